// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A list of trainees in which one is found by typing a part of the name.

#include "ui/shell/app_context.h"

class QComboBox;

namespace placode::ui {

/// An empty list that is searched by what is typed.
[[nodiscard]] QComboBox* make_search_list(const char* object);
/// Adds the active trainees whom the user teaches; the store is asked again when it is done.
void add_trainees(AppContext& context, QComboBox* list);
/// The row that is meant: the one whose text is typed as a whole, else the only one that holds what
/// is typed; -1 = none does, or several do.
[[nodiscard]] int chosen_row(const QComboBox* list);
/// Why chosen_row() is -1, and what to do.
/// @param unknown what is said when no row holds what is typed, which stands for its %1.
[[nodiscard]] QString why_no_row(const QComboBox* list, const QString& unknown);

}  // namespace placode::ui
