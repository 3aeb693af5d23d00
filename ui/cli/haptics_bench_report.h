// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `bench haptics` prints and writes.

#include <string>

#include "haptics/bench/haptic_bench_suite.h"
#include "ui/cli/cli.h"

namespace placode::cli {

[[nodiscard]] Json haptics_bench_json(const haptics::HapticBenchSuite& bench);
[[nodiscard]] std::string haptics_bench_text(const haptics::HapticBenchSuite& bench);
/// bench_haptics.csv, .json, time lines and figures. Throws InputError.
void write_haptics_bench(const haptics::HapticBenchSuite& bench, const Json& json,
                         const std::string& folder);

}  // namespace placode::cli
