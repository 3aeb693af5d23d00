// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "assessment/wanted_metrics.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/definitions.h"
#include "environment/expert.h"
#include "sim/world/saved_state.h"
#include "tests/environment_fixture.h"

namespace placode::environment {
namespace THIS_TEST {

using test::coarse;
using test::observation_of;
using test::random_action;
using testing::HasSubstr;

std::shared_ptr<FieldCache> fields() { return std::make_shared<FieldCache>(); }

EnvironmentError::Kind refused(const std::function<void()>& call, const char* words) {
    try {
        call();
    } catch (const EnvironmentError& error) {
        EXPECT_THAT(error.what(), HasSubstr(words));
        return error.kind();
    }
    ADD_FAILURE() << "not refused: " << words;
    return EnvironmentError::Kind::kOtherTask;
}

/// An attempt of the scripted expert in steps of 10 frames.
StepOutcome perform(Environment& environment, double& score_parts) {
    Expert expert(environment, "expert", 1);
    std::vector<double> action(environment.tools() * kActionSize);
    StepOutcome outcome;
    while (!environment.ended()) {
        const bool done = expert.act(environment, 10, action);
        outcome = environment.step(action, 10, done);
        score_parts += outcome.score_part;
    }
    return outcome;
}

TEST(Environment, AScoreAskedForOnTheWayLeavesOutOnlyWhatNobodyWants) {
    const auto shared = fields();
    for (const char* task : {"touch_targets", "two_handed_traction", "diathermy_ring_small"}) {
        EnvironmentOptions options = coarse();
        options.units = ActionUnits::kAbsolute;
        options.record = true;
        options.judge_every_s = 0.5;
        Environment environment(shared, task, options);
        environment.reset(1);
        Expert expert(environment, "expert", 1);
        std::vector<double> action(environment.tools() * kActionSize);
        for (int i = 0; i < 400; ++i) {
            (void)expert.act(environment, 10, action);
            (void)environment.step(action, 10);
            if (environment.state().time_s != environment.judged().at_s) continue;
            const Judgement full = environment.judge_in_full();
            EXPECT_EQ(full.score.points, environment.judged().score.points) << task;
            EXPECT_EQ(full.score.reasons.size(), environment.judged().score.reasons.size()) << task;
            EXPECT_GT(full.metrics.values.size(), environment.judged().metrics.values.size());
        }
        (void)environment.step(action, 10, true);
        const sim::Recording& recording = environment.recording();
        const assessment::MetricSet all = assessment::compute_metrics(recording);
        EXPECT_EQ(environment.judged().metrics.values.size(), all.values.size());
        for (const assessment::MetricDefinition& definition : assessment::metric_definitions()) {
            const auto some = assessment::compute_metrics(recording, {{definition.id}});
            EXPECT_EQ(some.find(definition.id), all.find(definition.id))
                << task << ", " << definition.id;
        }
    }
}

TEST(Environment, AnExpertPassesAndItsRecordingReplaysWithTheSameScore) {
    EnvironmentOptions options = coarse();
    options.units = ActionUnits::kAbsolute;
    options.record = true;
    Environment environment(fields(), "touch_targets", options);
    environment.reset(3);
    double parts = 0;
    const StepOutcome last = perform(environment, parts);
    EXPECT_EQ(last.end, sim::EndReason::kFinished);
    EXPECT_TRUE(last.success);
    const sim::Recording& recording = environment.recording();
    EXPECT_TRUE(recording.header.demonstration);
    EXPECT_EQ(recording.header.device, "environment");
    const curriculum::ReplayResult replayed = curriculum::replay(recording, 1);
    EXPECT_TRUE(replayed.identical) << replayed.message;
    EXPECT_EQ(replayed.frames, static_cast<int64_t>(recording.inputs.size()));
    // The points of the dense reward are those that anybody gets for this recording.
    const assessment::Score score = assessment::score_attempt(
        environment.task().rubric, assessment::compute_metrics(recording), recording);
    EXPECT_GT(score.points, 80);
    EXPECT_NEAR(100 * parts, score.points, 1e-9);
    EXPECT_EQ(environment.judged().score.points, score.points);
}

TEST(Environment, WhoDoesNothingGetsNothingAndIsStoppedByTheClock) {
    EnvironmentOptions options = coarse();
    options.time_limit_s = 1;
    Environment environment(fields(), "trace_contour", options);
    environment.reset(1);
    const std::vector<double> still(environment.tools() * kActionSize, 0.0);
    double reward = 0;
    StepOutcome outcome;
    while (!environment.ended()) reward += (outcome = environment.step(still, 100)).reward;
    EXPECT_EQ(outcome.end, sim::EndReason::kTimeLimit);
    EXPECT_FALSE(outcome.success);
    EXPECT_EQ(environment.judged().score.verdict, assessment::Verdict::kNotAttempted);
    EXPECT_NEAR(reward, 0, 1e-6);
    EXPECT_NEAR(environment.state().time_s, 1, 1e-9);
}

TEST(Environment, AMomentGoesOnAsBeforeHereAndElsewhere) {
    const auto shared = fields();
    EnvironmentOptions options = coarse();
    options.record = true;
    for (const char* task : {"diathermy_ring_small", "two_handed_traction"}) {
        SCOPED_TRACE(task);
        Environment first(shared, task, options);
        options.threads = 2;
        Environment second(shared, task, options);
        options.threads = 1;
        first.reset(1);
        sim::SplitMix64 random(5);
        for (int i = 0; i < 20; ++i) first.step(random_action(first, random), 20);
        SavedMoment moment;
        first.save(moment);
        const auto go_on = [](Environment& environment) {
            sim::SplitMix64 again(7);
            std::vector<double> all;
            for (int i = 0; i < 30; ++i) {
                all.push_back(environment.step(random_action(environment, again), 20).reward);
                const auto seen = observation_of(environment);
                all.insert(all.end(), seen.begin(), seen.end());
            }
            all.push_back(static_cast<double>(environment.events().size()));
            return all;
        };
        const std::vector<double> once = go_on(first);
        const uint64_t hash = sim::whole_hash(first.state());
        first.restore(moment);
        EXPECT_EQ(go_on(first), once);
        EXPECT_EQ(sim::whole_hash(first.state()), hash);
        second.restore(moment);
        EXPECT_EQ(go_on(second), once);
        EXPECT_EQ(sim::whole_hash(second.state()), hash);
        // What was recorded before the moment belongs to it.
        second.step(random_action(second, random), 1, true);
        const curriculum::ReplayResult replayed = curriculum::replay(second.recording(), 1);
        EXPECT_TRUE(replayed.identical) << replayed.message;
    }
    Environment other(shared, "trace_contour", coarse());
    SavedMoment moment;
    EXPECT_EQ(refused([&] { other.restore(moment); }, "save first"),
              EnvironmentError::Kind::kBadArgument);
    Environment first(shared, "touch_targets", coarse());
    first.reset(1);
    first.save(moment);
    EXPECT_EQ(refused([&] { other.restore(moment); }, "another task"),
              EnvironmentError::Kind::kOtherTask);
}

TEST(Environment, AMomentOfAnAttemptWithoutInputsGivesNoRecordingElsewhere) {
    const auto shared = fields();
    EnvironmentOptions options = coarse();
    Environment without(shared, "touch_targets", options);
    options.record = true;
    Environment with(shared, "touch_targets", options);
    const std::vector<double> action(with.tools() * kActionSize, 0.0);
    SavedMoment moment;
    without.reset(1);
    without.step(action, 5);
    without.save(moment);
    with.restore(moment);
    with.step(action, 5, true);
    ASSERT_TRUE(with.ended());
    EXPECT_EQ(refused([&] { (void)with.recording(); }, "option record"),
              EnvironmentError::Kind::kBadArgument);
    // The other way round its inputs are there, and it replays.
    with.reset(1);
    with.step(action, 5);
    with.save(moment);
    without.restore(moment);
    without.step(action, 5, true);
    EXPECT_TRUE(curriculum::replay(without.recording(), 1).identical);
    // A new attempt is as the environment is made.
    with.reset(1);
    with.step(action, 5, true);
    EXPECT_EQ(with.recording().inputs.size(), 5U);
    without.reset(1);
    without.step(action, 5, true);
    EXPECT_EQ(refused([&] { (void)without.recording(); }, "option record"),
              EnvironmentError::Kind::kBadArgument);
}

TEST(Environment, EnvironmentsShareTheField) {
    const auto shared = fields();
    Environment one(shared, "touch_targets", coarse()), two(shared, "touch_targets", coarse());
    one.reset(1);
    two.reset(99);  // one field for all seeds
    EXPECT_EQ(one.field().scene, two.field().scene);
    EXPECT_EQ(shared->built(), 1U);
    EnvironmentOptions each = coarse();
    each.fields = 2;
    Environment three(shared, "touch_targets", each);
    three.reset(0);
    EXPECT_EQ(shared->built(), 1U);  // field 1 again
    three.reset(1);
    EXPECT_EQ(shared->built(), 2U);
    EXPECT_NE(three.field().scene, one.field().scene);
    three.reset(4);
    EXPECT_EQ(three.field().scene, one.field().scene);
}

TEST(Environment, WhatIsWrongIsRefusedAndNothingHappens) {
    Environment environment(fields(), "touch_targets", coarse());
    std::vector<double> action(environment.tools() * kActionSize, 0.0);
    EXPECT_EQ(refused([&] { environment.step(action, 1); }, "reset"),
              EnvironmentError::Kind::kNotReset);
    environment.reset(1);
    const uint64_t before = sim::whole_hash(environment.state());
    action[3] = std::nan("");
    EXPECT_EQ(refused([&] { environment.step(action, 1); }, "number 3"),
              EnvironmentError::Kind::kBadArgument);
    action[3] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refused([&] { environment.step(action, 1); }, "not finite"),
              EnvironmentError::Kind::kBadArgument);
    action[3] = 0;
    EXPECT_EQ(refused(
                  [&] {
                      environment.step({action.data(), 3}, 1);
                  },
                  "expected 16"),
              EnvironmentError::Kind::kBadArgument);
    EXPECT_EQ(refused([&] { environment.step(action, 0); }, "0 frames"),
              EnvironmentError::Kind::kBadArgument);
    std::vector<double> small(3);
    EXPECT_EQ(refused([&] { environment.observe(small); }, "room for 3"),
              EnvironmentError::Kind::kBadArgument);
    EXPECT_EQ(sim::whole_hash(environment.state()), before);
    environment.step(action, 1, true);
    EXPECT_EQ(refused([&] { environment.step(action, 1); }, "over"),
              EnvironmentError::Kind::kEnded);
    EXPECT_EQ(refused([&] { (void)environment.recording(); }, "option record"),
              EnvironmentError::Kind::kBadArgument);
    EXPECT_THROW(Environment(fields(), "touch_target", {}), curriculum::DefinitionError);
    EnvironmentOptions options;
    options.scene_changes_json = R"({"edge_ring": 1})";
    EXPECT_THROW(Environment(fields(), "touch_targets", options), curriculum::DefinitionError);
    options = {};
    options.speed_m_s = 1;
    EXPECT_EQ(refused([&] { Environment(fields(), "touch_targets", options); }, "speed_m_s"),
              EnvironmentError::Kind::kBadArgument);
}

TEST(Environment, AnObservationSaysWhereToGo) {
    EnvironmentOptions options = coarse();
    Environment environment(fields(), "touch_targets", options);
    environment.reset(1);
    const auto& names = environment.observation_names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    std::vector<double> action(environment.tools() * kActionSize, 0.0);
    environment.step(action, 1);
    const auto away = [&] {
        return std::hypot(test::seen(environment, "tool0.to_goal_x_mm"),
                          test::seen(environment, "tool0.to_goal_y_mm"),
                          test::seen(environment, "tool0.to_goal_z_mm"));
    };
    EXPECT_EQ(test::seen(environment, "tool0.has_goal"), 1);
    EXPECT_EQ(test::seen(environment, "steps"), 8);
    const double before = away();
    double approach = 0;
    for (int i = 0; i < 10; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            const std::string axis(1, "xyz"[k]);
            action[k] = test::seen(environment, "tool0.to_goal_" + axis + "_mm") / before;
        }
        approach += environment.step(action, 20).approach_part;
    }
    EXPECT_LT(away(), before - 4);
    EXPECT_NEAR(approach, 0.2 * (before - away()) / 20, 1e-6);
    for (const double number : observation_of(environment)) EXPECT_TRUE(std::isfinite(number));
}

TEST(Environment, ABiteIsSeenAndRewardedByTheNeedlesPoint) {
    EnvironmentOptions options;
    options.units = ActionUnits::kAbsolute;
    options.fields = 1;
    options.record = true;
    Environment environment(fields(), "suture_bite", options);
    environment.reset(1);
    const auto& names = environment.observation_names();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    EXPECT_EQ(names.back(), "harm.thread_cuts") << "the needle's numbers come last";
    const auto seen = [&](const char* name) { return test::seen(environment, name); };
    // The first look shows the needle where the first frame has it, and not at the origin.
    EXPECT_EQ(seen("needle.held"), 1);
    const double point_z_mm = seen("needle.point_z_mm");
    EXPECT_GT(point_z_mm, 5);
    Expert expert(environment, "expert", 1);
    std::vector<double> action(environment.tools() * kActionSize);
    double parts = 0;
    bool held_at_first = false, goal_from_point = false, through_has_no_goal = false;
    while (!environment.ended()) {
        const bool done = expert.act(environment, 10, action);
        parts += environment.step(action, 10, done).score_part;
        if (environment.state().frame == 10) {
            EXPECT_NEAR(seen("needle.point_z_mm"), point_z_mm, 0.5);
        }
        if (seen("steps_done") == 0) {
            held_at_first = held_at_first || seen("needle.held") == 1;
            // The way to the mark begins where the needle's point is.
            const sim::Vec3 mark = environment.look().practice.target_m[0];
            goal_from_point = std::abs(seen("needle.point_x_mm") + seen("tool0.to_goal_x_mm") -
                                       1000 * mark.x()) < 1e-6;
        }
        if (seen("steps_done") == 3) through_has_no_goal = seen("tool0.has_goal") == 0;
    }
    EXPECT_TRUE(held_at_first);
    EXPECT_TRUE(goal_from_point);
    EXPECT_TRUE(through_has_no_goal);
    EXPECT_EQ(seen("needle.bites"), 1);
    EXPECT_EQ(seen("needle.exits"), 1);
    EXPECT_EQ(seen("needle.drawn_through"), 1);
    EXPECT_EQ(environment.judged().score.verdict, assessment::Verdict::kPassed);
    EXPECT_NEAR(100 * parts, environment.judged().score.points, 1e-9);
    EXPECT_TRUE(curriculum::replay(environment.recording(), 1).identical);
}

TEST(Environment, DroppingTheNeedleBringsNoReward) {
    EnvironmentOptions options;
    options.fields = 1;
    Environment environment(fields(), "suture_bite", options);
    environment.reset(1);
    std::vector<double> action(environment.tools() * kActionSize, 0.0);
    // The needle comes with the first frame: its way to the mark is no loss.
    EXPECT_EQ(environment.step(action, 1).approach_part, 0);
    // Jaws closed once, then opened; nothing else moves.
    double approach = 0;
    action[4] = -1;
    for (int i = 0; i < 20; ++i) approach += environment.step(action, 20).approach_part;
    action[4] = 1;
    for (int i = 0; i < 20; ++i) approach += environment.step(action, 20).approach_part;
    EXPECT_EQ(test::seen(environment, "needle.held"), 0);
    EXPECT_LE(approach, 1e-3);
}

TEST(Hands, MoveNoFasterThanHandsDoAndTakeTurnsInAPort) {
    const curriculum::Task task = curriculum::load_task("sb_dissection");
    Hands hands(task.scene.tools);
    std::array<sim::ToolInput, sim::kMaxTools> inputs;
    const size_t tools = task.scene.tools.size();
    const auto tip = [&](size_t i) { return inputs[i].pose().p; };
    hands.next({inputs.data(), tools});
    std::vector<double> action(tools * kActionSize, 0.0);
    action[0] = 0.05;  // far away, in one frame
    action[5] = action[6] = 1;
    const sim::Vec3 before = tip(0);
    hands.aim(ActionUnits::kAbsolute, 0.03, action, 1, 1e-3);
    hands.next({inputs.data(), tools});
    EXPECT_NEAR((tip(0) - before).norm(), 0.3e-3, 1e-8);
    EXPECT_EQ(inputs[0].pedals, 0) << "both pedals at once are none";
    // Two of the tools belong to the right hand.
    std::vector<size_t> right;
    for (size_t i = 0; i < tools; ++i)
        if (haptics::others_in_port(task.scene.tools, i) != 0) right.push_back(i);
    ASSERT_EQ(right.size(), 2U);
    action[right[0] * kActionSize + 7] = 0.6;
    action[right[1] * kActionSize + 7] = 0.9;
    hands.aim(ActionUnits::kAbsolute, 0.03, action, 1, 1e-3);
    hands.next({inputs.data(), tools});
    EXPECT_EQ(inputs[right[0]].engaged, 0);
    EXPECT_EQ(inputs[right[1]].engaged, 1);
    // A whole step of a normalised 1 is speed times time.
    Hands steady(task.scene.tools);
    steady.next({inputs.data(), tools});
    const sim::Vec3 from = tip(0);
    std::fill(action.begin(), action.end(), 0.0);
    action[2] = 5;  // beyond the range counts as its end
    steady.aim(ActionUnits::kNormalised, 0.03, action, 50, 1e-3);
    for (int f = 0; f < 50; ++f) steady.next({inputs.data(), tools});
    EXPECT_NEAR((tip(0) - from).z(), 0.03 * 0.05, 1e-7);
}

}  // namespace THIS_TEST
}  // namespace placode::environment
