// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What grasper and scissors did: lifted, released, snipped, taken out.

#include <algorithm>
#include <array>
#include <optional>

#include "assessment/tissue_metric_parts.h"
#include "sim/world/pieces_state.h"

namespace placode::assessment {

namespace {

/// Shows every sample, and before it what the instruments did since the one before.
template <class See, class Look>
void go_through(const sim::Recording& recording, See see, Look look) {
    size_t next = 0;
    for (const sim::Sample& sample : recording.samples) {
        for (; next < recording.events.size() && recording.events[next].time_s <= sample.time_s;
             ++next) {
            const sim::Event& e = recording.events[next];
            if (e.tool >= 0 && e.tool < sim::kMaxTools) see(e, static_cast<size_t>(e.tool), sample);
        }
        for (size_t t = 0; t < sim::kMaxTools; ++t) look(t, sample.tools[t]);
    }
}

/// Seconds during which held tissue was lifted, from the height of the tip since its grasp.
double lifted_s(const sim::Recording& recording) {
    constexpr float kLiftedM = 0.0007F;
    double sum = 0;
    std::array<float, sim::kMaxTools> from{};
    std::array<bool, sim::kMaxTools> holding{};
    go_through(
        recording,
        [&](const sim::Event& e, size_t t, const sim::Sample& sample) {
            if (e.kind == sim::EventKind::kGrasped) {
                holding[t] = true;
                from[t] = sample.tools[t].tip_m[2];
            } else if (e.kind == sim::EventKind::kReleased) {
                holding[t] = false;
            }
        },
        [&](size_t t, const sim::ToolSample& tool) {
            if (holding[t] && tool.tip_m[2] - from[t] > kLiftedM) sum += recording.header.sample_s;
        });
    return sum;
}

/// Seconds during which jaws crushed. The ledger enters when a grasp begins to; it goes on until
/// they let go, while they are shut as far as then: their force follows from their opening alone.
double crushed_s(const sim::Recording& recording) {
    double sum = 0;
    std::array<bool, sim::kMaxTools> crushing{};
    std::array<float, sim::kMaxTools> enough{}, last{};  // openings [rad]
    go_through(
        recording,
        [&](const sim::Event& e, size_t t, const sim::Sample& sample) {
            if (e.kind == sim::EventKind::kCrushed) {
                crushing[t] = true;
                enough[t] = std::max(last[t], sample.tools[t].jaw_rad);
            } else if (e.kind == sim::EventKind::kReleased) {
                crushing[t] = false;
            }
        },
        [&](size_t t, const sim::ToolSample& tool) {
            if (crushing[t] && tool.jaw_rad <= enough[t]) sum += recording.header.sample_s;
            last[t] = tool.jaw_rad;
        });
    return sum;
}

/// The share of the marked tissue that the ledger's last such entry tells.
std::optional<double> marked_share(const sim::Recording& recording, sim::EventKind kind) {
    std::optional<double> share;
    for (const sim::Event& e : recording.events)
        if (e.kind == kind) share = std::max(share.value_or(0), static_cast<double>(e.value2));
    return share;
}

/// Around how much of the placode nothing holds any more [deg]. Every sector is looked at once in
/// the first frames, when nothing can have been cut: one that is free then (in a coarse field a
/// sector may have no path of its own to the skin) says nothing about the operation.
double released_deg(const sim::Recording& recording) {
    const double first_round_s = (sim::kSectors + 0.5) * recording.header.frame_s;
    int hung = sim::kSectors, freed = 0;
    for (const sim::Event& e : recording.events) {
        if (e.kind != sim::EventKind::kSectorFree) continue;
        if (e.time_s <= first_round_s)
            --hung;
        else
            ++freed;
    }
    return hung > 0 ? 360.0 * freed / hung : 0;
}

/// What became of the marked tissue: taken out, destroyed; the rest was left behind.
void add_marked(const sim::Recording& recording, std::vector<Metric>& out) {
    const auto taken = marked_share(recording, sim::EventKind::kTakenOut);
    const auto lost = marked_share(recording, sim::EventKind::kMarkedLost);
    if (taken) out.push_back({"resected_percent", *taken * 100});
    if (lost) out.push_back({"marked_lost_percent", *lost * 100});
    if (taken && lost) out.push_back({"marked_gone_percent", 100 * std::min(1.0, *taken + *lost)});
}

}  // namespace

void add_dissection(const sim::Recording& recording, std::vector<Metric>& out) {
    using sim::EventKind;
    bool jaws = false, blades = false;
    for (const sim::ToolSpec& tool : recording.header.tools) {
        jaws = jaws || tool.kind == sim::ToolKind::kGrasper;
        blades = blades || tool.kind == sim::ToolKind::kScissors;
    }
    if (!recording.header.geometry.planned_contour.empty()) {
        out.push_back({"released_deg", released_deg(recording)});
    }
    if (blades) {
        double skin_m2 = 0;
        for (const sim::Event& e : recording.events)
            if (e.kind == EventKind::kSnipped && is_skin(e.tissue)) skin_m2 += e.value;
        const EventSum snips = total(recording, EventKind::kSnipped);
        const EventSum pieces = total(recording, EventKind::kPieceOut);
        out.push_back({"placode_snip_mm2", total(recording, EventKind::kPlacodeCut).value * 1e6});
        out.push_back({"skin_snip_mm2", skin_m2 * 1e6});
        out.push_back({"snips", static_cast<double>(snips.count)});
        out.push_back({"pieces_out", static_cast<double>(pieces.count)});
        out.push_back({"resected_mm3", pieces.value * 1e9});
        add_marked(recording, out);
    }
    if (jaws) {
        const EventSum released = total(recording, EventKind::kReleased);
        const EventSum crushes = total(recording, EventKind::kCrushed);
        const EventSum pulls = total(recording, EventKind::kOverTraction);
        out.push_back({"grasps", static_cast<double>(total(recording, EventKind::kGrasped).count)});
        out.push_back({"lift_hold_s", lifted_s(recording)});
        out.push_back(
            {"slip_count", static_cast<double>(total(recording, EventKind::kSlipped).count)});
        out.push_back({"crush_count", crushes.count + crushed_s(recording) / kAgainS});
        out.push_back(
            {"over_traction_count", times_of(spells_of(recording, EventKind::kOverTraction))});
        out.push_back({"peak_traction_mn", std::max(released.peak, pulls.peak) * 1e3});
    }
}

}  // namespace placode::assessment
