// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a needle's point does to a block of tissue: forces, peaks, channels, energy.
#include "sim/suture/puncture.h"

#include <gtest/gtest.h>

#include <memory>

#include "sim/suture/rest_walk.h"
#include "suture_block.h"

namespace placode::sim {
namespace THIS_TEST {

using namespace test;

/// A bite of `depth_m`, needle in the hand at two thirds of its arc.
std::unique_ptr<SutureBlock> bite(const BlockOptions& options, double depth_m = 1.4e-3) {
    const Needle needle(options.suture.needle);
    const Pose start = before_bite(needle, depth_m, 0.1e-3);
    auto block = std::make_unique<SutureBlock>(options, start);
    take_needle(block->suture, block->needle, start, 0.67 * needle.arc_m());
    return block;
}

/// Straight down with the point; the greatest push of the hand until the surface opens.
double puncture_n(const BlockOptions& options, double speed_m_s) {
    const Needle needle(options.suture.needle);
    const Pose start = SutureBlock::upright(Vec3(-needle.radius_m(), 0, 0.05e-3), 0);
    SutureBlock block(options, start);
    take_needle(block.suture, block.needle, start, 0.67 * needle.arc_m());
    double most = 0;
    for (int i = 1; i < 4000; ++i) {
        block.frame({start.p - Vec3(0, 0, speed_m_s * 1e-3 * i), start.q});
        most = std::max(most, block.push_n());
        if (block.saw(SutureEventKind::kEntered)) return most;
    }
    return 0;
}

// The hand feels what was set: within 5 %, at 2 and 10 mm/s, in tissue of two stiffnesses.
TEST(Puncture, SurfaceOpensAtTheForceThatWasSet) {
    const std::array<std::array<double, 2>, 4> cases{
        {{60e3, 0.015}, {60e3, 0.03}, {200e3, 0.05}, {200e3, 0.2}}};
    for (const auto& [stiffness, force] : cases) {
        for (const double speed : {2e-3, 10e-3}) {
            BlockOptions options = skin_block();
            options.youngs_modulus_pa = stiffness;
            set_strength(options.suture, force);
            const double found = puncture_n(options, speed);
            EXPECT_NEAR(found / force, 1, 0.05) << stiffness << ' ' << speed;
        }
    }
}

// Soft tissue ahead of the point is drawn out flat, or inside out; the point must not stand still
// in it while the needle goes on. It goes by the shape at rest, where every tet has a volume.
TEST(Puncture, AFlatTetIsCrossedByItsShapeAtRest) {
    const BlockOptions options = skin_block();
    SutureBlock block(options, SutureBlock::upright(Vec3(0, 0, 0.02)));
    const int32_t tet = block.body.tets_of(block.body.vertex_count() / 2)[0];
    const auto& c = corners(block.body, block.tissue_state, tet);
    const TissuePoint middle{tet, {0.25, 0.25, 0.25, 0.25}};
    for (const double beyond : {0.0, 0.5}) {  // of the way to the face, past it
        Vec3 face = Vec3::Zero();
        for (size_t k = 1; k < 4; ++k) face += position(block.tissue_state, c[k]) / 3;
        const Vec3 to = face + beyond * (face - rest_place(block.body, block.tissue_state, c[0]));
        Float4& x = block.tissue_state.x[as_index(c[0])];
        x.x = static_cast<float>(to.x());
        x.y = static_cast<float>(to.y());
        x.z = static_cast<float>(to.z());
        for (const Vec3& offset : {Vec3(-2e-3, 0, 0), Vec3(0, 1e-3, 0), Vec3(0, 0, 1e-3)}) {
            EXPECT_EQ(walk_to_face(block.tissue, middle, offset).end, WalkEnd::kLost);
            const TissueWalk walk = walk_at_rest(block.tissue, middle, offset);
            EXPECT_TRUE(walk.end == WalkEnd::kAtFace || walk.end == WalkEnd::kAtSurface);
            EXPECT_GT(walk.share, 0.01);
            double sum = 0;
            for (const double weight : walk.at.b) {
                EXPECT_GE(weight, 0);
                sum += weight;
            }
            EXPECT_NEAR(sum, 1, 1e-12);
            EXPECT_NEAR((rest_place_of(block.tissue, walk.at) -
                         rest_place_of(block.tissue, middle) - walk.share * offset)
                            .norm(),
                        0, 1e-12);
        }
    }
}

// No more passages fit: the point goes on without leaving any, and says that some were dropped.
TEST(Puncture, AFullListOfPassagesStopsNothing) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08, 0);
    const auto block = bite(options);
    SutureState& needle = block->needle;
    drive_round(*block, 3e-3, 5e-3, [&](SutureBlock&) { return needle.passage_count < 3; });
    ASSERT_EQ(needle.point.mode, PointMode::kInside);
    const Passage newest = needle.passages[as_index(needle.passage_count - 1)];
    while (needle.passage_count < kMostPassages)
        needle.passages[as_index(needle.passage_count++)] = newest;
    // Farther than one passage is due, within one tet.
    needle.point.since_passage_m = 0.3e-3;
    bool dropped = false;
    drive_round(*block, 1e-3, 5e-3, [&](SutureBlock& b) {
        dropped = dropped || b.report.dropped;
        return true;
    });
    EXPECT_TRUE(dropped);
    EXPECT_EQ(needle.passage_count, kMostPassages);
    EXPECT_TRUE(needle.needle.p.allFinite());
}

// One bite, in and out: two peaks of the puncture force, and between them the cutting force.
TEST(Puncture, BiteHasTwoPeaksAndCutsBetweenThem) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bite(options);
    const double cutting = 0.61 * 0.08;
    double first = 0, second = 0, between = 0, entered_at = -1, left_at = -1;
    drive_round(*block, 12e-3, 5e-3, [&](SutureBlock& b) {
        const double force = b.report.point_force_n;
        if (b.saw(SutureEventKind::kEntered)) entered_at = b.frames;
        if (entered_at < 0) {
            first = std::max(first, force);
        } else if (b.needle.point.mode == PointMode::kInside && b.frames > entered_at) {
            between = std::max(between, force);
        } else if (b.needle.point.mode == PointMode::kAtFarSide) {
            second = std::max(second, force);
        }
        if (b.saw(SutureEventKind::kLeft)) left_at = b.frames;
        return left_at < 0;
    });
    ASSERT_GT(entered_at, 0);
    ASSERT_GT(left_at, entered_at);
    EXPECT_NEAR(first, 0.08, 0.05 * 0.08);
    EXPECT_NEAR(second, 0.08, 0.05 * 0.08);
    EXPECT_NEAR(between, cutting, 1e-9);
}

// Passages stand in order along the needle, at most 0.3 mm apart, entry first and exit last.
TEST(Puncture, PassagesAreOrderedAndEvenlySpread) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bite(options);
    bool out = false;
    drive_round(*block, 12e-3, 5e-3, [&](SutureBlock& b) {
        out = out || b.saw(SutureEventKind::kLeft);
        return !out;
    });
    ASSERT_TRUE(out);
    const SutureState& s = block->needle;
    const PosedNeedle posed(block->suture.needle(), s.needle);
    ASSERT_GT(s.passage_count, 10);
    double last = block->suture.needle().arc_m(), length = 0;
    for (int i = 0; i < s.passage_count; ++i) {
        const Passage& p = s.passages[as_index(i)];
        const PassageKind kind = i == 0                    ? PassageKind::kEntry
                                 : i + 1 < s.passage_count ? PassageKind::kInner
                                                           : PassageKind::kExit;
        EXPECT_EQ(p.kind, kind) << i;
        EXPECT_EQ(p.channel, 1);
        EXPECT_LE(p.gap_m, 0.3e-3 + 1e-9);
        length += p.gap_m;
        double sum = 0;
        for (const double b : p.at.b) {
            EXPECT_GE(b, -1e-9);
            sum += b;
        }
        EXPECT_NEAR(sum, 1, 1e-9);
        const double at = posed.shape.foot(posed.to_N(place_of(block->tissue, p.at))).s_m;
        EXPECT_LT(at, last) << i;
        last = at;
    }
    // Of a circle of 4.1 mm that reaches 1.4 mm deep in a block that yields.
    EXPECT_GT(length, 4e-3);
    EXPECT_LT(length, 9e-3);
}

// Work of the hand against what is stored and dissipated, over a whole bite at 1, 5 and 20 mm/s.
// 1.5 to 2.2 % is missing at any speed: by estimate, what the tissue takes when it springs back
// from the opened surfaces. The force that drives the needle is what resists it: nothing drags that
// is not in the books.
TEST(Puncture, WorkOfTheHandIsStoredOrDissipated) {
    const std::array<std::array<double, 3>, 4> cases{
        {{60e3, 0.02, 5e-3}, {200e3, 0.08, 5e-3}, {200e3, 0.08, 1e-3}, {200e3, 0.08, 20e-3}}};
    for (const auto& one : cases) {
        BlockOptions options = skin_block();
        options.youngs_modulus_pa = one[0];
        set_strength(options.suture, one[1], 500 * one[1]);
        const auto block = bite(options);
        bool out = false;
        double after = 0, driven = 0, resisted = 0;
        drive_round(*block, 12e-3, one[2], [&](SutureBlock& b) {
            out = out || b.saw(SutureEventKind::kLeft);
            if (out) after += one[2] * 1e-3;
            driven += b.drive_n() * one[2] * 1e-3;
            resisted += (b.report.wall_force_n + b.report.point_force_n) * one[2] * 1e-3;
            return after < 1e-3;
        });
        ASSERT_TRUE(out);
        const SutureWork& w = block->needle.work;
        const double found = block->stored() + w.puncture + w.friction + w.jaws - w.made;
        EXPECT_NEAR(found / w.hand, 1, 0.03) << one[0] << ' ' << one[2];
        EXPECT_NEAR(driven / resisted, 1, 0.01);
    }
}

// Drawn back out, the needle leaves nothing behind, and the tissue goes back to where it was.
TEST(Puncture, DrawnBackTheNeedleLeavesTheTissueAsItWas) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bite(options);
    drive_round(*block, 4e-3, 10e-3, [](SutureBlock&) { return true; });
    ASSERT_GT(block->needle.passage_count, 3);
    bool withdrawn = false;
    drive_round(*block, -6e-3, 10e-3, [&](SutureBlock& b) {
        withdrawn = withdrawn || b.saw(SutureEventKind::kWithdrawn);
        return true;
    });
    EXPECT_TRUE(withdrawn);
    EXPECT_EQ(block->needle.passage_count, 0);
    EXPECT_EQ(block->needle.point.mode, PointMode::kFree);
    block->rest(400);
    double most = 0;
    for (int v = 0; v < block->body.vertex_count(); ++v)
        most = std::max(
            most, (position(block->tissue_state, v) - block->body.mesh().rest[as_index(v)]).norm());
    EXPECT_LT(most, 1e-6);
}

// Drawn all the way through, the needle leaves its channel passage by passage, and the tissue goes
// back as well.
TEST(Puncture, SwageRunsOffTheChannel) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bite(options);
    int ran_off = 0;
    double most = 0;
    drive_round(*block, 21e-3, 10e-3, [&](SutureBlock& b) {
        for (int i = 0; i < b.report.event_count; ++i)
            ran_off += b.report.events[as_index(i)].kind == SutureEventKind::kRanOff ? 1 : 0;
        most = std::max(most, b.drive_n());
        return true;
    });
    EXPECT_EQ(ran_off, 1) << "told once, by the exit";
    EXPECT_EQ(block->needle.passage_count, 0);
    // Never more than the far side and the whole wall.
    EXPECT_LT(most, 0.08 + 40 * 9e-3);
    EXPECT_LT(std::abs(block->drive_n()), 1e-4);
}

// Tissue that is burned away takes its passages with it; the needle comes out all the same.
TEST(Puncture, PassagesGoWithTheirTissue) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bite(options);
    drive_round(*block, 4e-3, 10e-3, [](SutureBlock&) { return true; });
    const int before = block->needle.passage_count;
    ASSERT_GT(before, 3);
    const int32_t tet = block->needle.passages[0].at.tet;
    remove_tet(block->body, block->tissue_state, tet);
    block->faces.remove_tet(block->surface, block->body.mesh(), block->tissue_state.tet_alive, tet);
    block->rest(1);
    EXPECT_TRUE(block->saw(SutureEventKind::kLost));
    EXPECT_LT(block->needle.passage_count, before);
    EXPECT_GT(block->needle.passage_count, 0);
    drive_round(*block, -6e-3, 10e-3, [](SutureBlock&) { return true; });
    EXPECT_EQ(block->needle.passage_count, 0);
    EXPECT_EQ(block->needle.point.mode, PointMode::kFree);
    EXPECT_LT(std::abs(block->drive_n()), 1e-4);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
