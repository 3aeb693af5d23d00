// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A watcher's copy follows the tissue, also while vertices that a cut parts wait for their turn.

#include "sim/step/snapshot.h"

#include <gtest/gtest.h>

#include "sim/world/shape_version.h"
#include "tests/box_scene.h"
#include "tests/cut_checks.h"

namespace placode::sim {
namespace THIS_TEST {

TEST(Snapshot, ACutIsShownWhenItsVerticesHaveParted) {
    const Scene scene = test::box_scene(
        test::scissors_sheet(Vec3(0.008, 0.008, 0.002), {16, 16, 4}, 2000, Method::kVbd));
    State state(scene, 1);
    ToolInput input;
    input.engaged = 1;
    input.set_pose(test::blades(Vec3(0.004, 0, -0.001), Vec3::UnitX(), Vec3::UnitZ()));
    ToolFeedback feedback;
    Snapshot seen;
    bool waited = false;
    const uint32_t whole = shape_version(state);
    uint32_t parting = whole, faces = 0;  // while vertices wait
    // Shut within two frames: more faces part than vertices can in that time.
    for (const float jaw : {0.7F, 0.35F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}) {
        input.jaw_rad = jaw;
        test::frame(scene, state, input, feedback);
        fill_snapshot(scene, state, seen);
        if (state.separation.count == 0) continue;
        waited = true;
        parting = shape_version(state);
        faces = state.surface.version();
    }
    ASSERT_TRUE(waited) << "nothing waits: the test shows nothing";
    EXPECT_GT(parting, whole);
    for (int i = 0; i < 300 && (state.separation.count > 0 || i < 20); ++i) {
        test::frame(scene, state, input, feedback);
        fill_snapshot(scene, state, seen);
    }
    ASSERT_EQ(state.separation.count, 0);
    ASSERT_EQ(state.surface.version(), faces) << "faces parted after the cut: it shows nothing";
    EXPECT_GT(shape_version(state), parting);
    const auto now = state.surface.triangles();
    ASSERT_EQ(seen.triangles.size(), now.size());
    for (size_t i = 0; i < now.size(); ++i)
        ASSERT_EQ(seen.triangles[i].vertex, now[i].vertex) << "triangle " << i;
}

}  // namespace THIS_TEST
}  // namespace placode::sim
