// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles the instruments touch in a substep.

#include "sim/contact/contact.h"

#include <algorithm>
#include <utility>

#include "sim/contact/contact_core.h"
#include "sim/contact/narrow_phase.h"
#include "sim/contact/patch_contact.h"
#include "sim/contact/self_contact.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kMostCandidates = 16384, kMostContacts = 2048;

/// Notes the nearest spot of bare metal.
void note_spot(const Scene& scene, const SoftBodyState& body, ToolState& tool,
               const SurfaceTriangle& tri, const Triangle& x, const TriangleDistance& d) noexcept {
    if (d.value_m >= tool.bare_gap_m) return;
    tool.bare_gap_m = d.value_m;
    tool.spot = tool.rest_spot = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        tool.spot += d.weight[i] * x[i];
        tool.rest_spot += d.weight[i] * scene.body.mesh().rest[origin_of(body, tri.vertex[i])];
    }
    tool.spot_tet = tri.tet;
    tool.touched = tri.tissue;
}

/// Distance of a corner to an instrument; open blades do not touch what is between them.
Distance distance_of_corner(const Scene& scene, const State& state, int t,
                            const Vec3& x_T) noexcept {
    const ToolShape& shape = state.scratch->contacts.shapes[t];
    if (!blades_open(scene, state, t)) return signed_distance(shape, x_T);
    Distance best{1, Vec3::UnitX()};
    for (int i = 1; i < shape.count; ++i) {
        const Distance d = signed_distance(shape.parts[i], x_T);
        if (d.value_m < best.value_m) best = d;
    }
    return best;
}

/// A patch has two sides and a thickness: its triangle is turned to what touches it.
void face_the_instrument(const Patch& patch, const Quat& q, NearTriangle& near,
                         Triangle& x_T) noexcept {
    near.half_thickness_m = patch.thickness_m / 2;
    const Vec3 face = (near.x[1] - near.x[0]).cross(near.x[2] - near.x[0]);
    const Vec3 out = near.nearest.pierced ? Vec3(q * Vec3::UnitZ()) : near.nearest.gradient;
    if (!(out.dot(face) > 0)) return;
    std::swap(near.vertex[1], near.vertex[2]);
    std::swap(near.x[1], near.x[2]);
    std::swap(x_T[1], x_T[2]);
    std::swap(near.nearest.weight[1], near.nearest.weight[2]);
}

/// Contacts of candidate `i` with its instrument. False when a list is full.
bool touch_candidate(const Scene& scene, State& state, const NarrowPhase& narrow, int i) noexcept {
    ContactSet& set = state.scratch->contacts;
    const SurfaceTriangle& tri = touched_triangle(scene, state, set.candidates[i] / 4);
    const int t = set.candidates[i] % 4;
    ToolState& tool = state.tools[t];
    NearTriangle near;
    near.vertex = tri.vertex;
    near.tissue = tri.tissue;
    near.nearest = set.nearest[i];
    Triangle x_T;
    for (int k = 0; k < 3; ++k) {
        near.x[k] = to_vec(state.body.x_start[tri.vertex[k]]);
        x_T[k] = narrow.to_tool(t) * near.x[k];
    }
    const bool on_patch = tri.tet < 0;
    if (near.nearest.part < set.shapes[t].bare_parts && !on_patch)
        note_spot(scene, state.body, tool, tri, near.x, near.nearest);
    const Quat& q = tool.proxy.q;
    near.nearest.gradient = q * near.nearest.gradient;
    if (on_patch) face_the_instrument(*scene.patch, q, near, x_T);
    for (int k = 0; k < 3 && !near.nearest.pierced; ++k) {
        near.corner[k] = distance_of_corner(scene, state, t, x_T[k]);
        near.corner[k].gradient = q * near.corner[k].gradient;
    }
    const Material& material = scene.body.spec().materials[static_cast<int>(tri.tissue)];
    near.friction = static_cast<float>(on_patch ? scene.patch->tool_friction : material.friction);
    near.friction_static_ratio = static_cast<float>(material.friction_static_ratio);
    RigidSide side{t, scene.contact.margin_m, tool.contact_share, tool.gap_m};
    const bool has_room = touch_triangle(set, state.body, side, near);
    tool.gap_m = side.gap_m;
    return has_room;
}

/// Where the vertices of the colour stick. Who left it has lifted off.
void recall_anchors(State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    for (int i = 0; i < state.colour.count; ++i) {
        const int v = state.colour.vertex[i];
        if (set.slot[v] < 0) state.friction[v] = {};
    }
    state.colour.count = set.vertex_count;
    for (int i = 0; i < set.vertex_count; ++i) {
        ContactVertex& touched = set.vertices[i];
        state.colour.vertex[i] = touched.vertex;
        const FrictionAnchor& anchor = state.friction[touched.vertex];
        if (anchor.tool < 0) continue;
        touched.sticks_to = anchor.tool;
        touched.slipping = anchor.slipping;
        touched.sticks_at = state.tools[anchor.tool].proxy *
                            Vec3(anchor.anchor_T[0], anchor.anchor_T[1], anchor.anchor_T[2]);
    }
}

}  // namespace

ContactSet::ContactSet(const Scene& scene)
    : ContactLists(scene.body.vertex_capacity(), kMostContacts, kMostContactVertices),
      candidates(kMostCandidates),
      start(kMostCandidates),
      nearest(kMostCandidates) {
    for (size_t t = 0; t < scene.tools.size() && t < shapes.size(); ++t) {
        shapes[t] = make_tool_shape(scene.tools[t]);
    }
}

void find_contacts(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    clear_contacts(set, std::span(state.colour.vertex).first(as_index(state.colour.count)),
                   state.body);
    for (ToolState& tool : state.tools) tool.bare_gap_m = tool.gap_m = 1;
    NarrowPhase narrow(scene, state);
    state.workers->run<&NarrowPhase::job>(narrow.jobs(), narrow);
    for (int i = 0; i < set.candidate_count; ++i) {
        if (set.nearest[i].part < 0) continue;
        if (!touch_candidate(scene, state, narrow, i)) {
            state.flags |= kContactsDropped;
            break;
        }
    }
    if (!touch_tissue(scene, state)) state.flags |= kContactsDropped;
    recall_anchors(state);
    begin_contacts(set, scene.body, state.body,
                   {scene.contact.stiffness_n_m, scene.body.spec().solver.frame_s / state.substeps,
                    state.frame});
    set.most_contacts = std::max(set.most_contacts, set.contact_count);
}

}  // namespace placode::sim
