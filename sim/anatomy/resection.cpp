// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/resection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/portable_math.h"

namespace placode::sim {

namespace {

constexpr double kPointStep = 0.00025;  // of the outline [m]
constexpr double kAcross = 0.0006;      // where to look whether it is parted, from the line [m]
constexpr double kInside = 0.0004;      // of the outline, before tissue counts as marked [m]
constexpr double kGraspIn = 0.0010;     // the place to take hold, from the incised edge [m]

double degrees(const Vec2& p) {
    const double a = atan2_portable(p.y(), p.x()) * 180 / std::numbers::pi;
    return a < 0 ? a + 360 : a;
}

/// True when `angle` lies in the sector that begins at `from` and is `span` wide.
bool within(double angle, double from, double span) {
    double ahead = std::fmod(angle - from, 360);
    if (ahead < 0) ahead += 360;
    return ahead <= span;
}

/// Point of a closed polyline around the origin in the direction `angle`.
Vec2 at_angle(const std::vector<Vec2>& line, double angle) {
    const SineAndCosine of = sin_cos_portable(angle * std::numbers::pi / 180);
    const Vec2 ray(of.cosine, of.sine);
    const auto side = [&](const Vec2& p) { return ray.x() * p.y() - ray.y() * p.x(); };
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
        const double sa = side(a), sb = side(b);
        if ((sa < 0) == (sb < 0) || a.dot(ray) <= 0) continue;
        return a + sa / (sa - sb) * (b - a);
    }
    return line.front();
}

void append(std::vector<Vec2>& path, const Vec2& to) {
    if (path.empty()) {
        path.push_back(to);
        return;
    }
    const Vec2 from = path.back();
    const int steps = std::max(1, static_cast<int>(std::lround((to - from).norm() / kPointStep)));
    for (int i = 1; i <= steps; ++i)
        path.push_back(from + static_cast<double>(i) / steps * (to - from));
}

/// Top tet whose centroid is nearest to a point of the plane.
int32_t top_tet(const FieldMesh& field, const Vec2& p) {
    const ContourAnchor anchor = anchor_on_surface(field, p);
    int32_t best = 0;
    double nearest = 1;
    for (int32_t t = 0; t < static_cast<int32_t>(field.mesh.tets.size()); ++t) {
        const auto& c = field.mesh.tets[t];
        int shared = 0;
        for (const int32_t v : anchor.vertex) shared += std::count(c.begin(), c.end(), v) > 0;
        if (shared < 3) continue;
        Vec3 centre = Vec3::Zero();
        for (const int32_t v : c) centre += field.mesh.rest[v] / 4;
        const double d = (centre.head<2>() - p).norm();
        if (d < nearest) {
            nearest = d;
            best = t;
        }
    }
    return best;
}

Vec3 lifted(const FieldMesh& field, const ContourAnchor& a) {
    Vec3 p = Vec3::Zero();
    for (int i = 0; i < 3; ++i) p += a.weight[i] * field.mesh.rest[a.vertex[i]];
    return p;
}

}  // namespace

void mark_resection(const OperativeFieldSpec& spec, const FieldShape& shape, const FieldMesh& field,
                    Scene& scene) {
    double span = std::fmod(spec.resect_to_deg - spec.resect_from_deg, 360);
    if (span < 0) span += 360;
    if (span == 0) return;
    const double from = spec.resect_from_deg, to = from + span;
    const std::vector<Vec2> outer = shape.skin().offset(-spec.resect_margin_m);
    // Out along the first side, along the skin edge, back in, and along the incision.
    std::vector<Vec2> path;
    append(path, at_angle(shape.contour(), from));
    const double step = 1;
    for (double a = from; a < to; a += step) append(path, at_angle(outer, a));
    append(path, at_angle(outer, to));
    for (double a = to; a > from; a -= step) append(path, at_angle(shape.contour(), a));
    Resection& r = scene.resection;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& p : path) middle += p / static_cast<double>(path.size());
    const size_t n = path.size();
    for (size_t i = 0; i < n; ++i) {
        r.anchors.push_back(anchor_on_surface(field, path[i]));
        r.line.push_back(lifted(field, r.anchors.back()));
        const Vec2 along = path[(i + 1) % n] - path[(i + n - 1) % n];
        Vec2 inward = Vec2(-along.y(), along.x()).normalized();
        if (inward.dot(middle - path[i]) < 0) inward = -inward;
        r.across.push_back({top_tet(field, path[i] + kAcross * inward),
                            top_tet(field, path[i] - kAcross * inward)});
    }
    const Vec2 edge = at_angle(shape.contour(), from + span / 2);
    const Vec2 grasp = edge + kGraspIn * (at_angle(outer, from + span / 2) - edge).normalized();
    r.grasp_anchor = anchor_on_surface(field, grasp);
    r.grasp_m = lifted(field, r.grasp_anchor);

    scene.marked.assign(field.mesh.tets.size(), 0);
    for (size_t t = 0; t < field.mesh.tets.size(); ++t) {
        if (field.mesh.tissue[t] != Tissue::kZone) continue;
        Vec3 centre = Vec3::Zero();
        double to_placode = 0, to_skin = 0;
        for (const int32_t v : field.mesh.tets[t]) {
            centre += field.mesh.rest[v] / 4;
            to_placode += field.columns[field.column[v]].to_placode_m / 4;
            to_skin += field.columns[field.column[v]].to_skin_m / 4;
        }
        // Only what lies well inside: the needle takes its own width, a cut follows the mesh.
        const double turn = kInside / centre.head<2>().norm() * 180 / std::numbers::pi;
        if (!within(degrees(centre.head<2>()), from + turn, span - 2 * turn)) continue;
        if (to_placode < spec.contour_offset_m + kInside) continue;
        if (to_skin > -spec.resect_margin_m - kInside) continue;
        scene.marked[t] = 1;
        scene.marked_volume_m3 += rest_volume(field.mesh, static_cast<int>(t));
    }
}

}  // namespace placode::sim
