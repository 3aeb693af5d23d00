// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/said.h"

#include "curriculum/task.h"
#include "db/store_error.h"

namespace placode::db {

Said Said::that(Sentence sentence) { return listed(sentence.english); }

Said Said::listed(const char* english) {
    Said said;
    said.sentence_ = english;
    return said;
}

Said Said::as_is(const std::string& text) {
    Said said;
    said.words_ = text;
    return said;
}

Said Said::as_is(const curriculum::LocalText& text) {
    Said said = as_is(text.en);
    said.words_pl_ = text.pl;
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

std::string Said::words_in(const std::string& code) const {
    return curriculum::LocalText{words_, words_pl_}.in(code);
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

StoreError::StoreError(Kind kind, const std::string& before, const Said& said)
    : std::runtime_error(before + said.english()),
      kind_(kind),
      said_(std::make_shared<const Said>(said)) {}

}  // namespace placode::db
