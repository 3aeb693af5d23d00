// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pages of studies share: which study, and how it is called.

#include <QComboBox>
#include <string>
#include <vector>

#include "ui/shell/app_context.h"

namespace placode::ui {

/// Title of the published protocol, else the id.
[[nodiscard]] QString study_title(AppContext& context, const std::string& study);

/// `wanted` if it is among `ids`, else the one chosen last, else the first; empty = there is none.
/// Remembered for the other pages.
[[nodiscard]] std::string chosen_study(AppContext& context, const std::vector<std::string>& ids,
                                       const QString& wanted);

/// nullptr when there is nothing to choose. Data of an entry: the id.
[[nodiscard]] QComboBox* make_study_chooser(AppContext& context,
                                            const std::vector<std::string>& ids,
                                            const std::string& chosen);

}  // namespace placode::ui
