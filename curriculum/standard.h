// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The standard of a task: the pass mark that an educator has set from two groups of people, with
// what it costs, or from the estimates of judges. A version is never changed; a new mark is the
// next version, with a reason.

#include <string>

namespace placode::curriculum {

/// One of the two groups; a person counts once. Points of 100.
struct StandardGroup {
    int n = 0;
    double mean_points = 0, sd_points = 0;
    double theoretical_wrong = 0;  ///< Share that the curves put on the wrong side of the mark.
    double observed_wrong = 0;     ///< Share that was there.
};

/// Judges who estimated how a trainee who is just good enough fares at each line of the rubric.
struct StandardJudges {
    int judges = 0, items = 0;
    double se_points = 0;  ///< Standard error of the mark.
};

struct PassStandard {
    std::string task_id;
    int version = 1;
    double pass_points = 70;
    int mean_of_last_attempts = 3;  ///< What a person's value is.
    StandardGroup novice, expert;   ///< Of contrasting groups.
    StandardJudges angoff;          ///< Of method "angoff".
    /// "contrasting-groups" (Jorgensen, Konge and Subhi 2018, doi:10.1186/s41077-018-0064-7) or
    /// "angoff" (Angoff 1971).
    std::string method = "contrasting-groups";
};

/// The text that a store keeps, and back. Throws DefinitionError.
[[nodiscard]] std::string standard_json(const PassStandard& standard);
[[nodiscard]] PassStandard load_standard_text(const std::string& json, const std::string& origin);

}  // namespace placode::curriculum
