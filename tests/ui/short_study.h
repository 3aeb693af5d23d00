// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The paper's study, published for tests: with least durations that a test can wait for, and with
// the task that a test can afford.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "curriculum/definitions.h"
#include "curriculum/study.h"
#include "curriculum/task.h"
#include "db/study_conduct.h"

namespace placode::ui {

/// Publishes the version after the newest one.
/// @param least_s by step; a procedure that is not named has none.
/// @param task of every procedure; empty: as the study says.
inline void publish_short_study(db::Store& store, const std::string& study,
                                const std::map<std::string, double>& least_s = {},
                                const std::string& task = {}) {
    auto json = nlohmann::ordered_json::parse(curriculum::load_study(study).json);
    const auto newest = store.definitions().find("study", study);
    json["version"] = (newest ? newest->version : json["version"].get<int>()) + 1;
    for (auto& step : json["steps"]) {
        step.erase("min_s");
        if (const auto found = least_s.find(step["id"]); found != least_s.end())
            step["min_s"] = found->second;
        if (!task.empty() && step.contains("task")) step["task"] = task;
    }
    for (const auto& step : json["steps"])
        if (step.contains("questionnaire"))
            db::publish_on_first_use(
                store, curriculum::load_questionnaire(step["questionnaire"].get<std::string>()));
    db::DefinitionRecord definition;
    definition.kind = "study";
    definition.id = study;
    definition.version = json["version"];
    definition.json = json.dump(2);
    definition.reason = "shorter, for a test";
    store.definitions().publish(definition);
}

inline constexpr const char* kShortRing = "short_ring";

/// A centre's own task, published: the small ring on larger elements and with half the substeps, a
/// second of which costs a third. From here on `folder` is the data that this program and those
/// that it starts read: all that is shipped, and this task.
inline void publish_short_ring(db::Store& store, const std::filesystem::path& folder) {
    std::filesystem::copy(curriculum::data_folder(), folder,
                          std::filesystem::copy_options::recursive);
    auto json = nlohmann::ordered_json::parse(curriculum::load_task("diathermy_ring_small").json);
    json["id"] = kShortRing;
    json["version"] = 1;
    json["scene"].merge_patch({{"edge_ring_m", 0.0012},
                               {"edge_placode_m", 0.0016},
                               {"edge_outer_m", 0.003},
                               {"solver", {{"substeps", 2}}}});
    std::ofstream(folder / "tasks" / (std::string(kShortRing) + ".json")) << json.dump(2);
    ::setenv("PLACODE_DATA", folder.c_str(), 1);
    db::DefinitionRecord definition;
    definition.kind = "task";
    definition.id = kShortRing;
    definition.version = 1;
    definition.json = curriculum::load_task(kShortRing).json;
    store.definitions().publish(definition);
}

}  // namespace placode::ui
