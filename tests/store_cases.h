// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// People, attempts and the store that the tests of `db/store.h` share.

#include <limits>
#include <memory>
#include <string>

#include "db/recording_file.h"
#include "db/store.h"
#include "tests/store_fixture.h"

namespace placode::test {

inline constexpr const char* kPassword = "correct horse battery";

inline db::NewUser trainee(const std::string& login) {
    return {login, "Name of " + login, kPassword, static_cast<db::Roles>(db::Role::kTrainee),
            false};
}

inline db::AttemptResult make_result(const std::string& task = "diathermy_ring") {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.task_version = 2;
    result.header.seed = std::numeric_limits<uint64_t>::max() - 1;
    result.header.build = "0.1.0 AVX2";
    result.header.device = "script:expert";
    result.header.started_utc = "2026-01-02T03:04:05.000Z";
    result.header.demonstration = true;
    result.end = {sim::EndReason::kTimeLimit, 1.0 / 3.0, ~uint64_t{0}, 0};
    result.metrics.values = {{"path_length_mm", 0.1},
                             {"tiny", std::numeric_limits<double>::denorm_min()},
                             {"large", std::numeric_limits<double>::max()},
                             {"third", -1.0 / 3.0},
                             {"unknown", std::numeric_limits<double>::quiet_NaN()}};
    result.score.points = 71.30000000000001;
    result.score.verdict = assessment::Verdict::kPassed;
    result.score.rubric_id = "ring";
    result.score.rubric_version = 4;
    result.score.reasons = {{"dwell",
                             "Rested 3.2 s at 4 o'clock; \"zażółć\" -- ?",
                             12.5,
                             7.25,
                             false,
                             {"Rested {value} s{where}; \"zażółć\" -- ?", "Stała {value} s{where}.",
                              "dwell_s", 1.0 / 3.0, 2, 4}},
                            {"burn", "Placode burned", 0.1, -1, true}};
    sim::Event event;
    event.time_s = 0.1;
    event.kind = sim::EventKind::kDwell;
    event.tool = 0;
    event.tissue = sim::Tissue::kZone;
    event.value = 3.2f;
    event.value2 = -0.1f;
    event.rest_position_m = {0.001f, -0.002f, 1e-30f};
    event.element = 40000;
    sim::Event vaporised = event;
    vaporised.kind = sim::EventKind::kVaporised;
    sim::Event hash = event;
    hash.kind = sim::EventKind::kStateHash;
    result.events = {vaporised, event, hash};
    return result;
}

inline void write_recording(const std::string& path, int seconds = 2) {
    const auto sink = db::create_recording_file(path);
    sink->begin(make_result().header);
    for (int s = 0; s < seconds; ++s) {
        std::vector<sim::Input> inputs(1000);
        for (size_t i = 0; i < inputs.size(); ++i) {
            inputs[i].frame = s * 1000 + static_cast<int64_t>(i);
            inputs[i].tools[0].position_m[0] = std::sin(static_cast<float>(i));
        }
        sink->append(inputs, {}, {});
    }
    sink->finish({sim::EndReason::kFinished, double(seconds), 1, 0});
}

class StoreTest : public EngineTest {
 protected:
    void ready() override {
        options.now_ms = [this] { return now_ms; };
    }
    [[nodiscard]] std::unique_ptr<db::Store> open(int timeout_ms = 5000) const {
        return db::open_store(url() + "?timeout_ms=" + std::to_string(timeout_ms), options);
    }

    int64_t now_ms = 1'700'000'000'000;
};

inline World* const world = World::install();

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(StoreTest);  // Not all who read this header use it.
INSTANTIATE_TEST_SUITE_P(Engines, StoreTest, testing::Values("Sqlite", "Postgresql"), engine_name);

}  // namespace placode::test
