// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/sac.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/solver/topology.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"
#include "sim/world/shape_version.h"

namespace placode::sim {
namespace {

constexpr double kFilm = 5e-5;     // fluid left between membrane and floor [m]
constexpr double kRousePa = 1;     // a change that the tissue is woken for
constexpr double kNoFloor = -1.0;  // [m]

Vec3 place(const State& state, int32_t vertex) noexcept {
    const Float4& x = state.body.x[as_index(vertex)];
    return {x.x, x.y, x.z};
}

bool closed(const Sac& sac, const State& state, size_t triangle) noexcept {
    const auto& tets = sac.above[triangle];
    return std::any_of(tets.begin(), tets.end(),
                       [&](int32_t t) { return state.body.tet_alive[as_index(t)] != 0; });
}

double rest_area(const Scene& scene, const std::array<int32_t, 3>& t) noexcept {
    const auto& rest = scene.body.mesh().rest;
    return (rest[as_index(t[1])] - rest[as_index(t[0])])
               .cross(rest[as_index(t[2])] - rest[as_index(t[0])])
               .norm() /
           2;
}

/// What is burned away, at its size at rest, and cuts as wide as they gape.
double open_area(const Scene& scene, const State& state) noexcept {
    const Sac& sac = scene.sac;
    double area = 0, whole = 0;
    for (size_t i = 0; i < sac.triangles.size(); ++i) {
        const double a = rest_area(scene, sac.triangles[i]);
        whole += a;
        if (!closed(sac, state, i)) area += a;
    }
    if (!state.body.topology) return area;
    const double edge = std::sqrt(2.3 * whole / static_cast<double>(sac.triangles.size()));
    const int32_t first = scene.body.vertex_count();
    for (int32_t v = first; v < state.body.topology->vertices; ++v) {
        const int32_t origin = origin_of(state.body, v);
        if (!std::binary_search(sac.vertices.begin(), sac.vertices.end(), origin)) continue;
        if (state.body.x[as_index(v)].w == 0 || state.body.x[as_index(origin)].w == 0) continue;
        area += edge * std::min(edge, (place(state, v) - place(state, origin)).norm());
    }
    return area;
}

void report_opening(const Scene& scene, State& state) noexcept {
    const Sac& sac = scene.sac;
    int32_t tet = sac.above[0][0];
    for (size_t i = 0; i < sac.triangles.size(); ++i) {
        if (!closed(sac, state, i)) tet = sac.above[i][0];
    }
    Event e = tissue_event(scene, state, EventKind::kSacOpened, tet);
    e.value = static_cast<float>(state.sac.pressure_pa);
    add_event(state, e);
}

void leak(const Scene& scene, State& state, double dt_s) noexcept {
    const SacSettings& s = scene.sac.settings;
    SacState& sac = state.sac;
    // Cuts gape more or less as the wall moves; what is empty loses nothing.
    const bool gapes = sac.hole_m2 > 0 && sac.pressure_pa > 0;
    const uint32_t shape = shape_version(state);
    if (sac.looked != shape || gapes) {
        sac.looked = shape;
        sac.hole_m2 = open_area(scene, state);
    }
    if (sac.hole_m2 > 0 && sac.opened == 0) {
        sac.opened = 1;
        report_opening(scene, state);
    }
    const double speed = std::sqrt(2 * sac.pressure_pa / s.fluid_density_kg_m3);
    const double lost = s.discharge * sac.hole_m2 * speed * dt_s;
    sac.content_m3 -= lost;
    sac.leaked_m3 += lost;
}

/// A third of the area vector of each closed triangle, for its corners; zero where it is open.
void measure_thirds(const Sac& sac, State& state) noexcept {
    auto& thirds = state.scratch->sac_thirds;
    for (size_t i = 0; i < sac.triangles.size(); ++i) {
        thirds[i] = Vec3::Zero();
        if (!closed(sac, state, i)) continue;
        const auto& t = sac.triangles[i];
        const Vec3 a = place(state, t[0]);
        thirds[i] = (place(state, t[1]) - a).cross(place(state, t[2]) - a) / 6;
    }
}

/// Pressure on the triangles around, and the floor below.
void load(const Scene& scene, State& state, size_t i) noexcept {
    const Sac& sac = scene.sac;
    const int32_t v = sac.vertices[i];
    Vec3 push = Vec3::Zero();
    for (int32_t k = sac.around_start[i]; k < sac.around_start[i + 1]; ++k) {
        push += state.scratch->sac_thirds[as_index(sac.around[as_index(k)])];
    }
    const Vec3 x = place(state, v);
    const double floor = sac.floor.at(x.x(), x.y()) + kFilm;
    const bool lies = x.z() < floor;
    const auto drag = static_cast<float>(lies ? sac.settings.floor_drag_n_m : 0);
    const auto stiff = static_cast<float>(lies ? sac.settings.floor_n_m : 0);
    const Vec3 anchor(x.x(), x.y(), floor);
    set_load(scene.body, state.body, v, (state.sac.pressure_pa * push).cast<float>(),
             Vec3f(drag, drag, stiff), anchor.cast<float>());
}

}  // namespace

double CanalFloor::at(double x, double y) const noexcept {
    const double fx = (x - x_m) / cell_m, fy = (y - y_m) / cell_m;
    const auto i = static_cast<int>(std::floor(fx)), j = static_cast<int>(std::floor(fy));
    if (i < 0 || j < 0 || i + 1 >= columns || j + 1 >= rows) return kNoFloor;
    const auto node = [&](int a, int b) {
        return static_cast<double>(height_m[static_cast<size_t>(b) * static_cast<size_t>(columns) +
                                            static_cast<size_t>(a)]);
    };
    return std::lerp(std::lerp(node(i, j), node(i + 1, j), fx - i),
                     std::lerp(node(i, j + 1), node(i + 1, j + 1), fx - i), fy - j);
}

void Sac::connect(const std::vector<uint8_t>& rim) {
    vertices.clear();
    for (const auto& t : triangles) {
        for (const int32_t v : t) {
            if (rim[as_index(v)] == 0) vertices.push_back(v);
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<std::vector<int32_t>> of(vertices.size());
    for (size_t i = 0; i < triangles.size(); ++i) {
        for (const int32_t v : triangles[i]) {
            const auto found = std::lower_bound(vertices.begin(), vertices.end(), v);
            if (found == vertices.end() || *found != v) continue;
            of[as_index(found - vertices.begin())].push_back(static_cast<int32_t>(i));
        }
    }
    around_start.assign(1, 0);
    around.clear();
    for (const auto& list : of) {
        around.insert(around.end(), list.begin(), list.end());
        around_start.push_back(static_cast<int32_t>(around.size()));
    }
}

double sac_volume(const Sac& sac, const State& state) noexcept {
    double six = 0;
    for (const auto& t : sac.triangles) {
        six += place(state, t[0]).dot(place(state, t[1]).cross(place(state, t[2])));
    }
    return six / 6;
}

void update_sac(const Scene& scene, State& state, double dt_s, bool held) noexcept {
    const Sac& sac = scene.sac;
    if (!sac.present()) return;
    SacState& s = state.sac;
    const bool leaks = s.hole_m2 > 0 && s.pressure_pa > 0;
    if (!held && s.filled != 0 && state.sleep.still() && !leaks) return;
    const double volume = sac_volume(sac, state);
    if (held || s.filled == 0) {
        s.pressure_pa = sac.settings.pressure_pa;
        s.content_m3 = volume + s.pressure_pa / sac.settings.stiffness_pa_m3;
        s.filled = held ? 0 : 1;
    } else {
        leak(scene, state, dt_s);
        s.pressure_pa = std::max(0.0, sac.settings.stiffness_pa_m3 * (s.content_m3 - volume));
    }
    if (std::abs(s.pressure_pa - s.roused_pa) > kRousePa) {
        s.roused_pa = s.pressure_pa;
        rouse_all(state.body);
    }
    measure_thirds(sac, state);
    for (size_t i = 0; i < sac.vertices.size(); ++i) load(scene, state, i);
}

}  // namespace placode::sim
