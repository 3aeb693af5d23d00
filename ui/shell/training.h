// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a trainee stands: the course, what the attempts so far have opened, and what is next.
// Read by the pages Today, Course and Task.

#include <QVariantMap>
#include <optional>
#include <vector>

#include "curriculum/next_step.h"
#include "reports/task_scope.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// One stage with its task; a task that cannot be loaded keeps its place and says why.
struct TrainingStage {
    std::string task_id;
    std::optional<curriculum::Task> task;
    std::optional<Problem> problem;
    curriculum::CourseStage rule;
    curriculum::StageProgress progress;
};

struct Training {
    curriculum::Course course;
    std::vector<TrainingStage> stages;
    int next_stage = -1;        ///< -1 = nothing to do now; `next` says why.
    curriculum::NextStep next;  ///< What is next and why.
    bool mastered = false;      ///< Every stage.
    std::optional<db::CertificateRecord> certificate;
    std::vector<db::AttemptRecord> attempts;  ///< Own, oldest first.
    /// Title of a task in the user's language; its id when the task cannot be loaded.
    [[nodiscard]] QString taskTitle(const AppContext& context, const std::string& task_id) const;
};

/// Courses by id. First the one that this person chose last; without a choice the first assigned
/// one that is neither finished nor begins later. Then assigned ones by due date, then all others.
/// Throws DefinitionError when there is none.
[[nodiscard]] std::vector<std::string> course_ids(AppContext& context);

/// Makes it the first of course_ids(), for this person on this computer.
void choose_course(AppContext& context, const QString& id);

/// @param course its id; empty = the first of course_ids(). Throws DefinitionError (course) and
/// StoreError.
[[nodiscard]] Training load_training(AppContext& context, const std::string& course = {});

/// Throws StoreError(kRefused) for who may not see the attempt: everybody sees the own ones, an
/// educator those of others, a coordinator those of studies.
void require_sight(AppContext& context, const db::AttemptRecord& attempt);

/// Remarks of others on the own attempts, not older than two weeks and not read on this computer.
struct NewRemarks {
    int count = 0;
    int64_t attempt_id = 0;  ///< With the newest of them.
};
/// Looks at the last attempts only (of `own`, oldest first): remarks come soon or not at all.
[[nodiscard]] NewRemarks new_remarks(AppContext& context,
                                     const std::vector<db::AttemptRecord>& own);
/// The user has the remarks on an own attempt before the eyes.
void remarks_read(AppContext& context, int64_t attempt_id,
                  const std::vector<db::CommentRecord>& comments);

/// What the task page must know to open this stage: an exam is asked for as one.
[[nodiscard]] QVariantMap task_state(const curriculum::Course& course,
                                     const curriculum::CourseStage& stage);

/// Title of any task, also outside the course.
[[nodiscard]] QString task_title(AppContext& context, const std::string& task_id);
/// Title of a stage of it, in the reader's language; its number where the task has no such stage.
[[nodiscard]] QString stage_title(AppContext& context, const std::string& task_id, int stage);
/// What belongs to it; everything where it is not installed.
[[nodiscard]] reports::TaskScope task_scope(AppContext& context, const std::string& task_id);

}  // namespace placode::ui
