// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What hangs together: loose pieces, crumbs, the way out of the field, release by sectors.

#include "sim/cutting/pieces.h"
#include "sim/cutting/grasp.h"
#include "sim/world/add_event.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "sim/cutting/cutting.h"
#include "sim/cutting/separation.h"
#include "sim/solver/topology.h"
#include "tests/cut_field.h"

namespace placode::sim {
namespace THIS_TEST {

using test::BoxOptions;
using test::upright;

BoxOptions block() { return test::grasped_block(Vec3(0.008, 0.008, 0.002), {16, 16, 4}); }

struct Field : test::CutField {
    explicit Field(Scene made) : CutField(std::move(made), 1) {}

    /// Moves the tip at 0.1 m/s.
    void move(const Vec3& from, const Vec3& to, double jaw) {
        const int frames = static_cast<int>((to - from).norm() / 1e-4) + 1;
        for (int i = 1; i <= frames; ++i) {
            run(from + static_cast<double>(i) / frames * (to - from), jaw, 1);
        }
    }
    /// Grasps what lies at `touch` and draws it out of the field.
    void draw_out(const Vec3& touch) {
        const Vec3 away(0, 0, 0.010), out(0, 0, 0.040);
        move(away, touch, 0.6);
        const double closed = 0.5 * grip_angle(scene.tools[0]);
        for (double jaw = 0.6; jaw > closed; jaw -= 0.01) run(touch, jaw, 1);
        run(touch, closed, 50);
        move(touch, out, closed);
        run(out, closed, 100);
    }
    /// Rest volume of a tissue that the ledger says is lost [m^3].
    [[nodiscard]] double lost(Tissue tissue) const {
        double sum = 0;
        for (const Event& e : events)
            if (e.kind == EventKind::kTorn && e.tissue == tissue)
                sum += static_cast<double>(e.value);
        return sum;
    }
    [[nodiscard]] double placode_lost() const { return lost(Tissue::kPlacode); }
    [[nodiscard]] int count(EventKind kind) const {
        int n = 0;
        for (const Event& e : events) n += e.kind == kind ? 1 : 0;
        return n;
    }
    [[nodiscard]] double height(const std::function<bool(const Vec3&)>& inside) const {
        double sum = 0;
        int n = 0;
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            if (!state.body.tet_alive[static_cast<size_t>(t)]) continue;
            if (!inside(rest_centroid(scene, t))) continue;
            for (const int32_t v : corners(scene.body, state.body, t)) {
                sum += static_cast<double>(state.body.x[static_cast<size_t>(v)].z);
                ++n;
            }
        }
        return n > 0 ? sum / n : 0;
    }
};

bool in_patch(const Vec3& p) {
    return std::abs(p.x()) < 0.0015 && std::abs(p.y()) < 0.0015 && p.z() > -0.001;
}

TEST(Pieces, APatchCutOutStaysUntilJawsTakeItOutOfTheField) {
    Field field(test::box_scene(block()));
    const Vec3 away(0, 0, 0.010), touch(0, 0, 0.0001), out(0, 0, 0.040);
    field.run(away, 0.6, 5);
    EXPECT_EQ(field.count(EventKind::kPieceFree), 0);
    const double before = field.height(in_patch);
    field.cut_out(in_patch);
    field.run(away, 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
    EXPECT_EQ(field.count(EventKind::kCrumb), 0);
    // Wet tissue sticks where it lies: in 0.2 s it would have fallen 0.2 m.
    EXPECT_NEAR(field.height(in_patch), before, 5e-5);
    // 3 x 3 x 1 mm, with the zigzag of the mesh at its sides.
    EXPECT_NEAR(field.state.pieces.list[0].volume_m3, 9e-9, 3e-9);
    field.move(away, touch, 0.6);
    const double closed = 0.5 * grip_angle(field.scene.tools[0]);
    for (double jaw = 0.6; jaw > closed; jaw -= 0.01) field.run(touch, jaw, 1);
    field.run(touch, closed, 50);
    ASSERT_GT(field.state.grasps[0].count, 0);
    field.move(touch, Vec3(0, 0, 0.005), closed);
    EXPECT_GT(field.height(in_patch), 0.003);  // it has come along, and nothing else has
    EXPECT_LT(std::abs(field.height([](const Vec3& p) { return std::abs(p.x()) > 0.003; }) + 0.001),
              2e-4);
    field.move(Vec3(0, 0, 0.005), out, closed);
    field.run(out, closed, 100);
    EXPECT_EQ(field.count(EventKind::kPieceOut), 1);
    EXPECT_EQ(field.state.pieces.out, 1);
    EXPECT_EQ(field.state.grasps[0].count, 0);
    for (int t = 0; t < field.scene.body.tet_count(); ++t) {
        EXPECT_EQ(field.state.body.tet_alive[static_cast<size_t>(t)] == 0,
                  in_patch(rest_centroid(field.scene, t)));
    }
}

TEST(Pieces, ACrumbIsWashedAway) {
    Field field(test::box_scene(block()));
    const auto crumb = [](const Vec3& p) { return p.head<2>().norm() < 0.0004 && p.z() > -0.0005; };
    field.cut_out(crumb);
    field.run(Vec3(0, 0, 0.02), 0.6, 200);
    EXPECT_GE(field.count(EventKind::kCrumb), 1);
    for (int t = 0; t < field.scene.body.tet_count(); ++t) {
        EXPECT_EQ(field.state.body.tet_alive[static_cast<size_t>(t)] == 0,
                  crumb(rest_centroid(field.scene, t)));
    }
}

TEST(Pieces, WhatHangsByOneFaceIsNotLoose) {
    Field field(test::box_scene(block()));
    // All faces but one.
    int spared = 0;
    for (int t = 0; t < field.scene.body.tet_count(); ++t) {
        if (!in_patch(rest_centroid(field.scene, t))) continue;
        for (int f = 0; f < 4; ++f) {
            const int other =
                field.scene.surface.neighbours()[static_cast<size_t>(t)][static_cast<size_t>(f)];
            if (other < 0 || in_patch(rest_centroid(field.scene, other))) continue;
            if (spared++ == 0) continue;
            cut_face(field.scene, field.state, t, f);
        }
    }
    ASSERT_GT(spared, 20);
    field.run(Vec3(0, 0, 0.02), 0.6, 200);
    EXPECT_EQ(field.count(EventKind::kPieceFree), 0);
}

/// Placode within 2 mm, skin beyond 3.4 mm, zone between; gel below.
Scene lesion() {
    BoxOptions options = block();
    options.cells = {24, 24, 4};
    SoftBodySpec spec;
    {
        const Scene plain = test::box_scene(options);
        spec = plain.body.spec();
    }
    for (size_t t = 0; t < spec.mesh.tets.size(); ++t) {
        Vec3 centre = Vec3::Zero();
        for (const int32_t v : spec.mesh.tets[t])
            centre += spec.mesh.rest[static_cast<size_t>(v)] / 4;
        const double r = centre.head<2>().norm();
        Tissue& tissue = spec.mesh.tissue[t];
        tissue = r < 0.002 ? Tissue::kPlacode : r > 0.0034 ? Tissue::kSkin : Tissue::kZone;
        if (centre.z() < -0.001) tissue = Tissue::kGel;
    }
    Scene scene{SoftBody(std::move(spec))};
    scene.tools = {options.tool};
    for (int i = 0; i < 60; ++i) {
        const double a = 2 * std::numbers::pi * i / 60;
        scene.geometry.planned_contour.emplace_back(0.0027 * std::cos(a), 0.0027 * std::sin(a), 0);
    }
    for (const Vec3& x : scene.body.mesh().rest) {
        scene.field.depth_m.push_back(static_cast<float>(-x.z()));
    }
    return scene;
}

/// Each half is a piece: the one that stays in the field has not been taken out with the other.
TEST(Pieces, APieceThatIsCutInTwoIsTwo) {
    Field field(test::box_scene(block()));
    // 6 x 3 mm: jaws at 2 mm hold nothing of the half at x < 0.
    const auto wide = [](const Vec3& p) {
        return std::abs(p.x()) < 0.003 && std::abs(p.y()) < 0.0015 && p.z() > -0.001;
    };
    const auto far_half = [&](const Vec3& p) { return wide(p) && p.x() < 0; };
    field.cut_out(wide);
    field.run(Vec3(0, 0, 0.010), 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
    const double whole = field.state.pieces.list[0].volume_m3, lay = field.height(far_half);
    field.cut_out(far_half);
    field.run(Vec3(0, 0, 0.010), 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 2);
    EXPECT_NEAR(field.height(far_half), lay, 5e-5) << "it lies where it lay";
    field.draw_out(Vec3(0.002, 0, 0.0001));
    ASSERT_EQ(field.count(EventKind::kPieceOut), 1);
    EXPECT_NEAR(field.state.pieces.out_m3, whole / 2, whole / 5);
    EXPECT_NEAR(field.height(far_half), lay, 2e-4);
    for (int t = 0; t < field.scene.body.tet_count(); ++t) {
        const bool out =
            wide(rest_centroid(field.scene, t)) && !far_half(rest_centroid(field.scene, t));
        EXPECT_EQ(field.state.body.tet_alive[static_cast<size_t>(t)] == 0, out);
    }
}

/// What lies still is held vertex by vertex: a copy that a cut makes is held, and let go, as well.
TEST(Pieces, APartOfAPieceThatLiesStillCanBeTakenAway) {
    Field field(test::box_scene(block()));
    const auto wide = [](const Vec3& p) {
        return std::abs(p.x()) < 0.003 && std::abs(p.y()) < 0.0015 && p.z() > -0.001;
    };
    field.cut_out(wide);
    field.run(Vec3(0, 0, 0.010), 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
    const int whole = field.state.body.topology->vertices;
    field.cut_out([&](const Vec3& p) { return wide(p) && p.x() < 0; });
    field.run(Vec3(0, 0, 0.010), 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 2);
    ASSERT_GT(field.state.body.topology->vertices, whole);
    for (int v = whole; v < field.state.body.topology->vertices; ++v)
        EXPECT_EQ(field.state.pieces.resting[static_cast<size_t>(v)], 1) << v;
    for (const Piece& piece : field.state.pieces.list) {
        if (piece.tets > 0) {
            EXPECT_EQ(piece.resting, 1);
        }
    }
}

/// Cut off with scissors and carried to the port, nothing of it had torn or burned.
TEST(Pieces, PlacodeThatLeavesWithAPieceIsLost) {
    Field field(lesion());
    field.cut_out(in_patch);
    field.run(Vec3(0, 0, 0.010), 0.6, 200);
    ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
    EXPECT_EQ(field.placode_lost(), 0) << "it lies where it was";
    const double volume = field.state.pieces.list[0].volume_m3;
    field.draw_out(Vec3(0, 0, 0.0001));
    ASSERT_EQ(field.count(EventKind::kPieceOut), 1);
    EXPECT_NEAR(field.placode_lost(), volume, 1e-6 * volume);
}

TEST(Pieces, PlacodeThatIsWashedAwayIsLost) {
    Field field(lesion());
    const auto crumb = [](const Vec3& p) { return p.head<2>().norm() < 0.0004 && p.z() > -0.0005; };
    field.cut_out(crumb);
    field.run(Vec3(0, 0, 0.02), 0.6, 200);
    ASSERT_GE(field.count(EventKind::kCrumb), 1);
    EXPECT_GT(field.placode_lost(), 0);
}

/// Skin that nobody was to remove, carried out as a flap; where it is marked, that is the task.
TEST(Pieces, TissueThatIsNotToGoIsLostWithAPiece) {
    for (const bool marked : {false, true}) {
        Field field(test::box_scene(block()));
        if (marked) {
            field.scene.marked.assign(static_cast<size_t>(field.scene.body.tet_count()), 1);
            field.scene.marked_volume_m3 = 128e-9;
        }
        field.cut_out(in_patch);
        field.run(Vec3(0, 0, 0.010), 0.6, 200);
        ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
        const double volume = field.state.pieces.list[0].volume_m3;
        field.draw_out(Vec3(0, 0, 0.0001));
        ASSERT_EQ(field.count(EventKind::kPieceOut), 1);
        EXPECT_NEAR(field.lost(Tissue::kZone), marked ? 0 : volume, 1e-6 * volume);
    }
}

/// A block that is marked zone at x < 0 and skin at x > 0, of which 1 mm may be cut.
Scene half_marked() {
    const BoxOptions options = block();
    SoftBodySpec spec;
    {
        const Scene plain = test::box_scene(options);
        spec = plain.body.spec();
    }
    const auto at_x = [&](size_t t) {
        double x = 0;
        for (const int32_t v : spec.mesh.tets[t])
            x += spec.mesh.rest[static_cast<size_t>(v)].x() / 4;
        return x;
    };
    std::vector<uint8_t> marked;
    for (size_t t = 0; t < spec.mesh.tets.size(); ++t) {
        marked.push_back(at_x(t) < 0 ? 1 : 0);
        spec.mesh.tissue[t] = at_x(t) < 0 ? Tissue::kZone : Tissue::kSkin;
    }
    Scene scene{SoftBody(std::move(spec))};
    scene.tools = {options.tool};
    scene.marked = std::move(marked);
    scene.marked_volume_m3 = 64e-9;
    for (const Vec3& x : scene.body.mesh().rest)
        scene.field.to_skin_m.push_back(static_cast<float>(x.x()));
    return scene;
}

/// A flap of healthy skin goes with the piece that is to go: what is marked counts as taken out,
/// what lies near it may be cut, the rest is lost. Where nothing tells how far it is from the edge
/// of a lesion, all skin is.
TEST(Pieces, HealthySkinThatLeavesWithMarkedTissueIsLost) {
    for (const bool edge : {true, false}) {
        Field field(half_marked());
        if (!edge) field.scene.field.to_skin_m.clear();
        field.cut_out(in_patch);
        field.run(Vec3(0, 0, 0.010), 0.6, 200);
        ASSERT_EQ(field.count(EventKind::kPieceFree), 1);
        double skin = 0, marked = 0;
        for (int t = 0; t < field.scene.body.tet_count(); ++t) {
            const Vec3 at = rest_centroid(field.scene, t);
            if (!in_patch(at)) continue;
            const double volume =
                static_cast<double>(field.scene.body.volume_m3()[static_cast<size_t>(t)]);
            if (at.x() < 0) marked += volume;
            if (at.x() > (edge ? 0.001 : 0)) skin += volume;
        }
        field.draw_out(Vec3(0, 0, 0.0001));
        ASSERT_EQ(field.count(EventKind::kPieceOut), 1);
        ASSERT_GT(skin, 0.5e-9);
        EXPECT_NEAR(field.lost(Tissue::kSkin), skin, 1e-6 * skin) << edge;
        EXPECT_EQ(field.lost(Tissue::kZone), 0);
        EXPECT_NEAR(field.state.pieces.marked_out_m3, marked, 1e-6 * marked);
    }
}

TEST(Pieces, TheReleaseIsDecidedByConnectivitySectorBySector) {
    Field field(lesion());
    const Vec3 away(0, 0, 0.02);
    field.run(away, 0.6, 2 * kSectors);
    EXPECT_EQ(field.state.release.free_count, 0);
    // The left half (y > 0) of the ring is parted at 2.7 mm, through placode, zone and skin.
    const auto inner = [](const Vec3& p) { return p.head<2>().norm() < 0.0027; };
    const auto part = [&](bool left) {
        for (int t = 0; t < field.scene.body.tet_count(); ++t) {
            const Vec3 here = rest_centroid(field.scene, t);
            if (!inner(here) || (here.y() > 0) != left) continue;
            for (int f = 0; f < 4; ++f) {
                const int other = field.scene.surface
                                      .neighbours()[static_cast<size_t>(t)][static_cast<size_t>(f)];
                if (other >= 0 && !inner(rest_centroid(field.scene, other))) {
                    cut_face(field.scene, field.state, t, f);
                }
            }
        }
    };
    part(true);
    field.run(away, 0.6, 2 * kSectors);
    // 36 sectors, but some at either end still reach around through their neighbours.
    EXPECT_GE(field.state.release.free_count, 26);
    EXPECT_LE(field.state.release.free_count, 36);
    for (int s = 0; s < kSectors; ++s) {
        if (s >= 36) {
            EXPECT_EQ(field.state.release.free[static_cast<size_t>(s)], 0) << s;
        }
    }
    part(false);
    field.run(away, 0.6, 2 * kSectors);
    EXPECT_EQ(field.state.release.free_count, kSectors);
    EXPECT_EQ(field.count(EventKind::kSectorFree), kSectors);
    EXPECT_EQ(field.count(EventKind::kPieceFree), 0);  // the gel below still holds it
}

TEST(Pieces, SectorsCountFromCranialToLeft) {
    EXPECT_EQ(sector_of(Vec3(1, 0.001, 0)), 0);
    EXPECT_EQ(sector_of(Vec3(0.001, 1, 0)), 17);
    EXPECT_EQ(sector_of(Vec3(-1, -0.001, 0)), 36);
    EXPECT_EQ(sector_of(Vec3(1, -0.001, 0)), 71);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
