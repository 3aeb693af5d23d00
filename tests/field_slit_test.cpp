// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A slit in the skin of a pad: its mesh, its walls, how far they stand apart.
#include "sim/anatomy/field_slit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "sim/anatomy/operative_field.h"
#include "sim/contact/self_contact.h"
#include "sim/contact/slit_gap.h"
#include "sim/core/as_index.h"
#include "sim/step/slit_when_let_go.h"
#include "sim/step/step.h"
#include "sim/world/state.h"
#include "tests/slit_pad.h"
#include "tests/undermine_pad.h"

namespace placode::sim {
namespace THIS_TEST {

using test::kHalfM, test::kWidthM, test::pad;

/// The pad, built once: a test changes only its states.
const std::shared_ptr<const Scene>& pad_scene() {
    static const std::shared_ptr<const Scene> scene = build_operative_field(pad());
    return scene;
}

std::string refusal(const OperativeFieldSpec& spec) {
    try {
        (void)build_operative_field(spec);
    } catch (const MeshError& error) {
        return error.what();
    }
    return {};
}

double volume_of(const TetMesh& mesh) {
    double sum = 0;
    for (size_t t = 0; t < mesh.tets.size(); ++t) sum += rest_volume(mesh, static_cast<int>(t));
    return sum;
}

TEST(FieldSlit, TheSlitIsAnEllipseThroughTheSkin) {
    const auto& scene = pad_scene();
    OperativeFieldSpec whole = pad();
    whole.slit.reset();
    const auto closed = build_operative_field(whole);
    const double missing = volume_of(closed->body.mesh()) - volume_of(scene->body.mesh());
    // Both layers of skin are 0.8 mm; chords of 0.5 mm cut off 4 % of the ellipse.
    const double ellipse = 3.14159265 * kHalfM * kWidthM / 2 * 0.0008;
    EXPECT_NEAR(missing, ellipse, 0.05 * ellipse);
    double least = 1;
    for (size_t t = 0; t < scene->body.mesh().tets.size(); ++t)
        least = std::min(least, tet_quality(scene->body.mesh(), static_cast<int>(t)));
    EXPECT_GT(least, 0.1);
    EXPECT_FALSE(closed->slit.present());
    EXPECT_TRUE(slit_events(*closed, State(*closed, 1)).empty());
    EXPECT_EQ(nearest_station(*closed, Vec2(0.009, 0)), -1);
}

TEST(FieldSlit, OnlyTheRowNextToTheSidesHangsOnThem) {
    const OperativeFieldSpec spec = pad();
    const auto& scene = pad_scene();
    size_t hang = 0;
    for (const auto& spring : scene->body.spec().springs) {
        ASSERT_GE(spring.vertex, 0) << "a column in the opening has no vertex at the surface";
        if (spring.normal_n_m != 0)
            continue;  // the bed's press along their normal, the sides' do not
        ++hang;
        const Vec3& at = scene->body.mesh().rest[static_cast<size_t>(spring.vertex)];
        const double to_side = std::min(spec.domain_x_m / 2 - std::abs(at.x()),
                                        spec.domain_y_m / 2 - std::abs(at.y()));
        EXPECT_LT(to_side, 2 * spec.edge_outer_m);
    }
    EXPECT_GT(hang, 100U);
}

TEST(FieldSlit, StationsStandOppositeAndTheirWallsAreSurface) {
    const auto& scene = pad_scene();
    const State state(*scene, 1);
    const auto& rest = scene->body.mesh().rest;
    const Slit& slit = scene->slit;
    ASSERT_EQ(slit.layers, 2);
    ASSERT_GT(slit.stations.size(), 20U);
    double last_y = -1;
    for (const Slit::Station& s : slit.stations) {
        for (size_t level = 0; level < 3; ++level) {
            const Vec3 left = rest[static_cast<size_t>(s.left[level])],
                       right = rest[static_cast<size_t>(s.right[level])];
            // Walking along +y the left wall lies at smaller x. Points lie on a grid of 1 nm.
            EXPECT_LT(left.x(), right.x());
            EXPECT_NEAR(left.x() + right.x(), 0.018, 3e-9);
            EXPECT_NEAR(left.y(), right.y(), 3e-9);
            EXPECT_EQ(slit.side_of(s.left[level]), level < 2 ? 1 : 0);
            EXPECT_EQ(slit.side_of(s.right[level]), level < 2 ? -1 : 0);
        }
        EXPECT_EQ(s.left[3], -1);
        EXPECT_GT(rest[static_cast<size_t>(s.left[0])].y(), last_y);
        last_y = rest[static_cast<size_t>(s.left[0])].y();
    }
    // Walls and floor are drawn as a wound; their area: both walls, 0.8 mm high, and the ellipse.
    double wound = 0;
    for (const SurfaceTriangle& face : state.surface.triangles()) {
        if (face.fresh == 0) continue;
        std::array<Vec3, 3> p;
        for (size_t k = 0; k < 3; ++k) p[k] = rest[static_cast<size_t>(face.vertex[k])];
        wound += (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
    }
    const double walls = 2 * 0.01214 * 0.0008, floor = 3.14159265 * kHalfM * kWidthM / 2;
    EXPECT_NEAR(wound, walls + floor, 0.03 * (walls + floor));
    // Every wall vertex belongs to faces that look into the slit.
    std::vector<uint8_t> on_surface(rest.size(), 0);
    for (const SurfaceTriangle& face : state.surface.triangles())
        for (const int32_t v : face.vertex) on_surface[static_cast<size_t>(v)] = 1;
    for (size_t v = 0; v < rest.size(); ++v) {
        if (slit.side_of(static_cast<int32_t>(v)) == 0) continue;
        EXPECT_EQ(on_surface[v], 1);
    }
}

TEST(FieldSlit, TheGapAtRestIsTheWidthOfTheEllipse) {
    const auto& scene = pad_scene();
    const State state(*scene, 1);
    for (const double y : {-0.004, -0.002, 0.0, 0.003, 0.005}) {
        const int station = nearest_station(*scene, Vec2(0.009, y));
        const auto& s = scene->slit.stations.at(static_cast<size_t>(station));
        const double at = scene->body.mesh().rest[static_cast<size_t>(s.left[0])].y();
        EXPECT_NEAR(at, y, 0.0003);
        const double width = kWidthM * std::sqrt(1 - at * at / (kHalfM * kHalfM));
        // To the nearest place of the other wall, which near the tips is not the one opposite.
        EXPECT_NEAR(slit_gap(*scene, state, station, 0), width - kTissueGapM, 0.015 * width);
        EXPECT_NEAR(slit_gap(*scene, state, station, 1), width - kTissueGapM, 0.015 * width);
        EXPECT_LE(narrowest_gap(*scene, state, station), slit_gap(*scene, state, station, 0));
    }
}

TEST(FieldSlit, WallsMovedTogetherAreShutAndThoseThatPassedEachOtherToo) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    const int station = nearest_station(*scene, Vec2(0.009, 0));
    const auto shift = [&](double path) {
        for (size_t v = 0; v < scene->body.mesh().rest.size(); ++v) {
            const int side = scene->slit.side_of(static_cast<int32_t>(v));
            state.body.x[v].x = static_cast<float>(scene->body.mesh().rest[v].x() + side * path);
        }
    };
    shift(0.0004);
    EXPECT_NEAR(slit_gap(*scene, state, station, 0), kWidthM - 0.0008 - kTissueGapM, 2e-6);
    shift(0.00048);
    EXPECT_EQ(slit_gap(*scene, state, station, 0), 0);
    shift(0.00055);
    EXPECT_EQ(narrowest_gap(*scene, state, station), 0);
}

TEST(FieldSlit, EdgesThatRideOverEachOtherShutNothing) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    const int station = nearest_station(*scene, Vec2(0.009, 0));
    // The left wall 1 mm past the right one and 0.5 mm up.
    for (size_t v = 0; v < scene->body.mesh().rest.size(); ++v) {
        if (scene->slit.side_of(static_cast<int32_t>(v)) <= 0) continue;
        const Vec3& at = scene->body.mesh().rest[v];
        state.body.x[v].x = static_cast<float>(at.x() + kWidthM + 0.001);
        state.body.x[v].z = static_cast<float>(at.z() + 0.0005);
    }
    EXPECT_GT(narrowest_gap(*scene, state, station), 0.0009);
    EXPECT_LT(narrowest_gap(*scene, state, station), 0.001);
    EXPECT_GT(slit_events(*scene, state).at(static_cast<size_t>(station) + 1).value, 0.0009F);
}

/// Both walls, until they touch.
void push_together(const Scene& scene, State& state) {
    for (size_t v = 0; v < scene.body.mesh().rest.size(); ++v) {
        const int side = scene.slit.side_of(static_cast<int32_t>(v));
        state.body.x[v].x =
            static_cast<float>(scene.body.mesh().rest[v].x() + side * 0.48 * kWidthM);
    }
}

TEST(FieldSlit, ATornWallIsOpenHoweverNearItsRagsLie) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    push_together(*scene, state);
    const auto before = slit_events(*scene, state);
    const auto shut = static_cast<size_t>(nearest_station(*scene, Vec2(0.009, 0)));
    EXPECT_EQ(before.at(shut + 1).value, 0);
    // One tetrahedron of a wall: the surface there, then below it too.
    for (int level = 0; level < scene->slit.layers; ++level) {
        const int32_t wall = scene->slit.stations[shut].left[static_cast<size_t>(level)];
        remove_tet(scene->body, state.body, scene->body.tets_of(wall).front());
    }
    const auto torn = slit_events(*scene, state);
    ASSERT_EQ(torn.size(), before.size());
    EXPECT_NEAR(torn[shut + 1].value, kWidthM - kTissueGapM, 0.015 * kWidthM);
    EXPECT_NEAR(torn[shut + 1].value2, kWidthM - kTissueGapM, 0.015 * kWidthM);
    for (size_t i = 1; i < torn.size(); ++i)
        EXPECT_GE(torn[i].value, before[i].value) << "tearing closes nothing, station " << i;
    // No thread is drawn tight by tearing out the wall between the marks.
    EXPECT_NEAR(narrowest_gap(*scene, state, static_cast<int>(shut)), kWidthM - kTissueGapM,
                0.015 * kWidthM);
    // And fluid is not stopped by rags of the floor.
    const int station = static_cast<int>(shut), floor = scene->slit.layers;
    const int32_t left = scene->slit.stations[shut].left[static_cast<size_t>(floor)],
                  right = scene->slit.stations[shut].right[static_cast<size_t>(floor)];
    state.body.x[static_cast<size_t>(left)] = state.body.x[static_cast<size_t>(right)];
    for (const int32_t t : scene->body.tets_of(left))
        if (state.body.tet_alive[as_index(t)] != 0) remove_tet(scene->body, state.body, t);
    EXPECT_NEAR(open_gap(*scene, state, station, floor), kWidthM - kTissueGapM, 0.015 * kWidthM);
}

TEST(FieldSlit, AWallThatIsNowhereIsOpen) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    push_together(*scene, state);
    const auto lost = static_cast<size_t>(nearest_station(*scene, Vec2(0.009, 0)));
    for (int level = 0; level < scene->slit.layers; ++level)
        state.body.x[static_cast<size_t>(scene->slit.stations[lost].left[as_index(level)])].x =
            std::numeric_limits<float>::quiet_NaN();
    const auto told = slit_events(*scene, state);
    EXPECT_NEAR(told.at(lost + 1).value, kWidthM - kTissueGapM, 0.015 * kWidthM);
    for (const Event& e : told) EXPECT_TRUE(std::isfinite(e.value)) << e.element;
    EXPECT_GT(narrowest_gap(*scene, state, static_cast<int>(lost)), 0.9 * kWidthM);
}

TEST(FieldSlit, APlaceLiesInTheSlitOrBesideIt) {
    const auto& scene = pad_scene();
    for (const double y : {-0.005, 0.0, 0.0041}) {
        const double half = kWidthM / 2 * std::sqrt(1 - y * y / (kHalfM * kHalfM));
        EXPECT_TRUE(in_slit(*scene, Vec2(0.009, y)));
        EXPECT_TRUE(in_slit(*scene, Vec2(0.009 + half, y))) << "on its wall";
        EXPECT_FALSE(in_slit(*scene, Vec2(0.009 + half + 0.0003, y)));
        EXPECT_FALSE(in_slit(*scene, Vec2(0.009 - half - 0.0003, y)));
    }
    EXPECT_FALSE(in_slit(*scene, Vec2(0.009, 0.0075))) << "beyond its tip";
    EXPECT_FALSE(in_slit(*scene, Vec2(0.00565, 0.004))) << "at a mark of the task";
}

TEST(FieldSlit, BetweenTwoStationsAWallRunsStraight) {
    const std::shared_ptr<const Scene> wide = build_operative_field(test::undermine_pad());
    const auto at = [&](int32_t v) -> Vec2 {
        return wide->body.mesh().rest[static_cast<size_t>(v)].head<2>();
    };
    const std::vector<Slit::Station>& stations = wide->slit.stations;
    for (size_t i = 0; i + 1 < stations.size(); ++i) {
        const Slit::Station &a = stations[i], &b = stations[i + 1];
        for (const double share : {0.0, 0.3, 0.7, 1.0}) {
            const Vec2 left = at(a.left[0]) + share * (at(b.left[0]) - at(a.left[0])),
                       right = at(a.right[0]) + share * (at(b.right[0]) - at(a.right[0]));
            const Vec2 out = (left - right).normalized() * 0.0003;
            for (const Vec2& wall : {left, right})
                EXPECT_TRUE(in_slit(*wide, wall)) << i << " and " << share;
            EXPECT_FALSE(in_slit(*wide, left + out)) << i << " and " << share;
            EXPECT_FALSE(in_slit(*wide, right - out)) << i << " and " << share;
        }
    }
}

TEST(FieldSlit, APlaceLiesOnTheUndersideOfSkinThatCanBeUndermined) {
    const std::shared_ptr<const Scene> wide = build_operative_field(test::undermine_pad());
    const double floor_m = -depth_at_rest(*wide, 5, 3);
    EXPECT_TRUE(below_skin(*wide, Vec3(0.0105, 0.004, floor_m)));
    EXPECT_TRUE(below_skin(*wide, Vec3(0.0105, -0.004, 0.6 * floor_m)));
    EXPECT_FALSE(below_skin(*wide, Vec3(0.0105, 0.004, 0.4 * floor_m)));
    EXPECT_FALSE(below_skin(*wide, Vec3(0.0105, 0.004, 0)));
    EXPECT_FALSE(below_skin(*pad_scene(), Vec3(0.009, 0.002, -0.0015))) << "nothing parts there";
}

/// The left wall is moved across the slit and on, as no thread could: the right one gives way.
TEST(FieldSlit, AWallDoesNotPassThroughTheOther) {
    const auto& scene = pad_scene();
    State state(*scene, 1);
    settle(*scene, state, 0.1);
    const std::array<ToolInput, kMaxTools> nobody{};
    std::array<ToolFeedback, kMaxTools> feedback{};
    const size_t tools = scene->tools.size();
    const int station = nearest_station(*scene, Vec2(0.009, 0));
    const Slit::Station& middle = scene->slit.stations.at(static_cast<size_t>(station));
    const double at_rest = position(state.body, middle.right[0]).x();
    double deepest = 0;
    for (int frame = 0; frame < 200; ++frame) {
        for (size_t v = 0; v < scene->body.mesh().rest.size(); ++v) {
            if (scene->slit.side_of(static_cast<int32_t>(v)) <= 0) continue;
            state.body.x[v].w = 0;  // held, and led by 1 mm in 0.1 s
            if (frame < 100) state.body.x[v].x += 1.2e-5F;
        }
        (void)step(*scene, state, {nobody.data(), tools}, {feedback.data(), tools});
        for (size_t i = 4; i + 4 < scene->slit.stations.size(); ++i) {
            const Slit::Station& s = scene->slit.stations[i];
            for (size_t level = 0; level < 2; ++level)
                deepest = std::max(deepest, (position(state.body, s.left[level]) -
                                             position(state.body, s.right[level]))
                                                .x());
        }
    }
    EXPECT_EQ(state.flags & kNotFinite, 0U);
    EXPECT_LT(deepest, kTissueGapM);
    EXPECT_EQ(narrowest_gap(*scene, state, station), 0);
    // 1.2 mm less the slit's own width of 1 mm, and the gap of the contact.
    EXPECT_NEAR(position(state.body, middle.right[0]).x() - at_rest, 0.0002, 0.0001);
}

TEST(FieldSlit, WhatIsLeftWhenHandsLetGoDependsOnTheStateAlone) {
    const auto& scene = pad_scene();
    State one(*scene, 1), two(*scene, 2);
    two.substeps = one.substeps + 3;  // chosen for a frame that never came
    const std::vector<Event> from_one = slit_when_let_go(*scene, one),
                             from_two = slit_when_let_go(*scene, two);
    ASSERT_EQ(from_one.size(), scene->slit.stations.size() + 1);
    ASSERT_EQ(from_two.size(), from_one.size());
    EXPECT_EQ(from_one[0].element, -1);
    EXPECT_EQ(from_one[0].value, static_cast<float>(scene->slit.stations.size()));
    for (size_t i = 0; i < from_one.size(); ++i) {
        EXPECT_EQ(from_one[i].value, from_two[i].value);
        EXPECT_EQ(from_one[i].value2, from_two[i].value2);
    }
    EXPECT_EQ(one.frame, 0) << "the state itself goes on as if nobody had looked";
}

TEST(FieldSlit, WhatCannotBeBuiltIsRefusedWithFieldAndValue) {
    OperativeFieldSpec spec = pad();
    spec.slit->width_m = 0.0005;
    EXPECT_NE(refusal(spec).find("slit.width_m = 0.0005, allowed 0.00075 to 0.01"),
              std::string::npos)
        << refusal(spec);
    spec = pad();
    spec.slit->layers = 4;
    EXPECT_NE(refusal(spec).find("slit.layers = 4, allowed 1 to 3"), std::string::npos);
    spec = pad();
    spec.slit->to_m = Vec2(0.009, 0.0075);
    EXPECT_NE(refusal(spec).find("slit: the field's side is"), std::string::npos) << refusal(spec);
    spec = pad();
    spec.slit->from_m = Vec2(0.002, 0);
    EXPECT_NE(refusal(spec).find("slit: the lesion's skin edge"), std::string::npos)
        << refusal(spec);
    spec = pad();
    spec.slit->to_m = spec.slit->from_m;
    EXPECT_NE(refusal(spec).find("slit: length = 0"), std::string::npos) << refusal(spec);
    spec = pad();
    spec.slit->width_m = std::nan("");
    EXPECT_NE(refusal(spec).find("slit.width_m"), std::string::npos);
    spec = pad();
    spec.contact.self_contact = false;
    EXPECT_NE(refusal(spec).find("contact.self_contact: false"), std::string::npos);
}

/// Slits of any direction, length, width and depth give a mesh that can be simulated.
TEST(FieldSlit, AnySlitThatFitsIsMeshed) {
    for (int i = 0; i < 12; ++i) {
        OperativeFieldSpec spec = pad();
        spec.domain_x_m = 0.03;
        spec.domain_y_m = 0.03;
        const double angle = 0.5 * i, half = 0.002 + 0.0003 * i;
        const Vec2 middle(0.0085, -0.0075), along(std::cos(angle), std::sin(angle));
        spec.slit = FieldSlit{middle - half * along, middle + half * along, 0.0008 + 0.0001 * i,
                              1 + i % 3, 0.0005};
        if (i % 2 == 1) spec.slit->edge_m = 0.0003;
        std::shared_ptr<const Scene> scene;
        ASSERT_NO_THROW(scene = build_operative_field(spec)) << i;
        double least = 1;
        for (size_t t = 0; t < scene->body.mesh().tets.size(); ++t)
            least = std::min(least, tet_quality(scene->body.mesh(), static_cast<int>(t)));
        EXPECT_GT(least, 0.05) << i;
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
