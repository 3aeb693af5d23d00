// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm_hands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/cutting/grasp.h"

namespace placode::haptics {

namespace {

constexpr uint32_t kGripButton = 1, kClutchButton = 2, kCoagButton = 4;
constexpr int64_t kShortPressNs = 250'000'000;  // shorter: change of instrument
constexpr double kJawS = 0.150;                 // a button closes jaws in this time
constexpr double kRatchet = 0.18;               // as for the mouse: holds without crushing
constexpr double kMeetM = 0.002;                // an arm is back at its instrument

bool energy_tool(const sim::ToolSpec& tool) noexcept { return sim::uses_pedals(tool.kind); }

double nearest_turn(double angle, double to) noexcept {
    const double turn = 2 * std::numbers::pi;
    return angle + turn * std::round((to - angle) / turn);
}

}  // namespace

ArmHands::ArmHands(const DeviceConfig& config, const std::vector<sim::Hand>& hands)
    : tools_(config.tools), window_(config.window), feet_(config.station) {
    for (size_t i = 0; i < tools_.size(); ++i) {
        Handle handle;
        if (tools_[i].kind == sim::ToolKind::kGrasper)
            handle.jaw_least_rad = (1 - kRatchet) * sim::grip_angle(tools_[i]);
        handle.shares_port = others_in_port(tools_, i) != 0;
        handles_.push_back(handle);
    }
    for (const sim::Hand hand : hands) {
        Arm arm;
        arm.hand = hand;
        for (size_t i = 0; i < tools_.size(); ++i) {
            const bool scope = tools_[i].kind == sim::ToolKind::kScope;
            if (!scope && (hands.size() == 1 || tools_[i].hand == hand)) arm.tools.push_back(i);
        }
        // A single arm begins with its own hand.
        std::stable_partition(arm.tools.begin(), arm.tools.end(),
                              [&](size_t i) { return tools_[i].hand == hand; });
        arms_.push_back(std::move(arm));
    }
}

std::vector<DeviceInfo> ArmHands::info() const {
    const std::vector<DeviceInfo> arms = arm_info();
    std::vector<DeviceInfo> out(tools_.size());
    for (size_t i = 0; i < tools_.size(); ++i) {
        if (!arms.empty()) out[i] = arms.front();
        for (size_t a = 0; a < arms_.size() && a < arms.size(); ++a)
            if (arms_[a].hand == tools_[i].hand) out[i] = arms[a];
        if (tools_[i].kind == sim::ToolKind::kScope) out[i].dof_force = out[i].dof_torque = 0;
    }
    return out;
}

void ArmHands::change_tool(Arm& arm) noexcept {
    if (arm.tools.size() < 2) return;
    // What leaves a shared port comes in again at its home; what has its own port stays.
    Handle& old = handles_[arm.tools[arm.turn]];
    if (old.shares_port) {
        old.position_m.setZero();
        old.roll_rad = old.jaw_rad = 0;
    }
    arm.turn = (arm.turn + 1) % arm.tools.size();
    arm.anchored = arm.waits = arm.met = false;
}

// An arm that is itself the instrument in the port cannot be taken up elsewhere. Behind a pause its
// tool stays, held and without force, until the arm is back where it stands, or is drawn out and
// comes in anew.
void ArmHands::wait_for_arm(Arm& arm, const ArmSample& sample) const noexcept {
    if (arm.tools.empty()) return;
    if (on_hold_) {
        arm.waits = arm.waits || (sample.absolute && arm.anchored);
        return;
    }
    if (!arm.waits) return;
    const Vec3 gap = sample.position_m - handles_[arm.tools[arm.turn]].position_m;
    const bool there = sample.status == DeviceStatus::kReady && sample.held;
    arm.met = there && gap.norm() <= kMeetM;
    arm.waits = there && !arm.met;
}

// Held, the second button lets the hand move without the tool; tapped, it changes the instrument.
// A pause is a clutch for every arm.
void ArmHands::clutch(Arm& arm, const ArmSample& sample, int64_t t_ns) noexcept {
    const bool now = (sample.buttons & kClutchButton) != 0;
    const bool before = (arm.buttons & kClutchButton) != 0;
    if (now && !before) arm.pressed_ns = t_ns;
    if (before && !now && !on_hold_ && t_ns - arm.pressed_ns < kShortPressNs) change_tool(arm);
    wait_for_arm(arm, sample);
    arm.clutched = sample.absolute ? arm.waits : now || on_hold_;
    arm.buttons = sample.buttons;
}

// The tool goes on from where it was: a new hold never makes it jump.
void ArmHands::follow(Arm& arm, const ArmSample& sample) noexcept {
    const bool usable = sample.status == DeviceStatus::kReady && sample.held && !arm.clutched &&
                        sample.position_m.allFinite();
    if (!usable) {
        arm.anchored = false;
        return;
    }
    if (arm.tools.empty()) return;
    Handle& handle = handles_[arm.tools[arm.turn]];
    if (!arm.anchored) {
        arm.anchored = true;
        arm.zero_m = sample.position_m - handle.position_m;
        arm.roll_zero = sample.roll_rad - handle.roll_rad;
        // The turn that an arm made in a pause stays between it and its tool.
        if (sample.absolute) arm.zero_m.setZero();
        if (sample.absolute && !arm.met) arm.roll_zero = 0;
        arm.met = false;
    }
    handle.position_m = sample.position_m - arm.zero_m;
    handle.roll_rad = nearest_turn(sample.roll_rad - arm.roll_zero, handle.roll_rad);
}

void ArmHands::fill(Arm& arm, const ArmSample& sample, uint8_t pedals, double dt_s,
                    std::span<DeviceState> states) noexcept {
    for (size_t n = 0; n < arm.tools.size(); ++n) {
        const size_t i = arm.tools[n];
        if (i >= states.size()) continue;
        DeviceState& out = states[i];
        Handle& handle = handles_[i];
        out.position_m = handle.position_m;
        out.roll_rad = handle.roll_rad;
        const bool energy = energy_tool(tools_[i]);
        if (n != arm.turn) {
            // Waits outside where it shares the port; stands still, as it was, where it does not.
            // The hand is elsewhere: its force begins by a ramp when it comes back.
            out.engaged = !handle.shares_port;
            out.clutched = true;
            out.jaw_rad = energy ? 0 : handle.jaw_rad;
            continue;
        }
        const bool close = (sample.buttons & kGripButton) != 0;
        const double widest = tools_[i].jaw_open_rad;
        const double step = widest * dt_s / kJawS;
        double jaw = handle.jaw_rad + (close ? -step : step);
        if (std::isfinite(sample.jaw)) jaw = widest * std::clamp(sample.jaw, 0.0, 1.0);
        if (!on_hold_) handle.jaw_rad = std::clamp(jaw, handle.jaw_least_rad, widest);
        if (!sample.position_m.allFinite()) out.position_m = sample.position_m;  // a doubt: say so
        out.orientation = sample.orientation;
        out.jaw_rad = energy ? 0 : handle.jaw_rad;
        out.buttons = sample.buttons;
        out.pedals = energy ? pedals : 0;
        out.status = sample.status;
        out.engaged = sample.held;
        out.clutched = arm.clutched;
        out.motor_heat = sample.motor_heat;
    }
}

void ArmHands::read(int64_t t_ns, std::span<DeviceState> states) noexcept {
    const double dt =
        sequence_ > 0 ? std::clamp(static_cast<double>(t_ns - last_ns_) * 1e-9, 0.0, 0.010) : 0.0;
    last_ns_ = t_ns;
    ++sequence_;
    if (window_ != nullptr && window_->refresh()) age_.heard(t_ns);
    const sim::WindowInput& now = window_ != nullptr ? window_->front() : idle_;
    if (!window_seen_) before_ = now;
    window_seen_ = true;
    const auto pressed = [&](sim::Key key) {
        const auto k = static_cast<size_t>(key);
        return now.presses[k] != before_.presses[k];
    };
    if (now.focused && pressed(sim::Key::kEnter)) finished_ = true;
    const bool tab = now.focused && pressed(sim::Key::kTab);

    for (ArmSample& sample : samples_) sample = {};
    sense(t_ns, {samples_.data(), arms_.size()});
    const bool cut_key = now.is_down(sim::Key::kCut), coag_key = now.is_down(sim::Key::kCoag);
    uint8_t feet = feet_.poll(t_ns);
    if (cut_key) feet |= sim::kPedalCut;
    if (coag_key) feet |= sim::kPedalCoag;
    // Keys that stand for pedals are only as good as what the window said last.
    const bool doubtful = (cut_key || coag_key) && age_.stale(t_ns);
    bool held = false;
    for (size_t a = 0; a < arms_.size(); ++a) {
        feet = static_cast<uint8_t>(feet | samples_[a].pedals);
        held = held || (samples_[a].held && samples_[a].status == DeviceStatus::kReady);
        // Without pedals the buttons of an arm with a needle stand for them.
        const Arm& arm = arms_[a];
        if (arm.tools.empty() || !energy_tool(tools_[arm.tools[arm.turn]])) continue;
        if ((samples_[a].buttons & kGripButton) != 0) feet |= sim::kPedalCut;
        if ((samples_[a].buttons & kCoagButton) != 0) feet |= sim::kPedalCoag;
    }
    // A pedal that is down in a pause has to be pressed anew.
    const uint8_t pedals = guard_.update(feet, t_ns, now.focused && held && !on_hold_ && !doubtful);
    before_ = now;

    for (DeviceState& state : states) {
        state = {};
        state.sequence = sequence_;
        state.t_ns = t_ns;
        state.finish = finished_;
    }
    for (size_t i = 0; i < std::min(states.size(), tools_.size()); ++i)
        states[i].engaged = tools_[i].kind == sim::ToolKind::kScope;
    for (size_t a = 0; a < arms_.size(); ++a) {
        clutch(arms_[a], samples_[a], t_ns);
        if (tab) change_tool(arms_[a]);
        follow(arms_[a], samples_[a]);
        fill(arms_[a], samples_[a], pedals, dt, states);
    }
}

void ArmHands::write(std::span<const DeviceCommand> commands) noexcept {
    for (size_t a = 0; a < arms_.size(); ++a) {
        const Arm& arm = arms_[a];
        ArmForce& out = forces_[a];
        out = {};
        out.position_m = samples_[a].position_m;
        if (arm.tools.empty() || arm.tools[arm.turn] >= commands.size()) continue;
        const DeviceCommand& command = commands[arm.tools[arm.turn]];
        const bool allowed = samples_[a].status == DeviceStatus::kReady && samples_[a].held &&
                             !arm.clutched && command.force_n.allFinite();
        if (allowed) out.force_n = command.force_n;
        out.valid_until_ns = command.valid_until_ns;
    }
    drive({forces_.data(), arms_.size()});
}

}  // namespace placode::haptics
