// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The contact colour of an attempt: passes over it, forces on the instruments, and what vertices
// remember of them.

#include <algorithm>
#include <array>

#include "sim/contact/contact.h"
#include "sim/contact/contact_core.h"
#include "sim/contact/jaw_spread.h"
#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kStiffnessMemory = 0.95;  // per substep: a short lift-off does not forget tissue

/// Keeps where a vertex sticks, in the frame of its instrument.
void keep_anchor(State& state, const ContactVertex& touched) noexcept {
    FrictionAnchor& anchor = state.friction[touched.vertex];
    anchor = {};
    if (touched.sticks_to < 0) return;
    const Vec3 at_T = state.tools[touched.sticks_to].proxy.inverse() * touched.sticks_at;
    anchor.tool = static_cast<int8_t>(touched.sticks_to);
    anchor.slipping = touched.slipping;
    for (int i = 0; i < 3; ++i) anchor.anchor_T[i] = static_cast<float>(at_T[i]);
}

bool is_bonded(const State& state, int vertex) noexcept {
    const auto& suture = state.scratch->suture;
    return !suture.empty() && suture[0].slot[as_index(vertex)] >= 0;
}

}  // namespace

void add_contacts(State& state, int32_t vertex, VertexSystem& system) noexcept {
    ContactSet& set = state.scratch->contacts;
    const int32_t slot = set.slot[as_index(vertex)];
    if (slot >= 0) add_touch(set, state.body, set.vertices[as_index(slot)], system);
}

void solve_contacts(const Scene& scene, State& state, double h, bool backward) noexcept {
    ContactSet& set = state.scratch->contacts;
    for (int turn = 0; turn < set.vertex_count; ++turn) {
        ContactVertex& touched = set.vertices[backward ? set.vertex_count - 1 - turn : turn];
        if (state.body.x[touched.vertex].w == 0 || is_bonded(state, touched.vertex)) continue;
        const VertexStep taken = solve_contact(set, scene.body, state.body, touched, h);
        if (!taken.finite) state.flags |= kNotFinite;
        if (taken.limited) state.flags |= kStepLimited;
    }
}

void finish_contacts(State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    const double share = 1.0 / state.substeps;
    for (ToolState& tool : state.tools) {
        tool.substep_force_n = Vec3::Zero();
        tool.substep_overlap_m = 0;
    }
    weigh_contacts(set, state.body, [&](const Contact& c, double gap, double force) noexcept {
        ToolState& tool = state.tools[c.side];
        tool.substep_force_n -= force * c.n;
        tool.substep_overlap_m = std::max(tool.substep_overlap_m, -gap);
        if (c.tissue == Tissue::kPlacode) tool.placode_force_n += share * force;
    });
    weigh_jaws(state);
    std::array<double, kMaxTools> stiffness{};
    for (int i = 0; i < set.vertex_count; ++i) {
        ContactVertex& touched = set.vertices[i];
        if (touched.side == kTissueSide) {
            state.friction[touched.vertex] = {};
            continue;
        }
        const Friction f = friction_of(touched, state.body);
        state.tools[touched.side].substep_force_n += f.stiffness_n_m * f.slide;
        stiffness[touched.side] += touched.stiffness_n_m;
        stick(touched, state.body);
        keep_anchor(state, touched);
    }
    for (int t = 0; t < kMaxTools; ++t) {
        ToolState& tool = state.tools[t];
        tool.substep_stiffness_n_m =
            std::max(stiffness[t], kStiffnessMemory * tool.substep_stiffness_n_m);
        tool.force_n += share * tool.substep_force_n;
        tool.stiffness_n_m += share * stiffness[t];
    }
}

}  // namespace placode::sim
