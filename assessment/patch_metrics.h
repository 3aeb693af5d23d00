// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a patch was laid over the placode: what the recording's last events say of how it lies when
// hands have let go (sim/contact/patch_cover.h), and how often it was taken.

#include "assessment/metrics.h"

namespace placode::assessment {

/// A patch shall reach this far beyond the placode's edge [m]: planning value.
inline constexpr double kPatchOverlapM = 0.005;

/// The event of the point of the placode's edge beyond which the patch reaches least; nullptr where
/// nobody looked.
[[nodiscard]] const sim::Event* least_overlap(const sim::Recording& recording);

/// Overlap, placode left open, folds, grasps; nothing without a patch, or where the last events are
/// not all there.
void add_patch_metrics(const sim::Recording& recording, std::vector<Metric>& out);

}  // namespace placode::assessment
