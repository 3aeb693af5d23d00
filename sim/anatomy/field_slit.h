// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A wound in the skin beside the lesion, to be sewn up: an ellipse from tip to tip, open from the
// start, whose walls the mesh follows.

#include <array>
#include <functional>
#include <vector>

#include "sim/anatomy/field_shape.h"
#include "sim/world/slit.h"

namespace placode::sim {

/// In the plane [m]. Both tips belong to both sides; the points in between stand opposite.
struct SlitOutline {
    std::vector<Vec2> left, right;

    [[nodiscard]] bool empty() const noexcept { return left.empty(); }
    /// All of them, counter-clockwise.
    [[nodiscard]] std::vector<Vec2> closed() const;
    [[nodiscard]] bool contains(const Vec2& p) const;
};

/// Nothing without a slit. @throws MeshError where it reaches the lesion or the sides.
[[nodiscard]] SlitOutline slit_outline(const OperativeFieldSpec& spec, const FieldShape& shape);

/// `edge_m`, finer towards the slit.
[[nodiscard]] double edge_near_slit(const OperativeFieldSpec& spec, const Vec2& p, double edge_m);

/// `vertices_at(p)`: the vertices below a point of the outline, surface first.
[[nodiscard]] Slit make_slit(const OperativeFieldSpec& spec, const SlitOutline& outline,
                             size_t vertices,
                             const std::function<Slit::Column(const Vec2&)>& vertices_at);

}  // namespace placode::sim
