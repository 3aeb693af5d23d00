// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/skill_levels.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "batches/scores.h"
#include "db/recording_file.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

/// Null for whoever is no scripted operator of a level.
db::LevelAttempts* level_of(SkillLevels& levels, std::string_view operator_name) {
    if (operator_name == "expert") return &levels.experts;
    if (operator_name == "intermediate") return &levels.intermediates;
    if (operator_name == "novice") return &levels.novices;
    return nullptr;
}

void add(SkillLevels& levels, std::string_view operator_name, db::MeasuredAttempt attempt) {
    db::LevelAttempts* const level = level_of(levels, operator_name);
    if (level == nullptr) return;
    if (attempt.record.verdict == assessment::Verdict::kNotAttempted) {
        ++levels.not_attempted;
        return;
    }
    level->by_person[static_cast<int64_t>(attempt.record.seed)].push_back(std::move(attempt));
}

}  // namespace

SkillLevels levels_of_recordings(const std::string& task_id, const fs::path& folder) {
    constexpr std::string_view kScript = "script:";
    const curriculum::Task task = curriculum::load_task(task_id);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".placode") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    SkillLevels levels;
    for (const fs::path& file : files) {
        const sim::Recording recording = db::read_recording_file(file.string());
        const std::string_view device = recording.header.device;
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

SkillLevels levels_of_rollouts(const std::string& task_id, const fs::path& folder) {
    const std::string task = curriculum::load_task(task_id).id;
    SkillLevels levels;
    for (const RolloutScore& each : scores_of_rollouts(folder, read_manifest(folder))) {
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

}  // namespace placode::batches
