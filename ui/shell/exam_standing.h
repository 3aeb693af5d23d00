// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an attempt at an exam has used up, how many are left, and what comes next: for the result.

#include <QString>

#include "ui/shell/app_context.h"

namespace placode::ui {

struct ExamStanding {
    bool used = false;  ///< The attempt used up one of those that the exam allows.
    QString words;      ///< Empty where the course or its stage is gone.
};

/// Of an attempt at an exam, as its course stands today. Throws StoreError.
[[nodiscard]] ExamStanding exam_standing(AppContext& context, const db::AttemptRecord& attempt);

}  // namespace placode::ui
