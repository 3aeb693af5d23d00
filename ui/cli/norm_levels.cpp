// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/norm_levels.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "batches/scores.h"
#include "db/recording_file.h"
#include "ui/cli/batch.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;

/// Null for whoever is no scripted operator of a level.
db::LevelAttempts* level_of(Levels& levels, const std::string& operator_name) {
    if (operator_name == "expert") return &levels.experts;
    if (operator_name == "intermediate") return &levels.intermediates;
    if (operator_name == "novice") return &levels.novices;
    return nullptr;
}

/// A seed is a person. What was not attempted is counted only.
void add(Levels& levels, const std::string& operator_name, db::MeasuredAttempt attempt) {
    db::LevelAttempts* const level = level_of(levels, operator_name);
    if (level == nullptr) return;
    if (attempt.record.verdict == assessment::Verdict::kNotAttempted) {
        ++levels.not_attempted;
        return;
    }
    level->by_person[static_cast<int64_t>(attempt.record.seed)].push_back(std::move(attempt));
}

sim::Recording readable(const fs::path& file) {
    try {
        return db::read_recording_file(file.string());
    } catch (const db::StoreError& error) {
        throw InputError(error.what());
    }
}

}  // namespace

Levels levels_of_store(const Context& context, const QualityOptions& options) {
    if (options.novices.empty() || options.experts.empty())
        throw InputError(
            "norms quality: give --novices and --experts, --recordings FOLDER, or --batch FOLDER");
    Session session(context, Missing::kRefuse);
    session.need(db::Action::kSetStandards, db::Scope::kOther);
    std::map<std::string, std::vector<int64_t>> people{
        {"expert", find_group(session, options.experts).members},
        {"novice", find_group(session, options.novices).members}};
    if (!options.intermediates.empty())
        people["intermediate"] = find_group(session, options.intermediates).members;
    Levels found;
    for (db::LevelAttempts& level : db::level_attempts(session.store(), options.task, people)) {
        db::LevelAttempts& place = level.level == "expert"   ? found.experts
                                   : level.level == "novice" ? found.novices
                                                             : found.intermediates;
        place = std::move(level);
    }
    return found;
}

Levels levels_of_recordings(const QualityOptions& options) {
    constexpr std::string_view kScript = "script:";
    const curriculum::Task task = curriculum::load_task(options.task);
    std::error_code problem;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(options.recordings, problem))
        if (entry.path().extension() == ".placode") files.push_back(entry.path());
    if (problem) throw InputError("--recordings " + options.recordings + ": " + problem.message());
    std::sort(files.begin(), files.end());
    Levels levels;
    for (const fs::path& file : files) {
        const sim::Recording recording = readable(file);
        const std::string& device = recording.header.device;
        if (recording.header.task_id != task.id || !device.starts_with(kScript)) continue;
        db::MeasuredAttempt attempt;
        attempt.metrics = assessment::compute_metrics(recording);
        const auto score = assessment::score_attempt(task.rubric, attempt.metrics, recording);
        attempt.record.task_id = task.id;
        attempt.record.seed = recording.header.seed;
        attempt.record.points = score.points;
        attempt.record.verdict = score.verdict;
        add(levels, device.substr(kScript.size()), std::move(attempt));
    }
    return levels;
}

Levels levels_of_batch(const QualityOptions& options) {
    const std::string task = curriculum::load_task(options.task).id;
    Levels levels;
    const auto scores = of_batch([&] {
        return batches::scores_of_rollouts(options.batch, batches::read_manifest(options.batch));
    });
    for (const batches::RolloutScore& each : scores) {
        if (each.task != task) continue;
        db::MeasuredAttempt attempt;
        attempt.metrics = each.metrics;
        attempt.record.task_id = task;
        attempt.record.seed = each.seed;
        attempt.record.points = each.points;
        attempt.record.verdict = each.verdict;
        add(levels, each.policy, std::move(attempt));
    }
    return levels;
}

}  // namespace placode::cli
