// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/scoring.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "assessment/tissue_metrics.h"
#include "sim/practice.h"
#include "sim/retune.h"

namespace placode::assessment {

namespace {

using sim::Event;
using sim::EventKind;

/// Where a metric's story can be seen.
struct Locus {
    std::optional<Vec2> at_m;
    double time_s = -1;
    int count = 0;
};

/// Which of several events to show.
enum class Show : uint8_t { kFirst, kLongest, kStrongest };

struct EventSource {
    std::string_view metric;
    EventKind kind;
    Show show;
    bool lasts;  ///< value is a duration, and the event was raised at its end.
};
constexpr EventSource kSources[]{
    {"placode_contacts", EventKind::kPlacodeContact, Show::kFirst, true},
    {"placode_contact_s", EventKind::kPlacodeContact, Show::kLongest, true},
    {"placode_peak_force_mn", EventKind::kPlacodeContact, Show::kStrongest, true},
    {"placode_energised_s", EventKind::kPlacodeEnergised, Show::kLongest, true},
    {"placode_overheated", EventKind::kPlacodeOverheated, Show::kFirst, false},
    {"placode_peak_cem43_min", EventKind::kPlacodeOverheated, Show::kFirst, false},
    {"placode_burned_percent", EventKind::kPlacodeBurned, Show::kFirst, false},
    {"over_force_count", EventKind::kOverForce, Show::kStrongest, true},
    {"over_force_s", EventKind::kOverForce, Show::kLongest, true},
    {"peak_force_mn", EventKind::kOverForce, Show::kStrongest, true},
    {"energy_in_air_count", EventKind::kEnergyInAir, Show::kLongest, true},
    {"energy_in_air_s", EventKind::kEnergyInAir, Show::kLongest, true},
    {"dwell_s", EventKind::kDwell, Show::kLongest, true},
    {"torn_volume_mm3", EventKind::kTorn, Show::kFirst, false},
    {"crush_count", EventKind::kCrushed, Show::kStrongest, false},
    {"slip_count", EventKind::kSlipped, Show::kStrongest, false},
    {"target_misses", sim::kTargetMissed, Show::kFirst, false},
    {"over_traction_count", EventKind::kOverTraction, Show::kStrongest, true},
    {"peak_traction_mn", EventKind::kReleased, Show::kStrongest, true},
    {"placode_snip_mm2", EventKind::kPlacodeCut, Show::kLongest, false},
};

void use_event(Locus& locus, const Event& event, bool lasts) {
    locus.at_m = Vec2(event.rest_position_m[0], event.rest_position_m[1]);
    locus.time_s = lasts ? std::max(0.0, event.time_s - event.value) : event.time_s;
}

Locus locate_events(const EventSource& source, const sim::Recording& recording) {
    Locus locus;
    const Event* best = nullptr;
    for (const Event& event : recording.events) {
        if (event.kind != source.kind) continue;
        ++locus.count;
        const bool better = best == nullptr ||
                            (source.show == Show::kLongest && event.value > best->value) ||
                            (source.show == Show::kStrongest && event.value2 > best->value2);
        if (better) best = &event;
    }
    if (best != nullptr) use_event(locus, *best, source.lasts);
    return locus;
}

/// First element lost to heat or tearing in one class of tissue.
template <class Wanted>
Locus locate_removed(const sim::Recording& recording, Wanted wanted) {
    Locus locus;
    for (const Event& event : recording.events) {
        if (!wanted(event)) continue;
        if (locus.count++ == 0) use_event(locus, event, false);
    }
    return locus;
}

/// Worst place of the incision for a metric of the contour.
Locus locate_incision(std::string_view metric, const sim::Recording& recording) {
    Locus locus;
    const std::optional<Incision> incision = analyse_incision(recording);
    if (!incision) return locus;
    if (metric == "ring_completeness_percent" || metric == "largest_gap_mm") {
        locus.count = incision->cover.gaps;
        if (locus.count > 0) locus.at_m = incision->gap_at_m;
        return locus;
    }
    const KerfBin* worst = nullptr;
    for (const KerfBin& bin : incision->bins) {
        if (!(bin.volume_m3 > 0)) continue;
        if (metric == "outside_band_mm" && !bin.outside_band) continue;
        if (metric == "toward_placode_mm" && !bin.toward_placode) continue;
        ++locus.count;
        const bool inwards = metric == "toward_placode_mm";
        const bool worse =
            worst == nullptr || (inwards ? bin.offset_m < worst->offset_m
                                         : std::abs(bin.offset_m) > std::abs(worst->offset_m));
        if (worse) worst = &bin;
    }
    if (worst != nullptr) {
        locus.at_m = worst->at_m;
        locus.time_s = worst->time_s;
    }
    return locus;
}

Locus locate(std::string_view metric, const sim::Recording& recording) {
    for (const EventSource& source : kSources) {
        if (source.metric == metric) return locate_events(source, recording);
    }
    const auto torn = [](const Event& e) { return e.kind == EventKind::kTorn; };
    if (metric == "placode_cut_mm3") {
        return locate_removed(recording, [&](const Event& e) {
            return (torn(e) || e.kind == EventKind::kVaporised) &&
                   e.tissue == sim::Tissue::kPlacode;
        });
    }
    if (metric == "torn_skin_mm3") {
        return locate_removed(recording, [&](const Event& e) {
            return torn(e) &&
                   (e.tissue == sim::Tissue::kSkin || e.tissue == sim::Tissue::kThinSkin);
        });
    }
    if (metric == "skin_snip_mm2") {
        return locate_removed(recording, [](const Event& e) {
            return e.kind == EventKind::kSnipped &&
                   (e.tissue == sim::Tissue::kSkin || e.tissue == sim::Tissue::kThinSkin);
        });
    }
    for (const char* contour : {"ring_completeness_percent", "largest_gap_mm", "off_line_mm",
                                "outside_band_mm", "toward_placode_mm", "contour_deviation_mm",
                                "contour_deviation_p95_mm", "contour_deviation_max_mm"}) {
        if (metric == contour) return locate_incision(metric, recording);
    }
    return {};
}

/// At most one decimal, none where it says nothing; '.' in every locale.
std::string number(double value) {
    const int decimals = std::abs(value) >= 100 || value == std::floor(value) ? 0
                         : std::abs(value) >= 1                               ? 1
                                                                              : 2;
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
    return {text, end.ptr};
}

std::string times(int count) {
    if (count == 1) return "once";
    if (count == 2) return "twice";
    return std::to_string(count) + " times";
}

void replace_all(std::string& text, std::string_view what, const std::string& with) {
    for (size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

std::string reason_text(const RubricItem& item, double value, double points, const Locus& locus) {
    std::string unit;
    for (const MetricDefinition& definition : metric_definitions()) {
        if (definition.id == item.metric) unit = definition.unit;
    }
    std::string text = item.reason;
    replace_all(text, "{value}", number(value));
    replace_all(text, "{unit}", unit);
    replace_all(text, "{points}", number(points));
    replace_all(text, "{count}", std::to_string(locus.count));
    replace_all(text, "{times}", times(locus.count));
    const std::string where =
        locus.at_m
            ? " at " + std::to_string(clock_hour(locus.at_m->x(), locus.at_m->y())) + " o'clock"
            : "";
    replace_all(text, " {where}", where);
    replace_all(text, "{where}", where);
    return text;
}

}  // namespace

int clock_hour(double x_m, double y_m) noexcept {
    // +x is up and +y is left in the picture, so the clock runs from +x towards -y.
    const double turns = std::atan2(-y_m, x_m) / (2 * std::numbers::pi);
    const int hour = static_cast<int>(std::lround(turns * 12 + 12)) % 12;
    return hour == 0 ? 12 : hour;
}

Score score_attempt(const Rubric& rubric, const MetricSet& metrics,
                    const sim::Recording& recording) {
    Score score;
    score.rubric_id = rubric.id;
    score.rubric_version = rubric.version;
    score.metric_set_version = metrics.version;
    double points = rubric.start_points;
    bool critical = false;
    for (const RubricItem& item : rubric.items) {
        const std::optional<double> value = metrics.find(item.metric);
        if (!value) continue;
        const double beyond = item.below ? item.threshold - *value : *value - item.threshold;
        if (!(beyond > 0)) continue;
        const double lost =
            std::min(item.max_points, item.points_fixed + item.points_per_unit * beyond);
        // Less than a twentieth of a point is no reason worth reading.
        if (lost < 0.05 && !item.critical) continue;
        const Locus locus = locate(item.metric, recording);
        score.reasons.push_back(
            {item.id, reason_text(item, *value, lost, locus), lost, locus.time_s, item.critical});
        points -= lost;
        critical = critical || item.critical;
    }
    // Tissue that was changed by hand is not the task's: such an attempt shows something, it proves
    // nothing.
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::kTuned) continue;
        score.reasons.insert(
            score.reasons.begin(),
            {"tuned", "Tissue or generator was tuned: this attempt is not scored as a pass.", 0,
             event.time_s, true});
        critical = true;
        break;
    }
    score.points = std::clamp(points, 0.0, 100.0);
    std::stable_sort(score.reasons.begin(), score.reasons.end(),
                     [](const Reason& a, const Reason& b) {
                         // What failed the attempt comes first, also where it took no points.
                         return a.critical != b.critical ? a.critical : a.points > b.points;
                     });
    score.verdict = critical                             ? Verdict::kFailed
                    : score.points >= rubric.pass_points ? Verdict::kPassed
                                                         : Verdict::kNotYet;
    return score;
}

}  // namespace placode::assessment
