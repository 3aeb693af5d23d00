// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Before an attempt that begins at a stage: what comes before it is taken from the user's cache or
// made now, in a window that shows the expert at work, or told on standard error.

#include <memory>
#include <string>

#include "curriculum/stage_start.h"
#include "ui/attempt/arguments.h"

namespace placode::ui {

/// What stands in the picture meanwhile, in the user's language: "Preparing stage: bite 2, 40 %".
[[nodiscard]] std::string preparing_text(const curriculum::TaskStage& stage, double share,
                                         const std::string& language);

/// Main thread. Null: Esc was pressed, the window closed or the program asked to stop. Throws
/// DefinitionError for a stage that the task does not have (before anything is shown), StageError
/// and ViewError.
[[nodiscard]] std::shared_ptr<const curriculum::StageStart> prepare_stage(
    const curriculum::Task& task, const Arguments& arguments);

}  // namespace placode::ui
