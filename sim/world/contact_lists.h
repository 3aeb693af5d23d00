// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What touches tissue in a substep, and the vertices that it touches: the lists on which
// sim/contact/contact_core.h works, for instruments as for the spheres of verification scenes.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/geometry.h"
#include "sim/core/tissue.h"

namespace placode::sim {

/// In place of a rigid body: the other side is tissue as well.
inline constexpr int32_t kTissueSide = -1;

/// One triangle against one rigid body (instrument, sphere), or a vertex against a triangle of
/// other tissue. f = k max(0, -gap), gap = n . (sum b x) + offset.
struct Contact {
    std::array<int32_t, 4> vertex{};
    std::array<double, 4> b{};  // barycentric weights; those of the other side are negative
    Vec3 n = Vec3::UnitZ();     // from the other side into the tissue, in W
    double offset_m = 0;
    double stiffness_n_m = 0;
    int32_t side = 0;  // number of the rigid body, or kTissueSide
    Tissue tissue = Tissue::kSkin;
    int8_t corners = 3;  // the first of `vertex` and `b` that count
};

/// A vertex of the contact colour, its share of the contacts, and where it sticks.
struct ContactVertex {
    int32_t vertex = 0;
    int32_t first = 0, count = 0;  // into ContactLists::incidence
    int32_t side = kTissueSide;    // that touches it
    float friction = 0, friction_static_ratio = 1;
    Vec3 normal_force_n = Vec3::Zero();
    double stiffness_n_m = 0;         // of the tissue alone, along the normal
    double friction_n_m = 0;          // of the tangential spring
    Vec3 sticks_at = Vec3::Zero();    // in W at the substep's end
    int32_t sticks_to = kTissueSide;  // a rigid body; kTissueSide = to nothing
    uint8_t slipping = 0;             // counts down the substeps since it slipped; 0 = sticks
};

/// Lists of a substep, of bounded size. Incidence entries are contact * 4 + corner.
struct ContactLists {
    /// @param vertices of the body, with its spares.
    ContactLists(int vertices, int most_contacts, int most_touched);
    /// Room for so many; what has more keeps it. Allocates. @pre no contacts
    void make_room(int most_contacts, int most_touched);

    std::vector<Contact> contacts;
    std::vector<ContactVertex> vertices;
    std::vector<int32_t> incidence;
    std::vector<int32_t> slot;  // (V) into vertices, -1 = not in contact
    // What a vertex answers with its neighbours held: xx xy xz yy yz zz [N/m], of this frame.
    std::vector<std::array<float, 6>> hessian;  // (V)
    std::vector<int64_t> hessian_frame;         // (V)
    // Corners and edges that have their contact already: open addressing, key + 1, 0 = empty.
    std::vector<uint64_t> feature;
    std::vector<int32_t> feature_used;
    int feature_shift = 64;  // of a hash of 64 bits, to a place in `feature`
    int feature_count = 0;
    int contact_count = 0, vertex_count = 0;
};

}  // namespace placode::sim
