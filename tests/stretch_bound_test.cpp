// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The quick look at stretch never says "below" of a tet that is not, and nearly always of one that
// is.

#include "sim/solver/stretch_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sim/cutting/cutting.h"
#include "sim/cutting/tissue_stretch.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

using test::box_scene;
using test::BoxOptions;

BoxOptions block() {
    BoxOptions options;
    options.size_m = Vec3(0.006, 0.006, 0.003);
    options.cells = {6, 6, 3};
    options.material.injury_stretch = 1.3;
    options.material.fail_stretch = 1.6;
    return options;
}

/// Gives the corners of a tet the places of `f` times their places at rest.
void deform(const Scene& scene, State& state, int tet, const Mat3& f) {
    const Vec3 far(0.3, -0.2, 0.1);  // places as floats, far from the origin
    for (const int32_t v : scene.body.mesh().tets[static_cast<size_t>(tet)]) {
        const Vec3 x = far + f * scene.body.mesh().rest[static_cast<size_t>(v)];
        Float4& p = state.body.x[static_cast<size_t>(v)];
        p = {static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z()), p.w};
    }
}

TEST(StretchBound, NeverPassesWhatIsStretched) {
    const Scene scene = box_scene(block());
    State state(scene, 1);
    const StretchLimits limits(scene.body.spec().materials);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    int below = 0, passed = 0, close = 0;
    for (int n = 0; n < 20000; ++n) {
        const int tet = n % scene.body.tet_count();
        Mat3 f;
        for (int i = 0; i < 9; ++i) f(i) = uniform(random);
        deform(scene, state, tet, Mat3::Identity() + 0.4 * f);
        const double stretch = principal_stretch(scene, state, tet);
        const std::array<int32_t, 1> tets{tet};
        const bool says = surely_below(scene.body, state.body, tets, limits) == 1;
        if (stretch >= 1.3) {
            EXPECT_FALSE(says) << "stretch " << stretch;
        }
        if (stretch >= 1.29 && stretch < 1.3) ++close;
        if (stretch < 1.1) ++below;
        if (stretch < 1.1 && says) ++passed;
    }
    EXPECT_GT(close, 20);  // or the limit was not tried
    EXPECT_GT(below, 500);
    EXPECT_GT(passed, 0.9 * below);
}

TEST(StretchBound, EveryTetOfAGroupHasItsOwnAnswer) {
    const Scene scene = box_scene(block());
    State state(scene, 1);
    const StretchLimits limits(scene.body.spec().materials);
    // Tets without a corner in common.
    std::vector<int32_t> apart;
    std::vector<uint8_t> taken(scene.body.mesh().rest.size(), 0);
    for (int t = 0; t < scene.body.tet_count() && apart.size() < 4; ++t) {
        const auto& c = scene.body.mesh().tets[static_cast<size_t>(t)];
        if (std::any_of(c.begin(), c.end(), [&](int32_t v) { return taken[size_t(v)] != 0; }))
            continue;
        for (const int32_t v : c) taken[static_cast<size_t>(v)] = 1;
        apart.push_back(t);
    }
    ASSERT_EQ(apart.size(), 4U);
    for (uint32_t bits = 0; bits < 16; ++bits) {
        for (size_t i = 0; i < 4; ++i) {
            const double stretch = (bits >> i & 1) != 0 ? 1.05 : 1.5;
            deform(scene, state, apart[i], Vec3(stretch, 1, 1).asDiagonal());
        }
        EXPECT_EQ(surely_below(scene.body, state.body, apart, limits), bits);
        const auto three = std::span<const int32_t>(apart).first(3);
        EXPECT_EQ(surely_below(scene.body, state.body, three, limits), bits & 7);
    }
}

TEST(StretchBound, TornAndInvertedTetsAreLookedAtClosely) {
    const Scene scene = box_scene(block());
    State state(scene, 1);
    const StretchLimits limits(scene.body.spec().materials);
    const std::array<int32_t, 1> tets{5};
    for (const Mat3& f :
         {Mat3(Vec3(-1, 1, 1).asDiagonal()), Mat3(Mat3::Zero()), Mat3(1.4 * Mat3::Identity())}) {
        deform(scene, state, 5, f);
        EXPECT_EQ(surely_below(scene.body, state.body, tets, limits), 0U);
    }
    state.body.x[static_cast<size_t>(scene.body.mesh().tets[5][0])].x = std::nanf("");
    EXPECT_EQ(surely_below(scene.body, state.body, tets, limits), 0U);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
