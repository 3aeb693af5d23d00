// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Running: what the simulator reports while the attempt goes on, and the two ways to end it.

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QTimer>

#include "curriculum/task.h"
#include "reports/metric_groups.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// Asks about the attempt that runs. The question goes when that attempt ends by itself: nobody is
/// told that he ends what has ended, and no answer reaches the attempt after it.
bool ask(AttemptLauncher& launcher, QWidget* window, const QString& title, const QString& text,
         const QString& verb) {
    bool stands = true;
    QObject question;
    QObject::connect(&launcher, &AttemptLauncher::ended, &question, [&stands] {
        stands = false;
        auto* open = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (open != nullptr && open->objectName() == "confirm") open->reject();
    });
    return confirm(window, title, text, verb,
                   QCoreApplication::translate("RunningPage", "Go on operating")) &&
           stands;
}

class RunningPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(RunningPage)
 public:
    explicit RunningPage(AppContext& context) : Page(context) {
        context.require(db::Action::kPerformAttempt);  // Everybody who is signed in.
        QVBoxLayout* column = make_column(this, 860);
        const AttemptLauncher& launcher = context.launcher();
        (void)context.problemOf([&] {
            std::vector<std::string> scored;
            for (const auto& item :
                 curriculum::load_task(launcher.order().task.toStdString()).rubric.items)
                scored.push_back(item.metric);
            ring_task_ = reports::looks_at_ring(scored);
        });
        auto* head = new QHBoxLayout;
        head->setSpacing(kSpace12);
        QLabel* name = make_label(launcher.order().title, "display");
        name->setWordWrap(false);
        head->addWidget(name);
        if (launcher.order().demonstration || launcher.order().device.startsWith("script"))
            head->addWidget(make_demonstration_badge());
        if (!launcher.order().exam.course_id.empty()) {
            head->addWidget(make_badge(tr("Exam"), "warn"));
            head->addWidget(make_badge(tr("Proctor: %1").arg(qstr(launcher.order().exam.proctor))));
        }
        head->addStretch();
        column->addLayout(head);
        state_ = make_label({}, "muted");
        column->addWidget(state_);
        column->addWidget(numbersCard());
        warning_ = make_label({}, "warn");
        column->addWidget(warning_);
        column->addWidget(scoringCard());
        column->addLayout(buttons());
        explained_ = make_label(
            study()
                ? tr("The procedure ends in the fetoscope's window, by itself or from its menu. "
                     "What is ended here ends for good.")
            : exam()
                ? tr("The exam ends here and is scored as it is, or it is left, which uses up this "
                     "attempt, too.")
                : tr("What was done is scored, or the attempt stays in the history as interrupted "
                     "and does not count for the course."),
            "small");
        explained_->setObjectName("running_words");
        column->addWidget(explained_);
        column->addStretch();
        scored_.setInterval(1000);
        connect(&scored_, &QTimer::timeout, this, [this] { showScoring(); });
        connect(&context.launcher(), &AttemptLauncher::statusChanged, this, [this] { update(); });
        connect(&context.launcher(), &AttemptLauncher::ended, this, [this] { update(); });
        update();
    }

    [[nodiscard]] QString title() const override {
        return context_.launcher().running() ? tr("Attempt is running") : tr("Scoring the attempt");
    }

 private:
    [[nodiscard]] curriculum::AttemptMode mode() const {
        return context_.launcher().order().mode();
    }
    [[nodiscard]] bool study() const { return mode() == curriculum::AttemptMode::kStudy; }
    [[nodiscard]] bool exam() const { return mode() == curriculum::AttemptMode::kExam; }

    QLabel* number(QGridLayout* grid, int column, const QString& name, const char* object) {
        QLabel* above = make_label(name, "muted");
        grid->addWidget(above, 0, column);
        QLabel* value = make_label("–", "display");
        value->setWordWrap(false);
        value->setObjectName(object);
        value->setAccessibleName(name);
        grid->addWidget(value, 1, column);
        grid->setColumnStretch(column, 1);
        if (column > 0) read_outs_ << above << value;
        return value;
    }

    QWidget* numbersCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace16);
        auto* grid = new QGridLayout;
        grid->setHorizontalSpacing(kSpace24);
        grid->setVerticalSpacing(kSpace4);
        time_ = number(grid, 0, tr("Time"), "live_time");
        phase_ = number(grid, 1, tr("Phase"), "live_phase");
        pictures_ = number(grid, 2, tr("Pictures a second"), "live_pictures");
        ring_ = number(grid, 3, tr("Ring cut"), "live_ring");
        layout->addLayout(grid);
        bar_ = new QProgressBar;
        bar_->setRange(0, 100);
        bar_->setTextVisible(false);
        bar_->setAccessibleName(tr("Ring cut"));
        layout->addWidget(bar_);
        return make_card(layout);
    }

    /// What happens after the end, which may take a while: the result opens by itself.
    QWidget* scoringCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        scoring_words_ = make_label({});
        scoring_words_->setObjectName("scoring_words");
        layout->addWidget(scoring_words_);
        scoring_bar_ = new QProgressBar;
        scoring_bar_->setRange(0, 0);  // The first time nobody knows how long it takes.
        scoring_bar_->setTextVisible(false);
        scoring_bar_->setAccessibleName(tr("Scoring the attempt"));
        layout->addWidget(scoring_bar_);
        scoring_ = make_card(layout);
        scoring_->setObjectName("scoring");
        scoring_->hide();
        return scoring_;
    }

    void showScoring() {
        if (!since_end_.isValid()) since_end_.start();
        const QString said =
            study() ? tr("The procedure is over and is being saved.")
                    : tr("The attempt is over. Its recording is measured and scored; the result "
                         "opens by itself.");
        const double seconds = static_cast<double>(since_end_.elapsed()) / 1000;
        const auto pace = context_.busyPace();
        scoring_bar_->setRange(0, pace ? 100 : 0);
        if (pace) {
            scoring_bar_->setValue(static_cast<int>(100 * pace->share));
            scoring_words_->setText(
                said + " " +
                (pace->overdue
                     ? tr("It takes longer than usual: %1 so far.").arg(format_duration(seconds))
                     : tr("About %1 left.").arg(format_duration(std::max(1.0, pace->left_s)))));
            return;
        }
        scoring_words_->setText(
            seconds < 2 ? said : said + " " + tr("%1 so far.").arg(format_duration(seconds)));
    }

    QHBoxLayout* buttons() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        // A participant sees no score: the step is done.
        stop_ = make_button(context_, study() ? tr("End the procedure") : tr("Finish and score"),
                            study() ? "secondary" : "primary", "stop");
        stop_->setObjectName("stop_and_score");
        abort_ = make_button(context_, study() ? tr("Break off") : tr("Leave without finishing"),
                             "danger", "close");
        abort_->setObjectName("abort");
        row->addWidget(stop_);
        row->addWidget(abort_);
        row->addStretch();
        // While a question stands the attempt may end by itself, and this page with it.
        connect(stop_, &QPushButton::clicked, this, [this, &launcher = context_.launcher()] {
            if (mayFinish()) launcher.finish();
        });
        connect(abort_, &QPushButton::clicked, this, [this, &launcher = context_.launcher()] {
            if (ask(launcher, window(),
                    study() ? tr("Break the procedure off?") : tr("Leave the attempt?"),
                    whatLeavingMeans(), study() ? tr("Break off") : tr("Leave without finishing")))
                launcher.abort();
        });
        return row;
    }

    /// Before the first motion nothing is recorded, and nothing is used up.
    [[nodiscard]] QString whatLeavingMeans() const {
        const bool begun = context_.launcher().status().time_s > 0;
        if (study())
            return begun ? tr("What was done so far is kept and does not count; the procedure has "
                              "to be done again from the beginning.")
                         : tr("The procedure has not begun yet: nothing is kept.");
        if (exam())
            return begun ? tr("This is an exam: leaving uses up this attempt.")
                         : tr("The exam has not begun yet: leaving uses up nothing.");
        return begun ? tr("What was done stays in the history as interrupted and does not count "
                          "for the course.")
                     : tr("The attempt has not begun yet: nothing is kept.");
    }

    /// One click in another window than the operation's ends nothing: it asks, and says what is
    /// lost.
    [[nodiscard]] bool mayFinish() {
        const double time_s = context_.launcher().status().time_s;
        if (!curriculum::conduct_of(mode()).always_ask)
            return ask(context_.launcher(), window(), tr("End the attempt?"),
                       tr("It ends here, after %1, and is scored for what was done.")
                           .arg(format_duration(time_s)),
                       tr("Finish and score"));
        const double min_s = context_.launcher().order().min_s;
        QString text = study()
                           ? tr("The procedure ends here for good, after %1. You cannot go on "
                                "with it.")
                           : tr("The exam ends here for good, after %1, and is scored as it is. "
                                "You cannot go on with it.");
        text = text.arg(format_duration(time_s));
        if (time_s < min_s)
            text += " " + tr("It lasted less than %1: it will not count and has to be done again.")
                              .arg(format_duration(min_s));
        return ask(context_.launcher(), window(),
                   study() ? tr("End the procedure?") : tr("End the exam?"), text,
                   study() ? tr("End the procedure") : tr("End the exam"));
    }

    [[nodiscard]] static QString phaseName(const QString& phase) {
        if (phase == "inspect") return tr("Inspect");
        if (phase == "incise") return tr("Incise");
        if (phase == "release") return tr("Release");
        if (phase == "resect") return tr("Resect");
        if (phase == "check") return tr("Check");
        return phase.isEmpty() ? "–" : phase;
    }

    void update() {
        const AttemptLauncher& launcher = context_.launcher();
        const LiveStatus& live = launcher.status();
        const bool begun = live.time_s > 0;
        state_->setText(!launcher.running() ? tr("The attempt has ended.")
                        : begun             ? tr("Runs in the fetoscope's window: %1.")
                                      .arg(device_name(launcher.order().device.toStdString()))
                                : tr("The fetoscope's window is opening."));
        time_->setText(begun ? format_duration(live.time_s) : "–");
        // An exam and a study have no read-outs but the time, here neither.
        // Phase and ring are those of an incision: other tasks have none.
        const bool numbers = mode() == curriculum::AttemptMode::kPractice && ring_task_;
        for (QWidget* part : read_outs_) part->setVisible(numbers);
        bar_->setVisible(numbers);
        phase_->setText(phaseName(live.phase));
        pictures_->setText(live.pictures_hz > 0 ? format_number(live.pictures_hz, 0) : "–");
        ring_->setText(begun ? format_number(100 * live.cut_fraction, 0) + " %" : "–");
        bar_->setValue(static_cast<int>(100 * live.cut_fraction));
        QStringList warnings;
        if (mode() == curriculum::AttemptMode::kPractice && !live.warning.isEmpty())
            warnings << live.warning;
        if (live.too_slow) warnings << tr("This computer is too slow: the attempt will not count.");
        if (live.dropped > 0)
            warnings << tr("The recording lost entries: %1. The attempt will not count.")
                            .arg(live.dropped);
        warning_->setText(warnings.join(" "));
        warning_->setVisible(!warnings.isEmpty());
        const bool running = launcher.running();
        stop_->setEnabled(running);
        abort_->setEnabled(running);
        stop_->setVisible(running);
        abort_->setVisible(running);
        explained_->setVisible(running);
        scoring_->setVisible(!running);
        if (!running && !scored_.isActive()) {
            scored_.start();
            showScoring();
        }
    }

    bool ring_task_ = true;
    QList<QWidget*> read_outs_;  ///< All numbers but the time, with their names.
    QLabel *state_ = nullptr, *time_ = nullptr, *phase_ = nullptr, *pictures_ = nullptr,
           *ring_ = nullptr, *warning_ = nullptr;
    QLabel *explained_ = nullptr, *scoring_words_ = nullptr;
    QProgressBar *bar_ = nullptr, *scoring_bar_ = nullptr;
    QFrame* scoring_ = nullptr;
    QTimer scored_;
    QElapsedTimer since_end_;
    QPushButton *stop_ = nullptr, *abort_ = nullptr;
};

}  // namespace

Page* make_running_page(AppContext& context, const Place&) { return new RunningPage(context); }

}  // namespace placode::ui
