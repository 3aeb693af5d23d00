// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt of a built-in policy.

#include "batches/checksum.h"
#include "batches/items.h"
#include "batches/scores.h"
#include "environment/policy.h"

namespace placode::batches {

environment::Environment& Worker::environment_for(const std::string& task_id,
                                                  const std::string& policy) {
    const bool absolute = environment::policy_units(policy) == environment::ActionUnits::kAbsolute;
    auto& made = environments_[task_id + (absolute ? "/absolute" : "/normalised")];
    if (made) return *made;
    environment::EnvironmentOptions options;
    options.units = environment::policy_units(policy);
    options.time_limit_s = manifest_.options.at("time_limit_s").get<double>();
    options.record = true;  // its hashes are the result
    options.judge_every_s = 0;
    if (const Json& changes = manifest_.options.at("scene_changes"); !changes.is_null())
        options.scene_changes_json = changes.dump();
    (void)task("id", task_id);  // still the planned one?
    const Json& entry = *entry_of(manifest_, "id", task_id);
    // What was compared is what is used: a path of the computer that planned it means nothing here.
    const std::filesystem::path brought =
        own_input(folder_, entry.at("sha256").get<std::string>(), ".json");
    made = std::make_unique<environment::Environment>(
        fields_,
        std::filesystem::exists(brought) ? brought.string() : entry.at("ref").get<std::string>(),
        options);
    return *made;
}

Json Worker::rollout(const Json& item) {
    const auto task_id = item.at("task").get<std::string>();
    const auto name = item.at("policy").get<std::string>();
    const auto seed = item.at("seed").get<uint64_t>();
    const int frames = manifest_.options.at("frames_per_step").get<int>();
    environment::Environment& environment = environment_for(task_id, name);
    environment.reset(seed);
    environment::Policy policy(name, environment, seed);
    std::vector<double> action(environment.tools() * environment::kActionSize, 0.0);
    environment::StepOutcome outcome;
    while (!environment.ended()) {
        check_stop();
        const bool done = policy.act(environment, frames, action);
        outcome = environment.step(action, frames, done);
    }
    const sim::Recording& recording = environment.recording();
    const assessment::Score& score = environment.judged().score;
    Json result = item;
    result["points"] = score.points;
    result["verdict"] = assessment::verdict_name(score.verdict);
    result["passed"] = outcome.success;
    result["duration_s"] = recording.end.duration_s;
    result["final_hash"] = hash_text(recording.end.final_hash);
    if (manifest_.options.at("metrics").get<bool>())
        result["metrics"] = metrics_json(environment.judged().metrics);
    if (manifest_.options.at("record").get<bool>()) {
        const std::string file = task_id + "-" + name + "-" + std::to_string(seed) + ".placode";
        write_recording(recording, folder_ / "recordings" / file);
        result["recording"] = file;
    }
    return result;
}

}  // namespace placode::batches
