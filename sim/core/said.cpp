// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/said.h"

namespace placode::sim {

Said Said::listed(const std::string& english) {
    Said said;
    said.sentence_ = english;
    return said;
}

Said Said::as_is(const std::string& text) { return as_is(text, {}); }

Said Said::as_is(const std::string& text, const std::string& polish) {
    Said said;
    said.words_ = text;
    said.words_pl_ = polish;
    return said;
}

Said Said::with(const Said& part) const {
    Said more = *this;
    more.parts_.push_back(part);
    return more;
}

std::string Said::english() const {
    return in("en", [](const char* sentence) { return std::string(sentence); });
}

// One pass: a place in what is filled in stays.
std::string Said::filled(const std::string& sentence, const std::vector<std::string>& parts) {
    std::string out;
    for (size_t i = 0; i < sentence.size(); ++i) {
        const bool is_place = i + 1 < sentence.size() && sentence[i] == '%' &&
                              sentence[i + 1] >= '1' && sentence[i + 1] <= '9';
        const size_t place = is_place ? static_cast<size_t>(sentence[i + 1] - '1') : parts.size();
        if (place < parts.size())
            out += parts[place], ++i;
        else
            out += sentence[i];
    }
    return out;
}

}  // namespace placode::sim
