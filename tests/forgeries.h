// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ways to forge an exam: what its recording says of the task, and of what was done, and what the
// order beside it says of whose it is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/core/random.h"
#include "sim/step/recording.h"

namespace placode::test {

using sim::Recording;

/// What is changed, and by how much or where: each draws it anew.
struct Forgery {
    const char* name;
    std::function<void(Recording&, sim::SplitMix64&)> make;
};

inline size_t below(size_t n, sim::SplitMix64& random) {
    return static_cast<size_t>(random.next() % n);
}
/// A factor that is far enough from 1 to matter to whoever forges.
inline double factor(sim::SplitMix64& random) { return 1.05 + 3 * random.uniform(); }

inline const std::vector<Forgery>& forgeries_of_the_task() {
    static const std::vector<Forgery> all{
        {"rubric that takes nothing off",
         [](Recording& r, sim::SplitMix64& random) {
             std::string& json = r.header.task_json;
             const size_t rubric = json.find("\"rubric\"");
             std::vector<size_t> weights;
             for (size_t at = rubric; (at = json.find("\"max_points\":", at)) != std::string::npos;)
                 weights.push_back(at += 13);
             ASSERT_FALSE(weights.empty());
             json.insert(weights[below(weights.size(), random)], "0.0");
         }},
        {"task that nobody published",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.task_id = "easy_ring_" + std::to_string(below(1000, random));
         }},
        {"version that nobody published",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.task_version += 1 + static_cast<int>(below(1000, random));
         }},
        {"path for a task",
         [](Recording& r, sim::SplitMix64& random) {
             static const char* const kPaths[]{"../tasks/diathermy_ring", "/tmp/touch_targets",
                                               "touch_targets.json", "touch_targets/",
                                               "./touch_targets"};
             r.header.task_id = kPaths[below(std::size(kPaths), random)];
         }},
        {"task that is no JSON",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.task_json.resize(below(r.header.task_json.size(), random));
         }},
        {"another time limit",
         [](Recording& r, sim::SplitMix64& random) {
             std::string& json = r.header.task_json;
             const size_t at = json.find("time_limit_s");
             ASSERT_NE(at, std::string::npos);
             json.replace(at, 12,
                          "time_limit_s\":" + std::to_string(1 + below(99, random)) + ",\"x");
         }},
        {"another case",
         [](Recording& r, sim::SplitMix64& random) { r.header.seed += 1 + below(99, random); }},
        {"other needle",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.tools[0].tip_radius_m /= static_cast<float>(factor(random));
         }},
        {"contour emptied",
         [](Recording& r, sim::SplitMix64& random) {
             auto& contour = r.header.geometry.planned_contour;
             contour.resize(below(contour.size(), random));
         }},
        {"contour moved",
         [](Recording& r, sim::SplitMix64& random) {
             const double by = factor(random);
             for (auto& p : r.header.geometry.planned_contour) p *= by;
         }},
        {"larger placode",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.geometry.placode_volume_m3 *= factor(random);
         }},
        {"time backwards",
         [](Recording& r, sim::SplitMix64& random) { r.header.sample_s *= -factor(random); }},
        {"no frame",
         [](Recording& r, sim::SplitMix64& random) {
             r.header.frame_s *= below(2, random) == 0 ? 0 : factor(random);
         }},
    };
    return all;
}

inline const std::vector<Forgery>& forgeries_of_what_was_done() {
    static const std::vector<Forgery> all{
        {"ring that was cut",
         [](Recording& r, sim::SplitMix64& random) {
             const size_t from = below(r.samples.size(), random);
             for (size_t i = from; i < r.samples.size(); ++i) r.samples[i].cut_fraction = 1;
         }},
        {"steadier hand",
         [](Recording& r, sim::SplitMix64& random) {
             const size_t from = below(r.samples.size() / 2, random);
             for (size_t i = from; i < r.samples.size(); ++i)
                 r.samples[i].tools[0].tip_m = r.samples[from].tools[0].tip_m;
         }},
        {"no force",
         [](Recording& r, sim::SplitMix64& random) {
             const auto force = static_cast<float>(1e-9 * factor(random));
             for (auto& s : r.samples) std::ranges::fill(s.tools[0].force_n, force);
         }},
        {"quieter samples",
         [](Recording& r, sim::SplitMix64& random) {
             const auto warm = static_cast<float>(36 + random.uniform());
             for (auto& s : r.samples) s.placode_peak_c = warm;
         }},
        {"tip nowhere",
         [](Recording& r, sim::SplitMix64& random) {
             r.samples[below(r.samples.size(), random)].tools[0].tip_m[below(3, random)] =
                 std::numeric_limits<float>::infinity();
         }},
        {"samples left out",
         [](Recording& r, sim::SplitMix64& random) {
             r.samples.resize(below(r.samples.size(), random));
         }},
        {"event left out",
         [](Recording& r, sim::SplitMix64& random) {
             r.events.erase(r.events.begin() +
                            static_cast<std::ptrdiff_t>(below(r.events.size(), random)));
         }},
        {"all events left out", [](Recording& r, sim::SplitMix64&) { r.events.clear(); }},
        {"event of a next phase",
         [](Recording& r, sim::SplitMix64& random) {
             sim::Event more;
             more.time_s = 4 * random.uniform();
             more.kind = sim::EventKind::kPhase;
             more.value = static_cast<float>(1 + below(5, random));
             r.events.push_back(more);
         }},
        {"end cut off",
         [](Recording& r, sim::SplitMix64& random) {
             r.inputs.resize(below(r.inputs.size(), random));
         }},
        {"input left out",
         [](Recording& r, sim::SplitMix64& random) {
             r.inputs.erase(r.inputs.begin() +
                            static_cast<std::ptrdiff_t>(below(r.inputs.size(), random)));
         }},
        {"shorter",
         [](Recording& r, sim::SplitMix64& random) {
             r.end.duration_s *= 0.1 + 0.8 * random.uniform();
         }},
        {"endless",
         [](Recording& r, sim::SplitMix64& random) {
             r.end.duration_s = std::pow(10.0, 5 + static_cast<double>(below(295, random)));
         }},
        {"no duration",
         [](Recording& r, sim::SplitMix64&) {
             r.end.duration_s = std::numeric_limits<double>::quiet_NaN();
         }},
        {"finished",
         [](Recording& r, sim::SplitMix64& random) {
             r.end.final_hash = random.next();
             r.end.reason = sim::EndReason::kFinished;
         }},
        {"entries lost",
         [](Recording& r, sim::SplitMix64& random) {
             r.end.dropped = static_cast<decltype(r.end.dropped)>(1 + below(900, random));
         }},
    };
    return all;
}

/// The order of an exam, as the shell writes it beside the recording.
struct OrderForgery {
    const char* name;
    std::function<void(nlohmann::json&, sim::SplitMix64&)> make;
};
/// Another demonstration account than the one that operated, another educator than the one who was
/// present, another exam with the same case.
struct OtherOrder {
    int64_t user = 0;
    std::string proctor, stage;
};
inline std::vector<OrderForgery> forgeries_of_the_order(const OtherOrder& other) {
    return {{"order of somebody else",
             [=](nlohmann::json& order, sim::SplitMix64&) { order["user_id"] = other.user; }},
            {"order with another proctor",
             [=](nlohmann::json& order, sim::SplitMix64& random) {
                 // Also the same one, written in another way.
                 order["proctor"] = below(2, random) == 0
                                        ? other.proctor
                                        : order["proctor"].get<std::string>() + " ";
             }},
            {"order of another exam",
             [=](nlohmann::json& order, sim::SplitMix64&) { order["exam_stage"] = other.stage; }}};
}

}  // namespace placode::test
