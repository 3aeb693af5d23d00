// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A tree of boxes around the deforming surface. Its shape is that of the tets at rest and never
// changes: a triangle lives in the leaf of the tet behind it, wherever that tet has gone, so that
// cutting only moves triangles between lists and nothing is ever rebuilt. Boxes are refitted from
// the present positions, bottom-up. Answers are exact whatever the leaf of a triangle: a bad leaf
// costs time only.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/fields.h"
#include "sim/core/float4.h"
#include "sim/mesh/mesh.h"

namespace placode::sim {

struct SurfaceTriangle;
class Workers;

/// Nodes in depth-first order; the first child follows its parent.
class SurfaceTree {
 public:
    /// For triangles of tets [0, mesh.tets.size()); room for `capacity` triangles and
    /// `tet_capacity` tets (at least those of the mesh).
    SurfaceTree(const TetMesh& mesh, size_t capacity, size_t tet_capacity);

    /// Triangle `slot` of `tet` has come, has gone, has got another number.
    void insert(int slot, int tet) noexcept;
    void remove(int slot) noexcept;
    void renumber(int from, int to) noexcept;

    /// Boxes from the present positions. Sum over the leaves: every triangle is read once.
    void refit(std::span<const SurfaceTriangle> triangles, std::span<const Float4> x) noexcept;
    /// The same boxes from fewer reads: only leaves where `moves` (by node) is not 0 or was not at
    /// the last call, and those that got or lost triangles, are looked at. Every branch is a job.
    void refit(std::span<const SurfaceTriangle> triangles, std::span<const Float4> x,
               std::span<const uint8_t> moves, Workers& workers) noexcept;
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(boxes_.size()); }
    [[nodiscard]] int leaf_of(int tet) const noexcept { return leaf_of_tet_[tet]; }

    struct Box {
        std::array<float, 4> low{}, high{};  ///< [m]; the fourth is padding.

        template <class Visit>
        friend void fields(Of<Box> auto& s, Visit&& visit) {
            auto& [low, high] = s;
            visit.kept(low, high);
        }
    };
    [[nodiscard]] const Box& bounds() const noexcept { return boxes_[0]; }
    [[nodiscard]] bool empty() const noexcept { return count_[0] == 0; }

    /// Calls `leave_out(box)` on nodes from the root; where it says false, goes on, and calls
    /// `visit(slot)` for every triangle of the leaves reached. Order: that of the tree, and within
    /// a leaf that of the lists.
    template <class LeaveOut, class Visit>
    void walk(LeaveOut&& leave_out, Visit&& visit) const noexcept {
        const int nodes = static_cast<int>(boxes_.size());
        for (int n = 0; n < nodes;) {
            if (count_[n] == 0 || leave_out(boxes_[n])) {
                n = after_[n];
                continue;
            }
            if (after_[n] == n + 1) {
                for (int32_t s = first_[n]; s >= 0; s = next_[s]) visit(s);
            }
            ++n;
        }
    }

 private:
    int build(const std::vector<Vec3>& centroid, std::vector<int32_t>& order, int first, int last,
              int parent);
    void fit(int node, std::span<const SurfaceTriangle> triangles,
             std::span<const Float4> x) noexcept;

    void refit_range(int first, int last, std::span<const SurfaceTriangle> triangles,
                     std::span<const Float4> x, std::span<const uint8_t> moves) noexcept;

    std::vector<Box> boxes_;
    std::vector<int32_t> after_;   // node behind the whole branch; n + 1 = leaf
    std::vector<int32_t> parent_;  // -1 at the root
    std::vector<int32_t> count_;   // triangles in the branch
    std::vector<int32_t> first_;   // of the list of a leaf, -1 = none
    std::vector<int32_t> leaf_of_tet_;
    std::vector<int32_t> leaf_, next_, previous_;  // by slot
    int32_t used_ = 0;                             // slots that were ever in use: [0, used_)
    std::vector<uint8_t> pending_;  // by node: 1 = the box may be wrong whatever moves
    std::vector<uint8_t> moved_;    // by node: `moves` of the last refit
    std::vector<uint8_t> fresh_;    // by node: fitted in this refit
    std::vector<int32_t> branch_;  // first nodes of the branches that make up the tree below crown_
    std::vector<int32_t> crown_;   // nodes above the branches

    template <class Visit>
    friend void fields(Of<SurfaceTree> auto& s, Visit&& visit) {
        auto& [boxes, after, parent, count, first, leaf_of_tet, leaf, next, previous, used, pending,
               moved, fresh, branch, crown] = s;
        visit.kept(boxes, count, first, used, pending, moved);
        visit.kept_of(used, leaf);
        visit.kept_of(used, next);
        visit.kept_of(used, previous);
        visit.constant(after, parent, leaf_of_tet, fresh, branch, crown);
    }
};
template <>
inline constexpr bool kPlainBytes<SurfaceTree::Box> = true;

}  // namespace placode::sim
