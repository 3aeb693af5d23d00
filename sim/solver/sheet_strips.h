// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the kernel sees a sheet: for every vertex the fan of its triangles, one after the other round
// the vertex, 16 vertices side by side. Internal to the solver.
//
// A step of the fan is a triangle (v, a, b) with the triangle beyond its far edge (a, b, o) and the
// two vertices p, q beyond that one's other edges: what the bending energy of both depends on. `a`
// is the `b` of the step before, and so is the triangle before the edge (v, a), so that a step
// loads four positions and each angle at the vertex is taken once. Lengths are in units of a power
// of two next to the mean edge: whatever units a scene is in, squares of areas fit into a float.
//
// Where a triangle lies beyond several edges of a vertex's fan (the fourth side of a tetrahedron),
// what it couples between these edges is left out of the Hessian; the gradient is whole.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/aligned_vector.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Constants of a step, a row of 16 floats each: cos and sin of the four rest angles (edges va, ab,
/// ao, ob); the bending matrix of (v, a, b) for the edges va, ab, bv, with what the far triangle
/// adds to ab, ab, and what it couples with ao and ob [J]; the membrane [J], r2 in units of length.
enum SheetRow : int {
    kSpokeCos,
    kSpokeSin,
    kRimCos,
    kRimSin,
    kFirstCos,
    kFirstSin,
    kSecondCos,
    kSecondSin,
    kBend00,
    kBend01,
    kBend02,
    kBend11,
    kBend12,
    kBend22,
    kRimFirst,
    kRimSecond,
    kEdgeA,
    kEdgeB,
    kAreaScale,
    kPressure,
    kStiffening,
    kSheetRows
};
inline constexpr int kSheetPoints = 4;  ///< Of a step: b, o, p, q.

/// 16 vertices of one colour, and what goes round them.
struct SheetBatch {
    int32_t batch = 0;  ///< Of KernelLayout::batches.
    int32_t steps = 0;  ///< Of the longest fan.
    int64_t start = 0;  ///< Steps before this batch; each batch has one more, for the last edge.
};

struct SheetStrips {
    std::vector<SheetBatch> batches;
    std::vector<int32_t> colour_start;  ///< Colour c owns batches [colour_start[c], .. [c + 1]).
    AlignedVector<uint32_t> entry;      ///< (batches x 2 x 16): vertex before the first a, and a
    AlignedVector<uint32_t> index;      ///< (steps x 4 x 16) 2 vertex: byte offset / 8 of a Float4.
    AlignedVector<float> rows;          ///< (steps x kSheetRows x 16)
    float per_length = 1;               ///< Units of length a metre.
    bool bends = false;
};

/// The fans of all vertices of a sheet.
class SheetFans {
 public:
    explicit SheetFans(const SoftBody& body);

    /// Steps of the fan of a vertex; 0 = no vertex of the sheet.
    [[nodiscard]] int steps(int32_t vertex) const;
    /// Vertices that must not move at the same time as `vertex`, ascending.
    [[nodiscard]] std::vector<int32_t> around(int32_t vertex) const;
    /// Appends a batch: the fans of `members`, at most 16 vertices of one colour.
    void add(const std::vector<int32_t>& members, int32_t batch, SheetStrips& out) const;
    [[nodiscard]] bool bends() const { return bends_; }
    [[nodiscard]] float per_length() const { return static_cast<float>(per_length_); }

 private:
    /// A triangle as seen from its vertex v: b, o, p, q and the constants.
    struct Step {
        std::array<int32_t, kSheetPoints> point{};
        std::array<float, kSheetRows> row{};
    };
    struct Fan {
        int32_t before = 0, first = 0;
        std::vector<Step> steps;  // the last one only ends the fan
    };
    [[nodiscard]] Fan fan_of(int32_t vertex) const;
    void append(int32_t vertex, const std::vector<std::array<int32_t, 3>>& ring, bool closed,
                Fan& out) const;
    [[nodiscard]] Step step_of(int32_t v, int32_t a, int32_t b, int32_t triangle) const;
    void set_bending(Step& step, int32_t v, int32_t a, int32_t b, int32_t triangle) const;
    void set_angle(Step& step, int row, const std::array<int32_t, 4>& hinge) const;
    [[nodiscard]] int32_t beyond(int32_t triangle, int32_t a, int32_t b) const;

    const SoftBody& body_;
    SheetElements elements_;
    std::vector<std::array<int32_t, 3>> neighbour_;  // triangle beyond each edge, -1 = none
    double per_length_ = 1;
    bool bends_ = false;
};

}  // namespace placode::sim
