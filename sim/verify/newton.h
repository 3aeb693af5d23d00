// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Quasi-static equilibrium in double precision: Newton's method with the exact tangent, a line
// search on the energy and load steps. The reference of every accuracy figure.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/verify/reference_body.h"
#include "sim/verify/sphere_contact.h"

namespace placode::sim {

/// What is to be in equilibrium. Held coordinates, forces and spheres run from `share` 0 to 1.
struct StaticProblem {
    const ReferenceBody* body = nullptr;
    std::vector<uint8_t> held;  ///< (3 V) 1 = this coordinate is prescribed.
    Coordinates held_at;        ///< (3 V) where, at share 1; read where `held` says so.
    Coordinates force_n;        ///< (3 V) gravity and loads at share 1.
    const SphereContacts* contacts = nullptr;  ///< nullptr = none.
    double contact_n_m = 0;                    ///< k of the contacts [N/m].
    double contact_time_s = 0;                 ///< Where the spheres are at share 1.
};

struct NewtonReport {
    bool converged = false;
    int iterations = 0, load_steps = 0;
    double residual_n = 0;     ///< Largest residual of a free coordinate [N].
    double force_scale_n = 0;  ///< What it is compared with [N].
};

struct NewtonSettings {
    double tolerance = 1e-10;  ///< Largest residual over the largest force [-].
    int max_iterations = 100;  ///< Of one load step.
    int load_steps = 1;        ///< To start with; halved where a step does not converge.
    /// Called before every iteration with the share of the load that is being solved.
    std::function<void(double share, const NewtonReport&)> watch = {};
};

/// Moves x (its start guess) to equilibrium. Without convergence x is the last iterate and
/// `converged` is false. @pre x has (3 V) coordinates, the problem a body and sizes as stated.
[[nodiscard]] NewtonReport solve_static(const StaticProblem& problem, Coordinates& x,
                                        const NewtonSettings& settings = {});

/// The step (3 V) [m] that Newton's method would take from x under the whole load, held coordinates
/// staying where they are; nullopt where the tangent is not positive definite (an unstable state).
/// @pre as solve_static().
[[nodiscard]] std::optional<Coordinates> newton_step(const StaticProblem& problem,
                                                     const Coordinates& x);

}  // namespace placode::sim
