// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "sim/core/as_index.h"
#include "sim/fluid/pool.h"
#include "sim/fluid/tip_flow.h"
#include "sim/mesh/box_distance.h"

namespace placode::sim {
namespace {

constexpr double kMouthReachM = 0.002;  // fluid comes from so far around the mouth
constexpr double kDrinkM = 0.0009;      // and from so far below it: gas carries it up
constexpr double kTakeM = 0.0015;       // of what floats
constexpr double kPullReachM = 0.0015;  // vertices of the tissue around the mouth that it pulls
constexpr double kPullStale = 2e-4;     // boxes may be those of the frame before
constexpr double kShutS = 0.03;         // in which suction follows what lies before the mouth
constexpr int kMostPulled = 64;

/// Tissue in front of the mouth is pulled to it: p A, the less the farther it is.
void pull_tissue(const Scene& scene, State& state, int t, double shut) noexcept {
    const SuctionSpec& spec = scene.irrigation->suction;
    const ToolState& tool = state.tools[as_index(t)];
    const Vec3 spot = tool.spot, back = -(tool.proxy.q * Vec3::UnitZ());
    struct Share {
        int32_t vertex;
        double weight;
    };
    std::array<Share, kMostPulled> around{};
    size_t count = 0;
    double sum = 0;
    const auto add = [&](int32_t v) noexcept {
        const double d = (position(state.body, v) - spot).norm() / kPullReachM;
        if (d >= 1 || scene.irrigation->bears[as_index(v)] == 0) return;
        const auto known = std::span(around).first(count);
        if (count == around.size() ||
            std::any_of(known.begin(), known.end(), [v](const Share& s) { return s.vertex == v; }))
            return;
        around[count++] = {v, 1 - d * d};
        sum += 1 - d * d;
    };
    state.surface.tree().walk(
        [&](const SurfaceTree::Box& box) noexcept {
            return squared_distance(box, spot, kPullStale) >= kPullReachM * kPullReachM;
        },
        [&](int slot) noexcept {
            for (const int32_t v : state.surface.triangles()[as_index(slot)].vertex) add(v);
        });
    if (!(sum > 0)) return;
    const double mouth = std::numbers::pi / 4 * spec.bore_m * spec.bore_m;
    const Vec3 pull = shut * spec.pressure_pa * mouth / sum * back;
    for (size_t i = 0; i < count; ++i)
        load_vertex(scene, state, around[i].vertex, around[i].weight * pull);
}

}  // namespace

void run_suction(const Scene& scene, State& state, int t, double dt_s) noexcept {
    const SuctionSpec& spec = scene.irrigation->suction;
    IrrigationState& now = state.irrigation;
    const ToolState& tool = state.tools[as_index(t)];
    TipFlow& flow = now.tips[as_index(t)];
    // As of the end of the last frame.
    const double near = std::clamp(1 - tool.tip_gap_m / (spec.bore_m / 2), 0.0, 1.0);
    // Tissue and fluid need a moment: a pull that comes at once would throw tissue at the mouth.
    const double before = static_cast<double>(flow.shut);
    const double shut = before + (near * near - before) * std::min(1.0, dt_s / kShutS);
    flow.shut = static_cast<float>(shut);
    if (shut > 0) pull_tissue(scene, state, t, shut);
    const Vec3& tip = tool.proxy.p;
    const double most = (1 - shut) * spec.flow_m3_s * dt_s;
    const PoolGrid& grid = scene.irrigation->grid;
    const double got =
        most > 0 ? drain_pool(grid, now.pool, tip.head<2>(), kMouthReachM, tip.z() - kDrinkM, most)
                 : 0;
    flow.sucked = static_cast<float>(most > 0 ? got / most : 0);
    for (size_t i = 0; i < now.debris.size() && shut < 1; ++i) {
        DebrisNow& one = now.debris[i];
        if (one.fate != DebrisFate::kLoose) continue;
        if ((debris_place(scene, state, i) - tip).norm() < kTakeM) one.fate = DebrisFate::kSucked;
    }
}

}  // namespace placode::sim
