// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the force law one by one, on a fake clock.
#include "haptics/safety.h"

#include <gtest/gtest.h>

namespace placode::haptics {
namespace THIS_TEST {

constexpr int64_t kMs = 1'000'000;

TEST(VelocityFilter, ReachesASteadySpeedAndForgetsIt) {
    VelocityFilter filter(100);
    for (int i = 0; i < 50; ++i) filter.update(Vec3(1e-4, 0, 0), 1e-3);
    // First order, 100 Hz at 1 kHz: gain 0.386, so 0.614^50 of the start is left.
    EXPECT_NEAR(filter.value().x(), 0.1, 1e-6);
    filter.update(Vec3(1, 0, 0), 0);
    EXPECT_NEAR(filter.value().x(), 0.1, 1e-6) << "no time, no velocity";
    filter.reset();
    EXPECT_EQ(filter.value(), Vec3::Zero());
}

TEST(PassivityController, CountsTheEnergyOfAHeldForceExactly) {
    PassivityController port(20, 1.0);
    port.observe(Vec3(0, 0, 2), Vec3(0, 0, -0.001), 1e-3);  // pushed against: absorbed
    EXPECT_DOUBLE_EQ(port.energy_j(), 0.002);
    port.observe(Vec3(0, 0, 2), Vec3(0, 0, 0.003), 1e-3);  // pushed along: given
    EXPECT_DOUBLE_EQ(port.energy_j(), -0.004);
    EXPECT_DOUBLE_EQ(port.least_j(), -0.004);
}

TEST(PassivityController, TakesBackWhatIsMissingAndNoMore) {
    PassivityController port(20, 0.005);
    bool acted = false;
    const Vec3 force(0, 0, 1), slow(0, 0, 0.0005), fast(0, 0, 0.1);
    EXPECT_EQ(port.correct(force, fast, 1e-3, acted), force);
    EXPECT_FALSE(acted) << "no energy is missing";
    port.observe(Vec3(0, 0, 1), Vec3(0, 0, 1e-5), 1e-3);  // 10 uJ created
    EXPECT_EQ(port.correct(force, slow, 1e-3, acted), force) << "below 1 mm/s it is noise";
    const Vec3 damped = port.correct(force, fast, 1e-3, acted);
    EXPECT_TRUE(acted);
    // a = 1e-5 / (1e-3 x 0.01) = 1 N s/m takes exactly 10 uJ back within the tick.
    EXPECT_NEAR((force - damped).dot(fast) * 1e-3, 1e-5, 1e-12);
    port.observe(Vec3(0, 0, 1), Vec3(0, 0, 0.01), 1e-3);
    EXPECT_NEAR((force - port.correct(force, fast, 1e-3, acted)).norm(), 20 * 0.1, 1e-9)
        << "the damping has a limit";
}

// At rest an encoder jumps between two steps, and what is missing creeps: that is forgiven. What a
// law that is unstable gives is not.
TEST(PassivityController, ForgivesTheCreepOfAnEncoder) {
    for (const auto& [power_w, acts] : {std::pair{1e-4, false}, std::pair{1e-2, true}}) {
        PassivityController port(20, 0.005, 2e-5, 2e-4);
        bool acted = false, ever = false;
        for (int i = 0; i < 2000; ++i) {
            port.observe(Vec3(0, 0, 1), Vec3(0, 0, 1e-3 * power_w), 1e-3);
            (void)port.correct(Vec3(0, 0, 1), Vec3(0, 0, 0.02), 1e-3, acted);
            ever = ever || acted;
        }
        EXPECT_EQ(ever, acts) << power_w;
    }
    PassivityController port(20, 0.005, 0, 2e-4);
    port.observe(Vec3(0, 0, 1), Vec3(0, 0, 1e-3), 1e-3);
    for (int i = 0; i < 10'000; ++i) port.observe(Vec3::Zero(), Vec3::Zero(), 1e-3);
    EXPECT_EQ(port.energy_j(), 0) << "forgiven, never turned into a surplus";
}

TEST(PassivityController, ForgetsSurplus) {
    PassivityController port(20, 0.005);
    for (int i = 0; i < 100; ++i) port.observe(Vec3(0, 0, 1), Vec3(0, 0, -0.01), 1e-3);
    EXPECT_DOUBLE_EQ(port.energy_j(), 0.005);
}

TEST(ThermalBudget, LetsTheCeilingFallWithTheRms) {
    const CouplingSettings settings;
    ThermalBudget budget(settings);
    EXPECT_DOUBLE_EQ(budget.ceiling_n(0), settings.max_force_n);
    // The rms after t is F sqrt(1 - exp(-t/60)); 1.1 N for ten minutes is 1.1 N.
    for (int i = 0; i < 600'000; ++i) budget.observe(Vec3(1.1, 0, 0), 1e-3);
    EXPECT_NEAR(budget.rms_n(), 1.1, 1e-3);
    const double hot = (1.1 / 0.88 - 1) / 0.5;
    EXPECT_NEAR(budget.ceiling_n(0), 3.0 + hot * (0.8 - 3.0), 0.01);
    for (int i = 0; i < 600'000; ++i) budget.observe(Vec3(3, 0, 0), 1e-3);
    EXPECT_DOUBLE_EQ(budget.ceiling_n(0), settings.thermal_floor_n);
}

TEST(ThermalBudget, BelievesADeviceThatIsHotAndDistrustsNonsense) {
    const CouplingSettings settings;
    const ThermalBudget budget(settings);
    EXPECT_DOUBLE_EQ(budget.ceiling_n(0.81), settings.thermal_floor_n);
    EXPECT_DOUBLE_EQ(budget.ceiling_n(std::nan("")), settings.thermal_floor_n);
}

TEST(ForceLimiter, KeepsTheDirectionAndTheSlew) {
    ForceLimiter limiter;
    bool saturated = false, slewed = false;
    Vec3 last = Vec3::Zero();
    for (int i = 0; i < 40; ++i) {
        const Vec3 now = limiter.apply(Vec3(30, 40, 0), 3, 200, 1e-3, saturated, slewed);
        EXPECT_TRUE(saturated);
        EXPECT_LE((now - last).norm(), 0.2 + 1e-12);
        EXPECT_NEAR(now.x() * 4, now.y() * 3, 1e-12);
        last = now;
    }
    EXPECT_NEAR(last.norm(), 3, 1e-12);
    EXPECT_FALSE(slewed);
    limiter.reset();
    EXPECT_NEAR(limiter.apply(Vec3(1, 0, 0), 3, 200, 1e-3, saturated, slewed).norm(), 0.2, 1e-12);
    EXPECT_FALSE(saturated);
    EXPECT_EQ(limiter.apply(Vec3(1, 0, 0), 3, 200, -1, saturated, slewed),
              limiter.apply(Vec3(1, 0, 0), 3, 200, 0, saturated, slewed))
        << "no time, no change";
}

// 5, 50 and 500 ms without a new tool state.
TEST(Watchdog, FadesFromTenToFiftyMilliseconds) {
    Watchdog watchdog(0.010, 0.050);
    EXPECT_TRUE(watchdog.dead(0)) << "nothing was ever seen";
    watchdog.seen(100 * kMs);
    EXPECT_FALSE(watchdog.fading(watchdog.age_s(105 * kMs)));
    EXPECT_DOUBLE_EQ(watchdog.spring_gain(watchdog.age_s(105 * kMs)), 1);
    EXPECT_TRUE(watchdog.fading(watchdog.age_s(111 * kMs)));
    EXPECT_NEAR(watchdog.spring_gain(watchdog.age_s(130 * kMs)), 0.5, 1e-12);
    EXPECT_FALSE(watchdog.dead(watchdog.age_s(150 * kMs)));
    EXPECT_DOUBLE_EQ(watchdog.spring_gain(watchdog.age_s(150 * kMs)), 0);
    EXPECT_TRUE(watchdog.dead(watchdog.age_s(600 * kMs)));
    watchdog.seen(600 * kMs);
    EXPECT_FALSE(watchdog.dead(watchdog.age_s(600 * kMs)));
}

TEST(Watchdog, ClockJumpsMakeNothingYoung) {
    Watchdog watchdog(0.010, 0.050);
    watchdog.seen(100 * kMs);
    EXPECT_GE(watchdog.age_s(50 * kMs), 0);
    watchdog.clock_jumped(50 * kMs);
    EXPECT_TRUE(watchdog.dead(watchdog.age_s(50 * kMs)));
    watchdog.seen(51 * kMs);
    EXPECT_FALSE(watchdog.fading(watchdog.age_s(52 * kMs)));
}

TEST(LatencyMeter, FindsTheHandThatAFreeToolAnswersTo) {
    LatencyMeter meter;
    const auto hand = [](int i) { return Vec3(1e-4 * i, 0, 0); };
    for (int i = 0; i < 400; ++i) {
        meter.sent(i * kMs, hand(i));
        if (i >= 4 && i % 4 == 0) meter.seen(i * kMs, hand(i - 4), 0.1);
    }
    // A share of 0.1 in each of 99 states: 0.9^99 of the way is left.
    EXPECT_NEAR(meter.latency_s(), 0.004, 2e-7);
    for (int i = 0; i < 100; ++i) meter.seen((400 + i) * kMs, hand(399), 0.001);
    EXPECT_NEAR(meter.latency_s(), 0.004, 2e-7) << "a slow hand tells no age";
    for (int i = 0; i < 100; ++i) meter.seen((400 + i) * kMs, Vec3(0, 0.01, 0), 0.1);
    EXPECT_NEAR(meter.latency_s(), 0.004, 2e-7) << "nor does a tool in contact";
    meter.reset();
    meter.seen(500 * kMs, hand(399), 0.1);
    EXPECT_NEAR(meter.latency_s(), 0.004, 2e-7) << "places from before the reset are forgotten";
}

TEST(PeriodSchedule, SkipsMissedPeriodsAndNeverCatchesUp) {
    PeriodSchedule schedule(0, kMs);
    EXPECT_EQ(schedule.next_ns(), kMs);
    EXPECT_EQ(schedule.advance(kMs + 50'000), 0u);
    EXPECT_EQ(schedule.next_ns(), 2 * kMs);
    // Stalls of 5, 50 and 500 ms: one tick follows, then the old beat.
    int64_t now = 2 * kMs;
    for (const int stall : {5, 50, 500}) {
        now = schedule.next_ns() + stall * kMs + 100'000;
        const uint64_t missed = schedule.advance(now);
        EXPECT_EQ(missed, static_cast<uint64_t>(stall)) << stall;
        EXPECT_GT(schedule.next_ns(), now);
        EXPECT_LE(schedule.next_ns() - now, kMs);
        EXPECT_EQ(schedule.next_ns() % kMs, 0) << "the beat is kept";
    }
}

TEST(PeriodSchedule, BearsAClockThatGoesBack) {
    PeriodSchedule schedule(1000 * kMs, kMs);
    EXPECT_EQ(schedule.advance(500 * kMs), 0u);
    EXPECT_EQ(schedule.next_ns(), 1002 * kMs);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
