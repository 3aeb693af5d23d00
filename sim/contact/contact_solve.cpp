// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The contact colour: vertices next to instruments, one by one, with dry friction.

#include <algorithm>
#include <cmath>

#include "sim/contact/contact.h"
#include "sim/contact/contact_law.h"
#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr uint8_t kSlipMemory = 8;         // substeps without slip until static friction is back
constexpr double kTissueFriction = 0.2;    // of wet tissue on wet tissue
constexpr double kStiffnessMemory = 0.95;  // per substep: a short lift-off does not forget tissue

double gap_of(const Contact& c, const SoftBodyState& body) noexcept {
    double gap = c.offset_m;
    for (int i = 0; i < c.corners; ++i) gap += c.b[i] * c.n.dot(position(body, c.vertex[i]));
    return gap;
}

/// Tangential spring of a vertex that an instrument presses.
Friction friction_of(const State& state, const ContactVertex& cv) noexcept {
    const FrictionAnchor& anchor = state.friction[cv.vertex];
    const double load = cv.normal_force_n.norm();
    if (anchor.tool < 0 || !(load > 0)) return {};
    const Vec3 at = state.tools[anchor.tool].proxy *
                    Vec3(anchor.anchor_T[0], anchor.anchor_T[1], anchor.anchor_T[2]);
    const double limit = cv.friction * load * (anchor.slipping ? 1.0f : cv.friction_static_ratio);
    return dry_friction(cv.normal_force_n, position(state.body, cv.vertex) - at, limit,
                        cv.friction_n_m);
}

/// Friction of tissue on tissue within the substep: a spring against the way since its start,
/// softer where the cone ends. It takes energy only, and forgets: what shall lie still sticks
/// (sim/pieces).
void rub(const SoftBodyState& body, const Contact& c, double b, double load_n,
         VertexSystem& system) noexcept {
    Vec3 way = Vec3::Zero();
    for (int i = 0; i < c.corners; ++i) {
        way += c.b[i] * (position(body, c.vertex[i]) -
                         to_vec(body.x_start[static_cast<size_t>(c.vertex[i])]));
    }
    way -= c.n * c.n.dot(way);
    double k = c.stiffness_n_m;
    const double length = way.norm();
    if (length * k > kTissueFriction * load_n) k = kTissueFriction * load_n / length;
    system.gradient += k * b * way;
    system.hessian += k * b * b * (Mat3::Identity() - c.n * c.n.transpose());
}

/// After a substep: drags the anchor along where the vertex slips, forgets it where it lifts off.
void update_anchor(State& state, const ContactVertex& cv) noexcept {
    FrictionAnchor& anchor = state.friction[cv.vertex];
    if (!(cv.normal_force_n.norm() > 0)) {
        anchor = {};
        return;
    }
    const Vec3 x = position(state.body, cv.vertex);
    Vec3 at = x;
    if (anchor.tool == cv.tool) {
        const Friction f = friction_of(state, cv);
        const double k = cv.friction_n_m, length = f.slide.norm();
        const double dynamic = cv.friction * cv.normal_force_n.norm();
        if (length * k > f.limit_n) {
            anchor.slipping = kSlipMemory;
        } else if (anchor.slipping > 0) {
            --anchor.slipping;
        }
        const double keep = anchor.slipping && length * k > dynamic ? dynamic / (length * k) : 1.0;
        at = x - keep * f.slide;
    } else {
        anchor.slipping = 0;
    }
    const Vec3 at_T = state.tools[cv.tool].proxy.inverse() * at;
    anchor.tool = cv.tool;
    for (int i = 0; i < 3; ++i) anchor.anchor_T[i] = static_cast<float>(at_T[i]);
}

/// All that touches a vertex, and how it answers.
void add_touch(State& state, ContactVertex& cv, VertexSystem& system) noexcept {
    const ContactSet& set = state.scratch->contacts;
    const Mat3 tissue = system.hessian;
    Vec3 load = Vec3::Zero();
    for (int n = cv.first; n < cv.first + cv.count; ++n) {
        const Contact& c = set.contacts[set.incidence[n] / 4];
        const double b = c.b[set.incidence[n] % 4], gap = gap_of(c, state.body);
        const double k = c.stiffness_n_m;
        if (gap >= 0) continue;
        add_normal_contact(system, k, b, gap, c.n);
        if (c.tool == kTissueSide)
            rub(state.body, c, b, -k * gap, system);
        else
            load -= k * gap * b * c.n;
    }
    cv.normal_force_n = load;
    const double size = load.norm();
    cv.stiffness_n_m = size > 0 ? load.dot(tissue * load) / (size * size) : 0.0;
    const Friction f = friction_of(state, cv);
    if (f.stiffness_n_m > 0) add_friction(system, f);
}

bool is_bonded(const State& state, int vertex) noexcept {
    const auto& suture = state.scratch->suture;
    return !suture.empty() && suture[0].slot[as_index(vertex)] >= 0;
}

}  // namespace

void add_contacts(State& state, int32_t vertex, VertexSystem& system) noexcept {
    ContactSet& set = state.scratch->contacts;
    const int32_t slot = set.slot[as_index(vertex)];
    if (slot >= 0) add_touch(state, set.vertices[as_index(slot)], system);
}

void solve_contacts(const Scene& scene, State& state, double h, bool backward) noexcept {
    ContactSet& set = state.scratch->contacts;
    for (int turn = 0; turn < set.vertex_count; ++turn) {
        ContactVertex& cv = set.vertices[backward ? set.vertex_count - 1 - turn : turn];
        Float4& x = state.body.x[cv.vertex];
        if (x.w == 0 || is_bonded(state, cv.vertex)) continue;
        VertexSystem system = vertex_system(scene.body, state.body, cv.vertex, h);
        add_touch(state, cv, system);
        const VertexStep way =
            vertex_step(system, 1, scene.body.shortest_edge_m()[origin_of(state.body, cv.vertex)]);
        if (!way.finite) {
            state.flags |= kNotFinite;
            continue;
        }
        if (way.limited) state.flags |= kStepLimited;
        x.x += static_cast<float>(way.step.x());
        x.y += static_cast<float>(way.step.y());
        x.z += static_cast<float>(way.step.z());
    }
}

void finish_contacts(State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    const double share = 1.0 / state.substeps;
    for (ToolState& tool : state.tools) {
        tool.substep_force_n = Vec3::Zero();
        tool.substep_overlap_m = 0;
    }
    std::array<double, kMaxTools> stiffness{};
    for (int i = 0; i < set.vertex_count; ++i) set.vertices[i].normal_force_n = Vec3::Zero();
    for (int i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[i];
        if (c.tool == kTissueSide) continue;
        const double gap = gap_of(c, state.body);
        if (gap >= 0) continue;
        const double force = -c.stiffness_n_m * gap;
        ToolState& tool = state.tools[c.tool];
        tool.substep_force_n -= force * c.n;
        tool.substep_overlap_m = std::max(tool.substep_overlap_m, -gap);
        if (c.tissue == Tissue::kPlacode) tool.placode_force_n += share * force;
        for (int corner = 0; corner < c.corners; ++corner) {
            set.vertices[set.slot[c.vertex[corner]]].normal_force_n += force * c.b[corner] * c.n;
        }
    }
    for (int i = 0; i < set.vertex_count; ++i) {
        const ContactVertex& cv = set.vertices[i];
        if (cv.tool == kTissueSide) {
            state.friction[cv.vertex] = {};
            continue;
        }
        ToolState& tool = state.tools[cv.tool];
        const Friction f = friction_of(state, cv);
        tool.substep_force_n += f.stiffness_n_m * f.slide;
        stiffness[cv.tool] += cv.stiffness_n_m;
        update_anchor(state, cv);
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
