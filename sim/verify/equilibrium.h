// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a verification scene is in equilibrium with, and how far a state of it is from there.
// Private to sim/verify.

#include <optional>

#include "sim/verify/newton.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {

/// Gravity, loads, supports and spheres of the scene at time t.
[[nodiscard]] StaticProblem static_problem(const SolveSetup& setup, double time_s);

/// Every piece of the body has to be held, or in balance by itself.
/// @throws VerificationError naming the piece, the axis and the force that nothing holds.
void check_support(const SolveSetup& setup, const Coordinates& force_n);

/// Every piece of the body is held along every axis, somewhere.
[[nodiscard]] bool is_held(const SolveSetup& setup);

/// The Newton step of the double-precision reference from x (3 V) [m]: to first order all that is
/// left to equilibrium, whichever method led to x. nullopt where it says nothing: a scene with
/// spheres (their penalty is not the fast methods' contact), an unstable state, pieces that nothing
/// holds, a step longer than the body, more than 60,000 coordinates (seconds of factors).
[[nodiscard]] std::optional<Coordinates> step_to_equilibrium(const SolveSetup& setup,
                                                             const Coordinates& x, double time_s);

}  // namespace placode::sim
