// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/learning_curve.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "assessment/statistics.h"

namespace placode::assessment {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;
using Vector3 = std::array<double, 3>;

double determinant(const Matrix3& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3 inverse(const Matrix3& m) {
    const double d = determinant(m);
    Matrix3 inv;
    for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
            const size_t a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, e = (i + 2) % 3;
            inv[i][j] = (m[a][c] * m[b][e] - m[a][e] * m[b][c]) / d;
        }
    }
    return inv;
}

double residual_sum(std::span<const double> y, const Vector3& p) {
    double rss = 0;
    for (size_t i = 0; i < y.size(); ++i) {
        const double r = y[i] - p[0] + p[1] * std::exp(-static_cast<double>(i) / p[2]);
        rss += r * r;
    }
    return rss;
}

/// For a fixed tau the other two parameters are linear: the best starting point is a scan over tau.
Vector3 start(std::span<const double> y) {
    const auto n = static_cast<double>(y.size());
    Vector3 best{0, 0, 1};
    double least = INFINITY, next = 0.3;
    while (next < 20 * n) {
        const double tau = std::exchange(next, next * 1.25);
        double se = 0, see = 0, sy = 0, sey = 0;
        for (size_t i = 0; i < y.size(); ++i) {
            const double e = std::exp(-static_cast<double>(i) / tau);
            se += e;
            see += e * e;
            sy += y[i];
            sey += e * y[i];
        }
        const double d = n * see - se * se;
        if (!(d > 1e-12 * n * see)) continue;
        const Vector3 p{(sy * see - se * sey) / d, -(n * sey - se * sy) / d, tau};
        const double rss = residual_sum(y, p);
        if (rss < least) least = rss, best = p;
    }
    return best;
}

/// J^T J and J^T r at `p`.
struct NormalEquations {
    Matrix3 normal{};
    Vector3 gradient{};
};
NormalEquations normal_equations(std::span<const double> y, const Vector3& p) {
    NormalEquations at;
    for (size_t i = 0; i < y.size(); ++i) {
        const double t = static_cast<double>(i), e = std::exp(-t / p[2]);
        const Vector3 j{1, -e, -p[1] * e * t / (p[2] * p[2])};
        const double r = y[i] - (p[0] - p[1] * e);
        for (size_t a = 0; a < 3; ++a) {
            at.gradient[a] += j[a] * r;
            for (size_t b = 0; b < 3; ++b) at.normal[a][b] += j[a] * j[b];
        }
    }
    return at;
}

/// One step of Levenberg-Marquardt; `change` is its largest part of a parameter.
Vector3 damped_step(const NormalEquations& at, const Vector3& p, double damping, double& change) {
    Matrix3 damped = at.normal;
    for (size_t a = 0; a < 3; ++a) damped[a][a] *= 1 + damping;
    const Matrix3 inv = inverse(damped);
    Vector3 next = p;
    change = 0;
    for (size_t a = 0; a < 3; ++a) {
        double step = 0;
        for (size_t b = 0; b < 3; ++b) step += inv[a][b] * at.gradient[b];
        next[a] += step;
        change = std::max(change, std::abs(step) / (std::abs(p[a]) + 1e-12));
    }
    return next;
}

/// Standard errors from the normal matrix, R^2 and AIC of the fit `p`.
ExponentialFit judged_fit(std::span<const double> y, const Vector3& p, const Matrix3& normal,
                          double rss) {
    const auto n = static_cast<double>(y.size());
    ExponentialFit fit{p[0], p[1], p[2]};
    const Matrix3 covariance = inverse(normal);
    const double variance = rss / (n - 3);
    fit.se_asymptote = std::sqrt(variance * covariance[0][0]);
    fit.se_gain = std::sqrt(variance * covariance[1][1]);
    fit.se_tau = std::sqrt(variance * covariance[2][2]);
    fit.rss = rss;
    const double mean = *mean_of(y);
    double total = 0;
    for (const double value : y) total += (value - mean) * (value - mean);
    fit.r2 = total > 0 ? 1 - rss / total : 0;
    // As R's AIC(nls): three parameters and the residual variance.
    fit.aic = n * (std::log(2 * std::numbers::pi) + std::log(rss / n) + 1) + 2 * 4;
    fit.trial_to_95pct_of_gain = 1 + fit.tau_trials * std::log(20.0);
    return fit;
}

/// Levenberg-Marquardt.
std::optional<ExponentialFit> fit_exponential(std::span<const double> y) {
    if (y.size() < 4) return std::nullopt;
    Vector3 p = start(y);
    double rss = residual_sum(y, p), damping = 1e-3;
    NormalEquations at;
    bool converged = false;
    for (int iteration = 0; iteration < 500 && !converged; ++iteration) {
        at = normal_equations(y, p);
        for (int attempt = 0; attempt < 60; ++attempt) {
            double change = 0;
            const Vector3 next = damped_step(at, p, damping, change);
            const double next_rss = next[2] > 0 ? residual_sum(y, next) : INFINITY;
            if (change < 1e-10) {
                converged = true;
                break;
            }
            if (next_rss <= rss) {
                p = next;
                rss = next_rss;
                damping = std::max(damping / 10, 1e-12);
                break;
            }
            damping *= 10;
        }
    }
    ExponentialFit fit = judged_fit(y, p, at.normal, rss);
    fit.converged = converged;
    if (!std::isfinite(fit.asymptote) || !std::isfinite(fit.se_tau)) return std::nullopt;
    return fit;
}

struct Line {
    double intercept = 0, slope = 0, r2 = 0, slope_se = 0;
};
Line least_squares(std::span<const double> x, std::span<const double> y) {
    const auto n = static_cast<double>(x.size());
    const double mx = *mean_of(x), my = *mean_of(y);
    double sxx = 0, sxy = 0, syy = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        sxx += (x[i] - mx) * (x[i] - mx);
        sxy += (x[i] - mx) * (y[i] - my);
        syy += (y[i] - my) * (y[i] - my);
    }
    Line line;
    line.slope = sxy / sxx;
    line.intercept = my - line.slope * mx;
    line.r2 = syy > 0 ? sxy * sxy / (sxx * syy) : 0;
    line.slope_se = n > 2 ? std::sqrt(std::max(0.0, syy - line.slope * sxy) / (n - 2) / sxx) : 0;
    return line;
}

std::optional<PowerFit> fit_power(std::span<const double> y) {
    std::vector<double> log_trial, log_score;
    for (size_t i = 0; i < y.size(); ++i) {
        if (y[i] <= 0) continue;
        log_trial.push_back(std::log(static_cast<double>(i + 1)));
        log_score.push_back(std::log(y[i]));
    }
    if (log_score.size() < 3) return std::nullopt;
    const Line line = least_squares(log_trial, log_score);
    return PowerFit{line.intercept, line.slope, line.r2, static_cast<int>(log_score.size())};
}

}  // namespace

LearningCurve learning_curve(std::span<const double> scores) {
    if (scores.empty()) throw std::invalid_argument("learning curve: there is no score");
    LearningCurve result;
    result.n = static_cast<int>(scores.size());
    const auto [least, most] = std::minmax_element(scores.begin(), scores.end());
    result.constant = *least == *most;
    if (!result.constant) result.exponential = fit_exponential(scores);
    result.power = fit_power(scores);
    const size_t ten = std::min<size_t>(10, scores.size());
    const auto first = scores.first(ten), last = scores.last(ten);
    result.mean_first10 = *mean_of(first);
    result.mean_last10 = *mean_of(last);
    if (ten >= 3) {
        std::vector<double> trial(ten);
        std::iota(trial.begin(), trial.end(), 1.0);
        const Line line = least_squares(trial, last);
        const double t =
            boost::math::quantile(boost::math::students_t(static_cast<double>(ten) - 2), 0.975);
        const Interval slope{line.slope - t * line.slope_se, line.slope + t * line.slope_se};
        result.last10_slope_ci95 = slope;
        result.plateau = result.exponential &&
                         result.exponential->trial_to_95pct_of_gain <= result.n && slope.low <= 0 &&
                         slope.high >= 0;
    }
    return result;
}

}  // namespace placode::assessment
