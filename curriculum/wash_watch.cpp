// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/wash_watch.h"

#include "sim/fluid/pool.h"

namespace placode::curriculum {

using sim::DebrisFate;
using sim::Vec3;

WashNow look_at_wash(const sim::Scene& scene, const sim::State& state) noexcept {
    WashNow now;
    if (!scene.irrigation) return now;
    const sim::IrrigationState& fluid = state.irrigation;
    Vec3 tip = Vec3::Zero();
    for (size_t i = 0; i < scene.tools.size(); ++i)
        if (scene.tools[i].kind == sim::ToolKind::kIrrigator && state.tools[i].engaged != 0)
            tip = state.tools[i].proxy.p;
    double nearest_stuck = 1, nearest_loose = 1;
    Vec3 loose = Vec3::Zero();
    for (size_t i = 0; i < fluid.debris.size(); ++i) {
        now.sight.debris += 1;
        const DebrisFate fate = fluid.debris[i].fate;
        if (fate != DebrisFate::kStuck && fate != DebrisFate::kLoose) continue;
        const bool stuck = fate == DebrisFate::kStuck;
        (stuck ? now.sight.stuck : now.sight.loose) += 1;
        const Vec3 place = debris_place(scene, state, i);
        const double away = (place - tip).head<2>().norm();
        double& nearest = stuck ? nearest_stuck : nearest_loose;
        if (away >= nearest) continue;
        nearest = away;
        (stuck ? now.stuck_m : loose) = place;
    }
    const sim::PoolGrid& grid = scene.irrigation->grid;
    const auto cells = static_cast<int32_t>(grid.cells());
    double deepest = sim::kStandingM;
    for (int32_t c = 0; c < cells; ++c) {
        const double depth = sim::pool_depth_m(grid, fluid.pool, c);
        if (depth <= sim::kStandingM) continue;
        now.sight.standing_m3 += fluid.pool.volume_m3[static_cast<size_t>(c)];
        if (depth <= deepest) continue;
        deepest = depth;
        now.fluid = true;
        now.fluid_m << grid.middle(c), sim::pool_level_m(grid, fluid.pool, c);
    }
    // Fluid first; the last crumbs where they lie.
    if (now.sight.standing_m3 <= assessment::kDryM3 && now.sight.loose > 0) {
        now.fluid = true;
        now.fluid_m = loose;
    }
    return now;
}

void WashWatch::show(sim::PracticeGoal& goal) const noexcept {
    const bool wash = goal.step.kind == sim::PracticeKind::kWash;
    goal.targets = 0;
    if (wash ? now_.sight.stuck <= 0 : !now_.fluid) return;
    goal.target_m[0] = wash ? now_.stuck_m : now_.fluid_m;
    goal.targets = 1;
}

}  // namespace placode::curriculum
