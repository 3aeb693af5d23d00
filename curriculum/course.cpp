// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course.h"

#include <algorithm>
#include <set>

#include "curriculum/json_reader.h"

namespace placode::curriculum {

namespace {

/// One task's stage in the light of all outcomes: the streak that was reached once stays reached.
StageProgress stage_progress(const CourseStage& stage,
                             const std::vector<AttemptOutcome>& outcomes) {
    StageProgress progress;
    progress.status = StageStatus::kOpen;
    for (const AttemptOutcome& outcome : outcomes) {
        if (outcome.task_id != stage.task_id || outcome.interrupted) continue;
        progress.best_points = progress.attempts == 0
                                   ? outcome.points
                                   : std::max(progress.best_points, outcome.points);
        ++progress.attempts;
        const bool met = outcome.points >= stage.benchmark_points && !outcome.critical;
        progress.streak = met ? progress.streak + 1 : 0;
        if (progress.streak >= stage.consecutive) progress.status = StageStatus::kMastered;
    }
    return progress;
}

}  // namespace

Course load_course(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("courses", id_or_file);
    const std::string origin = file.string();
    const Json json = parse_json(read_definition(file), origin);
    check_schema(json, "course", origin);
    Course course;
    course.id = json["id"];
    course.version = json["version"];
    course.title = local_text(json["title"]);
    if (json.contains("description")) course.description = local_text(json["description"]);
    std::set<std::string> earlier;
    for (size_t i = 0; i < json["stages"].size(); ++i) {
        const Json& entry = json["stages"][i];
        const std::string pointer = "/stages/" + std::to_string(i);
        CourseStage stage;
        stage.task_id = entry["task_id"];
        stage.benchmark_points = entry.value("benchmark_points", stage.benchmark_points);
        stage.consecutive = entry.value("consecutive", stage.consecutive);
        for (const Json& required : entry.value("requires_tasks", Json::array())) {
            stage.requires_tasks.push_back(required);
            // A stage that waits for itself or for a later one could never open.
            if (!earlier.contains(stage.requires_tasks.back())) {
                throw DefinitionError(
                    origin, pointer + "/requires_tasks",
                    "\"" + stage.requires_tasks.back() + "\" is not the task of an earlier stage");
            }
        }
        if (!earlier.insert(stage.task_id).second) {
            throw DefinitionError(origin, pointer + "/task_id",
                                  "\"" + stage.task_id + "\" is already a stage of this course");
        }
        course.stages.push_back(std::move(stage));
    }
    return course;
}

CourseProgress course_progress(const Course& course, const std::vector<AttemptOutcome>& outcomes) {
    CourseProgress progress;
    std::set<std::string> mastered;
    for (const CourseStage& stage : course.stages) {
        StageProgress own = stage_progress(stage, outcomes);
        if (own.status == StageStatus::kMastered) mastered.insert(stage.task_id);
        progress.stages.push_back(std::move(own));
    }
    for (size_t i = 0; i < course.stages.size(); ++i) {
        StageProgress& own = progress.stages[i];
        for (const std::string& task : course.stages[i].requires_tasks) {
            if (!mastered.contains(task)) own.missing.push_back(task);
        }
        if (!own.missing.empty() && own.status == StageStatus::kOpen)
            own.status = StageStatus::kLocked;
        if (progress.next_stage < 0 && own.status == StageStatus::kOpen)
            progress.next_stage = static_cast<int>(i);
    }
    return progress;
}

}  // namespace placode::curriculum
