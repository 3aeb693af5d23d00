// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Force law and its safety, with a fake clock.
#include "haptics/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placode::haptics {
namespace THIS_TEST {

constexpr int64_t kMs = 1'000'000;

// A tip-mapped hand whose device axes are the world's: force in D equals force in W.
struct Bench {
    explicit Bench(const CouplingSettings& s = {}) : settings(s), coupling(s), trocar(tool, map()) {
        feedback.proxy.p = home;
    }
    static TrocarSettings map() {
        TrocarSettings settings;
        settings.mapping = Mapping::kTip;
        return settings;
    }
    // One millisecond with the hand at `x` from home; `publish`: the physics sends a new state.
    CouplingResult tick(const Vec3& x, bool publish = true, int64_t step_ns = kMs) {
        t_ns += step_ns;
        if (publish) feedback.time_s = static_cast<double>(t_ns) * 1e-9;
        state.position_m = x;
        const sim::Pose tip = trocar.tip_pose(state);
        return coupling.tick(t_ns, state, tip.p, feedback, trocar);
    }
    CouplingResult ticks(int n, const Vec3& x) {
        CouplingResult last;
        for (int i = 0; i < n; ++i) last = tick(x);
        return last;
    }

    CouplingSettings settings;
    sim::ToolSpec tool;
    Vec3 home = TrocarSettings{}.home_tip_m;
    Coupling coupling;
    Trocar trocar;
    DeviceState state;
    sim::ToolFeedback feedback;
    int64_t t_ns = 0;
};

// Pushes the hand 2 mm below a tool that stays, slowly, after the start ramp.
Bench pressed(double depth_m = 0.002) {
    Bench bench;
    bench.ticks(700, Vec3::Zero());
    for (int i = 1; i <= 200; ++i) bench.tick(Vec3(0, 0, -depth_m * i / 200));
    bench.ticks(300, Vec3(0, 0, -depth_m));
    return bench;
}

// Near enough to its tool for a force to begin anew.
const Vec3 kNear(0, 0, -0.0015);

TEST(Coupling, PullsTheHandToTheToolWithItsStiffness) {
    Bench bench = pressed();
    const CouplingResult result = bench.tick(Vec3(0, 0, -0.002));
    EXPECT_TRUE(result.trusted);
    // At rest only the spring acts: 300 N/m x 2 mm.
    EXPECT_NEAR(result.force_n.z(), 0.6, 1e-3);
    EXPECT_NEAR(result.force_n.head<2>().norm(), 0, 1e-6);
}

// The force of the tissue is known twice: from the spring that the hand feels, and from the
// solver's multipliers, averaged over substeps.
TEST(Coupling, HoldsItsForceAgainstTheSolversAtRest) {
    const double right = 300 * 0.002;
    for (const double told : {right, 1.04 * right, 0.9 * right, 1.1 * right, 0.0, -right}) {
        Bench bench = pressed();
        bench.feedback.force_n = Vec3(0, 0, told);
        const CouplingResult result = bench.tick(Vec3(0, 0, -0.002));
        EXPECT_TRUE(result.compared) << told;
        // 5 %, and half a step of an encoder on the spring.
        EXPECT_EQ(result.differing, std::abs(told - right) > 0.05 * right + 0.0085) << told;
    }
    Bench bench = pressed();
    bench.feedback.force_n = Vec3(0, 0, right);
    EXPECT_FALSE(bench.tick(Vec3(0, 0, -0.0025)).compared) << "a hand that moves";
    bench = pressed();
    bench.feedback.force_n = Vec3(0, 0, right);
    for (int i = 0; i < 20; ++i) bench.tick(Vec3(0, 0, -0.002), false);
    EXPECT_FALSE(bench.tick(Vec3(0, 0, -0.002), false).compared) << "an old tool state";
    bench = Bench();
    bench.ticks(700, Vec3::Zero());
    EXPECT_FALSE(bench.tick(Vec3::Zero()).compared) << "nothing is felt";
    bench = pressed();
    bench.feedback.force_n.x() = std::nan("");
    EXPECT_FALSE(bench.tick(Vec3(0, 0, -0.002)).compared);
}

TEST(Coupling, StartsWithoutForceWhereverTheToolIs) {
    Bench bench;
    bench.feedback.proxy.p = bench.home + Vec3(0, 0, 0.0019);
    EXPECT_LT(bench.tick(Vec3::Zero()).force_n.norm(), 1e-4);
    double before = 0;
    for (int i = 0; i < 499; ++i) {
        const double now = bench.tick(Vec3::Zero()).force_n.norm();
        EXPECT_LE(std::abs(now - before), 0.03 + 1e-9) << "slew while ramping, 30 N/s";
        before = now;
    }
    EXPECT_NEAR(bench.ticks(50, Vec3::Zero()).force_n.z(), 300 * 0.0019, 0.02);
}

TEST(Coupling, GivesNoForceBeforeHandAndToolHaveMet) {
    Bench bench;
    bench.feedback.proxy.p = bench.home + Vec3(0, 0, 0.004);
    for (int i = 0; i < 200; ++i) {
        const auto result = bench.tick(Vec3::Zero());
        EXPECT_EQ(result.force_n, Vec3::Zero());
        EXPECT_TRUE(result.silent);
        EXPECT_TRUE(result.trusted) << "the tool may come to the hand";
    }
    bench.feedback.proxy.p = bench.home + Vec3(0, 0, 0.001);
    EXPECT_NEAR(bench.ticks(700, Vec3::Zero()).force_n.z(), 0.3, 0.01);
}

TEST(Coupling, LetsAClutchedHandGoAndComesBackByARamp) {
    Bench bench = pressed();
    bench.state.clutched = true;
    for (int i = 0; i < 20; ++i) {
        const auto result = bench.tick(Vec3(0, 0, -0.002));
        EXPECT_EQ(result.force_n, Vec3::Zero());
        EXPECT_TRUE(result.trusted) << "the tool is held";
    }
    bench.state.clutched = false;
    EXPECT_LT(bench.tick(Vec3(0, 0, -0.002)).force_n.norm(), 0.01);
    EXPECT_NEAR(bench.ticks(700, Vec3(0, 0, -0.002)).force_n.z(), 0.6, 0.01);
}

TEST(Coupling, CallsAHandThatIsOffNoFaultWhereverItGoes) {
    Bench bench = pressed();
    bench.state.engaged = false;
    EXPECT_FALSE(bench.tick(Vec3(0, 0, -0.002)).fault);
    EXPECT_FALSE(bench.tick(Vec3(0.08, 0, 0)).fault);
    bench.state.engaged = true;
    EXPECT_TRUE(bench.tick(Vec3(0.08, 0, 0)).trusted);
    EXPECT_EQ(bench.tick(Vec3(0.08, 0, 0)).force_n, Vec3::Zero()) << "far from its tool";
}

TEST(Coupling, GivesNoForceToAnArmThatIsNotCalibrated) {
    Bench bench = pressed();
    bench.state.status = DeviceStatus::kNotCalibrated;
    const auto result = bench.tick(Vec3(0, 0, -0.002));
    EXPECT_EQ(result.force_n, Vec3::Zero());
    EXPECT_FALSE(result.trusted);
}

TEST(Coupling, LowersTheCeilingWhenTheDeviceSaysItsMotorsAreHot) {
    Bench bench = pressed();
    for (int i = 0; i < 100; ++i) bench.tick(Vec3(0, 0, -0.002 - 0.0001 * i));
    EXPECT_NEAR(bench.tick(Vec3(0, 0, -0.0119)).force_n.norm(), 3.0, 0.01);
    bench.state.motor_heat = 0.85f;
    const auto result = bench.ticks(50, Vec3(0, 0, -0.0119));
    EXPECT_TRUE(result.hot);
    EXPECT_NEAR(result.force_n.norm(), bench.settings.thermal_floor_n, 1e-6);
}

// Clock jumps: whatever the clock does, the force stays in its limits and begins by a ramp.
TEST(Coupling, StartsAgainByARampWhenTheClockGoesBack) {
    Bench bench = pressed(0.0015);
    bench.state.position_m = kNear;
    const auto back = bench.tick(kNear, false, -500 * kMs);
    EXPECT_EQ(back.force_n, Vec3::Zero());
    double before = 0;
    for (int i = 0; i < 700; ++i) {
        const auto result = bench.tick(kNear);
        EXPECT_LE(result.force_n.norm() - before, 0.03 + 1e-9);
        before = result.force_n.norm();
    }
    EXPECT_NEAR(before, 150 * 0.0015, 0.01) << "softer for ten minutes: the loop is not even";
}

TEST(Coupling, IsSilentWhenTheClockJumpsAheadPastTheWatchdog) {
    Bench bench = pressed();
    const auto ahead = bench.tick(Vec3(0, 0, -0.002), false, 10'000 * kMs);
    EXPECT_EQ(ahead.force_n, Vec3::Zero());
    EXPECT_TRUE(ahead.stale);
}

TEST(Coupling, BearsABurstOfTicks) {
    Bench bench = pressed();
    const double before = bench.tick(Vec3(0, 0, -0.002)).force_n.z();
    for (int i = 0; i < 500; ++i) {
        const auto result = bench.tick(Vec3(0, 0, -0.002), true, i % 3 == 0 ? 0 : 1000);
        EXPECT_NEAR(result.force_n.z(), before, 1e-3);
    }
    EXPECT_NEAR(bench.tick(Vec3(0, 0, -0.002)).force_n.z(), before, 1e-3);
}

TEST(Coupling, IsSofterAfterAGapOfTheServo) {
    Bench bench = pressed(0.0015);
    bench.tick(kNear, true, 20 * kMs);
    EXPECT_NEAR(bench.ticks(700, kNear).force_n.z(), 150 * 0.0015, 0.01);
    for (int i = 0; i < 600'000; ++i) bench.tick(kNear);
    EXPECT_NEAR(bench.tick(kNear).force_n.z(), 300 * 0.0015, 0.01) << "ten even minutes later";
}

TEST(Coupling, GivesNoForceBeforeThereIsAToolState) {
    Bench bench;
    for (int i = 0; i < 100; ++i) {
        const auto result = bench.tick(Vec3(0, 0, -0.00002 * i), false);
        EXPECT_EQ(result.force_n, Vec3::Zero());
        EXPECT_TRUE(result.trusted) << "the hand may move the tool all the same";
    }
}

TEST(Coupling, IsNearlyFreeInFreeMotion) {
    Bench bench;
    double peak = 0;
    for (int i = 0; i < 2000; ++i) {
        const double w = 2 * std::numbers::pi * 2;  // 8 mm at 2 Hz: 0.1 m/s
        const Vec3 x(0.008 * std::sin(w * i * 1e-3), 0, 0);
        // The free tool is where the hand was one tick ago.
        bench.feedback.proxy.p = bench.home + bench.state.position_m;
        peak = std::max(peak, bench.tick(x).force_n.norm());
    }
    EXPECT_LT(peak, 0.15);
}

TEST(Coupling, NeverExceedsTheForceAndSlewLimits) {
    Bench bench = pressed();
    double before = bench.tick(Vec3(0, 0, -0.002)).force_n.norm(), peak = 0;
    bool clamped = false;
    for (int i = 0; i < 400; ++i) {
        const auto result = bench.tick(Vec3(0, 0, -0.002 - 0.0002 * std::min(i, 100)));
        const double now = result.force_n.norm();
        EXPECT_LE(now - before, 0.2 + 1e-9) << "200 N/s";
        EXPECT_LE(now, bench.settings.max_force_n + 1e-9);
        clamped |= result.clamped;
        peak = std::max(peak, now);
        before = now;
    }
    EXPECT_TRUE(clamped);
    EXPECT_NEAR(peak, bench.settings.max_force_n, 1e-6);
}

TEST(Coupling, LowersTheCeilingOfHotMotors) {
    Bench bench = pressed();
    for (int i = 0; i < 100; ++i) bench.tick(Vec3(0, 0, -0.002 - 0.0001 * i));
    double force = 0;
    for (int i = 0; i < 60'000; ++i) force = bench.tick(Vec3(0, 0, -0.0119)).force_n.norm();
    // The ceiling F(rms) falls from 3 N at 0.88 N to 0.8 N at 1.32 N and settles where F = rms:
    // F = 3 - 2.2 (F/0.88 - 1)/0.5 gives F = 7.4/6 = 1.233 N. One time constant is not yet there.
    EXPECT_LT(force, 1.5);
    EXPECT_GT(force, 1.1);
}

// Age of the tool state: 5 ms unchanged, 10..50 ms fading, then nothing.
TEST(Coupling, KeepsTheForceThroughAStallOfFiveMilliseconds) {
    Bench bench = pressed();
    const double before = bench.tick(Vec3(0, 0, -0.002)).force_n.z();
    for (int i = 0; i < 5; ++i) {
        const auto result = bench.tick(Vec3(0, 0, -0.002), false);
        EXPECT_NEAR(result.force_n.z(), before, 1e-3);
        EXPECT_FALSE(result.stale);
    }
}

TEST(Coupling, FadesTheForceThroughAStallOfFiftyMilliseconds) {
    Bench bench = pressed();
    double before = bench.tick(Vec3(0, 0, -0.002)).force_n.z();
    for (int i = 1; i <= 50; ++i) {
        const double now = bench.tick(Vec3(0, 0, -0.002), false).force_n.z();
        EXPECT_LE(now, before + 1e-3) << i << " ms";
        if (i == 30) {
            EXPECT_NEAR(now, 0.3, 0.02) << "half of the fade";
        }
        before = now;
    }
    EXPECT_LT(before, 0.02);
}

TEST(Coupling, IsSilentInAStallOfHalfASecondAndComesBackByARamp) {
    Bench bench = pressed(0.0015);
    for (int i = 1; i <= 500; ++i) {
        const auto result = bench.tick(kNear, false);
        if (i > 50) {
            EXPECT_EQ(result.force_n, Vec3::Zero()) << i << " ms";
        }
        EXPECT_EQ(result.stale, i > 10);
    }
    double before = 0;
    for (int i = 0; i < 600; ++i) {
        const double now = bench.tick(kNear).force_n.norm();
        EXPECT_LE(now - before, 0.03 + 1e-9);
        before = now;
    }
    EXPECT_NEAR(before, 300 * 0.0015, 0.01);
}

TEST(Coupling, RampsInAgainAfterAGapOfTheServo) {
    Bench bench = pressed(0.0015);
    EXPECT_LT(bench.tick(kNear, true, 20 * kMs).force_n.norm(), 0.01);
}

// Behind a pause, a stall or a gap the hand is somewhere else, and its tool runs after it: a force
// that began at once would push the hand in free air by the way that it went meanwhile.
TEST(Coupling, DoesNotPushAHandInAirThatWentOnBehindAStall) {
    Bench bench;
    bench.ticks(700, Vec3::Zero());
    for (int i = 1; i <= 600; ++i)
        EXPECT_LT(bench.tick(Vec3(0.00005 * i, 0, 0), false).force_n.norm(), 1.0) << i;
    const Vec3 hand(0.030, 0, 0);
    for (int i = 0; i < 700; ++i) {
        bench.feedback.proxy.p = bench.home + std::min(1.0, 0.1 * i) * hand;
        const auto result = bench.tick(hand);
        EXPECT_LT(result.force_n.norm(), 0.05) << i << " ms";
        EXPECT_TRUE(result.trusted) << "the tool may come to the hand";
        // It has 3 mm to go in the ninth step, and is there in the tenth.
        EXPECT_EQ(result.silent, i < 10) << i << " ms";
    }
    bench.feedback.proxy.p.z() += 0.001;
    EXPECT_NEAR(bench.ticks(100, hand).force_n.norm(), 0.3, 0.01) << "and the force is back";
}

TEST(Coupling, DoesNotPushAHandInAirThatWentOnBehindAGapOfTheServo) {
    Bench bench;
    bench.ticks(700, Vec3::Zero());
    const Vec3 hand(0.008, 0, 0);
    EXPECT_EQ(bench.tick(hand, true, 20 * kMs).force_n, Vec3::Zero());
    for (int i = 0; i < 700; ++i) {
        bench.feedback.proxy.p = bench.home + std::min(1.0, i / 3.0) * hand;
        EXPECT_LT(bench.tick(hand).force_n.norm(), 0.05) << i << " ms";
    }
    bench.feedback.proxy.p.z() += 0.001;
    EXPECT_NEAR(bench.ticks(100, hand).force_n.norm(), 0.15, 0.01) << "softer, as after any gap";
}

TEST(Coupling, IsSilentAfterAJumpUntilTheHandBehaves) {
    Bench bench = pressed();
    const Vec3 far(0.006, 0, -0.002);
    const auto jump = bench.tick(far);
    EXPECT_TRUE(jump.fault);
    EXPECT_FALSE(jump.trusted);
    EXPECT_EQ(jump.force_n, Vec3::Zero());
    int silent = 0, faults = 0;
    for (int i = 0; i < 150; ++i) {
        const auto result = bench.tick(far);
        silent += result.trusted ? 0 : 1;
        faults += result.fault;
        if (!result.trusted) {
            EXPECT_EQ(result.force_n, Vec3::Zero());
        }
    }
    EXPECT_NEAR(silent, 100, 2) << "recover_s";
    EXPECT_EQ(faults, 0) << "one jump is one fault";
}

TEST(Coupling, IsSilentForNumbersThatAreNone) {
    Bench bench = pressed();
    const Vec3 bad(0, std::nan(""), -0.002);
    for (int i = 0; i < 20; ++i) {
        const auto result = bench.tick(bad);
        EXPECT_FALSE(result.trusted);
        EXPECT_EQ(result.force_n, Vec3::Zero());
        EXPECT_EQ(result.fault, i == 0);
    }
    bench.ticks(105, Vec3(0, 0, -0.002));
    EXPECT_TRUE(bench.tick(Vec3(0, 0, -0.002)).trusted) << "and believes the hand again";
}

TEST(Coupling, IgnoresAToolStateThatIsNotFinite) {
    Bench bench = pressed();
    const double before = bench.tick(Vec3(0, 0, -0.002)).force_n.z();
    bench.feedback.proxy.p.x() = std::nan("");
    EXPECT_NEAR(bench.tick(Vec3(0, 0, -0.002)).force_n.z(), before, 1e-3);
    for (int i = 0; i < 100; ++i) bench.tick(Vec3(0, 0, -0.002));
    EXPECT_EQ(bench.tick(Vec3(0, 0, -0.002)).force_n, Vec3::Zero()) << "it ages like a stall";
}

TEST(Coupling, IsSilentForALostDeviceAndForAHandThatLetsGo) {
    Bench lost = pressed();
    lost.state.status = DeviceStatus::kLost;
    EXPECT_EQ(lost.tick(Vec3(0, 0, -0.002)).force_n, Vec3::Zero());
    EXPECT_FALSE(lost.tick(Vec3(0, 0, -0.002)).trusted);
    Bench off = pressed();
    off.state.engaged = false;
    EXPECT_EQ(off.tick(Vec3(0, 0, -0.002)).force_n, Vec3::Zero());
    EXPECT_FALSE(off.tick(Vec3(0, 0, -0.002)).trusted);
}

TEST(Coupling, ReleasesInFiftyMilliseconds) {
    Bench bench = pressed();
    bench.coupling.release();
    bench.ticks(25, Vec3(0, 0, -0.002));
    EXPECT_NEAR(bench.tick(Vec3(0, 0, -0.002)).force_n.z(), 0.3, 0.02);
    bench.ticks(30, Vec3(0, 0, -0.002));
    EXPECT_EQ(bench.tick(Vec3(0, 0, -0.002)).force_n, Vec3::Zero());
}

// A hand (light grip on an arm that stands) leans on a rigid wall through a slow physics: the
// published tool is 4 ms old or held. Returns the peak-to-peak motion of the last half second.
double limit_cycle(const CouplingSettings& settings, int hold_ms) {
    Bench bench(settings);
    constexpr double mass = 0.045, friction = 0.1, grip = 150, grip_damping = 0.5, dt = 1e-3;
    double x = 0, v = 0, low = 1, high = -1;
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < 4000; ++i) {
        const double aim = -0.004 * std::min(1.0, i / 1500.0);
        const int fine = 20;
        for (int k = 0; k < fine; ++k) {
            const double a = (force.z() + grip * (aim - x) - (grip_damping + friction) * v) / mass;
            v += a * dt / fine;
            x += v * dt / fine;
        }
        const bool publish = i % hold_ms == 0;
        if (publish) bench.feedback.proxy.p = bench.home + Vec3(0, 0, std::max(0.0, x));
        force = bench.tick(Vec3(0, 0, x), publish).force_n;
        if (i >= 3500) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
    }
    return high - low;
}

TEST(Coupling, IsStableOnAWallWithItsDefaults) {
    EXPECT_LT(limit_cycle({}, 1), 1e-4);
    EXPECT_LT(limit_cycle({}, 4), 1e-4);
}

// The test of the test: without damping and passivity control, a stiff law must be seen to buzz,
// and the passivity controller must calm it.
TEST(Coupling, CalmsAStiffLawByThePassivityController) {
    CouplingSettings stiff;
    stiff.stiffness_n_m = 4000;
    stiff.damping_ns_m = 0;
    stiff.passivity_ns_m = 0;
    const double wild = limit_cycle(stiff, 4);
    EXPECT_GT(wild, 3e-4);
    // What it forgives (0.2 mW) feeds a cycle of this size; the bench calls 0.3 mm calm.
    stiff.passivity_ns_m = CouplingSettings{}.passivity_ns_m;
    EXPECT_LT(limit_cycle(stiff, 4), 1.5e-4);
    stiff.passivity_forgiven_w = 0;
    EXPECT_LT(limit_cycle(stiff, 4), 1e-4);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
