// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The haptic port on the bench, without a device: an arm, a grip and the mechanics of a desktop arm
// hold the real servo (trocar, coupling, limits) against walls, air, and the tissue solver, on a
// fake clock. Arm: 0.554 kg, 6.45 N s/m, 135 N/m (one subject's fit, Sci Rep 5, 18004, fig. 3); the
// device: 45 g, 0.1 N s/m, encoder of 0.055 mm, the force held for a tick. Not in the model:
// bending of the device, cables and gears, the amplifier's lag, rotation; on hardware an eighth to
// a quarter of the stiffness found here is to be expected.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/servo.h"

namespace placode::haptics {

/// How fingers hold the stylus: a spring and a damper between arm and device.
struct HandModel {
    std::string_view name;
    double stiffness_n_m = 150, damping_ns_m = 0.5;
};
[[nodiscard]] std::span<const HandModel> grips() noexcept;  ///< Firm, light, fingertip.

enum class HapticBenchWorld : uint8_t {
    kWall,    ///< Rigid plane through the tool's home.
    kTissue,  ///< Block of soft tissue under the tool, simulated by the solver.
    kAir,     ///< Nothing: the tool is where the hand was.
};

struct HapticBenchCase {
    HandModel grip;
    HapticBenchWorld world = HapticBenchWorld::kWall;
    double physics_hz = 1000;         ///< Divides 1000.
    Vec3 direction = Vec3(0, 0, -1);  ///< Unit, in W: the way that the hand pushes.
    double push_m = 0.003;            ///< How far the hand wants to go behind the surface.
    double seconds = 3;
    CouplingSettings settings;
    int hold_ticks = 1;      ///< The law runs every so many ticks and its force is held between.
    double speed_m_s = 0.1;  ///< In air: peak speed of the hand's to and fro.
    bool friction = false;   ///< Coulomb friction of the device, 0.26 N.
    double youngs_modulus_pa = 60e3;  ///< Of the tissue.
    bool prompt = false;              ///< The physics answers at once, not at its next frame.
    // Disturbances, at 2 s: the physics stands still for so long, a tick is not a number, the hand
    // jumps, the device is unplugged for 0.1 s.
    double stall_s = 0;
    bool nan = false, teleport = false, unplug = false;
    /// Not 0: the hand goes in and out of the surface, and every second or so one of these comes,
    /// drawn with this seed: physics that stands still for 5, 50 or 500 ms, a servo that misses up
    /// to 60 ticks and then ticks four times in a burst, a clock that jumps back, no number, a
    /// jump of the hand, an unplugged device.
    uint64_t soak_seed = 0;
    /// Not 0: no arm; the device itself is moved by a sweep of this amplitude from 0.5 to 50 Hz,
    /// half as much again behind the surface.
    double sweep_m = 0;
};

/// The test of the test: a bare spring of 4 kN/m, held for 4 ms over a physics of 250 Hz, that must
/// buzz. If it does not, nothing here proves anything.
[[nodiscard]] HapticBenchCase control_case(const HandModel& grip);

struct HapticBenchResult {
    double peak_to_peak_m = 0;  ///< Of the device, in the last half second, along the push.
    double peak_force_n = 0;    ///< Of the whole run.
    double mean_force_n = 0;    ///< At the device, in the last half second.
    double gap_m = 0;           ///< From device to tool there, mean.
    double tissue_force_n = 0;  ///< On the tool, as the solver says, mean there.
    double least_energy_j = 0;  ///< Lowest energy that went into the port up to a time.
    double drift_j_s = 0;       ///< Energy given by the port per second at the end; + = created.
    double steepest_n_s = 0;    ///< Fastest rise of the force within a tick (falls are allowed).
    int disturbances = 0;       ///< Of a soak.
    double recovered_s = 0;     ///< From the end of the disturbance to half of the force before.
    HapticCertificate certificate;
    std::vector<float> position_m, force_n;  ///< Along the push, every tick.
    std::vector<float> energy_j;             ///< That went into the port so far, every tick.
};

/// Runs one case. Deterministic: the same case gives the same bits. Throws std::invalid_argument
/// for a rate that does not divide 1000.
[[nodiscard]] HapticBenchResult run_haptic_bench(const HapticBenchCase& what);

/// What the port is at one frequency: force by displacement.
struct HapticBenchImpedance {
    double hz = 0;
    double stiffness_n_m = 0;  ///< Size of force by displacement.
    double phase_rad = 0;      ///< 0 a spring, pi/2 a damper; negative: energy is given.
};
/// From a sweep against the wall (`sweep_m`), at 0.7 to 40 Hz.
[[nodiscard]] std::vector<HapticBenchImpedance> haptic_bench_impedance(HapticBenchCase what);

/// True when the device comes to rest: less than 0.3 mm from peak to peak after three seconds.
[[nodiscard]] bool calm(const HapticBenchResult& result) noexcept;

/// Stiffnesses that are tried, each `step` times the one before.
struct StiffnessSweep {
    double from_n_m = 50, to_n_m = 6000, step = 1.15;
};
/// Largest stiffness up to which every push into wall or tissue comes to rest; 0: not one.
[[nodiscard]] double largest_stiffness(HapticBenchCase what, const StiffnessSweep& sweep = {});

}  // namespace placode::haptics
