// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Hard cases for the solver and for contact, each with a verdict. Short enough for a test; the
// command line runs them longer.

#include <functional>
#include <string>
#include <vector>

#include "sim/solver/soft_body.h"

namespace placode::sim {

enum class StabilityVerdict : uint8_t {
    kHolds,     ///< Never left its bounds.
    kRecovers,  ///< Back within its bounds after `seconds`, to the end.
    kRestored,  ///< As above, after it was given its rest shape (an event says so).
    kRefused,   ///< Not built: `detail` is the reason with its numbers.
    kFails,     ///< `detail` says how.
};
[[nodiscard]] const char* verdict_name(StabilityVerdict verdict) noexcept;

struct StabilityResult {
    std::string name, method;
    StabilityVerdict verdict = StabilityVerdict::kFails;
    double seconds = 0;  ///< Until it was back for good.
    /// Largest error at the end: of an edge against its rest length [-], or as `detail` says.
    double error = 0;
    std::string detail;
};

struct StabilityOptions {
    double seconds = 2;                                ///< Simulated time of a case.
    double rest_seconds = 4;                           ///< Of the case at rest.
    int64_t poke_frames = 4000;                        ///< Of the random pokes.
    std::function<void(const std::string&)> progress;  ///< May be empty.
};

/// Names of the cases, in order.
[[nodiscard]] std::vector<std::string> stability_case_names();

/// Runs one case with one method. @throws std::invalid_argument for an unknown name.
[[nodiscard]] StabilityResult run_stability_case(const std::string& name, Method method,
                                                 const StabilityOptions& options);

}  // namespace placode::sim
