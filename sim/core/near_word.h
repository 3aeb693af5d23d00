// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// "Did you mean": the known word that a misspelt one is nearest to. All programs ask here.

#include <string>
#include <string_view>
#include <vector>

namespace placode::sim {

/// Fewest letters put in, left out, replaced or swapped with their neighbour that turn `a` into `b`
/// (optimal string alignment). Bytes; capitals count as their small letters.
[[nodiscard]] size_t edit_distance(std::string_view a, std::string_view b);

/// The known word that was probably meant, or empty: at most a third of the letters differ, or the
/// word is the beginning of just one of them. Of equals the first.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string>& known);

/// `; did you mean "script:expert"?`, or nothing when no known word is near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

}  // namespace placode::sim
