// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/coupling.h"

#include <algorithm>
#include <cmath>

namespace placode::haptics {

namespace {

constexpr double kReleaseTimeS = 0.05;
constexpr double kLeftLagS = 0.001;
// Cross-check with the solver: from this force on, below this speed, within this share and half a
// step of a usual encoder.
constexpr double kCheckedN = 0.05, kAtRestMS = 0.001, kCheckedShare = 0.05, kHalfStepM = 28e-6;

bool finite(const sim::ToolFeedback& feedback) noexcept {
    return feedback.proxy.p.allFinite() && std::isfinite(feedback.time_s);
}

}  // namespace

Coupling::Coupling(const CouplingSettings& settings) noexcept
    : settings_(settings),
      velocity_(settings.velocity_cutoff_hz),
      tip_velocity_(settings.velocity_cutoff_hz),
      watchdog_(settings.fade_after_s, settings.zero_after_s),
      tool_velocity_(settings.velocity_cutoff_hz),
      passivity_(settings.passivity_ns_m, settings.passivity_store_j, settings.passivity_dead_j,
                 settings.passivity_forgiven_w),
      heat_(settings) {}

bool Coupling::plausible(const DeviceState& device, double dt_s) const noexcept {
    if (!device.position_m.allFinite() || !std::isfinite(device.roll_rad)) return false;
    if (!seen_) return true;
    // A late tick may have moved further, but not without limit.
    const double allowed = settings_.jump_m * std::clamp(dt_s / 1e-3, 1.0, 10.0);
    return (device.position_m - last_position_).norm() <= allowed;
}

// Takes a new tool state over, with its age and velocity. The twist is extrapolated for a few
// milliseconds only.
void Coupling::follow_tool(int64_t t_ns, const sim::ToolFeedback& feedback) noexcept {
    // Time 0 is the default value: no tool state yet.
    if (!finite(feedback) || feedback.time_s <= 0 || feedback.time_s == tool_time_s_) return;
    const double dt = feedback.time_s - tool_time_s_;
    if (watchdog_.ever() && dt > 0 && dt < 0.05)
        tool_velocity_.update(feedback.proxy.p - tool_, dt);
    else
        tool_velocity_.reset();
    latency_.seen(t_ns, feedback.proxy.p, tip_velocity_.value().norm());
    tool_ = feedback.proxy.p;
    tool_time_s_ = feedback.time_s;
    watchdog_.seen(t_ns);
}

void Coupling::reanchor(const Vec3& tip_m) noexcept {
    offset_ = tool_ - tip_m;
    ramp_ = 0;
    silent_ = false;
    apart_ = false;
    limiter_.reset();
    passivity_.reset();
}

void Coupling::go_silent() noexcept {
    silent_ = true;
    ramp_ = 0;
    limiter_.reset();
    sent_.setZero();
}

// A clock that goes back says nothing about ages: everything starts again from here, by a ramp.
void Coupling::clock_jumped(int64_t t_ns) noexcept {
    go_silent();
    velocity_.reset();
    tip_velocity_.reset();
    if (watchdog_.ever()) watchdog_.clock_jumped(t_ns);
    latency_.reset();
    uneven_s_ = settings_.uneven_memory_s;
}

Vec3 Coupling::spring(const Vec3& tip_m, const Vec3& tip_velocity, double age_s) noexcept {
    double stiffness = settings_.stiffness_n_m;
    if (uneven_s_ > 0) stiffness = std::min(stiffness, settings_.uneven_stiffness_n_m);
    Vec3 twist = tool_velocity_.value();
    if (watchdog_.fading(age_s)) {
        // The tool is old: its spring fades, its damper stays against a resting tool.
        stiffness *= watchdog_.spring_gain(age_s);
        twist.setZero();
    }
    // A state answers to a hand of the past: it has an age already when it arrives. Without this
    // the free tool lags, and at 250 Hz a hand of 0.1 m/s drags 0.25 N through air. One tick of
    // the lag is left: a tool without any would give back as much energy as it takes, and the
    // passivity controller would answer to the encoder's steps.
    const double ahead = std::min(age_s, settings_.extrapolate_s) +
                         std::clamp(latency_.latency_s() - kLeftLagS, 0.0, settings_.latency_s);
    const Vec3 tool = tool_ + ahead * twist;
    return stiffness * (tool - tip_m - (1 - ramp_) * offset_) +
           settings_.damping_ns_m * (twist - tip_velocity);
}

// The tool rests where the tissue's force and its holder's, which is as stiff as this spring, are
// equal: then the hand feels what the solver says of the tissue, the mean of its multipliers over
// the substeps of the frame. Otherwise one of both is wrong, and what is scored is not what is
// felt.
void Coupling::compare(const Vec3& tip_m, const Vec3& solver_n,
                       CouplingResult& out) const noexcept {
    const bool at_rest = ramp_ >= 1 && release_ >= 1 && uneven_s_ <= 0 && !out.stale &&
                         tip_velocity_.value().norm() < kAtRestMS &&
                         tool_velocity_.value().norm() < kAtRestMS && solver_n.allFinite();
    const Vec3 felt = settings_.stiffness_n_m * (tool_ - tip_m);
    const double size = std::max(felt.norm(), solver_n.norm());
    out.compared = at_rest && size >= kCheckedN;
    out.differing = out.compared && (felt - solver_n).norm() >
                                        kCheckedShare * size + kHalfStepM * settings_.stiffness_n_m;
}

Vec3 Coupling::limit(const Vec3& force, float motor_heat, double dt_s,
                     CouplingResult& out) noexcept {
    const double ceiling = heat_.ceiling_n(static_cast<double>(motor_heat));
    out.hot = ceiling < settings_.max_force_n;
    const double slew = ramp_ < 1 ? settings_.slew_ramping_n_s : settings_.slew_n_s;
    return ramp_ * release_ * limiter_.apply(force, ceiling, slew, dt_s, out.clamped, out.slewed);
}

// A lost device, a number that is none, or a jump silences the hand; it has to behave for a while
// before it is believed again.
bool Coupling::trust(int64_t t_ns, const DeviceState& device, const Vec3& tip_m, double dt_s,
                     bool& fault) noexcept {
    if (!device.engaged && device.status == DeviceStatus::kReady && device.position_m.allFinite() &&
        tip_m.allFinite()) {
        // A hand that is off may go where it likes; that is no fault.
        last_position_ = device.position_m;
        last_tip_ = tip_m;
        velocity_.reset();
        tip_velocity_.reset();
        return false;
    }
    const bool good = plausible(device, dt_s) && tip_m.allFinite();
    if (!good || device.status != DeviceStatus::kReady) {
        fault = distrust_s_ <= 0;  // Counted once.
        distrust_s_ = settings_.recover_s;
        apart_ = true;
        if (device.position_m.allFinite()) last_position_ = device.position_m;
        if (tip_m.allFinite()) last_tip_ = tip_m;
        velocity_.reset();
        tip_velocity_.reset();
        return false;
    }
    const Vec3 moved = device.position_m - last_position_;
    if (seen_ && dt_s > 0) {
        velocity_.update(moved, dt_s);
        tip_velocity_.update(tip_m - last_tip_, dt_s);
        passivity_.observe(sent_, moved, dt_s);
        heat_.observe(sent_, dt_s);
    }
    seen_ = true;
    last_position_ = device.position_m;
    last_tip_ = tip_m;
    latency_.sent(t_ns, tip_m);
    distrust_s_ = std::max(0.0, distrust_s_ - std::max(0.0, dt_s));
    return distrust_s_ == 0;
}

CouplingResult Coupling::tick(int64_t t_ns, const DeviceState& device, const Vec3& tip_m,
                              const sim::ToolFeedback& feedback, const Trocar& trocar) noexcept {
    CouplingResult out;
    double dt = seen_ ? static_cast<double>(t_ns - last_ns_) * 1e-9 : 1e-3;
    last_ns_ = t_ns;
    if (dt < 0) {
        clock_jumped(t_ns);
        dt = 0;
    }
    follow_tool(t_ns, feedback);
    const double age = watchdog_.ever() ? watchdog_.age_s(t_ns) : 0;
    out.tool_age_s = age;
    out.stale = watchdog_.ever() && watchdog_.fading(age);

    out.trusted = trust(t_ns, device, tip_m, dt, out.fault);
    // Behind a tool state that is too old the hand may have gone anywhere.
    if (!out.trusted || watchdog_.dead(age)) apart_ = true;
    // No hand, no tool yet, or a tool state too old: no force; the way back is a ramp. A clutch
    // holds the tool and lets the hand go.
    if (!out.trusted || device.clutched || watchdog_.dead(age)) {
        go_silent();
        out.silent = true;
        return out;
    }
    const bool gap = dt > settings_.servo_gap_s;
    uneven_s_ = gap ? settings_.uneven_memory_s : std::max(0.0, uneven_s_ - dt);
    if (gap) {  // Likewise behind a gap of the servo.
        go_silent();
        apart_ = true;
    }
    // A hand that comes back elsewhere gets no force before tool and hand have met: a ramp from
    // where it is would push it in air, while its tool runs after it.
    if (silent_ && apart_ && (tool_ - tip_m).norm() > settings_.start_gap_m) {
        out.silent = true;
        return out;
    }
    if (silent_) reanchor(tip_m);
    ramp_ = std::min(1.0, ramp_ + dt / settings_.ramp_s);
    if (releasing_) release_ = std::max(0.0, release_ - dt / kReleaseTimeS);

    // Law in W, force to the hand by the transpose, energy check, limits.
    const Vec3 wished = trocar.device_force(spring(tip_m, tip_velocity_.value(), age));
    const Vec3 damped = passivity_.correct(wished, velocity_.value(), dt, out.passive);
    sent_ = limit(damped, device.motor_heat, dt, out);
    compare(tip_m, feedback.force_n, out);
    if (!sent_.allFinite()) {
        go_silent();
        distrust_s_ = settings_.recover_s;
        apart_ = true;
        out.fault = true;
        out.trusted = false;
        out.silent = true;
        return out;
    }
    out.force_n = sent_;
    return out;
}

}  // namespace placode::haptics
