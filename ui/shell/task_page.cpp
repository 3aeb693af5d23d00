// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Task: the goal, the steps, what is scored, how the device at hand is held, and Start.

#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPixmap>
#include <map>

#include "curriculum/definitions.h"
#include "haptics/device.h"
#include "ui/shell/device_tester.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

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
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace16);
        auto* left = new QVBoxLayout;
        left->setSpacing(kSpace16);
        left->addWidget(stepsCard());
        left->addWidget(scoredCard());
        left->addStretch();
        auto* right = new QVBoxLayout;
        right->setSpacing(kSpace16);
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
    [[nodiscard]] QVariantMap state() const override {
        return {{"device", devices_->currentData()}};
    }

 private:
    QWidget* stepsCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Step by step"), "heading"));
        const auto file = curriculum::data_folder() / "pictures" / (task_.id + ".jpg");
        if (const QPixmap picture(qstr(file.string())); !picture.isNull()) {
            auto* label = new QLabel;
            label->setObjectName("task_picture");
            label->setPixmap(picture.scaledToWidth(560, Qt::SmoothTransformation));
            label->setAccessibleName(tr("The task as a scripted expert does it"));
            layout->addWidget(label);
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
        return make_card(layout);
    }

    QWidget* scoredCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("What is scored"), "heading"));
        layout->addWidget(make_label(tr("You start with %1 points and pass with %2.")
                                         .arg(format_points(task_.rubric.start_points))
                                         .arg(format_points(task_.rubric.pass_points)),
                                     "muted"));
        for (const assessment::RubricItem& item : task_.rubric.items) {
            layout->addWidget(make_rule());
            auto* line = new QHBoxLayout;
            line->setSpacing(kSpace12);
            line->addWidget(make_label(itemRule(item)), 1);
            line->addWidget(item.critical
                                ? make_badge(tr("critical error"), "critical")
                                : make_badge(tr("up to −%1").arg(format_points(item.max_points))),
                            0, Qt::AlignTop);
            layout->addLayout(line);
        }
        return make_card(layout);
    }

    [[nodiscard]] static QString itemRule(const assessment::RubricItem& item) {
        QString name = qstr(item.metric), unit;
        for (const assessment::MetricDefinition& metric : assessment::metric_definitions()) {
            if (metric.id != item.metric) continue;
            name = metric_name(metric.name);
            unit = unit_sign(metric.unit);
        }
        const QString limit = QLocale().toString(item.threshold, 'g', 4) + " " + unit;
        return item.below ? tr("%1: at least %2").arg(name, limit.trimmed())
                          : tr("%1: at most %2").arg(name, limit.trimmed());
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
        layout->addWidget(make_label(tr("A window with the fetoscope's view opens. Time limit %1.")
                                         .arg(format_duration(task_.time_limit_s)),
                                     "small"));
        connect(devices_, &QComboBox::currentIndexChanged, this, [this] { showDevice(); });
        connect(start_, &QPushButton::clicked, this, [this] { start(); });
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

    [[nodiscard]] static QString controlsOf(const QString& device) {
        QStringList lines;
        for (const haptics::ControlHelp& help : haptics::controls(device.toStdString()))
            lines << QCoreApplication::translate("Controls", help.action.c_str()) + ": " +
                         QCoreApplication::translate("Controls", help.input.c_str());
        if (lines.isEmpty()) return tr("Nothing to hold. Escape in the window opens the menu.");
        lines << tr("F1 in the window shows them again, Escape pauses.");
        return lines.join("\n");
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
            context_.settings().setValue("device", order.device);
            context_.launcher().start(order, context_.recordingsFolder());
            Q_EMIT go({PageId::kRunning, 0, {}, {}});
        });
    }

    curriculum::Task task_;
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
