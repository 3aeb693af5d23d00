// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The force law against a simulated operator: what must be stable is, and what must not be is seen.
#include "haptics/bench/haptic_bench.h"

#include <gtest/gtest.h>

#include <numbers>

namespace placode::haptics {
namespace THIS_TEST {

const Vec3 kDirections[] = {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, -0.8}};

// Without this nothing below proves anything.
TEST(HapticBenchRig, SeesThatTheControlCaseIsUnstable) {
    for (const HandModel& grip : grips()) {
        HapticBenchCase wild = control_case(grip);
        EXPECT_FALSE(calm(run_haptic_bench(wild))) << grip.name;
        wild.settings = {};
        wild.hold_ticks = 1;
        EXPECT_TRUE(calm(run_haptic_bench(wild)))
            << grip.name << ": the shipped law at the same rate";
    }
}

TEST(HapticBenchRig, ComesToRestOnAWallInEveryDirection) {
    for (const HandModel& grip : grips()) {
        for (const Vec3& direction : kDirections) {
            for (const bool friction : {false, true}) {
                HapticBenchCase what;
                what.grip = grip;
                what.direction = direction;
                what.friction = friction;
                const HapticBenchResult result = run_haptic_bench(what);
                EXPECT_LT(result.peak_to_peak_m, 1e-4) << grip.name << " " << direction.transpose();
                EXPECT_LE(result.peak_force_n, what.settings.max_force_n);
                EXPECT_NEAR(result.gap_m, result.mean_force_n / what.settings.stiffness_n_m,
                            0.1 * result.gap_m);
                EXPECT_GE(result.least_energy_j, -0.5e-3);
                EXPECT_LT(result.drift_j_s, 1e-4);
                // The device's own friction (0.26 N) may hold it before the wall.
                if (!friction) {
                    EXPECT_GT(result.mean_force_n, 0.05) << "there is a force to judge";
                }
                EXPECT_EQ(result.certificate.faults, 0u);
            }
        }
    }
}

TEST(HapticBenchRig, GivesNoEnergyWhileItRestsForAMinute) {
    for (const HandModel& grip : grips()) {
        HapticBenchCase what;
        what.grip = grip;
        what.seconds = 60;
        const HapticBenchResult result = run_haptic_bench(what);
        EXPECT_GE(result.least_energy_j, -0.5e-3) << grip.name;
        // Less than half a step of the encoder: nothing buzzes.
        EXPECT_LT(result.peak_to_peak_m, 27e-6) << grip.name;
        EXPECT_EQ(result.certificate.passivity, 0u) << grip.name << ": nothing to take back";
    }
}

TEST(HapticBenchRig, ComesToRestOnTheTissueSolver) {
    for (const HandModel& grip : grips()) {
        HapticBenchCase what;
        what.grip = grip;
        what.world = HapticBenchWorld::kTissue;
        what.push_m = 0.0025;
        what.seconds = 2.5;
        const HapticBenchResult result = run_haptic_bench(what);
        EXPECT_LT(result.peak_to_peak_m, 1e-4) << grip.name;
        EXPECT_GE(result.least_energy_j, -0.5e-3);
        EXPECT_LT(result.drift_j_s, 1e-4);
        // The tool rests where the tissue's force equals the grip of the tool on the gap; the hand
        // feels the stiffness of the coupling on the same gap. Both are one: it feels the tissue.
        EXPECT_GT(result.tissue_force_n, 0.05) << "the tool presses the tissue";
        // Half a step of the encoder (0.055 mm) on the spring stays open.
        EXPECT_NEAR(result.mean_force_n, result.tissue_force_n,
                    0.05 * result.tissue_force_n + 0.5 * 55e-6 * what.settings.stiffness_n_m);
        // And so the servo itself saw it, tick by tick.
        EXPECT_GT(result.certificate.compared, 50u) << grip.name;
        EXPECT_LT(static_cast<double>(result.certificate.differing),
                  0.01 * static_cast<double>(result.certificate.compared))
            << grip.name;
    }
}

TEST(HapticBenchRig, IsStableAtThreeTimesItsStiffnessOnTheTissueSolver) {
    for (const HandModel& grip : grips()) {
        HapticBenchCase what;
        what.grip = grip;
        what.world = HapticBenchWorld::kTissue;
        what.push_m = 0.0015;
        const double three = 3 * what.settings.stiffness_n_m;
        EXPECT_EQ(largest_stiffness(what, {three, three, 2}), three) << grip.name;
    }
}

TEST(HapticBenchRig, IsNearlyFreeInAir) {
    for (const HandModel& grip : grips()) {
        for (const double hz : {1000.0, 500.0, 250.0}) {
            HapticBenchCase what;
            what.grip = grip;
            what.world = HapticBenchWorld::kAir;
            what.physics_hz = hz;
            what.seconds = 4;
            const HapticBenchResult result = run_haptic_bench(what);
            EXPECT_LT(result.peak_force_n, 0.15) << grip.name << " " << hz;
            EXPECT_GE(result.least_energy_j, -0.5e-3) << grip.name << " " << hz;
            // Without it the tool state is a frame old and the hand drags it along.
            what.settings.latency_s = 0;
            if (hz < 1000) {
                EXPECT_GT(run_haptic_bench(what).peak_force_n, 0.15) << grip.name << " " << hz;
            }
        }
    }
}

TEST(HapticBenchRig, IsNearlyFreeAndPassiveWhenThePhysicsAnswersAtOnce) {
    // The latency is measured, not assumed: a tool that ran ahead of the hand would pull it along.
    for (const HandModel& grip : grips()) {
        for (const double hz : {1000.0, 500.0, 250.0}) {
            HapticBenchCase what;
            what.grip = grip;
            what.physics_hz = hz;
            what.prompt = true;
            what.world = HapticBenchWorld::kAir;
            what.seconds = 4;
            const HapticBenchResult air = run_haptic_bench(what);
            EXPECT_LT(air.peak_force_n, 0.15) << grip.name << " " << hz;
            EXPECT_GE(air.least_energy_j, -0.5e-3) << grip.name << " " << hz;
            EXPECT_LT(air.drift_j_s, 1e-4) << grip.name << " " << hz;
            what.world = HapticBenchWorld::kWall;
            what.settings.stiffness_n_m *= 3;
            EXPECT_TRUE(calm(run_haptic_bench(what))) << grip.name << " " << hz;
        }
    }
}

TEST(HapticBenchRig, IsStableAtThreeTimesItsStiffnessWithEveryGripAndRate) {
    for (const HandModel& grip : grips()) {
        for (const double hz : {1000.0, 250.0}) {
            HapticBenchCase what;
            what.grip = grip;
            what.physics_hz = hz;
            what.seconds = 3.5;
            what.settings.stiffness_n_m *= 3;
            EXPECT_TRUE(calm(run_haptic_bench(what))) << grip.name << " " << hz;
        }
    }
}

TEST(HapticBenchRig, PassesStallsAndReturnsByARamp) {
    for (const double stall : {0.020, 0.100, 0.500}) {
        HapticBenchCase what;
        what.grip = grips()[1];
        what.stall_s = stall;
        what.seconds = 4;
        const HapticBenchResult result = run_haptic_bench(what);
        EXPECT_LE(result.peak_force_n, what.settings.max_force_n);
        EXPECT_LE(result.steepest_n_s, what.settings.slew_n_s + 1e-6);
        EXPECT_TRUE(calm(result)) << stall;
        EXPECT_GE(result.least_energy_j, -0.5e-3) << stall;
        EXPECT_EQ(result.certificate.stale > 0, true);
    }
}

TEST(HapticBenchRig, GivesNoForceThroughEveryDoubtAndReturnsSlowly) {
    for (const int which : {0, 1, 2}) {
        HapticBenchCase what;
        what.grip = grips()[1];
        what.push_m = 0.0015;  // hand and tool stay within 2 mm: farther apart no force begins
        what.seconds = 4.5;
        what.nan = which == 0;
        what.teleport = which == 1;
        what.unplug = which == 2;
        const HapticBenchResult result = run_haptic_bench(what);
        EXPECT_GE(result.certificate.faults, 1u) << which;
        // Silent for the time of distrust and then on a ramp: a whole ramp would be 0.5 s.
        EXPECT_GT(result.recovered_s, 0.2) << which;
        EXPECT_LE(result.steepest_n_s, what.settings.slew_n_s + 1e-6);
        EXPECT_TRUE(calm(result)) << which;
        // A hand that went on into the wall meanwhile gets no force before it meets its tool.
        what.push_m = 0.006;
        EXPECT_EQ(run_haptic_bench(what).mean_force_n, 0) << which;
    }
}

// A machine moves the device by a sweep of 1 mm on the wall: what it feels is the spring that was
// promised, at no frequency leads the force the motion.
TEST(HapticBenchRig, RendersItsStiffnessFromHalfToFortyHertz) {
    for (const double hz : {1000.0, 250.0}) {
        HapticBenchCase what;
        what.physics_hz = hz;
        const double k = what.settings.stiffness_n_m;
        for (const HapticBenchImpedance& at : haptic_bench_impedance(what)) {
            SCOPED_TRACE(std::to_string(at.hz) + " Hz, physics " + std::to_string(hz));
            if (at.hz <= 10) {
                EXPECT_NEAR(at.stiffness_n_m, k, 0.15 * k);
            }
            // Against velocity a spring is at -90 degrees; 5 degrees are allowed.
            EXPECT_GT(at.phase_rad, -5 * std::numbers::pi / 180);
            EXPECT_LT(at.phase_rad, std::numbers::pi / 2);
        }
        // The method sees a damper that is missing, and a law that comes too late.
        what.settings.damping_ns_m = 0;
        what.settings.passivity_ns_m = 0;
        what.hold_ticks = 4;
        EXPECT_LT(haptic_bench_impedance(what).back().phase_rad, -5 * std::numbers::pi / 180);
    }
}

// Ten simulated minutes in which everything goes wrong again and again.
TEST(HapticBenchRig, KeepsItsLimitsThroughTenMinutesOfTrouble) {
    for (const HandModel& grip : grips()) {
        for (const uint64_t seed : {1, 2}) {
            HapticBenchCase what;
            what.grip = grip;
            what.soak_seed = seed;
            what.push_m = 0.004;
            what.seconds = 600;
            const HapticBenchResult result = run_haptic_bench(what);
            SCOPED_TRACE(std::string(grip.name) + " " + std::to_string(seed));
            EXPECT_GT(result.disturbances, 150);
            EXPECT_LE(result.peak_force_n, what.settings.max_force_n);
            // A tick of a burst is not 1 ms long.
            EXPECT_LE(result.steepest_n_s, 1.05 * what.settings.slew_n_s);
            EXPECT_GE(result.least_energy_j, -0.5e-3);
            EXPECT_GT(result.certificate.peak_force_n, 0.2) << "there was a force all the same";
            EXPECT_GT(result.certificate.stale, 0u);
            EXPECT_GT(result.certificate.faults, 20u);
            EXPECT_EQ(judge(result.certificate).grade, CertificateGrade::kNotApplicable);
        }
    }
}

TEST(HapticBenchRig, LowersItsForceWhenItIsHotAfterTenMinutes) {
    HapticBenchCase what;
    what.grip = grips()[0];
    what.push_m = 0.018;
    what.seconds = 600;
    const HapticBenchResult result = run_haptic_bench(what);
    EXPECT_GT(result.force_n[2000], 1.3f) << "more than the motors bear for long";
    EXPECT_GT(result.certificate.hot, 100'000u);
    EXPECT_LT(result.certificate.rms_force_n, 1.5 * what.settings.continuous_force_n);
    EXPECT_GE(result.mean_force_n, what.settings.thermal_floor_n - 0.01);
    EXPECT_LT(result.mean_force_n, 1.5 * what.settings.continuous_force_n);
    EXPECT_TRUE(calm(result)) << "a ceiling that falls does not shake the hand";
    EXPECT_GE(result.least_energy_j, -0.5e-3);
}

TEST(HapticBenchRig, GivesTheSameBitsTwice) {
    HapticBenchCase what;
    what.grip = grips()[2];
    what.seconds = 1.5;
    const HapticBenchResult a = run_haptic_bench(what), b = run_haptic_bench(what);
    EXPECT_EQ(a.force_n, b.force_n);
    EXPECT_EQ(a.position_m, b.position_m);
    what.world = HapticBenchWorld::kTissue;
    what.seconds = 0.9;
    EXPECT_EQ(run_haptic_bench(what).force_n, run_haptic_bench(what).force_n);
}

TEST(HapticBenchRig, RefusesARateThatDoesNotDivide) {
    HapticBenchCase what;
    what.physics_hz = 300;
    EXPECT_THROW((void)run_haptic_bench(what), std::invalid_argument);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
