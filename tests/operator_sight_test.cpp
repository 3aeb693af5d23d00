// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What scripted hands see of the marked tissue: how much hangs on, and where to take hold of it.
#include "curriculum/operator_sight.h"

#include <gtest/gtest.h>

#include "sim/anatomy/operative_field.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::Vec3;

class OperatorSightTest : public testing::Test {
 protected:
    OperatorSightTest()
        : held_(sim::build_operative_field(load_task("scissors_resection").scene)),
          scene_(*held_),
          state_(scene_, 1),
          sight_(scene_) {}
    // Takes out the marked tets that `chosen` picks by their place at rest.
    template <class Chosen>
    void take_out(Chosen&& chosen) {
        for (size_t t = 0; t < scene_.marked.size(); ++t) {
            if (!scene_.marked[t]) continue;
            sim::Vec3 centre = sim::Vec3::Zero();
            for (const int32_t v : scene_.body.mesh().tets[t]) {
                centre += scene_.body.mesh().rest[static_cast<size_t>(v)] / 4;
            }
            if (chosen(centre)) state_.body.tet_alive[t] = 0;
        }
    }
    [[nodiscard]] haptics::Perception look() {
        sight_.look(state_);
        return sight_.seen(state_);
    }

    std::shared_ptr<const sim::Scene> held_;
    const sim::Scene& scene_;
    sim::State state_;
    OperatorSight sight_;
};

TEST_F(OperatorSightTest, PointsAtTheIncisedEdgeFirst) {
    const haptics::Perception seen = look();
    EXPECT_NEAR(seen.marked_left, 1, 1e-5);  // a sum of float volumes
    EXPECT_EQ(seen.marked_held, 0);
    // Nothing has moved yet: the place is the scene's own.
    EXPECT_LT((seen.grasp_place_m - scene_.resection.grasp_m).norm(), 1e-6);
}

TEST_F(OperatorSightTest, PointsAtWhatIsLeftOfIt) {
    take_out([](const sim::Vec3& c) { return c.y() > 0; });
    const haptics::Perception seen = look();
    EXPECT_GT(seen.marked_left, 0.3);
    EXPECT_LT(seen.marked_left, 0.7);
    EXPECT_LT(seen.grasp_place_m.y(), 0);
    // On tissue that is there: some marked tet lies within an edge of it.
    double nearest = 1;
    for (size_t t = 0; t < scene_.marked.size(); ++t) {
        if (!scene_.marked[t] || !state_.body.tet_alive[t]) continue;
        for (const int32_t v : scene_.body.mesh().tets[t]) {
            const sim::Vec3& x = scene_.body.mesh().rest[static_cast<size_t>(v)];
            nearest = std::min(nearest, (x - seen.grasp_place_m).norm());
        }
    }
    EXPECT_LT(nearest, 6e-4);
}

TEST_F(OperatorSightTest, SaysWhenNothingIsLeft) {
    take_out([](const sim::Vec3&) { return true; });
    EXPECT_EQ(look().marked_left, 0);
}

TEST_F(OperatorSightTest, ScissorsHaveNoBareMetal) {
    for (const double gap : look().placode_metal_gap_m) EXPECT_EQ(gap, 1);
}

TEST(OperatorSight, SeesTheFlankOfTheNeedle) {
    const auto scene = sim::build_operative_field(load_task("diathermy_ring_small").scene);
    ASSERT_EQ(scene->tools[0].kind, sim::ToolKind::kNeedle);
    sim::State state(*scene, 1);
    OperatorSight sight(*scene);
    const sim::TetMesh& mesh = scene->body.mesh();
    size_t v = 0;  // the highest vertex of the placode
    float height = -1;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (mesh.tissue[t] != sim::Tissue::kPlacode) continue;
        for (const int32_t corner : mesh.tets[t]) {
            const float z = state.body.x[static_cast<size_t>(corner)].z;
            if (z > height) v = static_cast<size_t>(corner);
            height = std::max(height, z);
        }
    }
    // The needle comes from below, through that vertex, its tip 2 mm above it.
    const double above_m = 0.002, radius_m = scene->tools[0].tip_radius_m;
    ASSERT_LT(above_m, scene->tools[0].tip_length_m);
    state.tools[0].proxy = {to_vec(state.body.x[v]) + Vec3(0, 0, above_m), sim::Quat::Identity()};
    sight.look(state);
    const haptics::Perception seen = sight.seen(state);
    EXPECT_NEAR(seen.placode_metal_gap_m[0], -radius_m, 1e-9);
    EXPECT_GT(seen.placode_gap_m[0], 1e-3) << "the tip itself is far away";
    EXPECT_EQ(seen.placode_metal_gap_m[1], 1) << "a scope";
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
