// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A text that says of itself that it is a draft: shipped consent texts do until a committee has
// approved them, and a published version is never changed.

#include <optional>
#include <string>

#include "curriculum/task.h"

namespace placode::curriculum {

/// The first text of a study or questionnaire that holds the word DRAFT (Polish: WERSJA ROBOCZA)
/// in capitals; a plain string counts as English. Nothing for text that is not JSON: whoever
/// publishes reads it anyway and says what is wrong.
[[nodiscard]] std::optional<LocalText> draft_text(const std::string& json);

}  // namespace placode::curriculum
