// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Why points were lost: what it means is kept, and put into words at the end, in whichever
// language.

#include <string>
#include <utility>

namespace placode::assessment {

/// Where along a slit: between which bites of its row.
struct BetweenBites {
    /// Numbers of the bites from 1, as one goes from the slit's left or upper end to the other one;
    /// 0 = that end. No bite at all says nothing.
    int before = 0, after = 0;
    bool upright = false;  ///< The ends are an upper and a lower one, else a left and a right one.
    [[nodiscard]] bool any() const noexcept { return before > 0 || after > 0; }
    bool operator==(const BetweenBites&) const = default;
};

/// A sentence with places, and what stands in them. Places: {value}, {unit}, {points}, {count},
/// {times}, {where}, {metric}.
struct ReasonMeaning {
    std::string pattern;        ///< English; empty in scores that an older program wrote.
    std::string pattern_pl;     ///< The wording of the rubric; empty where it has none.
    std::string metric;         ///< Metric id: {metric} is its name, {unit} its unit.
    double value = 0;           ///< Of the metric.
    int count = 0;              ///< How often it happened.
    int hour = 0;               ///< Position on the clock face, 1 to 12; 0 = nowhere in particular.
    BetweenBites between = {};  ///< Says more than the hour where it says anything.
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

/// " between bites 2 and 3", " between the left end and bite 1": with %1 and %2 where numbers of
/// bites stand, the lower first. Empty where `between` says nothing.
[[nodiscard]] const char* between_pattern(const BetweenBites& between) noexcept;
/// The numbers that stand in it; the second is 0 where it has one place.
[[nodiscard]] std::pair<int, int> between_numbers(const BetweenBites& between) noexcept;

/// At most one decimal, none where it says nothing, two below 1; '.' in every locale. Beyond a
/// million in the short form: "1e+300".
[[nodiscard]] std::string reason_number(double value);

/// The words of the sentence in English; another language says some of them again.
[[nodiscard]] ReasonWords english_places(const ReasonMeaning& meaning, double points);
/// The sentence in English.
[[nodiscard]] std::string english_words(const ReasonMeaning& meaning, double points);

}  // namespace placode::assessment
