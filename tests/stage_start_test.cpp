// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts that begin at a stage of their task: what was given, and that nobody can hide it.

#include "curriculum/stage_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

#include "assessment/scoring.h"
#include "assessment/soundness.h"
#include "curriculum/replay.h"
#include "curriculum/replay_check.h"
#include "sim/anatomy/operative_field.h"
#include "sim/step/begin_here.h"
#include "sim/step/step.h"
#include "sim/world/saved_state.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

using sim::Recording;

constexpr int kBeforeStep = 2;

/// A task that is done quickly, with two stages.
Task staged_task() {
    std::string json = load_task("touch_targets").json;
    const std::string rubric = ",\"rubric\":";
    const size_t at = json.find(rubric);
    EXPECT_NE(at, std::string::npos);
    json.insert(at,
                ",\"stages\":[{\"before_step\":2,\"title\":{\"en\":\"second\",\"pl\":\"d\"}},"
                "{\"before_step\":4,\"title\":{\"en\":\"third\",\"pl\":\"t\"}}]");
    return load_task_text(json, "staged");
}

const std::shared_ptr<const StageStart>& first_start() {
    static const auto start = make_stage_start(staged_task(), 1, 1, 1);
    return start;
}

Recording attempt_from(const std::shared_ptr<const StageStart>& start, double seconds,
                       int threads = 1) {
    AttemptOptions options = test::scripted("expert");
    options.threads = threads;
    options.duration_s = seconds;
    options.start = start;
    return test::recorded(staged_task(), 1, options);
}

const Recording& honest() {
    static const Recording recording = attempt_from(first_start(), 0);
    return recording;
}

ReplayVerdict check_replay(const Recording& recording, const Task& published, int threads = 1) {
    ReplayCheck check(recording, published, threads);
    while (check.step()) {
    }
    return check.verdict();
}

bool same_inputs(const std::vector<sim::Input>& a, const std::vector<sim::Input>& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(sim::Input)) == 0;
}

TEST(StageStart, IsTheSameWithAnyNumberOfThreads) {
    ASSERT_NE(first_start(), nullptr);
    const auto again = make_stage_start(staged_task(), 1, 1, 2);
    ASSERT_NE(again, nullptr);
    EXPECT_TRUE(same_inputs(again->given, first_start()->given));
    EXPECT_EQ(again->hash, first_start()->hash);
    EXPECT_EQ(again->state, first_start()->state);
    EXPECT_EQ(again->stage, 1);
}

TEST(StageStart, HandsAreBackWhereTheyBeganAndNothingIsHeld) {
    const StageStart& start = *first_start();
    ASSERT_GT(start.given.size(), 1000U);
    const sim::Input &first = start.given.front(), &last = start.given.back();
    for (int tool = 0; tool < first.tool_count; ++tool) {
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(last.tools[tool].position_m[k], first.tools[tool].position_m[k], 1e-6);
        EXPECT_EQ(last.tools[tool].pedals, 0);
    }
    Task task = staged_task();
    task.scene.seed = 1;
    const auto scene = sim::build_operative_field(task.scene);
    sim::State state(*scene, 1);
    sim::load_state(*scene, state, start.state);
    EXPECT_EQ(state.frame, 0);
    EXPECT_EQ(state.time_s, 0);
    EXPECT_EQ(sim::whole_hash(state), start.hash);
    for (const sim::Grasp& grasp : state.grasps) EXPECT_EQ(grasp.count, 0);
    for (const sim::ToolState& tool : state.tools) EXPECT_EQ(tool.engaged, 0);
}

TEST(StageStart, InputsAloneLeadToTheSameState) {
    Task task = staged_task();
    task.scene.seed = 1;
    const auto scene = sim::build_operative_field(task.scene);
    sim::State state(*scene, 2);
    sim::settle(*scene, state, task.settle_s);
    double last = -1;
    simulate_given(*scene, state, first_start()->given,
                   [&](double share, const auto&, const auto&) {
                       EXPECT_GT(share, last);
                       last = share;
                   });
    EXPECT_EQ(sim::whole_hash(state), first_start()->hash);
    EXPECT_GT(last, 0.9);
}

TEST(StageStart, CanBeStoppedAndSaysHowFarItIs) {
    int told = 0;
    double last = 0;
    const auto stopped =
        make_stage_start(staged_task(), 1, 2, 1, [&](double share, const auto&, const auto&) {
            EXPECT_GE(share, 0);
            EXPECT_LE(share, 1);
            last = share;
            return ++told < 20;
        });
    EXPECT_EQ(stopped, nullptr);
    EXPECT_EQ(told, 20);
    EXPECT_LT(last, 1);
}

TEST(StageStart, AStageThatTheExpertDoesNotReachIsNamed) {
    Task task = staged_task();
    task.time_limit_s = 0.2;
    EXPECT_THROW((void)make_stage_start(task, 1, 1, 1), StageError);
    EXPECT_THROW((void)make_stage_start(staged_task(), 1, 3, 1), DefinitionError);
}

TEST(StageStart, TheAttemptHasTheTraineesOwnPartOnly) {
    const Recording& own = honest();
    EXPECT_EQ(own.header.stage, 1);
    EXPECT_EQ(own.header.given_frames, std::ssize(first_start()->given));
    EXPECT_TRUE(same_inputs(own.given, first_start()->given));
    ASSERT_FALSE(own.inputs.empty());
    EXPECT_EQ(own.inputs.front().frame, 0);
    EXPECT_NEAR(own.samples.front().time_s, 0.01, 1e-9);
    EXPECT_EQ(own.end.reason, sim::EndReason::kFinished);
    const auto steps = static_cast<float>(staged_task().steps.size());
    int done = 0;
    for (const sim::Event& event : own.events) {
        if (event.kind == sim::EventKind::kPracticeSteps) {
            EXPECT_EQ(event.value, steps - kBeforeStep);
        }
        if (event.kind != sim::EventKind::kStepDone) continue;
        ++done;
        EXPECT_GE(event.value, kBeforeStep);
    }
    EXPECT_EQ(done, static_cast<int>(steps) - kBeforeStep);
    const auto problem = assessment::unsound(own);
    EXPECT_FALSE(problem) << problem->english();
    const auto metrics = assessment::compute_metrics(own);
    EXPECT_EQ(metrics.find("steps_done_percent").value_or(0), 100);
}

TEST(StageStart, ItHasNoPointsHoweverWellItWasDone) {
    const assessment::Score score = assessment::score_attempt(
        staged_task().rubric, assessment::compute_metrics(honest()), honest());
    EXPECT_EQ(score.points, 0);
    EXPECT_EQ(score.verdict, assessment::Verdict::kNotYet);
    ASSERT_EQ(score.reasons.size(), 1U);
    EXPECT_EQ(score.reasons[0].item, assessment::kGivenItem);
    EXPECT_EQ(score.reasons[0].text, "Not scored: begun at stage 1, what came before was given.");
}

TEST(StageStart, ReplaysExactlyOnOneThreadAndOnTwo) {
    for (const int threads : {1, 2}) {
        const ReplayResult result = replay(honest(), threads);
        EXPECT_TRUE(result.identical) << result.message;
        EXPECT_EQ(result.frames, std::ssize(honest().inputs));
        const ReplayVerdict verdict = check_replay(honest(), staged_task(), threads);
        EXPECT_TRUE(verdict.identical) << verdict.difference.english();
    }
}

TEST(StageStart, ACheckCountsWhatWasGivenFrameByFrameAndMayStopInIt) {
    const auto given = static_cast<double>(honest().given.size());
    const double all = given + static_cast<double>(honest().inputs.size());
    ReplayCheck stopped(honest(), staged_task(), 1);
    EXPECT_EQ(stopped.share(), 0);
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(stopped.step());
    EXPECT_DOUBLE_EQ(stopped.share(), 20 / all);
    ReplayCheck check(honest(), staged_task(), 1);
    double steps = 0;
    for (; check.step(); ++steps) ASSERT_DOUBLE_EQ(check.share(), (steps + 1) / all);
    EXPECT_EQ(steps, all);
    const ReplayVerdict verdict = check.verdict();
    EXPECT_TRUE(verdict.identical) << verdict.difference.english();
}

TEST(StageStart, AKnownStateIsUsedWhereItIsTheRecordedOneOnly) {
    int told = 0;
    const auto count = [&](double, const sim::Scene&, const sim::State&) { ++told; };
    const std::vector<uint8_t>& right = first_start()->state;
    Replay known(honest(), 1, 0, {&right, count});
    EXPECT_EQ(told, 0) << "nothing was simulated";
    while (known.step()) {
    }
    EXPECT_TRUE(known.result().identical) << known.result().message;
    std::vector<uint8_t> damaged = right, cut = right;
    damaged[damaged.size() / 2] ^= 1;
    cut.resize(cut.size() / 2);
    for (const auto& wrong : std::vector<std::vector<uint8_t>>{damaged, cut, {}}) {
        told = 0;
        Replay simulated(honest(), 1, 0, {&wrong, count});
        EXPECT_GT(told, 0);
        EXPECT_EQ(simulated.state().frame, 0);
        EXPECT_TRUE(simulated.step());
    }
}

TEST(StageStart, GoingBackToTheBeginningIsGoingBackToTheStage) {
    Replay replay(honest(), 1, size_t{100} << 20);
    const uint64_t first = sim::whole_hash(replay.state());
    EXPECT_EQ(first, first_start()->hash);
    EXPECT_EQ(replay.practice().index, kBeforeStep);
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(replay.step());
    replay.back_to(0.1);
    EXPECT_EQ(replay.state().frame, 0);
    EXPECT_EQ(sim::whole_hash(replay.state()), first);
    EXPECT_EQ(replay.practice().index, kBeforeStep);
    while (replay.step()) {
    }
    EXPECT_TRUE(replay.result().identical) << replay.result().message;
}

TEST(StageStart, WhoHidesOrChangesWhatWasGivenIsFoundOut) {
    const Task task = staged_task();
    struct Forgery {
        const char* name;
        std::function<void(Recording&)> make;
        bool sound;  // Only the replay finds it.
    };
    const Forgery forgeries[]{
        {"from the beginning",
         [](Recording& r) {
             r.header.stage = 0;
             r.header.given_frames = 0;
             r.header.given_hash = 0;
             r.given.clear();
         },
         true},
        {"the head is silent", [](Recording& r) { r.header.stage = 0; }, false},
        {"less was given",
         [](Recording& r) {
             r.given.resize(r.given.size() / 2);
             r.header.given_frames = std::ssize(r.given);
         },
         true},
        {"less than is told", [](Recording& r) { r.given.pop_back(); }, false},
        {"another hash", [](Recording& r) { r.header.given_hash ^= 1; }, true},
        {"another stage", [](Recording& r) { r.header.stage = 2; }, true},
        {"a stage that is not there", [](Recording& r) { r.header.stage = 7; }, true},
        {"a stage that cannot be", [](Recording& r) { r.header.stage = -1; }, false},
        {"other hands",
         [](Recording& r) {
             for (size_t i = r.given.size() - 40; i < r.given.size(); ++i)
                 r.given[i].tools[0].position_m[0] += 1e-3F;
         },
         true},
        {"hands that lie nowhere", [](Recording& r) { r.given[500].tools[0].position_m[2] = 1e9F; },
         false},
        {"frames out of turn", [](Recording& r) { r.given[500].frame = 7; }, false},
        {"another number of tools", [](Recording& r) { r.given[500].tool_count = 1; }, false},
    };
    for (const Forgery& forgery : forgeries) {
        Recording forged = honest();
        forgery.make(forged);
        EXPECT_EQ(!assessment::unsound(forged), forgery.sound) << forgery.name;
        if (!forgery.sound) continue;  // It is never simulated.
        const ReplayVerdict verdict = check_replay(forged, task);
        EXPECT_FALSE(verdict.identical) << forgery.name;
        // The state alone does not know which steps were asked for.
        if (std::string(forgery.name) != "another stage") {
            EXPECT_FALSE(replay(forged, 1).identical) << forgery.name;
        }
    }
}

TEST(StageStart, ATaskWithoutStagesTakesNone) {
    Recording forged = honest();
    const ReplayVerdict verdict = check_replay(forged, load_task("touch_targets"));
    EXPECT_FALSE(verdict.identical);
}

TEST(StageStart, ExamsAndStudiesBeginWithTheBeginning) {
    for (const AttemptMode mode : {AttemptMode::kExam, AttemptMode::kStudy}) {
        AttemptOptions options = test::scripted("expert");
        options.start = first_start();
        options.mode = mode;
        EXPECT_THROW(AttemptRunner(staged_task(), 1, options, nullptr), DefinitionError);
    }
}

const std::shared_ptr<const StageStart>& second_bite() {
    static const auto start = make_stage_start(test::coarse_suture_run(), 1, 1, 2);
    return start;
}

/// The second bite of a row: the driver has its needle, the thread runs through the first one.
struct SecondBite {
    SecondBite() {
        Task task = test::coarse_suture_run();
        task.scene.seed = 1;
        scene = sim::build_operative_field(task.scene);
        state = std::make_unique<sim::State>(*scene, 2);
        if (start) sim::load_state(*scene, *state, start->state);
    }
    /// So many frames with the hands as they were last, but for the driver.
    void frames(int count, bool engaged, float jaw_rad) {
        std::array<sim::ToolInput, sim::kMaxTools> hands{};
        std::array<sim::ToolFeedback, sim::kMaxTools> feedback{};
        std::copy(std::begin(start->given.back().tools), std::end(start->given.back().tools),
                  hands.begin());
        hands[0].engaged = engaged ? 1 : 0;
        hands[0].jaw_rad = jaw_rad;
        const size_t tools = scene->tools.size();
        for (int i = 0; i < count; ++i)
            (void)sim::step(*scene, *state, {hands.data(), tools}, {feedback.data(), tools});
    }
    std::shared_ptr<const StageStart> start = second_bite();
    std::shared_ptr<const sim::Scene> scene;
    std::unique_ptr<sim::State> state;
};

TEST(StageStart, ANeedleStaysInTheJawsUntilAHandHasClosedThem) {
    SecondBite second;
    ASSERT_NE(second.start, nullptr);
    const sim::Suturing& s = second.state->suturing;
    ASSERT_EQ(second.scene->tools[0].kind, sim::ToolKind::kNeedleDriver);
    EXPECT_EQ(s.driver, 0);
    EXPECT_EQ(s.locked, sim::kLockedUntilEngaged);
    EXPECT_EQ(s.needle[0].passage_count, 0) << "all of it is drawn through";
    EXPECT_GE(s.needle[0].thread.channel_count, 1);
    EXPECT_EQ(s.taken + s.entered + s.left + s.through, 0);
    second.frames(20, false, 0);
    EXPECT_EQ(s.driver, 0) << "no hand has come";
    second.frames(20, true, 0.9F);
    EXPECT_EQ(s.driver, 0) << "jaws that have not closed yet";
    second.frames(20, true, 0);
    second.frames(20, true, 0.9F);
    EXPECT_EQ(s.driver, -1) << "now they have, and let go";
    EXPECT_EQ(second.state->frame, 80);
}

TEST(StageStart, ASecondBiteIsRecordedWithItsNeedleInHand) {
    const Task task = test::coarse_suture_run();
    AttemptOptions options = test::scripted("expert");
    options.threads = 2;
    options.duration_s = 4;
    options.start = second_bite();
    ASSERT_NE(options.start, nullptr);
    const Recording own = test::recorded(task, 1, options);
    ASSERT_EQ(own.inputs.size(), 4000U);
    for (const sim::Event& event : own.events) {
        EXPECT_NE(event.kind, sim::EventKind::kNeedleReleased) << event.time_s;
        EXPECT_NE(event.kind, sim::EventKind::kNeedleTaken) << event.time_s;
    }
    EXPECT_TRUE(replay(own, 1).identical);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
