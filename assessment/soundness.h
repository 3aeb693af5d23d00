// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether a recording can be scored: everything that scoring needs is there, finite, in range and
// in order. What is missing must never make a better score.

#include <optional>

#include "sim/core/said.h"
#include "sim/step/recording.h"

namespace placode::assessment {

/// No attempt is longer [s]; the simulator ends one after an hour.
inline constexpr double kLongestRecordingS = 2 * 3600;

/// What is wrong ("sample 12 has no finite tip position"); nothing: it can be scored. Of a
/// recording that broke off only what is there is asked for.
[[nodiscard]] std::optional<sim::Said> unsound(const sim::Recording& recording);

}  // namespace placode::assessment
