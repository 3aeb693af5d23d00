// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pages say about courses, in the user's language.

#include <QString>

#include "curriculum/course_editing.h"

namespace placode::ui {

[[nodiscard]] QString mode_word(curriculum::StageMode mode);
/// "Benchmark 70 points, 2 times in a row · at most 10 attempts · refresh after 90 days"
[[nodiscard]] QString stage_rule_words(const curriculum::CourseStage& stage);
/// "No help, no planned line; 3 fixed cases, one after the other ...; a proctor confirms ..."
[[nodiscard]] QString exam_words(const curriculum::ExamRule& exam);
/// What is wrong, and what is expected.
[[nodiscard]] QString problem_words(const curriculum::CourseProblem& problem);

}  // namespace placode::ui
