// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scissors in hands that shake, and in a scene that has no vertices left.

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "sim/cutting/scissors.h"
#include "sim/solver/topology.h"
#include "tests/box_scene.h"
#include "tests/cut_checks.h"

namespace placode::sim {
namespace THIS_TEST {

using test::blades;
using test::BoxOptions;

BoxOptions small_sheet(int spare_vertices = 600) {
    return test::scissors_sheet(Vec3(0.004, 0.004, 0.001), {8, 8, 2}, spare_vertices, Method::kVbd);
}

/// What closing jaws did: `jaw_rad` of each frame, over the middle of the sheet.
struct Closing {
    Closing(const BoxOptions& options, int frames, const std::function<double(int)>& jaw_rad)
        : scene(test::box_scene(options)), state(scene, 1) {
        ToolInput input;
        input.engaged = 1;
        input.set_pose(blades(Vec3(0.0025, 0, -0.0005), Vec3::UnitX(), Vec3::UnitZ()));
        ToolFeedback feedback;
        for (int i = 0; i < frames + 30; ++i) {
            input.jaw_rad = i < frames ? static_cast<float>(std::max(0.0, jaw_rad(i))) : 0.0F;
            test::frame(scene, state, input, feedback);
            for (int e = 0; e < state.event_count; ++e) events.push_back(state.events[e]);
        }
    }
    [[nodiscard]] std::vector<Event> of(EventKind kind) const {
        std::vector<Event> out;
        for (const Event& e : events)
            if (e.kind == kind) out.push_back(e);
        return out;
    }

    Scene scene;
    State state;
    std::vector<Event> events;
};

TEST(ScissorsInHands, AJawThatShakesMakesOneSnipAndTheSameCut) {
    const Closing steady(small_sheet(), 70, [](int i) { return 0.7 - 0.01 * i; });
    const Closing shaking(small_sheet(), 70, [](int i) {
        return 0.7 - 0.01 * i + (i > 0 && i % 3 == 0 ? 0.014 : 0);  // 4 mrad back every third frame
    });
    ASSERT_EQ(steady.of(EventKind::kSnipped).size(), 1U);
    ASSERT_EQ(shaking.of(EventKind::kSnipped).size(), 1U);
    EXPECT_EQ(steady.state.splits, shaking.state.splits);
    EXPECT_EQ(steady.of(EventKind::kSnipped)[0].value, shaking.of(EventKind::kSnipped)[0].value);
}

TEST(ScissorsInHands, AJawThatClosesSlowlyAndShakesCutsAllTheSame) {
    // Every other frame it gives way by 0.6 mrad: a twentieth of what begins a snip.
    const Closing shaking(small_sheet(), 1250,
                          [](int i) { return 0.5 - 0.0004 * i + (i % 2 == 1 ? 0.001 : 0); });
    EXPECT_EQ(shaking.of(EventKind::kSnipped).size(), 1U);
    EXPECT_GT(shaking.state.splits, 10);
}

TEST(ScissorsInHands, AJawThatOpensAgainEndsTheSnip) {
    const Closing twice(small_sheet(), 80, [](int i) {
        if (i < 35) return 0.7 - 0.01 * i;
        return i < 45 ? 0.35 + 0.02 * (i - 35) : 0.55 - 0.02 * (i - 45);
    });
    EXPECT_EQ(twice.of(EventKind::kSnipped).size(), 2U);
}

TEST(ScissorsInHands, WithoutSpareVerticesTissueStaysWholeAndItIsSaid) {
    const Closing roomy(small_sheet(), 70, [](int i) { return 0.7 - 0.01 * i; });
    const Closing full(small_sheet(14), 70, [](int i) { return 0.7 - 0.01 * i; });
    EXPECT_TRUE(roomy.of(EventKind::kNoRoomToCut).empty());
    const std::vector<Event> said = full.of(EventKind::kNoRoomToCut);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_GT(said[0].value, 5);
    const std::vector<Event> snips = full.of(EventKind::kSnipped);
    ASSERT_EQ(snips.size(), 1U);
    EXPECT_LT(snips[0].value, 0.7F * roomy.of(EventKind::kSnipped)[0].value)
        << "what was left whole counts as cut";
    // What counts as cut has come apart: no vertex holds tets together that share no face.
    test::expect_whole_vertices(full.scene, full.state);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
