// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/mesh/surface.h"

#include <algorithm>
#include <cassert>

namespace placode::sim {

namespace {

// One side of a face: its vertices in rising order, and whose it is.
struct FaceSide {
    std::array<int32_t, 3> key{};
    int32_t face = 0;  // 4 * tet + local vertex opposite

    bool operator<(const FaceSide& other) const {
        return key != other.key ? key < other.key : face < other.face;
    }
};

std::vector<FaceSide> sorted_sides(const TetMesh& mesh) {
    std::vector<FaceSide> sides(4 * mesh.tets.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        for (int f = 0; f < 4; ++f) {
            FaceSide& side = sides[4 * t + f];
            for (int i = 0; i < 3; ++i) side.key[i] = mesh.tets[t][kTetFaces[f][i]];
            std::sort(side.key.begin(), side.key.end());
            side.face = static_cast<int32_t>(4 * t + f);
        }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

SurfaceTriangle triangle_of(const TetMesh& mesh, int face,
                            std::span<const std::array<int32_t, 4>> tets = {}) {
    SurfaceTriangle triangle;
    const int tet = face / 4, f = face % 4;
    const auto& corner = tets.empty() ? mesh.tets[tet] : tets[tet];
    for (int i = 0; i < 3; ++i) triangle.vertex[i] = corner[kTetFaces[f][i]];
    triangle.tet = tet;
    triangle.tissue = mesh.tissue[tet];
    return triangle;
}

// Sides of faces, or faces: those inside have two sides, those of the boundary one.
size_t most_slots(const Surface& surface, const TetMesh& mesh, bool can_part) {
    const size_t sides = 4 * mesh.tets.size();
    return can_part ? sides : (sides + surface.rest_triangles().size()) / 2;
}

}  // namespace

Surface::Surface(const TetMesh& mesh) : neighbours_(mesh.tets.size(), {-1, -1, -1, -1}) {
    const std::vector<FaceSide> sides = sorted_sides(mesh);
    for (size_t i = 0; i < sides.size();) {
        size_t end = i + 1;
        while (end < sides.size() && sides[end].key == sides[i].key) ++end;
        if (end - i > 2) {
            throw MeshError("face of tet " + std::to_string(sides[i].face / 4) + " is shared by " +
                            std::to_string(end - i) + " tets, allowed 1 to 2");
        }
        if (end - i == 2) {
            const int a = sides[i].face, b = sides[i + 1].face;
            neighbours_[a / 4][a % 4] = b / 4;
            neighbours_[b / 4][b % 4] = a / 4;
        }
        i = end;
    }
    // In the order of the tets, so that neighbouring triangles lie close in memory.
    for (size_t face = 0; face < 4 * mesh.tets.size(); ++face) {
        if (neighbours_[face / 4][face % 4] < 0) {
            rest_.push_back(triangle_of(mesh, static_cast<int>(face)));
        }
    }
}

SurfaceState::SurfaceState(const Surface& surface, const TetMesh& mesh, bool can_part)
    : tree_(mesh, most_slots(surface, mesh, can_part), mesh.tets.size()),
      triangles_(most_slots(surface, mesh, can_part)),
      slot_of_face_(4 * mesh.tets.size(), -1),
      face_of_slot_(triangles_.size(), -1) {
    size_t next = 0;
    for (size_t face = 0; face < slot_of_face_.size(); ++face) {
        if (surface.neighbours()[face / 4][face % 4] < 0)
            put(static_cast<int>(face), surface.rest_triangles()[next++]);
    }
}

void SurfaceState::put(int face, const SurfaceTriangle& triangle) noexcept {
    assert(slot_of_face_[face] < 0 && "face is on the surface already");
    assert(count_ < static_cast<int>(triangles_.size()) && "tets parted that cannot be");
    triangles_[count_] = triangle;
    slot_of_face_[face] = count_;
    face_of_slot_[count_] = face;
    tree_.insert(count_, triangle.tet);
    ++count_;
}

void SurfaceState::take(int face) noexcept {
    // The last triangle moves into the gap.
    const int slot = slot_of_face_[face], last = --count_;
    tree_.remove(slot);
    tree_.renumber(last, slot);
    triangles_[slot] = triangles_[last];
    face_of_slot_[slot] = face_of_slot_[last];
    slot_of_face_[face_of_slot_[slot]] = slot;
    slot_of_face_[face] = -1;
}

void SurfaceState::remove_tet(const Surface& surface, const TetMesh& mesh,
                              std::span<const uint8_t> tet_alive, int tet,
                              std::span<const std::array<int32_t, 4>> tets) noexcept {
    assert(tet_alive[tet] == 0);
    for (int f = 0; f < 4; ++f) {
        if (slot_of_face_[4 * tet + f] >= 0) {
            take(4 * tet + f);
            continue;
        }
        const int other = surface.neighbours()[tet][f];
        if (other < 0 || !tet_alive[other]) continue;
        for (int g = 0; g < 4; ++g) {
            if (surface.neighbours()[other][g] != tet || slot_of_face_[4 * other + g] >= 0)
                continue;
            SurfaceTriangle triangle = triangle_of(mesh, 4 * other + g, tets);
            triangle.fresh = 1;
            put(4 * other + g, triangle);
        }
    }
    ++version_;
}

void SurfaceState::cut_face(const Surface& surface, const TetMesh& mesh, int tet, int f,
                            std::span<const std::array<int32_t, 4>> tets) noexcept {
    assert(slot_of_face_[tet * 4 + f] < 0);
    const int other = surface.neighbours()[tet][f];
    for (int g = 0; g < 4; ++g) {
        if (surface.neighbours()[other][g] != tet) continue;
        for (const int face : {4 * tet + f, 4 * other + g}) {
            SurfaceTriangle triangle = triangle_of(mesh, face, tets);
            triangle.fresh = 1;
            put(face, triangle);
        }
    }
    ++version_;
}

void SurfaceState::follow_corners(int tet, std::span<const std::array<int32_t, 4>> tets) noexcept {
    for (int f = 0; f < 4; ++f) {
        const int slot = slot_of_face_[4 * tet + f];
        if (slot < 0) continue;
        for (int i = 0; i < 3; ++i) triangles_[slot].vertex[i] = tets[tet][kTetFaces[f][i]];
    }
}

}  // namespace placode::sim
