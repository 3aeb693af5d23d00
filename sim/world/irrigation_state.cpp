// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/irrigation_state.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

IrrigationState::IrrigationState(const Scene& scene) {
    if (!scene.irrigation) return;
    const Irrigation& irrigation = *scene.irrigation;
    pool.volume_m3.assign(irrigation.grid.cells(), 0);
    pool.blood_m3.assign(irrigation.grid.cells(), 0);
    // What stands there from the start: level in the lowest cells, found from below.
    std::vector<int32_t> order = irrigation.view;
    const auto ground = [&](int32_t c) {
        return static_cast<double>(irrigation.grid.ground_m[as_index(c)]);
    };
    std::sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
        return ground(a) != ground(b) ? ground(a) < ground(b) : a < b;
    });
    double level = order.empty() ? 0 : ground(order[0]), left = irrigation.start_m3;
    for (size_t n = 1; n <= order.size() && left > 0; ++n) {
        const double area = static_cast<double>(n) * irrigation.grid.cell_m2();
        const double room = n < order.size() ? area * (ground(order[n]) - level) : left;
        level += std::min(room, left) / area;
        left -= std::min(room, left);
    }
    for (const int32_t c : order) {
        if (irrigation.start_m3 <= 0 || ground(c) >= level) break;
        const double volume = (level - ground(c)) * irrigation.grid.cell_m2();
        pool.volume_m3[as_index(c)] = volume;
        pool.blood_m3[as_index(c)] = irrigation.start_blood_m3 * volume / irrigation.start_m3;
        pool.given_m3 += volume;
    }
    debris.resize(irrigation.debris.size());
    const auto bearing = std::count(irrigation.bears.begin(), irrigation.bears.end(), 1);
    loaded.assign(static_cast<size_t>(bearing), -1);
    listed.resize(irrigation.bears.size());
    load_n.resize(irrigation.bears.size());
    told_n.resize(irrigation.bears.size());
}

Vec3 debris_place(const Scene& scene, const State& state, size_t number) noexcept {
    const DebrisNow& now = state.irrigation.debris[number];
    const Irrigation& irrigation = *scene.irrigation;
    const double x = static_cast<double>(now.at_m[0]), y = static_cast<double>(now.at_m[1]);
    const int32_t cell = irrigation.grid.cell_at(x, y);
    if (now.fate != DebrisFate::kStuck && cell >= 0) {
        const auto c = as_index(cell);
        return {x, y,
                static_cast<double>(irrigation.grid.ground_m[c]) +
                    state.irrigation.pool.volume_m3[c] / irrigation.grid.cell_m2()};
    }
    const Debris& debris = irrigation.debris[number];
    Vec3 p = Vec3::Zero();
    for (size_t k = 0; k < 3; ++k)
        p += static_cast<double>(debris.weight[k]) * position(state.body, debris.vertex[k]);
    return p;
}

}  // namespace placode::sim
