// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Entry of a study's sheets from paper, twice, and the decision where the two entries differ.

#include <functional>
#include <string>
#include <vector>

#include "db/study_conduct.h"
#include "db/study_records.h"
#include "ui/shell/pages.h"

class QTableWidget;

namespace placode::ui {

/// What the card shows of a study.
struct EntryData {
    std::string study;
    std::vector<db::Progress> progress;
    std::vector<db::AnswerRecord> answers;
    std::vector<db::EntryDifference> differences;
};

/// @param people table of the participants, codes in front: the chosen one's sheet is entered.
/// @param again is called when a difference was decided.
[[nodiscard]] QWidget* make_entry_card(AppContext& context, Page& page, const EntryData& data,
                                       QTableWidget* people, const std::function<void()>& again);

}  // namespace placode::ui
