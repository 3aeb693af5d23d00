// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/closing_tension.h"

#include <algorithm>
#include <cassert>

#include "sim/contact/slit_gap.h"
#include "sim/core/as_index.h"
#include "sim/step/pull_vertices.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

/// Levels of a wall that are skin: what a suture takes.
int skin_levels(const Slit& slit) noexcept { return std::min(slit.layers, 3); }

}  // namespace

std::vector<double> station_lengths(const Scene& scene) {
    const int stations = static_cast<int>(scene.slit.stations.size());
    std::vector<double> lengths;
    for (int i = 0; i < stations; ++i) {
        double length_m = 0;
        for (const int other : {i - 1, i + 1}) {
            if (other < 0 || other >= stations) continue;
            length_m += 0.5 * (middle_at_rest(scene, i) - middle_at_rest(scene, other)).norm();
        }
        lengths.push_back(length_m);
    }
    return lengths;
}

ClosingTension closing_tension(const Scene& scene, State& state) {
    assert(scene.slit.present());
    const std::vector<Slit::Station>& stations = scene.slit.stations;
    const auto levels = as_index(skin_levels(scene.slit));
    std::vector<PulledVertex> pulled;
    std::vector<Vec3> out;  // of each station, from right to left
    for (size_t i = 0; i < stations.size(); ++i) {
        const auto& rest = scene.body.mesh().rest;
        const Vec3 middle = middle_at_rest(scene, static_cast<int>(i));
        Vec3 across = rest[as_index(stations[i].left[0])] - rest[as_index(stations[i].right[0])];
        across.z() = 0;
        across.normalize();
        out.push_back(across);
        for (size_t k = 0; k < levels; ++k) {
            for (const int32_t v : {stations[i].left[k], stations[i].right[k]}) {
                const Vec3 at = position(state.body, v);
                pulled.push_back({v, at - across * across.dot(at - middle)});
            }
        }
    }
    const std::vector<Vec3> force_n = pull_vertices(scene, state, pulled);
    const std::vector<double> length_m = station_lengths(scene);
    ClosingTension tension;
    double sum_n = 0, sum_m = 0;
    size_t next = 0;
    for (size_t i = 0; i < stations.size(); ++i) {
        double pull_n = 0;
        for (size_t k = 0; k < levels; ++k) {
            pull_n += 0.5 * force_n[next++].dot(out[i]);  // left
            pull_n -= 0.5 * force_n[next++].dot(out[i]);  // right
        }
        tension.at_station.push_back(length_m[i] > 0 ? pull_n / length_m[i] : 0);
        sum_n += pull_n;
        sum_m += length_m[i];
    }
    tension.n_per_m = sum_m > 0 ? sum_n / sum_m : 0;
    return tension;
}

}  // namespace placode::sim
