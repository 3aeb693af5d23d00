// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Metrics of movement in signal files: speeds, positions, two hands.

#include <optional>

#include "assessment/signal_metrics.h"

namespace placode::assessment {

using SignalValues = std::vector<std::pair<std::string, double>>;

/// Appends what is known.
void add(SignalValues& out, const char* key, std::optional<double> value);

/// Sampling rate [Hz]; throws SignalError when times do not grow or, with `must_be_even`, are not
/// evenly spaced.
[[nodiscard]] double rate_of(const SignalFile& file, bool must_be_even);

/// Columns: t_s, speed in mm/s.
[[nodiscard]] SignalValues speed_metrics(const SignalFile& file, const SignalOptions& options);
/// Columns: t_s, speed in a unit that nobody told.
[[nodiscard]] SignalValues unitless_speed_metrics(const SignalFile& file,
                                                  const SignalOptions& options);
/// Columns: t_s, x [mm], or x, y, z, or these and a quaternion w first.
[[nodiscard]] SignalValues pose_metrics(const SignalFile& file, const SignalOptions& options);
/// Columns: t_s, speed of the left and of the right hand in mm/s.
[[nodiscard]] SignalValues bimanual_metrics(const SignalFile& file, const SignalOptions& options);

}  // namespace placode::assessment
