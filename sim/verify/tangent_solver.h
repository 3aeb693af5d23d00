// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Linear systems of the tangent stiffness in double precision: factors where they are cheap,
// conjugate gradients where the body is too thick for them. From one Newton step to the next the
// tangent changes little, or in a few touched vertices: conjugate gradients with the factors of an
// earlier tangent then need some ten iterations, where factors anew cost a hundred times one.
// Private to sim/verify.

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

    /// How many times a tangent was factored so far.
    [[nodiscard]] int factorisations() const { return factorisations_; }

 private:
    [[nodiscard]] bool factor(const SparseMatrix& lower);
    [[nodiscard]] bool solve_with_old_factors(const SparseMatrix& lower, const Coordinates& right,
                                              Coordinates& out);

    TangentEffort effort_;
    bool analysed_ = false, is_direct_ = false, has_factors_ = false;
    int factorisations_ = 0;
    int most_with_old_factors_ = 0;  // iterations that cost half of a factorisation
    Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower> direct_;
};

}  // namespace placode::sim
