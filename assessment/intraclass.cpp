// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of raters: the six intraclass correlations of Shrout & Fleiss 1979, as psych::ICC.

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "assessment/reliability.h"

namespace placode::assessment {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double f_quantile(double p, double df1, double df2) {
    return boost::math::quantile(boost::math::fisher_f(df1, df2), p);
}

IccForm form(double icc, double f, double df1, double df2) {
    IccForm result{icc, f, df1, df2, 1, {}};
    result.p = std::isfinite(f)
                   ? boost::math::cdf(boost::math::complement(boost::math::fisher_f(df1, df2), f))
                   : 0;
    return result;
}

/// Interval of ICC(2,1) by Satterthwaite's degrees of freedom.
Interval two_way_interval(double icc, double ms_rows, double ms_columns, double ms_error, double n,
                          double k) {
    // Without an error the degrees of freedom are none; without a difference between raters, too,
    // every interval shrinks to 1.
    if (!(ms_error > 0)) return ms_columns > 0 ? Interval{kNone, kNone} : Interval{1, 1};
    const double fj = ms_columns / ms_error;
    const double numerator = std::pow(k * icc * fj + n * (1 + (k - 1) * icc) - k * icc, 2);
    const double v =
        (k - 1) * (n - 1) * numerator /
        ((n - 1) * k * k * icc * icc * fj * fj + std::pow(n * (1 + (k - 1) * icc) - k * icc, 2));
    const double upper = f_quantile(0.975, n - 1, v), lower = f_quantile(0.975, v, n - 1);
    const double rest = k * ms_columns + (k * n - k - n) * ms_error;
    return {n * (ms_rows - upper * ms_error) / (upper * rest + n * ms_rows),
            n * (lower * ms_rows - ms_error) / (rest + n * lower * ms_rows)};
}

Interval averaged(const Interval& single, double k) {
    return {single.low * k / (1 + single.low * (k - 1)),
            single.high * k / (1 + single.high * (k - 1))};
}

}  // namespace

Icc intraclass_correlation(const Scores& ratings) {
    if (ratings.size() < 2 || ratings[0].size() < 2) {
        throw std::invalid_argument("icc: needs at least 2 subjects and 2 raters");
    }
    Icc result;
    result.subjects = static_cast<int>(ratings.size());
    result.raters = static_cast<int>(ratings[0].size());
    const double n = result.subjects, k = result.raters;
    double grand = 0;
    std::vector<double> row(ratings.size(), 0.0), column(ratings[0].size(), 0.0);
    for (size_t i = 0; i < ratings.size(); ++i) {
        for (size_t j = 0; j < column.size(); ++j) {
            row[i] += ratings[i][j] / k;
            column[j] += ratings[i][j] / n;
            grand += ratings[i][j] / (n * k);
        }
    }
    double ss_rows = 0, ss_columns = 0, ss_total = 0;
    for (const double r : row) ss_rows += k * (r - grand) * (r - grand);
    for (const double c : column) ss_columns += n * (c - grand) * (c - grand);
    for (const auto& subject : ratings) {
        for (const double x : subject) ss_total += (x - grand) * (x - grand);
    }
    // What rounding leaves of zero beside the squares themselves is no variance.
    const double nothing = 1e-12 * (ss_total + grand * grand);
    if (!(ss_total > nothing)) throw std::invalid_argument("icc: ratings do not vary");
    const auto variance = [&](double sum, double df) { return sum > nothing ? sum / df : 0; };
    const double msb = variance(ss_rows, n - 1), msj = variance(ss_columns, k - 1);
    const double mse = variance(ss_total - ss_rows - ss_columns, (n - 1) * (k - 1));
    const double msw = variance(ss_total - ss_rows, n * (k - 1));
    result.ms_rows = msb;
    result.ms_columns = msj;
    result.ms_error = mse;
    const double f1 = msb / msw, f3 = msb / mse, df1 = n - 1, within = n * (k - 1),
                 error = (n - 1) * (k - 1);

    result.icc1 = form((msb - msw) / (msb + (k - 1) * msw), f1, df1, within);
    result.icc2 = form((msb - mse) / (msb + (k - 1) * mse + k * (msj - mse) / n), f3, df1, error);
    result.icc3 = form((msb - mse) / (msb + (k - 1) * mse), f3, df1, error);
    result.icc1k = form((msb - msw) / msb, f1, df1, within);
    result.icc2k = form((msb - mse) / (msb + (msj - mse) / n), f3, df1, error);
    result.icc3k = form((msb - mse) / msb, f3, df1, error);

    const double f1_low = f1 / f_quantile(0.975, df1, within),
                 f1_high = f1 * f_quantile(0.975, within, df1);
    const auto single = [&](double f) { return std::isinf(f) ? 1 : (f - 1) / (f + k - 1); };
    result.icc1.ci95 = {single(f1_low), single(f1_high)};
    result.icc1k.ci95 = {1 - 1 / f1_low, 1 - 1 / f1_high};
    const double f3_low = f3 / f_quantile(0.975, df1, error),
                 f3_high = f3 * f_quantile(0.975, error, df1);
    result.icc3.ci95 = {single(f3_low), single(f3_high)};
    result.icc3k.ci95 = {1 - 1 / f3_low, 1 - 1 / f3_high};
    result.icc2.ci95 = two_way_interval(result.icc2.icc, msb, msj, mse, n, k);
    result.icc2k.ci95 = averaged(result.icc2.ci95, k);
    result.sem_agreement = std::sqrt((msj - mse) / n + mse);
    result.sem_consistency = std::sqrt(mse);
    return result;
}

}  // namespace placode::assessment
