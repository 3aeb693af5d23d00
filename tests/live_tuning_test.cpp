// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Tissue changed between two frames.

#include "sim/step/live_tuning.h"

#include <gtest/gtest.h>

#include <memory>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "tests/attempt_fixture.h"

namespace placode::sim {
namespace THIS_TEST {

using curriculum::Task;

Task coarse(const char* id) { return test::tiny_task(id); }

Event tuning(TuneParameter parameter, Tissue tissue, double value) {
    Event event;
    event.kind = EventKind::kTuned;
    event.element = static_cast<int32_t>(parameter);
    event.tissue = tissue;
    event.value = static_cast<float>(value);
    return event;
}

/// A vertex inside the skin, pushed by 0.1 mm: what its tets answer.
double answer(const Scene& scene, State& state) {
    for (int v = 0; v < scene.body.vertex_count(); ++v) {
        const auto i = static_cast<size_t>(v);
        if (state.body.x[i].w == 0) continue;
        bool inside = true;
        for (const int32_t t : scene.body.tets_of(v))
            inside = inside && scene.body.mesh().tissue[static_cast<size_t>(t)] == Tissue::kSkin;
        if (!inside) continue;
        const Vec3 before = elastic_force(scene.body, state.body, v);
        state.body.x[i].z += 1e-4F;
        const Vec3 after = elastic_force(scene.body, state.body, v);
        state.body.x[i].z -= 1e-4F;
        return (after - before).norm();
    }
    return 0;
}

class Retune : public testing::TestWithParam<const char*> {};

// One task whose tissue can be cut (the state owns the strips) and one whose tissue cannot.
TEST_P(Retune, TwiceTheModulusAnswersWithTwiceTheForce) {
    const auto shown = build_operative_field(coarse(GetParam()).scene);
    const auto scene = std::const_pointer_cast<Scene>(shown);
    State state(*scene, 1);
    const double before = answer(*scene, state);
    ASSERT_GT(before, 0);
    const double modulus = tuned_value(*scene, TuneParameter::kStiffness, Tissue::kSkin);
    EXPECT_TRUE(
        tune_live(*scene, state, tuning(TuneParameter::kStiffness, Tissue::kSkin, 2 * modulus)));
    // Both are sums of floats.
    EXPECT_NEAR(answer(*scene, state) / before, 2, 1e-3);
    EXPECT_TRUE(
        tune_live(*scene, state, tuning(TuneParameter::kStiffness, Tissue::kSkin, modulus)));
    EXPECT_NEAR(answer(*scene, state) / before, 1, 1e-3);
}
INSTANTIATE_TEST_SUITE_P(Bodies, Retune,
                         testing::Values("diathermy_ring_small", "scissors_resection"));

TEST(Retune, ValuesStayInTheirRangeAndNonsenseChangesNothing) {
    const auto scene =
        std::const_pointer_cast<Scene>(build_operative_field(coarse("diathermy_ring_small").scene));
    State state(*scene, 1);
    EXPECT_TRUE(tune_live(*scene, state, tuning(TuneParameter::kFriction, Tissue::kSkin, 99)));
    EXPECT_EQ(tuned_value(*scene, TuneParameter::kFriction, Tissue::kSkin),
              tune_range(TuneParameter::kFriction).high);
    EXPECT_FALSE(tune_live(*scene, state, tuning(TuneParameter::kFriction, Tissue::kSkin, NAN)));
    EXPECT_FALSE(
        tune_live(*scene, state, tuning(static_cast<TuneParameter>(77), Tissue::kSkin, 1)));
    EXPECT_TRUE(tune_live(*scene, state, tuning(TuneParameter::kCutPower, Tissue::kSkin, 20)));
    EXPECT_EQ(scene->tools[0].cut_power_w, 20);
}

TEST(Retune, ATunedAttemptIsReplayedExactlyAndNeverPasses) {
    const Task task = coarse("diathermy_ring_small");
    curriculum::AttemptOptions options;
    options.device = "script:expert";
    options.fast = true;
    options.threads = 1;
    options.duration_s = 4;
    const auto recording = std::make_shared<Recording>();
    curriculum::AttemptRunner runner(task, 1, options,
                                     std::make_unique<test::MemorySink>(recording));
    runner.tune(TuneParameter::kStiffness, Tissue::kZone, 60000);
    runner.start();
    // While it runs, at whatever frame it meets: the recording says which.
    runner.tune(TuneParameter::kCutPower, Tissue::kSkin, 18);
    runner.tune(TuneParameter::kDamping, Tissue::kZone, 30);
    runner.wait();
    int tuned = 0;
    for (const Event& event : recording->events) tuned += event.kind == EventKind::kTuned ? 1 : 0;
    EXPECT_EQ(tuned, 3);
    const curriculum::ReplayResult result = curriculum::replay(*recording, 2);
    EXPECT_TRUE(result.identical) << result.message;
    const auto score =
        assessment::score_attempt(task.rubric, assessment::compute_metrics(*recording), *recording);
    EXPECT_EQ(score.verdict, assessment::Verdict::kFailed);
    ASSERT_FALSE(score.reasons.empty());
    EXPECT_EQ(score.reasons.front().item, "tuned");
    // Without its tunings the same recording is not reproduced: they did change something.
    std::erase_if(recording->events, [](const Event& e) { return e.kind == EventKind::kTuned; });
    EXPECT_FALSE(curriculum::replay(*recording, 2).identical);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
