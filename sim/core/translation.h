// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What haptics, curriculum and the attempt's window say, in another language. There is one file of
// Polish, ui/shell/translations/placode_pl.ts. Programs with Qt ask a QTranslator for it; these
// folders have no Qt (libplacode.so is made of them as well), and some of their sentences are
// needed in both languages at once. So the build makes a table of the contexts that they use
// (cmake/write_translations.cmake): part of the program, found by halving, nothing to load.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace placode::sim {

/// A text of the translation files.
struct Translation {
    std::string_view context, english;
    /// Where a number is said, the forms for 1, 2 to 4, and more; otherwise the first one.
    std::array<std::string_view, 3> polish;
    /// Where a number is said, the English forms for 1 and for others.
    std::array<std::string_view, 2> counted;
};

/// All of them, by context and English. Generated at build time.
[[nodiscard]] std::span<const Translation> embedded_translations() noexcept;

/// `english` in `language` ("en", "pl"); `english` itself where it has no translation, so what is
/// returned may live no longer than that. Any thread; never allocates.
[[nodiscard]] std::string_view translated(std::string_view context, std::string_view english,
                                          std::string_view language) noexcept;

/// The form that goes with a number; %n is not filled yet. As translated().
[[nodiscard]] std::string_view translated(std::string_view context, std::string_view english,
                                          std::string_view language, int64_t number) noexcept;

}  // namespace placode::sim
