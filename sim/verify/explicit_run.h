// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The explicit double-precision dynamics by itself, for comparisons beside solve().

#include <array>
#include <vector>

#include "sim/core/workers.h"
#include "sim/verify/reference_body.h"

namespace placode::sim {

/// Symplectic Euler: v += h (f / m + g), damped, then x += h v. The caller holds what is held by
/// writing x and v between steps.
class ExplicitDynamics {
 public:
    /// The body and the team must outlive it. h_s must stay below 2 / highest_frequency_rad_s().
    ExplicitDynamics(const ReferenceBody& body, const Vec3& gravity_m_s2, double h_s,
                     Workers& workers);
    ExplicitDynamics(const ExplicitDynamics&) = delete;
    ExplicitDynamics& operator=(const ExplicitDynamics&) = delete;

    Coordinates x, v;           ///< (3 V) [m], [m/s]
    Coordinates outer_force_n;  ///< (3 V) loads and contact of the next step, without gravity.

    void step();

 private:
    void load(int part) noexcept;
    void integrate(int part) noexcept;

    const ReferenceBody& body_;
    Vec3 gravity_;
    double h_ = 0;
    int parts_ = 1;
    Workers& workers_;
    std::vector<std::array<Vec3, 4>> corner_;  // of each tet
    Coordinates spring_;
    std::vector<int32_t> start_, tet_corner_;  // corners of vertex i, as 4 tet + corner
};

}  // namespace placode::sim
