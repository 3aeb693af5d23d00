// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a terminal is given. Names are other people's text, and one from an older store may hold
// what moves the cursor or hides the rest of the line.

#include <string>

#include "sim/core/hidden_letters.h"

namespace placode::cli {

/// The text with its lines and tabs, and U+FFFD for every other letter that is not seen.
[[nodiscard]] inline std::string on_screen(const std::string& text) {
    return sim::without_hidden_letters(text, "\n\t");
}

}  // namespace placode::cli
