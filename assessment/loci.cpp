// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/loci.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/bites.h"
#include "assessment/closure.h"
#include "assessment/leak_map.h"
#include "assessment/loci_line.h"
#include "assessment/motion_metrics.h"
#include "assessment/patch_metrics.h"
#include "assessment/practice.h"
#include "assessment/tissue_metric_parts.h"
#include "assessment/undermine_metrics.h"
#include "assessment/wash_metrics.h"

namespace placode::assessment {

namespace {

using sim::Event;
using sim::EventKind;

/// Which of several events to show.
enum class Show : uint8_t { kFirst, kLast, kLongest, kStrongest, kWeakest };

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
    {"energy_in_air_count", EventKind::kEnergyInAir, Show::kLongest, true},
    {"energy_in_air_s", EventKind::kEnergyInAir, Show::kLongest, true},
    {"dwell_s", EventKind::kDwell, Show::kLongest, true},
    {"buried_s", EventKind::kBuried, Show::kLongest, true},
    {"buried_count", EventKind::kBuried, Show::kLongest, true},
    {"torn_volume_mm3", EventKind::kTorn, Show::kFirst, false},
    {"over_stretch_count", EventKind::kOverStretch, Show::kFirst, false},
    {"over_stretch_mm3_s", sim::EventKind::kStretchSum, Show::kLongest, false},
    {"max_stretch", sim::EventKind::kStretchSum, Show::kStrongest, false},
    {"crush_count", EventKind::kCrushed, Show::kStrongest, false},
    {"slip_count", EventKind::kSlipped, Show::kStrongest, false},
    {"grasps", EventKind::kGrasped, Show::kLast, false},
    {"lift_hold_s", EventKind::kReleased, Show::kLast, false},
    {"target_misses", sim::EventKind::kTargetMissed, Show::kFirst, false},
    {"steps_done_percent", sim::EventKind::kStepDone, Show::kLast, false},
    {"traction_held_s", sim::EventKind::kTractionHeld, Show::kLast, false},
    {"draw_pull_least_mn", sim::EventKind::kThreadDrawn, Show::kWeakest, false},
    {"over_traction_count", EventKind::kOverTraction, Show::kStrongest, true},
    {"bite_entry_offset_mm", EventKind::kBiteEntry, Show::kLast, false},
    {"bite_exit_offset_mm", EventKind::kBiteExit, Show::kLast, false},
    {"bite_depth_mm", EventKind::kBiteExit, Show::kLast, false},
    {"bite_angle_deg", EventKind::kBiteEntry, Show::kLast, false},
    {"needle_entries", EventKind::kNeedleEntered, Show::kLast, false},
    {"needle_drops", EventKind::kNeedleDropped, Show::kFirst, false},
    {"needle_place_off_percent", EventKind::kNeedlePlaced, Show::kStrongest, false},
    {"needle_askew_deg", EventKind::kNeedleGrip, Show::kWeakest, false},
    {"needle_turned_deg", EventKind::kNeedleSwung, Show::kLongest, false},
    {"needle_handover_turn_deg", EventKind::kNeedleHandedOver, Show::kLongest, false},
    {"needle_handover_force_mn", EventKind::kNeedleHandedOver, Show::kStrongest, false},
    {"placode_snip_mm2", EventKind::kPlacodeCut, Show::kLongest, false},
};

/// Events that happen nowhere on the tissue, or do not say where.
bool has_place(const Event& event) {
    if (event.kind == EventKind::kEnergyInAir || event.kind == sim::EventKind::kStepDone)
        return false;
    return event.rest_position_m[0] != 0 || event.rest_position_m[1] != 0;
}

void use_event(Locus& locus, const Event& event, bool lasts) {
    if (has_place(event)) locus.at_m = Vec2(event.rest_position_m[0], event.rest_position_m[1]);
    locus.time_s = lasts ? std::max(0.0, event.time_s - event.value) : event.time_s;
}

Locus locate_events(const EventSource& source, const sim::Recording& recording) {
    Locus locus;
    const Event* best = nullptr;
    for (const Event& event : recording.events) {
        if (event.kind != source.kind) continue;
        if (event.kind == sim::EventKind::kStretchSum && event.element < 0)
            continue;  // says "recorded" only
        ++locus.count;
        const bool better = best == nullptr || source.show == Show::kLast ||
                            (source.show == Show::kLongest && event.value > best->value) ||
                            (source.show == Show::kStrongest && event.value2 > best->value2) ||
                            (source.show == Show::kWeakest && event.value2 < best->value2);
        if (better) best = &event;
    }
    if (best != nullptr) use_event(locus, *best, source.lasts);
    return locus;
}

/// First element lost to heat, blades or tearing in one class of tissue.
template <class Wanted>
Locus locate_first(const sim::Recording& recording, Wanted wanted) {
    Locus locus;
    for (const Event& event : recording.events) {
        if (!wanted(event)) continue;
        if (locus.count++ == 0) use_event(locus, event, false);
    }
    return locus;
}

/// Where most of the marked tissue still hangs.
Locus locate_left(const sim::Recording& recording) {
    Locus locus;
    for (const Event& event : recording.events) {
        if (event.kind == EventKind::kPieceOut) {
            ++locus.count;
            locus.time_s = event.time_s;
        }
        if (event.kind == sim::EventKind::kTakenOut && has_place(event))
            locus.at_m = Vec2(event.rest_position_m[0], event.rest_position_m[1]);
    }
    return locus;
}

/// Strongest of the two events that tell a pull.
Locus locate_pull(const sim::Recording& recording) {
    Locus locus;
    const Event* best = nullptr;
    for (const Event& event : recording.events) {
        if (event.kind != EventKind::kReleased && event.kind != EventKind::kOverTraction) continue;
        ++locus.count;
        if (best == nullptr || event.value2 > best->value2) best = &event;
    }
    if (best != nullptr) use_event(locus, *best, true);
    return locus;
}

/// Strongest force: of the ledger, which sees every frame, or of the samples.
Locus locate_force(const sim::Recording& recording) {
    Locus locus;
    double worst = 0;
    for (const Event& event : recording.events) {
        if (event.kind != EventKind::kOverForce && event.kind != EventKind::kPlacodeContact)
            continue;
        ++locus.count;
        if (!(event.value2 > worst)) continue;
        worst = event.value2;
        use_event(locus, event, true);
    }
    for (const sim::Sample& sample : recording.samples) {
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
            const sim::ToolSample& tool = sample.tools[i];
            const double force = std::hypot(tool.force_n[0], tool.force_n[1], tool.force_n[2]);
            if (!(force > worst)) continue;
            worst = force;
            locus.time_s = sample.time_s;
            locus.at_m = Vec2(tool.tip_m[0], tool.tip_m[1]);
        }
    }
    return locus;
}

/// Where energy first reached healthy skin.
Locus locate_skin_heat(const sim::Recording& recording) {
    const HealthySkin skin(recording.header.geometry);
    Locus locus;
    for (const sim::Sample& sample : recording.samples) {
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i) {
            const sim::ToolSample& tool = sample.tools[i];
            if (!skin.heated(tool)) continue;
            locus.count = 1;
            locus.time_s = sample.time_s;
            locus.at_m = Vec2(tool.tip_m[0], tool.tip_m[1]);
            return locus;
        }
    }
    return locus;
}

/// Beginning of the longest spell with a tip outside the picture.
Locus locate_out_of_view(const sim::Recording& recording) {
    Locus locus;
    double begun = -1, longest = 0;
    for (const sim::Sample& sample : recording.samples) {
        bool out = false;
        for (size_t i = 0; i < recording.header.tools.size() && i < sim::kMaxTools; ++i)
            out = out || (recording.header.tools[i].kind != sim::ToolKind::kScope &&
                          sample.tools[i].in_view == 0);
        if (out && begun < 0) begun = sample.time_s;
        if (out && sample.time_s - begun >= longest) {
            longest = sample.time_s - begun;
            locus.time_s = begun;
        }
        if (!out) begun = -1;
    }
    return locus;
}

/// Metrics that come from one class of tissue.
std::optional<Locus> locate_tissue(std::string_view metric, const sim::Recording& recording) {
    const auto torn = [](const Event& e) { return e.kind == EventKind::kTorn; };
    if (metric == "placode_cut_mm3") {
        return locate_first(recording, [&](const Event& e) {
            return (torn(e) || e.kind == EventKind::kVaporised) &&
                   e.tissue == sim::Tissue::kPlacode;
        });
    }
    if (metric == "torn_skin_mm3")
        return locate_first(recording,
                            [&](const Event& e) { return torn(e) && is_skin(e.tissue); });
    if (metric == "skin_burned_mm3") {
        const HealthySkin skin(recording.header.geometry);
        return locate_first(recording,
                            [&](const Event& e) { return e.value > 0 && skin.burned(e); });
    }
    if (metric == "skin_snip_mm2") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kSnipped && is_skin(e.tissue);
        });
    }
    return std::nullopt;
}

/// The first touch that came down farthest from its target.
std::optional<Locus> locate_touch(std::string_view metric, const sim::Recording& recording) {
    if (metric != "target_error_mm") return std::nullopt;
    Locus locus;
    const Event* worst = nullptr;
    for (const Event* touch : first_touches(recording)) {
        ++locus.count;
        if (worst == nullptr || touch->value2 > worst->value2) worst = touch;
    }
    if (worst != nullptr) use_event(locus, *worst, false);
    return locus;
}

/// Metrics of needle and thread that more than one kind of event counts, or not every event.
std::optional<Locus> locate_suture(std::string_view metric, const sim::Recording& recording) {
    if (metric == "needle_slips") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kNeedleSlipped || e.kind == EventKind::kNeedleTurned;
        });
    }
    if (metric == "needle_let_between") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kNeedleHandedOver && e.element == 0;
        });
    }
    if (metric == "needle_handovers") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kNeedleHandedOver && e.element > 0;
        });
    }
    if (metric == "thread_cuts") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kThreadCut || e.kind == EventKind::kThreadToreOut;
        });
    }
    if (metric == "needle_regrasps") {  // whoever takes it first takes nothing again
        bool first = true;
        return locate_first(recording, [&](const Event& e) {
            return e.kind == EventKind::kNeedleTaken && !std::exchange(first, false);
        });
    }
    return std::nullopt;
}

/// Where a slit leaks: at the pressure that the metric speaks of, and where it burst. Of a test in
/// which nobody looked at that the station that leaks most at the lower pressure.
std::optional<Locus> locate_leak(std::string_view metric, const sim::Recording& recording) {
    const std::optional<Watertight> test = watertight_of(recording);
    if (!test) return std::nullopt;
    Locus locus;
    locus.count = 1;
    if (const std::optional<LeakMap> map = leak_map(recording)) {
        const bool burst = metric.substr(0, 10) == "slit_burst";
        const LeakStage stage = burst && map->burst                       ? LeakStage::kLast
                                : burst || metric == "slit_leak_6_ml_min" ? LeakStage::kPass
                                                                          : LeakStage::kGood;
        if (const std::optional<LeakPlace> place = worst_leak(*map, stage)) {
            locus.at_m = place->at_m;
            locus.between = place->between;
            return locus;
        }
    }
    if (test->worst == nullptr) return std::nullopt;
    locus.at_m = rest_place(*test->worst).head<2>();
    return locus;
}

std::optional<Locus> locate_slit(std::string_view metric, const sim::Recording& recording) {
    if (metric.substr(0, 5) != "slit_") return std::nullopt;
    if (metric.substr(0, 10) == "slit_burst" ||
        (metric.substr(0, 10) == "slit_leak_" && metric != "slit_leak_ml_min"))
        return locate_leak(metric, recording);
    const Event* widest = widest_gap(recording);
    if (widest == nullptr) return std::nullopt;
    Locus locus;
    locus.count = 1;
    locus.at_m = rest_place(*widest).head<2>();
    return locus;
}

/// Where a patch reaches least beyond the placode's edge, where it is folded, where it was taken
/// last.
std::optional<Locus> locate_patch(std::string_view metric, const sim::Recording& recording) {
    if (metric.substr(0, 6) != "patch_") return std::nullopt;
    const Event* shown = nullptr;
    Locus locus;
    for (const Event& e : recording.events) {
        const bool taken = metric == "patch_grasps" && e.kind == EventKind::kGrasped;
        if (taken) ++locus.count;
        if (taken || (metric == "patch_folded_percent" && e.kind == EventKind::kPatchFold))
            shown = &e;
    }
    if (metric.substr(0, 13) == "patch_overlap" || metric == "patch_uncovered_percent")
        shown = least_overlap(recording);
    if (shown == nullptr) return locus;
    locus.count = std::max(1, locus.count);
    use_event(locus, *shown, false);
    if (shown->kind == EventKind::kPatchEdge || shown->kind == EventKind::kPatchFold)
        locus.time_s = -1;  // how it lies is no moment
    return locus;
}

/// Where the jet pressed hardest on the placode, where suction held tissue, what is left.
std::optional<Locus> locate_wash(std::string_view metric, const sim::Recording& recording) {
    if (metric.substr(0, 5) != "wash_") return std::nullopt;
    const bool jet = metric.substr(0, 8) == "wash_jet",
               held = metric.substr(0, 12) == "wash_suction",
               left = metric == "wash_cleared_percent",
               fluid = metric.substr(0, 10) == "wash_fluid",
               placode = metric == "wash_suction_placode_s";
    Locus locus;
    const Event* shown = nullptr;
    for (const Event& e : recording.events) {
        const bool mine = (jet && e.kind == EventKind::kJetOnPlacode) ||
                          (held && e.kind == EventKind::kSuctionHeld &&
                           (!placode || e.tissue == sim::Tissue::kPlacode)) ||
                          (left && e.kind == EventKind::kDebrisLeft);
        if (!mine) continue;
        ++locus.count;
        if (shown == nullptr || (!left && e.value > shown->value)) shown = &e;
    }
    if (shown == nullptr) {
        // Told by its sum alone, at the end.
        using Sum = sim::IrrigationSum;
        const Event* sum = irrigation_sum(recording, jet     ? Sum::kJet
                                                     : held  ? Sum::kSuction
                                                     : left  ? Sum::kDebris
                                                     : fluid ? Sum::kFluid
                                                             : Sum::kView);
        if (sum != nullptr) use_event(locus, *sum, false);
        return locus;
    }
    use_event(locus, *shown, !left);
    if (left) locus.time_s = -1;
    return locus;
}

/// Where skin holds nearest to the wound's edge; fascia where it tore first.
std::optional<Locus> locate_undermining(std::string_view metric, const sim::Recording& recording) {
    const bool closing = metric.substr(0, 8) == "closing_";
    if (!closing && metric.substr(0, 10) != "undermine_") return std::nullopt;
    if (metric == "undermine_fascia_mm3") {
        return locate_first(recording, [](const Event& e) {
            return e.kind == EventKind::kTorn && e.tissue == sim::Tissue::kMuscle;
        });
    }
    const int side = metric == "undermine_left_percent"    ? 1
                     : metric == "undermine_right_percent" ? -1
                                                           : 0;
    Locus locus;
    const Event* shown = shallowest_line(recording, side);
    if (shown == nullptr) return locus;
    locus.count = 1;
    use_event(locus, *shown, false);
    locus.time_s = -1;  // how far it came is no moment
    return locus;
}

/// The bite of a row that a metric speaks of, where it went in or came out.
std::optional<Locus> locate_bite(std::string_view metric, const sim::Recording& recording) {
    if (metric.substr(0, 5) != "bite_" && metric != "bites_done") return std::nullopt;
    const std::vector<Bite> bites = bites_of(recording);
    if (bites.empty()) return std::nullopt;
    Locus locus;
    locus.count = static_cast<int>(
        std::count_if(bites.begin(), bites.end(), [](const Bite& bite) { return bite.done; }));
    const Bite* shown = bite_shown(metric, bites);
    if (shown == nullptr) return locus;
    const bool in = metric == "bite_entry_worst_mm" || metric == "bite_angle_least_deg";
    locus.at_m = (in ? shown->entry_m : shown->exit_m).head<2>();
    locus.time_s = in ? shown->entered_s : shown->left_s;
    return locus;
}

}  // namespace

Locus locate(std::string_view metric, double threshold, const sim::Recording& recording) {
    for (const EventSource& source : kSources)
        if (source.metric == metric) return locate_events(source, recording);
    if (const auto found = locate_tissue(metric, recording)) return *found;
    if (const auto found = locate_touch(metric, recording)) return *found;
    if (const auto found = locate_suture(metric, recording)) return *found;
    if (const auto found = locate_slit(metric, recording)) return *found;
    if (const auto found = locate_bite(metric, recording)) return *found;
    if (const auto found = locate_patch(metric, recording)) return *found;
    if (const auto found = locate_wash(metric, recording)) return *found;
    if (const auto found = locate_undermining(metric, recording)) return *found;
    if (const auto found = locate_on_line(metric, recording)) return *found;
    if (metric == "resected_percent" || metric == "marked_gone_percent" || metric == "pieces_out" ||
        metric == "resected_mm3")
        return locate_left(recording);
    if (metric == "peak_traction_mn") return locate_pull(recording);
    if (metric == "skin_heat_j") return locate_skin_heat(recording);
    if (metric == "peak_force_mn") return locate_force(recording);
    if (metric == "out_of_view_s") return locate_out_of_view(recording);
    if (metric == "task_time_s") {
        Locus locus;
        locus.time_s = task_start_s(recording) + threshold;
        return locus;
    }
    return {};
}

}  // namespace placode::assessment
