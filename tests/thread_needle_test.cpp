// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Thread that follows its needle through tissue.
#include "sim/suture/thread_step.h"

#include <gtest/gtest.h>

#include "thread_block.h"

namespace placode::sim {
namespace THIS_TEST {

using namespace test;

BlockOptions needle_and_thread() {
    BlockOptions options = threaded_block();
    set_strength(options.suture, 0.08);
    options.suture.thread.length_m = 0.06;
    return options;
}
std::unique_ptr<SutureBlock> bite(const BlockOptions& options) {
    const Needle needle(options.suture.needle);
    const Pose start = before_bite(needle, 1.4e-3, 0.1e-3);
    auto block = std::make_unique<SutureBlock>(options, start);
    take_needle(block->suture, block->needle, start, 0.67 * needle.arc_m());
    return block;
}
void lift(SutureBlock& block, double path_m, double speed_m_s, auto&& look) {
    const Pose start = block.needle.hold.hand;
    const int frames = static_cast<int>(std::ceil(path_m / (speed_m_s * 1e-3)));
    for (int i = 1; i <= frames; ++i) {
        block.frame({start.p + Vec3(0, 0, path_m * i / frames), start.q});
        if (!look(block)) return;
    }
}

// All of the thread is somewhere: outside at the tail, in the channel, between it and the swage.
TEST(ThreadNeedle, ThreadFollowsTheSwageAndPullsAtTheHand) {
    BlockOptions options = needle_and_thread();
    options.suture.thread.friction.drag_n_m = 10;
    const auto block = bite(options);
    int threaded = 0;
    double jump = 0, before = 0;
    drive_round(*block, 21e-3, 10e-3, [&](SutureBlock& b) {
        threaded += b.saw(SutureEventKind::kThreaded) ? 1 : 0;
        const double force = b.needle.hold.force_n.norm();
        if (b.saw(SutureEventKind::kThreaded)) jump = std::abs(force / before - 1);
        before = force;
        return true;
    });
    EXPECT_EQ(threaded, 1);
    EXPECT_LT(jump, 0.3);
    const ThreadState& thread = block->needle.thread;
    ASSERT_EQ(thread.channel_count, 1);
    EXPECT_EQ(thread.channels[0].open, 0);
    EXPECT_GT(thread.passage_count, 6);
    EXPECT_EQ(block->needle.passage_count, 0);
    lift(*block, 10e-3, 10e-3, [](SutureBlock&) { return true; });
    const SutureWork& w = block->needle.work;
    const double in = w.hand + thread.work.hands;
    const double found = block->stored() + w.puncture + w.friction + w.jaws - w.made +
                         thread.work.friction + thread.work.torn - thread.work.made;
    EXPECT_NEAR(found / in, 1, 0.03);
    record("found_of_work", found / in);
    record("jump", jump);
    block->rest(200);
    double path = -thread.pieces[0].stretch_m - thread.pieces[1].stretch_m;
    for (int i = 0; i + 1 < thread.passage_count; ++i)
        path += thread_path_m(place_of(block->tissue, thread.passages[as_index(i)].at),
                              place_of(block->tissue, thread.passages[as_index(i + 1)].at));
    path += thread_path_m(
        place_of(block->tissue, thread.passages[as_index(thread.passage_count - 1)].at),
        swage_m(block->suture, block->needle));
    EXPECT_NEAR(path, 0.06, 1e-4);
    // The hand feels what the thread pulls, and the bottom carries it.
    const Vec3 hand = block->needle.hold.force_n, bottom = block->carried_n();
    EXPECT_GT(hand.norm(), 0.01);
    EXPECT_LT((hand + thread.ends[1].force_n).norm(), 0.01 * hand.norm());
    EXPECT_LT((hand - bottom).norm(), 0.01 * hand.norm());
}

// Until it comes into tissue, a thread changes no bit of it.
TEST(ThreadNeedle, ThreadThatIsOutsideChangesNothing) {
    std::array<uint64_t, 2> hash{};
    for (const size_t threaded : {size_t{0}, size_t{1}}) {
        BlockOptions options = needle_and_thread();
        if (threaded == 0) options.suture.thread.length_m = 0;
        const auto block = bite(options);
        drive_round(*block, 9e-3, 10e-3, [](SutureBlock&) { return true; });
        EXPECT_GT(block->needle.passage_count, 10);
        hash[threaded] = state_hash(block->tissue_state);
    }
    EXPECT_EQ(hash[0], hash[1]);
}

// Before the swage has left the channel, the needle can go back.
TEST(ThreadNeedle, NeedleComesBackForItsThread) {
    const auto block = bite(needle_and_thread());
    drive_round(*block, 15.5e-3, 10e-3, [](SutureBlock&) { return true; });
    const ThreadState& thread = block->needle.thread;
    ASSERT_EQ(thread.channel_count, 1);
    EXPECT_EQ(thread.channels[0].open, 1);
    ASSERT_GT(thread.passage_count, 3);
    bool withdrawn = false;
    drive_round(*block, -17e-3, 10e-3, [&](SutureBlock& b) {
        withdrawn = withdrawn || b.saw(SutureEventKind::kWithdrawn);
        return true;
    });
    EXPECT_TRUE(withdrawn);
    EXPECT_EQ(thread.channel_count, 0);
    EXPECT_EQ(thread.passage_count, 0);
    EXPECT_EQ(block->needle.passage_count, 0);
    EXPECT_NEAR(thread.pieces[0].stretch_m, -0.06, 1e-4);
    block->rest(400);
    EXPECT_LT(off_rest_m(*block), 1e-6);
}

// A needle through both edges of a slit, and its thread drawn up to the stopper: the slit closes.
TEST(ThreadNeedle, StitchThroughBothEdgesClosesASlit) {
    BlockOptions options = needle_and_thread();
    options.slit_m = 0.8e-3;
    options.cells = {12, 10, 8};
    options.youngs_modulus_pa = 60e3;
    set_strength(options.suture, 0.02, 10);
    options.suture.thread.length_m = 0.03;
    options.suture.thread.stopper = true;
    options.suture.thread.friction.barb_n_m = 200;
    const auto block = bite(options);
    drive_round(*block, 22.5e-3, 20e-3, [](SutureBlock&) { return true; });
    const ThreadState& thread = block->needle.thread;
    ASSERT_EQ(thread.channel_count, 2);
    const int second = thread.channels[1].first;
    const auto gap = [&] {
        return (place_of(block->tissue, thread.passages[as_index(second)].at) -
                place_of(block->tissue, thread.passages[as_index(second - 1)].at))
            .norm();
    };
    EXPECT_NEAR(gap(), 0.8e-3, 0.2e-3);
    lift(*block, 40e-3, 50e-3, [&](SutureBlock&) { return gap() > 0.1e-3; });
    block->rest(100);
    EXPECT_LT(gap(), 0.15e-3);
    record("gap_m", gap());
    record("pull_n", thread.pieces[1].pull_n);
    EXPECT_GT(thread.pieces[1].pull_n, 0.02);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
