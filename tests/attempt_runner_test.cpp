// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <set>
#include <stdexcept>
#include <thread>

#include "assessment/metrics.h"
#include "assessment/scoring.h"
#include "assessment/tissue_metrics.h"
#include "tests/attempt_fixture.h"

namespace placode::curriculum {
namespace THIS_TEST {

class FullDisk final : public sim::RecordingSink {
 public:
    void begin(const sim::RecordingHeader&) override {}
    void append(std::span<const sim::Input>, std::span<const sim::Sample>,
                std::span<const sim::Event>) override {
        throw std::runtime_error("no space left on device");
    }
    void finish(const sim::RecordingEnd&) override { FAIL() << "nothing to finish"; }
};

/// The coarse task with a field that a test can afford.
Task quick_task() { return test::tiny_task("diathermy_ring_small"); }

/// A mouse that nobody moves until the window says so.
AttemptOptions still_mouse(sim::Latest<sim::WindowInput>& window) {
    window.publish({});
    AttemptOptions options;
    options.device = "mouse";
    options.window = &window;
    return options;
}

AttemptOptions fast(double duration_s, int threads = 1) {
    AttemptOptions options;
    options.device = "script:expert";
    options.fast = true;
    options.duration_s = duration_s;
    options.threads = threads;
    return options;
}

std::shared_ptr<sim::Recording> perform(const AttemptOptions& options, uint64_t seed = 3) {
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(quick_task(), seed, options,
                         std::make_unique<test::MemorySink>(recording));
    runner.start();
    runner.wait();
    EXPECT_TRUE(runner.finished());
    EXPECT_EQ(runner.status().warning, "");
    EXPECT_EQ(runner.end().final_hash, recording->end.final_hash);
    return recording;
}

TEST(AttemptRunner, RecordsEveryFrameSampleAndHash) {
    const auto r = perform(fast(2.2));
    EXPECT_EQ(r->header.task_id, "diathermy_ring_small");
    EXPECT_EQ(r->header.device, "script:expert");
    EXPECT_EQ(r->header.seed, 3u);
    EXPECT_FALSE(r->header.geometry.planned_contour.empty());
    ASSERT_EQ(r->inputs.size(), 2200u);
    for (size_t k = 0; k < r->inputs.size(); ++k)
        ASSERT_EQ(r->inputs[k].frame, static_cast<int64_t>(k));
    ASSERT_EQ(r->samples.size(), 220u);
    EXPECT_NEAR(r->samples.back().time_s, 2.2, 1e-9);
    EXPECT_EQ(r->end.reason, sim::EndReason::kTimeLimit);
    EXPECT_EQ(r->end.dropped, 0);
    EXPECT_NEAR(r->end.duration_s, 2.2, 1e-9);
    int hashes = 0;
    for (const sim::Event& event : r->events) hashes += event.kind == sim::EventKind::kStateHash;
    EXPECT_EQ(hashes, 3);  // at 1 s, at 2 s, at the end
    // Nothing is missing for over-stretch and thermal spread, though this ring is hardly begun.
    EXPECT_THAT(assessment::not_recorded(*r), testing::IsEmpty());
    EXPECT_TRUE(assessment::compute_metrics(*r).find("over_stretch_mm3_s"));
    // The needle moved, and no sample is nonsense.
    EXPECT_GT(*assessment::compute_metrics(*r).find("path_length_mm"), 1);
    for (const sim::Sample& sample : r->samples)
        for (const float x : sample.tools[0].tip_m) ASSERT_LT(std::abs(x), 0.3f);
}

TEST(AttemptRunner, CertifiesItsHapticLoop) {
    AttemptRunner runner(quick_task(), 3, fast(0.3), nullptr);
    runner.start();
    runner.wait();
    const auto certificate = haptics::certificate_from_json(runner.haptic_certificate());
    EXPECT_EQ(certificate.ticks, 300u);
    EXPECT_NEAR(certificate.duration_s, 0.299, 1e-9) << "from the first tick to the last";
    EXPECT_TRUE(certificate.lock_step);
    EXPECT_EQ(certificate.faults, 0u);
    EXPECT_EQ(judge(certificate).grade, haptics::CertificateGrade::kNotApplicable);
}

TEST(AttemptRunner, AReplayIsIdenticalWithAnyNumberOfThreads) {
    const auto r = perform(fast(1.1, 2));
    for (const int threads : {1, 3}) {
        int64_t frames = 0;
        const ReplayResult result =
            replay(*r, threads, [&](const sim::Scene&, const sim::State&) { ++frames; });
        EXPECT_TRUE(result.identical) << result.message;
        EXPECT_EQ(result.message, "replay: identical");
        EXPECT_EQ(result.frames, 1100);
        EXPECT_EQ(frames, 1100);
    }
}

TEST(AttemptRunner, AReplayFindsWhereARecordingWasChanged) {
    auto r = perform(fast(2.2));
    sim::Recording changed = *r;
    // In the air the tool is where the hand is: the change must last until the next hash.
    for (size_t k = 1500; k < 2000; ++k) changed.inputs[k].tools[0].position_m[0] += 0.001f;
    const ReplayResult result = replay(changed, 1);
    EXPECT_FALSE(result.identical);
    EXPECT_NEAR(result.first_difference_s, 2.0, 1e-9);
    EXPECT_NE(result.message.find("replay: differs from 2.000 s on: state hash"), std::string::npos)
        << result.message;

    changed = *r;
    changed.inputs.erase(changed.inputs.begin() + 700);
    EXPECT_NE(replay(changed, 1).message.find("frame 700 is missing"), std::string::npos);

    changed = *r;
    changed.end.final_hash ^= 1;
    EXPECT_NE(replay(changed, 1).message.find("differs at the end"), std::string::npos);
}

TEST(AttemptRunner, RealTimeGivesTheSameBitsAsFast) {
    const auto quick = perform(fast(0.3));
    AttemptOptions options = fast(0.3);
    options.fast = false;
    const auto slow = perform(options);
    ASSERT_EQ(slow->inputs.size(), quick->inputs.size());
    EXPECT_EQ(slow->end.final_hash, quick->end.final_hash);
    for (size_t k = 0; k < slow->inputs.size(); ++k) {
        EXPECT_EQ(slow->inputs[k].substeps, quick->inputs[k].substeps);
        EXPECT_EQ(std::memcmp(slow->inputs[k].tools, quick->inputs[k].tools,
                              sizeof slow->inputs[k].tools),
                  0)
            << k;
    }
}

TEST(AttemptRunner, AnotherSeedIsAnotherField) {
    EXPECT_NE(perform(fast(0.05), 3)->end.final_hash, perform(fast(0.05), 4)->end.final_hash);
}

TEST(AttemptRunner, AFullDiskStopsTheRecordingButNotTheAttempt) {
    AttemptRunner runner(quick_task(), 3, fast(0.6), std::make_unique<FullDisk>());
    runner.start();
    runner.wait();
    EXPECT_EQ(runner.end().reason, sim::EndReason::kTimeLimit);
    EXPECT_NEAR(runner.end().duration_s, 0.6, 1e-9);
    EXPECT_NE(runner.status().warning.find("no space left on device"), std::string::npos);
}

TEST(AttemptRunner, FinishesOnRequestAlsoWhilePaused) {
    AttemptOptions options = fast(0);
    options.fast = false;
    AttemptRunner runner(quick_task(), 3, options, nullptr);
    runner.set_paused(true);
    runner.start();
    while (!runner.snapshot().paused) std::this_thread::yield();
    EXPECT_EQ(runner.snapshot().frame, 0);
    runner.request_finish(sim::EndReason::kFinished);
    runner.wait();
    EXPECT_EQ(runner.end().reason, sim::EndReason::kFinished);
    EXPECT_FALSE(runner.status().running);
    EXPECT_TRUE(runner.snapshot().finished);
}

/// Calls `look` until it is true; a slow machine may take its time.
template <class Look>
void until(Look look) {
    for (int i = 0; i < 10'000 && !look(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ASSERT_TRUE(look());
}

TEST(AttemptRunner, TheClockStartsWithTheFirstMotionAndStandsInAPause) {
    sim::Latest<sim::WindowInput> window;
    sim::WindowInput input;
    AttemptOptions options = still_mouse(window);
    options.threads = 1;
    options.wait_for_motion = true;
    options.mode = AttemptMode::kStudy;
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(quick_task(), 3, options, std::make_unique<test::MemorySink>(recording));
    runner.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_TRUE(runner.status().waiting);
    EXPECT_EQ(runner.snapshot().frame, 0);
    until([&] { return runner.snapshot().tools[0].engaged != 0; });  // seen before it moves
    // What was looked at before the beginning is no pause.
    runner.set_paused(true, sim::PauseCause::kHelp);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    runner.set_paused(false);
    // A tick that still holds the hands would take the motion for one of the pause.
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    input.mouse_x += 200;
    window.publish(input);
    until([&] { return runner.status().time_s > 0.1; });
    EXPECT_FALSE(runner.status().waiting);
    runner.set_paused(true, sim::PauseCause::kHelp);
    until([&] { return runner.snapshot().paused != 0; });
    const double here = runner.status().time_s;
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_EQ(runner.status().time_s, here);
    runner.set_paused(false);
    until([&] { return runner.status().time_s > here; });
    runner.request_finish(sim::EndReason::kFinished);
    runner.wait();
    EXPECT_EQ(recording->header.mode, "study");
    std::vector<sim::Event> pauses;
    for (const sim::Event& event : recording->events)
        if (event.kind == sim::EventKind::kPaused) pauses.push_back(event);
    ASSERT_EQ(pauses.size(), 1U);
    EXPECT_GE(pauses[0].value, 0.3F);
    EXPECT_EQ(static_cast<sim::PauseCause>(pauses[0].value2), sim::PauseCause::kHelp);
    EXPECT_TRUE(replay(*recording, 1).identical);
}

std::atomic<int64_t> slept_ns{0};

// Everything ran by a clock that stands still meanwhile: an attempt over lunch had no trace of it.
TEST(AttemptRunner, ASleepOfTheComputerIsAPauseOfItsOwnAndMakesAnotherLonger) {
    slept_ns = 0;
    sim::Latest<sim::WindowInput> window;
    AttemptOptions options = still_mouse(window);
    options.threads = 1;
    options.asleep_ns = []() noexcept { return slept_ns.load(); };
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(quick_task(), 3, options, std::make_unique<test::MemorySink>(recording));
    runner.start();
    until([&] { return runner.status().time_s > 0.05; });
    EXPECT_EQ(runner.status().sleeps, 0);
    slept_ns += 60'000'000'000;
    until([&] { return runner.status().sleeps == 1; });
    runner.set_paused(true, sim::PauseCause::kHelp);
    until([&] { return runner.snapshot().paused != 0; });
    slept_ns += 30'000'000'000;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const double here = runner.status().time_s;
    runner.set_paused(false);
    until([&] { return runner.status().time_s > here; });
    EXPECT_EQ(runner.status().sleeps, 1) << "nobody needs another pause after one";
    runner.request_finish(sim::EndReason::kFinished);
    runner.wait();
    std::vector<sim::Event> pauses;
    for (const sim::Event& event : recording->events)
        if (event.kind == sim::EventKind::kPaused) pauses.push_back(event);
    ASSERT_EQ(pauses.size(), 2U);
    EXPECT_NEAR(pauses[0].value, 60, 0.01);
    EXPECT_EQ(static_cast<sim::PauseCause>(pauses[0].value2), sim::PauseCause::kAsleep);
    EXPECT_GE(pauses[1].value, 30.1F);
    EXPECT_LT(pauses[1].value, 60);
    EXPECT_EQ(static_cast<sim::PauseCause>(pauses[1].value2), sim::PauseCause::kHelp);
    EXPECT_TRUE(replay(*recording, 1).identical);
}

// The tuning panel stands open in a pause, and somebody may turn at it for long.
TEST(AttemptRunner, EveryWishOfTheTuningPanelArrivesWhileTimeStandsStill) {
    AttemptOptions options = fast(0);
    options.fast = false;
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(quick_task(), 3, options, std::make_unique<test::MemorySink>(recording));
    runner.set_paused(true);
    runner.start();
    until([&] { return runner.snapshot().paused != 0; });
    constexpr int kWishes = 90;  // more than wait for a frame
    for (int i = 0; i < kWishes; ++i) {
        runner.tune(sim::TuneParameter::kFriction, sim::Tissue::kSkin, i % 2 == 0 ? 0.1 : 0.2);
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(runner.snapshot().frame, 0);
    runner.set_paused(false);
    until([&] { return runner.status().time_s > 0.05; });
    runner.request_finish(sim::EndReason::kFinished);
    runner.wait();
    int tuned = 0;
    for (const sim::Event& event : recording->events)
        tuned += event.kind == sim::EventKind::kTuned ? 1 : 0;
    EXPECT_EQ(tuned, kWishes);
    EXPECT_TRUE(replay(*recording, 1).identical);
}

TEST(AttemptRunner, LeavesBeforeAnyMotion) {
    sim::Latest<sim::WindowInput> window;
    AttemptOptions options = still_mouse(window);
    options.wait_for_motion = true;
    AttemptRunner runner(quick_task(), 3, options, nullptr);
    runner.start();
    until([&] { return runner.status().waiting; });
    runner.request_finish(sim::EndReason::kInterrupted);
    runner.wait();
    EXPECT_EQ(runner.end().reason, sim::EndReason::kInterrupted);
    EXPECT_EQ(runner.end().duration_s, 0);
}

// As the simulator itself records it: a hand that does nothing, in tissue that has settled.
TEST(AttemptRunner, AHandThatDoesNothingHasNotAttemptedTheTask) {
    for (const char* id : {"familiarisation", "diathermy_ring_small"}) {
        const Task task = test::tiny_task(id);
        sim::Latest<sim::WindowInput> window;
        AttemptOptions options = still_mouse(window);
        options.fast = true;
        options.duration_s = 1.5;
        auto recording = std::make_shared<sim::Recording>();
        AttemptRunner runner(task, 3, options, std::make_unique<test::MemorySink>(recording));
        runner.start();
        runner.wait();
        const assessment::Score score = assessment::score_attempt(
            task.rubric, assessment::compute_metrics(*recording), *recording);
        EXPECT_EQ(score.verdict, assessment::Verdict::kNotAttempted) << id;
        EXPECT_EQ(score.points, 0) << id;
    }
}

TEST(AttemptRunner, AnUnknownDeviceIsRefusedBeforeTheSceneIsBuilt) {
    AttemptOptions options = fast(1);
    options.device = "crystal_ball";
    EXPECT_THROW(AttemptRunner(quick_task(), 1, options, nullptr), haptics::DeviceError);
}

}  // namespace THIS_TEST
}  // namespace placode::curriculum
