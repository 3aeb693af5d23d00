// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode.h, from outside: through the shared library alone.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "db/recording_file.h"
#include "interface/placode.h"
#include "tests/environment_fixture.h"

extern "C" int placode_in_c(const char* scene_changes);

namespace placode {
namespace THIS_TEST {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Interface : public testing::Test {
 protected:
    void SetUp() override {
        placode_options_init(&options_);
        options_.scene_changes = test::kCoarseScene;
        options_.fields = 1;
        fields_ = placode_fields_new(4);
        ASSERT_NE(fields_, nullptr);
    }
    void TearDown() override {
        placode_environment_free(environment_);
        placode_fields_free(fields_);
    }
    void open(const char* task) {
        environment_ = placode_environment_new(fields_, task, &options_);
        ASSERT_NE(environment_, nullptr) << placode_fields_error(fields_);
        action_.assign(placode_tool_count(environment_) * PLACODE_ACTION_SIZE, 0.0);
    }
    placode_status step(int frames = 10, int finish = 0) {
        outcome_.size = sizeof outcome_;
        return placode_step(environment_, action_.data(), action_.size(), frames, finish,
                            &outcome_);
    }

    placode_options options_{};
    placode_fields* fields_ = nullptr;
    placode_environment* environment_ = nullptr;
    placode_outcome outcome_{};
    std::vector<double> action_;
};

TEST_F(Interface, WorksFromC) { EXPECT_EQ(placode_in_c(test::kCoarseScene), 0); }

TEST_F(Interface, ARecordingIsReadReplayedAndScoredLikeAPersons) {
    options_.units = PLACODE_ABSOLUTE;
    options_.record = 1;
    open("touch_targets");
    const fs::path folder = fs::temp_directory_path() / "placode_interface_test";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const std::string path = (folder / "a.placode").string();
    EXPECT_EQ(placode_write_recording(environment_, path.c_str()), PLACODE_NOT_RESET);
    ASSERT_EQ(placode_reset(environment_, 1), PLACODE_OK);
    EXPECT_EQ(placode_write_recording(environment_, path.c_str()), PLACODE_RUNNING);
    placode_expert* expert = placode_expert_new(environment_, "intermediate", 3);
    ASSERT_NE(expert, nullptr) << placode_error(environment_);
    int32_t done = 0;
    do {
        ASSERT_EQ(
            placode_expert_act(environment_, expert, 20, action_.data(), action_.size(), &done),
            PLACODE_OK);
        ASSERT_EQ(step(20, done), PLACODE_OK) << placode_error(environment_);
    } while (outcome_.end == PLACODE_GOING_ON);
    placode_expert_free(expert);
    ASSERT_EQ(placode_write_recording(environment_, path.c_str()), PLACODE_OK)
        << placode_error(environment_);
    EXPECT_EQ(placode_write_recording(environment_, path.c_str()), PLACODE_FILE);
    EXPECT_THAT(placode_error(environment_), HasSubstr("not overwritten"));

    const sim::Recording recording = db::read_recording_file(path);
    EXPECT_TRUE(recording.header.demonstration);
    EXPECT_TRUE(curriculum::replay(recording, 1).identical);
    double points = 0;
    ASSERT_EQ(placode_score(environment_, &points, nullptr), PLACODE_OK);
    const curriculum::Task task =
        curriculum::load_task_text(recording.header.task_json, "recording");
    EXPECT_DOUBLE_EQ(
        assessment::score_attempt(task.rubric, assessment::compute_metrics(recording), recording)
            .points,
        points);
    const char* json = nullptr;
    ASSERT_EQ(placode_score_json(environment_, &json), PLACODE_OK);
    EXPECT_THAT(json, HasSubstr("\"steps_done_percent\""));
    fs::remove_all(folder);
}

TEST_F(Interface, EverythingWrongIsAStatusWithWords) {
    EXPECT_EQ(placode_environment_new(fields_, "touch_target", &options_), nullptr);
    EXPECT_THAT(placode_fields_error(fields_), HasSubstr("touch_targets"));
    EXPECT_EQ(placode_environment_new(fields_, nullptr, &options_), nullptr);
    EXPECT_EQ(placode_environment_new(nullptr, "touch_targets", nullptr), nullptr);
    options_.units = 7;
    EXPECT_EQ(placode_environment_new(fields_, "touch_targets", &options_), nullptr);
    EXPECT_THAT(placode_fields_error(fields_), HasSubstr("units"));
    options_.units = PLACODE_NORMALISED;
    options_.size = 4;
    EXPECT_EQ(placode_environment_new(fields_, "touch_targets", &options_), nullptr);
    EXPECT_THAT(placode_fields_error(fields_), HasSubstr("placode_options_init"));
    options_.size = sizeof options_;
    open("touch_targets");
    EXPECT_EQ(step(), PLACODE_NOT_RESET);
    EXPECT_EQ(placode_picture_new(environment_, 100, 100), nullptr);
    EXPECT_THAT(placode_error(environment_), HasSubstr("reset"));
    ASSERT_EQ(placode_reset(environment_, 1), PLACODE_OK);
    EXPECT_STREQ(placode_error(environment_), "");
    action_[0] = std::nan("");
    EXPECT_EQ(step(), PLACODE_BAD_ARGUMENT);
    EXPECT_THAT(placode_error(environment_), HasSubstr("number 0"));
    action_[0] = 0;
    EXPECT_EQ(placode_step(environment_, nullptr, 16, 1, 0, nullptr), PLACODE_BAD_ARGUMENT);
    EXPECT_EQ(placode_step(nullptr, action_.data(), 16, 1, 0, nullptr), PLACODE_BAD_ARGUMENT);
    EXPECT_EQ(placode_observe(environment_, nullptr, 3), PLACODE_BAD_ARGUMENT);
    EXPECT_EQ(placode_save(environment_, nullptr), PLACODE_BAD_ARGUMENT);
    EXPECT_EQ(placode_expert_new(environment_, "champion", 1), nullptr);
    EXPECT_THAT(placode_error(environment_), HasSubstr("novice"));
    EXPECT_EQ(placode_picture_new(environment_, 0, 100), nullptr);
    EXPECT_EQ(step(1, 1), PLACODE_OK);
    EXPECT_EQ(outcome_.end, PLACODE_FINISHED);
    EXPECT_EQ(step(), PLACODE_ENDED);
    for (int i = 0; i <= 10; ++i)
        EXPECT_STRNE(placode_status_name(static_cast<placode_status>(i)), "unknown");
    EXPECT_STREQ(placode_status_name(static_cast<placode_status>(11)), "unknown");
    // Nothing is freed twice, and nothing is nothing.
    placode_environment_free(nullptr);
    placode_fields_free(nullptr);
    placode_moment_free(nullptr);
    placode_batch_free(nullptr);
    placode_picture_free(nullptr);
}

TEST_F(Interface, WhatThereIsToSee) {
    open("diathermy_ring_small");
    ASSERT_EQ(placode_reset(environment_, 1), PLACODE_OK);
    ASSERT_EQ(step(), PLACODE_OK);
    size_t points = 0;
    ASSERT_EQ(placode_contour(environment_, nullptr, nullptr, 0, &points), PLACODE_OK);
    ASSERT_GT(points, 20U);
    std::vector<double> line(3 * points);
    std::vector<uint8_t> cut(points, 7);
    ASSERT_EQ(placode_contour(environment_, line.data(), cut.data(), points, &points), PLACODE_OK);
    EXPECT_EQ(*std::max_element(cut.begin(), cut.end()), 0);
    for (const double x : line) EXPECT_LT(std::abs(x), 0.03);
    size_t vertices = 0, triangles = 0;
    ASSERT_EQ(placode_surface(environment_, nullptr, nullptr, 0, nullptr, 0, &vertices, &triangles),
              PLACODE_OK);
    std::vector<float> xyz(3 * vertices), damage(4 * vertices);
    std::vector<int32_t> corners(3 * triangles, -1);
    ASSERT_EQ(placode_surface(environment_, xyz.data(), damage.data(), vertices, corners.data(),
                              triangles, &vertices, &triangles),
              PLACODE_OK);
    EXPECT_FLOAT_EQ(damage[3], 37);
    for (const int32_t v : corners) ASSERT_LT(static_cast<size_t>(v), vertices);
    EXPECT_GE(*std::min_element(corners.begin(), corners.end()), 0);
    size_t events = 0;
    placode_event first{};
    ASSERT_EQ(placode_events(environment_, 0, &first, 1, &events), PLACODE_OK);
    EXPECT_GT(events, 0U);
    EXPECT_STRNE(placode_event_name(first.kind), "");
}

/// A picture off-screen: what is drawn is the field, and two environments do not mix theirs.
TEST_F(Interface, PicturesOfTwoEnvironments) {
    open("touch_targets");
    ASSERT_EQ(placode_reset(environment_, 1), PLACODE_OK);
    placode_environment* other = placode_environment_new(fields_, "touch_targets", &options_);
    ASSERT_EQ(placode_reset(other, 1), PLACODE_OK);
    placode_picture* one = placode_picture_new(environment_, 160, 120);
    if (one == nullptr) GTEST_SKIP() << placode_error(environment_);
    placode_picture* two = placode_picture_new(other, 160, 120);
    ASSERT_NE(two, nullptr);
    std::vector<uint8_t> a(160 * 120 * 3), b(a.size()), again(a.size());
    ASSERT_EQ(step(), PLACODE_OK);
    ASSERT_EQ(placode_draw(environment_, one, a.data(), a.size()), PLACODE_OK);
    // The tip comes nearer in one of them only.
    action_[0] = 1;
    for (int i = 0; i < 20; ++i) ASSERT_EQ(step(20), PLACODE_OK);
    ASSERT_EQ(placode_step(other, std::vector<double>(16, 0.0).data(), 16, 10, 0, nullptr),
              PLACODE_OK);
    ASSERT_EQ(placode_draw(environment_, one, b.data(), b.size()), PLACODE_OK);
    ASSERT_EQ(placode_draw(other, two, again.data(), again.size()), PLACODE_OK);
    EXPECT_EQ(placode_draw(other, two, again.data(), 5), PLACODE_BAD_ARGUMENT);
    const auto unlike = [&](const std::vector<uint8_t>& x, const std::vector<uint8_t>& y) {
        size_t count = 0;
        for (size_t i = 0; i < x.size(); ++i) count += std::abs(x[i] - y[i]) > 24 ? 1 : 0;
        return count;
    };
    EXPECT_GT(std::set<uint8_t>(a.begin(), a.end()).size(), 30U) << "hardly anything is drawn";
    EXPECT_GT(unlike(a, b), 500U);
    EXPECT_LT(unlike(a, again), 200U);
    placode_picture_free(one);
    ASSERT_EQ(placode_draw(other, two, again.data(), again.size()), PLACODE_OK);
    EXPECT_LT(unlike(a, again), 200U);
    placode_picture_free(two);
    placode_environment_free(other);
}

TEST_F(Interface, APictureThatCouldNotBeMadeAnewIsRefusedUntilItCan) {
    options_.fields = 2;
    open("touch_targets");
    ASSERT_EQ(placode_reset(environment_, 1), PLACODE_OK);
    placode_picture* picture = placode_picture_new(environment_, 160, 120);
    if (picture == nullptr) GTEST_SKIP() << placode_error(environment_);
    std::vector<uint8_t> rgb(160 * 120 * 3);
    EXPECT_EQ(placode_draw(environment_, picture, rgb.data(), rgb.size()), PLACODE_OK);
    const char* fonts = std::getenv("PLACODE_FONTS");
    const std::string before = fonts != nullptr ? fonts : "";
    ::setenv("PLACODE_FONTS", "/no fonts are here", 1);
    // Another field, then the first again: neither has a view any more.
    for (const uint64_t seed : {2, 2, 1}) {
        ASSERT_EQ(placode_reset(environment_, seed), PLACODE_OK);
        EXPECT_EQ(placode_draw(environment_, picture, rgb.data(), rgb.size()), PLACODE_NO_PICTURE);
        EXPECT_THAT(placode_error(environment_), HasSubstr("font"));
    }
    fonts != nullptr ? ::setenv("PLACODE_FONTS", before.c_str(), 1) : ::unsetenv("PLACODE_FONTS");
    EXPECT_EQ(placode_draw(environment_, picture, rgb.data(), rgb.size()), PLACODE_OK)
        << placode_error(environment_);
    placode_picture_free(picture);
}

TEST_F(Interface, ABatchGoesThroughTheSameFunctions) {
    options_.time_limit_s = 0.1;
    open("touch_targets");
    placode_environment* other = placode_environment_new(fields_, "touch_targets", &options_);
    placode_environment* both[] = {environment_, other};
    placode_batch* batch = placode_batch_new(both, 2, PLACODE_SAME_STEP, 2);
    ASSERT_NE(batch, nullptr) << placode_error(environment_);
    const size_t size = placode_observation_size(environment_);
    std::vector<double> seen(2 * size), last(2 * size), actions(32, 0.0), rewards(2);
    uint8_t terminated[2], truncated[2], success[2];
    const uint64_t seeds[] = {1, 2};
    ASSERT_EQ(placode_batch_reset(batch, seeds, seen.data()), PLACODE_OK);
    ASSERT_EQ(placode_batch_step(batch, actions.data(), 100, seen.data(), last.data(),
                                 rewards.data(), terminated, truncated, success),
              PLACODE_OK);
    EXPECT_EQ(truncated[0] + truncated[1], 2);
    EXPECT_NEAR(last[0], 0.1, 1e-9);
    EXPECT_EQ(seen[0], 0);
    EXPECT_EQ(placode_batch_step(batch, actions.data(), 100, seen.data(), nullptr, rewards.data(),
                                 terminated, truncated, success),
              PLACODE_BAD_ARGUMENT);
    EXPECT_STRNE(placode_batch_error(batch), "");
    placode_batch_free(batch);
    placode_environment_free(other);
}

}  // namespace THIS_TEST
}  // namespace placode
