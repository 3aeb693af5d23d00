// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/tethers.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/double_float.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

Vec3 between(const SoftBodyState& state, const Tether& t) noexcept {
    const Float4& a = state.x[as_index(t.vertex[0])];
    const Float4& b = state.x[as_index(t.vertex[1])];
    return Vec3(b.x, b.y, b.z) - Vec3(a.x, a.y, a.z);
}

}  // namespace

uint32_t solve_singles_vbd(const SoftBody& body, SoftBodyState& state, double h) noexcept {
    uint32_t flags = 0;
    for (const int32_t i : body.packed().single_vertices) {
        if (state.x[as_index(i)].w == 0) continue;
        const VertexSystem s = vertex_system(body, state, i, h);
        Vec3 step = -body.spec().solver.over_relaxation * s.hessian.ldlt().solve(s.gradient);
        if (!step.allFinite()) continue;
        const double limit = static_cast<double>(body.shortest_edge_m()[as_index(i)]) / 4;
        if (step.norm() > limit) {
            step *= limit / step.norm();
            flags |= kStepLimited;
        }
        move_vertex(state, i, step);
    }
    for (size_t i = 0; i < state.tether_alive.size(); ++i) {
        if (state.tether_alive[i] == 0) continue;
        const Tether& t = body.spec().tethers[i];
        const double excess = std::max(0.0, between(state, t).norm() - t.rest_m);
        state.tether_lambda_n[i] = static_cast<float>(excess / t.compliance_m_n);
    }
    return flags;
}

void solve_tethers_xpbd(const SoftBody& body, SoftBodyState& state, double h) noexcept {
    for (size_t i = 0; i < state.tether_alive.size(); ++i) {
        if (state.tether_alive[i] == 0) continue;
        const Tether& t = body.spec().tethers[i];
        const Float4& a = state.x[as_index(t.vertex[0])];
        const Float4& b = state.x[as_index(t.vertex[1])];
        const Vec3 d = between(state, t);
        const double length = d.norm(), w = static_cast<double>(a.w) + static_cast<double>(b.w);
        const double compliance = t.compliance_m_n / (h * h);
        const double before = static_cast<double>(state.tether_lambda_n[i]) * h * h;
        // One-sided: the multiplier pulls or is zero.
        const double after =
            std::max(0.0, before + (length - t.rest_m - compliance * before) / (w + compliance));
        if (!(length > 0) || !std::isfinite(after)) continue;
        const Vec3 step = (after - before) / length * d;
        state.tether_lambda_n[i] = static_cast<float>(after / (h * h));
        move_vertex(state, t.vertex[0], static_cast<double>(a.w) * step);
        move_vertex(state, t.vertex[1], -static_cast<double>(b.w) * step);
    }
}

bool break_overloaded_tethers(const SoftBody& body, SoftBodyState& state) noexcept {
    bool broke = false;
    for (size_t i = 0; i < state.tether_alive.size(); ++i) {
        if (state.tether_alive[i] == 0) continue;
        if (static_cast<double>(state.tether_lambda_n[i]) > body.spec().tethers[i].break_n) {
            state.tether_alive[i] = 0;
            broke = true;
        }
    }
    return broke;
}

}  // namespace placode::sim
