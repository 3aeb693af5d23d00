// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/tangent_solver.h"

#include <gtest/gtest.h>

using namespace placode::sim;

namespace THIS_TEST {

constexpr int kSize = 40;

/// Lower triangle of a chain of springs between walls, the last one of stiffness `last`.
SparseMatrix chain(double last) {
    Triplets entries;
    for (int i = 0; i < kSize; ++i) {
        entries.emplace_back(i, i, i + 1 < kSize ? 2.0 : 1 + last);
        if (i > 0) entries.emplace_back(i, i - 1, -1.0);
    }
    SparseMatrix out(kSize, kSize);
    out.setFromTriplets(entries.begin(), entries.end());
    return out;
}

TEST(TangentSolver, FactorsAndIterationsMeetTheClosedForm) {
    // Unit forces on a chain between walls: u_i = i (n + 1 - i) / 2.
    for (const double envelope : {1e9, 0.0}) {
        TangentSolver solver({envelope, 1e-12, 1000});
        Coordinates u;
        ASSERT_TRUE(solver.solve(chain(1), Coordinates::Ones(kSize), u));
        for (int i = 0; i < kSize; ++i)
            EXPECT_NEAR(u[i], 0.5 * (i + 1) * (kSize - i), 1e-8) << envelope;
    }
}

TEST(TangentSolver, FactorsSayWhenTheTangentIsNotPositiveDefinite) {
    TangentSolver solver({1e9, 1e-12, 1000});
    Coordinates u;
    EXPECT_FALSE(solver.solve(chain(-1), Coordinates::Ones(kSize), u));
    EXPECT_TRUE(solver.solve(chain(1), Coordinates::Ones(kSize), u));
}

TEST(TangentSolver, ATangentThatHasChangedLittleIsSolvedWithTheOldFactors) {
    TangentSolver solver({1e9, 1e-12, 1000});
    Coordinates u, v;
    const Coordinates right = Coordinates::LinSpaced(kSize, -1, 2);
    ASSERT_TRUE(solver.solve(chain(1), right, u));
    EXPECT_EQ(solver.factorisations(), 1);
    // One spring has changed: two iterations.
    ASSERT_TRUE(solver.solve(chain(1.5), right, u));
    EXPECT_EQ(solver.factorisations(), 1);
    ASSERT_TRUE(TangentSolver({1e9, 1e-12, 1000}).solve(chain(1.5), right, v));
    EXPECT_LT((u - v).norm(), 1e-10 * v.norm());
    // What is no longer positive definite is found out with old factors as well.
    EXPECT_FALSE(solver.solve(chain(-1), right, u));
}

}  // namespace THIS_TEST
