// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/tangent_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>

namespace placode::sim {
namespace {

// Above this many unknowns factors grow past the memory of a small machine.
constexpr Eigen::Index kMostDirect = 150000;

// Conjugate gradients that need more have the wrong factors.
constexpr double kMostWithOldFactors = 60;

/// Sum of the squares of the rows' lengths from their first entry to the diagonal.
double envelope(const SparseMatrix& lower) {
    std::vector<Eigen::Index> first(static_cast<size_t>(lower.rows()));
    for (size_t row = 0; row < first.size(); ++row) first[row] = static_cast<Eigen::Index>(row);
    for (Eigen::Index column = 0; column < lower.outerSize(); ++column) {
        for (SparseMatrix::InnerIterator i(lower, column); i; ++i) {
            Eigen::Index& begin = first[static_cast<size_t>(i.row())];
            begin = std::min(begin, column);
        }
    }
    double sum = 0;
    for (size_t row = 0; row < first.size(); ++row) {
        const double length = static_cast<double>(static_cast<Eigen::Index>(row) - first[row]);
        sum += length * length;
    }
    return sum;
}

}  // namespace

bool TangentSolver::factor(const SparseMatrix& lower) {
    direct_.factorize(lower);
    ++factorisations_;
    has_factors_ = direct_.info() == Eigen::Success;
    if (!has_factors_) return false;
    const auto& factors = direct_.matrixL().nestedExpression();
    double work = 0, entries = 0;
    for (Eigen::Index column = 0; column < factors.outerSize(); ++column) {
        const auto length = static_cast<double>(factors.outerIndexPtr()[column + 1] -
                                                factors.outerIndexPtr()[column]);
        work += length * length;
        entries += length;
    }
    // Two triangles, a multiplication for each entry; memory makes each some four times as dear.
    most_with_old_factors_ =
        static_cast<int>(std::clamp(0.5 * work / (8 * entries), 4.0, kMostWithOldFactors));
    return true;
}

/// Conjugate gradients preconditioned with the factors at hand. false = they have not converged in
/// the time of a factorisation, or have met a direction in which the tangent is not positive.
bool TangentSolver::solve_with_old_factors(const SparseMatrix& lower, const Coordinates& right,
                                           Coordinates& out) {
    const double enough = effort_.tolerance * right.norm();
    Coordinates residual = right, z = direct_.solve(right), direction = z;
    out = Coordinates::Zero(right.size());
    double along = residual.dot(z);
    for (int i = 0; i < most_with_old_factors_; ++i) {
        if (residual.norm() <= enough) return true;
        const Coordinates pushed = lower.selfadjointView<Eigen::Lower>() * direction;
        const double curvature = direction.dot(pushed);
        if (!(curvature > 0)) return false;
        const double step = along / curvature;
        out += step * direction;
        residual -= step * pushed;
        z = direct_.solve(residual);
        const double next = residual.dot(z);
        direction = z + next / along * direction;
        along = next;
    }
    return residual.norm() <= enough;
}

bool TangentSolver::solve(const SparseMatrix& lower, const Coordinates& right, Coordinates& out) {
    if (lower.rows() == 0) {
        out.resize(0);
        return true;
    }
    if (!analysed_) {
        analysed_ = true;
        is_direct_ = lower.rows() <= kMostDirect && envelope(lower) <= effort_.most_envelope;
        if (is_direct_) direct_.analyzePattern(lower);
    }
    if (is_direct_) {
        if (has_factors_ && solve_with_old_factors(lower, right, out)) return true;
        if (!factor(lower)) return false;
        out = direct_.solve(right);
        return true;
    }
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower,
                             Eigen::IncompleteCholesky<double, Eigen::Lower>>
        iterative;
    iterative.setTolerance(effort_.tolerance);
    iterative.setMaxIterations(effort_.most_iterations);
    iterative.compute(lower);
    if (iterative.info() != Eigen::Success) return false;
    out = iterative.solve(right);
    return out.allFinite();
}

}  // namespace placode::sim
