// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/field_sac.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace placode::sim {

namespace {

constexpr int kUnderside = 2;           // level below the wall of two layers
constexpr double kFloorCell = 0.00025;  // [m]
constexpr float kNowhere = -1.0F;       // [m]

CanalFloor make_floor(const OperativeFieldSpec& spec, const FieldShape& shape) {
    CanalFloor floor;
    floor.cell_m = kFloorCell;
    // The wobble may stretch both axes.
    const double reach = 1 + 3 * spec.wobble;
    floor.x_m = -reach * spec.skin_edge_a_m;
    floor.y_m = -reach * spec.skin_edge_b_m;
    floor.columns = static_cast<int>(std::ceil(-2 * floor.x_m / kFloorCell)) + 1;
    floor.rows = static_cast<int>(std::ceil(-2 * floor.y_m / kFloorCell)) + 1;
    for (int j = 0; j < floor.rows; ++j) {
        for (int i = 0; i < floor.columns; ++i) {
            const Vec2 p(floor.x_m + i * kFloorCell, floor.y_m + j * kFloorCell);
            const bool inside = shape.skin().rho(p) < 1;
            floor.height_m.push_back(inside ? static_cast<float>(shape.column(p).level_m[3].z())
                                            : kNowhere);
        }
    }
    return floor;
}

}  // namespace

Sac make_sac(const OperativeFieldSpec& spec, const FieldShape& shape, const FieldMesh& field) {
    assert(spec.cystic);
    Sac sac;
    sac.settings = spec.sac;
    // Tets of the wall by the columns they stand in: those of one prism have corners in the same
    // three columns, in the two upper layers.
    std::map<std::array<int32_t, 3>, std::vector<int32_t>> wall;
    for (size_t t = 0; t < field.mesh.tets.size(); ++t) {
        const auto& corners = field.mesh.tets[t];
        std::vector<int32_t> columns;
        bool upper = true;
        for (const int32_t v : corners) {
            upper = upper && field.level[v] <= kUnderside;
            columns.push_back(field.column[v]);
        }
        if (!upper) continue;
        std::sort(columns.begin(), columns.end());
        columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
        wall[{columns[0], columns[1], columns[2]}].push_back(static_cast<int32_t>(t));
    }
    std::vector<uint8_t> rim(field.mesh.rest.size(), 0);
    for (const std::array<int32_t, 3>& t : field.plane.triangles) {
        Vec2 centroid = Vec2::Zero();
        for (const int32_t c : t) centroid += field.plane.points[c] / 3;
        if (shape.skin().signed_distance(centroid) >= 0) {
            for (const int32_t c : t) rim[field.vertices[c][kUnderside]] = 1;
            continue;
        }
        std::array<int32_t, 3> sorted = t;
        std::sort(sorted.begin(), sorted.end());
        std::array<int32_t, 3> triangle{};
        for (int i = 0; i < 3; ++i) triangle[i] = field.vertices[t[i]][kUnderside];
        sac.triangles.push_back(triangle);
        const std::vector<int32_t>& tets = wall.at(sorted);
        std::array<int32_t, 6> above{};
        std::copy_n(tets.begin(), above.size(), above.begin());
        sac.above.push_back(above);
    }
    sac.connect(rim);
    sac.floor = make_floor(spec, shape);
    return sac;
}

}  // namespace placode::sim
