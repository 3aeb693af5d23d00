// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is loaded is what was saved, before anything else is done with it.

#include "sim/world/saved_state.h"

#include <gtest/gtest.h>

#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

TEST(SavedState, HasItsHashAtOnceAlsoWhileSomethingIsTouched) {
    test::BoxOptions options;
    options.size_m = Vec3(0.008, 0.008, 0.003);
    options.cells = {8, 8, 3};
    options.tissue = Tissue::kZone;
    options.heat = false;
    options.tool.kind = ToolKind::kProbe;
    options.tool.tip_radius_m = 0.001;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    ToolFeedback feedback;
    for (int i = 0; i < 60; ++i)
        test::frame(scene, state, test::upright(Vec3(0, 0, 2e-4 - 1e-5 * i)), feedback);
    ASSERT_EQ(state.tools[0].in_contact, 1);
    ASSERT_GT(state.colour.count, 0);
    State loaded(scene, 1);
    load_state(scene, loaded, save_state(scene, state));
    EXPECT_EQ(state_hash(loaded), state_hash(state));
    EXPECT_EQ(whole_hash(loaded), whole_hash(state));
}

}  // namespace THIS_TEST
}  // namespace placode::sim
