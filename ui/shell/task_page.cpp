// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Task: the goal, the steps, what is scored, how the device at hand is held, and Start.

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <map>
#include <set>

#include "curriculum/conduct.h"
#include "curriculum/definitions.h"
#include "db/course_conduct.h"
#include "db/standards.h"
#include "haptics/device.h"
#include "reports/metric_groups.h"
#include "ui/shell/course_words.h"
#include "ui/shell/device_tester.h"
#include "ui/shell/form_keys.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// Arms that push back; the others have no loop that could be certified.
bool is_haptic(const std::string& device) {
    return device == "openhaptics" || device == "haply" || device == "avatar" ||
           device == "forcedimension";
}

/// As wide as its column, with every pixel that the screen has.
class TaskPicture : public QWidget {
 public:
    explicit TaskPicture(QPixmap picture) : picture_(std::move(picture)) {
        QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
        setMaximumWidth(kWidest);
    }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override {
        return width * picture_.height() / picture_.width();
    }
    [[nodiscard]] QSize sizeHint() const override { return {kWidest, heightForWidth(kWidest)}; }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {kNarrowest, heightForWidth(kNarrowest)};
    }

 protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawPixmap(QRect(0, 0, width(), heightForWidth(width())), picture_);
    }

 private:
    static constexpr int kNarrowest = 280, kWidest = 560;
    QPixmap picture_;
};

class TaskPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(TaskPage)
 public:
    TaskPage(AppContext& context, const Place& place)
        : Page(context), task_(curriculum::load_task(place.text.toStdString())) {
        context.require(db::Action::kPerformAttempt);
        QVBoxLayout* column = make_column(this);
        column->addWidget(make_label(context.in(task_.title), "display"));
        QLabel* goal = make_label(context.in(task_.goal), "muted");
        column->addWidget(goal);
        readExam(place);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        auto* left = new QVBoxLayout;
        left->setSpacing(kSpace16);
        left->addWidget(stepsCard());
        left->addWidget(scoredCard());
        left->addStretch();
        auto* right = new QVBoxLayout;
        right->setSpacing(kSpace16);
        if (exam_) right->addWidget(examCard());
        right->addWidget(startCard());
        right->addWidget(controlsCard());
        right->addStretch();
        row->addLayout(left, 3);
        row->addLayout(right, 2);
        column->addLayout(row);
        column->addStretch();
        wanted_ = place.state.value("device", context.settings().value("device")).toString();
        devices_->setCurrentIndex(std::max(0, devices_->findData(wanted_)));
        // A choice by hand is not taken back when a device is found later.
        connect(devices_, &QComboBox::activated, this, [this] { wanted_.clear(); });
        showDevice();
    }

    [[nodiscard]] QString title() const override { return tr("Task"); }
    [[nodiscard]] QString aboutTask() const override { return qstr(task_.id); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"device", devices_->currentData()},
                {"exam_course", qstr(course_)},
                {"exam_stage", exam_ ? qstr(exam_->id) : QString()}};
    }

 private:
    /// Asked for as an exam of a course: the rules stand on the page, the store decides at Start.
    void readExam(const Place& place) {
        course_ = place.state.value("exam_course").toString().toStdString();
        if (course_.empty()) return;
        standing_ = db::course_standing(context_.store(), context_.user().id, course_, nowUtc());
        const curriculum::CourseStage* stage =
            standing_.course.stage(place.state.value("exam_stage").toString().toStdString());
        if (stage == nullptr || stage->mode != curriculum::StageMode::kExam) return course_.clear();
        exam_ = *stage;
        const auto at = static_cast<size_t>(stage - standing_.course.stages.data());
        left_ = standing_.progress.stages[at].attempts_left;
    }

    [[nodiscard]] static std::string nowUtc() {
        return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    }

    QWidget* examCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(tr("Exam"), "heading"));
        head->addWidget(make_badge(context_.in(standing_.course.title), "warn"));
        head->addStretch();
        layout->addLayout(head);
        QLabel* rules = make_label(exam_words(exam_->exam));
        rules->setObjectName("exam_rules");
        layout->addWidget(rules);
        layout->addWidget(make_label(stage_rule_words(*exam_), "small"));
        if (left_ >= 0) layout->addWidget(make_label(tr("Attempts left: %1").arg(left_), "warn"));
        if (exam_->exam.proctor) {
            proctor_ = new QLineEdit;
            proctor_->setObjectName("proctor_login");
            proctor_password_ = new QLineEdit;
            proctor_password_->setObjectName("proctor_password");
            proctor_password_->setEchoMode(QLineEdit::Password);
            layout->addLayout(make_field(tr("Proctor: log-in name"), proctor_));
            layout->addLayout(make_field(tr("Proctor: password"), proctor_password_));
            enter_submits({proctor_, proctor_password_}, this, [this] {
                if (start_->isEnabled()) startWhenFree();
            });
            layout->addWidget(make_label(
                tr("An educator or administrator who is present confirms that it may begin."),
                "small"));
        }
        QFrame* card = make_card(layout);
        card->setObjectName("exam_card");
        return card;
    }

    /// Who is present confirms with the own password. Throws kRefused.
    [[nodiscard]] QString confirmedProctor() {
        if (proctor_ == nullptr) return {};
        // The next key belongs to the field that is to be mended.
        const auto refuse = [this](const QString& why) {
            (proctor_->text().trimmed().isEmpty() ? proctor_ : proctor_password_)->setFocus();
            throw Refusal(why);
        };
        if (proctor_->text().trimmed().isEmpty() || proctor_password_->text().isEmpty())
            refuse(tr("The exam begins when a proctor has typed log-in name and password."));
        const db::SignIn found = context_.store().accounts().confirm(
            proctor_->text().trimmed().toStdString(), proctor_password_->text().toStdString());
        proctor_password_->clear();
        if (found.outcome == db::SignInOutcome::kThrottled)
            refuse(tr("Too many wrong passwords. Try again in %1 s.").arg(found.wait_s));
        if (found.outcome != db::SignInOutcome::kOk)
            refuse(tr("The proctor's log-in name or password is wrong."));
        if (found.user->id == context_.user().id)
            refuse(tr("Nobody can be their own proctor; ask somebody who is present."));
        if (!db::has_role(found.user->roles, db::Role::kEducator) &&
            !db::has_role(found.user->roles, db::Role::kAdministrator))
            refuse(tr("%1 is neither educator nor administrator and cannot be the proctor.")
                       .arg(qstr(found.user->display_name)));
        return qstr(found.user->display_name);
    }

    /// An exam that a crash left over is saved before the next one: it uses up an attempt.
    void refuseBesideLeftExam() const {
        for (const Leftover& left : find_leftovers(context_.recordingsFolder(), Depth::kLength)) {
            if (!left.order || !left.problem.isEmpty() || left.duration_s <= 0) continue;
            if (left.order->user_id == context_.user().id &&
                left.order->exam.course_id == course_ && left.order->exam.stage_id == exam_->id)
                throw Refusal(
                    tr("An attempt at this exam was not finished and not saved. Save it "
                       "first: it uses up this attempt."));
        }
    }

    void makeExam(AttemptOrder& order) {
        refuseBesideLeftExam();
        const std::string device = order.device.toStdString();
        // The loop of a force device is judged when the attempt is saved; anything else has none.
        const bool haptic = haptic_.count(order.device) > 0;
        const db::ExamOrder ready = db::prepare_exam(context_.store(), context_.user().id, course_,
                                                     exam_->id, confirmedProctor().toStdString(),
                                                     haptic ? device : std::string(), nowUtc());
        order.exam = ready.context;
        order.seed = ready.seed;
        context_.audit("exam.begin", qstr(course_ + "/" + exam_->id),
                       tr("proctor %1").arg(qstr(ready.context.proctor)));
    }

    QWidget* stepsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Step by step"), "heading"));
        const auto file = curriculum::data_folder() / "pictures" / (task_.id + ".jpg");
        if (const QPixmap picture(qstr(file.string())); !picture.isNull()) {
            auto* shown = new TaskPicture(picture);
            shown->setObjectName("task_picture");
            shown->setAccessibleName(tr("The task as a scripted expert does it"));
            layout->addWidget(shown);
        }
        int number = 1;
        for (const curriculum::LocalText& step : task_.instructions) {
            auto* line = new QHBoxLayout;
            line->setSpacing(kSpace12);
            QLabel* badge = make_badge(QString::number(number++), "accent");
            line->addWidget(badge, 0, Qt::AlignTop);
            line->addWidget(make_label(context_.in(step)), 1);
            layout->addLayout(line);
        }
        if (const QString aids = aidWords(); !aids.isEmpty())
            layout->addWidget(make_label(aids, "small"));
        return make_card(layout);
    }

    /// Steps say what to do in every mode; what helps with it exists in practice alone.
    [[nodiscard]] QString aidWords() const {
        const auto mode =
            exam_ ? curriculum::AttemptMode::kExam : curriculum::AttemptMode::kPractice;
        std::vector<std::string> scored;
        for (const auto& item : task_.rubric.items) scored.push_back(item.metric);
        const bool line = curriculum::conduct_of(mode).aids.planned_line;
        return line && reports::looks_at_ring(scored)
                   ? tr("F5 in the window shows the planned line.")
                   : QString();
    }

    QWidget* scoredCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("What is scored"), "heading"));
        double weights = 0;
        for (const assessment::RubricItem& item : task_.rubric.items) weights += item.earns;
        const QString start = format_points(task_.rubric.start_points);
        const QString pass = format_points(db::rubric_at(context_.store(), task_).pass_points);
        layout->addWidget(make_label(
            weights > 0 ? tr("What you do earns up to %1 points, harm takes points off. You pass "
                             "with %2.")
                              .arg(start, pass)
                        : tr("You start with %1 points and pass with %2.").arg(start, pass),
            "muted"));
        if (exam_) {
            QLabel* asked = make_label(
                tr("This exam asks for %1 points.").arg(format_points(exam_->benchmark_points)));
            asked->setObjectName("exam_points");
            layout->addWidget(asked);
        }
        for (const assessment::RubricItem& item : task_.rubric.items) {
            layout->addWidget(make_rule());
            auto* line = new QHBoxLayout;
            line->setSpacing(kSpace12);
            line->addWidget(make_label(itemRule(item)), 1);
            line->addWidget(itemBadge(item, weights), 0, Qt::AlignTop);
            layout->addLayout(line);
        }
        return make_card(layout);
    }

    [[nodiscard]] QLabel* itemBadge(const assessment::RubricItem& item, double weights) const {
        if (item.critical) return make_badge(tr("critical error"), "critical");
        if (item.earns > 0)
            return make_badge(
                tr("up to +%1")
                    .arg(format_points(task_.rubric.start_points * item.earns / weights)),
                "good");
        return make_badge(tr("up to −%1").arg(format_points(item.max_points)));
    }

    [[nodiscard]] static QString itemRule(const assessment::RubricItem& item) {
        QString name = qstr(item.metric), unit;
        if (const auto* metric = assessment::metric_definition(item.metric)) {
            name = metric_name(metric->name);
            unit = unit_sign(metric->unit);
        }
        // As the time limit beside it is written.
        const QString limit =
            unit == "s" && item.threshold >= 60
                ? format_duration(item.threshold)
                : QString(QLocale().toString(item.threshold, 'g', 4) + " " + unit).trimmed();
        if (item.earns > 0)
            return tr("%1: %2 earn all these points, less in proportion").arg(name, limit);
        if (item.critical)
            return item.below ? tr("%1: less than %2 fails the attempt").arg(name, limit)
                   : item.threshold == 0
                       ? tr("%1: any fails the attempt").arg(name)
                       : tr("%1: more than %2 fails the attempt").arg(name, limit);
        return item.below            ? tr("%1: at least %2").arg(name, limit)
               : item.threshold == 0 ? tr("%1: none").arg(name)
                                     : tr("%1: at most %2").arg(name, limit);
    }

    QWidget* startCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace16);
        devices_ = new QComboBox;
        devices_->setObjectName("device");
        addDevices();
        layout->addLayout(make_field(tr("Device"), devices_));
        device_note_ = make_label({}, "small");
        layout->addWidget(device_note_);
        start_ = make_button(context_, tr("Start the attempt"), "primary", "play");
        start_->setObjectName("start_attempt");
        start_->setProperty("scale", "large");
        layout->addWidget(start_);
        const QString limit = task_.time_limit_s > 0
                                  ? tr("Time limit %1.").arg(format_duration(task_.time_limit_s))
                                  : tr("No time limit.");
        layout->addWidget(
            make_label(tr("A window with the fetoscope's view opens.") + " " + limit, "small"));
        connect(devices_, &QComboBox::currentIndexChanged, this, [this] { showDevice(); });
        connect(start_, &QPushButton::clicked, this, [this] { startWhenFree(); });
        QFrame* card = make_card(layout);
        card->setProperty("tone", "accent");
        return card;
    }

    /// Hands for everybody; scripted operators only for demonstration accounts and educators,
    /// because their scores are nobody's skill.
    void addDevices() {
        each_device(context_, devices_, [this](const ListedDevice& device) {
            details_[device.name] =
                QCoreApplication::translate("Device", device.detail.toUtf8().constData());
            devices_->addItem(device_name(device.name.toStdString()), device.name);
            if (is_haptic(device.name.toStdString())) haptic_.insert(device.name);
            if (device.name == wanted_) devices_->setCurrentIndex(devices_->count() - 1);
        });
        if (!context_.user().demonstration &&
            !db::has_role(context_.user().roles, db::Role::kEducator))
            return;
        for (const char* script : {"script:expert", "script:intermediate", "script:novice"})
            devices_->addItem(device_name(script), script);
    }

    QWidget* controlsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Controls"), "heading"));
        controls_ = make_label({});
        controls_->setObjectName("controls");
        controls_->setTextFormat(Qt::RichText);
        layout->addWidget(controls_);
        return make_card(layout);
    }

    void showDevice() {
        const QString name = devices_->currentData().toString();
        const auto found = details_.find(name);
        device_note_->setText(found == details_.end()
                                  ? tr("A program operates; you watch. Marked as demonstration.")
                                  : found->second);
        start_->setEnabled(!context_.launcher().running());
        controls_->setText(controlsOf(name));
    }

    /// A table: what one wants to do, and below it which control does it.
    [[nodiscard]] QString controlsOf(const QString& device) const {
        QString rows;
        const QString muted = context_.colors().muted.name();
        for (const haptics::ControlHelp& help : haptics::controls(device.toStdString()))
            rows +=
                QString("<p style='margin:0 0 8px 0'><span style='color:%1'>%2</span><br>%3</p>\n")
                    .arg(muted,
                         QCoreApplication::translate("Controls", help.action.c_str())
                             .toHtmlEscaped(),
                         QCoreApplication::translate("Controls", help.input.c_str())
                             .toHtmlEscaped());
        if (rows.isEmpty()) return tr("Nothing to hold. Escape in the window opens the menu.");
        return rows + "<p style='margin:0'>" +
               (exam_ ? tr("Escape in the window pauses.")
                      : tr("F1 in the window shows them again, Escape pauses.")) +
               "</p>";
    }

    /// A report or a score that is being made would take the computer from the attempt, which then
    /// would not count.
    void startWhenFree() {
        if (context_.busy())
            Q_EMIT notice(
                tr("Placode is still working. The attempt begins when that is done, so "
                   "that the computer is free for it."));
        start_->setEnabled(false);
        context_.whenIdle(this, [this] {
            start_->setEnabled(true);
            start();
        });
    }

    void start() {
        context_.guard(tr("Starting the attempt"), [this] {
            context_.require(db::Action::kPerformAttempt);
            AttemptOrder order;
            order.user_id = context_.user().id;
            order.user_name = qstr(context_.user().display_name);
            order.task = qstr(task_.id);
            order.title = context_.in(task_.title);
            order.device = devices_->currentData().toString();
            order.started_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
            order.demonstration = context_.user().demonstration;
            if (exam_) makeExam(order);
            context_.settings().setValue("device", order.device);
            context_.launcher().start(order, context_.recordingsFolder());
            Q_EMIT go({PageId::kRunning, 0, {}, {}});
        });
    }

    curriculum::Task task_;
    std::string course_;  ///< Of the exam; empty = practice.
    db::CourseStanding standing_;
    std::optional<curriculum::CourseStage> exam_;
    int left_ = -1;
    std::set<QString> haptic_;
    QLineEdit *proctor_ = nullptr, *proctor_password_ = nullptr;
    std::map<QString, QString> details_;
    QString wanted_;  // the device of last time, until somebody chooses
    QComboBox* devices_ = nullptr;
    QPushButton* start_ = nullptr;
    QLabel *device_note_ = nullptr, *controls_ = nullptr;
};

}  // namespace

Page* make_task_page(AppContext& context, const Place& place) {
    return new TaskPage(context, place);
}

}  // namespace placode::ui
