// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/coupling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::haptics {

namespace {

constexpr double kReleaseTimeS = 0.05;
constexpr double kMovingSpeedMS = 0.001;  // Slower is encoder noise to the passivity controller.

double low_pass_gain(double dt_s, double cutoff_hz) noexcept {
    const double w = 2 * std::numbers::pi * cutoff_hz * dt_s;
    return w / (1 + w);
}

bool finite(const sim::ToolFeedback& feedback) noexcept {
    return feedback.proxy.p.allFinite() && std::isfinite(feedback.time_s);
}

}  // namespace

Coupling::Coupling(const CouplingSettings& settings) noexcept : settings_(settings) {}

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
    if (tool_seen_ && dt > 0 && dt < 0.05) {
        const Vec3 v = (feedback.proxy.p - tool_) / dt;
        tool_velocity_ += low_pass_gain(dt, settings_.velocity_cutoff_hz) * (v - tool_velocity_);
    } else {
        tool_velocity_.setZero();
    }
    tool_ = feedback.proxy.p;
    tool_time_s_ = feedback.time_s;
    tool_ns_ = t_ns;
    tool_seen_ = true;
}

void Coupling::reanchor(const Vec3& tip_m) noexcept {
    offset_ = tool_ - tip_m;
    ramp_ = 0;
    silent_ = false;
    limited_.setZero();
    energy_j_ = 0;
}

void Coupling::go_silent() noexcept {
    silent_ = true;
    ramp_ = 0;
    limited_.setZero();
    sent_.setZero();
}

Vec3 Coupling::spring(const Vec3& tip_m, const Vec3& tip_velocity, double age_s) noexcept {
    double stiffness = settings_.stiffness_n_m;
    Vec3 twist = tool_velocity_;
    if (age_s > settings_.fade_after_s) {
        // The tool is old: its spring fades, its damper stays against a resting tool.
        const double span = settings_.zero_after_s - settings_.fade_after_s;
        stiffness *= std::clamp(1 - (age_s - settings_.fade_after_s) / span, 0.0, 1.0);
        twist.setZero();
    }
    const Vec3 tool = tool_ + std::min(age_s, settings_.extrapolate_s) * twist;
    return stiffness * (tool - tip_m - (1 - ramp_) * offset_) +
           settings_.damping_ns_m * (twist - tip_velocity);
}

// The observer is exact for a force held over the tick: the hand moved against the force that was
// really sent. Where the virtual side has created energy, damping takes it back.
Vec3 Coupling::passivity(const Vec3& force, double dt_s) noexcept {
    const double v2 = velocity_.squaredNorm();
    if (energy_j_ >= 0 || dt_s <= 0 || v2 < kMovingSpeedMS * kMovingSpeedMS) return force;
    const double damping = std::min(-energy_j_ / (dt_s * v2), settings_.passivity_ns_m);
    return force - damping * velocity_;
}

Vec3 Coupling::limit(Vec3 force, double dt_s, bool& clamped) noexcept {
    // Heat of the motors: above the allowed rms the ceiling falls, to its floor at 1.5 times.
    const double rms = std::sqrt(heat_n2_) / settings_.continuous_force_n;
    const double hot = std::clamp((rms - 1) / 0.5, 0.0, 1.0);
    const double ceiling =
        settings_.max_force_n + hot * (settings_.thermal_floor_n - settings_.max_force_n);
    const double size = force.norm();
    if (size > ceiling) {
        force *= ceiling / size;
        clamped = true;
    }
    const double slew = (ramp_ < 1 ? settings_.slew_ramping_n_s : settings_.slew_n_s) * dt_s;
    const Vec3 change = force - limited_;
    if (change.norm() > slew) force = limited_ + change * (slew / change.norm());
    limited_ = force;
    return ramp_ * release_ * force;
}

// A lost device, a number that is none, or a jump silences the hand; it has to behave for a while
// before it is believed again.
bool Coupling::trust(int64_t t_ns, const DeviceState& device, const Vec3& tip_m, double dt_s,
                     bool& fault) noexcept {
    const bool good = plausible(device, dt_s) && tip_m.allFinite();
    last_ns_ = t_ns;
    if (!good || device.status != DeviceStatus::kReady) {
        fault = distrust_s_ <= 0;  // Counted once.
        distrust_s_ = settings_.recover_s;
        if (device.position_m.allFinite()) last_position_ = device.position_m;
        if (tip_m.allFinite()) last_tip_ = tip_m;
        velocity_.setZero();
        tip_velocity_.setZero();
        return false;
    }
    const Vec3 moved = device.position_m - last_position_;
    if (seen_ && dt_s > 0) {
        const double gain = low_pass_gain(dt_s, settings_.velocity_cutoff_hz);
        velocity_ += gain * (moved / dt_s - velocity_);
        tip_velocity_ += gain * ((tip_m - last_tip_) / dt_s - tip_velocity_);
        energy_j_ = std::min(energy_j_ - sent_.dot(moved), settings_.passivity_store_j);
        heat_n2_ +=
            (sent_.squaredNorm() - heat_n2_) * std::min(1.0, dt_s / settings_.thermal_window_s);
    }
    seen_ = true;
    last_position_ = device.position_m;
    last_tip_ = tip_m;
    distrust_s_ = std::max(0.0, distrust_s_ - dt_s);
    return distrust_s_ == 0;
}

CouplingResult Coupling::tick(int64_t t_ns, const DeviceState& device, const Vec3& tip_m,
                              const sim::ToolFeedback& feedback, const Trocar& trocar) noexcept {
    CouplingResult out;
    const double dt = seen_ ? static_cast<double>(t_ns - last_ns_) * 1e-9 : 1e-3;
    follow_tool(t_ns, feedback);
    const double age = static_cast<double>(t_ns - tool_ns_) * 1e-9;
    out.stale = tool_seen_ && age > settings_.fade_after_s;

    out.trusted = trust(t_ns, device, tip_m, dt, out.fault) && device.engaged;
    // No hand, no tool yet, or a tool state too old: no force; the way back is a ramp.
    if (!out.trusted || !tool_seen_ || age > settings_.zero_after_s) {
        go_silent();
        return out;
    }
    if (silent_ || dt > settings_.servo_gap_s) reanchor(tip_m);
    ramp_ = std::min(1.0, ramp_ + dt / settings_.ramp_s);
    if (releasing_) release_ = std::max(0.0, release_ - dt / kReleaseTimeS);

    // Law in W, force to the hand by the transpose, energy check, limits.
    const Vec3 wished = trocar.device_force(spring(tip_m, tip_velocity_, age));
    sent_ = limit(passivity(wished, dt), dt, out.clamped);
    if (!sent_.allFinite()) {
        go_silent();
        distrust_s_ = settings_.recover_s;
        out.fault = true;
        out.trusted = false;
        return out;
    }
    out.force_n = sent_;
    return out;
}

}  // namespace placode::haptics
