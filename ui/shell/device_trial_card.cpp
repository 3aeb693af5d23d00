// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/device_trial_card.h"

#include <QCoreApplication>
#include <QDate>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPointer>
#include <algorithm>

#include "haptics/hand_identity.h"
#include "ui/shell/app_context.h"
#include "ui/shell/details.h"
#include "ui/shell/parts.h"
#include "ui/shell/trial_arms.h"

namespace placode::ui {
namespace {

/// Forces of the test, one after the other; the first is 0.5 N.
constexpr std::array<double, 4> kLevelsN{0.5, 1, 2, 3};
constexpr double kLeastLimitN = 0.1;  // of the setting of the computer

class TrialCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(TrialCard)
 public:
    TrialCard(AppContext& context, const QString& device, const StationWishes& wishes)
        : context_(context),
          device_(device),
          wishes_(wishes),
          arms_(context),
          tester_(context.launcher().options()) {
        setProperty("role", "card");
        setObjectName("trial_card");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout->setSpacing(kSpace12);
        layout->addLayout(head());
        layout->addWidget(guide());
        layout->addLayout(arms_.layout());
        loop_ = make_label(tr("Waiting for the device…"), "small");
        loop_->setObjectName("trial_loop");
        layout->addWidget(loop_);
        details_ = new Details(context_);
        layout->addWidget(details_);
        rights_ = make_label(
            tr("No real-time rights: other programs can make the force stutter. An administrator "
               "grants them once: %1, then puts the user into the group placode.")
                .arg("placode-sim --limits-file | sudo tee /etc/security/limits.d/placode.conf"),
            "small");
        rights_->setObjectName("trial_rights");
        rights_->setTextInteractionFlags(Qt::TextSelectableByMouse);
        rights_->hide();
        layout->addWidget(rights_);
        layout->addWidget(make_rule());
        layout->addWidget(forceTest());
        layout->addWidget(make_rule());
        layout->addWidget(handTest());
        connect(&tester_, &DeviceTester::stateChanged, this, [this] { update(); });
        connect(&tester_, &DeviceTester::ended, this, [this](const QString& why) { over(why); });
        begin();
    }

 private:
    QHBoxLayout* head() {
        auto* line = new QHBoxLayout;
        line->setSpacing(kSpace12);
        line->addWidget(
            make_label(tr("Trying: %1").arg(device_name(device_.toStdString())), "heading"));
        line->addStretch();
        stop_ = make_button(context_, tr("End the test"), "secondary", "stop");
        stop_->setObjectName("trial_stop");
        connect(stop_, &QPushButton::clicked, this,
                [this] { tester_.running() ? tester_.stop() : begin(); });
        line->addWidget(stop_);
        return line;
    }

    QWidget* guide() {
        QString text;
        for (const QString& step : calibration_steps(device_))
            text += (text.isEmpty() ? "" : "\n") + step;
        QLabel* label = make_label(text, "muted");
        label->setObjectName("calibration_guide");
        return label;
    }

    QWidget* forceTest() {
        auto* box = new QWidget;
        auto* layout = new QVBoxLayout(box);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Force test"), "heading"));
        force_text_ = make_label({}, "muted");
        force_text_->setObjectName("force_text");
        layout->addWidget(force_text_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        floor_ = make_button(context_, tr("Put a floor under the hand"), "primary", "download");
        floor_->setObjectName("floor");
        good_ = make_button(context_, tr("It pushed me out softly"), "secondary", "check");
        good_->setObjectName("force_good");
        good_->setEnabled(false);  // before the device has said anything, too
        bad_ = make_button(context_, tr("It buzzed or pushed wrongly"), "danger", "alert");
        bad_->setObjectName("force_bad");
        connect(floor_, &QPushButton::clicked, this,
                [this] { tester_.say(tester_.state().floor ? "floor off" : "floor on"); });
        connect(good_, &QPushButton::clicked, this, [this] { passed(); });
        connect(bad_, &QPushButton::clicked, this, [this] { failed(); });
        layout->addWidget(floor_, 0, Qt::AlignLeft);
        for (QPushButton* button : {good_, bad_}) row->addWidget(button);
        row->addStretch();
        layout->addLayout(row);
        floor_first_ = make_hint();
        floor_first_->setObjectName("floor_first");
        floor_first_->setText(
            tr("First put the floor under the hand: a force that nobody felt is not passed."));
        layout->addWidget(floor_first_);
        return box;
    }

    QWidget* handTest() {
        auto* box = new QWidget;
        auto* layout = new QVBoxLayout(box);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(kSpace8);
        layout->addWidget(make_label(tr("Right and left hand"), "heading"));
        hand_text_ = make_label({}, "muted");
        hand_text_->setObjectName("hand_text");
        layout->addWidget(hand_text_);
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        identify_ = make_button(context_, tr("Find the right hand"), "secondary", "hand");
        identify_->setObjectName("identify");
        swap_ = make_button(context_, tr("Swap right and left"), "secondary", "switch");
        swap_->setObjectName("swap_hands");
        connect(identify_, &QPushButton::clicked, this, [this] { tester_.say("identify"); });
        connect(swap_, &QPushButton::clicked, this, [this] { swap(); });
        row->addWidget(identify_);
        row->addWidget(swap_);
        row->addStretch();
        layout->addLayout(row);
        return box;
    }

    void begin() {
        answered_ = floored_ = false;
        details_->setText({});
        context_.guard(tr("Trying the device"), [this] { tester_.start(device_, level()); });
        stop_->setText(tr("End the test"));
        explain();
    }

    [[nodiscard]] double level() const { return kLevelsN[level_]; }

    void explain() {
        force_text_->setText(
            tr("Now with at most %1 N. Hold the arm in the air, put the floor under it, go down "
               "slowly until it carries the hand, then let go: it must come to rest. One hand on "
               "the arm, the other at its power switch.")
                .arg(format_number(level(), 1)));
    }

    void update() {
        const TrialState& state = tester_.state();
        const bool force = arms_.show(state);
        rights_->setVisible(!arms_.empty() && !state.real_time);
        QString loop =
            tr("Loop: %1 µs, 99.9 %: %2 µs, drop-outs %3, faults %4. Force at most %5 N, "
               "stiffness %6 N/m.")
                .arg(format_number(state.period_p50_us, 0), format_number(state.period_p999_us, 0),
                     QString::number(state.gaps), QString::number(state.faults),
                     format_number(state.limit_n, 1), format_number(state.stiffness_n_m, 0));
        if (!state.last_error.isEmpty())
            loop += " " + tr("Last error of the device: %1.").arg(state.last_error);
        loop_->setText(loop);
        floor_->setText(state.floor ? tr("Take the floor away") : tr("Put a floor under the hand"));
        floored_ = floored_ || state.floor;
        for (QPushButton* button : {floor_, bad_}) button->setEnabled(force);
        good_->setEnabled(force && floored_);
        floor_first_->setVisible(force && !floored_);
        if (!force && !arms_.empty())
            force_text_->setText(tr("This device gives no force: there is nothing to test."));
        showHands(state);
    }

    void showHands(const TrialState& state) {
        const bool two = state.arms.size() > 1;
        identify_->setVisible(two);
        if (!two) {
            hand_text_->setText(tr("One arm: it stands for the %1 hand.")
                                    .arg(state.arms.empty() || state.arms[0].hand != "left"
                                             ? tr("right")
                                             : tr("left")));
            return;
        }
        if (!state.identity_asked)
            hand_text_->setText(
                tr("Find out which arm is the right one: press the button below, then move only "
                   "the arm in your right hand, or press its button."));
        else if (state.identity_arm < 0)
            hand_text_->setText(tr("Move the arm in your right hand now; let the other rest."));
        else if (state.identity_arm == 0)
            hand_text_->setText(tr("✓ That is the arm that is set as the right one."));
        else if (!answered_)
            hand_text_->setText(tr("That arm is set as the left one: swap right and left."));
        answered_ = state.identity_arm >= 0;
    }

    void swap() {
        const TrialState state = tester_.state();
        std::vector<haptics::DeviceInfo> infos;
        for (const TriedArm& arm : state.arms) {
            haptics::DeviceInfo info;
            info.serial = arm.serial.toStdString();
            infos.push_back(info);
        }
        tester_.stop();
        const bool done = wishes_.change([&](haptics::Station& station) {
            haptics::swap_hands(station, device_.toStdString(), infos);
        });
        if (done) wishes_.notice(tr("Right and left were swapped and saved."));
        begin();
    }

    void passed() {
        const double force = level();
        tester_.stop();
        const bool done = wishes_.change([&](haptics::Station& station) {
            station.set("tested.device", device_.toStdString());
            station.set("tested.force_n", number_text(force));
            station.set("tested.date", QDate::currentDate().toString(Qt::ISODate).toStdString());
        });
        const double limit = wishes_.station().number("limit.force_n");
        if (done && level_ + 1 < kLevelsN.size() && kLevelsN[level_ + 1] <= limit) {
            ++level_;
            wishes_.notice(tr("%1 N passed and saved; now %2 N.")
                               .arg(format_number(force, 1), format_number(level(), 1)));
        } else if (done) {
            wishes_.notice(
                tr("%1 N passed and saved: the test is complete.").arg(format_number(force, 1)));
        }
        begin();
    }

    // Half of what was too much, as the bench checklist says; the computer may allow less than the
    // level already.
    void failed() {
        const double allowed = wishes_.station().number("limit.force_n");
        const double force = std::max(kLeastLimitN, std::min(level(), allowed) / 2);
        tester_.stop();
        level_ = 0;
        if (wishes_.change([&](haptics::Station& station) {
                station.set("limit.force_n", number_text(force));
                station.set("tested.device", device_.toStdString());
                station.set("tested.force_n", "0");
                station.set("tested.date",
                            QDate::currentDate().toString(Qt::ISODate).toStdString());
            }))
            wishes_.notice(tr("The force of this computer is limited to %1 N now. Check the axes "
                              "and signs of the device before you try again.")
                               .arg(format_number(force, 2)));
        begin();
    }

    void over(const QString& why) {
        stop_->setText(tr("Try again"));
        const Problem problem = device_problem(device_, why);
        loop_->setText(why.isEmpty() ? tr("The test has ended; no force.") : problem.said());
        details_->setText(why);
        for (QPushButton* button : {floor_, good_, bad_}) button->setEnabled(false);
        floor_first_->hide();
    }

    static std::string number_text(double value) { return QString::number(value).toStdString(); }

    AppContext& context_;
    QString device_;
    StationWishes wishes_;
    size_t level_ = 0;
    bool answered_ = false;
    bool floored_ = false;  ///< A floor was there since this force began.
    TrialArms arms_;
    QPushButton *stop_ = nullptr, *floor_ = nullptr, *good_ = nullptr, *bad_ = nullptr,
                *identify_ = nullptr, *swap_ = nullptr;
    Details* details_ = nullptr;
    QLabel *loop_ = nullptr, *rights_ = nullptr, *force_text_ = nullptr, *floor_first_ = nullptr,
           *hand_text_ = nullptr;
    DeviceTester tester_;  // the last: it ends first
};

}  // namespace

QFrame* make_trial_card(AppContext& context, const QString& device, const StationWishes& wishes) {
    return new TrialCard(context, device, wishes);
}

}  // namespace placode::ui
