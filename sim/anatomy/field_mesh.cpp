// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/field_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace placode::sim {

namespace {

constexpr int kMostTriangles = 40000;  // 480,000 tets, ten times the default

// Vertices of the columns before renumbering: number = 5 * column + level.
TetMesh extruded(const FieldShape& shape, int slit_layers, FieldMesh& field) {
    TetMesh mesh;
    for (const Vec2& p : field.plane.points) {
        field.columns.push_back(shape.column(p));
        const auto& levels = field.columns.back().level_m;
        mesh.rest.insert(mesh.rest.end(), levels.begin(), levels.end());
    }
    // The diagonal of a prism's side runs from the lower-ranked column's bottom to the other one's
    // top. Ranked by falling height, it is the shorter of the two diagonals on every slope, and
    // neighbouring prisms agree on it.
    std::vector<int32_t> by_height(field.plane.points.size()), rank(by_height.size());
    std::iota(by_height.begin(), by_height.end(), 0);
    std::stable_sort(by_height.begin(), by_height.end(), [&](int32_t a, int32_t b) {
        return field.columns[a].top_m > field.columns[b].top_m;
    });
    for (size_t i = 0; i < rank.size(); ++i) rank[by_height[i]] = static_cast<int32_t>(i);

    for (size_t triangle = 0; triangle < field.plane.triangles.size(); ++triangle) {
        std::array<int32_t, 3> t = field.plane.triangles[triangle];
        double to_placode = 0, to_skin = 0;
        Vec2 centroid = Vec2::Zero();
        for (const int32_t c : t) centroid += field.plane.points[c] / 3;
        to_placode = shape.placode().signed_distance(centroid);
        to_skin = shape.skin().signed_distance(centroid);
        std::sort(t.begin(), t.end(), [&](int32_t a, int32_t b) { return rank[a] < rank[b]; });
        const Vec2 e = field.plane.points[t[1]] - field.plane.points[t[0]];
        const Vec2 f = field.plane.points[t[2]] - field.plane.points[t[0]];
        const bool left = e.x() * f.y() - e.y() * f.x() > 0;
        for (int l = 0; l < kFieldLayers; ++l) {
            if (shape.fluid(l, to_skin)) continue;
            if (l < slit_layers && field.open[triangle]) continue;
            const Tissue tissue = shape.tissue(l, to_placode, to_skin);
            std::array<int32_t, 3> top{}, low{};
            for (int i = 0; i < 3; ++i) top[i] = kColumnVertices * t[i] + l;
            for (int i = 0; i < 3; ++i) low[i] = top[i] + 1;
            std::array<std::array<int32_t, 4>, 3> tets{{{low[0], low[1], low[2], top[2]},
                                                        {low[0], low[1], top[2], top[1]},
                                                        {low[0], top[1], top[2], top[0]}}};
            for (int k = 0; k < 3; ++k) {
                // Triangles that run clockwise after sorting mirror the prism.
                if (!left) std::swap(tets[k][2], tets[k][3]);
                mesh.tets.push_back(tets[k]);
                mesh.tissue.push_back(tissue);
            }
        }
    }
    return mesh;
}

double area_of(const std::vector<Vec2>& closed) {
    double twice = 0;
    for (size_t i = 0; i < closed.size(); ++i) {
        const Vec2 &a = closed[i], &b = closed[(i + 1) % closed.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

void open_slit(const OperativeFieldSpec& spec, const SlitOutline& outline, FieldMesh& field) {
    if (outline.empty()) {
        field.open.assign(field.plane.triangles.size(), 0);
        return;
    }
    double area = 0;
    for (const auto& t : field.plane.triangles) {
        const std::vector<Vec2> corners{field.plane.points[t[0]], field.plane.points[t[1]],
                                        field.plane.points[t[2]]};
        const bool open = outline.contains((corners[0] + corners[1] + corners[2]) / 3);
        field.open.push_back(open ? 1 : 0);
        if (open) area += area_of(corners);
    }
    // Equal where no triangle lies across a wall.
    const double wanted = area_of(outline.closed());
    if (std::abs(area - wanted) > 1e-6 * wanted)
        throw MeshError("operative field '" + spec.id +
                        "': slit.edge_m: the mesh does not follow the walls; take shorter edges "
                        "or a wider slit");
}

/// Without vertices that no tet has. `original` gets their numbers of before.
TetMesh without_orphans(const TetMesh& raw, std::vector<int32_t>& original) {
    std::vector<int32_t> number(raw.rest.size(), -1);
    for (const auto& tet : raw.tets)
        for (const int32_t v : tet) number[v] = 0;
    TetMesh mesh;
    mesh.tissue = raw.tissue;
    for (size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int32_t>(original.size());
        original.push_back(static_cast<int32_t>(v));
        mesh.rest.push_back(raw.rest[v]);
    }
    for (auto tet : raw.tets) {
        for (int32_t& v : tet) v = number[v];
        mesh.tets.push_back(tet);
    }
    return mesh;
}

void number_columns(const TetMesh& raw, FieldMesh& field) {
    std::vector<int32_t> original;
    const TetMesh used = without_orphans(raw, original);
    const std::vector<int32_t> order = rcm_order(used);
    field.mesh = renumbered(used, order);
    std::array<int32_t, kColumnVertices> none{};
    none.fill(-1);
    field.vertices.assign(field.columns.size(), none);
    for (size_t v = 0; v < order.size(); ++v) {
        field.column.push_back(original[order[v]] / kColumnVertices);
        field.level.push_back(original[order[v]] % kColumnVertices);
        field.vertices[field.column[v]][field.level[v]] = static_cast<int32_t>(v);
    }
}

/// The column at a point that the triangulation has kept.
int32_t column_at(const FieldMesh& field, const Vec2& p) {
    const auto& points = field.plane.points;
    return static_cast<int32_t>(std::find(points.begin(), points.end(), p) - points.begin());
}

}  // namespace

FieldMesh build_field_mesh(const OperativeFieldSpec& spec, const FieldShape& shape) {
    FieldMesh field;
    const SlitOutline outline = slit_outline(spec, shape);
    const std::vector<std::vector<Vec2>> curves{shape.placode().points(), shape.contour(),
                                                shape.skin().points()};
    try {
        field.plane = graded_mesh(
            Vec2(spec.domain_x_m / 2, spec.domain_y_m / 2), curves,
            [&](const Vec2& p) { return edge_near_slit(spec, p, shape.edge_length(p)); }, spec.seed,
            kMostTriangles, outline.empty() ? std::vector<Vec2>{} : outline.closed());
    } catch (const MeshError& error) {
        throw MeshError("operative field '" + spec.id + "': edge_ring_m, edge_placode_m or " +
                        "edge_outer_m: " + error.what());
    }
    open_slit(spec, outline, field);
    number_columns(extruded(shape, spec.slit ? spec.slit->layers : 0, field), field);
    check_mesh(field.mesh);
    field.slit = make_slit(spec, outline, field.mesh.rest.size(),
                           [&](const Vec2& p) { return field.vertices[column_at(field, p)]; });
    return field;
}

namespace {

// Where a point of the plane lies in the triangulation.
struct PlaneHit {
    int32_t triangle = 0;
    std::array<double, 3> weight{};
};

// Nearest triangle in the sense of the largest smallest weight: points on an edge are safe.
PlaneHit locate(const FieldMesh& field, const Vec2& p) {
    const PlanarMesh& plane = field.plane;
    PlaneHit best;
    double best_margin = -1e9;
    for (size_t t = 0; t < plane.triangles.size(); ++t) {
        if (field.open[t]) continue;
        const Vec2 &a = plane.points[plane.triangles[t][0]],
                   &b = plane.points[plane.triangles[t][1]],
                   &c = plane.points[plane.triangles[t][2]];
        if (std::max({a.x(), b.x(), c.x()}) < p.x() || std::min({a.x(), b.x(), c.x()}) > p.x() ||
            std::max({a.y(), b.y(), c.y()}) < p.y() || std::min({a.y(), b.y(), c.y()}) > p.y()) {
            continue;
        }
        const Vec2 ab = b - a, ac = c - a, ap = p - a;
        const double area = ab.x() * ac.y() - ab.y() * ac.x();
        const double wb = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
        const double wc = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
        const double margin = std::min({1 - wb - wc, wb, wc});
        if (margin > best_margin) {
            best_margin = margin;
            best = {static_cast<int32_t>(t), {1 - wb - wc, wb, wc}};
        }
    }
    return best;
}

ContourAnchor anchor_at(const FieldMesh& field, const Vec2& p) {
    const PlaneHit hit = locate(field, p);
    ContourAnchor anchor;
    for (int i = 0; i < 3; ++i) {
        anchor.vertex[i] = field.vertices[field.plane.triangles[hit.triangle][i]][0];
        anchor.weight[i] = static_cast<float>(hit.weight[i]);
    }
    return anchor;
}

Vec3 point_of(const FieldMesh& field, const ContourAnchor& anchor) {
    Vec3 p = Vec3::Zero();
    for (int i = 0; i < 3; ++i) p += anchor.weight[i] * field.mesh.rest[anchor.vertex[i]];
    return p;
}

}  // namespace

SurfaceLine laid_on_surface(const FieldMesh& field, const std::vector<Vec2>& line, int points) {
    std::vector<double> along(line.size() + 1, 0);
    const auto lifted = [&](size_t i) { return point_of(field, anchor_at(field, line[i])); };
    const Vec3 first = lifted(0);
    Vec3 previous = first;
    for (size_t i = 1; i <= line.size(); ++i) {
        const Vec3 here = i < line.size() ? lifted(i) : first;
        along[i] = along[i - 1] + (here - previous).norm();
        previous = here;
    }
    SurfaceLine out;
    size_t at = 0;
    for (int i = 0; i < points; ++i) {
        const double wanted = along.back() * i / points;
        while (along[at + 1] < wanted) ++at;
        const double share = (wanted - along[at]) / (along[at + 1] - along[at]);
        const Vec2 p = line[at] + share * (line[(at + 1) % line.size()] - line[at]);
        out.anchors.push_back(anchor_at(field, p));
        out.points.push_back(point_of(field, out.anchors.back()));
    }
    return out;
}

ContourAnchor anchor_on_surface(const FieldMesh& field, const Vec2& p) {
    return anchor_at(field, p);
}

}  // namespace placode::sim
