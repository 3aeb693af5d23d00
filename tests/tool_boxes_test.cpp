// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tool_boxes.h"

#include <gtest/gtest.h>

#include "ui/view/tool_renderer.h"

namespace placode::view {
namespace THIS_TEST {

using namespace sim;

TEST(ToolBoxes, HoldEverythingThatIsSeenOfAnInstrument) {
    for (const ToolKind kind :
         {ToolKind::kNeedle, ToolKind::kHook, ToolKind::kGrasper, ToolKind::kScissors}) {
        ToolSpec spec;
        spec.kind = kind;
        if (kind == ToolKind::kGrasper || kind == ToolKind::kScissors) spec.tip_length_m = 0.012;
        Snapshot snapshot;
        snapshot.tool_count = 1;
        snapshot.tools[0].pose.p = Vec3(0.003, -0.004, 0.001);
        snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(0.5, 0.7, -0.6));
        const Camera camera = look_at(Vec3(-15.4, 0, 25.7), Vec3(0, 0, 0), 70);
        const auto boxes = tool_boxes(snapshot, {spec}, camera);
        ASSERT_FALSE(boxes.empty());
        int seen = 0;
        for (const auto& v : tool_model(spec).vertices) {
            const Vec3 at =
                1000 * snapshot.tools[0].pose.p + snapshot.tools[0].pose.q * v.p.cast<double>();
            const auto place = place_in_picture(camera, at);
            if (!place || place->norm() > 1) continue;
            ++seen;
            EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(), [&](const PictureBox& box) {
                return (*place - box.low).minCoeff() >= 0 && (box.high - *place).minCoeff() >= 0;
            })) << static_cast<int>(kind);
        }
        EXPECT_GT(seen, 50);
        double area = 0;
        for (const PictureBox& box : boxes) area += (box.high - box.low).prod();
        EXPECT_LT(area, 1.0) << "the whole picture is 4";
    }
}

TEST(ToolBoxes, NothingForWhatIsOutOfThePicture) {
    Snapshot snapshot;
    snapshot.tool_count = 1;
    snapshot.tools[0].pose.p = Vec3(0, 0.2, 0.2);
    snapshot.tools[0].pose.q = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3(0, -1, -1));
    EXPECT_TRUE(
        tool_boxes(snapshot, {ToolSpec{}}, look_at(Vec3(-15, 0, 26), Vec3(0, 0, 0), 70)).empty());
}

// Before the first input the first picture showed its tip in the middle of the lesion.
TEST(ToolBoxes, NothingForWhatNoHandHasMovedYet) {
    Snapshot snapshot;
    snapshot.tool_count = 1;
    const Camera camera = look_at(Vec3(-15.4, 0, 25.7), Vec3(0, 0, 0), 70);
    EXPECT_FALSE(is_drawn({ToolSpec{}}, 0, snapshot));
    EXPECT_TRUE(tool_boxes(snapshot, {ToolSpec{}}, camera).empty());
    snapshot.tools[0].pose.p = Vec3(0, 0, 0.002);
    EXPECT_TRUE(is_drawn({ToolSpec{}}, 0, snapshot));
}

}  // namespace THIS_TEST
}  // namespace placode::view
