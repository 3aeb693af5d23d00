// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Needle, hand and tissue together: rest, action and reaction, jaws, threads, memory.
#include "sim/suture/suture_step.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "count_allocations.h"
#include "thread_block.h"

namespace placode::sim {
namespace THIS_TEST {

using namespace test;

/// A needle of 13 mm, `bite_m` of arc into a block of skin.
std::unique_ptr<SutureBlock> bitten(const BlockOptions& options, double bite_m,
                                    double speed_m_s = 5e-3) {
    const Needle needle(options.suture.needle);
    const Pose start = before_bite(needle, 1.4e-3, 0.05e-3);
    auto block = std::make_unique<SutureBlock>(options, start);
    take_needle(block->suture, block->needle, start, 0.67 * needle.arc_m());
    drive_round(*block, bite_m, speed_m_s, [](SutureBlock&) { return true; });
    return block;
}

// Implicit Euler with drag a: v_n+1 = (v_n + h g) / (1 + a h).
TEST(SutureStep, FreeNeedleFallsAndKeepsItsSpin) {
    BlockOptions options = skin_block();
    options.suture.gravity_m_s2 = Vec3(0, 0, -9.81);
    options.suture.drag_per_s = 5;
    SutureBlock block(options, SutureBlock::upright(Vec3(0, 0, 0.05)));
    block.needle.w = Vec3(0, 0.7, 0);  // about the axis that keeps still: y is N's z
    double v = 0, z = (block.needle.needle * block.suture.needle().centre_m()).z(), w = 0.7;
    for (int i = 0; i < 25; ++i) {
        block.rest(1);
        for (int s = 0; s < 4; ++s) {
            v = (v - SutureBlock::kStep * 9.81) / (1 + 5 * SutureBlock::kStep);
            w /= 1 + 5 * SutureBlock::kStep;
            z += SutureBlock::kStep * v;
        }
    }
    EXPECT_NEAR(block.needle.v.z(), v, 1e-6);
    EXPECT_NEAR(block.needle.w.y(), w, 1e-5);
    EXPECT_NEAR((block.needle.needle * block.suture.needle().centre_m()).z(), z, 1e-8);
}

// What the hand pushes is what the bottom of the block carries: 1 % of it, or 0.2 mN where it is
// less (a float's share of 10,000 elements).
TEST(SutureStep, HandAndBottomOfTheBlockCarryTheSame) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.08);
    const auto block = bitten(options, 4e-3);
    ASSERT_GT(block->needle.passage_count, 3);
    block->rest(400);
    const Vec3 hand = block->needle.hold.force_n, bottom = block->carried_n();
    EXPECT_GT(hand.norm(), 0.02);
    EXPECT_LT((hand - bottom).norm(), std::max(0.01 * hand.norm(), 2e-4));
}

// Let go in the tissue, under its weight: less than 10 um in 60 s.
TEST(SutureStep, RestingNeedleDoesNotDrift) {
    BlockOptions options = skin_block();
    options.size_m = Vec3(0.008, 0.003, 0.0025);
    options.cells = {16, 6, 5};
    set_strength(options.suture, 0.08);
    options.suture.gravity_m_s2 = Vec3(0, 0, -9.81);
    const auto block = bitten(options, 3e-3, 10e-3);
    let_go_needle(block->needle);
    block->rest(2000);
    const Needle& needle = block->suture.needle();
    const auto places = [&] {
        return std::array<Vec3, 3>{block->needle.needle * needle.tip_m(),
                                   block->needle.needle * needle.at(needle.arc_m()).place_m,
                                   block->needle.needle * Vec3(0, 0, needle.radius_m())};
    };
    const auto before = places();
    const int seconds = std::getenv("PLACODE_LONG_TESTS") != nullptr ? 60 : 10;
    double drift = 0;
    for (int s = 0; s < seconds; ++s) {
        block->rest(1000);
        for (size_t k = 0; k < 3; ++k) drift = std::max(drift, (places()[k] - before[k]).norm());
    }
    EXPECT_LT(drift, 10e-6 * seconds / 60);
    EXPECT_GT(block->needle.passage_count, 3);
}

// Jaws on a needle that is stuck: they slip along the wire at 2 mu N, and turn at mu N w.
TEST(SutureStep, JawsSlipWhereTheirFrictionEnds) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 2, 1000);  // nothing gives
    options.youngs_modulus_pa = 1e6;
    options.suture.jaws.force_n = 0.15;
    const auto block = bitten(options, 0.3e-3);
    const JawSpec& jaws = block->suture.spec().jaws;
    const double most = 2 * jaws.friction * jaws.force_n, torque = most / 2 * jaws.width_m;
    double pull = 0, turn = 0;
    drive_round(*block, 2e-3, 5e-3, [&](SutureBlock& b) {
        const NeedleHold& hold = b.needle.hold;
        pull = std::max(pull, std::abs(hold.force_n.dot(b.needle.needle.q * hold.back_N)));
        turn = std::max(turn, hold.torque_n_m.norm());
        return true;
    });
    EXPECT_LE(pull, most * (1 + 1e-3));
    EXPECT_LE(turn, torque * (1 + 1e-3));
    EXPECT_GT(std::max(pull / most, turn / torque), 0.99) << "the jaws never slipped";
    EXPECT_GT(block->needle.work.jaws, 0);
}

TEST(SutureStep, JawsThatAreDrawnOffTheWireHoldNothing) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.05);
    const auto block = bitten(options, 4e-3, 10e-3);
    // From now on the tissue holds the needle faster than the jaws do.
    set_strength(options.suture, 0.05, 1000);
    options.suture.jaws.force_n = 0.02;
    options.suture.jaws.width_m = 10e-3;
    block->suture = Suture(options.suture);
    double arc = block->needle.hold.arc_m;
    bool slipped = false;
    drive_round(*block, -6e-3, 10e-3, [&](SutureBlock& b) {
        slipped = slipped || b.saw(SutureEventKind::kSlipped);
        arc = std::max(arc, b.needle.hold.arc_m);
        return true;
    });
    EXPECT_TRUE(slipped);
    EXPECT_GT(arc, options.suture.needle.arc_m);
    EXPECT_EQ(block->needle.hold.held, 0);
    EXPECT_GT(block->needle.passage_count, 3);
}

TEST(SutureStep, SameBitsAtAnyNumberOfThreads) {
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
        BlockOptions options = skin_block();
        options.threads = threads;
        set_strength(options.suture, 0.06);
        const auto block = bitten(options, 3e-3, 20e-3);
        EXPECT_GT(block->needle.passage_count, 2);
        hashes.push_back(block->hash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

/// A needle with thread through a bite, its swage well out of it.
std::unique_ptr<SutureBlock> threaded(int threads) {
    BlockOptions options = skin_block();
    options.threads = threads;
    options.suture.thread.length_m = 0.05;
    options.suture.thread.friction.drag_n_m = 10;
    set_strength(options.suture, 0.05);
    return bitten(options, 21e-3, 20e-3);
}

TEST(SutureStep, SameBitsAtAnyNumberOfThreadsWithThreadInTheTissue) {
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
        const auto block = threaded(threads);
        EXPECT_GT(block->needle.thread.passage_count, 6);
        EXPECT_GT(block->needle.thread.pieces[1].pull_n, 0.01);
        hashes.push_back(block->hash());
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

// Hands that throw about both ends of a thread: all stays finite and near, whatever tears.
TEST(SutureStep, BadHandsOnAThreadLeaveEverythingFinite) {
    uint64_t seed = 7;
    const auto random = [&] {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed >> 33) / static_cast<double>(1ULL << 31) * 2 - 1;
    };
    for (const double barb : {0.0, 300.0}) {
        BlockOptions options = threaded_block();
        options.suture.thread.length_m = 0.03;
        options.suture.thread.friction.barb_n_m = barb;
        const auto block = block_of(options);
        lay_bite(*block, 1.2e-3, -2.5e-3);
        lay_bite(*block, 1.2e-3, 2.5e-3);
        for (int i = 0; i < 600; ++i) {
            for (const int end : {0, 1}) {
                const Vec3 place(4e-3 * random(), 3e-3 * random(), 4e-3 * random());
                if (i % 50 == 25 * end)
                    hold(*block, end, place, 1e-3 * (1 + random()));
                else if (i % 50 == 25 * end + 20)
                    let_go(*block, end);
                else if (i % 5 == 0)
                    end_of(*block, end).place_m = place;
            }
            block->rest(1);
            ASSERT_TRUE(std::isfinite(block->tissue_motion())) << i;
            ASSERT_TRUE(std::isfinite(thread_energy(block->needle.thread))) << i;
            ASSERT_LT(off_rest_m(*block), 20e-3) << i;
        }
        EXPECT_TRUE(std::all_of(block->tissue_state.contact_vertex.begin(),
                                block->tissue_state.contact_vertex.end(),
                                [](uint8_t c) { return c == 0; }));
    }
}

TEST(SutureStep, FrameWithThreadNeitherAllocatesNorLocks) {
    const auto block = threaded(1);
    const long allocations = placode::test::allocations, locks = placode::test::locks;
    const int before = block->needle.thread.passage_count;
    drive_round(*block, 10e-3, 20e-3, [](SutureBlock&) { return true; });
    EXPECT_EQ(placode::test::allocations, allocations);
    EXPECT_EQ(placode::test::locks, locks);
    EXPECT_GT(before, 6);
}

TEST(SutureStep, FrameNeitherAllocatesNorLocks) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.06);
    const auto block = bitten(options, 1e-3, 20e-3);
    const long allocations = placode::test::allocations, locks = placode::test::locks;
    drive_round(*block, 3e-3, 20e-3, [](SutureBlock&) { return true; });
    EXPECT_EQ(placode::test::allocations, allocations);
    EXPECT_EQ(placode::test::locks, locks);
    EXPECT_GT(block->needle.passage_count, 4);
}

// Hands that are thrown about: all stays finite, and no vertex stays out of the sweep.
TEST(SutureStep, BadHandsLeaveEverythingFinite) {
    BlockOptions options = skin_block();
    set_strength(options.suture, 0.05);
    const auto block = bitten(options, 2e-3, 20e-3);
    uint64_t seed = 1;
    const auto random = [&] {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(seed >> 33) / static_cast<double>(1ULL << 31) * 2 - 1;
    };
    const Pose start = block->needle.hold.hand;
    for (int i = 0; i < 1500; ++i) {
        Pose hand = start;
        hand.p += 3e-3 * Vec3(random(), random(), random());
        hand.q = hand.q * turned(1.5 * random(), Vec3(random(), random(), 1.1).normalized());
        block->frame(hand);
        if (i % 200 == 199) {
            let_go_needle(block->needle);
            block->rest(20);
            take_needle(block->suture, block->needle, block->needle.needle, 8e-3);
        }
        ASSERT_TRUE(block->needle.needle.p.allFinite()) << i;
        ASSERT_TRUE(std::isfinite(block->tissue_motion())) << i;
    }
    EXPECT_TRUE(std::all_of(block->tissue_state.contact_vertex.begin(),
                            block->tissue_state.contact_vertex.end(),
                            [](uint8_t c) { return c == 0; }));
}

}  // namespace THIS_TEST
}  // namespace placode::sim
