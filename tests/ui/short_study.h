// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The paper's study, published for tests: with least durations that a test can wait for, and with
// the task that a test can afford.

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "curriculum/study.h"
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

}  // namespace placode::ui
