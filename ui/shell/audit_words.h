// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the audit's codes ("user.create") say, in the program's language.

#include <QString>
#include <string_view>

namespace placode::ui {

/// The sentence for an action; the code itself where none is known (a newer program's store).
[[nodiscard]] QString audit_words(std::string_view action);

}  // namespace placode::ui
