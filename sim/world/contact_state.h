// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contacts of a frame (scratch), and the pairs of tissue that may touch (state).
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"
#include "sim/core/tissue.h"
#include "sim/core/tool_shape.h"

namespace placode::sim {

struct Scene;

/// In place of a tool: the other side is tissue as well.
inline constexpr int8_t kTissueSide = -1;

/// One triangle against one instrument, or a vertex against a triangle of other tissue.
/// f = k max(0, -gap), gap = n . (sum b x) + offset.
struct Contact {
    std::array<int32_t, 4> vertex{};
    std::array<double, 4> b{};  // barycentric weights; those of the other side are negative
    Vec3 n = Vec3::UnitZ();     // from the other side into the tissue, in W
    double offset_m = 0;
    double stiffness_n_m = 0;
    Tissue tissue = Tissue::kSkin;
    int8_t tool = 0;     // or kTissueSide
    int8_t corners = 3;  // the first of `vertex` and `b` that count
};

/// A vertex of the contact colour and its share of the contacts.
struct ContactVertex {
    int32_t vertex = 0;
    int32_t first = 0, count = 0;  // into ContactSet::incidence
    int8_t tool = kTissueSide;     // that touches it
    float friction = 0, friction_static_ratio = 1;
    Vec3 normal_force_n = Vec3::Zero();
    double stiffness_n_m = 0;  // of the tissue alone, along the normal
    double friction_n_m = 0;   // of the tangential spring
};

inline constexpr int kMostContactVertices = 2048;

/// Bounded lists of a frame. Incidence entries are contact * 4 + corner.
struct ContactSet {
    explicit ContactSet(const Scene& scene);
    std::array<ToolShape, kMaxTools> shapes;
    std::array<uint8_t, kMaxTools> near{};    // 1 = the tool has candidates in this frame
    std::vector<int32_t> candidates;          // triangle * 4 + tool
    std::vector<std::array<float, 4>> start;  // of each: centre in T at the frame's start, distance
    std::vector<TriangleDistance> nearest;    // of each: on the triangle, in this substep
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
    int feature_count = 0;
    int candidate_count = 0, contact_count = 0, vertex_count = 0;
    int most_contacts = 0;  // within this frame
};

/// The contact colour of the last substep: who leaves it loses its memory of friction.
struct ContactColour {
    std::vector<int32_t> vertex;  ///< First `count`. Sized once.
    int32_t count = 0;
    uint32_t fitted = ~0U;  ///< Surface version at the last refit of the tree.
};
template <class Visit>
void fields(Of<ContactColour> auto& s, Visit&& visit) {
    auto& [vertex, count, fitted] = s;
    visit.state(vertex, count, fitted);
}

/// A vertex and the face that it may touch: the one opposite to corner `face` of `tet`, which
/// keeps its name while others come and go.
struct TissuePair {
    int32_t vertex = -1, tet = -1;
    int32_t face = 0;
};
template <class Visit>
void fields(Of<TissuePair> auto& s, Visit&& visit) {
    auto& [vertex, tet, face] = s;
    visit.state(vertex, tet, face);
}
template <>
inline constexpr bool kPlainBytes<TissuePair> = true;

/// Sized by the constructor, never grows; empty in a scene that does not list it.
struct SelfContact {
    explicit SelfContact(const Scene& scene);

    [[nodiscard]] bool enabled() const noexcept { return !beside_until.empty(); }

    /// By vertex modulo kGroups: one group is looked up anew in every frame.
    static constexpr int kGroups = 4;
    std::array<std::vector<TissuePair>, kGroups> pairs;
    std::array<int32_t, kGroups> count{};
    std::vector<int64_t>
        beside_until;  ///< (V + spares) Lies next to moved tissue until this frame.
};
template <class Visit>
void fields(Of<SelfContact> auto& s, Visit&& visit) {
    auto& [pairs, count, beside_until] = s;
    visit.state(count, beside_until);
    for (size_t g = 0; g < pairs.size(); ++g) visit.state_of(count[g], pairs[g]);
}

}  // namespace placode::sim
