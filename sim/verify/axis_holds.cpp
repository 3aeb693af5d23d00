// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/axis_holds.h"

#include "sim/core/as_index.h"
#include "sim/solver/double_float.h"
#include "sim/solver/vertex_step.h"

namespace placode::sim {

double AxisHolds::held_at(int32_t v, int axis) const {
    // The way as a float, which is the same in all units.
    const auto moved = static_cast<float>(units_.length * setup_.held_displacement(v, axis, time_));
    return body_.mesh().rest[as_index(v)][axis] + static_cast<double>(moved);
}

void AxisHolds::put_on_axes(int32_t v) {
    Vec3 place = exact_position(state_, v);
    for (int a = 0; a < 3; ++a) {
        if ((setup_.held[as_index(v)] >> a & 1) != 0) place[a] = held_at(v, a);
    }
    put_vertex(state_, v, place);
}

void AxisHolds::begin(const PressedVertices& pressed) {
    for (const int32_t v : setup_.partly_held()) {
        state_.contact_vertex[as_index(v)] = 1;
        // The contact moves it along its free axes only.
        if (pressed.touches(v)) put_on_axes(v);
    }
}

void AxisHolds::solve(const PressedVertices& pressed) {
    const SolverSettings& solver = body_.spec().solver;
    // Vertices among others: as they, over-relaxed and once a sweep.
    const double relaxation = solver.method == Method::kVbd ? solver.over_relaxation : 1;
    for (const int32_t v : setup_.partly_held()) {
        if (state_.x[as_index(v)].w == 0 || pressed.touches(v)) continue;
        put_on_axes(v);
        VertexSystem system = vertex_system(body_, state_, v, h_body_);
        hold_axes(system, setup_.held[as_index(v)]);
        const VertexStep taken =
            vertex_step(system, relaxation, body_.shortest_edge_m()[as_index(v)]);
        if (taken.finite) move_vertex(state_, v, taken.step);
    }
}

}  // namespace placode::sim
