// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contact of rigid bodies with tissue, for all that touches: the instruments of an attempt
// (contact.cpp) and the spheres of verification scenes (verify/pressed_vertices.cpp), so that what
// is verified is what is felt. Who calls it says where the bodies are, which triangles are near,
// and keeps where vertices stick between substeps. Any one system of units in which tissue has the
// size of an operative field, some centimetres.
//
// A substep: clear_contacts(), touch_triangle() for what is near, begin_contacts(); sticks_at and
// sticks_to of every vertex; solve_contact() vertex by vertex, before the sweep and after it; then
// weigh_contacts(), friction_of() and stick().

#include <cassert>
#include <span>

#include "sim/contact/contact_law.h"
#include "sim/core/as_index.h"
#include "sim/core/tool_shape.h"
#include "sim/solver/double_float.h"
#include "sim/world/contact_lists.h"

namespace placode::sim {

/// Faces that look away from a rigid body more than this (cosine) are not touched: their other side
/// is.
inline constexpr double kContactFacing = 0.5;

/// A rigid body that looks for what it touches.
struct RigidSide {
    int32_t number = 0;      ///< Contact::side.
    double margin_m = 0;     ///< Contact starts this far out.
    double force_share = 1;  ///< Of the contact force that is let through.
    double gap_m = 1;        ///< Out: the smallest gap found so far.
};

/// A triangle near to a rigid body, by the places at the substep's start.
struct NearTriangle {
    std::array<int32_t, 3> vertex{};
    Triangle x;
    Tissue tissue = Tissue::kSkin;
    bool both_sides = false;      ///< A sheet. Of others, faces that look away are not touched.
    double half_thickness_m = 0;  ///< In front of its face.
    float friction = 0, friction_static_ratio = 1;  ///< Coulomb [-].
    TriangleDistance nearest;                       ///< Gradient in W.
    std::array<Distance, 3> corner;  ///< Gradients in W. Not read where it is pierced.
};

/// What the stiffness of contacts goes by.
struct ContactStiffness {
    double most_n_m = 0;
    double h_s = 0;     ///< Of a substep.
    int64_t frame = 0;  ///< What a vertex answers is looked up once a frame.
};

/// Start of a substep: nothing touches. @param colour vertices that were in contact.
void clear_contacts(ContactLists& lists, std::span<const int32_t> colour,
                    SoftBodyState& body) noexcept;

/// Adds the contacts of one triangle: its corners, and its nearest point where the body is more
/// curved than the corners show. Corners do not move over the triangle as the nearest point does,
/// which on a flat face jumps about with every micrometre. False when a list is full.
/// @pre fewer than 2^15 bodies and 2^24 vertices.
[[nodiscard]] bool touch_triangle(ContactLists& lists, SoftBodyState& body, RigidSide& side,
                                  const NearTriangle& triangle) noexcept;

/// Adds a contact that is known already. False when a list is full.
[[nodiscard]] bool add_to_colour(ContactLists& lists, SoftBodyState& body,
                                 const Contact& contact) noexcept;

/// After the last contact: vertices start from where they were, contacts get their stiffness.
void begin_contacts(ContactLists& lists, const SoftBody& body, SoftBodyState& state,
                    const ContactStiffness& stiffness) noexcept;

/// Adds all that touches a vertex to its system, and notes how it answers.
void add_touch(ContactLists& lists, const SoftBodyState& state, ContactVertex& touched,
               VertexSystem& system) noexcept;

/// Newton's step of one touched vertex. @param held bits of the axes along which it stays.
VertexStep solve_contact(ContactLists& lists, const SoftBody& body, SoftBodyState& state,
                         ContactVertex& touched, double h_s, uint8_t held = 0) noexcept;

/// Gap of a contact at the present positions [m], negative when they overlap.
[[nodiscard]] inline double gap_of(const Contact& c, const SoftBodyState& state) noexcept {
    double gap = c.offset_m;
    for (size_t i = 0; i < as_index(c.corners); ++i)
        gap += c.b[i] * c.n.dot(exact_position(state, c.vertex[i]));
    return gap;
}

/// Loads of all vertices anew, at the present positions; tells `each` (contact, gap, force) of the
/// rigid bodies that press.
template <class Each>
void weigh_contacts(ContactLists& lists, const SoftBodyState& state, Each&& each) {
    for (int i = 0; i < lists.vertex_count; ++i)
        lists.vertices[as_index(i)].normal_force_n = Vec3::Zero();
    for (int i = 0; i < lists.contact_count; ++i) {
        const Contact& c = lists.contacts[as_index(i)];
        if (c.side == kTissueSide) continue;
        const double gap = gap_of(c, state);
        if (gap >= 0) continue;
        const double force = -c.stiffness_n_m * gap;
        each(c, gap, force);
        for (size_t corner = 0; corner < as_index(c.corners); ++corner) {
            const int32_t slot = lists.slot[as_index(c.vertex[corner])];
            lists.vertices[as_index(slot)].normal_force_n += force * c.b[corner] * c.n;
        }
    }
}

/// Tangential spring of a vertex that a rigid body presses, by its load and where it sticks.
[[nodiscard]] Friction friction_of(const ContactVertex& touched,
                                   const SoftBodyState& state) noexcept;

/// After a substep: drags the place where a vertex sticks along where it slips, forgets it where
/// the vertex has lifted off.
void stick(ContactVertex& touched, const SoftBodyState& state) noexcept;

}  // namespace placode::sim
