// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/field_irrigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/as_index.h"
#include "sim/core/random.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

constexpr double kDebrisApartM = 0.0013;  // between two, while there is room
constexpr double kDebrisRim = 0.92;       // of the lesion's radius: none lies on the skin
constexpr int kDebrisTries = 400;
constexpr uint64_t kDebrisSeed = 0x77617368;  // apart from what else the seed draws

/// Height of the meshed surface in the middle of every cell; cells beside it drain.
void lay_ground(const OperativeFieldSpec& spec, const FieldMesh& field, PoolGrid& grid) {
    grid.cell_m = spec.irrigation->cell_m;
    grid.columns = static_cast<int>(std::ceil(spec.domain_x_m / grid.cell_m));
    grid.rows = static_cast<int>(std::ceil(spec.domain_y_m / grid.cell_m));
    grid.x_m = -0.5 * grid.cell_m * grid.columns;
    grid.y_m = -0.5 * grid.cell_m * grid.rows;
    const size_t cells = as_index(grid.columns) * as_index(grid.rows);
    grid.ground_m.assign(cells, -1.0F);
    grid.drain.assign(cells, 1);
    for (const auto& triangle : field.plane.triangles) {
        std::array<Vec3, 3> p;
        for (size_t k = 0; k < 3; ++k) p[k] = field.columns[as_index(triangle[k])].level_m[0];
        const Vec3 low = p[0].cwiseMin(p[1]).cwiseMin(p[2]),
                   high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        const auto first = [&](double from, double edge) {
            return std::max(0, static_cast<int>(std::floor((from - edge) / grid.cell_m - 0.5)));
        };
        const Vec2 u = (p[1] - p[0]).head<2>(), v = (p[2] - p[0]).head<2>();
        const double area = u.x() * v.y() - u.y() * v.x();
        for (int j = first(low.y(), grid.y_m); j < grid.rows; ++j) {
            if (grid.y_m + grid.cell_m * (j + 0.5) > high.y()) break;
            for (int i = first(low.x(), grid.x_m); i < grid.columns; ++i) {
                const int32_t c = j * grid.columns + i;
                const Vec2 w = grid.middle(c) - p[0].head<2>();
                if (grid.middle(c).x() > high.x()) break;
                const double b = (w.x() * v.y() - w.y() * v.x()) / area,
                             a = (u.x() * w.y() - u.y() * w.x()) / area;
                if (b < 0 || a < 0 || a + b > 1) continue;
                grid.ground_m[as_index(c)] = static_cast<float>(
                    p[0].z() + b * (p[1].z() - p[0].z()) + a * (p[2].z() - p[0].z()));
                grid.drain[as_index(c)] = 0;
            }
        }
    }
    // The rim lets go of what reaches it.
    for (int32_t c = 0; c < static_cast<int32_t>(cells); ++c) {
        const int i = c % grid.columns, j = c / grid.columns;
        if (i == 0 || j == 0 || i + 1 == grid.columns || j + 1 == grid.rows)
            grid.drain[as_index(c)] = 1;
    }
}

/// Places within the lesion, even over its area, apart from each other.
std::vector<Debris> scatter(const OperativeFieldSpec& spec, const FieldShape& shape,
                            const FieldMesh& field) {
    const FieldIrrigation& in = *spec.irrigation;
    SplitMix64 random(spec.seed ^ kDebrisSeed);
    std::vector<Debris> out;
    std::vector<Vec2> places;
    const int count = in.crumbs + in.spots;
    for (int n = 0; n < count; ++n) {
        Vec2 place = Vec2::Zero();
        for (int attempt = 0; attempt < kDebrisTries; ++attempt) {
            place = Vec2(spec.skin_edge_a_m * random.uniform(-1, 1),
                         spec.skin_edge_b_m * random.uniform(-1, 1));
            const bool apart = std::all_of(places.begin(), places.end(), [&](const Vec2& other) {
                return (other - place).norm() > kDebrisApartM;
            });
            if (shape.skin().rho(place) < kDebrisRim && apart) break;
        }
        places.push_back(place);
        const ContourAnchor anchor = anchor_on_surface(field, place);
        Debris& debris = out.emplace_back();
        debris.kind = n < in.crumbs ? DebrisKind::kChar : DebrisKind::kBlood;
        debris.vertex = anchor.vertex;
        debris.weight = anchor.weight;
        debris.radius_m =
            static_cast<float>(random.uniform(0.7, 1.3) * (n < in.crumbs ? 3.5e-4 : 6e-4));
    }
    return out;
}

/// Vertices of the surface that nothing else needs a spring for.
std::vector<uint8_t> bearing_jets(const FieldMesh& field, const SoftBodySpec& body) {
    std::vector<uint8_t> out(body.mesh.rest.size(), 0);
    const Surface surface(field.mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) {
        for (const int32_t v : t.vertex)
            out[as_index(v)] = field.level[as_index(v)] < kFieldLayers ? 1 : 0;
    }
    for (const AnchorSpring& s : body.springs) out[as_index(s.vertex)] = 0;
    for (const int32_t v : body.fixed) out[as_index(v)] = 0;
    return out;
}

}  // namespace

std::optional<Irrigation> add_irrigation(const OperativeFieldSpec& spec, const FieldShape& shape,
                                         const FieldMesh& field, SoftBodySpec& body) {
    if (!spec.irrigation) return std::nullopt;
    const FieldIrrigation& in = *spec.irrigation;
    Irrigation out;
    out.jet = in.jet;
    out.suction = in.suction;
    out.law = in.law;
    out.start_m3 = in.start_m3;
    out.start_blood_m3 = in.start_blood_share * in.start_m3;
    lay_ground(spec, field, out.grid);
    for (int32_t c = 0; c < static_cast<int32_t>(out.grid.cells()); ++c) {
        if (out.grid.drain[as_index(c)] == 0 && shape.skin().rho(out.grid.middle(c)) < 1)
            out.view.push_back(c);
    }
    out.debris = scatter(spec, shape, field);
    out.bears = bearing_jets(field, body);
    for (size_t v = 0; v < out.bears.size(); ++v) {
        if (out.bears[v] != 0)
            body.springs.push_back(
                {static_cast<int32_t>(v), body.mesh.rest[v], Vec3::UnitZ(), 0, 0});
    }
    return out;
}

}  // namespace placode::sim
