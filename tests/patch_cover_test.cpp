// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a patch of a scene lies over its placode, as the last events of an attempt say it.
#include "sim/contact/patch_cover.h"

#include <gtest/gtest.h>

#include "sim/anatomy/operative_field.h"
#include "sim/step/patch_when_let_go.h"
#include "sim/step/step.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"
#include "tests/patch_pad.h"

namespace placode::sim {
namespace THIS_TEST {

/// A flat pad with a placode of 2.2 mm in its middle and a patch of 16 x 14 mm beside it.
OperativeFieldSpec pad() {
    OperativeFieldSpec spec = test::patch_pad();
    spec.domain_x_m = 0.042;
    spec.domain_y_m = 0.019;
    spec.edge_outer_m = 0.0020;
    spec.patch->length_m = 0.016;
    spec.patch->width_m = 0.014;
    spec.patch->centre_m = Vec2(-0.0100, 0);
    return spec;
}

/// The pad, built once: a test changes only its states.
const std::shared_ptr<const Scene>& pad_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(pad());
    return scene;
}

/// Carries the patch as it lies by a way, as no hand could.
void move_patch(const Scene& scene, State& state, const Vec3& offset) {
    for (int i = 0; i < scene.patch->vertex_count; ++i) {
        Float4& x = state.body.x[static_cast<size_t>(scene.patch->first_vertex + i)];
        x.x += static_cast<float>(offset.x());
        x.y += static_cast<float>(offset.y());
        x.z += static_cast<float>(offset.z());
    }
}

const Event& head_of(const std::vector<Event>& events) { return events.at(0); }
const Event& fold_of(const std::vector<Event>& events) { return events.back(); }

TEST(PatchCover, WithoutPatchOrPlacodeThereIsNothingToSay) {
    OperativeFieldSpec spec = pad();
    spec.patch.reset();
    const auto scene = build_operative_field(spec);
    EXPECT_FALSE(PatchCover(*scene).there());
    EXPECT_TRUE(patch_when_let_go(*scene, State(*scene, 1)).empty());
    EXPECT_EQ(patch_handles(*scene).rim, -1);
}

TEST(PatchCover, BesideThePlacodeItCoversNothing) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    PatchCover cover(*scene);
    ASSERT_TRUE(cover.there());
    const std::vector<Event> events = cover.events(*scene, state);
    ASSERT_EQ(events.size(), kPatchEdgePoints + 2U);
    EXPECT_EQ(head_of(events).element, -1);
    EXPECT_EQ(head_of(events).value, kPatchEdgePoints);
    EXPECT_EQ(head_of(events).value2, 1) << "all of the placode lies open";
    for (int i = 0; i < kPatchEdgePoints; ++i) {
        const Event& point = events[static_cast<size_t>(i) + 1];
        EXPECT_EQ(point.element, i);
        EXPECT_EQ(point.value, 0);
        EXPECT_NEAR(std::hypot(point.rest_position_m[0], point.rest_position_m[1]), 0.0011, 2e-4);
    }
    EXPECT_EQ(fold_of(events).value, 0);
    EXPECT_NEAR(fold_of(events).value2, 0.016 * 0.014, 1e-9);
}

/// Flat over a round placode of radius r, its middle moved aside by d: straight up and down the
/// overlap is 7 mm - r, straight to the sides 8 mm - r -+ d.
TEST(PatchCover, MovedOverThePlacodeItReachesAsFarAsItsSidesDo) {
    const auto& scene = pad_scene();
    for (const double d : {0.0, 0.0012}) {
        State state(*scene, 1);
        move_patch(*scene, state, Vec3(0.0100 + d, 0, 0));
        const std::vector<Event> events = PatchCover(*scene).events(*scene, state);
        EXPECT_EQ(head_of(events).value2, 0);
        for (int i = 0; i < kPatchEdgePoints; ++i) {
            const Event& point = events[static_cast<size_t>(i) + 1];
            const double x = static_cast<double>(point.rest_position_m[0]),
                         y = static_cast<double>(point.rest_position_m[1]);
            const double nearest =
                std::min({x >= 0 ? 0.008 + d - x : 0.008 - d + x, 0.007 - std::abs(y)});
            // The least way lies in the half plane outwards; beside it a side may be a bit farther.
            EXPECT_GE(point.value, nearest - 1e-6);
            EXPECT_LE(point.value, nearest * 1.03);
        }
    }
}

TEST(PatchCover, HeldUpItIsJudgedWhereItFalls) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    move_patch(*scene, state, Vec3(0.0100, 0, 0.004));
    const std::vector<Event> events = patch_when_let_go(*scene, state);
    ASSERT_EQ(events.size(), kPatchEdgePoints + 2U);
    EXPECT_EQ(head_of(events).value2, 0);
    EXPECT_NEAR(events[1].value, 0.0069, 0.0012);
    EXPECT_EQ(state.frame, 0) << "the state itself goes on as if nobody had looked";
    State two(*scene, 2);
    move_patch(*scene, two, Vec3(0.0100, 0, 0.004));
    two.substeps = state.substeps + 3;  // chosen for a frame that never came
    const std::vector<Event> again = patch_when_let_go(*scene, two);
    for (size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ(again[i].value, events[i].value) << i;
        EXPECT_EQ(again[i].value2, events[i].value2) << i;
    }
}

TEST(PatchCover, IsTakenAtTheMiddleOfItsNearSide) {
    const auto& scene = pad_scene();
    const PatchHandles handles = patch_handles(*scene);
    const auto& rest = scene->body.mesh().rest;
    const Vec3 rim = rest.at(static_cast<size_t>(handles.rim));
    EXPECT_NEAR(rim.x(), -0.0020, 1e-9);
    EXPECT_NEAR(rim.y(), 0, 1e-9);
    EXPECT_NEAR(rest.at(static_cast<size_t>(handles.middle)).x(), -0.0100, 1e-9);
    const std::array<Vec2, 4> corners{Vec2(-0.018, -0.007), Vec2(-0.002, -0.007),
                                      Vec2(-0.002, 0.007), Vec2(-0.018, 0.007)};
    for (size_t i = 0; i < 4; ++i)
        EXPECT_LT((rest.at(static_cast<size_t>(handles.corner[i])).head<2>() - corners[i]).norm(),
                  1e-9)
            << i;
}

}  // namespace THIS_TEST
}  // namespace placode::sim
