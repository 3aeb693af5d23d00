// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strengths and weaknesses: the lines of a rubric by what they are about, against the own earlier
// attempts.

#include <optional>
#include <vector>

#include "assessment/scoring.h"

namespace placode::assessment {

/// What a line of a rubric is about.
enum class Theme : uint8_t {
    kPlacode,    ///< Neural tissue left alone.
    kIncision,   ///< On the line, complete.
    kRelease,    ///< What the task wants done: lifted, free, resected, taken out.
    kTissue,     ///< Skin and soft tissue: force, tears, jaws.
    kEnergy,     ///< Pedals.
    kTime,       ///< Time and way.
    kPrecision,  ///< Targets hit, lines followed, instruments kept in view.
    kSteps,      ///< Steps of a practice task done.
};
inline constexpr int kThemes = 8;
[[nodiscard]] Theme theme_of(std::string_view metric);

struct ThemeResult {
    Theme theme = Theme::kPlacode;
    double lost = 0;               ///< Points lost in this attempt.
    bool critical = false;         ///< A critical error belongs to it.
    std::optional<double> before;  ///< Mean of the points lost in the earlier attempts.
    enum class Judgement : uint8_t {
        kStrength,  ///< Nothing lost, or at least 2 points less than before.
        kWeakness,  ///< A critical error, or at least 5 points lost.
        kNeither
    } judgement = Judgement::kNeither;
};

/// One result for each theme that the rubric has, weaknesses first (the most costly first), then
/// strengths. `earlier`: reasons of own earlier attempts under the same rubric; may be empty.
[[nodiscard]] std::vector<ThemeResult> judge_themes(
    const Rubric& rubric, const std::vector<Reason>& reasons,
    const std::vector<std::vector<Reason>>& earlier);

}  // namespace placode::assessment
