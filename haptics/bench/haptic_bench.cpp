// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/bench/haptic_bench.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "haptics/bench/haptic_bench_hand.h"
#include "haptics/bench/haptic_bench_tissue.h"
#include "haptics/minimum_jerk.h"

namespace placode::haptics {

namespace {

constexpr HandModel kGrips[] = {{"firm", 800, 3}, {"light", 150, 0.5}, {"fingertip", 60, 0.2}};
constexpr double kTick = kHapticBenchTickS;
constexpr double kStartS = 0.6;  // after the ramp of the force
constexpr double kPushS = 0.3, kDisturbS = 2.0, kUnplugS = 0.1;
constexpr double kEndS = 0.5;  // what is measured at the end

/// What the servo sees of it.
struct Link {
    DeviceState state;
    Vec3 force = Vec3::Zero();
    int64_t valid_until_ns = 0;
};

class BenchDevice final : public DeviceGroup {
 public:
    explicit BenchDevice(Link& link) : link_(link) {}
    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        DeviceInfo info;
        info.vendor = "Placode";
        info.model = "bench";
        info.driver = "model";
        info.dof_sensed = info.dof_force = 3;
        return {info};
    }
    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        states[0] = link_.state;
        states[0].t_ns = t_ns;
    }
    void write(std::span<const DeviceCommand> commands) noexcept override {
        link_.force = commands[0].force_n;
        link_.valid_until_ns = commands[0].valid_until_ns;
    }
    [[nodiscard]] bool lock_step() const noexcept override { return true; }

 private:
    Link& link_;
};

sim::ToolSpec bench_tool(double hand_n_m) {
    sim::ToolSpec tool;
    tool.hand_n_m = hand_n_m;  // as in an attempt with force
    tool.kind = sim::ToolKind::kProbe;
    tool.tip_radius_m = 0.0015;
    tool.pivot_m = Vec3(0, 0, 0.100);
    return tool;
}

/// Tip mapping along the axes of the world: what the coupling sees is what the hand does.
TrocarSettings bench_trocar() {
    TrocarSettings settings;
    settings.mapping = Mapping::kTip;
    settings.home_tip_m = Vec3(0, 0, 0.0002);
    return settings;
}

class Run {
 public:
    explicit Run(const HapticBenchCase& what)
        : what_(what),
          hand_(what.grip, what.friction),
          tool_(bench_tool(what.settings.stiffness_n_m)),
          servo_(std::make_unique<BenchDevice>(link_), std::span(&tool_, 1), std::span(&trocar_, 1),
                 what.settings),
          home_(trocar_.home_tip_m),
          trouble_(what.soak_seed) {
        const double ratio = 1000 / what.physics_hz;
        every_ = static_cast<int>(std::lround(ratio));
        if (every_ < 1 || std::abs(ratio - every_) > 1e-9 || what.hold_ticks < 1)
            throw std::invalid_argument("port bench: the physics rate must divide 1000 Hz");
        if (what.world == HapticBenchWorld::kTissue)
            tissue_.emplace(tool_, what.youngs_modulus_pa, every_ * kTick);
        feedback_[0].proxy.p = pending_.proxy.p = home_;
    }

    HapticBenchResult all() {
        const int ticks = static_cast<int>(std::lround(what_.seconds / kTick));
        for (int i = 0; i < ticks; ++i) tick(i);
        finish();
        return std::move(result_);
    }

 private:
    [[nodiscard]] Vec3 target(double t) const noexcept {
        if (what_.world == HapticBenchWorld::kAir) {
            // 2 Hz to and fro, once the force has begun.
            const double w = 2 * std::numbers::pi * 2;
            const double rise = std::min(1.0, t);
            return what_.direction * (rise * what_.speed_m_s / w * std::sin(w * t));
        }
        if (what_.soak_seed != 0) {
            // In and out at 0.4 Hz: hand and tool meet again whatever has come between them.
            const double in = std::sin(2 * std::numbers::pi * 0.4 * t);
            return what_.direction * (minimum_jerk(t) * what_.push_m * (0.3 + in));
        }
        return what_.direction * (what_.push_m * minimum_jerk((t - kStartS) / kPushS));
    }
    [[nodiscard]] Vec3 swept(double t) const noexcept {
        const double in = 1.5 * minimum_jerk((t - kStartS) / kPushS);
        return what_.direction * (what_.sweep_m * (in + std::sin(sweep_phase(t))));
    }

    // The world answers to the input of this frame; it is published a frame later.
    void physics(int i, double t) {
        const bool stalled =
            (what_.stall_s > 0 && t >= kDisturbS && t < kDisturbS + what_.stall_s) ||
            trouble_.now == Trouble::Kind::kStall;
        if (i % every_ != 0 || stalled) return;
        if (!what_.prompt) feedback_[0] = pending_;
        pending_.time_s = t + kTick;
        const Vec3 tip = inputs_[0].pose().p;
        if (tissue_) {
            tissue_->frame(inputs_[0], pending_);
            pending_.time_s = t + kTick;
        } else {
            pending_.proxy.p = tip;
            // A wall takes what goes through it.
            const double behind = (tip - home_).dot(what_.direction);
            if (what_.world == HapticBenchWorld::kWall && behind > 0)
                pending_.proxy.p -= behind * what_.direction;
            pending_.force_n = tool_.hand_n_m * (pending_.proxy.p - tip);
        }
        if (what_.prompt) feedback_[0] = pending_;
    }

    void disturb(double t) noexcept {
        DeviceState& state = link_.state;
        state.status = DeviceStatus::kReady;
        const bool now = t >= kDisturbS && t < kDisturbS + kTick / 2;
        if (what_.nan && now) state.position_m.x() = std::nan("");
        if (what_.teleport && now) state.position_m.y() += 0.02;
        if (what_.unplug && t >= kDisturbS && t < kDisturbS + kUnplugS)
            state.status = DeviceStatus::kLost;
        if (trouble_.now == Trouble::Kind::kNan) state.position_m.z() = std::nan("");
        if (trouble_.now == Trouble::Kind::kJump) state.position_m.y() += 0.02;
        if (trouble_.now == Trouble::Kind::kUnplug) state.status = DeviceStatus::kLost;
    }

    // One tick of the servo, or what a driver does without one.
    void serve(int i) noexcept {
        const bool gap = trouble_.now == Trouble::Kind::kGap;
        const int64_t now_ns = static_cast<int64_t>(i + 1) * 1'000'000 - back_ns_;
        if (i % what_.hold_ticks == 0 && !gap) {
            // After a gap a scheduler of a vendor may tick in a burst.
            for (int n = gap_ ? 3 : 0; n > 0; --n)
                servo_.tick(now_ns - 50'000 * n, inputs_, feedback_);
            servo_.tick(now_ns, inputs_, feedback_);
        }
        gap_ = gap;
        if (now_ns > link_.valid_until_ns) link_.force.setZero();
    }

    void tick(int i) {
        const double t = i * kTick;
        link_.state.position_m = hand_.encoder_m();
        if (what_.soak_seed != 0 && trouble_.step(i)) {
            ++result_.disturbances;
            if (trouble_.now == Trouble::Kind::kBack) back_ns_ += 7'000'000;
        }
        disturb(t);
        serve(i);
        physics(i, t);
        const Vec3 before = hand_.device_m();
        if (what_.sweep_m > 0)
            hand_.place(swept(t));
        else
            hand_.step(target(t), link_.force);
        note(t, hand_.device_m() - before);
    }

    void note(double t, const Vec3& moved) {
        const double force = link_.force.norm();
        result_.peak_force_n = std::max(result_.peak_force_n, force);
        result_.steepest_n_s = std::max(result_.steepest_n_s, (force - last_force_) / kTick);
        last_force_ = force;
        energy_j_ -= link_.force.dot(moved);
        result_.least_energy_j = std::min(result_.least_energy_j, energy_j_);
        const double disturbed = what_.stall_s + (what_.unplug ? kUnplugS : 0);
        if (t < kDisturbS) force_before_ = force;
        if (t > kDisturbS + disturbed && !recovered_ && force > 0.5 * force_before_ &&
            seen_silent_) {
            recovered_ = true;
            result_.recovered_s = t - kDisturbS - disturbed;
        }
        if (t >= kDisturbS && force == 0) seen_silent_ = true;
        const double along = hand_.device_m().dot(what_.direction);
        result_.position_m.push_back(static_cast<float>(along));
        result_.energy_j.push_back(static_cast<float>(energy_j_));
        result_.force_n.push_back(static_cast<float>(-link_.force.dot(what_.direction)));
        if (t < what_.seconds - kEndS) {
            energy_then_j_ = energy_j_;
            return;
        }
        low_ = std::min(low_, along);
        high_ = std::max(high_, along);
        ++counted_;
        mean_force_ += link_.force;
        mean_tissue_ += feedback_[0].force_n;
        mean_gap_ += feedback_[0].proxy.p - home_ - hand_.device_m();
    }

    void finish() {
        const double n = std::max(1, counted_);
        result_.peak_to_peak_m = high_ - low_;
        // Vectors first: the encoder's steps would only ever add to a mean of sizes.
        result_.mean_force_n = mean_force_.norm() / n;
        result_.gap_m = mean_gap_.norm() / n;
        result_.tissue_force_n = mean_tissue_.norm() / n;
        result_.drift_j_s = (energy_then_j_ - energy_j_) / kEndS;
        result_.certificate = servo_.certificate();
    }

    HapticBenchCase what_;
    HapticBenchHand hand_;
    Link link_;
    sim::ToolSpec tool_;
    TrocarSettings trocar_ = bench_trocar();
    Servo servo_;
    Vec3 home_;
    int every_ = 1;
    std::optional<HapticBenchTissue> tissue_;
    std::array<sim::ToolInput, 1> inputs_{};
    std::array<sim::ToolFeedback, 1> feedback_{};
    sim::ToolFeedback pending_;
    HapticBenchResult result_;
    Vec3 mean_force_ = Vec3::Zero(), mean_tissue_ = Vec3::Zero(), mean_gap_ = Vec3::Zero();
    double energy_j_ = 0, energy_then_j_ = 0, last_force_ = 0, force_before_ = 0;
    double low_ = 1, high_ = -1;
    int counted_ = 0;
    bool recovered_ = false, seen_silent_ = false;
    Trouble trouble_;
    int64_t back_ns_ = 0;
    bool gap_ = false;
};

}  // namespace

std::span<const HandModel> grips() noexcept { return kGrips; }

HapticBenchCase control_case(const HandModel& grip) {
    HapticBenchCase what;
    what.grip = grip;
    what.physics_hz = 250;
    what.hold_ticks = 4;
    what.seconds = 3.5;
    what.settings.stiffness_n_m = 4000;
    what.settings.damping_ns_m = what.settings.passivity_ns_m = 0;
    return what;
}

HapticBenchResult run_haptic_bench(const HapticBenchCase& what) { return Run(what).all(); }

bool calm(const HapticBenchResult& result) noexcept { return result.peak_to_peak_m < 3e-4; }

double largest_stiffness(HapticBenchCase what, const StiffnessSweep& sweep) {
    double found = 0;
    what.seconds = 3.5;
    for (double k = sweep.from_n_m; k <= sweep.to_n_m; k *= sweep.step) {
        what.settings.stiffness_n_m = k;
        if (!calm(run_haptic_bench(what))) return found;
        found = k;
    }
    return found;
}

}  // namespace placode::haptics
