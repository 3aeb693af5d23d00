// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Entry of a study's sheets from paper, twice, and the decision where the two entries differ.

#include <functional>
#include <string>
#include <vector>

#include "db/study_records.h"
#include "ui/shell/pages.h"

namespace placode::ui {

/// @param selected code of the participant whose sheet is entered.
/// @param again is called when a difference was decided.
[[nodiscard]] QWidget* make_entry_card(AppContext& context, Page& page, const std::string& study,
                                       const std::vector<db::AnswerRecord>& answers,
                                       const std::vector<db::EntryDifference>& differences,
                                       const std::function<QString()>& selected,
                                       const std::function<void()>& again);

}  // namespace placode::ui
