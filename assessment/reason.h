// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Why points were lost: what it means is kept, and put into words at the end, in whichever
// language.

#include <string>

namespace placode::assessment {

/// A sentence with places, and what stands in them. Places: {value}, {unit}, {points}, {count},
/// {times}, {where}, {metric}.
struct ReasonMeaning {
    std::string pattern;     ///< English; empty in scores that an older program wrote.
    std::string pattern_pl;  ///< The wording of the rubric; empty where it has none.
    std::string metric;      ///< Metric id: {metric} is its name, {unit} its unit.
    double value = 0;        ///< Of the metric.
    int count = 0;           ///< How often it happened.
    int hour = 0;            ///< Position on the clock face, 1 to 12; 0 = nowhere in particular.
    bool operator==(const ReasonMeaning&) const = default;
};

/// Why points were lost, with the place in the recording that shows it.
struct Reason {
    std::string item;    ///< RubricItem::id
    std::string text;    ///< In English: "The needle rested 3.2 s on one spot at 4 o'clock."
    double points = 0;   ///< Lost.
    double time_s = -1;  ///< Where to look in the recording; -1 = whole attempt.
    bool critical = false;
    ReasonMeaning meaning = {};
};

/// What stands in the places of a sentence, in one language.
struct ReasonWords {
    std::string value, unit, points, count, times, where, metric;
};
/// A place that the sentence does not have is left out; a blank before an empty {where} goes, too.
[[nodiscard]] std::string fill_places(std::string pattern, const ReasonWords& words);

/// At most one decimal, none where it says nothing, two below 1; '.' in every locale. Beyond a
/// million in the short form: "1e+300".
[[nodiscard]] std::string reason_number(double value);

/// The words of the sentence in English; another language says some of them again.
[[nodiscard]] ReasonWords english_places(const ReasonMeaning& meaning, double points);
/// The sentence in English.
[[nodiscard]] std::string english_words(const ReasonMeaning& meaning, double points);

}  // namespace placode::assessment
