// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/training.h"

#include <algorithm>

namespace placode::ui {

QString Training::taskTitle(const AppContext& context, const std::string& task_id) const {
    for (const TrainingStage& stage : stages) {
        if (stage.task_id == task_id && stage.task) return context.in(stage.task->title);
    }
    return QString::fromStdString(task_id);
}

std::vector<std::string> course_ids(AppContext& context) {
    std::vector<std::string> ids = curriculum::list_definitions("courses");
    if (ids.empty()) {
        throw curriculum::DefinitionError((curriculum::data_folder() / "courses").string(), "",
                                          "no course found; expected at least one .json file");
    }
    const std::string chosen = context.settings().value("course").toString().toStdString();
    const auto found = std::find(ids.begin(), ids.end(), chosen);
    if (found != ids.end()) std::rotate(ids.begin(), found, found + 1);
    return ids;
}

Training load_training(AppContext& context) {
    Training training;
    training.course = curriculum::load_course(course_ids(context).front());
    training.attempts = context.store().attempts(context.user().id);
    std::vector<curriculum::AttemptOutcome> outcomes;
    for (const db::AttemptRecord& attempt : training.attempts) {
        outcomes.push_back({attempt.task_id, attempt.points,
                            attempt.verdict == assessment::Verdict::kFailed,
                            attempt.end == sim::EndReason::kInterrupted});
    }
    const curriculum::CourseProgress progress =
        curriculum::course_progress(training.course, outcomes);
    training.next_stage = progress.next_stage;
    for (size_t i = 0; i < training.course.stages.size(); ++i) {
        TrainingStage stage;
        stage.rule = training.course.stages[i];
        stage.task_id = stage.rule.task_id;
        stage.progress = progress.stages[i];
        stage.problem =
            context.problemOf([&] { stage.task = curriculum::load_task(stage.rule.task_id); });
        training.stages.push_back(std::move(stage));
    }
    return training;
}

QString task_title(AppContext& context, const std::string& task_id) {
    QString title = QString::fromStdString(task_id);
    // A history may hold tasks that no longer ship: their id is title enough.
    (void)context.problemOf([&] { title = context.in(curriculum::load_task(task_id).title); });
    return title;
}

}  // namespace placode::ui
