// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/newton.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "sim/verify/tangent_solver.h"

namespace placode::sim {
namespace {

// Added to the diagonal, relative to its mean: rigid motion that nothing holds stays where it is.
// Far below the smallest stiffness of a body (about (edge / size)^2), it does not slow convergence.
constexpr double kProximal = 1e-11;
// Stiff contacts leave rounding that no step removes: a residual that has not halved in so many
// iterations, and is this near to the tolerance, is accepted.
constexpr int kStall = 12;
constexpr double kStalled = 1e3;
constexpr TangentEffort kOnce{1e10, 1e-6, 500};  // a single step: some seconds at most

class StaticSolver {
 public:
    StaticSolver(const StaticProblem& problem, Coordinates& x, const NewtonSettings& settings,
                 const TangentEffort& effort = {})
        : problem_(problem), body_(*problem.body), x_(x), settings_(settings), tangent_(effort) {
        const auto n = static_cast<size_t>(x.size());
        assert(x.size() == 3 * body_.vertex_count() && "x has three coordinates a vertex");
        assert(problem.held.size() == n && "held has one flag a coordinate");
        assert(problem.held_at.size() == x.size() && problem.force_n.size() == x.size());
        rounding_ = 1e-14 * body_.largest_term_n();
        free_.assign(n, -1);
        for (size_t i = 0; i < n; ++i) {
            if (problem.held[i] == 0) free_[i] = free_count_++;
        }
    }

    /// One whole step at share 1, held coordinates where they are. false = no descent from here.
    bool single_step(Coordinates& direction) {
        share_ = 1;
        return newton_direction(Coordinates::Zero(x_.size()), false, direction);
    }

    NewtonReport run() {
        const Coordinates start = x_;
        double share = 0, step = 1.0 / std::max(1, settings_.load_steps);
        while (share < 1) {
            const double next = share + step > 1 - 1e-9 ? 1 : share + step;
            const Coordinates before = x_;
            share_ = next;
            if (solve_step(start, next)) {
                share = next;
                ++report_.load_steps;
                step = std::min(2 * step, 1.0 / std::max(1, settings_.load_steps));
                continue;
            }
            if (step < 1.0 / 512) return report_;  // not converged: x stays at the last iterate
            x_ = before;
            step /= 2;
        }
        report_.converged = true;
        return report_;
    }

 private:
    [[nodiscard]] double energy(const Coordinates& x) const {
        double e = body_.energy(x) - share_ * problem_.force_n.dot(x - body_.rest());
        if (problem_.contacts != nullptr) {
            e += contact_energy(*problem_.contacts, x, share_ * problem_.contact_time_s,
                                problem_.contact_n_m);
        }
        return e;
    }

    void gradient(Triplets* stiffness) {
        gradient_ = -share_ * problem_.force_n;
        body_.add_gradient(x_, gradient_);
        if (problem_.contacts == nullptr) return;
        Coordinates touch = Coordinates::Zero(x_.size());
        (void)add_contact(*problem_.contacts, x_, share_ * problem_.contact_time_s,
                          problem_.contact_n_m, touch, stiffness);
        gradient_ += touch;
        touch_n_ = touch.lpNorm<Eigen::Infinity>();
    }

    [[nodiscard]] double residual() const {
        double worst = 0;
        for (size_t i = 0; i < free_.size(); ++i) {
            if (free_[i] >= 0)
                worst = std::max(worst, std::abs(gradient_[static_cast<Eigen::Index>(i)]));
        }
        return worst;
    }

    /// Stiffness of the free coordinates; the held ones, times their step, go to the right side.
    bool newton_direction(const Coordinates& held_step, bool projected, Coordinates& direction) {
        Triplets all;
        all.reserve(static_cast<size_t>(body_.tet_count()) * 144);
        body_.add_stiffness(x_, projected, all);
        gradient(&all);
        Coordinates right = Coordinates::Zero(free_count_);
        for (size_t i = 0; i < free_.size(); ++i) {
            if (free_[i] >= 0) right[free_[i]] = -gradient_[static_cast<Eigen::Index>(i)];
        }
        Triplets kept;
        kept.reserve(all.size() / 2);
        double trace = 0;
        for (const auto& t : all) {
            const int row = free_[static_cast<size_t>(t.row())];
            const int column = free_[static_cast<size_t>(t.col())];
            if (row < 0) continue;
            if (column < 0) {
                right[row] -= t.value() * held_step[t.col()];
            } else if (row >= column) {
                kept.emplace_back(row, column, t.value());
                if (row == column) trace += t.value();
            }
        }
        all.clear();
        all.shrink_to_fit();
        const double shift = kProximal * std::abs(trace) / std::max(1, free_count_);
        for (int i = 0; i < free_count_; ++i) kept.emplace_back(i, i, shift);
        SparseMatrix k(free_count_, free_count_);
        k.setFromTriplets(kept.begin(), kept.end());
        Coordinates step;
        if (!tangent_.solve(k, right, step)) return false;
        direction = held_step;
        for (size_t i = 0; i < free_.size(); ++i) {
            if (free_[i] >= 0) direction[static_cast<Eigen::Index>(i)] = step[free_[i]];
        }
        return direction.allFinite();
    }

    /// Largest force that the residual is compared with: what acts on single coordinates.
    [[nodiscard]] double force_scale() const {
        double largest = std::max(share_ * problem_.force_n.lpNorm<Eigen::Infinity>(), touch_n_);
        for (size_t i = 0; i < free_.size(); ++i) {
            if (free_[i] < 0)
                largest = std::max(largest, std::abs(gradient_[static_cast<Eigen::Index>(i)]));
        }
        return largest;
    }

    bool solve_step(const Coordinates& start, double share) {
        Coordinates held_step = Coordinates::Zero(x_.size());
        for (Eigen::Index i = 0; i < x_.size(); ++i) {
            if (problem_.held[static_cast<size_t>(i)] == 0) continue;
            held_step[i] = start[i] + share * (problem_.held_at[i] - start[i]) - x_[i];
        }
        bool moving = held_step.lpNorm<Eigen::Infinity>() > 0;
        double halved = std::numeric_limits<double>::infinity();
        int since = 0;
        for (int i = 0; i < settings_.max_iterations; ++i) {
            gradient(nullptr);
            report_.residual_n = residual();
            report_.force_scale_n = force_scale();
            if (settings_.watch) settings_.watch(share, report_);
            const double small = std::max(settings_.tolerance * report_.force_scale_n, rounding_);
            if (!moving && report_.residual_n <= small) return true;
            if (report_.residual_n < 0.5 * halved) {
                halved = report_.residual_n;
                since = i;
            } else if (i - since >= kStall && report_.residual_n <= kStalled * small) {
                return true;
            }
            Coordinates direction;
            if (!newton_direction(held_step, false, direction) &&
                !newton_direction(held_step, true, direction))
                return false;
            ++report_.iterations;
            if (moving) {
                // The first step carries the prescribed motion into the body; it is taken whole.
                x_ += direction;
                held_step.setZero();
                moving = false;
                continue;
            }
            double slope = gradient_.dot(direction);
            if (!(slope < 0)) {
                if (!newton_direction(held_step, true, direction)) return false;
                slope = gradient_.dot(direction);
            }
            if (!line_search(direction, slope)) return report_.residual_n <= kStalled * small;
        }
        return false;
    }

    /// Backtracking on the energy; near the end, where energies differ by rounding, on the
    /// residual.
    bool line_search(const Coordinates& direction, double slope) {
        const double before = energy(x_), old_residual = report_.residual_n;
        const double noise = 1e-13 * (std::abs(before) + std::abs(slope)) + 1e-300;
        const Coordinates from = x_;
        for (double a = 1; a > 1e-9; a /= 2) {
            x_ = from + a * direction;
            const double now = energy(x_);
            if (!std::isfinite(now)) continue;
            if (now <= before + 1e-4 * a * slope) return true;
            if (now <= before + noise) {
                gradient(nullptr);
                if (residual() < old_residual) return true;
            }
        }
        x_ = from;
        return false;
    }

    const StaticProblem& problem_;
    const ReferenceBody& body_;
    Coordinates& x_;
    NewtonSettings settings_;
    NewtonReport report_;
    Coordinates gradient_;
    std::vector<int> free_;
    int free_count_ = 0;
    double share_ = 1, rounding_ = 0;
    double touch_n_ = 0;  // largest force of contact on a coordinate
    TangentSolver tangent_;
};

}  // namespace

NewtonReport solve_static(const StaticProblem& problem, Coordinates& x,
                          const NewtonSettings& settings) {
    return StaticSolver(problem, x, settings).run();
}

std::optional<Coordinates> newton_step(const StaticProblem& problem, const Coordinates& x) {
    Coordinates at = x, step;
    if (!StaticSolver(problem, at, {}, kOnce).single_step(step)) return std::nullopt;
    return step;
}

}  // namespace placode::sim
