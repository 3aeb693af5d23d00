// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How well a slit was sewn up: what is left of its opening when the attempt ends.

#include "assessment/metrics.h"

namespace placode::assessment {

/// The event of the station that gapes most; nullptr where there was no slit, or nobody looked.
[[nodiscard]] const sim::Event* widest_gap(const sim::Recording& recording);

/// Edges this near at the end count as shut [m].
inline constexpr double kShutM = 0.0002;

/// Share that is shut, mean and widest gap; nothing where there was no slit.
void add_closure_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
