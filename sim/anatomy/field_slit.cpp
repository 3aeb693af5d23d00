// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/field_slit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/anatomy/planar_delaunay.h"
#include "sim/core/number_text.h"
#include "sim/core/portable_math.h"
#include "sim/mesh/mesh.h"

namespace placode::sim {
namespace {

constexpr int kArcPoints = 2000;  // of half the ellipse, from which stations are taken

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

void check_place(const OperativeFieldSpec& spec, const FieldShape& shape, const Vec2& p) {
    const auto refuse = [&](const std::string& what, double found, double allowed) {
        throw MeshError("operative field '" + spec.id + "': slit: " + what + " is " +
                        rounded_text(found, 6) + " m away, allowed at least " +
                        rounded_text(allowed, 6) + " m");
    };
    const double room = 2 * spec.edge_outer_m;
    const double to_side =
        std::min(spec.domain_x_m / 2 - std::abs(p.x()), spec.domain_y_m / 2 - std::abs(p.y()));
    if (to_side < room) refuse("the field's side", to_side, room);
    const double to_skin = shape.skin().signed_distance(p), apart = 2 * spec.slit->edge_m;
    if (to_skin < apart) refuse("the lesion's skin edge", to_skin, apart);
}

}  // namespace

std::vector<Vec2> SlitOutline::closed() const {
    // The right side from tip to tip, then the left one back.
    std::vector<Vec2> all = right;
    for (size_t i = left.size() - 1; i-- > 1;) all.push_back(left[i]);
    return all;
}

bool SlitOutline::contains(const Vec2& p) const {
    // It is convex: inside is to the left of every edge.
    const auto inside = [&](const Vec2& a, const Vec2& b) { return cross(b - a, p - a) > 0; };
    for (size_t i = 0; i + 1 < right.size(); ++i) {
        if (!inside(right[i], right[i + 1]) || !inside(left[i + 1], left[i])) return false;
    }
    return !empty();
}

SlitOutline slit_outline(const OperativeFieldSpec& spec, const FieldShape& shape) {
    SlitOutline outline;
    if (!spec.slit) return outline;
    const FieldSlit& slit = *spec.slit;
    const Vec2 half = (slit.to_m - slit.from_m) / 2, middle = slit.from_m + half;
    const Vec2 aside = Vec2(-half.y(), half.x()).normalized() * slit.width_m / 2;
    std::vector<Vec2> arc;
    for (int i = 0; i <= kArcPoints; ++i) {
        const SineAndCosine angle = sin_cos_portable(std::numbers::pi * i / kArcPoints);
        arc.emplace_back(-angle.cosine, angle.sine);
    }
    arc.front() = Vec2(-1, 0);
    arc.back() = Vec2(1, 0);
    const auto placed = [&](const Vec2& q) -> Vec2 {
        return middle + q.x() * half + q.y() * aside;
    };
    std::vector<Vec2> line;
    line.reserve(arc.size());
    for (const Vec2& q : arc) line.push_back(placed(q));
    // One side is divided, the other one is its mirror image.
    for (const Vec2& p : divided(line, false, [&](const Vec2&) { return slit.edge_m; })) {
        const Vec2 from_middle = p - middle;
        const double along = from_middle.dot(half) / half.squaredNorm();
        const double off = from_middle.dot(aside) / aside.squaredNorm();
        outline.left.push_back(on_grid(placed(Vec2(along, off))));
        outline.right.push_back(on_grid(placed(Vec2(along, -off))));
    }
    outline.right.front() = outline.left.front() = on_grid(slit.from_m);
    outline.right.back() = outline.left.back() = on_grid(slit.to_m);
    for (const Vec2& p : outline.closed()) check_place(spec, shape, p);
    return outline;
}

double edge_near_slit(const OperativeFieldSpec& spec, const Vec2& p, double edge_m) {
    if (!spec.slit) return edge_m;
    const FieldSlit& slit = *spec.slit;
    const double away =
        std::sqrt(squared_distance_to_segment(p, slit.from_m, slit.to_m)) - slit.width_m / 2;
    return std::min(edge_m, slit.edge_m + spec.edge_growth * std::max(0.0, away));
}

Slit make_slit(const OperativeFieldSpec& spec, const SlitOutline& outline, size_t vertices,
               const std::function<Slit::Column(const Vec2&)>& vertices_at) {
    Slit slit;
    if (outline.empty()) return slit;
    slit.layers = spec.slit->layers;
    slit.watertight = spec.slit->watertight;
    slit.side.assign(vertices, 0);
    for (size_t i = 1; i + 1 < outline.left.size(); ++i) {
        Slit::Station station{vertices_at(outline.left[i]), vertices_at(outline.right[i])};
        for (int level = 0; level < Slit::kMostLevels; ++level) {
            const auto k = static_cast<size_t>(level);
            if (level > slit.layers) station.left[k] = station.right[k] = -1;
            if (level >= slit.layers) continue;
            slit.side[static_cast<size_t>(station.left[k])] = 1;
            slit.side[static_cast<size_t>(station.right[k])] = -1;
        }
        slit.stations.push_back(station);
    }
    return slit;
}

}  // namespace placode::sim
