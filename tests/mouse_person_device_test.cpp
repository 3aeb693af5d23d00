// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A mouse can do it: whole attempts through window events, the real mouse device and its mapping,
// on a coarse field. In step with the simulation, so that the machine's speed changes nothing.

#include <gtest/gtest.h>

#include "assessment/ledger.h"
#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

struct Outcome {
    sim::Recording recording;
    assessment::MetricSet metrics;
    assessment::Score score;
};

Outcome by_mouse(const std::string& id) {
    const Task task = test::changed_task(id, {{"edge_ring_m", "0.0008"},
                                              {"edge_placode_m", "0.0014"},
                                              {"edge_outer_m", "0.003"},
                                              {"settle_s", "0.05"}});
    Outcome out;
    out.recording = test::scripted_attempt(task, "mouse");
    out.metrics = assessment::compute_metrics(out.recording);
    out.score = assessment::score_attempt(task.rubric, out.metrics, out.recording);
    return out;
}

double value(const Outcome& outcome, const char* metric) {
    return outcome.metrics.find(metric).value_or(-1);
}

TEST(MousePerson, DoesEveryStepOfTheTutorial) {
    const Outcome tutorial = by_mouse("familiarisation");
    EXPECT_EQ(value(tutorial, "steps_done_percent"), 100);
    EXPECT_EQ(tutorial.score.verdict, assessment::Verdict::kPassed) << tutorial.score.points;
}

TEST(MousePerson, TakesABite) {
    const Task task = load_task("suture_bite");
    const sim::Recording recording = test::scripted_attempt(task, "mouse");
    const assessment::MetricSet metrics = assessment::compute_metrics(recording);
    const assessment::Score score = assessment::score_attempt(task.rubric, metrics, recording);
    EXPECT_EQ(metrics.find("steps_done_percent").value_or(-1), 100);
    EXPECT_EQ(score.verdict, assessment::Verdict::kPassed) << score.points;
}

// One mouse for two drivers: Tab leaves the jaws closed on the needle, a click opens them.
TEST(MousePerson, HandsANeedleOver) {
    const Task task = load_task("needle_handover");
    const sim::Recording recording = test::scripted_attempt(task, "mouse");
    const assessment::MetricSet metrics = assessment::compute_metrics(recording);
    const assessment::Score score = assessment::score_attempt(task.rubric, metrics, recording);
    EXPECT_EQ(metrics.find("steps_done_percent").value_or(-1), 100);
    EXPECT_EQ(metrics.find("needle_handovers").value_or(-1), 2);
    EXPECT_EQ(metrics.find("needle_drops").value_or(-1), 0);
    EXPECT_EQ(score.verdict, assessment::Verdict::kPassed) << score.points;
}

TEST(MousePerson, SewsARow) {
    const Task task = test::coarse_suture_run();
    const sim::Recording recording = test::scripted_attempt(task, "mouse");
    const assessment::MetricSet metrics = assessment::compute_metrics(recording);
    EXPECT_EQ(metrics.find("steps_done_percent").value_or(-1), 100);
    EXPECT_EQ(metrics.find("bites_done").value_or(-1), 3);
    EXPECT_EQ(metrics.find("torn_volume_mm3").value_or(-1), 0);
    EXPECT_EQ(metrics.find("thread_cuts").value_or(-1), 0);
}

TEST(MousePerson, TakesThePieceOut) {
    const Outcome resection = by_mouse("scissors_resection");
    // On so coarse a field about half of it comes out whole: 49 % seen.
    EXPECT_GT(value(resection, "resected_percent"), 45);
    EXPECT_GT(value(resection, "pieces_out"), 0);
    EXPECT_EQ(value(resection, "placode_cut_mm3"), 0);
    EXPECT_EQ(resection.score.verdict, assessment::Verdict::kPassed) << resection.score.points;
    // Nobody incises without an instrument that carries current.
    const auto phases = assessment::phase_starts(resection.recording.events);
    ASSERT_GE(phases.size(), 3U);
    EXPECT_EQ(phases[0].phase, sim::Phase::kInspect);
    EXPECT_EQ(phases[1].phase, sim::Phase::kResect);
    EXPECT_EQ(phases[2].phase, sim::Phase::kCheck);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
