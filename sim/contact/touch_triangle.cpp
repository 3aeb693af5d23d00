// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where a triangle touches a rigid body, and the lists of contacts and vertices that follow.

#include <algorithm>
#include <bit>
#include <cassert>

#include "sim/contact/contact_core.h"

namespace placode::sim {
namespace {

// Deepest overlap that still adds force [m]. In touch it stays below 0.02 mm; more only happens
// where surface appears inside an instrument (removed tets) or a hand comes back inside tissue.
constexpr double kDeepest = 2e-4;
// A nearest point this much deeper than its corners say, in edges, counts as a whole contact.
constexpr double kBulge = 0.02;
constexpr double kHardest = 1e-4;       // contacts harden up to this overlap [m]
constexpr double kHardening = 5e4;      // of a contact, for every metre of overlap [1/m]
constexpr int kFeaturesOfAContact = 4;  // places in the table for every contact, so that few clash
constexpr int kVertexBits = 24, kSideBits = 15;  // of the key of a corner or edge

/// Slot of a vertex in the contact colour; -1 when the list is full.
int32_t slot_of(ContactLists& lists, SoftBodyState& body, int32_t v) noexcept {
    int32_t& slot = lists.slot[as_index(v)];
    if (slot >= 0) return slot;
    if (lists.vertex_count == std::ssize(lists.vertices)) return -1;
    slot = lists.vertex_count++;
    lists.vertices[as_index(slot)] = {};
    lists.vertices[as_index(slot)].vertex = v;
    body.contact_vertex[as_index(v)] = 1;
    return slot;
}

/// True when the corner or edge on which the contact lies has one already: the same point must not
/// push as often as triangles meet there.
bool is_double(ContactLists& lists, const Contact& c) noexcept {
    if (c.corners == 3) return false;
    const int32_t a = c.vertex[0], b = c.vertex[as_index(c.corners - 1)];
    const auto low = static_cast<uint64_t>(std::min(a, b)),
               high = static_cast<uint64_t>(std::max(a, b));
    assert(high >> kVertexBits == 0 && c.side >> kSideBits == 0);
    const uint64_t key =
        ((high << kVertexBits | low) << kSideBits | static_cast<uint64_t>(c.side)) + 1;
    uint64_t place = key * 0x9E3779B97F4A7C15ull >> lists.feature_shift;
    for (;; place = place + 1 == lists.feature.size() ? 0 : place + 1) {
        if (lists.feature[place] == key) return true;
        if (lists.feature[place] == 0) break;
    }
    lists.feature[place] = key;
    lists.feature_used[as_index(lists.feature_count++)] = static_cast<int32_t>(place);
    return false;
}

/// Adds a contact whose weights, normal and share (in stiffness_n_m) are set. False when a list is
/// full.
bool add_contact(ContactLists& lists, SoftBodyState& body, RigidSide& side,
                 const NearTriangle& triangle, Contact c, double gap) noexcept {
    side.gap_m = std::min(side.gap_m, gap);
    c.offset_m = std::max(gap, -kDeepest * side.force_share);
    // Harder the deeper it is: a soft contact is calm, and a strong hand must not get through.
    c.stiffness_n_m *= 1 + kHardening * std::clamp(-c.offset_m, 0.0, kHardest);
    // Corners that count come first.
    c.corners = 0;
    for (size_t k = 0; k < 3; ++k) {
        if (c.b[k] == 0) continue;
        c.offset_m -= c.b[k] * c.n.dot(triangle.x[k]);
        c.vertex[as_index(c.corners)] = triangle.vertex[k];
        c.b[as_index(c.corners++)] = c.b[k];
    }
    // First, because is_double() notes the corner or edge in a list as long as that of contacts.
    if (lists.contact_count == std::ssize(lists.contacts)) return false;
    if (is_double(lists, c)) return true;
    for (size_t k = 0; k < as_index(c.corners); ++k) {
        const int32_t slot = slot_of(lists, body, c.vertex[k]);
        if (slot < 0) return false;
        ContactVertex& touched = lists.vertices[as_index(slot)];
        touched.side = c.side;
        touched.friction = triangle.friction;
        touched.friction_static_ratio = triangle.friction_static_ratio;
    }
    lists.contacts[as_index(lists.contact_count++)] = c;
    return true;
}

}  // namespace

ContactLists::ContactLists(int vertices_of_body, int most_contacts, int most_touched)
    : slot(as_index(vertices_of_body), -1),
      hessian(as_index(vertices_of_body)),
      hessian_frame(as_index(vertices_of_body), -1) {
    make_room(most_contacts, most_touched);
}

void ContactLists::make_room(int most_contacts, int most_touched) {
    assert(contact_count == 0 && feature_count == 0);
    if (most_touched > std::ssize(vertices)) vertices.resize(as_index(most_touched));
    if (most_contacts <= std::ssize(contacts)) return;
    contacts.resize(as_index(most_contacts));
    incidence.resize(4 * as_index(most_contacts));
    feature_used.resize(as_index(most_contacts));
    const uint64_t places = std::bit_ceil(kFeaturesOfAContact * as_index(most_contacts));
    feature.assign(places, 0);
    feature_shift = std::countl_zero(places) + 1;
}

void clear_contacts(ContactLists& lists, std::span<const int32_t> colour,
                    SoftBodyState& body) noexcept {
    for (const int32_t v : colour) {
        lists.slot[as_index(v)] = -1;
        body.contact_vertex[as_index(v)] = 0;
    }
    for (int i = 0; i < lists.feature_count; ++i)
        lists.feature[as_index(lists.feature_used[as_index(i)])] = 0;
    lists.contact_count = lists.vertex_count = lists.feature_count = 0;
}

bool touch_triangle(ContactLists& lists, SoftBodyState& body, RigidSide& side,
                    const NearTriangle& triangle) noexcept {
    const Triangle& x = triangle.x;
    const TriangleDistance& d = triangle.nearest;
    const double half_m = triangle.half_thickness_m;
    const Vec3 face = (x[1] - x[0]).cross(x[2] - x[0]).normalized();
    const auto looks_away = [&](const Vec3& n) noexcept {
        return !triangle.both_sides && n.dot(face) > kContactFacing;
    };
    Contact c;
    c.side = side.number;
    c.tissue = triangle.tissue;
    c.stiffness_n_m = 1;
    if (d.pierced) {
        c.n = -face;  // back to the side that the instrument came from
        for (size_t k = 0; k < 3; ++k) c.b[k] = d.weight[static_cast<Eigen::Index>(k)];
        return add_contact(lists, body, side, triangle, c, d.value_m - half_m);
    }
    double chord = 0;
    for (size_t k = 0; k < 3; ++k) {
        const Distance& corner = triangle.corner[k];
        chord += d.weight[static_cast<Eigen::Index>(k)] * corner.value_m;
        c.n = corner.gradient;
        const double gap = corner.value_m - half_m;
        if (gap > side.margin_m || looks_away(c.n)) continue;
        c.b = {};
        c.b[k] = 1;
        if (!add_contact(lists, body, side, triangle, c, gap)) return false;
    }
    const double size =
        std::max({(x[1] - x[0]).norm(), (x[2] - x[0]).norm(), (x[2] - x[1]).norm()});
    const double share = std::min(1.0, (chord - d.value_m) / (kBulge * size));
    c.n = d.gradient;
    if (!(share > 1e-3) || looks_away(c.n)) return true;
    c.stiffness_n_m = share;
    for (size_t k = 0; k < 3; ++k) c.b[k] = d.weight[static_cast<Eigen::Index>(k)];
    return add_contact(lists, body, side, triangle, c, d.value_m - half_m);
}

bool add_to_colour(ContactLists& lists, SoftBodyState& body, const Contact& contact) noexcept {
    if (lists.contact_count == std::ssize(lists.contacts)) return false;
    for (size_t k = 0; k < as_index(contact.corners); ++k) {
        if (slot_of(lists, body, contact.vertex[k]) < 0) return false;
    }
    lists.contacts[as_index(lists.contact_count++)] = contact;
    return true;
}

}  // namespace placode::sim
