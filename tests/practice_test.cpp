// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a practice task, watched on samples made by hand.

#include "assessment/practice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/loci.h"
#include "assessment/metrics.h"

namespace placode::assessment {
namespace THIS_TEST {

using sim::PracticeKind;
using sim::PracticeStep;
using sim::Vec3;

sim::FieldGeometry circle(double radius_m) {
    sim::FieldGeometry geometry;
    for (int i = 0; i < 360; ++i) {
        const double a = 2 * std::numbers::pi * i / 360;
        geometry.planned_contour.emplace_back(radius_m * std::cos(a), radius_m * std::sin(a), 0);
    }
    return geometry;
}

/// One right hand and one left hand, samples by hand.
class Attempt {
 public:
    explicit Attempt(std::vector<PracticeStep> steps)
        : tracker_(steps, tools(), circle(0.005)), steps_(std::move(steps)) {}

    static std::vector<sim::ToolSpec> tools() {
        std::vector<sim::ToolSpec> two(2);
        two[1].hand = sim::Hand::kLeft;
        return two;
    }
    sim::ToolSample& tool(size_t i) { return sample_.tools[i]; }
    void tip(size_t i, const Vec3& at) {
        for (int k = 0; k < 3; ++k)
            sample_.tools[i].tip_m[static_cast<size_t>(k)] = static_cast<float>(at[k]);
    }
    void see(int samples = 1) {
        for (int i = 0; i < samples; ++i) {
            sample_.time_s += 0.01;
            PracticeSight sight{sample_,      targets, holds,      pull_n,
                                {true, true}, needle,  slit_gap_m, thread_pull_n};
            for (const sim::Event& e : tracker_.see(sight)) recording.events.push_back(e);
        }
    }
    [[nodiscard]] const PracticeTracker& tracker() const { return tracker_; }
    [[nodiscard]] MetricSet metrics() {
        for (const sim::Event& e : tracker_.end(sample_.time_s)) recording.events.push_back(e);
        MetricSet set;
        add_practice_metrics(recording, set.values);
        return set;
    }

    std::vector<Vec3> targets{Vec3::Zero(), Vec3::Zero()};
    std::array<bool, sim::kMaxTools> holds{};
    std::array<double, sim::kMaxTools> pull_n{};
    NeedleSight needle;
    double slit_gap_m = -1;
    double thread_pull_n = 0;
    sim::Recording recording;

 private:
    PracticeTracker tracker_;
    std::vector<PracticeStep> steps_;
    sim::Sample sample_;
};

TEST(Practice, TargetsStandOnTheClockOfThePlannedLine) {
    PracticeStep step;
    step.outward_m = 0.002;
    for (const auto& [hour, x, y] :
         {std::tuple{12.0, 0.007, 0.0}, {3.0, 0.0, -0.007}, {9.0, 0.0, 0.007}}) {
        step.hour = hour;
        const sim::Vec2 at = practice_target(step, circle(0.005), false);
        EXPECT_NEAR(at.x(), x, 1e-4) << hour;  // the line has a point for every degree
        EXPECT_NEAR(at.y(), y, 1e-4) << hour;
    }
}

TEST(Practice, AWayAcrossTheShaftIsMotionAndAWayAlongItIsDepth) {
    PracticeStep move{.kind = PracticeKind::kMove, .distance_m = 0.01};
    PracticeStep depth{.kind = PracticeKind::kDepth, .distance_m = 0.01};
    Attempt attempt({move, depth});
    for (int i = 0; i <= 30; ++i) {  // along z, the shaft of a tool that is not turned
        attempt.tip(0, Vec3(0, 0, 0.001 * i));
        attempt.see();
    }
    EXPECT_EQ(attempt.tracker().index(), 0);
    for (int i = 0; i <= 12; ++i) {
        attempt.tip(0, Vec3(0.001 * i, 0, 0.03));
        attempt.see();
    }
    EXPECT_EQ(attempt.tracker().index(), 1);
    // Sideways over a field that slopes: half as much along the shaft is no push.
    for (int i = 1; i <= 30; ++i) {
        attempt.tip(0, Vec3(0.012, 0.001 * i, 0.03 - 0.0005 * i));
        attempt.see();
    }
    EXPECT_EQ(attempt.tracker().index(), 1);
    EXPECT_EQ(attempt.tracker().progress(), 0);
    for (int i = 0; i <= 12; ++i) {
        attempt.tip(0, Vec3(0.012, 0.03, 0.015 - 0.001 * i));
        attempt.see();
    }
    EXPECT_TRUE(attempt.tracker().done());
    EXPECT_EQ(*attempt.metrics().find("steps_done_percent"), 100);
}

TEST(Practice, ATurnAboutTheShaftIsTakenFromTheOrientationAlone) {
    Attempt attempt({{.kind = PracticeKind::kTurn, .turn_rad = 1.0}});
    for (int i = 0; i <= 9; ++i) {
        const double half = 0.05 * i;
        attempt.tool(0).orientation = {static_cast<float>(std::cos(half)), 0, 0,
                                       static_cast<float>(std::sin(half))};
        attempt.see();
    }
    EXPECT_NEAR(attempt.tracker().progress(), 0.9, 1e-4);  // orientations are floats
}

TEST(Practice, ATouchBesideTheTargetIsAMissHoweverItSlidesAfterwards) {
    Attempt attempt({{.kind = PracticeKind::kTouch, .hold_s = 0.05, .tolerance_m = 0.001}});
    attempt.tip(0, Vec3(0.003, 0, 0));
    attempt.tool(0).in_contact = 1;
    attempt.see(3);
    attempt.tool(0).in_contact = 0;
    attempt.see(2);
    attempt.tip(0, Vec3(0.0004, 0, 0));
    attempt.tool(0).in_contact = 1;
    attempt.see(8);
    const MetricSet metrics = attempt.metrics();
    EXPECT_EQ(*metrics.find("target_misses"), 1);
    EXPECT_NEAR(*metrics.find("target_error_mm"), 0.4, 1e-4);
    EXPECT_EQ(*metrics.find("steps_done_percent"), 100);
}

TEST(Practice, EnergyCountsInBurstsWithTheRightPedalOnly) {
    Attempt attempt({{.kind = PracticeKind::kCut, .hold_s = 0.1}});
    attempt.tool(0).in_contact = 1;
    attempt.tool(0).pedals = sim::kPedalCoag;
    attempt.see(30);
    EXPECT_EQ(attempt.tracker().progress(), 0);
    for (int burst = 0; burst < 2; ++burst) {
        attempt.tool(0).pedals = sim::kPedalCut;
        attempt.see(6);
        attempt.tool(0).pedals = 0;
        attempt.see(6);
    }
    EXPECT_TRUE(attempt.tracker().done());
}

/// Once around at `offset` outside the line.
void go_around(Attempt& attempt, double offset, int degrees) {
    attempt.tool(0).tip_gap_m = 0.0002F;
    for (int i = 0; i < 2 * degrees; ++i) {
        const double a = std::numbers::pi * i / 360;
        const double r = 0.005 + offset;
        attempt.tip(0, Vec3(r * std::cos(a), r * std::sin(a), 0));
        attempt.see();
    }
}

TEST(Practice, TracingMeasuresTheDistanceFromTheLine) {
    Attempt attempt({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
    go_around(attempt, 0.0004, 360);
    EXPECT_TRUE(attempt.tracker().done());
    const MetricSet metrics = attempt.metrics();
    // A chord of one degree lies 0.2 um inside its arc.
    EXPECT_NEAR(*metrics.find("trace_error_mm"), 0.4, 1e-3);
    EXPECT_GT(*metrics.find("trace_coverage_percent"), 95);
}

/// Value of the only pass: out to `peak_m` from the line and back, then so many samples of
/// standing, with a hand that trembles by `tremble_m`.
double wobble(double peak_m, int standing, double tremble_m = 0) {
    Attempt attempt({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
    attempt.tool(0).tip_gap_m = 0.0002F;
    constexpr double kAngle = 0.5 * 2 * std::numbers::pi / sim::kTraceBins;  // middle of the first
    const auto see_at = [&](double offset) {
        const double r = 0.005 + offset;
        attempt.tip(0, Vec3(r * std::cos(kAngle), r * std::sin(kAngle), 0));
        attempt.see();
    };
    for (int i = 0; i <= 20; ++i) see_at(peak_m * i / 20);
    for (int i = 0; i < standing; ++i) see_at(i % 2 == 0 ? 0 : tremble_m);
    (void)attempt.metrics();
    double value = -1;
    for (const sim::Event& e : attempt.recording.events)
        if (e.kind == sim::EventKind::kTraced) value = static_cast<double>(e.value2);
    return value;
}

TEST(Practice, StandingStillOnTheLineThinsOutNoWobble) {
    // Out and back along a straight way: half of the farthest offset, however long it stands then.
    EXPECT_NEAR(wobble(0.0029, 1), 0.00145, 2e-5);
    EXPECT_NEAR(wobble(0.0029, 500), 0.00145, 2e-5);
    EXPECT_NEAR(wobble(0.0029, 500, 0.00008), 0.00145, 2e-5) << "trembling is no way";
    // Who stands and goes nowhere has the distance at which it stood.
    EXPECT_NEAR(wobble(0, 100), 0, 1e-6);
}

TEST(Practice, AnEvenTraceIsWorthTheSameWithStopsAndWithout) {
    for (const double offset : {0.0002, 0.0006}) {
        Attempt even({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}}),
            stops({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
        go_around(even, offset, 180);
        for (int i = 0; i < 3; ++i) {
            go_around(stops, offset, 60);
            stops.see(300);
        }
        go_around(stops, offset, 180);
        EXPECT_NEAR(*even.metrics().find("trace_error_mm"), 1e3 * offset, 0.02 * 1e3 * offset);
        EXPECT_NEAR(*stops.metrics().find("trace_error_mm"), 1e3 * offset, 0.02 * 1e3 * offset);
    }
}

TEST(Practice, TracingFarFromTheLineIsAFaultAndNoPass) {
    Attempt attempt({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
    go_around(attempt, 0.0001, 180);
    const double good = *attempt.metrics().find("trace_error_mm");
    go_around(attempt, 0.004, 90);
    EXPECT_FALSE(attempt.tracker().done());
    attempt.tip(0, Vec3(0.02, 0, 0.01));
    attempt.tool(0).tip_gap_m = 0.01F;
    attempt.see();
    const MetricSet metrics = attempt.metrics();
    // 36 stretches with 0.1 mm, then 18 of them with 4 mm, of which 0.3 s are two or three.
    EXPECT_NEAR(good, 0.1, 0.01);
    EXPECT_NEAR(*metrics.find("trace_error_mm"), (20.5 * 0.1 + 15.5 * 4) / 36, 0.06);
    EXPECT_NEAR(*metrics.find("trace_error_p95_mm"), 4, 0.05);
    EXPECT_NEAR(*metrics.find("trace_coverage_percent"), 50, 2);
}

TEST(Practice, WhoComesFromAfarIsOnTheWayAndLiftedIsNotTracing) {
    Attempt attempt({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
    attempt.tool(0).tip_gap_m = 0.0002F;
    for (int i = 0; i < 25; ++i) {  // a quarter of a second, 14 to 8.6 mm from the middle
        attempt.tip(0, Vec3(0.014 - 0.000225 * i, 0, 0));
        attempt.see();
    }
    go_around(attempt, 0.0001, 180);
    attempt.tool(0).tip_gap_m = 0.002F;
    attempt.tip(0, Vec3(0.02, 0, 0.002));
    attempt.see(500);
    const MetricSet metrics = attempt.metrics();
    EXPECT_LT(*metrics.find("trace_error_p95_mm"), 0.2);
}

/// A traced line as events: every stretch at `offset_m`.
sim::Recording traced(double offset_m) {
    sim::Recording recording;
    const auto add = [&](sim::EventKind kind, int value, double value2) {
        sim::Event event;
        event.kind = kind;
        event.value = static_cast<float>(value);
        event.value2 = static_cast<float>(value2);
        recording.events.push_back(event);
    };
    add(sim::EventKind::kPracticeSteps, 1, 0);
    for (int bin = 0; bin < sim::kTraceBins; ++bin) add(sim::EventKind::kTraced, bin, offset_m);
    return recording;
}

MetricSet practice_metrics(const sim::Recording& recording) {
    MetricSet set;
    add_practice_metrics(recording, set.values);
    return set;
}

TEST(Practice, NeitherAWobbleOnTheSpotNorASecondLapWipesOutABadTrace) {
    const sim::Recording bad = traced(0.0009);
    EXPECT_NEAR(*practice_metrics(bad).find("trace_error_mm"), 0.9, 1e-4);
    sim::Recording wobble = bad, lap = bad;
    for (int i = 0; i < 1500; ++i) {
        sim::Event pass = bad.events[static_cast<size_t>(11 + i % 2)];
        pass.value2 = 2e-5F;
        wobble.events.push_back(pass);
    }
    const sim::Recording good = traced(2e-5);
    for (int i = 0; i < 20; ++i)
        lap.events.insert(lap.events.end(), good.events.begin() + 1, good.events.end());
    for (const sim::Recording* each : {&wobble, &lap}) {
        const MetricSet metrics = practice_metrics(*each);
        EXPECT_NEAR(*metrics.find("trace_error_mm"), 0.9, 1e-4);
        EXPECT_NEAR(*metrics.find("trace_error_p95_mm"), 0.9, 1e-4);
        EXPECT_EQ(*metrics.find("trace_coverage_percent"), 100);
    }
    // A stretch that is mended is no worse for it, and one more fault is one stretch's.
    sim::Recording fault = good;
    fault.events.push_back(bad.events[20]);
    const MetricSet once = practice_metrics(fault);
    EXPECT_NEAR(*once.find("trace_error_mm"), 0.02 + 0.88 / sim::kTraceBins, 1e-4);
    for (int i = 0; i < 100; ++i) fault.events.push_back(bad.events[20]);
    EXPECT_EQ(*practice_metrics(fault).find("trace_error_mm"), *once.find("trace_error_mm"));
}

TEST(Practice, APassThatSaysAnotherStretchIsStillAFault) {
    sim::Recording odd = traced(0.0001);
    for (const float bin : {-3.0F, 1e9F, std::nanf("")}) {
        sim::Event pass = odd.events[1];
        pass.value = bin;
        pass.value2 = 0.002F;
        odd.events.push_back(pass);
    }
    EXPECT_GT(*practice_metrics(odd).find("trace_error_mm"), 0.1);
}

TEST(Practice, OnlyTheFirstTouchOfATargetSaysHowWellItWasAimedAt) {
    sim::Recording recording = traced(0.0001);
    const auto touch = [&](int step, double error_m) {
        sim::Event event;
        event.kind = sim::EventKind::kTargetTouched;
        event.time_s = static_cast<double>(recording.events.size());
        event.value = static_cast<float>(step);
        event.value2 = static_cast<float>(error_m);
        recording.events.push_back(event);
        return event.time_s;
    };
    touch(0, 0.0003);
    const double worst_s = touch(1, 0.0009);
    for (int i = 0; i < 200; ++i) touch(1, 1e-5);
    touch(0, 0.00095);
    EXPECT_NEAR(*practice_metrics(recording).find("target_error_mm"), 0.6, 1e-4);
    EXPECT_EQ(locate("target_error_mm", 0, recording).time_s, worst_s);
}

TEST(Practice, HalfARingFarFromTheLineCoversNothing) {
    Attempt attempt({{.kind = PracticeKind::kTrace, .tolerance_m = 0.001}});
    go_around(attempt, 0.0015, 180);
    EXPECT_FALSE(attempt.tracker().done());
    const MetricSet metrics = attempt.metrics();
    EXPECT_EQ(*metrics.find("trace_coverage_percent"), 0);
    EXPECT_NEAR(*metrics.find("trace_error_mm"), 1.5, 1e-2);
}

TEST(Practice, TractionCountsWhileBothHandsPullWithinTheBand) {
    Attempt attempt(
        {{.kind = PracticeKind::kTraction, .hold_s = 0.5, .low_n = 0.01, .high_n = 0.05}});
    attempt.see();  // both open: what is held before the step does not count
    attempt.holds = {true, true};
    attempt.pull_n = {0.02, 0.02};
    attempt.see(30);
    attempt.pull_n = {0.02, 0.08};  // too hard: from the start again
    attempt.see(5);
    attempt.pull_n = {0.02, 0.03};
    attempt.see(40);
    EXPECT_FALSE(attempt.tracker().done());
    attempt.see(15);
    EXPECT_TRUE(attempt.tracker().done());
    EXPECT_NEAR(*attempt.metrics().find("traction_held_s"), 0.8, 0.02);  // two spells
}

TEST(Practice, ANeedlePushedThroughInOneGoEndsTheBite) {
    Attempt attempt({{.kind = PracticeKind::kNeedleIn},
                     {.kind = PracticeKind::kNeedleOut},
                     {.kind = PracticeKind::kNeedleTake},
                     {.kind = PracticeKind::kNeedleThrough}});
    attempt.needle.through = 1;  // of a bite before
    attempt.see(5);
    attempt.needle.entered = 1;
    attempt.see();
    attempt.needle.left = 1;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 2);
    attempt.needle.through = 2;  // never let go
    attempt.see(2);
    EXPECT_TRUE(attempt.tracker().done());
}

TEST(Practice, ANeedleThatHasLeftOneWallOfASlitIsNotDrawnThrough) {
    Attempt attempt({{.kind = PracticeKind::kNeedleOut}, {.kind = PracticeKind::kNeedleThrough}});
    attempt.needle.in_tissue = true;
    attempt.see();
    attempt.needle.left = 1;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 1);
    attempt.needle.through = 1;  // the first wall
    attempt.see(20);
    EXPECT_FALSE(attempt.tracker().done());
    attempt.needle.through = 2;
    attempt.needle.in_tissue = false;
    attempt.see();
    EXPECT_TRUE(attempt.tracker().done());
}

TEST(Practice, APointThatComesOutWithinASlitGoesOnIntoTheOtherEdge) {
    Attempt attempt({{.kind = PracticeKind::kNeedleIn}, {.kind = PracticeKind::kNeedleOut}});
    attempt.see();
    attempt.needle.entered = 1;
    attempt.see();
    attempt.needle.left = 1;
    attempt.needle.exit_in_slit = true;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 1) << "half of the way";
    attempt.needle.entered = 2;  // into the other wall: no second entry of the bite
    attempt.needle.entry_in_slit = true;
    attempt.see();
    attempt.needle.left = 2;
    attempt.needle.exit_in_slit = false;
    attempt.see();
    EXPECT_TRUE(attempt.tracker().done());
    int entries = 0, exits = 0;
    for (const sim::Event& e : attempt.recording.events) {
        entries += e.kind == sim::EventKind::kBiteEntry ? 1 : 0;
        exits += e.kind == sim::EventKind::kBiteExit ? 1 : 0;
    }
    EXPECT_EQ(entries, 1);
    EXPECT_EQ(exits, 1);
}

TEST(Practice, WhoComesOutOfASlitAndBeginsAnewIsMeasuredAnew) {
    Attempt attempt({{.kind = PracticeKind::kNeedleIn}, {.kind = PracticeKind::kNeedleOut}});
    attempt.needle.entered = 1;
    attempt.needle.entry_in_slit = true;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 0) << "into a wall from within the slit";
    attempt.needle.entered = 2;
    attempt.needle.entry_in_slit = false;
    attempt.see();
    attempt.needle.left = 1;
    attempt.needle.exit_in_slit = true;
    attempt.see();
    attempt.needle.entered = 3;  // drawn back, and in again 2 mm beside the mark
    attempt.needle.entry_m = Vec3(0.002, 0, 0);
    attempt.see();
    double offset_m = 0;
    for (const sim::Event& e : attempt.recording.events)
        if (e.kind == sim::EventKind::kBiteEntry) offset_m = static_cast<double>(e.value2);
    EXPECT_NEAR(offset_m, 0.002, 1e-6);
}

TEST(Practice, ThreadIsDrawnUntilTheSlitStaysShut) {
    Attempt attempt(
        {{.kind = PracticeKind::kThreadDraw, .hold_s = 0.3, .tolerance_m = 0.0002, .low_n = 0}});
    attempt.slit_gap_m = 0.001;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().progress(), 0);
    attempt.slit_gap_m = 0.0006;
    attempt.see();
    EXPECT_NEAR(attempt.tracker().progress(), 0.5, 1e-9);
    attempt.slit_gap_m = 0.0001;
    attempt.see(20);
    EXPECT_FALSE(attempt.tracker().done()) << "not for long enough";
    attempt.slit_gap_m = 0.0003;
    attempt.see();
    attempt.slit_gap_m = 0.0002;
    attempt.see(20);
    EXPECT_FALSE(attempt.tracker().done()) << "it had come open in between";
    attempt.see(12);
    EXPECT_TRUE(attempt.tracker().done());

    Attempt without({{.kind = PracticeKind::kThreadDraw}});
    without.see();
    EXPECT_TRUE(without.tracker().done()) << "no slit: nothing to wait for";
}

TEST(Practice, ThreadIsDrawnAsHardAsTheStepWants) {
    Attempt attempt(
        {{.kind = PracticeKind::kThreadDraw, .hold_s = 0.3, .tolerance_m = 0.0002, .low_n = 0.1}});
    attempt.slit_gap_m = 0.0008;
    attempt.see();
    attempt.slit_gap_m = 0.0005;
    attempt.see();
    EXPECT_NEAR(attempt.tracker().progress(), 0.25, 1e-6) << "half of it is to shut the slit";
    attempt.slit_gap_m = 0;
    attempt.thread_pull_n = 0.05;
    attempt.see(50);
    EXPECT_FALSE(attempt.tracker().done()) << "pressed together, not drawn";
    EXPECT_NEAR(attempt.tracker().progress(), 0.75, 1e-6);
    attempt.thread_pull_n = 0.1001;
    attempt.slit_gap_m = 0.0003;
    attempt.see(50);
    EXPECT_FALSE(attempt.tracker().done()) << "drawn, not shut";
    attempt.slit_gap_m = 0;
    attempt.see(32);
    EXPECT_TRUE(attempt.tracker().done());
}

PracticeStep drawn_by_choice() {
    return {.kind = PracticeKind::kThreadDraw,
            .hold_s = 0.3,
            .tolerance_m = 0.0002,
            .low_n = 0.12,
            .high_n = 0.25,
            .enough_n = 0.04};
}

TEST(Practice, WhoEasesOffAfterAFairPullHasDrawnTheThreadAndIsToldHowHard) {
    Attempt attempt({drawn_by_choice(), drawn_by_choice(), drawn_by_choice()});
    attempt.slit_gap_m = 0.001;
    attempt.see();
    attempt.slit_gap_m = 0.0001;
    attempt.thread_pull_n = 0.06;
    attempt.see(20);
    attempt.thread_pull_n = 0.01;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 0) << "a jerk is no pull";
    attempt.thread_pull_n = 0.07;
    attempt.see(200);
    EXPECT_EQ(attempt.tracker().index(), 0) << "it goes on as long as the hand pulls";
    attempt.thread_pull_n = 0.03;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 0) << "a hand that trembles has not let go";
    attempt.thread_pull_n = 0.019;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 1);
    attempt.thread_pull_n = 0.15;
    attempt.see(32);
    EXPECT_EQ(attempt.tracker().index(), 2) << "as hard as is aimed at: nothing to wait for";
    EXPECT_NEAR(*attempt.metrics().find("draw_pull_least_mn"), 70, 1e-3);
    const Locus loosest = locate("draw_pull_least_mn", 120, attempt.recording);
    EXPECT_EQ(loosest.count, 2);
    EXPECT_LT(loosest.time_s, 3);

    attempt.slit_gap_m = 0.001;  // pulled hard, and open: that shuts nothing
    attempt.see(50);
    attempt.thread_pull_n = 0;
    attempt.see(50);
    EXPECT_EQ(attempt.tracker().index(), 2);
}

TEST(Practice, ADrawWithoutAChoiceTellsNothingNew) {
    // Recordings of tasks that lack it are replayed, and compared event by event.
    Attempt attempt(
        {{.kind = PracticeKind::kThreadDraw, .hold_s = 0.3, .tolerance_m = 0.0002, .low_n = 0.1}});
    attempt.slit_gap_m = 0;
    attempt.thread_pull_n = 0.09;
    attempt.see(50);
    attempt.thread_pull_n = 0;
    attempt.see(50);
    EXPECT_FALSE(attempt.tracker().done());
    attempt.thread_pull_n = 0.11;
    attempt.see(32);
    EXPECT_TRUE(attempt.tracker().done());
    for (const sim::Event& e : attempt.recording.events)
        EXPECT_NE(e.kind, sim::EventKind::kThreadDrawn);
    EXPECT_FALSE(attempt.metrics().find("draw_pull_least_mn"));
}

TEST(Practice, ForceOfTheDriverBesideTheThreadDrawsNothing) {
    Attempt attempt({drawn_by_choice()});
    attempt.slit_gap_m = 0.0001;
    attempt.tool(0).force_n = {0, 0, 0.15F};
    attempt.see(50);
    EXPECT_FALSE(attempt.tracker().done()) << "pressed together beside the slit";
    attempt.tool(0).force_n = {0, 0, 0};
    attempt.see(50);
    EXPECT_FALSE(attempt.tracker().done()) << "nor was that a pull to ease off from";
    attempt.thread_pull_n = 0.15;
    attempt.see(32);
    EXPECT_TRUE(attempt.tracker().done());
}

TEST(Practice, ABiteIsMeasuredFromItsMarksAndMayBeginAnew) {
    Attempt attempt({{.kind = PracticeKind::kNeedleIn},
                     {.kind = PracticeKind::kNeedleOut},
                     {.kind = PracticeKind::kNeedleTake},
                     {.kind = PracticeKind::kNeedleThrough}});
    attempt.needle.taken = 1;
    attempt.needle.mark_m = {Vec3(0.003, 0, 0), Vec3(-0.003, 0, 0)};
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 0);
    attempt.needle.entered = 1;
    attempt.needle.entry_m = Vec3(0.004, 0, 0);
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 1);
    attempt.see(10);
    EXPECT_EQ(attempt.tracker().index(), 1) << "an entry is no exit";
    attempt.needle.entered = 2;  // drawn back, and in again nearer to the mark
    attempt.needle.entry_m = Vec3(0.0033, 0, 0);
    attempt.see();
    attempt.needle.left = 1;
    attempt.needle.exit_m = Vec3(-0.003, 0.0005, 0);
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 2);
    attempt.see(10);
    EXPECT_EQ(attempt.tracker().index(), 2) << "it has been held all the time, not taken again";
    attempt.needle.taken = 2;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 3);
    attempt.needle.through = 1;
    attempt.see();
    EXPECT_TRUE(attempt.tracker().done());
    std::vector<float> entries, exits;
    for (const sim::Event& e : attempt.recording.events) {
        if (e.kind == sim::EventKind::kBiteEntry) entries.push_back(e.value2);
        if (e.kind == sim::EventKind::kBiteExit) exits.push_back(e.value2);
    }
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_NEAR(entries[0], 1e-3, 1e-9);
    EXPECT_NEAR(entries[1], 0.3e-3, 1e-9);
    ASSERT_EQ(exits.size(), 1U);
    EXPECT_NEAR(exits[0], 0.5e-3, 1e-9);
    EXPECT_EQ(*attempt.metrics().find("steps_done_percent"), 100);
}

std::vector<PracticeStep> row_of(int bites) {
    std::vector<PracticeStep> steps;
    for (int i = 0; i < bites; ++i) {
        steps.push_back({.kind = PracticeKind::kNeedleIn});
        steps.push_back({.kind = PracticeKind::kNeedleOut});
        steps.push_back({.kind = PracticeKind::kNeedleThrough});
    }
    return steps;
}

TEST(Practice, EachBiteOfARowTellsItsMarksWhenItIsNext) {
    Attempt attempt(row_of(2));
    const auto told = [&] {
        std::vector<sim::Event> marks;
        for (const sim::Event& e : attempt.recording.events)
            if (e.kind == sim::EventKind::kBiteMark) marks.push_back(e);
        return marks;
    };
    EXPECT_EQ(attempt.tracker().bites(), 2);
    attempt.needle.mark_m = {Vec3(0.003, 0.001, 0), Vec3(-0.003, 0.001, 0)};
    attempt.see(5);
    ASSERT_EQ(told().size(), 2U) << "once";
    EXPECT_EQ(told()[0].element, 0);
    EXPECT_EQ(told()[0].value2, 0);
    EXPECT_NEAR(told()[0].rest_position_m[0], 0.003, 1e-9);
    EXPECT_EQ(told()[1].value2, 1);
    EXPECT_NEAR(told()[1].rest_position_m[0], -0.003, 1e-9);
    attempt.needle.entered = 1;
    attempt.see();
    attempt.needle.left = 1;
    attempt.see();
    EXPECT_EQ(attempt.tracker().bite(), 0);
    attempt.needle.through = 1;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 3);
    EXPECT_EQ(attempt.tracker().bite(), 1);
    attempt.needle.mark_m = {Vec3(0.003, 0.005, 0), Vec3(-0.003, 0.005, 0)};
    attempt.see();
    ASSERT_EQ(told().size(), 4U);
    EXPECT_EQ(told()[2].element, 1);
    EXPECT_EQ(told()[2].value, 3) << "its step";
    EXPECT_NEAR(told()[2].rest_position_m[1], 0.005, 1e-9);
    EXPECT_EQ(attempt.tracker().index(), 3) << "the entry of the bite before is none of this one";
}

TEST(Practice, ASingleBiteTellsNoMarks) {
    Attempt attempt(row_of(1));
    attempt.see(3);
    for (const sim::Event& e : attempt.recording.events)
        EXPECT_NE(e.kind, sim::EventKind::kBiteMark);
}

TEST(Practice, ANeedleHasToBeTakenWhereTheStepSays) {
    Attempt attempt({{.kind = PracticeKind::kNeedleTake, .take_share = 0.7}});
    attempt.needle.taken = 1;
    attempt.needle.held_share = 0.08;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 0) << "behind its point";
    attempt.needle.held_share = 0.62;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 0) << "held there, but not taken anew";
    attempt.needle.taken = 2;
    attempt.see();
    EXPECT_TRUE(attempt.tracker().done());
}

TEST(Practice, APlaceInTheFieldNeedsNoClock) {
    PracticeStep step;
    step.placed = true;
    step.place_m = {sim::Vec2(0.01, 0.004), sim::Vec2(0.003, 0.004)};
    step.hour = 3;
    EXPECT_EQ(practice_target(step, circle(0.005), false), step.place_m[0]);
    EXPECT_EQ(practice_target(step, circle(0.005), true), step.place_m[1]);
}

TEST(Practice, RecordingsWithoutStepsHaveNoSuchMetrics) {
    std::vector<Metric> none;
    add_practice_metrics({}, none);
    EXPECT_TRUE(none.empty());
}

/// A needle between two drivers: taken by the right hand, shown, laid down.
std::vector<PracticeStep> handling() {
    PracticeStep take{.kind = PracticeKind::kNeedleTake, .hand = sim::Hand::kLeft};
    take.take_share = 0.33;
    PracticeStep show{.kind = PracticeKind::kNeedleShow, .hand = sim::Hand::kLeft};
    show.tolerance_m = 0.002;
    show.hold_s = 0.1;
    PracticeStep lay{.kind = PracticeKind::kNeedleLay, .hand = sim::Hand::kLeft};
    lay.tolerance_m = 0.004;
    lay.hold_s = 0.1;
    return {take, show, lay};
}

int told(const sim::Recording& recording, sim::EventKind kind) {
    return static_cast<int>(std::count_if(recording.events.begin(), recording.events.end(),
                                          [&](const sim::Event& e) { return e.kind == kind; }));
}

TEST(Practice, ANeedleIsTakenByTheHandThatIsAskedForAtItsPlace) {
    Attempt attempt(handling());
    attempt.needle.handled = true;
    attempt.needle.taken = 1;
    attempt.needle.held[0] = true;  // the other hand
    attempt.needle.share[0] = 0.33;
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 0);
    attempt.needle.held[1] = true;
    attempt.needle.share[1] = 0.6;  // beside its place
    attempt.see(5);
    EXPECT_EQ(attempt.tracker().index(), 0);
    attempt.needle.share[1] = 0.4;
    attempt.see();
    EXPECT_EQ(attempt.tracker().index(), 1) << "while both hold it";
    ASSERT_EQ(told(attempt.recording, sim::EventKind::kNeedlePlaced), 1);
    for (const sim::Event& e : attempt.recording.events)
        if (e.kind == sim::EventKind::kNeedlePlaced) {
            EXPECT_NEAR(e.value2, 0.07F, 1e-6F);
        }
}

TEST(Practice, ANeedleIsShownByTheHandAndLaidDownWhereItIsLetGo) {
    Attempt attempt(handling());
    attempt.needle.handled = true;
    attempt.needle.held[1] = true;
    attempt.needle.share[1] = 0.33;
    attempt.needle.lowest_m = 0.01;
    attempt.needle.point_m = Vec3(0.003, 0, 0);
    attempt.see(20);
    EXPECT_EQ(attempt.tracker().index(), 1) << "3 mm beside the mark";
    attempt.needle.point_m = Vec3(0.001, 0, 0.001);
    attempt.see(12);
    EXPECT_EQ(attempt.tracker().index(), 2);
    attempt.needle.middle_m = Vec3(0.003, 0, 0);
    attempt.needle.lowest_m = 0.001;
    attempt.see(20);
    EXPECT_EQ(attempt.tracker().index(), 2) << "still in the jaws";
    attempt.needle.held[1] = false;
    attempt.see(12);
    EXPECT_TRUE(attempt.tracker().done());
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleShown), 1);
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleLaid), 1);
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 0);
}

TEST(Practice, ANeedleThatIsLetGoElsewhereOrFromHighIsDropped) {
    Attempt attempt(handling());
    attempt.needle.handled = true;
    attempt.see(2);  // it lies there: nobody has dropped it
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 0);
    attempt.needle.held[0] = true;
    attempt.see();
    attempt.needle.held[1] = true;
    attempt.needle.share[1] = 0.33;
    attempt.see();
    attempt.needle.held[0] = false;  // handed over
    attempt.see();
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 0);
    attempt.needle.held[1] = false;
    attempt.see(5);
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 1);
    attempt.needle.held[1] = true;
    attempt.see(20);
    EXPECT_EQ(attempt.tracker().index(), 2);
    attempt.needle.lowest_m = 0.008;  // over its mark, but high above it
    attempt.needle.held[1] = false;
    attempt.see();
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 2);
    attempt.needle.held[1] = true;
    attempt.see();
    attempt.needle.in_tissue = true;  // left in the tissue it does not fall
    attempt.needle.held[1] = false;
    attempt.see();
    EXPECT_EQ(told(attempt.recording, sim::EventKind::kNeedleDropped), 2);
}

}  // namespace THIS_TEST
}  // namespace placode::assessment
