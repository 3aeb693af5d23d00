// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/bimanual.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

double path(std::span<const double> speed, double dt_s) {
    return std::accumulate(speed.begin(), speed.end(), 0.0) * dt_s;
}

double correlation(std::span<const double> a, std::span<const double> b) {
    const double ma = mean_of(a).value_or(0), mb = mean_of(b).value_or(0);
    double aa = 0, bb = 0, ab = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
        ab += (a[i] - ma) * (b[i] - mb);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace

Bimanual bimanual_dexterity(std::span<const double> left, std::span<const double> right,
                            double dt_s, double threshold) {
    assert(left.size() == right.size() && left.size() >= 2);
    Bimanual out;
    out.pearson_r = correlation(left, right);
    out.path_left = path(left, dt_s);
    out.path_right = path(right, dt_s);
    const double longer = std::max(out.path_left, out.path_right);
    if (out.path_right > 0) out.path_ratio = out.path_left / out.path_right;
    if (longer > 0) out.balance = std::min(out.path_left, out.path_right) / longer;
    const double share = 1 / static_cast<double>(left.size());
    for (size_t i = 0; i < left.size(); ++i) {
        const bool l = left[i] > threshold, r = right[i] > threshold;
        (l ? (r ? out.both : out.left_only) : (r ? out.right_only : out.neither)) += share;
    }
    return out;
}

}  // namespace placode::assessment
