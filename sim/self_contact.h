// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tissue against tissue, for scenes that list it (ContactSettings::self_contact): a piece that the
// jaws let go lies on the field, and a flap that is folded over does not sink into it.
//
// Only tissue that has come away from its place at rest can meet other tissue. Its surface
// vertices, and those of what lies next to it, look for the nearest face now and then; the pair is
// a contact of the contact colour like that with an instrument, with the vertex on one side and
// the face's corners on the other, so that action and reaction are equal by construction. Edges
// against edges are left out: the gap of kGapM hides them.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/surface.h"

namespace placode::sim {

struct Scene;
struct State;

/// A vertex and the face that it may touch: the one opposite to corner `face` of `tet`, which
/// keeps its name while others come and go.
struct TissuePair {
    int32_t vertex = -1, tet = -1;
    int32_t face = 0;
};

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

/// Start of a frame, after collect_candidates(): nearest faces of one group of vertices.
void collect_tissue_pairs(const Scene& scene, State& state) noexcept;

/// Within find_contacts(): adds the pairs that touch. False when a list is full.
bool touch_tissue(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
