// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/metrics.h"

namespace placode::assessment {

/// Metrics of a needle that goes from hand to hand; nothing where there were not two drivers.
void add_handling_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
