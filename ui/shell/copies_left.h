// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the data of participants who were just erased may still be.

#include <QLabel>

#include "ui/shell/app_context.h"

namespace placode::ui {

/// The copies of the store, as a warning; nullptr where there are none, and for no participant.
/// @param codes of the participants, for people.
[[nodiscard]] QLabel* make_copies_left(AppContext& context, const QString& codes);

}  // namespace placode::ui
