// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a field was washed: what the recording's last events say of jet, suction, fluid, debris and
// view (sim/fluid/irrigation.h).

#include "assessment/metrics.h"

namespace placode::assessment {

/// The event that tells one of the sums; nullptr where nobody counted.
[[nodiscard]] const sim::Event* irrigation_sum(const sim::Recording& recording,
                                               sim::IrrigationSum what);

/// Nothing without irrigation, or where the last events are not all there.
void add_wash_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
