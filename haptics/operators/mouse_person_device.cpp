// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// "script:mouse": the scripted expert with a mouse in the hand instead of two instruments. What is
// to be done comes from the operator; how, from what a mouse has: whole counts sixty times a
// second, notches of a wheel, buttons, Tab, Shift and Ctrl, one hand at a time. These go as window
// events through the real mouse device and its mapping, so that this shows what a person with a
// mouse can do. The operator's plan waits while the mouse is behind.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/mouse_mapping.h"
#include "haptics/operators/open_operator.h"
#include "haptics/operators/operator_random.h"
#include "haptics/trocar.h"

namespace placode::haptics {

std::unique_ptr<DeviceGroup> open_mouse(const DeviceConfig& config);

namespace {

constexpr int64_t kPollNs = 16'000'000;  // as a window at 60 Hz reports
constexpr int64_t kNotchNs = 90'000'000;
constexpr int64_t kFingerNs = 120'000'000;               // the left hand finds Ctrl or Shift
constexpr int64_t kChangeNs = 350'000'000;               // eye and mind go over to the other hand
constexpr double kMostMS = 0.0375;                       // of the tip: 150 mm/s on the desk
constexpr double kNearM = 2.5e-4, kNearDepthM = 1.2e-4;  // there, at the tissue
constexpr double kAirM = 1e-3, kAirDepthM = 5e-4;        // and on the way to it
constexpr double kLeap = 1.3;                            // notches
constexpr double kAtTissueM = 0.0012;  // of height over the planned line counts as at the tissue
constexpr double kNearRollRad = 0.12;
constexpr double kUnsteady = 0.12;  // a stroke of the mouse is that much longer or shorter, rms

class MousePersonDevice final : public DeviceGroup {
 public:
    explicit MousePersonDevice(const DeviceConfig& config)
        : count_(config.tools.size()),
          hands_(count_),
          wants_(count_),
          states_(count_),
          random_(config.seed + 7) {
        const auto settings = default_trocars(config.tools, "mouse");
        std::vector<Vec3> homes;
        for (size_t i = 0; i < count_; ++i) {
            trocars_.emplace_back(config.tools[i], settings[i]);
            homes.push_back(settings[i].home_tip_m);
            const sim::ToolKind kind = config.tools[i].kind;
            wants_[i].scope = kind == sim::ToolKind::kScope;
            wants_[i].begins_closed = kind == sim::ToolKind::kNeedleDriver;
            wants_[i].jaws = kind == sim::ToolKind::kGrasper || kind == sim::ToolKind::kScissors ||
                             kind == sim::ToolKind::kNeedleDriver;
        }
        while (active_ + 1 < count_ && wants_[active_].scope) ++active_;
        operator_ = open_operator(config, OperatorLevel::kExpert, homes);
        DeviceConfig own = config;
        own.name = "mouse";
        own.window = &window_;
        mouse_ = open_mouse(own);
    }

    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        std::vector<DeviceInfo> out = mouse_->info();
        for (DeviceInfo& device : out) device.model = "script:mouse";
        return out;
    }
    void turn_about(size_t tool, const Vec3& arm_m, const Vec3& axis) noexcept override {
        mouse_->turn_about(tool, arm_m, axis);
        if (tool < carried_.size()) carried_[tool] = !arm_m.isZero();
    }
    void perceive(const Perception& seen) noexcept override {
        operator_->see(seen);
        double highest = seen.contour.empty() ? 1 : -1;
        for (const Vec3& p : seen.contour) highest = std::max(highest, p.z());
        tissue_m_ = highest + kAtTissueM;
    }

    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        if (!began_) {  // the first report is where counting begins
            last_ns_ = t_ns;
            poll_ns_ = t_ns + kPollNs;
            window_.publish(input_);
            began_ = true;
        }
        const double dt = static_cast<double>(t_ns - last_ns_) * 1e-9;
        last_ns_ = t_ns;
        if (!behind()) {
            for (HandAction& hand : hands_) hand = {};
            done_ = operator_->act(dt, hands_) || done_;
            for (size_t i = 0; i < count_; ++i) want(i);
        }
        if (t_ns >= poll_ns_) {
            use_mouse(t_ns);
            poll_ns_ += kPollNs;
            window_.publish(input_);
        }
        mouse_->read(t_ns, states_);
        std::copy_n(states_.begin(), std::min(states.size(), count_), states.begin());
    }
    void write(std::span<const DeviceCommand> commands) noexcept override {
        mouse_->write(commands);
    }
    [[nodiscard]] bool lock_step() const noexcept override { return true; }

 private:
    /// What the plan asks of one hand, as the device would say it.
    struct Want {
        bool scope = false, jaws = false, any = false, closed = false;
        bool begins_closed = false;  // on a needle; other jaws wait for the plan to open them
        Vec3 position_m = Vec3::Zero(), opening = Vec3::Zero(), across = Vec3::Zero();
        bool at_tissue = false;
        uint8_t pedals = 0;
        double widest_rad = 0.1;  // that the plan has opened the jaws
    };

    void want(size_t i) noexcept {
        const HandAction& hand = hands_[i];
        Want& w = wants_[i];
        if (!hand.engaged) {
            w.pedals = 0;
            return;
        }
        w.any = true;
        w.position_m = trocars_[i].device_position(hand.tip_m);
        w.at_tissue = hand.tip_m.z() < tissue_m_;
        w.opening = hand.opening;
        w.across = hand.across;
        w.pedals = hand.pedals;
        if (hand.jaw_rad > w.widest_rad) w.widest_rad = hand.jaw_rad;
        const double share = hand.jaw_rad / w.widest_rad;
        if (share < 0.5) w.closed = w.begins_closed || w.widest_rad > 0.1;
        if (share > 0.6) w.closed = false;
    }

    [[nodiscard]] double turn(size_t i) noexcept {
        DeviceState straight = states_[i];
        straight.roll_rad = 0;
        const sim::Pose pose = trocars_[i].tip_pose(straight);
        return wants_[i].across.isZero()
                   ? turn_to_open_along(wants_[i].opening, pose, states_[i].roll_rad)
                   : turn_to_lie_along(wants_[i].across, pose, states_[i].roll_rad);
    }

    /// The hand is not yet where and how the plan wants it.
    [[nodiscard]] bool lacks(size_t i) noexcept {
        const Want& w = wants_[i];
        if (!w.any) return false;
        const Vec3 gap = w.position_m - states_[i].position_m;
        if (gap.head<2>().norm() > (w.at_tissue ? kNearM : kAirM)) return true;
        if (std::abs(gap.z()) > (w.at_tissue ? kNearDepthM : kAirDepthM)) return true;
        if (w.scope) return false;
        if (!states_[i].engaged || states_[i].pedals != w.pedals) return true;
        return w.jaws && (std::abs(turn(i)) > kNearRollRad || w.closed != closed_[i]);
    }

    [[nodiscard]] bool behind() noexcept {
        for (size_t i = 0; i < count_; ++i)
            if (lacks(i)) return true;
        return false;
    }

    void press(sim::Key key, bool down) noexcept {
        const auto k = static_cast<size_t>(key);
        if (down && !input_.down[k]) ++input_.presses[k];
        input_.down[k] = down;
    }

    [[nodiscard]] bool holds(sim::Key key) const noexcept { return input_.is_down(key); }

    /// One report of the window.
    void use_mouse(int64_t t_ns) noexcept {
        input_.t_ns = t_ns;
        press(sim::Key::kTab, false);
        press(sim::Key::kEnter, done_);
        // Where the last Tab has led to.
        for (size_t i = 0; i < count_; ++i)
            if (states_[i].in_hand) active_ = i;
        if (t_ns < busy_until_ns_) return;
        size_t hand = active_;
        input_.middle = false;
        if (!lacks(active_)) {
            for (size_t i = 0; i < count_ && hand == active_; ++i)
                if (i != active_ && lacks(i)) hand = i;
        }
        if (hand != active_ && !wants_[hand].scope) {
            change(t_ns);
            return;
        }
        if (hand != active_) input_.middle = true;
        move(hand, t_ns);
        if (hand != active_) return;
        const Want& w = wants_[hand];
        if (w.jaws && latched_[hand]) {
            // A click opens jaws that were left closed.
            input_.left = true;
            latched_[hand] = false;
        } else if (w.jaws) {
            input_.left = w.closed;
            closed_[hand] = w.closed;
        } else {
            input_.left = (w.pedals & sim::kPedalCut) != 0;
            input_.right = (w.pedals & sim::kPedalCoag) != 0;
        }
    }

    /// Tab, then the button is let go: closed jaws stay closed.
    void change(int64_t t_ns) noexcept {
        busy_until_ns_ = t_ns + kChangeNs;
        press(sim::Key::kShift, false);
        press(sim::Key::kControl, false);
        if (input_.down[static_cast<size_t>(sim::Key::kTab)]) return;
        press(sim::Key::kTab, true);
        // Other jaws wait for what the plan does with them next.
        latched_[active_] = wants_[active_].begins_closed && closed_[active_];
        input_.left = input_.right = false;
    }

    void move(size_t hand, int64_t t_ns) noexcept {
        const Want& w = wants_[hand];
        const Vec3 gap = w.position_m - aimed(hand);
        const double angle = w.jaws && hand == active_ ? turn(hand) : 0;
        const bool twist = std::abs(angle) > 0.5 * kNearRollRad;
        // At the tissue Ctrl is held, a fifth of everything, but for leaps out of it.
        const double z = gap.z();
        const bool fine = w.at_tissue && std::abs(z) < kLeap * kMouseNotchM;
        if (holds(sim::Key::kShift) != twist || holds(sim::Key::kControl) != fine) {
            press(sim::Key::kShift, twist);
            press(sim::Key::kControl, fine);
            busy_until_ns_ = t_ns + kFingerNs;
            return;
        }
        const double gain = fine ? kMousePrecision : 1.0;
        if (twist) {
            input_.mouse_x += std::clamp(std::round(angle / (gain * kMouseRollRad)), -60.0, 60.0);
            busy_until_ns_ = t_ns + 2 * kPollNs;
            swung_[hand] = carried_[hand];
            return;
        }
        if (t_ns >= notch_ns_ && std::abs(z) >= 0.6 * gain * kMouseNotchM) {
            const double notch = z < 0 ? 1 : -1;
            input_.wheel += notch;
            aim_[hand].z() -= gain * kMouseNotchM * notch;
            notch_ns_ = t_ns + kNotchNs;
        }
        Vec3 step(gap.x(), gap.y(), 0);
        const double most = gain * kMostMS * static_cast<double>(kPollNs) * 1e-9;
        if (step.norm() > most) step *= most / step.norm();
        step *= 1 + kUnsteady * random_.normal();
        const double dx = std::round(step.x() / (gain * kMouseCountM)),
                     dy = std::round(-step.y() / (gain * kMouseCountM));
        input_.mouse_x += dx;
        input_.mouse_y += dy;
        aim_[hand] += gain * kMouseCountM * Vec3(dx, -dy, 0);
    }

    /// Where the device is going; an instrument that came in anew begins at its start.
    [[nodiscard]] Vec3 aimed(size_t hand) noexcept {
        if (!came_in_[hand] && states_[hand].engaged) aim_[hand] = states_[hand].position_m;
        // The tip goes round with a needle that is turned.
        if (swung_[hand]) aim_[hand] = states_[hand].position_m;
        swung_[hand] = false;
        came_in_[hand] = states_[hand].engaged;
        return aim_[hand];
    }

    size_t count_, active_ = 0;
    std::vector<Trocar> trocars_;
    std::vector<HandAction> hands_;
    std::vector<Want> wants_;
    std::vector<DeviceState> states_;
    std::array<bool, sim::kMaxTools> closed_{}, came_in_{}, carried_{}, swung_{}, latched_{};
    std::array<Vec3, sim::kMaxTools> aim_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    OperatorRandom random_;
    sim::Latest<sim::WindowInput> window_;
    sim::WindowInput input_;
    std::unique_ptr<ScriptedOperator> operator_;
    std::unique_ptr<DeviceGroup> mouse_;
    double tissue_m_ = 1;
    int64_t last_ns_ = 0, poll_ns_ = 0, busy_until_ns_ = 0, notch_ns_ = 0;
    bool began_ = false, done_ = false;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_mouse_person(const DeviceConfig& config) {
    return std::make_unique<MousePersonDevice>(config);
}

}  // namespace placode::haptics
