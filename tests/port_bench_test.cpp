// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The force law against a simulated operator: what must be stable is, and what must not be is seen.
#include "haptics/port_bench.h"

#include <gtest/gtest.h>

namespace placode::haptics {
namespace {

const Vec3 kDirections[] = {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, -0.8}};

// Without this nothing below proves anything.
TEST(PortBench, SeesThatTheControlCaseIsUnstable) {
    for (const Grip& grip : grips()) {
        PortCase wild;
        wild.grip = grip;
        wild.physics_hz = 250;
        wild.hold_ticks = 4;
        wild.seconds = 3.5;
        wild.settings.stiffness_n_m = 4000;
        wild.settings.damping_ns_m = wild.settings.passivity_ns_m = 0;
        EXPECT_FALSE(calm(run_port(wild))) << grip.name;
        wild.settings = {};
        wild.hold_ticks = 1;
        EXPECT_TRUE(calm(run_port(wild))) << grip.name << ": the shipped law at the same rate";
    }
}

TEST(PortBench, ComesToRestOnAWallInEveryDirection) {
    for (const Grip& grip : grips()) {
        for (const Vec3& direction : kDirections) {
            for (const bool friction : {false, true}) {
                PortCase what;
                what.grip = grip;
                what.direction = direction;
                what.friction = friction;
                const PortResult result = run_port(what);
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

TEST(PortBench, ComesToRestOnTheTissueSolver) {
    for (const Grip& grip : grips()) {
        PortCase what;
        what.grip = grip;
        what.world = PortWorld::kTissue;
        what.push_m = 0.0015;
        what.seconds = 2.2;
        const PortResult result = run_port(what);
        EXPECT_LT(result.peak_to_peak_m, 1e-4) << grip.name;
        EXPECT_GE(result.least_energy_j, -0.5e-3);
        EXPECT_LT(result.drift_j_s, 1e-4);
        // The tool rests where the tissue's force equals the grip of the tool (600 N/m) on the gap;
        // the hand feels the stiffness of the coupling (300 N/m) on the same gap: half of it.
        EXPECT_GT(result.tissue_force_n, 0.05) << "the tool presses the tissue";
        const double scale = what.settings.stiffness_n_m / sim::ToolSpec{}.grip_n_m;
        EXPECT_NEAR(result.mean_force_n, scale * result.tissue_force_n,
                    0.05 * result.tissue_force_n);
    }
}

TEST(PortBench, IsNearlyFreeInAir) {
    // At 1000 Hz, the rate of attempts; slower physics drags more, the bench says how much.
    PortCase what;
    what.grip = grips()[1];
    what.world = PortWorld::kAir;
    what.seconds = 2;
    EXPECT_LT(run_port(what).peak_force_n, 0.15);
}

TEST(PortBench, IsStableAtThreeTimesItsStiffnessWithEveryGripAndRate) {
    for (const Grip& grip : grips()) {
        for (const double hz : {1000.0, 250.0}) {
            PortCase what;
            what.grip = grip;
            what.physics_hz = hz;
            what.seconds = 3.5;
            what.settings.stiffness_n_m *= 3;
            EXPECT_TRUE(calm(run_port(what))) << grip.name << " " << hz;
        }
    }
}

TEST(PortBench, PassesStallsAndReturnsByARamp) {
    for (const double stall : {0.020, 0.100, 0.500}) {
        PortCase what;
        what.grip = grips()[1];
        what.stall_s = stall;
        what.seconds = 4;
        const PortResult result = run_port(what);
        EXPECT_LE(result.peak_force_n, what.settings.max_force_n);
        EXPECT_LE(result.steepest_n_s, what.settings.slew_n_s + 1e-6);
        EXPECT_TRUE(calm(result)) << stall;
        EXPECT_GE(result.least_energy_j, -0.5e-3) << stall;
        EXPECT_EQ(result.certificate.stale > 0, true);
    }
}

TEST(PortBench, GivesNoForceThroughEveryDoubtAndReturnsSlowly) {
    for (const int which : {0, 1, 2}) {
        PortCase what;
        what.grip = grips()[1];
        what.push_m = 0.0015;  // hand and tool stay within 2 mm: farther apart no force begins
        what.seconds = 4.5;
        what.nan = which == 0;
        what.teleport = which == 1;
        what.unplug = which == 2;
        const PortResult result = run_port(what);
        EXPECT_GE(result.certificate.faults, 1u) << which;
        // Silent for the time of distrust and then on a ramp: a whole ramp would be 0.5 s.
        EXPECT_GT(result.recovered_s, 0.2) << which;
        EXPECT_LE(result.steepest_n_s, what.settings.slew_n_s + 1e-6);
        EXPECT_TRUE(calm(result)) << which;
        // A hand that went on into the wall meanwhile gets no force before it meets its tool.
        what.push_m = 0.006;
        EXPECT_EQ(run_port(what).mean_force_n, 0) << which;
    }
}

TEST(PortBench, GivesTheSameBitsTwice) {
    PortCase what;
    what.grip = grips()[2];
    what.seconds = 1.5;
    const PortResult a = run_port(what), b = run_port(what);
    EXPECT_EQ(a.force_n, b.force_n);
    EXPECT_EQ(a.position_m, b.position_m);
    what.world = PortWorld::kTissue;
    what.seconds = 0.9;
    EXPECT_EQ(run_port(what).force_n, run_port(what).force_n);
}

TEST(PortBench, RefusesARateThatDoesNotDivide) {
    PortCase what;
    what.physics_hz = 300;
    EXPECT_THROW((void)run_port(what), std::invalid_argument);
}

}  // namespace
}  // namespace placode::haptics
