// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A recording that is named on the command line: how it is read, and what of it and its metrics is
// printed.

#include "assessment/metrics.h"
#include "sim/step/recording.h"
#include "ui/cli/cli.h"

namespace placode::cli {

/// Throws InputError for what cannot be read. @param recover what stands before a damage is used.
/// @param damage what is wrong with the file, empty = nothing.
[[nodiscard]] sim::Recording load_recording(const std::string& file, bool recover,
                                            std::string& damage);

/// Task, device, seed, build, duration, end.
[[nodiscard]] Json recording_head(const sim::Recording& recording, const std::string& damage);

[[nodiscard]] Json metrics_json(const assessment::MetricSet& metrics);
[[nodiscard]] std::string metric_table(const assessment::MetricSet& metrics);

}  // namespace placode::cli
