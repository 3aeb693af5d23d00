// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Linear systems of the tangent stiffness in double precision: factors where they are cheap,
// conjugate gradients where the body is too thick for them. Private to sim/verify.

#include <Eigen/SparseCholesky>

#include "sim/verify/reference_body.h"

namespace placode::sim {

/// What a solution may cost.
struct TangentEffort {
    /// Multiplications of a factorisation within the envelope of the rows, which is more than it
    /// takes: 4e9 of these are about a second.
    double most_envelope = 2e11;
    double tolerance = 1e-9;  ///< Of conjugate gradients, relative to the right side.
    int most_iterations = 5000;
};

class TangentSolver {
 public:
    explicit TangentSolver(const TangentEffort& effort) : effort_(effort) {}
    /// Solves K out = right. @param lower triangle of K, always of the same pattern, in RCM order.
    /// false = K is not positive definite, or nothing came of the iterations (that did not
    /// end: a step that falls short).
    [[nodiscard]] bool solve(const SparseMatrix& lower, const Coordinates& right, Coordinates& out);

 private:
    TangentEffort effort_;
    bool analysed_ = false, is_direct_ = false;
    Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower> direct_;
};

}  // namespace placode::sim
