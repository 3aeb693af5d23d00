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
/// The row that fits what is typed, which may be a part of a name; -1 = none does.
[[nodiscard]] int chosen_row(const QComboBox* list);

}  // namespace placode::ui
