// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/bilingual.h"

#include <algorithm>

#include "sim/core/number_text.h"
#include "sim/core/said.h"
#include "sim/core/translation.h"

namespace placode::curriculum {
namespace {

std::string filled(std::string_view sentence, const std::string& language,
                   const std::vector<LocalText>& parts) {
    sim::Said said = sim::Said::listed(std::string(sentence));
    for (const LocalText& part : parts) said = said.with(sim::Said::as_is(part));
    return said.in(language, [](const char* same) { return std::string(same); });
}

std::string with_number(std::string_view sentence, int64_t number) {
    std::string text(sentence);
    const size_t at = text.find("%n");
    return at == std::string::npos ? text : text.replace(at, 2, std::to_string(number));
}

}  // namespace

LocalText Bilingual::phrase(Phrase english, const std::vector<LocalText>& parts) {
    return {filled(english.english, "en", parts),
            filled(sim::translated(kContext, english.english, "pl"), "pl", parts)};
}

LocalText Bilingual::count_phrase(Phrase english, int64_t number,
                                  const std::vector<LocalText>& parts) {
    const auto in = [&](const char* language) {
        const std::string_view form = sim::translated(kContext, english.english, language, number);
        return filled(with_number(form, number), language, parts);
    };
    return {in("en"), in("pl")};
}

LocalText Bilingual::number(double value, int digits) {
    LocalText text = as_is(sim::rounded_text(value, digits));
    std::replace(text.pl.begin(), text.pl.end(), '.', ',');
    return text;
}

}  // namespace placode::curriculum
