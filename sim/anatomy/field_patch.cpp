// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/field_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/contact/patch_contact.h"
#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/core/portable_math.h"

namespace placode::sim {
namespace {

constexpr double kPatchDegree = std::numbers::pi / 180;
constexpr double kPatchClear =
    1e-4;  // between the tissue and a patch that has not come down yet [m]

/// Points of the patch in a regular lattice, row by row, in the plane of the field. All diagonals
/// run the same way: so the bending energy of sheets is exact in every direction (sheet.h).
struct PatchLattice {
    int columns = 1, rows = 1;  // cells
    std::vector<Vec2> points;

    explicit PatchLattice(const FieldPatch& patch)
        : columns(std::max(1, static_cast<int>(std::lround(patch.length_m / patch.edge_m)))),
          rows(std::max(1, static_cast<int>(std::lround(patch.width_m / patch.edge_m)))) {
        const auto [s, c] = sin_cos_portable(patch.yaw_deg * kPatchDegree);
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                const double x = patch.length_m * (static_cast<double>(i) / columns - 0.5);
                const double y = patch.width_m * (static_cast<double>(j) / rows - 0.5);
                points.emplace_back(patch.centre_m.x() + c * x - s * y,
                                    patch.centre_m.y() + s * x + c * y);
            }
        }
    }
    [[nodiscard]] std::vector<std::array<int32_t, 3>> triangles(int32_t first) const {
        std::vector<std::array<int32_t, 3>> out;
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < columns; ++i) {
                const int32_t a = first + j * (columns + 1) + i, b = a + columns + 1;
                out.push_back({a, a + 1, b + 1});
                out.push_back({a, b + 1, b});
            }
        }
        return out;
    }
};

void check_patch_place(const OperativeFieldSpec& spec, const std::vector<Vec2>& points) {
    const Vec2 most =
        Vec2(spec.domain_x_m, spec.domain_y_m) / 2 - Vec2::Constant(spec.edge_outer_m);
    for (const Vec2& p : points) {
        for (int k = 0; k < 2; ++k) {
            if (std::abs(p[k]) <= most[k]) continue;
            throw MeshError("operative field '" + spec.id + "': patch.centre_m: a corner lies at " +
                            (k == 0 ? "x = " : "y = ") + rounded_text(p[k], 4) +
                            " m, outside of the field; allowed " + rounded_text(-most[k], 4) +
                            " to " + rounded_text(most[k], 4) +
                            "; move it, turn it or make it smaller");
        }
    }
}

/// The highest place of the tissue under the patch, or near it.
double highest_below(const FieldMesh& field, const std::vector<Vec2>& points, double near_m) {
    double highest = -1;
    for (size_t v = 0; v < field.level.size(); ++v) {
        if (field.level[v] != 0) continue;
        const Vec3& p = field.mesh.rest[v];
        const bool below = std::any_of(points.begin(), points.end(), [&](const Vec2& q) {
            return (q - p.head<2>()).squaredNorm() < near_m * near_m;
        });
        if (below) highest = std::max(highest, p.z());
    }
    return highest;
}

/// Vertices of the surface that nothing else needs a spring for.
std::vector<uint8_t> bearing(const FieldMesh& field, const SoftBodySpec& body) {
    std::vector<uint8_t> out(body.mesh.rest.size(), 0);
    for (size_t v = 0; v < field.mesh.rest.size(); ++v) out[v] = field.level[v] < kFieldLayers;
    for (const AnchorSpring& s : body.springs) out[as_index(s.vertex)] = 0;
    for (const int32_t v : body.fixed) out[as_index(v)] = 0;
    std::vector<uint8_t> outside(out.size(), 0);
    const Surface surface(field.mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) {
        for (const int32_t v : t.vertex) outside[as_index(v)] = 1;
    }
    for (size_t v = 0; v < out.size(); ++v) out[v] &= outside[v];
    return out;
}

}  // namespace

std::optional<Patch> add_patch(const OperativeFieldSpec& spec, const FieldMesh& field,
                               SoftBodySpec& body) {
    if (!spec.patch) return std::nullopt;
    const FieldPatch& in = *spec.patch;
    const PatchLattice lattice(in);
    check_patch_place(spec, lattice.points);
    if (std::ssize(lattice.points) > kMostPatchVertices)
        throw MeshError("operative field '" + spec.id +
                        "': patch.edge_m = " + rounded_text(in.edge_m, 6) + " makes " +
                        std::to_string(lattice.points.size()) + " vertices, allowed " +
                        std::to_string(kMostPatchVertices) + "; take longer edges");
    Patch out;
    out.first_vertex = static_cast<int32_t>(body.mesh.rest.size());
    out.vertex_count = static_cast<int32_t>(lattice.points.size());
    out.thickness_m = in.thickness_m;
    out.friction = in.friction;
    out.tool_friction = in.tool_friction;
    const double near = std::max(in.edge_m, spec.edge_outer_m);
    const double height =
        highest_below(field, lattice.points, near) + in.thickness_m / 2 + kPatchClear + in.height_m;
    for (const Vec2& p : lattice.points) body.mesh.rest.emplace_back(p.x(), p.y(), height);
    body.sheet_bending = in.bending;
    body.sheet_material = in.material;
    out.area_m2.assign(lattice.points.size(), 0.0F);
    for (const auto& t : lattice.triangles(out.first_vertex)) {
        body.sheet.push_back({t, Tissue::kDura, in.thickness_m});
        out.triangles.push_back({t, -1, Tissue::kDura, 0, {}});
        const double area = area_of(body.mesh.rest, body.sheet.back());
        for (const int32_t v : t)
            out.area_m2[as_index(v - out.first_vertex)] += static_cast<float>(area / 3);
    }
    out.bears = bearing(field, body);
    for (size_t v = 0; v < body.mesh.rest.size(); ++v) {
        if (out.bears[v] != 0 || out.owns(static_cast<int32_t>(v)))
            body.springs.push_back(
                {static_cast<int32_t>(v), body.mesh.rest[v], Vec3::UnitZ(), 0, 0});
    }
    return out;
}

}  // namespace placode::sim
