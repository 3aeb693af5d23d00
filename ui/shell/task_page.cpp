// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Task: the goal, the steps, what is scored, how the device at hand is held, and Start.

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <map>
#include <set>

#include "curriculum/conduct.h"
#include "curriculum/definitions.h"
#include "haptics/control_help.h"
#include "haptics/control_words.h"
#include "haptics/hint_device.h"
#include "reports/metric_groups.h"
#include "ui/shell/controls_card.h"
#include "ui/shell/device_tester.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/rubric_card.h"
#include "ui/shell/task_exam.h"
#include "ui/shell/task_picture.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// Arms that push back; the others have no loop that could be certified.
bool is_haptic(const std::string& device) {
    return device == "openhaptics" || device == "haply" || device == "avatar" ||
           device == "forcedimension";
}

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
        exam_.read(place);
        // As it was chosen last, for each task; on this page, before it was shown in another
        // language.
        wanted_stage_ =
            place.state.value("stage", context.settings().value(stageSetting(), 0)).toInt();
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        auto* left = new QVBoxLayout;
        left->setSpacing(kSpace16);
        left->addWidget(stepsCard());
        left->addWidget(make_rubric_card(context, task_, exam_.stage()));
        left->addStretch();
        auto* right = new QVBoxLayout;
        right->setSpacing(kSpace16);
        if (exam_.stage() != nullptr)
            right->addWidget(exam_.makeCard([this] {
                if (start_->isEnabled()) startWhenFree();
            }));
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
                {"stage", stage()},
                {"exam_course", qstr(exam_.course())},
                {"exam_stage", exam_.stage() != nullptr ? qstr(exam_.stage()->id) : QString()}};
    }

 private:
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
            line->addWidget(make_label(withKeys(context_.in(step), haptics::HintDevice::kKeyboard)),
                            1);
            layout->addLayout(line);
        }
        if (const QString aids = aidWords(); !aids.isEmpty())
            layout->addWidget(make_label(aids, "small"));
        return make_card(layout);
    }

    /// Steps say what to do in every mode; what helps with it exists in practice alone.
    [[nodiscard]] QString aidWords() const {
        const auto mode = exam_.stage() != nullptr ? curriculum::AttemptMode::kExam
                                                   : curriculum::AttemptMode::kPractice;
        std::vector<std::string> scored;
        for (const auto& item : task_.rubric.items) scored.push_back(item.metric);
        const bool line = curriculum::conduct_of(mode).aids.planned_line;
        return line && reports::looks_at_ring(scored)
                   ? tr("F5 in the window shows the planned line.")
                   : QString();
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
        if (exam_.stage() == nullptr && !task_.stages.empty()) addStages(layout);
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

    /// In practice a long task may begin further on.
    void addStages(QVBoxLayout* layout) {
        stages_ = new QComboBox;
        stages_->setObjectName("stage");
        stages_->addItem(tr("the beginning"), 0);
        for (size_t i = 0; i < task_.stages.size(); ++i)
            stages_->addItem(context_.in(task_.stages[i].title), static_cast<int>(i) + 1);
        layout->addLayout(make_field(tr("Begin at"), stages_));
        stage_note_ = make_label(
            tr("The scripted expert does what comes before; the first time this takes a while. An "
               "attempt that begins here has no score and counts for nothing."),
            "small");
        stage_note_->setObjectName("stage_note");
        layout->addWidget(stage_note_);
        stages_->setCurrentIndex(std::max(0, stages_->findData(wanted_stage_)));
        const auto show = [this] { stage_note_->setVisible(stage() > 0); };
        connect(stages_, &QComboBox::currentIndexChanged, this, show);
        show();
    }

    [[nodiscard]] QString stageSetting() const { return "stage/" + qstr(task_.id); }
    [[nodiscard]] int stage() const {
        return stages_ != nullptr ? stages_->currentData().toInt() : 0;
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
        change_ = make_button(context_, tr("Change keys and buttons"), "quiet");
        change_->setObjectName("change_controls");
        connect(change_, &QPushButton::clicked, this, [this] {
            Q_EMIT go({PageId::kAccount, 0, "controls", {}});
        });
        layout->addWidget(change_, 0, Qt::AlignLeft);
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
        const haptics::HintDevice hands = haptics::hint_device(name.toStdString());
        change_->setVisible(hands == haptics::HintDevice::kMouse ||
                            hands == haptics::HintDevice::kKeyboard ||
                            hands == haptics::HintDevice::kGamepad);
    }

    /// A text with the keys that whoever is signed in has chosen.
    [[nodiscard]] QString withKeys(const QString& text, haptics::HintDevice device) const {
        return qstr(haptics::in_layout(text.toStdString(), layout_, device,
                                       context_.language().toStdString()));
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
                         withKeys(QCoreApplication::translate("Controls", help.input.c_str()),
                                  haptics::hint_device(device.toStdString()))
                             .toHtmlEscaped());
        if (rows.isEmpty()) return tr("Nothing to hold. Escape in the window opens the menu.");
        return rows + "<p style='margin:0'>" +
               (exam_.stage() != nullptr
                    ? tr("Escape in the window pauses.")
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
            order.controls = qstr(layout_.text());
            order.started_utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODate);
            order.demonstration = context_.user().demonstration;
            order.stage = stage();
            if (stages_ != nullptr) context_.settings().setValue(stageSetting(), order.stage);
            if (exam_.stage() != nullptr) exam_.prepare(order, haptic_.count(order.device) > 0);
            context_.settings().setValue("device", order.device);
            order.store = server_place(context_.storeUrl());
            context_.launcher().start(order, context_.recordingsFolder());
            Q_EMIT go({PageId::kRunning, 0, {}, {}});
        });
    }

    curriculum::Task task_;
    TaskExam exam_{context_};  ///< Asked for; no stage = practice.
    std::set<QString> haptic_;
    std::map<QString, QString> details_;
    QString wanted_;  // the device of last time, until somebody chooses
    QComboBox *devices_ = nullptr, *stages_ = nullptr;  // stages: in practice, where there are any
    QLabel* stage_note_ = nullptr;
    int wanted_stage_ = 0;
    QPushButton *start_ = nullptr, *change_ = nullptr;
    haptics::ControlLayout layout_ = own_layout(context_);
    QLabel *device_note_ = nullptr, *controls_ = nullptr;
};

}  // namespace

Page* make_task_page(AppContext& context, const Place& place) {
    return new TaskPage(context, place);
}

}  // namespace placode::ui
