// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "haptics/trocar.h"
#include "picture_fixture.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

TEST(Camera, TakesTheScopeWithCranialUpAndADefaultBeforeAnybodyHoldsIt) {
    SmallField f = small_field();
    const Camera held = camera_of(f.snapshot, f.view.tools);
    EXPECT_LT((held.position_mm - 1000 * f.snapshot.tools[1].pose.p).norm(), 1e-9);
    EXPECT_GT(held.up.x(), 0.5);      // cranial up
    EXPECT_LT(held.right.y(), -0.9);  // the patient's right on the right
    f.view.tools[1].scope_angle_deg = 30;
    const Camera oblique = camera_of(f.snapshot, f.view.tools);
    EXPECT_NEAR(oblique.forward.dot(held.forward), std::cos(3.14159265 / 6), 1e-6);
    EXPECT_LT(oblique.forward.dot(held.up), -0.49);  // looks down past its axis
    f.snapshot.tools[1].pose = Pose{};
    EXPECT_GT(camera_of(f.snapshot, f.view.tools).position_mm.z(), 10);
}

TEST(Camera, ShowsTheWorkFromTheBeginningAndTheSameOnceSomebodyHoldsIt) {
    SmallField f = small_field();
    ToolSpec& scope = f.view.tools[1];
    scope.pivot_m = Vec3(-0.045, 0, 0.075);
    scope.look_at_m = Vec3(0.011, 0, 0);
    f.snapshot.tools[1].pose = Pose{};
    const Camera first = camera_of(f.snapshot, f.view.tools);
    const auto middle = place_in_picture(first, 1000 * scope.look_at_m);
    ASSERT_TRUE(middle);
    EXPECT_LT(middle->norm(), 1e-6);

    const auto trocars = placode::haptics::default_trocars(f.view.tools, "mouse");
    f.snapshot.tools[1].pose =
        placode::haptics::Trocar(scope, trocars[1]).tip_pose(placode::haptics::DeviceState{});
    const Camera held = camera_of(f.snapshot, f.view.tools);
    EXPECT_LT((held.position_mm - first.position_mm).norm(), 1e-6);
    EXPECT_LT((held.forward - first.forward).norm(), 1e-6);
    EXPECT_LT((held.up - first.up).norm(), 1e-6);
    const auto hand = place_in_picture(held, 1000 * trocars[0].home_tip_m);
    ASSERT_TRUE(hand);
    EXPECT_LT(hand->norm(), 0.9) << "the instrument begins in the picture";
}

}  // namespace THIS_TEST
