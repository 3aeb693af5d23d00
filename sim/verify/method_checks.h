// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What xpbd, xpbd_pair and vbd cannot do in a verification scene, before it runs. Private to
// sim/verify.

#include "sim/verify/kernel_units.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {

/// Above it vbd settles beside the equilibrium (a cantilever of nu 0.49 at Courant number 2.3 by
/// 2.4 %) and trembles with over-relaxation.
inline constexpr double kVbdExactPoissonsRatio = 0.46;

/// Adds to the warnings where the result is inexact, with an estimate of the error.
/// @throws VerificationError where it would be none, with what would do, unless the scene allows
/// what is not valid.
void check_method(const SolveSetup& setup, const KernelUnits& units, SolveResult& out);

}  // namespace placode::sim
