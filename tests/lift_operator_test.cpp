// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The scripted grasp and lift on a coarse field, as a whole attempt without a window.

#include "haptics/lift_operator.h"

#include <gtest/gtest.h>

#include <memory>

#include "assessment/metrics.h"
#include "curriculum/attempt_runner.h"

namespace placode::curriculum {
namespace {

class MemorySink final : public sim::RecordingSink {
 public:
    explicit MemorySink(std::shared_ptr<sim::Recording> to) : to_(std::move(to)) {}
    void begin(const sim::RecordingHeader& header) override { to_->header = header; }
    void append(std::span<const sim::Input> inputs, std::span<const sim::Sample> samples,
                std::span<const sim::Event> events) override {
        to_->inputs.insert(to_->inputs.end(), inputs.begin(), inputs.end());
        to_->samples.insert(to_->samples.end(), samples.begin(), samples.end());
        to_->events.insert(to_->events.end(), events.begin(), events.end());
    }
    void finish(const sim::RecordingEnd& end) override { to_->end = end; }

 private:
    std::shared_ptr<sim::Recording> to_;
};

assessment::MetricSet perform(const std::string& level) {
    Task task = load_task("grasp_and_lift");
    std::string json = task.json;
    const auto set = [&json](const std::string& key, const std::string& value) {
        const size_t at = json.find("\"" + key + "\":") + key.size() + 3;
        json.replace(at, json.find_first_of(",}", at) - at, value);
    };
    set("edge_ring_m", "0.0010");
    set("edge_placode_m", "0.0016");
    set("edge_outer_m", "0.003");
    set("settle_s", "0.05");
    task = load_task_text(json, "coarse");
    AttemptOptions options;
    options.device = "script:" + level;
    options.fast = true;
    options.threads = 1;
    auto recording = std::make_shared<sim::Recording>();
    AttemptRunner runner(task, 1, options, std::make_unique<MemorySink>(recording));
    runner.start();
    runner.wait();
    EXPECT_EQ(recording->end.reason, sim::EndReason::kFinished);
    return assessment::compute_metrics(*recording);
}

TEST(LiftOperator, TheExpertLiftsThreeTimesWithoutHarm) {
    const assessment::MetricSet m = perform("expert");
    EXPECT_EQ(*m.find("grasps"), 3);
    EXPECT_GT(*m.find("lift_hold_s"), 8);
    EXPECT_EQ(*m.find("crush_count"), 0);
    EXPECT_EQ(*m.find("slip_count"), 0);
    EXPECT_EQ(*m.find("placode_contacts"), 0);
    EXPECT_GT(*m.find("peak_traction_mn"), 1);
    EXPECT_LT(*m.find("peak_traction_mn"), 400);
}

TEST(LiftOperator, TheNoviceCrushesWhatItHolds) {
    EXPECT_GE(*perform("novice").find("crush_count"), 1);
}

}  // namespace
}  // namespace placode::curriculum
