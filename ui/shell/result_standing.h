// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What became of an attempt beside its points: why it does not count, and how far its replay is.

#include <QString>
#include <QWidget>

#include "ui/shell/app_context.h"
#include "ui/shell/exam_standing.h"

namespace placode::ui {

/// Complete and sound, but for the proof.
[[nodiscard]] bool waits_for_replay(const db::AttemptRecord& record);

/// Whether that can be done here: bits are promised for one build and instruction set.
[[nodiscard]] bool can_be_replayed_here(const db::AttemptRecord& record);

/// For who reads it: sentences. @param own it is the reader's.
[[nodiscard]] QString why_not_counted(const db::AttemptRecord& record, const ExamStanding& standing,
                                      bool own);

/// Of an own attempt that counts: that its stage of the course is mastered, and what is next. Empty
/// where a newer one counts, or the course has no such stage.
[[nodiscard]] QString course_words(AppContext& context, const db::AttemptRecord& record);

/// Follows the replay of this attempt, and has it begun; the window builds the page anew at the
/// end.
[[nodiscard]] QWidget* make_replay_bar(AppContext& context, int64_t attempt_id);

}  // namespace placode::ui
