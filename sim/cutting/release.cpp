// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/release.h"

#include <algorithm>

#include "sim/core/healthy_skin.h"
#include "sim/core/portable_math.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/linked_tets.h"
#include "sim/solver/topology.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

// Sectors to either side in which a path may run: 35 degrees are 1.8 mm at the narrowest, some
// three edges of the mesh; a narrower wedge would miss paths that are there.
constexpr int kSectorsAside = 3;
constexpr double kNearLine = 0.0014;  // around a point of the outline [m]

bool counts_for_release(Tissue t) noexcept {
    return t == Tissue::kPlacode || t == Tissue::kZone || is_skin(t);
}

/// True while every link of the path that was found last still holds.
bool holds(const Scene& scene, const State& state, const PieceSearch::Path& path) noexcept {
    for (int i = 0; i < path.count; ++i) {
        if (!state.body.tet_alive[path.tet[i]]) return false;
        bool linked = i == 0;
        for (int f = 0; f < 4 && !linked; ++f) {
            linked = linked_across(scene, state, path.tet[i], f) == path.tet[i - 1];
        }
        if (!linked) return false;
    }
    return path.count > 0;
}

/// Remembers how `t` was reached; a path that is too long is not remembered.
void remember(PieceSearch& search, PieceSearch::Path& path, int32_t t) noexcept {
    path.count = 0;
    for (; t >= 0; t = search.reached_by[t]) {
        if (path.count == PieceSearch::kLongestPath) {
            path.count = 0;
            return;
        }
        path.tet[path.count++] = t;
    }
}

/// True when no path leads from the placode in sector `s` to the skin within s - 3 .. s + 3.
bool sector_free(const Scene& scene, State& state, int s) noexcept {
    PieceSearch& search = state.scratch->pieces;
    PieceSearch::Path& path = search.path[s];
    if (holds(scene, state, path)) return false;
    const uint32_t stamp = ++search.sector_stamp;
    const auto& tissue = scene.body.mesh().tissue;
    auto& seen = search.sector_seen;
    auto& queue = state.scratch->sector_stack;  // breadth first: the path found is a short one
    int end = 0;
    for (int i = search.sector_start[s]; i < search.sector_start[s + 1]; ++i) {
        const int32_t t = search.sector_tets[i];
        if (tissue[t] != Tissue::kPlacode || !state.body.tet_alive[t]) continue;
        seen[t] = stamp;
        search.reached_by[t] = -1;
        queue[end++] = t;
    }
    for (int next = 0; next < end; ++next) {
        const int32_t t = queue[next];
        if (is_skin(tissue[t])) {
            remember(search, path, t);
            return false;
        }
        for_linked(
            scene, state, t, [&](int32_t other) noexcept { return seen[other] == stamp; },
            [&](int32_t other) noexcept {
                if (!counts_for_release(tissue[other])) return;
                const int away =
                    (search.sector_of_tet[other] - s + kSectors + kSectorsAside) % kSectors;
                if (away > 2 * kSectorsAside) return;
                seen[other] = stamp;
                search.reached_by[other] = t;
                queue[end++] = other;
            });
    }
    return true;
}

}  // namespace

void update_release(const Scene& scene, State& state) noexcept {
    ReleaseProgress& r = state.release;
    const int s = r.next;
    r.next = (r.next + 1) % kSectors;
    if (r.checked[s] == state.surface.version()) return;
    r.checked[s] = state.surface.version();
    if (r.free[s] || !sector_free(scene, state, s)) return;
    r.free[s] = 1;  // what is free stays free
    ++r.free_count;
    Event e;
    e.time_s = state.time_s;
    e.kind = EventKind::kSectorFree;
    e.tissue = Tissue::kPlacode;
    e.value = static_cast<float>(s);
    e.value2 = static_cast<float>(r.free_count);
    add_event(state, e);
}

namespace {

/// True when no path leads from one side of the outline to the other in the neighbourhood.
bool parted(const Scene& scene, State& state, const Vec3& where, int32_t from,
            int32_t to) noexcept {
    const auto& alive = state.body.tet_alive;
    if (!alive[from] || !alive[to]) return true;
    PieceSearch& search = state.scratch->pieces;
    const uint32_t stamp = ++search.sector_stamp;
    auto& stack = state.scratch->sector_stack;
    int top = 0;
    search.sector_seen[from] = stamp;
    stack[top++] = from;
    while (top > 0) {
        const int32_t t = stack[--top];
        if (t == to) return false;
        for_linked(
            scene, state, t,
            [&](int32_t other) noexcept { return search.sector_seen[other] == stamp; },
            [&](int32_t other) noexcept {
                if (!counts_for_release(scene.body.mesh().tissue[other])) return;
                if ((rest_centroid(scene, other) - where).squaredNorm() > kNearLine * kNearLine)
                    return;
                search.sector_seen[other] = stamp;
                stack[top++] = other;
            });
    }
    return true;
}

}  // namespace

void update_outline(const Scene& scene, State& state) noexcept {
    ResectionProgress& r = state.resection;
    const auto points = static_cast<int32_t>(r.cut.size());
    if (points == 0) return;
    const int i = r.next;
    r.next = (r.next + 1) % points;
    if (r.checked[i] == state.surface.version()) return;
    r.checked[i] = state.surface.version();
    const auto& sides = scene.resection.across[i];
    if (r.cut[i] || !parted(scene, state, scene.resection.line[i], sides[0], sides[1])) return;
    r.cut[i] = 1;
    ++r.cut_count;
}

int sector_of(const Vec3& rest) noexcept {
    double angle = atan2_portable(rest.y(), rest.x()) * 180 / 3.14159265358979323846;
    if (angle < 0) angle += 360;
    return std::min(kSectors - 1, static_cast<int>(angle / 5));
}

}  // namespace placode::sim
