// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/loci_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assessment/tissue_metrics.h"
#include "sim/core/practice.h"
#include "sim/world/pieces_state.h"

namespace placode::assessment {

namespace {

using sim::Event;
using sim::EventKind;

/// The largest gap as the ledger has it; without one, from what was removed.
Locus locate_gap(const sim::Recording& recording) {
    Locus locus;
    const Event* longest = nullptr;
    bool told = false;
    for (const Event& event : recording.events) {
        if (event.kind != sim::EventKind::kRingGap) continue;
        told = true;
        if (event.element < 0) continue;
        ++locus.count;
        if (longest == nullptr || event.value > longest->value) longest = &event;
    }
    if (longest != nullptr)
        locus.at_m = Vec2(longest->rest_position_m[0], longest->rest_position_m[1]);
    if (told) return locus;
    const std::optional<Incision> incision = analyse_incision(recording);
    if (!incision) return locus;
    locus.count = incision->cover.gaps;
    if (locus.count > 0) locus.at_m = incision->gap_at_m;
    return locus;
}

/// Worst place of the incision for a metric of the contour.
Locus locate_incision(std::string_view metric, const sim::Recording& recording) {
    Locus locus;
    const std::optional<Incision> incision = analyse_incision(recording);
    if (!incision) return locus;
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

/// Middle of the longest run of sectors that still hold, and when the last one came free.
Locus locate_held(const sim::Recording& recording) {
    std::array<bool, sim::kSectors> free{};
    Locus locus;
    for (const Event& event : recording.events) {
        if (event.kind != EventKind::kSectorFree) continue;
        if (event.value >= 0 && event.value < sim::kSectors)
            free[static_cast<size_t>(event.value)] = true;
        locus.time_s = event.time_s;
        ++locus.count;
    }
    int longest = 0, end = 0, run = 0;
    // Twice round, so that a run that passes the first sector is one.
    for (int i = 0; i < 2 * sim::kSectors; ++i) {
        run = free[static_cast<size_t>(i % sim::kSectors)] ? 0 : std::min(run + 1, sim::kSectors);
        if (run <= longest) continue;
        longest = run;
        end = i;
    }
    if (longest == 0 || longest == sim::kSectors) return locus;  // nowhere, or everywhere
    const double angle = 2 * std::numbers::pi * (end + 1 - longest / 2.0) / sim::kSectors;
    locus.at_m = Vec2(std::cos(angle), std::sin(angle));
    return locus;
}

/// A stretch of the line that was not followed, or the one that was followed worst.
Locus locate_trace(std::string_view metric, const sim::Recording& recording) {
    Locus locus;
    std::array<bool, sim::kTraceBins> done{};
    double worst = -1;
    int bin = -1;
    for (const Event& event : recording.events) {
        if (event.kind != sim::EventKind::kTraced ||
            !(event.value >= 0 && event.value < sim::kTraceBins))
            continue;
        ++locus.count;
        if (event.value2 <= 0.001F) done[static_cast<size_t>(event.value)] = true;
        if (metric == "trace_coverage_percent" || event.value2 <= worst) continue;
        worst = event.value2;
        bin = static_cast<int>(event.value);
        locus.time_s = event.time_s;
    }
    if (metric == "trace_coverage_percent" && locus.count > 0)
        bin = static_cast<int>(std::find(done.begin(), done.end(), false) - done.begin());
    const auto& line = recording.header.geometry.planned_contour;
    if (bin < 0 || bin == sim::kTraceBins || line.size() < 3) return locus;
    const ClosedContour contour(line);
    locus.at_m = contour.at((bin + 0.5) / sim::kTraceBins * contour.length());
    return locus;
}

}  // namespace

std::optional<Locus> locate_on_line(std::string_view metric, const sim::Recording& recording) {
    if (metric == "ring_completeness_percent" || metric == "largest_gap_mm" ||
        metric == "gap_count")
        return locate_gap(recording);
    if (metric == "off_line_mm" || metric == "outside_band_mm" || metric == "toward_placode_mm" ||
        metric.substr(0, 17) == "contour_deviation")
        return locate_incision(metric, recording);
    if (metric.substr(0, 6) == "trace_") return locate_trace(metric, recording);
    if (metric == "released_deg") return locate_held(recording);
    return std::nullopt;
}

}  // namespace placode::assessment
