// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Moves a vertex of the mesh through the body: its place at rest slides into a tet, a triangle or
// an edge next to it, and its place now by the same shares, so that the tissue stays where it is
// while the mesh gets a vertex where a cut needs one. Connectivity, colours and strips stay; the
// constants of the tets around the vertex and the masses of their corners are made again. Idea:
// node snapping (Nienhuys & van der Stappen 2001); recipe: docs/cutting.md.

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// What the tets around a vertex must still be like after a slide.
struct SlideLimits {
    double least_volume = 0.4;   ///< Of the volume in the mesh, by slides of all of its corners.
    double least_quality = 0.1;  ///< tet_quality(), where it was better.
};

/// Where a vertex slides: by `share` of the way to each of up to three vertices.
struct Slide {
    int32_t vertex = -1;
    std::array<int32_t, 3> towards{-1, -1, -1};  ///< Corners of a tet with `vertex`; -1 = none.
    std::array<float, 3> share{};                ///< Not negative, their sum at most 1.
};
template <class Visit>
void fields(Of<Slide> auto& s, Visit&& visit) {
    auto& [vertex, towards, share] = s;
    visit.state(vertex, towards, share);
}

/// Where the vertex is at rest after the slide, all others being at `rest` (V + spares).
[[nodiscard]] Vec3 slid_rest(std::span<const Vec3> rest, const Slide& slide) noexcept;

/// True when the tets around the vertex, at `rest`, keep the limits.
[[nodiscard]] bool slide_fits(const SoftBody& body, const SoftBodyState& state,
                              std::span<const Vec3> rest, const Slide& slide,
                              const SlideLimits& limits) noexcept;

/// Slides a vertex. False, and nothing is changed, where a limit forbids it, where the vertex
/// cannot be split (held by a spring, a tether, the bed) or is held now, or where no living tet has
/// all of them any more. Does not allocate.
/// @pre the body has a Topology and no strip is out of date (repack()).
[[nodiscard]] bool slide_vertex(const SoftBody& body, SoftBodyState& state, const Slide& slide,
                                const SlideLimits& limits) noexcept;

/// The lowest tet_quality() of the body, its vertices where they are at rest by now.
[[nodiscard]] double least_quality(const SoftBody& body, const SoftBodyState& state) noexcept;

}  // namespace placode::sim
