// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What scripted hands see of the marked tissue: how much hangs on, and where to take hold of it.
#include "curriculum/operator_sight.h"

#include <gtest/gtest.h>

#include "sim/anatomy/operative_field.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace {

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

}  // namespace
}  // namespace placode::curriculum
