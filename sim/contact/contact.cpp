// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/contact.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/contact_law.h"
#include "sim/contact/narrow_phase.h"
#include "sim/contact/self_contact.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kMostCandidates = 16384, kMostContacts = 2048;
constexpr int kFeatureTable = 8192;  // a power of two, four times the most contacts
// Deepest overlap that still adds force [m]. In touch it stays below 0.02 mm; more only happens
// where surface appears inside an instrument (removed tets) or a hand comes back inside tissue.
constexpr double kDeepest = 2e-4;
// A nearest point this much deeper than its corners say, in edges, counts as a whole contact.
constexpr double kBulge = 0.02;
constexpr double kHardest = 1e-4;   // contacts harden up to this overlap [m]
constexpr double kHardening = 5e4;  // of a contact, for every metre of overlap [1/m]
constexpr double kFacing = 0.5;  // faces that look away from the instrument more than this are not
                                 // touched: their other side is

/// Slot of a vertex in the contact colour; -1 when the list is full.
int slot_of(ContactSet& set, SoftBodyState& body, int v) noexcept {
    if (set.slot[v] >= 0) return set.slot[v];
    if (set.vertex_count == static_cast<int>(set.vertices.size())) return -1;
    set.slot[v] = set.vertex_count;
    set.vertices[set.vertex_count] = {};
    set.vertices[set.vertex_count].vertex = v;
    body.contact_vertex[v] = 1;
    return set.vertex_count++;
}

void clear_contacts(ContactSet& set, const ContactColour& colour, SoftBodyState& body) noexcept {
    for (int i = 0; i < colour.count; ++i) {
        const int v = colour.vertex[i];
        set.slot[v] = -1;
        body.contact_vertex[v] = 0;
    }
    for (int i = 0; i < set.feature_count; ++i) set.feature[set.feature_used[i]] = 0;
    set.contact_count = set.vertex_count = set.feature_count = 0;
}

/// True when the corner or edge on which the contact lies has one already: the same point must not
/// push as often as triangles meet there.
bool is_double(ContactSet& set, const Contact& c) noexcept {
    if (c.corners == 3) return false;
    const int32_t a = c.vertex[0], b = c.vertex[c.corners - 1];
    const auto low = static_cast<uint64_t>(std::min(a, b)),
               high = static_cast<uint64_t>(std::max(a, b));
    const uint64_t key = ((high << 30 | low) << 2 | static_cast<uint64_t>(c.tool)) + 1;
    uint64_t place = key * 0x9E3779B97F4A7C15ull >> 51;
    for (;; place = (place + 1) % kFeatureTable) {
        if (set.feature[place] == key) return true;
        if (set.feature[place] == 0) break;
    }
    set.feature[place] = key;
    set.feature_used[set.feature_count++] = static_cast<int32_t>(place);
    return false;
}

/// What a vertex answers along `n` with its neighbours held [N/m].
double answer_along(const ContactSet& set, int v, const Vec3& n) noexcept {
    const auto& k = set.hessian[v];
    return k[0] * n.x() * n.x() + k[3] * n.y() * n.y() + k[5] * n.z() * n.z() +
           2 * (k[1] * n.x() * n.y() + k[2] * n.x() * n.z() + k[4] * n.y() * n.z());
}

/// Stiffness of every contact and friction spring, from the tissue's. Once a frame for each vertex.
void set_stiffness(const Scene& scene, State& state, double h) noexcept {
    ContactSet& set = state.scratch->contacts;
    const double most = scene.contact.stiffness_n_m;
    for (int i = 0; i < set.vertex_count; ++i) {
        ContactVertex& cv = set.vertices[i];
        auto& k = set.hessian[cv.vertex];
        if (set.hessian_frame[cv.vertex] != state.frame) {
            set.hessian_frame[cv.vertex] = state.frame;
            const Mat3 m = vertex_system(scene.body, state.body, cv.vertex, h).hessian;
            const double values[6] = {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
            for (int n = 0; n < 6; ++n) k[n] = static_cast<float>(values[n]);
        }
        cv.friction_n_m = std::min(most, kContactRatio * (k[0] + k[3] + k[5]) / 3);
    }
    for (int i = 0; i < set.contact_count; ++i) {
        Contact& c = set.contacts[i];
        double gives = 0;
        for (int n = 0; n < c.corners; ++n) {
            if (state.body.x[c.vertex[n]].w == 0) continue;
            const double answer = answer_along(set, c.vertex[n], c.n);
            if (answer > 0) gives += c.b[n] * c.b[n] / answer;
        }
        c.stiffness_n_m *= gives * most > kContactRatio ? kContactRatio / gives : most;
    }
}

/// Incidence lists: contacts of each vertex, in the order of the contacts.
void build_incidence(ContactSet& set) noexcept {
    for (int i = 0; i < set.contact_count; ++i) {
        const Contact& c = set.contacts[i];
        for (int n = 0; n < c.corners; ++n) ++set.vertices[set.slot[c.vertex[n]]].count;
    }
    int sum = 0;
    for (int i = 0; i < set.vertex_count; ++i) {
        set.vertices[i].first = sum;
        sum += set.vertices[i].count;
        set.vertices[i].count = 0;
    }
    for (int i = 0; i < set.contact_count; ++i) {
        for (int corner = 0; corner < set.contacts[i].corners; ++corner) {
            ContactVertex& cv = set.vertices[set.slot[set.contacts[i].vertex[corner]]];
            set.incidence[cv.first + cv.count++] = i * 4 + corner;
        }
    }
}

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

/// Adds a contact whose corners, weights, normal and share (in stiffness_n_m) are set. False when a
/// list is full.
bool add_contact(const Scene& scene, State& state, Contact c, double gap,
                 const Triangle& x) noexcept {
    ContactSet& set = state.scratch->contacts;
    ToolState& tool = state.tools[c.tool];
    tool.gap_m = std::min(tool.gap_m, gap);
    c.offset_m = std::max(gap, -kDeepest * tool.contact_share);
    // Harder the deeper it is: a soft contact is calm, and a strong hand must not get through.
    c.stiffness_n_m *= 1 + kHardening * std::clamp(-c.offset_m, 0.0, kHardest);
    // Corners that count come first.
    Triangle at = x;
    c.corners = 0;
    for (int k = 0; k < 3; ++k) {
        if (c.b[k] == 0) continue;
        c.offset_m -= c.b[k] * c.n.dot(at[k]);
        c.vertex[c.corners] = c.vertex[k];
        c.b[c.corners++] = c.b[k];
    }
    if (is_double(set, c)) return true;
    if (set.contact_count == static_cast<int>(set.contacts.size())) return false;
    const Material& material = scene.body.spec().materials[static_cast<int>(c.tissue)];
    for (int k = 0; k < c.corners; ++k) {
        const int slot = slot_of(set, state.body, c.vertex[k]);
        if (slot < 0) return false;
        ContactVertex& cv = set.vertices[slot];
        cv.tool = c.tool;
        cv.friction = static_cast<float>(material.friction);
        cv.friction_static_ratio = static_cast<float>(material.friction_static_ratio);
    }
    set.contacts[set.contact_count++] = c;
    return true;
}

}  // namespace

bool add_tissue_contact(State& state, const Contact& contact) noexcept {
    ContactSet& set = state.scratch->contacts;
    if (set.contact_count == static_cast<int>(set.contacts.size())) return false;
    for (int k = 0; k < contact.corners; ++k) {
        if (slot_of(set, state.body, contact.vertex[k]) < 0) return false;
    }
    set.contacts[set.contact_count++] = contact;
    return true;
}

namespace {

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

/// Contacts of one triangle: its corners, and its nearest point where the instrument is more curved
/// than the corners show. Corners do not move over the triangle as the nearest point does, which on
/// a flat face jumps about with every micrometre.
bool touch_triangle(const Scene& scene, State& state, const SurfaceTriangle& tri, int t,
                    const Triangle& x, const Triangle& x_T, const TriangleDistance& d) noexcept {
    const Quat& q = state.tools[t].proxy.q;
    const Vec3 face = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    Contact c;
    c.tool = static_cast<int8_t>(t);
    c.tissue = tri.tissue;
    std::copy(tri.vertex.begin(), tri.vertex.end(), c.vertex.begin());
    c.stiffness_n_m = 1;
    if (d.pierced) {
        c.n = -face;  // back to the side that the instrument came from
        for (int k = 0; k < 3; ++k) c.b[k] = d.weight[k];
        return add_contact(scene, state, c, d.value_m, x);
    }
    double chord = 0;
    for (int k = 0; k < 3; ++k) {
        const Distance corner = distance_of_corner(scene, state, t, x_T[k]);
        chord += d.weight[k] * corner.value_m;
        c.n = q * corner.gradient;
        if (corner.value_m > scene.contact.margin_m || c.n.dot(face) > kFacing) continue;
        c.b = {};
        c.b[k] = 1;
        if (!add_contact(scene, state, c, corner.value_m, x)) return false;
    }
    const double size =
        std::max({(x[1] - x[0]).norm(), (x[2] - x[0]).norm(), (x[2] - x[1]).norm()});
    const double share = std::min(1.0, (chord - d.value_m) / (kBulge * size));
    c.n = q * d.gradient;
    if (!(share > 1e-3) || c.n.dot(face) > kFacing) return true;
    c.stiffness_n_m = share;
    for (int k = 0; k < 3; ++k) c.b[k] = d.weight[k];
    return add_contact(scene, state, c, d.value_m, x);
}

}  // namespace

ContactSet::ContactSet(const Scene& scene)
    : candidates(kMostCandidates),
      start(kMostCandidates),
      nearest(kMostCandidates),
      contacts(kMostContacts),
      vertices(kMostContactVertices),
      incidence(4 * kMostContacts),
      slot(scene.body.vertex_capacity(), -1),
      hessian(scene.body.vertex_capacity()),
      hessian_frame(scene.body.vertex_capacity(), -1),
      feature(kFeatureTable, 0),
      feature_used(kMostContacts) {
    for (size_t t = 0; t < scene.tools.size() && t < shapes.size(); ++t) {
        shapes[t] = make_tool_shape(scene.tools[t]);
    }
}

void find_contacts(const Scene& scene, State& state) noexcept {
    ContactSet& set = state.scratch->contacts;
    clear_contacts(set, state.colour, state.body);
    const auto triangles = state.surface.triangles();
    for (ToolState& tool : state.tools) tool.bare_gap_m = tool.gap_m = 1;
    NarrowPhase narrow(scene, state);
    state.workers->run<&NarrowPhase::job>(narrow.jobs(), narrow);
    for (int i = 0; i < set.candidate_count; ++i) {
        const TriangleDistance& d = set.nearest[i];
        if (d.part < 0) continue;
        const SurfaceTriangle& tri = triangles[set.candidates[i] / 4];
        const int t = set.candidates[i] % 4;
        Triangle x, x_T;
        for (int k = 0; k < 3; ++k) {
            x[k] = to_vec(state.body.x_start[tri.vertex[k]]);
            x_T[k] = narrow.to_tool(t) * x[k];
        }
        if (d.part < set.shapes[t].bare_parts) {
            note_spot(scene, state.body, state.tools[t], tri, x, d);
        }
        if (!touch_triangle(scene, state, tri, t, x, x_T, d)) {
            state.flags |= kContactsDropped;
            break;
        }
    }
    if (!touch_tissue(scene, state)) state.flags |= kContactsDropped;
    // Who left the colour has lifted off.
    for (int i = 0; i < state.colour.count; ++i) {
        const int v = state.colour.vertex[i];
        if (set.slot[v] < 0) state.friction[v] = {};
    }
    state.colour.count = set.vertex_count;
    for (int i = 0; i < set.vertex_count; ++i) state.colour.vertex[i] = set.vertices[i].vertex;
    // A vertex between instrument and tissue starts from where it was: with the momentum of the
    // others a deeply pressed patch of fine triangles bursts into oscillation (60 kPa, edges of
    // 0.1 mm, sphere of 1.5 mm dug 0.5 mm in, h = 0.25 ms).
    for (int i = 0; i < set.vertex_count; ++i) {
        Float4& x = state.body.x[set.vertices[i].vertex];
        const Float4& before = state.body.x_start[set.vertices[i].vertex];
        x = {before.x, before.y, before.z, x.w};
    }
    set_stiffness(scene, state, scene.body.spec().solver.frame_s / state.substeps);
    build_incidence(set);
    set.most_contacts = std::max(set.most_contacts, set.contact_count);
}

}  // namespace placode::sim
