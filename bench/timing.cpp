// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/timing.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "assessment/statistics.h"

namespace placode::bench {

Rates measure_rates(const Plan& plan, const std::function<void(int)>& run) {
    using Clock = std::chrono::steady_clock;
    run(std::max(1, plan.substeps / 4));
    std::vector<double> rates;
    for (int i = 0; i < plan.runs; ++i) {
        const auto start = Clock::now();
        run(plan.substeps);
        rates.push_back(plan.substeps /
                        std::chrono::duration<double>(Clock::now() - start).count());
    }
    const auto [slowest, fastest] = std::minmax_element(rates.begin(), rates.end());
    return {assessment::median_of(rates), *slowest, *fastest};
}

sim::SoftBody slab(sim::Method method, const std::array<int, 3>& cells_mm) {
    sim::SoftBodySpec spec;
    const sim::Vec3 size = 1e-3 * sim::Vec3(cells_mm[0], cells_mm[1], cells_mm[2]);
    const sim::TetMesh box = sim::box_mesh(size, cells_mm);
    spec.mesh = sim::renumbered(box, sim::rcm_order(box));
    spec.solver.method = method;
    spec.solver.substeps = 8;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        const double x = spec.mesh.rest[static_cast<size_t>(v)].x();
        if (x < 1e-9 || x > size.x() - 1e-9) spec.fixed.push_back(v);
    }
    return sim::SoftBody(std::move(spec));
}

const char* method_name(sim::Method method) {
    switch (method) {
        case sim::Method::kXpbd:
            return "xpbd";
        case sim::Method::kXpbdPair:
            return "xpbd_pair";
        case sim::Method::kVbd:
            return "vbd";
    }
    return "?";
}

double log_slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(x.size());
    for (size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    for (size_t i = 0; i < x.size(); ++i) {
        const double dx = std::log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (std::log(y[i]) - mean_y);
    }
    return xx > 0 ? xy / xx : 0;
}

}  // namespace placode::bench
