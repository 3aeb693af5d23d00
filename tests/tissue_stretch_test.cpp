// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The mean stretch, by which tissue tears, does not hang on the mesh.

#include "sim/cutting/tissue_stretch.h"

#include <gtest/gtest.h>

#include <functional>

#include "sim/cutting/cutting.h"
#include "tests/box_scene.h"

namespace placode::sim {
namespace THIS_TEST {

constexpr double kRadius = 5e-4;

Scene block(int cells_a_mm, std::function<Tissue(const Vec3&)> tissue_at = {}) {
    test::BoxOptions options;
    options.size_m = Vec3(0.003, 0.003, 0.00025);
    options.cells = {3 * cells_a_mm, 3 * cells_a_mm, cells_a_mm / 4};
    options.tissue_at = std::move(tissue_at);
    options.heat = false;
    return test::box_scene(options);
}

void deform(const Scene& scene, State& state, const std::function<Vec3(const Vec3&)>& to) {
    for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
        const Vec3 x = to(scene.body.mesh().rest[v]);
        state.body.x[v].x = static_cast<float>(x.x());
        state.body.x[v].y = static_cast<float>(x.y());
        state.body.x[v].z = static_cast<float>(x.z());
    }
}

/// Around a line at x = y = 0 strain grows as 1 / sqrt(r): the tip of a cut that is pulled open.
Vec3 tip_field(const Vec3& x) {
    const double r = std::hypot(x.x(), x.y());
    return x + Vec3(0, 0.004 * std::sqrt(r) * (r > 0 ? x.y() / r : 0), 0);
}

struct Peaks {
    double one_tet = 0, mean = 0;
};
Peaks peaks_at_the_tip(int cells_a_mm) {
    const Scene scene = block(cells_a_mm);
    State state(scene, 1);
    deform(scene, state, tip_field);
    Peaks out;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        out.one_tet = std::max(out.one_tet, principal_stretch(scene, state, t));
        // Far from the tip there is no peak.
        if (scene.body.mesh().rest[scene.body.mesh().tets[t][0]].head<2>().norm() < 3e-4)
            out.mean = std::max(out.mean, mean_stretch(scene, state, t, kRadius));
    }
    return out;
}

TEST(TissueStretch, OfAHomogeneousStateTheMeanIsThatOfEveryTet) {
    const Scene scene = block(8);
    State state(scene, 1);
    Mat3 f = Mat3::Identity();
    f(0, 0) = 1.3;
    f(0, 1) = 0.2;
    deform(scene, state, [&](const Vec3& x) { return Vec3(f * x); });
    for (int t = 0; t < scene.body.tet_count(); t += 17) {
        const double one = principal_stretch(scene, state, t);
        EXPECT_NEAR(one, f.jacobiSvd().singularValues()[0], 1e-4) << t;  // floats of 4 mm
        EXPECT_NEAR(mean_stretch(scene, state, t, kRadius), one, 1e-4) << t;
        EXPECT_EQ(mean_stretch(scene, state, t, 0), one) << "no radius: tet by tet";
    }
}

TEST(TissueStretch, AtTheTipOfACutTheMeanDoesNotHangOnTheMesh) {
    const Peaks coarse = peaks_at_the_tip(4), fine = peaks_at_the_tip(8);
    // Strain of one tet grows as 1 / sqrt(edge), by 41 %.
    EXPECT_GT((fine.one_tet - 1) / (coarse.one_tet - 1), 1.3);
    EXPECT_NEAR((fine.mean - 1) / (coarse.mean - 1), 1, 0.08);  // edges are radius / 2 and / 4
}

TEST(TissueStretch, OtherTissueAndWhatLiesBehindACutAreNotAsked) {
    const auto right = [](const Vec3& x) { return x.x() > 1e-9; };
    // Only the right half is stretched.
    const auto pull = [&](const Vec3& x) { return right(x) ? Vec3(x.x(), 1.5 * x.y(), x.z()) : x; };
    const auto most_on_the_left = [&](const Scene& scene, const State& state) {
        double most = 0;
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            double highest = -1;
            for (const int32_t v : scene.body.mesh().tets[static_cast<size_t>(t)])
                highest = std::max(highest, scene.body.mesh().rest[static_cast<size_t>(v)].x());
            if (highest > 1e-9 || state.body.tet_alive[static_cast<size_t>(t)] == 0) continue;
            most = std::max(most, mean_stretch(scene, state, t, kRadius));
        }
        return most;
    };
    const Scene one = block(8);
    State joined(one, 1);
    deform(one, joined, pull);
    EXPECT_GT(most_on_the_left(one, joined), 1.05);

    const Scene two =
        block(8, [&](const Vec3& x) { return right(x) ? Tissue::kSkin : Tissue::kZone; });
    State border(two, 1);
    deform(two, border, pull);
    EXPECT_NEAR(most_on_the_left(two, border), 1, 1e-4);

    State cut(one, 1);
    deform(one, cut, pull);
    for (int t = 0; t < one.body.tet_count(); ++t) {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : one.body.mesh().tets[static_cast<size_t>(t)])
            sum += one.body.mesh().rest[static_cast<size_t>(v)];
        if (sum.x() > 0 && sum.x() / 4 < 2e-4) take_out(one, cut, t);
    }
    EXPECT_NEAR(most_on_the_left(one, cut), 1, 1e-4);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
