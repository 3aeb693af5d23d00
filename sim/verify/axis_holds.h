// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Vertices that only some axes hold: rollers, planes of symmetry, ends that are pulled along one
// axis. The kernels know free and fixed vertices only, so that these are solved one by one. No
// contact: what a sphere touches as well is solved with it (pressed_vertices.h). Private to
// sim/verify.

#include <vector>

#include "sim/solver/soft_body.h"
#include "sim/verify/kernel_units.h"
#include "sim/verify/pressed_vertices.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {

/// Positions in the kernels' units, times in the scene's.
class AxisHolds {
 public:
    AxisHolds(const SolveSetup& setup, const KernelUnits& units, const SoftBody& body,
              SoftBodyState& state, double h_body)
        : setup_(setup), units_(units), body_(body), state_(state), h_body_(h_body) {}

    /// Start of a substep that ends at `time_s`.
    void set_time(double time_s) { time_ = time_s; }
    /// After the spheres have found what they touch: the sweeps leave these vertices out.
    void begin(const PressedVertices& pressed);
    /// After a sweep: one pass over those that no sphere touches.
    void solve(const PressedVertices& pressed);
    /// Where a vertex that every axis holds is at the substep's end.
    [[nodiscard]] Vec3 held_place(int32_t v) const {
        return {held_at(v, 0), held_at(v, 1), held_at(v, 2)};
    }

 private:
    [[nodiscard]] double held_at(int32_t v, int axis) const;
    /// Axes that are held go where their region is.
    void put_on_axes(int32_t v);

    const SolveSetup& setup_;
    const KernelUnits& units_;
    const SoftBody& body_;
    SoftBodyState& state_;
    const double h_body_;
    double time_ = 0;
};

}  // namespace placode::sim
