// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Making an entry.
#include "batches/benchmark.h"

#include <algorithm>
#include <map>

#include "assessment/soundness.h"
#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "batches/plan.h"
#include "db/recording_file.h"
#include "db/store_error.h"
#include "environment/judge.h"
#include "environment/policy.h"
#include "sim/core/near_word.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;

using Attempt = std::pair<std::string, uint64_t>;  // task and seed

std::string words_of(const Attempt& attempt) {
    return attempt.first + ", seed " + std::to_string(attempt.second);
}

std::vector<Attempt> attempts_of(const Protocol& protocol, const EntryOrder& order) {
    std::vector<std::string> known;
    std::string names;
    for (const BenchmarkTask& one : protocol.tasks) {
        known.push_back(one.task);
        names += (names.empty() ? "" : ", ") + one.task;
    }
    for (const std::string& task : order.only)
        if (std::find(known.begin(), known.end(), task) == known.end())
            throw BatchError(Kind::kBadInput, "--tasks: \"" + task + "\" is not in the benchmark " +
                                                  protocol.id + "; expected some of " + names +
                                                  sim::did_you_mean(task, known));
    std::vector<Attempt> attempts;
    for (const BenchmarkTask& one : protocol.tasks)
        for (const uint64_t seed : order.seeds.empty() ? protocol.seeds : order.seeds)
            if (order.only.empty() ||
                std::find(order.only.begin(), order.only.end(), one.task) != order.only.end())
                attempts.emplace_back(one.task, seed);
    return attempts;
}

double budget_of(const Protocol& protocol, const std::string& task) {
    for (const BenchmarkTask& one : protocol.tasks)
        if (one.task == task) return one.budget_s;
    return 0;
}

void perform(const Protocol& protocol, const std::string& name, const Attempt& attempt,
             const std::shared_ptr<environment::FieldCache>& fields, const fs::path& file,
             const EntryProgress& progress) {
    environment::EnvironmentOptions options;
    options.units = environment::policy_units(name);
    options.time_limit_s = budget_of(protocol, attempt.first);
    options.record = true;
    options.judge_every_s = 0;
    if (!protocol.scene_changes.is_null())
        options.scene_changes_json = protocol.scene_changes.dump();
    environment::Environment environment(fields, attempt.first, options);
    environment.reset(attempt.second);
    environment::Policy policy(name, environment, attempt.second);
    std::vector<double> action(environment.tools() * environment::kActionSize, 0.0);
    while (!environment.ended()) {
        if (!progress(words_of(attempt))) throw Stopped{};
        const bool done = policy.act(environment, protocol.frames_per_step, action);
        (void)environment.step(action, protocol.frames_per_step, done);
    }
    write_recording(environment.recording(), file);
}

/// A stopped run goes on in its own folder only: what another policy left there is not its own.
void claim_folder(const Protocol& protocol, const EntryOrder& order, const fs::path& folder) {
    const Json claim{
        {"policy", order.policy}, {"protocol_sha256", protocol.sha256}, {"build", order.build}};
    const fs::path path = folder / "made_by.json";
    if (fs::exists(path) ? Json::parse(read_text(path), nullptr, false) != claim
                         : !fs::is_empty(folder))
        throw BatchError(Kind::kBadInput, folder.string() +
                                              ": holds what another policy, protocol or build "
                                              "made; choose another folder");
    write_whole(path, claim.dump() + "\n");
}

/// Recordings in the folder by what they are of. Two of the same: which one counts?
std::map<Attempt, fs::path> recordings_of(const fs::path& folder) {
    std::map<Attempt, fs::path> found;
    for (const fs::path& file : recordings_in(folder)) {
        const auto head = db::recording_summary(file.string()).header;
        if (const auto [at, fresh] = found.emplace(Attempt{head.task_id, head.seed}, file); !fresh)
            throw BatchError(Kind::kBadInput, file.string() + " and " + at->second.string() +
                                                  ": both are of " + words_of(at->first) +
                                                  "; expected one attempt at each, the first");
    }
    return found;
}

Json attempt_json(const Protocol& protocol, const Attempt& attempt, const fs::path& file) {
    const sim::Recording recording = db::read_recording_file(file.string());
    if (const auto problem = assessment::unsound(recording))
        throw BatchError(Kind::kBadInput,
                         file.string() + ": cannot be scored: " + problem->english());
    const curriculum::Task task = protocol_task(protocol, attempt.first);
    const auto judged = environment::judge_finished(task.rubric, recording);
    return {{"task", attempt.first},
            {"seed", attempt.second},
            {"points", judged.score.points},
            {"passed", judged.score.verdict == assessment::Verdict::kPassed},
            {"duration_s", recording.end.duration_s},
            {"build", recording.header.build},
            {"final_hash", hash_text(recording.end.final_hash)},
            {"recording", file.filename().string()},
            {"sha256", sha256_of_file(file)}};
}

/// Means by task, and over the tasks.
void sum_up(const Protocol& protocol, Json& entry) {
    double sum = 0;
    entry["tasks"] = Json::array();
    for (const BenchmarkTask& one : protocol.tasks) {
        double points = 0;
        int attempts = 0, passed = 0;
        for (const Json& attempt : entry["attempts"]) {
            if (attempt["task"] != one.task) continue;
            ++attempts;
            passed += attempt["passed"].get<bool>() ? 1 : 0;
            points += attempt["points"].get<double>();
        }
        if (attempts == 0) continue;
        entry["tasks"].push_back({{"task", one.task},
                                  {"attempts", attempts},
                                  {"passed", passed},
                                  {"points", points / attempts}});
        sum += points / attempts;
    }
    entry["complete"] = entry["tasks"].size() == protocol.tasks.size();
    entry["score"] = sum / static_cast<double>(entry["tasks"].size());
}

}  // namespace

Json make_entry(const Protocol& protocol, const EntryOrder& order, const fs::path& folder,
                const EntryProgress& progress) {
    if (!order.policy.empty()) need_policy(order.policy);
    const std::vector<Attempt> attempts = attempts_of(protocol, order);
    fs::create_directories(folder);
    if (!order.policy.empty()) {
        claim_folder(protocol, order, folder);
        const auto fields = std::make_shared<environment::FieldCache>(1);
        for (const Attempt& attempt : attempts) {
            const fs::path file =
                folder / (attempt.first + "-" + std::to_string(attempt.second) + ".placode");
            // What a stopped run has made already.
            if (!fs::exists(file)) perform(protocol, order.policy, attempt, fields, file, progress);
        }
    }
    const auto recordings = recordings_of(folder);
    Json entry{{"benchmark", protocol.id},
               {"version", protocol.version},
               {"protocol_sha256", protocol.sha256},
               {"name", order.name},
               {"policy", order.policy.empty() ? Json() : Json(order.policy)},
               {"build", order.build},
               {"held_out_seeds", !order.seeds.empty() && order.seeds != protocol.seeds},
               {"seeds", order.seeds.empty() ? protocol.seeds : order.seeds},
               {"attempts", Json::array()}};
    for (const Attempt& attempt : attempts) {
        if (!progress(words_of(attempt))) throw Stopped{};
        const auto at = recordings.find(attempt);
        if (at == recordings.end())
            throw BatchError(Kind::kBadInput, folder.string() + ": holds no recording of " +
                                                  words_of(attempt) +
                                                  "; expected one of each task and seed");
        entry["attempts"].push_back(attempt_json(protocol, attempt, at->second));
    }
    sum_up(protocol, entry);
    write_whole(folder / "entry.json", entry.dump(2) + "\n");
    return entry;
}

}  // namespace placode::batches
