// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/metrics.h"

namespace placode::assessment {

/// Metrics of a suture needle from the events of a recording; nothing where no driver was there.
void add_suture_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
