// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letters that are not seen but do something: they move the cursor of a terminal, turn the
// direction of what follows, begin a line, or make two names look alike. A name holds none, and
// what an older store holds is shown without them.

#include <string>
#include <string_view>

namespace placode::sim {

/// Whether `code` is a control (Cc), a format character (Cf: direction, zero width, soft hyphen,
/// tags), or ends a line or paragraph (Zl, Zp). Source: Unicode 15.0, DerivedGeneralCategory.txt.
[[nodiscard]] bool is_hidden_letter(char32_t code) noexcept;

/// Whether UTF-8 text holds such a letter, or bytes that are no UTF-8.
/// @param but letters of ASCII that may be there.
[[nodiscard]] bool has_hidden_letters(std::string_view text, std::string_view but = {});

/// The text with U+FFFD in place of each. Damaged bytes become one as well.
[[nodiscard]] std::string without_hidden_letters(std::string_view text, std::string_view but = {});

}  // namespace placode::sim
