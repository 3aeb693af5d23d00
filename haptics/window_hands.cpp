// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/window_hands.h"

#include <algorithm>
#include <cmath>

#include "haptics/trocar.h"
#include "sim/cutting/grasp.h"

namespace placode::haptics {

namespace {

constexpr int64_t kPedalTimeoutNs = 10'000'000'000;
constexpr double kSpeedCapMS = 0.150;
constexpr double kLagLimitM = 0.020;     // A flick is not stored as motion to come.
constexpr double kFollowS = 0.025;       // Bridges the 60 Hz of the window at 1 kHz.
constexpr double kFollowDepthS = 0.050;  // A wheel notch is a step; 95 % of it in 0.15 s.
constexpr double kTurnCapRadS = 4;       // of a needle: its point at 20 mm/s
constexpr double kEaseS = 0.050;         // 95 % of the speed in 0.15 s.
constexpr double kJawRadS = 1.2;  // A button is pressed at once, a hand closes in 0.2 to 0.3 s.
// A button knows open and closed only: the working opening, not the widest, or jaws would gather
// what lies beside the place that is meant, and each snip would be as long as the blades.
constexpr double kGrasperOpening = 0.4, kBladeOpening = 0.3;
constexpr double kRatchet = 0.18;  // of the full jaw force: holds membrane without crushing it
const Vec3 kReachLow(-0.045, -0.045, -0.025), kReachHigh(0.045, 0.045, 0.040);
const Vec3 kScopeReach(0.020, 0.020, 0.015);

}  // namespace

uint8_t PedalGuard::update(uint8_t pressed, int64_t t_ns, bool allowed, bool endless) noexcept {
    if (pressed == 0) spent_ = false;
    if (pressed != 0 && before_ == 0) since_ns_ = t_ns;
    before_ = pressed;
    const bool late = !endless && t_ns - since_ns_ > kPedalTimeoutNs;
    if (pressed != 0 && (!allowed || late)) spent_ = true;
    return spent_ ? 0 : pressed;
}

WindowHands::WindowHands(const DeviceConfig& config, std::string model)
    : model_(std::move(model)),
      window_(config.window),
      hands_(config.tools.size()),
      feet_(config.station) {
    bool found = false;
    for (size_t i = 0; i < hands_.size(); ++i) {
        const auto kind = config.tools[i].kind;
        hands_[i].scope = kind == sim::ToolKind::kScope;
        hands_[i].others_in_port = others_in_port(config.tools, i);
        hands_[i].out = (hands_[i].others_in_port & ((1U << i) - 1)) != 0;
        const bool scissors = kind == sim::ToolKind::kScissors;
        const bool grasper = kind == sim::ToolKind::kGrasper;
        const bool driver = kind == sim::ToolKind::kNeedleDriver;
        if (scissors || grasper || driver)
            hands_[i].jaw_open_rad =
                (scissors ? kBladeOpening : kGrasperOpening) * config.tools[i].jaw_open_rad;
        if (grasper) hands_[i].jaw_least_rad = (1 - kRatchet) * sim::grip_angle(config.tools[i]);
        hands_[i].holds = grasper || driver;
        // Open from the start: jaws that open by themselves would start the clock.
        hands_[i].jaw_rad = std::max(hands_[i].jaw_open_rad, hands_[i].jaw_least_rad);
        hands_[i].energy = sim::uses_pedals(kind);
        // A pedal that sticks burns; water may run.
        hands_[i].endless = kind == sim::ToolKind::kIrrigator || !hands_[i].energy;
        if (!hands_[i].scope && !found) {
            active_ = i;
            found = true;
        }
    }
}

std::vector<DeviceInfo> WindowHands::info() const {
    DeviceInfo device;
    device.vendor = "Placode";
    device.model = model_;
    device.driver = "window";
    device.dof_sensed = 4;
    return std::vector<DeviceInfo>(hands_.size(), device);
}

void WindowHands::ease(WindowHand& hand, const Vec3& wished_m_s, double dt_s) noexcept {
    hand.rate_m_s += (wished_m_s - hand.rate_m_s) * (1 - std::exp(-dt_s / kEaseS));
    if (hand.rate_m_s.norm() < 1e-7) hand.rate_m_s.setZero();
    hand.target_m += hand.rate_m_s * dt_s;
}

void WindowHands::follow(WindowHand& hand, double dt_s) noexcept {
    const Vec3 low = hand.scope ? Vec3(-kScopeReach) : kReachLow;
    const Vec3 high = hand.scope ? kScopeReach : kReachHigh;
    hand.target_m = hand.target_m.cwiseMax(low).cwiseMin(high);
    Vec3 gap = hand.target_m - hand.position_m;
    if (gap.norm() > kLagLimitM) {
        gap *= kLagLimitM / gap.norm();
        hand.target_m = hand.position_m + gap;
    }
    const double plane = 1 - std::exp(-dt_s / kFollowS);
    const double depth = 1 - std::exp(-dt_s / kFollowDepthS);
    Vec3 step = gap.cwiseProduct(Vec3(plane, plane, depth));
    const double cap = kSpeedCapMS * dt_s;
    if (step.norm() > cap) step *= cap / step.norm();
    hand.position_m += step;
    hand.velocity_m_s = dt_s > 0 ? Vec3(step / dt_s) : Vec3(Vec3::Zero());
}

void WindowHands::turn_about(size_t tool, const Vec3& arm_m, const Vec3& axis) noexcept {
    if (tool >= hands_.size() || !arm_m.allFinite() || !axis.allFinite()) return;
    hands_[tool].arm_m = arm_m;
    hands_[tool].axis = axis;
}

/// Roll as the device has it; about a needle's own axis the tip goes round with it.
void WindowHands::turn(WindowHand& hand, double dt_s) noexcept {
    const double gap = hand.roll_rad - hand.turned_rad;
    if (hand.arm_m.isZero()) {
        hand.turned_rad = hand.roll_rad;
        return;
    }
    const double most = kTurnCapRadS * dt_s;
    const double step = std::clamp(gap * (1 - std::exp(-dt_s / kFollowS)), -most, most);
    hand.turned_rad += step;
    const Vec3 offset = hand.arm_m - Eigen::AngleAxisd(step, hand.axis) * hand.arm_m;
    hand.target_m += offset;
    hand.position_m += offset;
}

/// Jaws that were left closed in its port do not make room for it: with one hand for all, whoever
/// holds tissue or a needle would lose it on the way to the other side.
bool WindowHands::kept_out(size_t i) const noexcept {
    for (size_t k = 0; k < hands_.size(); ++k) {
        const WindowHand& other = hands_[k];
        if ((hands_[i].others_in_port >> k & 1U) != 0 && other.holds && other.latched && !other.out)
            return true;
    }
    return false;
}

void WindowHands::next_hand(uint32_t presses) noexcept {
    for (uint32_t k = 0; k < presses % (hands_.size() + 1); ++k) {
        WindowHand& left = hands_[active_];
        left.latched = left.latched || ((held_before_ & sim::kPedalCut) != 0 && !left.energy &&
                                        pressed_by_ == active_);
        size_t i = active_;
        do i = (i + 1) % hands_.size();
        while (i != active_ && (hands_[i].scope || kept_out(i)));
        active_ = i;
        // Another instrument through the same port: the old one leaves, the new one comes in at
        // its start.
        for (size_t k = 0; k < hands_.size(); ++k) {
            if ((hands_[i].others_in_port >> k & 1U) == 0) continue;
            hands_[k].out = true;
            hands_[k].target_m.setZero();
            hands_[k].position_m.setZero();
            hands_[k].rate_m_s.setZero();
            hands_[k].jaw_rad = 0;
            hands_[k].latched = false;
        }
        hands_[i].out = false;
    }
}

// A press belongs to the hand that was active when it began: whoever changes hands with the button
// down neither cuts nor closes with the new one.
uint8_t WindowHands::own_press(uint8_t held) noexcept {
    if (held != 0 && held_before_ == 0) {
        pressed_by_ = active_;
        hands_[active_].latched = false;
    }
    held_before_ = held;
    return pressed_by_ == active_ ? held : 0;
}

// Nobody opens a hand in a pause or in another window: jaws whose button is let go there, or is
// seen no more, stay closed until the next press. Energy is never kept. What is pressed there
// begins afterwards.
uint8_t WindowHands::keep_jaws(uint8_t held) noexcept {
    const auto let_go = static_cast<uint8_t>(held_before_ & ~held);
    held_before_ &= held;
    if (pressed_by_ != active_) return 0;
    if ((let_go & sim::kPedalCut) != 0 && !hands_[active_].energy) hands_[active_].latched = true;
    return held_before_;
}

void WindowHands::move_jaw(WindowHand& hand, bool pressed, double dt_s) const noexcept {
    const double step = pressed || hand.latched ? -kJawRadS * dt_s : kJawRadS * dt_s;
    hand.jaw_rad = std::clamp(hand.jaw_rad + step, hand.jaw_least_rad,
                              std::max(hand.jaw_open_rad, hand.jaw_least_rad));
}

/// What the window asks of hand and scope in this tick.
void WindowHands::move_hands(const sim::WindowInput& now, double dt_s) noexcept {
    const auto key = [](sim::Key k) { return static_cast<size_t>(k); };
    next_hand(now.presses[key(sim::Key::kTab)] - before_.presses[key(sim::Key::kTab)]);
    WindowHand* scope = nullptr;
    for (auto& hand : hands_)
        if (hand.scope) scope = &hand;
    const bool clutch = now.is_down(sim::Key::kSpace);
    if (clutch)
        hands_[active_].rate_m_s.setZero();
    else
        move(now, before_, dt_s, hands_[active_], scope);
    if (now.presses[key(sim::Key::kEnter)] != before_.presses[key(sim::Key::kEnter)] || finish(now))
        finished_ = true;
}

void WindowHands::stand_still() noexcept {
    for (auto& hand : hands_) {
        hand.target_m = hand.position_m;
        hand.rate_m_s.setZero();
        hand.roll_rad = hand.turned_rad;
    }
}

/// Those that count, of the active hand.
uint8_t WindowHands::pedals_down(const sim::WindowInput& now, int64_t t_ns, bool attended,
                                 bool allowed) noexcept {
    uint8_t pressed = static_cast<uint8_t>(buttons(now) | feet_.poll(t_ns));
    if (now.is_down(sim::Key::kCut)) pressed |= sim::kPedalCut;
    if (now.is_down(sim::Key::kCoag)) pressed |= sim::kPedalCoag;
    // A pedal that is down in a pause has to be pressed anew; jaws stay as they are.
    const bool may_press = hands_[active_].energy ? allowed : attended;
    const uint8_t counts = pedals_.update(pressed, t_ns, may_press, hands_[active_].endless);
    return allowed ? own_press(counts) : keep_jaws(counts);
}

DeviceState WindowHands::state_of(size_t i, int64_t t_ns, uint8_t held, bool there) const noexcept {
    const WindowHand& hand = hands_[i];
    DeviceState out;
    out.sequence = sequence_;
    out.t_ns = t_ns;
    out.position_m = hand.position_m;
    out.velocity_m_s = hand.velocity_m_s;
    out.roll_rad = hand.turned_rad;
    out.jaw_rad = hand.energy || hand.scope ? 0 : hand.jaw_rad;
    out.pedals = i == active_ && hand.energy ? held : 0;
    out.finish = finished_;
    out.engaged = !hand.out;
    out.in_hand = i == active_;
    out.status = there ? DeviceStatus::kReady : DeviceStatus::kLost;
    return out;
}

void WindowHands::read(int64_t t_ns, std::span<DeviceState> states) noexcept {
    if (hands_.empty()) return;
    before_read(t_ns);
    if (window_ != nullptr && window_->refresh()) age_.heard(t_ns);
    const sim::WindowInput& now = window_ != nullptr ? window_->front() : idle_;
    if (!seen_) before_ = now;  // Totals from before the attempt do not count.
    const double dt =
        seen_ ? std::clamp(static_cast<double>(t_ns - last_ns_) * 1e-9, 0.0, 0.010) : 0.0;
    seen_ = true;
    last_ns_ = t_ns;

    const bool there = present(now);
    const bool attended = now.focused && there && !age_.stale(t_ns);
    const bool allowed = attended && !on_hold_;
    if (allowed)
        move_hands(now, dt);
    else
        stand_still();
    const uint8_t held = pedals_down(now, t_ns, attended, allowed);
    before_ = now;

    ++sequence_;
    for (size_t i = 0; i < std::min(states.size(), hands_.size()); ++i) {
        WindowHand& hand = hands_[i];
        follow(hand, dt);
        turn(hand, dt);
        if (i == active_ && !hand.energy && !on_hold_)
            move_jaw(hand, (held & sim::kPedalCut) != 0, dt);
        states[i] = state_of(i, t_ns, held, there);
    }
}

}  // namespace placode::haptics
