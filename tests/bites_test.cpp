// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/bites.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assessment/loci.h"
#include "assessment/scoring.h"
#include "curriculum/task.h"
#include "tests/generated_attempts.h"

namespace placode::assessment {
namespace THIS_TEST {

using sim::EventKind;
using sim::Vec3;

constexpr double kHalfM = 0.003, kPitchM = 0.004;  // of the plan; its line is x = 0

/// A row of bites as it is recorded.
struct Row {
    sim::Recording recording;
    double time_s = 0;

    sim::Event& add(EventKind kind, double value, double value2, const Vec3& place = Vec3::Zero()) {
        sim::Event event;
        event.time_s = ++time_s;
        event.kind = kind;
        event.value = static_cast<float>(value);
        event.value2 = static_cast<float>(value2);
        for (int k = 0; k < 3; ++k)
            event.rest_position_m[static_cast<size_t>(k)] = static_cast<float>(place[k]);
        recording.events.push_back(event);
        return recording.events.back();
    }
    static Vec3 mark(int bite, bool in) { return {in ? kHalfM : -kHalfM, kPitchM * bite, 0}; }
    void marks(int bite) {
        for (const bool in : {true, false})
            add(EventKind::kBiteMark, 5 * bite, in ? 0 : 1, mark(bite, in)).element = bite;
    }
    void enter(int bite, const Vec3& off, double sine = 0.5) {
        add(EventKind::kNeedleEntered, 0.025, sine);
        add(EventKind::kBiteEntry, 5 * bite, off.norm(), mark(bite, true) + off);
    }
    void leave(int bite, const Vec3& off, double depth_m = 1.2e-3) {
        add(EventKind::kNeedleLeft, 0.024, depth_m);
        add(EventKind::kBiteExit, 5 * bite + 1, off.norm(), mark(bite, false) + off);
    }
    void through() { add(EventKind::kNeedleThrough, 0, 0); }
    void bite(int number, const Vec3& in = Vec3::Zero(), const Vec3& out = Vec3::Zero(),
              double depth_m = 1.2e-3, double sine = 0.5) {
        marks(number);
        enter(number, in, sine);
        leave(number, out, depth_m);
        through();
    }
    [[nodiscard]] MetricSet measured() const {
        MetricSet set;
        add_bite_metrics(recording, set.values);
        return set;
    }
};

TEST(Bites, ARowIsMeasuredByItsWorstBiteAndItsSpread) {
    Row row;
    row.bite(0, {0.4e-3, 0, 0}, {0.1e-3, 0, 0}, 1.0e-3, 0.5);
    // Along the line: its middle goes 0.5 mm on.
    row.bite(1, {0, 0.3e-3, 0}, {0, 0.7e-3, 0}, 1.5e-3, 0.8);
    row.bite(2, {-0.1e-3, 0, 0}, {0.2e-3, 0, 0}, 1.3e-3, 0.6);
    const MetricSet set = row.measured();
    EXPECT_EQ(*set.find("bites_done"), 3);
    EXPECT_NEAR(*set.find("bite_entry_worst_mm"), 0.4, 1e-4);
    EXPECT_NEAR(*set.find("bite_exit_worst_mm"), 0.7, 1e-4);
    EXPECT_NEAR(*set.find("bite_depth_least_mm"), 1.0, 1e-4);
    EXPECT_NEAR(*set.find("bite_depth_most_mm"), 1.5, 1e-4);
    EXPECT_NEAR(*set.find("bite_depth_spread_mm"), 0.5, 1e-4);
    // 4.5 mm, then 3.5 mm.
    EXPECT_NEAR(*set.find("bite_pitch_mm"), 4.0, 1e-4);
    EXPECT_NEAR(*set.find("bite_pitch_spread_mm"), 1.0, 1e-4);
    // The first: 3.4 mm on one side, 2.9 on the other.
    EXPECT_NEAR(*set.find("bite_asymmetry_mm"), 0.5, 1e-4);
    EXPECT_NEAR(*set.find("bite_angle_least_deg"), 30, 1e-4);
    const std::vector<Bite> bites = bites_of(row.recording);
    ASSERT_EQ(bites.size(), 3U);
    EXPECT_NEAR(bites[0].entry_from_line_m(), 3.4e-3, 1e-7);
    EXPECT_NEAR(bites[0].exit_from_line_m(), 2.9e-3, 1e-7);
    EXPECT_NEAR(*pitch_m(bites[0], bites[1]), 4.5e-3, 1e-7);
    EXPECT_FALSE(pitch_m(bites[0], bites[2]).has_value()) << "no neighbours";
}

TEST(Bites, TheLastEntryOfABiteCounts) {
    Row row;
    row.marks(0);
    row.enter(0, {2e-3, 0, 0}, 0.1);
    row.add(EventKind::kNeedleWithdrawn, 0, 0);
    row.enter(0, {0.2e-3, 0, 0}, 0.5);
    row.leave(0, Vec3::Zero());
    row.through();
    // What happens between the bites belongs to none.
    row.add(EventKind::kNeedleEntered, 0.025, 0.01);
    row.add(EventKind::kNeedleLeft, 0.025, 0.01);
    const MetricSet set = row.measured();
    EXPECT_NEAR(*set.find("bite_entry_worst_mm"), 0.2, 1e-4);
    EXPECT_NEAR(*set.find("bite_angle_least_deg"), 30, 1e-4);
    EXPECT_NEAR(*set.find("bite_depth_most_mm"), 1.2, 1e-4);
}

// In at the mark, out of one wall of the slit, into the other, out at the second mark.
TEST(Bites, ABiteThroughBothWallsOfASlitIsMeasuredFromItsFirstEntry) {
    Row row;
    row.marks(0);
    row.enter(0, Vec3::Zero(), std::sin(10 * std::numbers::pi / 180));
    row.add(EventKind::kNeedleLeft, 0.024, 1.3e-3).hash = 1;
    row.add(EventKind::kNeedleEntered, 0.025, 0.98).hash = 2;
    row.add(EventKind::kNeedleLeft, 0.024, 0.4e-3).hash = 2;
    row.add(EventKind::kBiteExit, 1, 0, Row::mark(0, false));
    row.add(EventKind::kNeedleThrough, 0, 0).hash = 1;
    EXPECT_EQ(*row.measured().find("bites_done"), 0) << "it hangs in the second wall";
    row.add(EventKind::kNeedleThrough, 0, 0).hash = 2;
    const MetricSet set = row.measured();
    EXPECT_EQ(*set.find("bites_done"), 1);
    EXPECT_NEAR(*set.find("bite_angle_least_deg"), 10, 1e-4);
    EXPECT_NEAR(*set.find("bite_depth_most_mm"), 1.3, 1e-4);
}

// What is drawn back and done anew says nothing of the bite that is made in the end.
TEST(Bites, ANewEntryBeginsTheDepthAnew) {
    Row row;
    row.marks(0);
    row.enter(0, Vec3::Zero());
    row.add(EventKind::kNeedleLeft, 0.024, 2.4e-3);
    row.add(EventKind::kNeedleWithdrawn, 0, 0);
    row.enter(0, Vec3::Zero());
    row.leave(0, Vec3::Zero(), 1.1e-3);
    row.through();
    EXPECT_NEAR(*row.measured().find("bite_depth_most_mm"), 1.1, 1e-4);
}

TEST(Bites, OnlyWhatIsDoneIsMeasured) {
    Row row;
    row.marks(0);
    EXPECT_EQ(*row.measured().find("bites_done"), 0);
    EXPECT_FALSE(row.measured().find("bite_entry_worst_mm").has_value());
    row.enter(0, Vec3::Zero());
    EXPECT_TRUE(row.measured().find("bite_angle_least_deg").has_value());
    for (const char* id :
         {"bite_exit_worst_mm", "bite_depth_least_mm", "bite_depth_spread_mm", "bite_asymmetry_mm"})
        EXPECT_FALSE(row.measured().find(id).has_value()) << id << ": it has not come out";
    row.leave(0, Vec3::Zero());
    EXPECT_EQ(*row.measured().find("bites_done"), 0) << "the needle is still in it";
    row.through();
    EXPECT_EQ(*row.measured().find("bites_done"), 1);
    EXPECT_EQ(*row.measured().find("bite_depth_spread_mm"), 0);
    EXPECT_FALSE(row.measured().find("bite_pitch_mm").has_value());
    row.bite(1);
    EXPECT_NEAR(*row.measured().find("bite_pitch_mm"), 4, 1e-4);
    EXPECT_FALSE(row.measured().find("bite_pitch_spread_mm").has_value()) << "one pitch is no row";
    row.marks(2);
    EXPECT_NEAR(*row.measured().find("bite_entry_worst_mm"), 0, 1e-4);
    row.enter(2, {5e-3, 0, 0});
    EXPECT_EQ(*row.measured().find("bites_done"), 2);
    EXPECT_NEAR(*row.measured().find("bite_entry_worst_mm"), 5, 1e-4) << "nobody took it back";
}

/// Whoever leaves a bad bite, or draws the needle through some other channel, does no better than
/// whoever ends it.
TEST(Bites, ABadBiteCountsFinishedOrNot) {
    const auto with_third = [](bool through, uint64_t channel) {
        Row row;
        row.bite(0);
        row.bite(1);
        row.marks(2);
        row.enter(2, {3e-3, 0, 0}, 0.2);
        row.leave(2, {0, 2.5e-3, 0}, 0.3e-3);
        if (through) row.add(EventKind::kNeedleThrough, 0, 0).hash = channel;
        return row;
    };
    const Row ended = with_third(true, 0);
    const MetricSet whole = ended.measured();
    EXPECT_EQ(*whole.find("bites_done"), 3);
    for (const Row& row : {with_third(false, 0), with_third(true, 77)}) {
        const MetricSet left = row.measured();
        EXPECT_EQ(*left.find("bites_done"), 2);
        for (const char* id : {"bite_entry_worst_mm", "bite_exit_worst_mm", "bite_depth_least_mm",
                               "bite_depth_most_mm", "bite_depth_spread_mm", "bite_asymmetry_mm",
                               "bite_angle_least_deg"}) {
            EXPECT_EQ(left.find(id), whole.find(id)) << id;
            // And it is the one that a reason shows.
            EXPECT_EQ(locate(id, 0, row.recording).at_m, locate(id, 0, ended.recording).at_m) << id;
        }
    }
}

TEST(Bites, ThreadThatLeftABiteUndoesIt) {
    for (const auto& [channel, kind] : {std::pair{21, EventKind::kThreadToreOut},
                                        {22, EventKind::kThreadToreOut},
                                        {22, EventKind::kThreadOut}}) {
        Row row;
        for (const int bite : {0, 1, 2}) {
            const auto first = static_cast<uint64_t>(10 * (bite + 1) + 1);
            row.marks(bite);
            row.add(EventKind::kNeedleEntered, 0.025, 0.5).hash = first;
            row.add(EventKind::kBiteEntry, 5 * bite, 0, Row::mark(bite, true));
            row.add(EventKind::kNeedleLeft, 0.024, 1.2e-3).hash = first;
            row.add(EventKind::kNeedleEntered, 0.025, 0.5).hash = first + 1;
            row.add(EventKind::kNeedleLeft, 0.024, 1.2e-3).hash = first + 1;
            row.add(EventKind::kBiteExit, 5 * bite + 1, 0, Row::mark(bite, false));
            row.add(EventKind::kNeedleThrough, 0, 0).hash = first + 1;
        }
        const auto torn = static_cast<uint64_t>(channel);
        row.add(EventKind::kThreadCut, 700, 0).hash = torn;
        EXPECT_EQ(*row.measured().find("bites_done"), 3) << "cut into, it holds";
        row.add(kind, 700, 0).hash = 99;
        EXPECT_EQ(*row.measured().find("bites_done"), 3) << "of no bite";
        row.add(kind, 700, 0).hash = torn;
        EXPECT_EQ(*row.measured().find("bites_done"), 2) << channel;
        EXPECT_TRUE(bites_of(row.recording)[1].lost);
        row.add(EventKind::kNeedleThrough, 0, 0).hash = torn;
        EXPECT_EQ(*row.measured().find("bites_done"), 2) << "gone is gone";
        EXPECT_EQ(*row.measured().find("bite_entry_worst_mm"), 0) << "where it was is known";
    }
}

// As a pin it holds a slit shut, for as long as it is there.
TEST(Bites, ANeedleThatIsLeftInTheTissueUndoesTheLastBite) {
    Row row;
    for (const int bite : {0, 1, 2}) row.bite(bite);
    EXPECT_EQ(*row.measured().find("bites_done"), 3);
    row.add(EventKind::kNeedleEntered, 0.025, 0.5);
    row.add(EventKind::kNeedleLeftIn, 0, 0);
    EXPECT_EQ(*row.measured().find("bites_done"), 2);
}

// A single bite is measured by itself: tasks and recordings of one bite stay what they are.
TEST(Bites, WithoutMarksThereIsNoRow) {
    Row row;
    row.enter(0, Vec3::Zero());
    row.leave(0, Vec3::Zero());
    row.through();
    EXPECT_TRUE(bites_of(row.recording).empty());
    EXPECT_TRUE(row.measured().values.empty());
}

TEST(Bites, AReasonShowsTheWorstBite) {
    Row row;
    row.bite(0);
    row.bite(1, {0.9e-3, 0, 0}, Vec3::Zero(), 2e-3);
    row.bite(2, Vec3::Zero(), {0, 1.1e-3, 0}, 0.5e-3, 0.2);
    const auto at = [&](const char* metric) { return *locate(metric, 0, row.recording).at_m; };
    EXPECT_LT((at("bite_entry_worst_mm") - sim::Vec2(kHalfM + 0.9e-3, kPitchM)).norm(), 1e-7);
    EXPECT_LT((at("bite_exit_worst_mm") - sim::Vec2(-kHalfM, 2 * kPitchM + 1.1e-3)).norm(), 1e-7);
    EXPECT_LT((at("bite_depth_most_mm") - sim::Vec2(-kHalfM, kPitchM)).norm(), 1e-7);
    EXPECT_NEAR(at("bite_depth_least_mm").y(), 2 * kPitchM + 1.1e-3, 1e-7);
    EXPECT_NEAR(at("bite_angle_least_deg").y(), 2 * kPitchM, 1e-7);
    EXPECT_EQ(locate("bites_done", 3, row.recording).count, 3);
}

/// The task itself: a further bite, done as badly as can be, never costs more than it earns.
class BitesOfTask : public ::testing::TestWithParam<const char*> {};

TEST_P(BitesOfTask, ABadBiteIsNeverWorseThanNone) {
    const curriculum::Task task = curriculum::load_task(GetParam());
    double earned = 0, weights = 0, costs = 0;
    int bites = 0, last_bite = 0;
    for (const curriculum::TaskStep& step : task.steps) {
        if (step.goal.kind == sim::PracticeKind::kNeedleIn) {
            ++bites;
            last_bite = 0;
        }
        ++last_bite;
    }
    ASSERT_EQ(bites, 3);
    for (const RubricItem& item : task.rubric.items) {
        weights += item.earns;
        if (item.metric.substr(0, 5) == "bite_") costs += item.max_points;
        // Where it lacks, it has been taken in full before the last bite.
        if (item.metric == "bite_pitch_spread_mm") costs -= item.max_points;
        if (item.metric == "steps_done_percent")
            earned += item.earns * 100.0 * last_bite / static_cast<double>(task.steps.size());
    }
    EXPECT_LE(costs, earned / weights + 1e-9);
}
/// A whole row without harm, each bite moved from its marks: so far along the line and across.
Score score_with(const curriculum::Task& task, double along_m, double out_across_m) {
    sim::Recording recording = test::AttemptMaker::idle(task);
    test::AttemptMaker::ask(recording, 1);
    int bite = -1;
    for (sim::Event& e : recording.events) {
        const bool in = e.kind == EventKind::kBiteEntry;
        if (!in && e.kind != EventKind::kBiteExit) continue;
        if (in) ++bite;
        const Vec3 off(in ? 0 : out_across_m, along_m * bite, 0);
        e.rest_position_m[0] += static_cast<float>(off.x());
        e.rest_position_m[1] += static_cast<float>(off.y());
        e.value2 = static_cast<float>(std::max(static_cast<double>(e.value2), off.norm()));
    }
    return score_attempt(task.rubric, compute_metrics(recording), recording);
}

// Entry and exit count wherever they are, so that a hand may go on; what lies where another bite
// belongs, or does not cross the line, is no row.
TEST(Bites, ThreeBitesThroughOnePlaceAreNoRow) {
    const curriculum::Task task = curriculum::load_task("suture_run");
    EXPECT_EQ(score_with(task, 0, 0).verdict, Verdict::kPassed);
    EXPECT_EQ(score_with(task, 0.9e-3, 0).verdict, Verdict::kPassed) << "badly, but a row";
    EXPECT_EQ(score_with(task, -kPitchM, 0).verdict, Verdict::kFailed) << "all through the first";
    EXPECT_EQ(score_with(task, 0, 2 * kHalfM - 1e-3).verdict, Verdict::kFailed)
        << "nips of 1 mm on one side of the line";
}

INSTANTIATE_TEST_SUITE_P(Rows, BitesOfTask, ::testing::Values("suture_run", "suture_slit"));

}  // namespace THIS_TEST
}  // namespace placode::assessment
