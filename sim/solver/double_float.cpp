// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/double_float.h"

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

/// Out of line: where two neighbours go to floats and back, g++ 12.2 leaves both steps out (from
/// -O2 on).
[[gnu::noinline]] double nearest_float(double x) noexcept {
    return static_cast<double>(static_cast<float>(x));
}

}  // namespace

void use_double_float(SoftBodyState& state) {
    state.x_low.resize(state.x.size());
    state.x_start_low.resize(state.x.size());
}

Vec3 moved_in_substep(const SoftBodyState& state, int vertex) noexcept {
    const auto i = as_index(vertex);
    const Vec3 rounded = to_vec(state.x[i]) - to_vec(state.x_start[i]);
    if (state.x_low.empty()) return rounded;
    return rounded + (to_vec(state.x_low[i]) - to_vec(state.x_start_low[i]));
}

void move_vertex(SoftBodyState& state, int vertex, const Vec3& step) noexcept {
    Float4& x = state.x[as_index(vertex)];
    const Vec3f s = step.cast<float>();
    if (state.x_low.empty()) {
        x = {x.x + s.x(), x.y + s.y(), x.z + s.z(), x.w};
        return;
    }
    Float4& low = state.x_low[as_index(vertex)];
    carry(x.x, low.x, s.x());
    carry(x.y, low.y, s.y());
    carry(x.z, low.z, s.z());
}

void put_vertex(SoftBodyState& state, int vertex, const Vec3& place) noexcept {
    const Vec3 high(nearest_float(place.x()), nearest_float(place.y()), nearest_float(place.z()));
    const Vec3f x = high.cast<float>(), low = (place - high).cast<float>();
    state.x[as_index(vertex)] = {x.x(), x.y(), x.z(), state.x[as_index(vertex)].w};
    if (!state.x_low.empty()) state.x_low[as_index(vertex)] = {low.x(), low.y(), low.z(), 0};
}

}  // namespace placode::sim
