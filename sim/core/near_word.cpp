// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/near_word.h"

#include <algorithm>

namespace placode::sim {
namespace {

constexpr size_t kLongestWord = 200;  ///< Nobody misspells more.

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows are enough: a swap of neighbours looks two rows back.
    std::vector<size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = small(a[i - 1]) == small(b[j - 1]);
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (same ? 0u : 1u)});
            if (i > 1 && j > 1 && small(a[i - 1]) == small(b[j - 2]) &&
                small(a[i - 2]) == small(b[j - 1]))
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
    if (word.empty() || word.size() > kLongestWord) return {};
    const std::string* best = nullptr;
    size_t least = std::max<size_t>(1, word.size() / 3) + 1;
    for (const std::string& each : known) {
        // What is much longer or shorter cannot be near.
        const size_t apart =
            std::max(each.size(), word.size()) - std::min(each.size(), word.size());
        if (apart >= least) continue;
        const size_t distance = edit_distance(word, each);
        if (distance >= least) continue;
        least = distance;
        best = &each;
    }
    if (best != nullptr) return *best;
    const auto begun = [&](const std::string& each) { return each.starts_with(word); };
    if (word.size() < 2 || std::count_if(known.begin(), known.end(), begun) != 1) return {};
    return *std::find_if(known.begin(), known.end(), begun);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    const std::string near = nearest_word(word, known);
    return near.empty() ? std::string() : "; did you mean \"" + near + "\"?";
}

}  // namespace placode::sim
