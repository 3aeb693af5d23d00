// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The visible and touchable skin of the tetrahedra. Faces that an element uncovers when it is
// removed become fresh surface; nothing is allocated after construction.

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "sim/core/fields.h"
#include "sim/mesh/mesh.h"
#include "sim/mesh/surface_tree.h"

namespace placode::sim {

/// One oriented boundary face (outward by the right-hand rule).
struct SurfaceTriangle {
    std::array<int32_t, 3> vertex{};
    int32_t tet = -1;  ///< The living tet behind it.
    Tissue tissue = Tissue::kSkin;
    uint8_t fresh = 0;  ///< 1 = uncovered by cutting or burning, or open from the start.
    std::array<uint8_t, 2> reserved{};
};
template <class Visit>
void fields(Of<SurfaceTriangle> auto& s, Visit&& visit) {
    auto& [vertex, tet, tissue, fresh, reserved] = s;
    visit.state(vertex, tet, tissue, fresh, reserved);
}
template <>
inline constexpr bool kPlainBytes<SurfaceTriangle> = true;
static_assert(std::has_unique_object_representations_v<SurfaceTriangle>);

/// Local vertices of the face opposite to local vertex f, outward for a positive tet.
inline constexpr std::array<std::array<int, 3>, 4> kTetFaces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Constant part: who is behind each face.
class Surface {
 public:
    /// Throws MeshError when more than two tets share a face.
    explicit Surface(const TetMesh& mesh);
    /// Neighbour tet over the face opposite to local vertex f (T x 4), -1 at the boundary.
    [[nodiscard]] std::span<const std::array<int32_t, 4>> neighbours() const noexcept {
        return neighbours_;
    }
    /// Boundary triangles at rest.
    [[nodiscard]] std::span<const SurfaceTriangle> rest_triangles() const noexcept { return rest_; }
    /// A boundary triangle that is an open wound from the start is drawn as one.
    void uncover(size_t triangle) { rest_.at(triangle).fresh = 1; }

 private:
    std::vector<std::array<int32_t, 4>> neighbours_;
    std::vector<SurfaceTriangle> rest_;
};

/// Changing part. `triangles()` is unordered but deterministic.
class SurfaceState {
 public:
    /// Where nothing parts tets (`can_part` false, no cut_face), a face is on the surface from one
    /// side at most, and half the room is enough.
    SurfaceState(const Surface& surface, const TetMesh& mesh, bool can_part);
    [[nodiscard]] std::span<const SurfaceTriangle> triangles() const noexcept {
        return {triangles_.data(), static_cast<size_t>(count_)};
    }
    /// Grows by one with every change.
    [[nodiscard]] uint32_t version() const noexcept { return version_; }
    /// Updates the boundary after `tet` was removed. @pre it was alive.
    /// `tets` = corners as they are now (empty: those of the mesh).
    void remove_tet(const Surface& surface, const TetMesh& mesh, std::span<const uint8_t> tet_alive,
                    int tet, std::span<const std::array<int32_t, 4>> tets = {}) noexcept;
    /// Boxes around the triangles; refit before asking. Slots are indices into triangles().
    [[nodiscard]] const SurfaceTree& tree() const noexcept { return tree_; }
    void refit(std::span<const Float4> x) noexcept { tree_.refit(triangles(), x); }
    /// The same where only leaves of `moves` (by node) have moved, and what was cut.
    void refit(std::span<const Float4> x, std::span<const uint8_t> moves,
               Workers& workers) noexcept {
        tree_.refit(triangles(), x, moves, workers);
    }
    /// True when the face of `tet` opposite to local vertex `f` is boundary.
    [[nodiscard]] bool on_surface(int tet, int f) const noexcept {
        return slot_of_face_[4 * tet + f] >= 0;
    }
    /// Parts two living tets: both sides of their face become fresh surface. @pre !on_surface.
    void cut_face(const Surface& surface, const TetMesh& mesh, int tet, int f,
                  std::span<const std::array<int32_t, 4>> tets) noexcept;
    /// After corners of a tet have changed.
    void follow_corners(int tet, std::span<const std::array<int32_t, 4>> tets) noexcept;

 private:
    SurfaceTree tree_;
    std::vector<SurfaceTriangle> triangles_;  // room for all that can be on the surface
    std::vector<int32_t> slot_of_face_;  // (4 T) index into triangles_, -1 when not on the surface
    std::vector<int32_t> face_of_slot_;  // the way back: 4 * tet + local vertex opposite
    void put(int face, const SurfaceTriangle& triangle) noexcept;
    void take(int face) noexcept;
    int count_ = 0;
    uint32_t version_ = 0;

    template <class Visit>
    friend void fields(Of<SurfaceState> auto& s, Visit&& visit) {
        auto& [tree, triangles, slot_of_face, face_of_slot, count, version] = s;
        visit.state(count, version);
        visit.state_of(count, triangles);
        visit.kept(tree, slot_of_face);
        visit.kept_of(count, face_of_slot);
    }
};

}  // namespace placode::sim
