// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/patch_cover.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "sim/core/as_index.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr double kLatticeM = 0.00025;  // of the points of the placode that are looked at
constexpr int kWays = 30;              // to either side of straight outwards

const Vec3& patch_rest_of(const Scene& scene, int32_t v) {
    return scene.body.mesh().rest[as_index(v)];
}

/// Of the vertices in `from`, the nearest to a place in the plane; -1 where there is none.
template <class From>
int32_t nearest_rest_of(const Scene& scene, const From& from, const Vec2& place) {
    int32_t nearest = -1;
    double least2 = std::numeric_limits<double>::max();
    for (const int32_t v : from) {
        const double away2 = (patch_rest_of(scene, v).head<2>() - place).squaredNorm();
        if (away2 >= least2) continue;
        least2 = away2;
        nearest = v;
    }
    return nearest;
}

std::vector<int32_t> surface_vertices(const Scene& scene) {
    std::vector<int32_t> out;
    for (size_t v = 0; v < scene.field.depth_m.size(); ++v)
        if (!(scene.field.depth_m[v] > 0) &&
            !(scene.patch && scene.patch->owns(static_cast<int32_t>(v))))
            out.push_back(static_cast<int32_t>(v));
    return out;
}

/// Vertices with fewer than six triangles: those of the rim.
std::vector<int32_t> rim_of(const Patch& patch) {
    std::vector<int> faces(as_index(patch.vertex_count), 0);
    for (const SurfaceTriangle& t : patch.triangles)
        for (const int32_t v : t.vertex) ++faces[as_index(v - patch.first_vertex)];
    std::vector<int32_t> rim;
    for (int32_t i = 0; i < patch.vertex_count; ++i)
        if (faces[as_index(i)] < 6) rim.push_back(patch.first_vertex + i);
    return rim;
}

}  // namespace

Vec2 placode_middle(const Scene& scene) noexcept {
    Vec2 low = Vec2::Zero(), high = Vec2::Zero();
    bool first = true;
    for (const Vec3& p : scene.geometry.placode_edge) {
        low = first ? Vec2(p.head<2>()) : Vec2(low.cwiseMin(p.head<2>()));
        high = first ? Vec2(p.head<2>()) : Vec2(high.cwiseMax(p.head<2>()));
        first = false;
    }
    return 0.5 * (low + high);
}

double height_at_rest(const Scene& scene, const Vec2& place) {
    const int32_t v = nearest_rest_of(scene, surface_vertices(scene), place);
    return v < 0 ? 0 : patch_rest_of(scene, v).z();
}

PatchHandles patch_handles(const Scene& scene) {
    PatchHandles out;
    if (!scene.patch) return out;
    const std::vector<int32_t> rim = rim_of(*scene.patch);
    Vec2 middle = Vec2::Zero();
    std::vector<int32_t> all;
    for (int32_t i = 0; i < scene.patch->vertex_count; ++i) {
        all.push_back(scene.patch->first_vertex + i);
        middle += patch_rest_of(scene, all.back()).head<2>() / scene.patch->vertex_count;
    }
    out.middle = nearest_rest_of(scene, all, middle);
    // Where the line from its middle to the placode's crosses the rim.
    const Vec2 direction = (placode_middle(scene) - middle).normalized();
    double best = std::numeric_limits<double>::max();
    for (const int32_t v : rim) {
        const Vec2 from = patch_rest_of(scene, v).head<2>() - middle;
        const double aside = std::abs(direction.x() * from.y() - direction.y() * from.x());
        if (from.dot(direction) <= 0 || aside >= best) continue;
        best = aside;
        out.rim = v;
    }
    // Rows of the lattice follow each other; the first triangle leads from one to the next.
    const int32_t first = scene.patch->first_vertex, last = first + scene.patch->vertex_count - 1;
    int32_t columns = 1;  // vertices in a row
    for (const int32_t v : scene.patch->triangles.front().vertex)
        columns = std::max(columns, v - first - 1);
    out.corner = {first, first + columns - 1, last, last - columns + 1};
    return out;
}

PatchCover::PatchCover(const Scene& scene) {
    if (!scene.patch || scene.geometry.placode_edge.size() < 3) return;
    rest_ = points_of_edge(scene.geometry.placode_edge, kPatchEdgePoints);
    edge_ = rest_;
    const std::vector<int32_t> surface = surface_vertices(scene);
    for (const EdgePoint& point : rest_)
        vertex_.push_back(nearest_rest_of(scene, surface, point.at_m));
    corners_.resize(scene.patch->triangles.size());
    sheet_ = SheetCover(corners_.size());
}

void PatchCover::look(const Scene& scene, const State& state) noexcept {
    assert(there() && "no patch, or no placode");
    for (size_t i = 0; i < edge_.size(); ++i) {
        const int32_t v = vertex_[i];
        if (v < 0) continue;
        edge_[i].at_m =
            rest_[i].at_m + (position(state.body, v) - patch_rest_of(scene, v)).head<2>();
    }
    const std::vector<SurfaceTriangle>& triangles = scene.patch->triangles;
    for (size_t t = 0; t < triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k)
            corners_[t][k] = position(state.body, triangles[t].vertex[k]);
    sheet_.place(corners_);
}

std::vector<Event> PatchCover::events(const Scene& scene, const State& state) {
    std::vector<Event> out;
    if (!there()) return out;
    look(scene, state);
    const std::vector<Vec2> inside = points_within(scene.geometry.placode_edge, kLatticeM);
    const auto open = std::count_if(inside.begin(), inside.end(),
                                    [&](const Vec2& p) { return !sheet_.covers(p); });
    Event head;
    head.kind = EventKind::kPatchEdge;
    head.value = static_cast<float>(edge_.size());
    head.value2 =
        inside.empty()
            ? 0
            : static_cast<float>(static_cast<double>(open) / static_cast<double>(inside.size()));
    out.push_back(head);
    for (size_t i = 0; i < edge_.size(); ++i) {
        Event event;
        event.kind = EventKind::kPatchEdge;
        event.element = static_cast<int32_t>(i);
        event.value = static_cast<float>(
            sheet_.margin(edge_[i].at_m, edge_[i].outward, kWays, kMostOverlapM));
        set_rest_position(event, Vec3(rest_[i].at_m.x(), rest_[i].at_m.y(), 0));
        out.push_back(event);
    }
    Event fold;
    fold.kind = EventKind::kPatchFold;
    const Vec3 look = sheet_.most_look();
    double folded = 0, whole = 0;
    Vec2 where = Vec2::Zero();
    for (size_t t = 0; t < sheet_.faces(); ++t) {
        const double area = sheet_.area_m2(t), part = area * sheet_.folded(t, look);
        whole += area;
        folded += part;
        where += part * sheet_.middle(t);
    }
    fold.value = static_cast<float>(folded);
    fold.value2 = static_cast<float>(whole);
    if (folded > 0) set_rest_position(fold, Vec3(where.x() / folded, where.y() / folded, 0));
    out.push_back(fold);
    return out;
}

}  // namespace placode::sim
