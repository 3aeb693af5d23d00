// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The parts of the force law that keep a hand safe, each alone and on a given clock: own velocity
// filter, passivity observer and controller (Hannaford & Ryu 2002), motor heat, force and slew
// limits, ramps, watchdog of the tool state. `Coupling` puts them together. Servo thread only; no
// allocation, nothing throws, nobody asks the time.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "haptics/device.h"

namespace placode::haptics {

/// Limits of the force law; defaults for a desktop arm of the Touch class.
struct CouplingSettings {
    double stiffness_n_m = 300;
    double damping_ns_m = 1.5;
    double velocity_cutoff_hz = 100;
    double max_force_n = 3.0;
    double slew_n_s = 200, slew_ramping_n_s = 30;
    double ramp_s = 0.5;
    double fade_after_s = 0.010, zero_after_s = 0.050;  ///< Age of the tool state.
    double jump_m = 0.005;                              ///< Per ms; more is a fault.
    double continuous_force_n = 0.88;                   ///< Allowed rms over `thermal_window_s`.
    double thermal_window_s = 60, thermal_floor_n = 0.8;
    double motor_heat_limit = 0.8;  ///< Of what the device itself reports, 0 to 1.
    double extrapolate_s = 0.004;   ///< Longest extrapolation of the tool state by its age.
    double latency_s = 0.005;    ///< Longest latency of tool states that is made up for; 0: none.
    double recover_s = 0.1;      ///< Good ticks needed after a fault.
    double servo_gap_s = 0.005;  ///< A longer gap between ticks ramps in again.
    double start_gap_m = 0.002;  ///< No force begins while hand and tool are farther apart.
    double uneven_stiffness_n_m = 150;   ///< Ceiling of the stiffness after a gap of the servo,
    double uneven_memory_s = 600;        ///< for so long.
    double passivity_ns_m = 20;          ///< Largest damping that the passivity controller adds.
    double passivity_store_j = 0.005;    ///< Cap of the observed surplus, so that it is forgotten.
    double passivity_dead_j = 2e-5;      ///< Missing energy that is left alone: encoder noise.
    double passivity_forgiven_w = 2e-4;  ///< Missing energy that is forgiven in a second, likewise.
};

/// The same law within what a device can bear; a limit that the device does not name stays.
/// `scale`: of the trocar. It acts on motion and on force, so the device feels stiffness and
/// damping times its square.
[[nodiscard]] CouplingSettings limited_to(CouplingSettings settings, const DeviceInfo& device,
                                          double scale = 1) noexcept;

/// The defaults within the limits that a station sets.
[[nodiscard]] CouplingSettings station_limits(const Station& station);

/// Gain of a first-order low-pass over one tick. @pre dt_s >= 0.
[[nodiscard]] inline double low_pass_gain(double dt_s, double cutoff_hz) noexcept {
    assert(dt_s >= 0 && cutoff_hz >= 0);
    const double w = 2 * std::numbers::pi * cutoff_hz * dt_s;
    return w / (1 + w);
}

/// Velocity from positions; a vendor's velocity went through an unknown filter.
class VelocityFilter {
 public:
    explicit VelocityFilter(double cutoff_hz) noexcept : cutoff_hz_(cutoff_hz) {}
    void reset() noexcept { velocity_.setZero(); }
    const Vec3& update(const Vec3& moved_m, double dt_s) noexcept {
        if (dt_s > 0) velocity_ += low_pass_gain(dt_s, cutoff_hz_) * (moved_m / dt_s - velocity_);
        return velocity_;
    }
    [[nodiscard]] const Vec3& value() const noexcept { return velocity_; }  ///< [m/s]

 private:
    double cutoff_hz_;
    Vec3 velocity_ = Vec3::Zero();
};

/// Observes the energy at the port and takes back by damping what the virtual side has created.
class PassivityController {
 public:
    /// `dead_j`: missing energy that is left alone, the noise of an encoder's steps. `forgiven_w`:
    /// what of it is forgotten in a second. At rest the observed energy creeps away with every
    /// step; damping steps, whose velocity is a spike that comes late, then made a hand on a wall
    /// buzz by 0.03 mm and gave up to 3 mJ in a minute. A law that is unstable gives a hundred
    /// times as much.
    PassivityController(double max_damping_ns_m, double store_j, double dead_j = 0,
                        double forgiven_w = 0) noexcept
        : max_damping_(max_damping_ns_m),
          store_j_(store_j),
          dead_j_(dead_j),
          forgiven_w_(forgiven_w) {}
    void reset() noexcept { energy_j_ = 0; }
    /// Exact for a force held over the tick: `sent_n` acted while the hand moved by `moved_m`.
    void observe(const Vec3& sent_n, const Vec3& moved_m, double dt_s) noexcept {
        energy_j_ = std::min(energy_j_ - sent_n.dot(moved_m), store_j_);
        if (energy_j_ < 0) energy_j_ = std::min(0.0, energy_j_ + forgiven_w_ * dt_s);
        least_j_ = std::min(least_j_, energy_j_);
    }
    /// The force, damped where energy is missing. Slower than 1 mm/s is encoder noise.
    [[nodiscard]] Vec3 correct(const Vec3& force_n, const Vec3& velocity_m_s, double dt_s,
                               bool& acted) noexcept;
    [[nodiscard]] double energy_j() const noexcept { return energy_j_; }
    [[nodiscard]] double least_j() const noexcept { return least_j_; }  ///< Since construction.

 private:
    double max_damping_, store_j_, dead_j_, forgiven_w_, energy_j_ = 0, least_j_ = 0;
};

/// Heat of the motors: the ceiling falls from the rms allowance to the floor at 1.5 times of it,
/// and to the floor at once when the device says that its motors are hot.
class ThermalBudget {
 public:
    explicit ThermalBudget(const CouplingSettings& settings) noexcept : settings_(settings) {}
    void observe(const Vec3& sent_n, double dt_s) noexcept {
        const double share = std::clamp(dt_s / settings_.thermal_window_s, 0.0, 1.0);
        heat_n2_ += (sent_n.squaredNorm() - heat_n2_) * share;
    }
    [[nodiscard]] double rms_n() const noexcept { return std::sqrt(heat_n2_); }
    [[nodiscard]] double ceiling_n(double motor_heat) const noexcept;

 private:
    CouplingSettings settings_;
    double heat_n2_ = 0;
};

/// Norm and slew of the force.
class ForceLimiter {
 public:
    void reset() noexcept { last_.setZero(); }
    /// Keeps the direction when it clamps. @param saturated, slewed set when a limit acted.
    [[nodiscard]] Vec3 apply(Vec3 force_n, double ceiling_n, double slew_n_s, double dt_s,
                             bool& saturated, bool& slewed) noexcept;

 private:
    Vec3 last_ = Vec3::Zero();
};

/// Age of the tool state and what it allows.
class Watchdog {
 public:
    Watchdog(double fade_after_s, double zero_after_s) noexcept
        : fade_after_s_(fade_after_s), zero_after_s_(zero_after_s) {}
    void seen(int64_t t_ns) noexcept {
        seen_ = true;
        seen_ns_ = t_ns;
    }
    [[nodiscard]] bool ever() const noexcept { return seen_; }
    /// Never negative: a clock that went back makes nothing young.
    [[nodiscard]] double age_s(int64_t t_ns) const noexcept {
        return std::max(0.0, static_cast<double>(t_ns - seen_ns_) * 1e-9);
    }
    [[nodiscard]] bool fading(double age_s) const noexcept { return age_s > fade_after_s_; }
    [[nodiscard]] bool dead(double age_s) const noexcept { return !seen_ || age_s > zero_after_s_; }
    /// 1 while fresh, falling to 0 at the end.
    [[nodiscard]] double spring_gain(double age_s) const noexcept {
        return std::clamp((zero_after_s_ - age_s) / (zero_after_s_ - fade_after_s_), 0.0, 1.0);
    }
    /// After a jump of the clock: the state counts as seen now, and as too old.
    void clock_jumped(int64_t t_ns) noexcept {
        seen_ns_ = t_ns - static_cast<int64_t>(1e9 * 2 * zero_after_s_);
    }

 private:
    double fade_after_s_, zero_after_s_;
    bool seen_ = false;
    int64_t seen_ns_ = 0;
};

/// How old a tool state is when it arrives: a free tool stands where the hand was when the physics
/// looked, so its place is found again among the last places of the hand. A tool in contact says
/// nothing; the last finding holds.
class LatencyMeter {
 public:
    void reset() noexcept { count_ = 0; }
    /// The hand asks for `tip_m` in this tick.
    void sent(int64_t t_ns, const Vec3& tip_m) noexcept {
        tips_[count_ % kTips] = {t_ns, tip_m};
        ++count_;
    }
    /// A new tool state. A slow hand is at one place for many ticks: it tells no age.
    void seen(int64_t t_ns, const Vec3& tool_m, double hand_speed_m_s) noexcept {
        if (hand_speed_m_s < kTellingSpeedMS) return;
        for (size_t back = 1; back <= std::min(count_, kTips); ++back) {
            const Sent& one = tips_[(count_ - back) % kTips];
            if ((one.tip_m - tool_m).squaredNorm() > kSamePlaceM * kSamePlaceM) continue;
            const double found = static_cast<double>(t_ns - one.t_ns) * 1e-9;
            latency_s_ += kShare * (found - latency_s_);
            return;
        }
    }
    [[nodiscard]] double latency_s() const noexcept { return latency_s_; }

 private:
    static constexpr size_t kTips = 32;
    static constexpr double kTellingSpeedMS = 0.01;
    static constexpr double kSamePlaceM = 1e-7;  // inputs are floats: 4e-9 at 0.1 m
    static constexpr double kShare = 0.1;
    struct Sent {
        int64_t t_ns = 0;
        Vec3 tip_m = Vec3::Zero();
    };
    std::array<Sent, kTips> tips_;
    size_t count_ = 0;
    double latency_s_ = 0;
};

/// When the next tick is due. A missed period is skipped: a burst to catch up would act on one old
/// hand position.
class PeriodSchedule {
 public:
    PeriodSchedule(int64_t now_ns, int64_t period_ns) noexcept
        : period_ns_(period_ns), next_ns_(now_ns + period_ns) {}
    [[nodiscard]] int64_t next_ns() const noexcept { return next_ns_; }
    /// The tick is over at `now_ns`. Returns the number of periods that were missed.
    [[nodiscard]] uint64_t advance(int64_t now_ns) noexcept {
        next_ns_ += period_ns_;
        const int64_t late = now_ns - next_ns_;
        if (late <= 0) return 0;
        const int64_t missed = late / period_ns_ + 1;
        next_ns_ += missed * period_ns_;
        return static_cast<uint64_t>(missed);
    }

 private:
    int64_t period_ns_, next_ns_;
};

}  // namespace placode::haptics
