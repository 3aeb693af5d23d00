// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which instruments that stand in tissue count as buried: the rule itself, without a task.

#include "sim/ledger/burial.h"

#include <gtest/gtest.h>

#include "tests/box_scene.h"
#include "tests/cut_checks.h"

namespace placode::sim {
namespace THIS_TEST {

/// An instrument upright in a block of tissue, its tip at a height.
struct Stuck {
    Stuck(ToolKind kind, Tissue tissue, double tip_z_m, float jaw_rad) : scene(made(kind, tissue)) {
        ToolInput input;
        input.engaged = 1;
        input.jaw_rad = jaw_rad;
        input.set_pose(test::blades(Vec3(0, 0, tip_z_m), -Vec3::UnitZ(), Vec3::UnitX()));
        ToolFeedback feedback;
        for (int i = 0; i < 3; ++i) test::frame(scene, state, input, feedback);
    }
    static Scene made(ToolKind kind, Tissue tissue) {
        test::BoxOptions options =
            test::scissors_sheet(Vec3(0.010, 0.010, 0.006), {10, 10, 6}, 200, Method::kVbd);
        options.tissue = tissue;
        options.tool.kind = kind;
        return test::box_scene(options);
    }
    [[nodiscard]] Burial burial() const { return burial_of(scene, state, 0); }

    Scene scene;
    State state{scene, 1};
};

TEST(Burial, OpenBladesThatStandInThePlacodeAreBuriedThere) {
    const auto open_in = [](Tissue tissue, double tip_z_m) {
        return Stuck(ToolKind::kScissors, tissue, tip_z_m, 0.5F).burial();
    };
    const Burial in = open_in(Tissue::kPlacode, -0.003);
    EXPECT_NEAR(in.depth_m, 0.003, 1e-4);
    EXPECT_EQ(in.tissue, Tissue::kPlacode);
    EXPECT_EQ(open_in(Tissue::kPlacode, 0.001).depth_m, 0) << "above it";
    EXPECT_EQ(open_in(Tissue::kZone, -0.003).depth_m, 0) << "they stand where they are to cut";
}

TEST(Burial, JawsThatHoldTissueMayStandInItThoseThatHoldAPatchMayNot) {
    Stuck grasper(ToolKind::kGrasper, Tissue::kZone, -0.003, 0.6F);
    EXPECT_GT(grasper.burial().depth_m, 0.002);
    grasper.state.grasps[0].count = 1;
    grasper.state.grasps[0].tet = 5;
    EXPECT_EQ(grasper.burial().depth_m, 0);
    grasper.state.grasps[0].tet = -1;  // as with nothing but a patch in the jaws
    EXPECT_GT(grasper.burial().depth_m, 0.002);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
