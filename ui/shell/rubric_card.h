// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is scored in a task: the points it begins with, the mark, and the rule of every item.

#include <QFrame>

#include "curriculum/course.h"
#include "curriculum/task.h"
#include "ui/shell/app_context.h"

namespace placode::ui {

/// @param exam the stage of a course that the attempt is an exam of; nullptr = practice.
[[nodiscard]] QFrame* make_rubric_card(AppContext& context, const curriculum::Task& task,
                                       const curriculum::CourseStage* exam);

}  // namespace placode::ui
