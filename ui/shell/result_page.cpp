// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Result: verdict and score in one line, the three reasons that cost most, strengths and
// weaknesses, when and where harm was done, the paths of the instruments, the numbers beside the
// person's own band, remarks, and what to do next.

#include <QHBoxLayout>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTimer>
#include <memory>

#include "db/attempt_counting.h"
#include "reports/words.h"
#include "ui/shell/exam_standing.h"
#include "ui/shell/kept_recording.h"
#include "ui/shell/ledger_view.h"
#include "ui/shell/result_cards.h"
#include "ui/shell/result_standing.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

class ResultPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
 public:
    ResultPage(AppContext& context, const Place& place)
        : Page(context), data_(read_result(context.store(), place.number)) {
        const db::AttemptRecord& record = data_.detail.record;
        const bool own = record.user_id == context.user().id;
        require_sight(context, record);
        if (!record.exam.course_id.empty()) exam_ = exam_standing(context, record);
        QVBoxLayout* column = make_column(this);
        column->addWidget(headCard(own));
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        const auto show = [this](double time_s) { watch(time_s); };
        const bool scored = db::counts(record);
        const bool idle = record.verdict == assessment::Verdict::kNotAttempted;
        // Of what was given the head says all that its one reason would.
        const bool given = db::given_stage(record) > 0;
        if (scored || (!idle && !given && !data_.detail.score.reasons.empty()))
            row->addWidget(make_reasons_card(context, data_, show), 3);
        // Strengths and weaknesses are points; of an idle attempt the card says how to begin.
        if (scored || idle) row->addWidget(make_themes_card(context, data_), 2);
        column->addLayout(row);
        pictures_ = new QVBoxLayout;
        pictures_->setSpacing(kSpace16);
        column->addLayout(pictures_);
        column->addWidget(make_comments_card(
            context, record.id, record.user_id, {}, show,
            [this](const std::vector<db::CommentRecord>& comments) { remarked(comments); }));
        column->addWidget(make_metrics_card(context, data_));
        column->addStretch();
        readRecording();
        // Left alone, the focus would fall on the first button of the rail. Only after the attempt:
        // who changes the language has it elsewhere.
        if (on_ && place.state.value("after_attempt").toBool())
            QTimer::singleShot(0, on_, [on = on_] { on->setFocus(Qt::OtherFocusReason); });
    }

    [[nodiscard]] QString title() const override { return tr("Result"); }
    [[nodiscard]] bool keepsTyped() const override { return true; }
    [[nodiscard]] QString aboutTask() const override { return qstr(data_.detail.record.task_id); }

 private:
    QWidget* headCard(bool own) {
        const db::AttemptRecord& record = data_.detail.record;
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        if (db::counts(record))
            addScore(layout);
        else
            addNotCounted(layout);
        QStringList facts{task_title(context_, record.task_id), format_when(record.started_utc),
                          format_duration(record.duration_s), device_name(record.device),
                          end_word(record.end)};
        if (const int stage = db::given_stage(record); stage > 0)
            facts.insert(1, tr("from %1").arg(stage_title(context_, record.task_id, stage)));
        if (!own) facts.prepend(qstr(record.user_name));
        auto* below = new QHBoxLayout;
        below->setSpacing(kSpace12);
        if (!record.exam.course_id.empty()) below->addWidget(make_badge(tr("Exam"), "warn"));
        if (!record.study.study.empty())
            below->addWidget(make_badge(tr("Study %1").arg(qstr(record.study.study)), "accent"));
        if (record.demonstration) below->addWidget(make_demonstration_badge());
        below->addWidget(make_label(facts.join(" · "), "muted"), 1);
        layout->addLayout(below);
        // A line of their own: beside the points they are wider than a small screen.
        auto* buttons = new QHBoxLayout;
        buttons->setSpacing(kSpace8);
        addButtons(buttons, own);
        buttons->addStretch();
        layout->addLayout(buttons);
        addStanding(layout, own);
        return make_card(layout);
    }

    /// What became of it: of an exam how many attempts are left, of an attempt that does not count
    /// why, and of a force device whether it worked.
    void addStanding(QVBoxLayout* layout, bool own) {
        const db::AttemptRecord& record = data_.detail.record;
        if (db::counts(record) && !exam_.words.isEmpty()) {
            QLabel* left = make_label(exam_.words);
            left->setObjectName("exam_standing");
            layout->addWidget(left);
        }
        if (own && db::counts(record) && record.exam.course_id.empty() &&
            record.study.study.empty()) {
            if (const QString words = course_words(context_, record); !words.isEmpty()) {
                QLabel* next = make_label(words);
                next->setObjectName("course_standing");
                layout->addWidget(next);
            }
        }
        if (!db::counts(record)) {
            QLabel* why = make_label(why_not_counted(record, exam_, own), "warn");
            why->setObjectName("void_for_cause");
            layout->addWidget(why);
            if (waits_for_replay(record) && can_be_replayed_here(record))
                layout->addWidget(make_replay_bar(context_, record.id));
        } else if (record.haptic_grade == "bad") {
            layout->addWidget(make_label(
                tr("The force device did not work as it must: forces of this attempt may have been "
                   "wrong."),
                "warn"));
        } else if (record.haptic_grade == "sound") {
            layout->addWidget(make_label(tr("Haptic certificate: sound."), "small"));
        }
    }

    void addScore(QVBoxLayout* layout) {
        const db::AttemptRecord& record = data_.detail.record;
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        QLabel* points = make_label(points_words(record.points), "display");
        points->setObjectName("result_points");
        points->setWordWrap(false);
        line->addWidget(points);
        QLabel* verdict = make_badge(verdict_word(record), verdict_tone(record));
        verdict->setObjectName("result_verdict");
        line->addWidget(verdict);
        line->addStretch();
        layout->addLayout(line);
    }

    /// No points and no verdict of the rubric: they would read like a score. That an exam does not
    /// count would contradict that it has used up an attempt.
    void addNotCounted(QVBoxLayout* layout) {
        const QString why = reports::not_counted_words(data_.detail.record);
        QLabel* verdict = make_label(
            (exam_.used ? tr("No score: %1") : tr("Does not count: %1")).arg(why), "title");
        verdict->setObjectName("result_verdict");
        layout->addWidget(verdict);
    }

    void addButtons(QHBoxLayout* line, bool own) {
        if (!own) {  // Its owner goes on with Again and Next.
            QPushButton* before = make_button(context_, tr("Back"), "quiet", "back");
            before->setObjectName("back");
            before->setToolTip(tr("To the page before (Alt and left arrow)"));
            connect(before, &QPushButton::clicked, this, [this] { Q_EMIT back(); });
            line->addWidget(before);
        }
        watch_ = make_button(context_, tr("Watch"), "secondary", "play");
        watch_->setObjectName("watch");
        watch_->setToolTip(tr("See this attempt again in the simulator's window"));
        connect(watch_, &QPushButton::clicked, this, [this] { watch(0); });
        line->addWidget(watch_);
        QPushButton* compare = make_button(context_, tr("Compare"), "secondary");
        compare->setObjectName("compare");
        compare->setToolTip(tr("See this attempt beside another one"));
        connect(compare, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kCompare, data_.detail.record.id, {}, {}});
        });
        line->addWidget(compare);
        report_ = make_button(context_, tr("Report"), "secondary", "report");
        report_->setObjectName("report_pdf");
        report_->setToolTip(tr("Write a PDF of this attempt"));
        connect(report_, &QPushButton::clicked, this, [this] { writeReport(); });
        line->addWidget(report_);
        if (!own || !context_.may(db::Action::kPerformAttempt)) return;
        const QString task = qstr(data_.detail.record.task_id);
        // An exam is begun from its course: the task's own page would be practice.
        const bool exam = !data_.detail.record.exam.course_id.empty();
        // What does not count is done once more.
        const bool counts = db::counts(data_.detail.record);
        QPushButton* again = make_button(context_, exam ? tr("To the course") : tr("Again"),
                                         counts ? "secondary" : "primary", exam ? "" : "again");
        again->setObjectName("again");
        connect(again, &QPushButton::clicked, this, [this, task, exam] {
            Q_EMIT go(exam ? Place{PageId::kCourse, 0, {}, {}} : Place{PageId::kTask, 0, task, {}});
        });
        QPushButton* next =
            make_button(context_, tr("Next"), counts ? "primary" : "secondary", "next");
        next->setObjectName("next");
        connect(next, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kToday, 0, {}, {}});
        });
        line->addWidget(again);
        line->addWidget(next);
        on_ = counts ? next : again;
    }

    void watch(double time_s) {
        Q_EMIT go({PageId::kWatch, data_.detail.record.id, {}, {{"from_s", time_s}}});
    }

    void remarked(const std::vector<db::CommentRecord>& comments) {
        data_.comments = comments;
        if (auto* ledger = findChild<QWidget*>("ledger"))
            static_cast<LedgerView*>(ledger)->setMarks(marks_of(comments));
    }

    /// The pictures need the recording, which is read beside the page.
    void readRecording() {
        QLabel* wait = make_label(tr("Reading the recording …"), "muted");
        pictures_->addWidget(wait);
        auto recording = std::make_shared<sim::Recording>();
        auto there = std::make_shared<bool>(false);
        const int64_t id = data_.detail.record.id;
        context_.background(
            this, tr("Reading the recording"),
            [recording, there, id](db::Store& store) {
                const QTemporaryDir folder;
                *there = take_recording(store, id, folder.filePath("attempt.placode"), *recording);
            },
            [this, recording, there, wait](bool done) {
                if (!done) return wait->setText(tr("The recording cannot be shown."));
                if (!*there) return withoutRecording(wait);
                recording_ = recording;
                wait->hide();
                const auto show = [this](double time_s) { watch(time_s); };
                pictures_->addWidget(make_ledger_card(context_, data_, *recording, show));
                if (QWidget* leak = make_leak_card(context_, recording)) pictures_->addWidget(leak);
                pictures_->addWidget(make_map_card(context_, recording));
                pictures_->addWidget(make_ways_card(context_, recording));
            },
            {"reading", data_.detail.record.duration_s});
    }

    void withoutRecording(QLabel* said) {
        said->setText(
            tr("This attempt was kept without a recording. Score, reasons and measures are "
               "complete; the pictures, the report and watching it again need one."));
        said->setObjectName("no_recording");
        watch_->setEnabled(false);
        report_->setEnabled(false);
        for (auto* show :
             findChildren<QPushButton*>(QRegularExpression("^(show_reason|comment_show)_\\d+$")))
            show->hide();
    }

    void writeReport() {
        const QString name = QString("placode-attempt-%1.pdf").arg(data_.detail.record.id);
        const QString path =
            context_.askSaveFile(this, tr("Write the report"), name, tr("PDF (*.pdf)"));
        if (path.isEmpty()) return;
        const auto detail = data_.detail;
        const auto history = data_.history;
        const auto known = recording_;
        context_.background(
            this, tr("Writing the report"),
            [detail, history, known, path = path.toStdString(),
             login = context_.user().login](db::Store& store) {
                const sim::Recording recording =
                    known ? *known : stored_recording(store, detail.record.id);
                const auto head = reports::report_head(store, detail.record);
                // Before the file: nothing leaves without its entry.
                store.audit().write(login, "report.pdf",
                                    "attempt " + std::to_string(detail.record.id), path);
                reports::write_attempt_pdf(detail, recording, history, path, head);
            },
            [this, path](bool done) {
                if (done) Q_EMIT written(tr("Report written: %1").arg(path), path);
            });
    }

    ResultData data_;
    ExamStanding exam_;
    QVBoxLayout* pictures_ = nullptr;
    QPushButton *watch_ = nullptr, *report_ = nullptr;
    QPushButton* on_ = nullptr;  ///< The way on that is proposed: Next, or Again.
    std::shared_ptr<sim::Recording> recording_;
};

}  // namespace

Page* make_result_page(AppContext& context, const Place& place) {
    return new ResultPage(context, place);
}

}  // namespace placode::ui
