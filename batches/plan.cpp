// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/plan.h"

#include <algorithm>
#include <set>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "curriculum/scene_changes.h"
#include "db/evidence.h"
#include "db/recording_file.h"
#include "environment/policy.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;

/// From the batch's folder where it lies below it, else absolute.
std::string name_of(const fs::path& file, const fs::path& folder) {
    const fs::path whole = fs::absolute(file).lexically_normal();
    const fs::path from = whole.lexically_relative(fs::absolute(folder).lexically_normal());
    return from.empty() || *from.begin() == ".." ? whole.string() : from.string();
}

/// Task that a recording says it is of; empty: its head cannot be read, which is the item's result.
std::string task_id_of(const fs::path& file) {
    try {
        return db::recording_summary(file.string()).header.task_id;
    } catch (const db::StoreError&) {
        return {};
    }
}

}  // namespace

void need_policy(const std::string& name) {
    const auto& known = environment::kPolicies;
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw BatchError(
            Kind::kBadInput,
            "policy \"" + name +
                "\": unknown; expected expert, intermediate, novice, nothing or random");
}

std::vector<fs::path> recordings_in(const fs::path& folder) {
    if (!fs::is_directory(folder))
        throw BatchError(Kind::kBadInput, folder.string() +
                                              ": is no folder; expected one that "
                                              "holds recordings (*.placode)");
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() == ".placode")
            found.push_back(entry.path());
    if (found.empty())
        throw BatchError(Kind::kBadInput, folder.string() + ": holds no recordings (*.placode)");
    std::sort(found.begin(), found.end());
    return found;
}

Manifest plan_recordings(const RecordingsOrder& order, const fs::path& folder,
                         const PlanProgress& progress) {
    Manifest manifest;
    manifest.kind = order.kind;
    std::set<std::string> ids;
    if (order.kind == "replay") {
        manifest.options["threads"] = order.threads;
    } else {
        manifest.options["metrics"] = order.metrics;
        manifest.options["task"] = nullptr;
        if (!order.task.empty()) {
            manifest.tasks.push_back(task_entry(order.task));
            manifest.options["task"] = manifest.tasks[0]["ref"];
        }
    }
    for (const OrderedRecording& one : order.recordings) {
        if (progress) progress(manifest.items.size(), order.recordings.size());
        Json item{{"recording", name_of(one.path, folder)}, {"sha256", sha256_of_file(one.path)}};
        if (one.attempt > 0) item["attempt"] = one.attempt;
        if (one.pass_points) item["pass_points"] = *one.pass_points;
        manifest.items.push_back(std::move(item));
        ids.insert(task_id_of(one.path));
    }
    for (const std::string& id : ids)
        if (order.task.empty() && db::shipped_task(id)) manifest.tasks.push_back(task_entry(id));
    return manifest;
}

Manifest plan_rollouts(const RolloutsOrder& order) {
    for (const std::string& policy : order.policies) need_policy(policy);
    Manifest manifest;
    manifest.kind = "rollouts";
    manifest.options = {{"frames_per_step", order.frames_per_step},
                        {"time_limit_s", order.time_limit_s},
                        {"scene_changes", Json()},
                        {"metrics", order.metrics},
                        {"record", order.record}};
    if (!order.scene_changes_json.empty())
        manifest.options["scene_changes"] = Json::parse(order.scene_changes_json, nullptr, false);
    for (const std::string& ref : order.tasks) {
        const Json entry = task_entry(ref);
        if (!order.scene_changes_json.empty())
            (void)curriculum::with_scene_changes(task_of_entry(entry, {}),
                                                 order.scene_changes_json);
        if (entry_of(manifest, "id", entry["id"].get<std::string>()) != nullptr)
            throw BatchError(Kind::kBadInput, "task " + entry["id"].get<std::string>() +
                                                  ": named twice; expected each once");
        manifest.tasks.push_back(entry);
        // Seeds before policies: those of one seed share its field, which takes seconds to build.
        for (const uint64_t seed : order.seeds)
            for (const std::string& policy : order.policies)
                manifest.items.push_back(
                    {{"task", entry["id"]}, {"policy", policy}, {"seed", seed}});
    }
    if (manifest.items.empty())
        throw BatchError(Kind::kBadInput,
                         "rollouts: expected at least one task, one policy and one seed");
    return manifest;
}

}  // namespace placode::batches
