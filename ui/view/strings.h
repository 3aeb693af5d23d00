// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the attempt window says, by its English text. The Polish stands in the translation file
// (sim/core/translation.h, context Attempt).

#include <string>
#include <string_view>

namespace placode::view {

/// `english` in `language` ("en", "pl"); the English text itself when there is no translation.
[[nodiscard]] std::string translated(std::string_view english, std::string_view language);

}  // namespace placode::view
