// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the files of hard cases give to bench/hard_cases.h. Private to bench.

#include <span>
#include <string>

#include "sim/core/number_text.h"
#include "sim/verify/stability_cases.h"

namespace placode::bench {

struct HardCase {
    const char* name;
    /// Fills in verdict, error and detail.
    void (*run)(sim::StabilityResult& result, const sim::StabilityOptions& options);
};

/// In the scene of a task that has needle and thread: the scripted expert bites, then the hand does
/// what no hand should.
[[nodiscard]] std::span<const HardCase> suture_cases();
/// In the scene of the task that has a patch: it is folded and pushed through a hole in the tissue,
/// and handled without sense.
[[nodiscard]] std::span<const HardCase> patch_cases();

/// What has come to rest is no faster [m/s].
inline constexpr double kCalmM_S = 0.01;

/// "1.23 mm"
[[nodiscard]] inline std::string millimetres(double metres) {
    return sim::rounded_text(1000 * metres, 3) + " mm";
}

}  // namespace placode::bench
