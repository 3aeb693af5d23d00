// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Points that move with the tissue, and how a needle's tip wanders from one to the next: through
// the tetrahedra as they are now, from face to face. Weights of a place inside a linear tetrahedron
// are the same at rest and deformed, so a point found in the deformed body is known at rest.

#include <array>
#include <cstdint>

#include "sim/mesh/surface.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

/// What else acts on a vertex that is bonded to needle or thread, as an instrument that touches it:
/// adds its part to the vertex's system, so that both are solved together.
struct OtherLoads {
    void (*add)(void* of, int32_t vertex, VertexSystem& system) noexcept = nullptr;
    void* of = nullptr;
};

/// What the suture knows of the tissue, and what it changes of it: vertices in `state`.
struct SuturedTissue {
    const SoftBody& body;
    SoftBodyState& state;
    const Surface& surface;
    const SurfaceState& faces;  ///< Its tree must have been refitted in this frame or the last.
    OtherLoads others{};
};

/// A place in a tetrahedron, or on one of its faces (weight 0).
struct TissuePoint {
    int32_t tet = -1;
    std::array<double, 4> b{};  ///< Barycentric, in the order of the tet's corners; sum 1.
};
template <class Visit>
void fields(Of<TissuePoint> auto& s, Visit&& visit) {
    auto& [tet, b] = s;
    visit.state(tet, b);
}

/// Where it is now [m].
[[nodiscard]] Vec3 place_of(const SuturedTissue& tissue, const TissuePoint& point) noexcept;
/// Where it is at rest [m].
[[nodiscard]] Vec3 rest_place_of(const SuturedTissue& tissue, const TissuePoint& point) noexcept;
/// What the tissue answers there at once, every vertex with its neighbours held [N/m]; 0 where all
/// corners are held. Costs four vertex_system().
[[nodiscard]] double answer_of(const SuturedTissue& tissue, const TissuePoint& point,
                               double h_s) noexcept;

enum class WalkEnd : uint8_t {
    kArrived,
    kAtFace,     ///< At a face that has tissue behind it.
    kAtSurface,  ///< At a face of the body's surface.
    kLost,       ///< The tetrahedron is too flat to say where; nothing was moved.
};
struct TissueWalk {
    TissuePoint at;
    double share = 0;  ///< Of the way that was gone.
    int face = -1;     ///< Local face at which it ended, or -1.
    WalkEnd end = WalkEnd::kArrived;
};
/// Goes from a point by `way` [m], as far as the next face.
[[nodiscard]] TissueWalk walk_to_face(const SuturedTissue& tissue, const TissuePoint& from,
                                      const Vec3& offset) noexcept;
/// The same point in the tet behind a face. @pre the face has a living tet behind it.
[[nodiscard]] TissuePoint across_face(const SuturedTissue& tissue, const TissuePoint& at,
                                      int face) noexcept;

/// Where a straight way meets the surface from outside, first. tet -1 = it does not.
struct SurfaceHit {
    TissuePoint at;
    double share = 1;
    Tissue tissue = Tissue::kSkin;
};
[[nodiscard]] SurfaceHit meet_surface(const SuturedTissue& tissue, const Vec3& from,
                                      const Vec3& offset) noexcept;

/// The surface next to a place, as a plane. false in `found`: farther than was asked for.
struct SurfacePlane {
    Vec3 n = Vec3::UnitZ();  ///< Outward.
    double gap_m = 0;        ///< Of the place; negative inside.
    bool found = false;
};
[[nodiscard]] SurfacePlane nearest_surface(const SuturedTissue& tissue, const Vec3& p,
                                           double within_m) noexcept;

}  // namespace placode::sim
