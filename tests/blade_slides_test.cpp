// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices slide to where blades pass: the edge of the cut is the blades' path, the tissue stays
// where it is, and the mesh stays sound.

#include "sim/cutting/blade_slides.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sim/anatomy/operative_field.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/tissue_stretch.h"
#include "sim/solver/slide_vertex.h"
#include "sim/verify/cut_rim.h"
#include "sim/world/saved_state.h"
#include "tests/box_scene.h"
#include "tests/cut_checks.h"

namespace placode::sim {
namespace THIS_TEST {

using test::at;
using test::blades;
using test::BoxOptions;

BoxOptions slab(Method method = Method::kVbd) {
    return test::scissors_sheet(Vec3(0.006, 0.006, 0.0015), {12, 12, 3}, 2600, method);
}

/// Opens and closes within `frames`.
void snip(const Scene& scene, State& state, const Pose& pose, int frames = 40) {
    ToolInput input;
    input.set_pose(pose);
    input.engaged = 1;
    ToolFeedback feedback;
    input.jaw_rad = 0;
    test::frame(scene, state, input, feedback);
    for (int i = 0; i <= frames; ++i) {
        input.jaw_rad = 0.7F * static_cast<float>(frames - i) / static_cast<float>(frames);
        test::frame(scene, state, input, feedback);
    }
    for (int i = 0; i < 30; ++i) test::frame(scene, state, input, feedback);
}

/// A slide of a random vertex into a random tet around it.
Slide random_slide(const Scene& scene, const State& state, std::mt19937& random) {
    std::uniform_real_distribution<float> share(0, 0.2F);
    const auto vertices = static_cast<unsigned>(state.body.topology->vertices);
    const auto v = static_cast<int>(random() % vertices);
    const auto around = tets_around(scene.body, state.body, v);
    const auto& c = corners(scene.body, state.body, around[random() % around.size()]);
    Slide slide;
    slide.vertex = v;
    size_t n = 0;
    for (const int32_t other : c) {
        if (other == v) continue;
        slide.towards[n] = other;
        slide.share[n++] = share(random);
    }
    return slide;
}

TEST(SlideVertex, LeavesForcesThatTheTetsHaveOneByOne) {
    for (const Method method : {Method::kVbd, Method::kXpbd}) {
        const Scene scene = test::box_scene(slab(method));
        State state(scene, 1);
        std::mt19937 random(3);
        std::normal_distribution<float> shake(0, 2e-5F);
        for (Float4& x : state.body.x) {
            x.x = 1.1F * x.x + shake(random);
            x.y += shake(random);
            x.z += shake(random);
        }
        int slides = 0;
        for (int i = 0; i < 400; ++i)
            slides += slide_vertex(scene.body, state.body, random_slide(scene, state, random),
                                   SlideLimits{});
        EXPECT_GT(slides, 200);
        double largest = 0, worst = 0;
        for (int v = 0; v < state.body.topology->vertices; ++v) {
            const Vec3 by_tets = test::force_by_tets(scene, state, v);
            largest = std::max(largest, by_tets.norm());
            worst = std::max(worst, (elastic_force(scene.body, state.body, v) - by_tets).norm());
        }
        // Constants are floats.
        EXPECT_LT(worst, 1e-5 * largest);
    }
}

TEST(SlideVertex, LeavesTheTissueWhereItIs) {
    // Sheared and stretched alike everywhere: whatever vertices do, F stays, and the material at
    // every place stays.
    const Scene scene = test::box_scene(slab());
    State state(scene, 1);
    Mat3 f;
    f << 1.15, 0.2, 0, -0.1, 0.95, 0.05, 0, 0.1, 0.98;
    for (int v = 0; v < state.body.topology->vertices; ++v) {
        const Vec3f x = (f * rest_place(scene.body, state.body, v)).cast<float>();
        state.body.x[static_cast<size_t>(v)].x = x.x();
        state.body.x[static_cast<size_t>(v)].y = x.y();
        state.body.x[static_cast<size_t>(v)].z = x.z();
    }
    const auto mass = [&] {
        double sum = 0;
        for (int v = 0; v < state.body.topology->vertices; ++v)
            sum += static_cast<double>(mass_of(scene.body, state.body, v));
        return sum;
    };
    const double before_kg = mass(), before_m3 = test::living_volume(scene, state);
    std::mt19937 random(4);
    int slides = 0;
    for (int i = 0; i < 2000; ++i) {
        const Slide slide = random_slide(scene, state, random);
        // Inner ones: the outline of the box is to stay.
        const Vec3 p = rest_place(scene.body, state.body, slide.vertex);
        if (std::abs(p.x()) > 0.0028 || std::abs(p.y()) > 0.0028 || p.z() > -2e-4 ||
            p.z() < -0.0013)
            continue;
        slides += slide_vertex(scene.body, state.body, slide, SlideLimits{});
    }
    EXPECT_GT(slides, 100);
    for (int v = 0; v < state.body.topology->vertices; ++v)
        EXPECT_LT((at(state, v) - f * rest_place(scene.body, state.body, v)).norm(), 2e-9);
    EXPECT_NEAR(mass() / before_kg, 1, 1e-6);
    EXPECT_NEAR(test::living_volume(scene, state) / before_m3, 1, 1e-6);
    for (int t = 0; t < scene.body.tet_count(); ++t)
        EXPECT_NEAR(
            principal_stretch(scene, state, t),
            std::sqrt(
                Eigen::SelfAdjointEigenSolver<Mat3>(f.transpose() * f).eigenvalues().maxCoeff()),
            1e-4);
}

TEST(SlideVertex, RefusesWhatWouldFlattenTurnOrLoosenATet) {
    BoxOptions options = slab();
    options.hold_bottom = true;
    const Scene scene = test::box_scene(options);
    State state(scene, 1);
    std::mt19937 random(5);
    for (int i = 0; i < 5000; ++i) {
        Slide slide = random_slide(scene, state, random);
        for (float& share : slide.share) share *= 2;
        const Vec3 rest = rest_place(scene.body, state.body, slide.vertex);
        const bool held = !can_split(state.body, slide.vertex);
        const bool slid = slide_vertex(scene.body, state.body, slide, SlideLimits{});
        EXPECT_FALSE(held && slid);
        if (!slid) {
            EXPECT_EQ(rest, rest_place(scene.body, state.body, slide.vertex));
        }
    }
    EXPECT_GE(least_quality(scene.body, state.body), SlideLimits{}.least_quality - 1e-9);
    for (int t = 0; t < scene.body.tet_count(); ++t)
        ASSERT_GE(static_cast<double>(rest_volume_of(scene.body, state.body, t)),
                  (SlideLimits{}.least_volume - 1e-6) * rest_volume(scene.body.mesh(), t));
    // Neighbours only.
    const Slide far{0, {scene.body.vertex_count() - 1, -1, -1}, {0.1F, 0, 0}};
    EXPECT_FALSE(slide_vertex(scene.body, state.body, far, SlideLimits{}));
}

/// Snips along the planned incision of the default field; root mean square of their rims [mm].
double rim_rms_mm(double snap, double* quality = nullptr) {
    OperativeFieldSpec spec;
    spec.heat = false;
    spec.cut_snap = snap;
    spec.tools.push_back(slab().tool);
    spec.tools[0].tip_length_m = 0.006;
    const auto scene = build_operative_field(spec);
    double square_sum = 0, points = 0;
    for (int i = 0; i < 8; ++i) {
        State state(*scene, 2);
        const auto& contour = scene->geometry.planned_contour;
        const size_t k = contour.size() * static_cast<size_t>(i) / 8;
        const Vec3 along = contour[(k + 1) % contour.size()] - contour[k];
        const double angle = std::atan2(along.y(), along.x()) + 0.15 * (i - 4);
        const Vec3 ahead(std::cos(angle), std::sin(angle), 0);
        const Vec3 tip = contour[k] + 0.003 * ahead - 0.0003 * Vec3::UnitZ();
        snip(*scene, state, blades(tip, ahead, Vec3::UnitZ()));
        EXPECT_GT(state.splits, 0);
        for (const auto& point : cut_rim_mm(*scene, state, tip, ahead)) {
            square_sum += point[1] * point[1];
            ++points;
        }
        if (quality != nullptr)
            *quality = std::min(*quality, least_quality(scene->body, state.body));
    }
    return std::sqrt(square_sum / points);
}

TEST(BladeSlides, PutTheRimOfACutOntoTheBladesPath) {
    double quality = 1;
    const double with = rim_rms_mm(0.65, &quality), without = rim_rms_mm(0);
    EXPECT_LT(with, 0.06);
    EXPECT_LT(with, 0.35 * without);
    EXPECT_GE(quality, SlideLimits{}.least_quality - 1e-9);
}

TEST(BladeSlides, RandomCutsKeepTheMeshSoundAndTheBitsWithAnyThreads) {
    std::array<uint64_t, 2> hash{};
    for (const int threads : {1, 3}) {
        for (const Method method : {Method::kVbd, Method::kXpbd}) {
            Scene scene = test::box_scene(slab(method));
            scene.cut_snap = 0.65;
            State state(scene, threads);
            std::mt19937 random(11);
            std::uniform_real_distribution<double> unit(-1, 1);
            const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
            for (int i = 0; i < 50; ++i) {
                const Vec3 middle(0.003 * unit(random), 0.003 * unit(random), -0.0008);
                snip(scene, state, blades(middle, vector(), vector()), 6);
                ASSERT_EQ(state.flags & (kCutRefused | kNotFinite), 0U) << "cut " << i;
            }
            EXPECT_GT(state.slides, 100);
            test::expect_closed_surface(scene, state);
            test::expect_whole_vertices(scene, state);
            EXPECT_GE(least_quality(scene.body, state.body), SlideLimits{}.least_quality - 1e-9);
            uint64_t& kept = hash[method == Method::kVbd ? 0 : 1];
            const uint64_t now = whole_hash(state);
            if (threads == 1) kept = now;
            EXPECT_EQ(now, kept);
        }
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
