// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/reliability.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace placode::assessment {
namespace {

using Matrix = std::vector<std::vector<double>>;

Matrix covariance(const Scores& scores) {
    const size_t n = scores.size(), k = scores[0].size();
    std::vector<double> mean(k, 0.0);
    for (const auto& row : scores) {
        for (size_t j = 0; j < k; ++j) mean[j] += row[j] / static_cast<double>(n);
    }
    Matrix c(k, std::vector<double>(k, 0.0));
    for (const auto& row : scores) {
        for (size_t i = 0; i < k; ++i) {
            for (size_t j = 0; j < k; ++j)
                c[i][j] += (row[i] - mean[i]) * (row[j] - mean[j]) / static_cast<double>(n - 1);
        }
    }
    return c;
}

Matrix correlations(const Matrix& c) {
    Matrix r = c;
    for (size_t i = 0; i < c.size(); ++i) {
        for (size_t j = 0; j < c.size(); ++j) r[i][j] = c[i][j] / std::sqrt(c[i][i] * c[j][j]);
    }
    return r;
}

/// Inverse of a correlation matrix by Gauss-Jordan with pivoting; none when singular. A pivot of
/// 1e-10 beside ones is what rounding leaves of zero in sums of some ten terms.
std::optional<Matrix> inverse(Matrix a) {
    const size_t k = a.size();
    Matrix inv(k, std::vector<double>(k, 0.0));
    for (size_t i = 0; i < k; ++i) inv[i][i] = 1;
    for (size_t column = 0; column < k; ++column) {
        size_t pivot = column;
        for (size_t row = column; row < k; ++row) {
            if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
        }
        if (std::abs(a[pivot][column]) < 1e-10) return std::nullopt;
        std::swap(a[pivot], a[column]);
        std::swap(inv[pivot], inv[column]);
        const double scale = 1 / a[column][column];
        for (size_t j = 0; j < k; ++j) {
            a[column][j] *= scale;
            inv[column][j] *= scale;
        }
        for (size_t row = 0; row < k; ++row) {
            if (row == column) continue;
            const double factor = a[row][column];
            for (size_t j = 0; j < k; ++j) {
                a[row][j] -= factor * a[column][j];
                inv[row][j] -= factor * inv[column][j];
            }
        }
    }
    return inv;
}

struct Sums {
    double total = 0, trace = 0;
};
Sums sums(const Matrix& m) {
    Sums s;
    for (size_t i = 0; i < m.size(); ++i) {
        s.trace += m[i][i];
        s.total += std::accumulate(m[i].begin(), m[i].end(), 0.0);
    }
    return s;
}

double alpha_of(const Matrix& c) {
    const auto k = static_cast<double>(c.size());
    const Sums s = sums(c);
    return k / (k - 1) * (1 - s.trace / s.total);
}

Matrix without(const Matrix& c, size_t item) {
    Matrix smaller;
    for (size_t i = 0; i < c.size(); ++i) {
        if (i == item) continue;
        std::vector<double> row = c[i];
        row.erase(row.begin() + static_cast<long>(item));
        smaller.push_back(row);
    }
    return smaller;
}

void check(const Scores& scores, size_t least_items, const char* what) {
    if (scores.size() < 3 || scores[0].size() < least_items) {
        throw std::invalid_argument(std::string(what) + ": needs at least 3 complete cases and " +
                                    std::to_string(least_items) + " items, found " +
                                    std::to_string(scores.size()) + " cases");
    }
    for (size_t j = 0; j < scores[0].size(); ++j) {
        const bool constant = std::all_of(scores.begin(), scores.end(),
                                          [&](const auto& row) { return row[j] == scores[0][j]; });
        if (constant)
            throw std::invalid_argument(std::string(what) + ": item " + std::to_string(j + 1) +
                                        " is constant");
    }
}

double standard_error(const Matrix& c, double n) {
    const auto k = static_cast<double>(c.size());
    const Sums s = sums(c);
    double trace_square = 0, sum_square = 0;  // of C C
    for (size_t i = 0; i < c.size(); ++i) {
        for (size_t j = 0; j < c.size(); ++j) {
            double entry = 0;
            for (size_t l = 0; l < c.size(); ++l) entry += c[i][l] * c[l][j];
            sum_square += entry;
            if (i == j) trace_square += entry;
        }
    }
    const double q = 2 * k * k / ((k - 1) * (k - 1) * s.total * s.total * s.total) *
                     (s.total * (trace_square + s.trace * s.trace) - 2 * s.trace * sum_square);
    return std::sqrt(q / n);
}

/// EM for one factor: Sigma = l l' + diag(theta). Slow but monotone; k is small.
bool fit_maximum_likelihood(const Matrix& s, std::vector<double>& l, std::vector<double>& theta) {
    const size_t k = s.size();
    l.assign(k, 0);
    theta.assign(k, 0);
    for (size_t i = 0; i < k; ++i) {
        l[i] = std::sqrt(0.5 * s[i][i]);
        theta[i] = 0.5 * s[i][i];
    }
    for (int iteration = 0; iteration < 200000; ++iteration) {
        double precision = 1;
        for (size_t i = 0; i < k; ++i) precision += l[i] * l[i] / theta[i];
        std::vector<double> beta(k), sb(k, 0.0);  // E[f | x] = beta' x
        for (size_t i = 0; i < k; ++i) beta[i] = l[i] / theta[i] / precision;
        double factor_variance = 1 / precision;
        for (size_t i = 0; i < k; ++i) {
            for (size_t j = 0; j < k; ++j) sb[i] += s[i][j] * beta[j];
            factor_variance += beta[i] * sb[i];
        }
        double change = 0;
        for (size_t i = 0; i < k; ++i) {
            const double next = sb[i] / factor_variance;
            change = std::max(change, std::abs(next - l[i]) / std::sqrt(s[i][i]));
            l[i] = next;
            theta[i] =
                std::max(s[i][i] - next * sb[i], 1e-6 * s[i][i]);  // Heywood case: kept positive
        }
        if (change < 1e-12) return true;
    }
    return false;
}

/// Principal factors with communalities iterated to the least-squares solution.
std::vector<double> fit_minres(const Matrix& r) {
    const size_t k = r.size();
    std::vector<double> l(k, 0.7);
    for (int iteration = 0; iteration < 100000; ++iteration) {
        double change = 0;
        for (size_t i = 0; i < k; ++i) {  // exact coordinate minimum of the off-diagonal residuals
            double above = 0, below = 0;
            for (size_t j = 0; j < k; ++j) {
                if (j == i) continue;
                above += r[i][j] * l[j];
                below += l[j] * l[j];
            }
            const double next = below > 0 ? std::clamp(above / below, -0.9975, 0.9975) : 0;
            change = std::max(change, std::abs(next - l[i]));
            l[i] = next;
        }
        if (change < 1e-13) break;
    }
    return l;
}

}  // namespace

Alpha cronbach_alpha(const Scores& scores) {
    check(scores, 2, "alpha");
    const Matrix c = covariance(scores), r = correlations(c);
    Alpha result;
    result.n = static_cast<int>(scores.size());
    result.k = static_cast<int>(c.size());
    const double n = result.n, k = result.k;
    result.raw = alpha_of(c);
    result.standardized = alpha_of(r);
    const Sums rs = sums(r);
    result.mean_interitem_r = (rs.total - rs.trace) / (k * (k - 1));
    if (const auto inv = inverse(r)) {
        double unique = 0;
        for (size_t i = 0; i < r.size(); ++i)
            unique += 1 / (*inv)[i][i];  // 1 - squared multiple correlation
        result.g6 = 1 - unique / rs.total;
    }
    result.ase = standard_error(c, n);
    const boost::math::fisher_f f(n - 1, (n - 1) * (k - 1));
    result.feldt_ci95 = {1 - (1 - result.raw) * boost::math::quantile(f, 0.975),
                         1 - (1 - result.raw) * boost::math::quantile(f, 0.025)};
    result.duhachek_ci95 = {result.raw - 1.96 * result.ase, result.raw + 1.96 * result.ase};
    for (size_t i = 0; i < c.size(); ++i) {
        if (k > 2) result.alpha_if_dropped.push_back(alpha_of(without(c, i)));
        double with_rest = 0;
        const Sums all = sums(c);
        const double row = std::accumulate(c[i].begin(), c[i].end(), 0.0);
        with_rest = row - c[i][i];
        const double rest_variance = all.total - 2 * row + c[i][i];
        result.corrected_item_total_r.push_back(with_rest / std::sqrt(c[i][i] * rest_variance));
    }
    return result;
}

Omega mcdonald_omega(const Scores& scores) {
    check(scores, 3, "omega");
    if (scores.size() <= scores[0].size())
        throw std::invalid_argument("omega: needs more complete cases than items, found " +
                                    std::to_string(scores.size()) + " cases of " +
                                    std::to_string(scores[0].size()) + " items");
    const Matrix c = covariance(scores);
    Omega result;
    result.converged = fit_maximum_likelihood(c, result.loadings, result.theta);
    const auto omega = [](const std::vector<double>& l, const std::vector<double>& theta) {
        const double common = std::pow(std::accumulate(l.begin(), l.end(), 0.0), 2);
        return common / (common + std::accumulate(theta.begin(), theta.end(), 0.0));
    };
    result.total_ml = omega(result.loadings, result.theta);
    const std::vector<double> l = fit_minres(correlations(c));
    std::vector<double> unique;
    for (const double loading : l) unique.push_back(1 - loading * loading);
    result.total_minres = omega(l, unique);
    return result;
}

}  // namespace placode::assessment
