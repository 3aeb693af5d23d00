// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics.h"

#include <cmath>

#include "assessment/bites.h"
#include "assessment/motion_detail.h"
#include "assessment/motion_metrics.h"
#include "assessment/practice.h"
#include "assessment/suture_metrics.h"
#include "assessment/tissue_metrics.h"

namespace placode::assessment {

std::optional<double> MetricSet::find(std::string_view id) const {
    for (const Metric& metric : values) {
        if (metric.id == id) return metric.value;
    }
    return std::nullopt;
}

MetricSet compute_metrics(const sim::Recording& recording) {
    std::vector<Metric> found;
    add_motion_metrics(recording, found);
    add_motion_details(recording, found);
    add_tissue_metrics(recording, found);
    add_practice_metrics(recording, found);
    add_suture_metrics(recording, found);
    add_bite_metrics(recording, found);
    // In the order of the definitions; what is not finite is not known.
    MetricSet set;
    for (const MetricDefinition& definition : metric_definitions()) {
        for (const Metric& metric : found) {
            if (metric.id == definition.id && std::isfinite(metric.value))
                set.values.push_back(metric);
        }
    }
    return set;
}

}  // namespace placode::assessment
