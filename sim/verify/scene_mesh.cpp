// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes and sheets of a verification scene, and which of their vertices an output point is.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/as_index.h"
#include "sim/core/bounds.h"
#include "sim/core/number_text.h"
#include "sim/mesh/surface.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {
namespace {

constexpr double kWeld = 1e-6;  // of the longest edge of the sheet

/// Vertices in rising x, to find the one at a place.
class PlaceIndex {
 public:
    explicit PlaceIndex(const std::vector<Vec3>& points) : points_(points), order_(points.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        std::sort(order_.begin(), order_.end(), [&](int32_t a, int32_t b) {
            return points[as_index(a)].x() != points[as_index(b)].x()
                       ? points[as_index(a)].x() < points[as_index(b)].x()
                       : a < b;
        });
    }
    /// -1 when nothing is within `reach`.
    [[nodiscard]] int32_t find(const Vec3& p, double reach) const {
        auto i =
            std::lower_bound(order_.begin(), order_.end(), p.x() - reach,
                             [&](int32_t v, double x) { return points_[as_index(v)].x() < x; });
        for (; i != order_.end() && points_[as_index(*i)].x() <= p.x() + reach; ++i) {
            if ((points_[as_index(*i)] - p).norm() <= reach) return *i;
        }
        return -1;
    }

 private:
    const std::vector<Vec3>& points_;
    std::vector<int32_t> order_;
};

double longest_edge(const SheetInput& sheet) {
    double longest = 0;
    for (const auto& t : sheet.triangles) {
        for (size_t k = 0; k < 3; ++k)
            longest = std::max(
                longest,
                (sheet.points[as_index(t[k])] - sheet.points[as_index(t[(k + 1) % 3])]).norm());
    }
    return longest;
}

/// Largest difference of vertex numbers in a tet.
int32_t span_of(const TetMesh& mesh, const std::vector<int32_t>& new_of_old) {
    int32_t span = 0;
    for (const auto& tet : mesh.tets) {
        int32_t low = new_of_old[as_index(tet[0])], high = low;
        for (const int32_t v : tet) {
            low = std::min(low, new_of_old[as_index(v)]);
            high = std::max(high, new_of_old[as_index(v)]);
        }
        span = std::max(span, high - low);
    }
    return span;
}

std::vector<int32_t> inverse(const std::vector<int32_t>& order) {
    std::vector<int32_t> out(order.size());
    for (size_t i = 0; i < order.size(); ++i) out[as_index(order[i])] = static_cast<int32_t>(i);
    return out;
}

/// Vertices along the longest axis of the mesh.
std::vector<int32_t> axis_order(const TetMesh& mesh) {
    int axis = 0;
    bounds_of(mesh.rest).sizes().maxCoeff(&axis);
    std::vector<int32_t> order(mesh.rest.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
        return mesh.rest[as_index(a)][axis] < mesh.rest[as_index(b)][axis];
    });
    return order;
}

/// RCM. In a thick body its fronts are three times as wide as the body's sections, and the kernels'
/// offsets end at 32,767: there whichever order keeps neighbours nearer.
std::vector<int32_t> near_order(const TetMesh& mesh) {
    constexpr int32_t kWide = 8192;
    std::vector<int32_t> rcm = rcm_order(mesh);
    const int32_t span = span_of(mesh, inverse(rcm));
    if (span <= kWide) return rcm;
    std::vector<int32_t> along = axis_order(mesh);
    return span_of(mesh, inverse(along)) < span ? along : rcm;
}

}  // namespace

void use_mesh(VerificationScene& scene, const TetMesh& mesh, std::vector<Vec3> output_points,
              const std::vector<int32_t>& vertex_of_output) {
    const std::vector<int32_t> order = near_order(mesh);
    const std::vector<int32_t> new_of_old = inverse(order);
    scene.mesh = renumbered(mesh, order);
    scene.output_points = std::move(output_points);
    scene.vertex_of_output = vertex_of_output;
    for (int32_t& v : scene.vertex_of_output) v = v < 0 ? -1 : new_of_old[as_index(v)];
}

void use_box(VerificationScene& scene, const Vec3& size_m, const std::array<int, 3>& cells) {
    const TetMesh box = box_mesh(size_m, cells);
    std::vector<int32_t> same(box.rest.size());
    std::iota(same.begin(), same.end(), 0);
    use_mesh(scene, box, box.rest, same);
}

SheetInput boundary_in(const VerificationScene& scene, const BoxSelection& box) {
    constexpr double kTolerance = 1e-9;  // [m], as for vertices
    SheetInput out;
    out.points = scene.mesh.rest;
    const auto inside = [&](int32_t v) {
        const Vec3& p = scene.mesh.rest[as_index(v)];
        return ((p - box.low).array() >= -kTolerance).all() &&
               ((box.high - p).array() >= -kTolerance).all();
    };
    const Surface surface(scene.mesh);
    for (const SurfaceTriangle& t : surface.rest_triangles()) {
        if (inside(t.vertex[0]) && inside(t.vertex[1]) && inside(t.vertex[2]))
            out.triangles.push_back(t.vertex);
    }
    return out;
}

void use_sheet(VerificationScene& scene, const SheetInput& sheet) {
    std::vector<SheetTriangle> triangles;
    for (const auto& t : sheet.triangles)
        triangles.push_back({t, sheet_tissue(scene.sheet_materials.size()), sheet.thickness_m});
    check_sheet(sheet.points, triangles);
    const PlaceIndex place(scene.mesh.rest);
    const double reach = kWeld * longest_edge(sheet);
    const bool alone = scene.mesh.rest.empty();
    std::vector<int32_t> vertex(sheet.points.size(), -1);
    std::vector<Vec3> fresh;
    int welded = 0;
    for (SheetTriangle& t : triangles) {
        for (int32_t& v : t.vertex) {
            const size_t p = as_index(v);
            if (vertex[p] < 0) {
                const int32_t output = sheet.output.empty() ? -1 : sheet.output[p];
                vertex[p] = output >= 0 ? scene.vertex_of_output[as_index(output)]
                                        : place.find(sheet.points[p], reach);
                welded += vertex[p] >= 0 ? 1 : 0;
                if (vertex[p] < 0) {
                    vertex[p] = static_cast<int32_t>(scene.mesh.rest.size() + fresh.size());
                    fresh.push_back(sheet.points[p]);
                    if (output >= 0) {
                        scene.vertex_of_output[as_index(output)] = vertex[p];
                    } else {
                        scene.output_points.push_back(sheet.points[p]);
                        scene.vertex_of_output.push_back(vertex[p]);
                    }
                }
            }
            v = vertex[p];
        }
    }
    if (welded == 0 && !alone && !sheet.allow_disconnected)
        throw MeshError("none of its " + std::to_string(fresh.size()) +
                        " points is a vertex of the mesh (within " + rounded_text(reach, 3) +
                        " m); expected at least one to be welded to, or "
                        "\"allow_disconnected\": true");
    scene.mesh.rest.insert(scene.mesh.rest.end(), fresh.begin(), fresh.end());
    scene.sheet.insert(scene.sheet.end(), triangles.begin(), triangles.end());
    scene.sheet_materials.push_back(sheet.material);
    check_sheet(scene.mesh.rest, scene.sheet);  // sheets among each other
}

}  // namespace placode::sim
