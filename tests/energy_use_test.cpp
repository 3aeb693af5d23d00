// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Current on one spot and in air: what is one spell, what parts two, and when and where it was.

#include "sim/ledger/energy_use.h"

#include <gtest/gtest.h>

#include <vector>

#include "sim/cutting/diathermy.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kFrameS = 1e-3;
constexpr double kSpotM = 0.002, kElsewhereM = 0.006;

/// A needle with a pedal, without the tissue's answer: only the ledger is at work.
class Pedal {
 public:
    Pedal() : scene_(test::box_scene({})), state_(scene_, 1) {}

    void down(int frames, double x_m = kSpotM) {
        for (int i = 0; i < frames; ++i) frame(true, x_m, kPowerW);
    }
    void down_in_air(int frames) {
        for (int i = 0; i < frames; ++i) frame(true, kElsewhereM, 0);
    }
    /// The needle goes elsewhere meanwhile, as a hand does.
    void up(int frames) {
        for (int i = 0; i < frames; ++i) frame(false, kElsewhereM, 0);
    }
    [[nodiscard]] std::vector<Event> entered(EventKind kind) const {
        std::vector<Event> found;
        for (const Event& e : events_)
            if (e.kind == kind) found.push_back(e);
        return found;
    }
    /// Entered, or to be entered at the end.
    [[nodiscard]] std::vector<Event> open() const {
        std::vector<Event> events;
        open_energy(state_, 0, events);
        return events;
    }

 private:
    static constexpr double kPowerW = 5;

    void frame(bool pedal, double x_m, double power_w) {
        ++state_.frame;
        state_.time_s = static_cast<double>(state_.frame) * kFrameS;
        state_.event_count = 0;
        ToolState& tool = state_.tools[0];
        tool.spot = tool.rest_spot = Vec3(x_m, 0, 0);
        on_ = pedal ? on_ + 1 : 0;
        // As long as a tap has not reached a step of heat, its power is not known.
        tool.power_in_tissue_w = on_ < heat_interval(scene_) ? 0 : power_w;
        ledger_energy(scene_, state_, 0, pedal, kFrameS);
        events_.insert(events_.end(), state_.events.begin(),
                       state_.events.begin() + state_.event_count);
    }

    Scene scene_;
    State state_;
    std::vector<Event> events_;
    int on_ = 0;
};

TEST(EnergyUse, TapsOnOneSpotAreOneSpell) {
    Pedal pedal;
    for (int i = 0; i < 10; ++i) {
        pedal.down(900);
        pedal.up(10);
    }
    EXPECT_TRUE(pedal.entered(EventKind::kDwell).empty()) << "it is not over";
    pedal.up(1100);
    const auto dwells = pedal.entered(EventKind::kDwell);
    ASSERT_EQ(dwells.size(), 1U);
    EXPECT_GT(dwells[0].value, 8);
    EXPECT_LE(dwells[0].value, 9.001F) << "pauses do not count";
    EXPECT_NEAR(dwells[0].time_s, 9.09, 0.002) << "the last current, not when the pause was over";
    EXPECT_NEAR(dwells[0].rest_position_m[0], kSpotM, 1e-6) << "where it was, not where it went";
    EXPECT_EQ(pedal.entered(EventKind::kEnergyOff).size(), 10U);
    EXPECT_TRUE(pedal.entered(EventKind::kEnergyInAir).empty());
}

TEST(EnergyUse, TapsInTheAirAreOneSpell) {
    Pedal pedal;
    for (int i = 0; i < 5; ++i) {
        pedal.down_in_air(900);
        pedal.up(50);
    }
    pedal.up(1100);
    const auto spells = pedal.entered(EventKind::kEnergyInAir);
    ASSERT_EQ(spells.size(), 1U);
    EXPECT_NEAR(spells[0].value, 4.5, 0.01);
    EXPECT_NEAR(spells[0].time_s, 4.7, 0.002);
}

TEST(EnergyUse, ASingleTapCostsNothing) {
    Pedal pedal;
    pedal.down(900);
    pedal.up(2000);
    pedal.down_in_air(900);
    pedal.up(2000);
    EXPECT_TRUE(pedal.entered(EventKind::kDwell).empty());
    EXPECT_TRUE(pedal.entered(EventKind::kEnergyInAir).empty());
    EXPECT_TRUE(pedal.open().empty());
}

TEST(EnergyUse, APauseOfOverASecondPartsTwoSpells) {
    Pedal parted, joined;
    parted.down(700);
    parted.up(1100);
    parted.down(700);
    parted.up(1100);
    EXPECT_TRUE(parted.entered(EventKind::kDwell).empty());
    joined.down(700);
    joined.up(900);
    joined.down(700);
    joined.up(1100);
    EXPECT_EQ(joined.entered(EventKind::kDwell).size(), 1U);
}

TEST(EnergyUse, AnotherSpotOrAirEndsIt) {
    Pedal moved, lifted, rested;
    moved.down(700);
    moved.up(10);
    moved.down(700, kElsewhereM);
    moved.up(1100);
    EXPECT_TRUE(moved.entered(EventKind::kDwell).empty());
    lifted.down(700);
    lifted.down_in_air(100);
    lifted.down(700);
    lifted.up(1100);
    EXPECT_TRUE(lifted.entered(EventKind::kDwell).empty());
    // Entered at once, where and when it was.
    rested.down(1500);
    rested.down(1, kElsewhereM);
    const auto dwells = rested.entered(EventKind::kDwell);
    ASSERT_EQ(dwells.size(), 1U);
    EXPECT_NEAR(dwells[0].time_s, 1.5, 0.002);
    EXPECT_NEAR(dwells[0].rest_position_m[0], kSpotM, 1e-6);
}

TEST(EnergyUse, WhoeverEndsTheAttemptInAPauseHasRestedAllTheSame) {
    Pedal pedal;
    pedal.down(1500);
    pedal.up(500);
    const auto open = pedal.open();
    ASSERT_EQ(open.size(), 1U);
    EXPECT_EQ(open[0].kind, EventKind::kDwell);
    EXPECT_NEAR(open[0].time_s, 1.5, 0.002);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
