// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How skin was undermined: what the recording's last events say of area, depth and the tension to
// close (sim/step/undermining_when_let_go.h).

#include "assessment/metrics.h"

namespace placode::assessment {

/// Where skin holds nearest to the wound's edge; nullptr where nobody measured. `side`: 1 = left,
/// -1 = right, 0 = either.
[[nodiscard]] const sim::Event* shallowest_line(const sim::Recording& recording, int side);

/// Nothing without a plane to undermine in, or where the last events are not all there.
void add_undermine_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
