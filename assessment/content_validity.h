// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Content validity by expert ratings: I-CVI, S-CVI, modified kappa, Lawshe's CVR.

#include <string>
#include <vector>

namespace placode::assessment {

struct ContentItem {
    std::string item;
    int experts = 0, agree = 0, essential = 0;  ///< Ratings >= 3 of 4; ratings = 4.
    double i_cvi = 0, pc = 0, modified_kappa = 0, cvr_lawshe = 0;
};
struct ContentValidity {
    int n_experts = 0;
    std::vector<ContentItem> items;
    double s_cvi_ave = 0, s_cvi_ua = 0, mean_cvr = 0;
};
/// `ratings[item][expert]`, 1 to 4. Missing ratings are left out by the caller, item by item.
[[nodiscard]] ContentValidity content_validity(const std::vector<std::string>& items,
                                               const std::vector<std::vector<int>>& ratings);

struct CriticalCvr {
    int n_critical = 0;  ///< Least number of "essential" that is significant.
    double cvr_critical = 0, one_tailed_p = 1;
};
/// Exact one-tailed binomial at alpha. n_critical = 0 when no count is significant.
[[nodiscard]] CriticalCvr critical_cvr(int experts, double alpha = 0.05);

}  // namespace placode::assessment
