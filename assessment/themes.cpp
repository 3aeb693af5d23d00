// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/themes.h"

#include <algorithm>
#include <array>

namespace placode::assessment {
namespace {

struct Prefix {
    std::string_view text;
    Theme theme;
};
// First match counts: "toward_placode" is about the line, not about contact.
constexpr Prefix kPrefixes[]{
    {"toward_placode", Theme::kIncision},
    {"placode_", Theme::kPlacode},
    {"energy_near_placode", Theme::kEnergy},
    {"ring_", Theme::kIncision},
    {"largest_gap", Theme::kIncision},
    {"contour_", Theme::kIncision},
    {"off_line", Theme::kIncision},
    {"outside_band", Theme::kIncision},
    {"kerf_", Theme::kIncision},
    {"released", Theme::kRelease},
    {"resected", Theme::kRelease},
    {"pieces", Theme::kRelease},
    {"grasps", Theme::kRelease},
    {"marked_", Theme::kRelease},
    {"lift_hold", Theme::kRelease},
    {"energy", Theme::kEnergy},
    {"activation", Theme::kEnergy},
    {"dwell", Theme::kEnergy},
    {"task_time", Theme::kTime},
    {"path_length", Theme::kTime},
    {"idle", Theme::kTime},
    {"target_", Theme::kPrecision},
    {"trace_", Theme::kPrecision},
    {"patch_grasps", Theme::kTissue},
    {"patch_", Theme::kPrecision},
    {"wash_jet", Theme::kTissue},
    {"wash_suction", Theme::kTissue},
    {"wash_", Theme::kPrecision},
    {"undermine_fascia", Theme::kTissue},
    {"undermine_", Theme::kPrecision},
    {"closing_", Theme::kPrecision},
    {"out_of_view", Theme::kPrecision},
    {"steps_", Theme::kSteps},
};

double lost_in(const Rubric& rubric, Theme theme, const std::vector<Reason>& reasons,
               bool* critical) {
    double lost = 0;
    for (const Reason& reason : reasons) {
        const auto item =
            std::find_if(rubric.items.begin(), rubric.items.end(),
                         [&](const RubricItem& each) { return each.id == reason.item; });
        if (item == rubric.items.end() || theme_of(item->metric) != theme) continue;
        lost += reason.points;
        if (critical != nullptr) *critical = *critical || reason.critical;
    }
    return lost;
}

/// A weakness comes before a strength, what costs more before what costs less.
int rank(const ThemeResult& result) {
    switch (result.judgement) {
        case ThemeResult::Judgement::kWeakness:
            return result.critical ? 0 : 1;
        case ThemeResult::Judgement::kStrength:
            return 2;
        default:
            return 3;
    }
}

}  // namespace

Theme theme_of(std::string_view metric) {
    for (const Prefix& prefix : kPrefixes)
        if (metric.substr(0, prefix.text.size()) == prefix.text) return prefix.theme;
    return Theme::kTissue;
}

std::vector<ThemeResult> judge_themes(const Rubric& rubric, const std::vector<Reason>& reasons,
                                      const std::vector<std::vector<Reason>>& earlier) {
    std::vector<ThemeResult> results;
    // Where nothing was done, nothing was done well.
    if (std::any_of(reasons.begin(), reasons.end(),
                    [](const Reason& each) { return each.item == kNotAttemptedItem; }))
        return results;
    for (int i = 0; i < kThemes; ++i) {
        ThemeResult result;
        result.theme = static_cast<Theme>(i);
        const bool has = std::any_of(
            rubric.items.begin(), rubric.items.end(),
            [&](const RubricItem& each) { return theme_of(each.metric) == result.theme; });
        if (!has) continue;
        result.lost = lost_in(rubric, result.theme, reasons, &result.critical);
        if (!earlier.empty()) {
            double sum = 0;
            for (const auto& each : earlier) sum += lost_in(rubric, result.theme, each, nullptr);
            result.before = sum / static_cast<double>(earlier.size());
        }
        using Judgement = ThemeResult::Judgement;
        const bool better = result.before && *result.before - result.lost >= 2;
        if (result.critical || result.lost >= 5)
            result.judgement = Judgement::kWeakness;
        else if (result.lost < 0.05 || better)
            result.judgement = Judgement::kStrength;
        results.push_back(result);
    }
    std::stable_sort(results.begin(), results.end(),
                     [](const ThemeResult& a, const ThemeResult& b) {
                         return rank(a) != rank(b) ? rank(a) < rank(b) : a.lost > b.lost;
                     });
    return results;
}

}  // namespace placode::assessment
