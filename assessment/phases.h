// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An attempt part by part: metrics and damage ledger of each phase. A phase that is entered again
// (the check finds more to cut) is a part of its own.

#include <map>
#include <span>
#include <vector>

#include "assessment/metrics.h"

namespace placode::assessment {

struct PhasePart {
    sim::Phase phase = sim::Phase::kInspect;
    double from_s = 0, to_s = 0;
    MetricSet metrics;  ///< Of this part alone.
};

/// In order of time. Parts shorter than 0.1 s are left out: nothing can be measured in them.
[[nodiscard]] std::vector<PhasePart> compute_phase_metrics(const sim::Recording& recording);

struct PhaseLedger {
    sim::Phase phase = sim::Phase::kInspect;
    double from_s = 0, to_s = 0;
    std::map<sim::EventKind, int> counts;  ///< Phase changes and state hashes are left out.
};

/// Ledger by phase, from the events alone: an attempt in a store has no samples at hand.
/// @param events in order of time.
[[nodiscard]] std::vector<PhaseLedger> ledger_by_phase(std::span<const sim::Event> events,
                                                       double duration_s);

}  // namespace placode::assessment
