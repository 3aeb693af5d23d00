// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm_hands.h"

#include <gtest/gtest.h>

namespace placode::haptics {
namespace THIS_TEST {

using sim::Key;

constexpr int64_t kMs = 1'000'000;

/// An arm with a hand on it that stands still.
class StillArm final : public ArmHands {
 public:
    explicit StillArm(const DeviceConfig& config) : ArmHands(config, {sim::Hand::kRight}) {}
    uint32_t buttons = 0;

 protected:
    void sense(int64_t, std::span<ArmSample> samples) noexcept override {
        samples[0].status = DeviceStatus::kReady;
        samples[0].held = true;
        samples[0].buttons = buttons;
    }
    void drive(std::span<const ArmForce>) noexcept override {}
    [[nodiscard]] std::vector<DeviceInfo> arm_info() const override { return {}; }
};

struct Bench {
    Bench() {
        DeviceConfig config;
        config.name = "haply";
        config.tools.resize(1);
        config.window = &window;
        arm = std::make_unique<StillArm>(config);
        window.publish(input);
        (void)pedals(10);
    }
    /// After so many ticks, while the window says nothing.
    uint8_t pedals(int ms) {
        for (int i = 0; i < ms; ++i) arm->read(t_ns += kMs, states);
        return states[0].pedals;
    }
    void hold(Key key, bool down) {
        input.down[static_cast<size_t>(key)] = down;
        window.publish(input);
    }

    sim::Latest<sim::WindowInput> window;
    sim::WindowInput input;
    std::unique_ptr<StillArm> arm;
    std::array<DeviceState, 1> states{};
    int64_t t_ns = 0;
};

// A pedal that comes as a keyboard stayed down for ten seconds where the main thread hung.
TEST(ArmHands, AKeyThatStandsForAPedalIsLetGoWhereTheWindowSaysNothing) {
    Bench bench;
    bench.hold(Key::kCut, true);
    EXPECT_EQ(bench.pedals(900), sim::kPedalCut) << "a slow picture is no reason";
    EXPECT_EQ(bench.pedals(200), 0);
    EXPECT_EQ(bench.pedals(2000), 0);
    bench.hold(Key::kCut, true);
    EXPECT_EQ(bench.pedals(10), 0) << "it has to be pressed anew";
    bench.hold(Key::kCut, false);
    (void)bench.pedals(1);
    bench.hold(Key::kCut, true);
    EXPECT_EQ(bench.pedals(1), sim::kPedalCut);
}

TEST(ArmHands, WhatTheArmItselfSaysIsNewWhateverTheWindowDoes) {
    Bench bench;
    bench.arm->buttons = 1;
    EXPECT_EQ(bench.pedals(3000), sim::kPedalCut);
    EXPECT_EQ(bench.states[0].status, DeviceStatus::kReady);
}

}  // namespace THIS_TEST
}  // namespace placode::haptics
