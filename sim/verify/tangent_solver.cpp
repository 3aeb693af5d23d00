// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/tangent_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <algorithm>

namespace placode::sim {
namespace {

// Above this many unknowns factors grow past the memory of a small machine.
constexpr Eigen::Index kMostDirect = 150000;

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
        direct_.factorize(lower);
        if (direct_.info() != Eigen::Success) return false;
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
