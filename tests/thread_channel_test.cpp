// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Thread in channels of a block of tissue: pulls, balance, energy, slits, and out again.
#include "sim/suture/thread_channel.h"

#include <gtest/gtest.h>

#include "thread_block.h"

namespace placode::sim {
namespace THIS_TEST {

using namespace test;
constexpr double kPi = std::numbers::pi;

/// A screw of 1 mm about the x axis, with hands that go on along it at both ends.
struct Screw {
    double turns, radius_m = 1e-3, pitch_m = 2e-3;
    [[nodiscard]] Vec3 place(double s) const {
        const double a = 2 * kPi * turns * s;
        return Vec3(pitch_m * turns * (s - 0.5), radius_m * std::sin(a),
                    radius_m * std::cos(a) - 1.5e-3);
    }
    [[nodiscard]] Vec3 offset(double s) const {
        const double a = 2 * kPi * turns * s, w = 2 * kPi * turns * radius_m;
        return Vec3(pitch_m * turns, w * std::cos(a), -w * std::sin(a));
    }
    [[nodiscard]] double length_m() const { return offset(0).norm(); }
    /// Of its tangent.
    [[nodiscard]] double turn_rad() const {
        const double c = pitch_m / (2 * kPi);
        return 2 * kPi * turns * radius_m / std::sqrt(radius_m * radius_m + c * c);
    }
};

/// The screw in tissue so stiff that it keeps its turns, with hands 5 mm from it.
std::unique_ptr<SutureBlock> screwed(const Screw& screw, double friction) {
    BlockOptions options = threaded_block(friction);
    options.youngs_modulus_pa = 20e6;
    for (SutureStrength& s : options.suture.strength) s.tear_n_m = 1e6;
    auto block = block_of(options);
    lay_along(*block, screw.length_m(), [&](double s) { return screw.place(s); });
    hold(*block, 0, screw.place(0) - 5e-3 * screw.offset(0).normalized());
    hold(*block, 1, screw.place(1) + 5e-3 * screw.offset(1).normalized());
    return block;
}

// e^(mu phi) between the hands, drawn out and drawn back until the thread slides.
TEST(ThreadChannel, PullGrowsAlongAChannelAsOnADrum) {
    double worst = 0;
    for (const double turns : {0.5, 1.0, 2.0, 3.0}) {
        for (const double friction : {0.1, 0.2, 0.3}) {
            const Screw screw{turns};
            const auto block = screwed(screw, friction);
            const double exact = std::exp(friction * screw.turn_rad());
            const Vec3 offset = std::min(0.1e-3 * exact, 3e-3) * screw.offset(1).normalized();
            const ThreadChannel& channel = block->needle.thread.channels[0];
            draw(*block, 1, offset, 5e-3);
            ASSERT_GT(channel.slid_m, 20e-6);
            const double out = pull_n(*block, 1) / pull_n(*block, 0) / exact;
            EXPECT_NEAR(channel.wrap_rad / screw.turn_rad(), 1, 0.01);
            EXPECT_NEAR(out, 1, 0.03) << turns << ' ' << friction;
            const double most = channel.slid_m;
            draw(*block, 1, -offset, 5e-3,
                 [&](SutureBlock&) { return channel.slid_m > most - 2e-6; });
            ASSERT_LT(channel.slid_m, most - 2e-6);
            ASSERT_GT(pull_n(*block, 1), 0);
            const double back = pull_n(*block, 0) / pull_n(*block, 1) / exact;
            EXPECT_NEAR(back, 1, 0.03) << turns << ' ' << friction;
            worst = std::max({worst, std::abs(out - 1), std::abs(back - 1)});
        }
    }
    record("worst", worst);
}

// What both hands feel is what the bottom of the block carries.
TEST(ThreadChannel, HandsAndBottomOfTheBlockCarryTheSame) {
    const auto block = block_of(threaded_block());
    lay_bite(*block);
    hold(*block, 0, Vec3(-3e-3, 0.5e-3, 4e-3));
    hold(*block, 1, Vec3(4e-3, 0, 3e-3));
    draw(*block, 1, Vec3(0.3e-3, 0, 0.3e-3), 5e-3);
    block->rest(400);
    const Vec3 hands = -(end_of(*block, 0).force_n + end_of(*block, 1).force_n);
    const Vec3 bottom = block->carried_n();
    EXPECT_GT(hands.norm(), 0.02);
    EXPECT_LT((hands - bottom).norm(), 0.01 * hands.norm());
}

// Drawn through, drawn back, and drawn again, at three speeds.
TEST(ThreadChannel, WorkOfTheHandsIsStoredOrDissipated) {
    for (const double speed : {1e-3, 5e-3, 20e-3}) {
        const auto block = block_of(threaded_block(0.2));
        lay_bite(*block);
        hold(*block, 0, Vec3(-3e-3, 0, 4e-3));
        hold(*block, 1, Vec3(3e-3, 0, 4e-3));
        const Vec3 offset(0.1e-3, 0, 0.4e-3);
        double put_in = 0, last = 0;
        const auto found = [&] {
            const ThreadWork& w = block->needle.thread.work;
            return block->stored() + w.friction + w.torn - w.made;
        };
        for (const double share : {1.0, -0.7, 1.0}) {
            draw(*block, 1, share * offset, speed);
            const ThreadWork& w = block->needle.thread.work;
            put_in += std::max(0.0, w.hands - last);
            last = w.hands;
            EXPECT_NEAR(found(), w.hands, 0.03 * put_in) << speed << ' ' << share;
        }
        EXPECT_GT(block->needle.thread.work.friction, 0.05 * block->needle.thread.work.hands);
    }
}

/// Two halves 0.8 mm apart, a channel through either edge, a stopper at the tail.
std::unique_ptr<SutureBlock> slit(double barb_n_m) {
    BlockOptions options = threaded_block();
    options.slit_m = 0.8e-3;
    options.cells = {12, 10, 8};
    options.youngs_modulus_pa = 60e3;
    options.suture.thread.stopper = true;
    options.suture.thread.friction.barb_n_m = barb_n_m;
    auto block = block_of(options);
    const double edge = options.slit_m / 2, far = 2e-3, deep = 1.2e-3;
    // Quarter circles from the skin to the walls of the slit.
    const auto quarter = [=](double s, double side) {
        const double a = kPi / 2 * s;
        return Vec3(side * (edge + far * std::cos(a)), 0, -deep * std::sin(a));
    };
    lay_along(*block, 2.6e-3, [&](double s) { return quarter(s, -1); });
    lay_along(*block, 2.6e-3, [&](double s) { return quarter(1 - s, 1); });
    hold(*block, 1, Vec3(4e-3, 0, 10e-3));
    return block;
}
/// Between the two mouths in the walls of the slit.
double gap_m(const SutureBlock& block) {
    const ThreadState& thread = block.needle.thread;
    const int last = thread.channels[0].first + thread.channels[0].count - 1;
    const Vec3 from = place_of(block.tissue, thread.passages[as_index(last)].at);
    return place_of(block.tissue, thread.passages[as_index(last + 1)].at).x() - from.x();
}

TEST(ThreadChannel, PulledThreadClosesASlitAndBarbsKeepItClosed) {
    for (const double barb : {0.0, 200.0}) {
        const auto block = slit(barb);
        const double before = gap_m(*block);
        EXPECT_NEAR(before, 0.8e-3, 1e-5);
        draw(*block, 1, Vec3(0, 0, 110e-3), 100e-3,
             [&](SutureBlock& b) { return gap_m(b) > 0.15e-3; });
        block->rest(100);
        const double closed = gap_m(*block);
        record("gap_m", closed);
        record("pull_n", pull_n(*block, 1));
        let_go(*block, 1);
        block->rest(300);
        const double after = gap_m(*block);
        record(barb > 0 ? "gap_barbed_m" : "gap_smooth_m", after);
        EXPECT_LT(closed, 0.2e-3);
        if (barb > 0)
            EXPECT_LT(after, closed + 0.02e-3);
        else
            EXPECT_GT(after, 0.6e-3);
    }
}

TEST(ThreadChannel, DrawnOutNothingIsLeft) {
    for (const int end : {0, 1}) {
        BlockOptions options = threaded_block();
        options.suture.thread.friction.drag_n_m = 20;
        const auto block = block_of(options);
        lay_bite(*block);
        const double side = end == 0 ? -1 : 1;
        hold(*block, end, Vec3(side * 2e-3, 0, 3e-3));
        const double outside = end_of(*block, end).spare_m;
        EXPECT_GT(outside, 0);
        int out = 0;
        double most = 0;
        // Barely more than the thread is long.
        draw(*block, end, Vec3(side * 0.02, 0, 0.104), 0.2, [&](SutureBlock& b) {
            out += b.saw(SutureEventKind::kThreadOut) ? 1 : 0;
            most = std::max(most, pull_n(b, end));
            return out == 0;
        });
        EXPECT_NEAR(most, 20 * kPi * 1.2e-3 * 1.3, 20 * 1e-3);
        EXPECT_EQ(out, 1);
        const ThreadState& thread = block->needle.thread;
        EXPECT_EQ(thread.passage_count, 0);
        EXPECT_EQ(thread.channel_count, 0);
        block->rest(400);
        EXPECT_EQ(pull_n(*block, end), 0);
        EXPECT_LT(off_rest_m(*block), 1e-6);
        // All of the thread hangs from the hand.
        EXPECT_NEAR(-thread.pieces[0].stretch_m + end_of(*block, end).spare_m, 0.1, 1e-4);
    }
}

/// A straight channel of 0.8 mm, 0.4 mm under the top of the block, drawn upwards by both hands.
std::unique_ptr<SutureBlock> drawn_up(double strength_n_m) {
    BlockOptions options = threaded_block();
    for (SutureStrength& s : options.suture.strength) s.tear_n_m = strength_n_m;
    auto block = block_of(options);
    lay_along(*block, 0.8e-3, [](double s) { return Vec3(0.8e-3 * (s - 0.5), 0, -0.4e-3); });
    hold(*block, 0, Vec3(-0.4e-3, 0, 3e-3));
    hold(*block, 1, Vec3(0.4e-3, 0, 3e-3));
    return block;
}

// A loop through 0.8 mm of tissue, drawn up at both ends: it holds up to the strength times its
// length and then tears out. Tissue that springs back keeps no books.
TEST(ThreadChannel, LoopTearsOutAtTheStrengthThatWasSet) {
    for (const double strength : {100.0, 200.0}) {
        const auto block = drawn_up(strength);
        double most = 0;
        const auto drawn = [&](SutureEventKind until) {
            for (int i = 0; i < 20000 && !block->saw(until); ++i) {
                for (const int end : {0, 1}) end_of(*block, end).place_m.z() += 0.5e-6;
                block->begin_frame();
                block->substep(Pose{});
                most = std::max(most, pull_n(*block, 0) + pull_n(*block, 1));
            }
        };
        drawn(SutureEventKind::kCutThrough);
        ASSERT_TRUE(block->saw(SutureEventKind::kCutThrough));
        EXPECT_NEAR(most / (strength * 0.8e-3), 1, 0.05);
        record("share_of_strength", most / (strength * 0.8e-3));
        drawn(SutureEventKind::kToreOut);
        EXPECT_EQ(block->needle.thread.channel_count, 0);
        EXPECT_EQ(block->needle.thread.passage_count, 0);
        EXPECT_LT(most, strength * 0.8e-3 * 1.05);
        const ThreadWork& w = block->needle.thread.work;
        EXPECT_GT(w.torn, 0);
        EXPECT_LT(w.torn, w.hands);
        block->rest(400);
        EXPECT_LT(off_rest_m(*block), 1e-6);
    }
}

}  // namespace THIS_TEST
}  // namespace placode::sim
