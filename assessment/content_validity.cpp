// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/content_validity.h"

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <stdexcept>

namespace placode::assessment {

ContentValidity content_validity(const std::vector<std::string>& items,
                                 const std::vector<std::vector<int>>& ratings) {
    if (items.empty() || items.size() != ratings.size()) {
        throw std::invalid_argument("cvi: needs one row of ratings for each item");
    }
    ContentValidity result;
    for (size_t i = 0; i < items.size(); ++i) {
        ContentItem item;
        item.item = items[i];
        item.experts = static_cast<int>(ratings[i].size());
        if (item.experts == 0)
            throw std::invalid_argument("cvi: item " + items[i] + " has no rating");
        for (const int rating : ratings[i]) {
            if (rating < 1 || rating > 4) {
                throw std::invalid_argument("cvi: item " + items[i] + ": rating " +
                                            std::to_string(rating) + " is not on the scale 1 to 4");
            }
            item.agree += rating >= 3;
            item.essential += rating == 4;
        }
        const double n = item.experts;
        item.i_cvi = item.agree / n;
        // Chance agreement: every expert tosses a coin (Polit, Beck & Owen 2007).
        item.pc = boost::math::pdf(boost::math::binomial(n, 0.5), item.agree);
        item.modified_kappa = item.pc < 1 ? (item.i_cvi - item.pc) / (1 - item.pc) : 0;
        item.cvr_lawshe = (item.essential - n / 2) / (n / 2);
        result.n_experts = std::max(result.n_experts, item.experts);
        result.s_cvi_ave += item.i_cvi;
        result.s_cvi_ua += item.agree == item.experts;
        result.mean_cvr += item.cvr_lawshe;
        result.items.push_back(item);
    }
    const auto k = static_cast<double>(items.size());
    result.s_cvi_ave /= k;
    result.s_cvi_ua /= k;
    result.mean_cvr /= k;
    return result;
}

CriticalCvr critical_cvr(int experts, double alpha) {
    const boost::math::binomial chance(experts, 0.5);
    for (int count = (experts + 1) / 2; count <= experts; ++count) {
        const double p =
            count == 0 ? 1 : boost::math::cdf(boost::math::complement(chance, count - 1));
        if (p <= alpha) return {count, (count - experts / 2.0) / (experts / 2.0), p};
    }
    return {};
}

}  // namespace placode::assessment
