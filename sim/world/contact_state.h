// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Contacts of a frame (scratch), and the pairs of tissue that may touch (state).
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"
#include "sim/core/tool_shape.h"
#include "sim/world/contact_lists.h"

namespace placode::sim {

struct Scene;

inline constexpr int kMostContactVertices = 2048;

/// What instruments touch, and where they come near to tissue in a frame. Lists of bounded size.
struct ContactSet : ContactLists {
    explicit ContactSet(const Scene& scene);
    std::array<ToolShape, kMaxTools> shapes;
    std::array<uint8_t, kMaxTools> near{};    // 1 = the tool has candidates in this frame
    std::vector<int32_t> candidates;          // triangle * 4 + tool
    std::vector<std::array<float, 4>> start;  // of each: centre in T at the frame's start, distance
    std::vector<TriangleDistance> nearest;    // of each: on the triangle, in this substep
    int candidate_count = 0;
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

    [[nodiscard]] bool enabled() const noexcept { return !near_moved_until.empty(); }

    /// By vertex modulo kGroups: one group is looked up anew in every frame.
    static constexpr int kGroups = 4;
    std::array<std::vector<TissuePair>, kGroups> pairs;
    std::array<int32_t, kGroups> count{};
    std::vector<int64_t>
        near_moved_until;  ///< (V + spares) Lies next to moved tissue until this frame.
};
template <class Visit>
void fields(Of<SelfContact> auto& s, Visit&& visit) {
    auto& [pairs, count, near_moved_until] = s;
    visit.state(count, near_moved_until);
    for (size_t g = 0; g < pairs.size(); ++g) visit.state_of(count[g], pairs[g]);
}

}  // namespace placode::sim
