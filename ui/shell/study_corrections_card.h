// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Corrections of a study's answers: one is made for a reason, and all are listed with the old
// answer.

#include <functional>
#include <vector>

#include "db/study_records.h"
#include "ui/shell/pages.h"

class QTableWidget;

namespace placode::ui {

/// @param people the records, whose code stands in their first column; outlives the card.
/// @param again is called when something was corrected.
[[nodiscard]] QWidget* make_corrections_card(AppContext& context, Page& page,
                                             const std::vector<db::AnswerRecord>& answers,
                                             const std::vector<db::Correction>& corrections,
                                             const QTableWidget* people,
                                             const std::function<void()>& again);

}  // namespace placode::ui
