// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/fluid/pool.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/as_index.h"
#include "sim/core/portable_math.h"

namespace placode::sim {
namespace {

constexpr double kRestM = 1e-9;  // a depth that flows from cell to cell: less is rest
constexpr int32_t kCalmSweeps = 20;
constexpr double kLevelShare = 0.2;  // of a difference that flows in a sweep; 0.25 is the edge
// Whole blood takes 30 of 1/mm in green light, which tells red from white: planning value.
constexpr double kBloodPerM = 3e4;

/// What flows from cell a to cell b, negative the other way, and its share of the giver's volume.
struct Flow {
    double volume_m3 = 0, blood_m3 = 0;
};

Flow flow_between(const PoolGrid& grid, const Pool& pool, size_t a, size_t b) noexcept {
    const double area = grid.cell_m2();
    const double level_a = static_cast<double>(grid.ground_m[a]) + pool.volume_m3[a] / area;
    const double level_b = static_cast<double>(grid.ground_m[b]) + pool.volume_m3[b] / area;
    const size_t giver = level_a > level_b ? a : b;
    const double loose = pool.volume_m3[giver] - kFilmM * area;
    if (!(loose > 0)) return {};
    const double wish = kLevelShare * std::abs(level_a - level_b) * area;
    const double volume = std::min(wish, loose / 4);
    const double blood = pool.blood_m3[giver] * (volume / pool.volume_m3[giver]);
    const double sign = giver == a ? 1 : -1;
    return {sign * volume, sign * blood};
}

}  // namespace

double pool_level_m(const PoolGrid& grid, const Pool& pool, int32_t cell) noexcept {
    return static_cast<double>(grid.ground_m[as_index(cell)]) + pool_depth_m(grid, pool, cell);
}

void add_fluid(Pool& pool, int32_t cell, double volume_m3, double blood_m3) noexcept {
    pool.given_m3 += volume_m3;
    pool.calm = 0;
    if (cell < 0) {
        pool.run_off_m3 += volume_m3;
        return;
    }
    pool.volume_m3[as_index(cell)] += volume_m3;
    pool.blood_m3[as_index(cell)] += blood_m3;
}

void sweep_pool(const PoolGrid& grid, Pool& pool, PoolFlux& flux) noexcept {
    const auto columns = static_cast<size_t>(grid.columns), rows = static_cast<size_t>(grid.rows);
    const double film = kFilmM * grid.cell_m2();
    if (pool.calm >= kCalmSweeps) {
        if (pool.calm == kCalmSweeps) flux.clear();
        pool.calm = kCalmSweeps + 1;
        return;
    }
    double most = 0;
    for (size_t j = 0; j < rows; ++j) {
        for (size_t i = 0; i < columns; ++i) {
            const size_t c = j * columns + i;
            const bool wet = pool.volume_m3[c] > film;
            Flow x, y;
            if (i + 1 < columns && (wet || pool.volume_m3[c + 1] > film))
                x = flow_between(grid, pool, c, c + 1);
            if (j + 1 < rows && (wet || pool.volume_m3[c + columns] > film))
                y = flow_between(grid, pool, c, c + columns);
            most = std::max({most, std::abs(x.volume_m3), std::abs(y.volume_m3)});
            flux.x[c] = x.volume_m3;
            flux.blood_x[c] = x.blood_m3;
            flux.y[c] = y.volume_m3;
            flux.blood_y[c] = y.blood_m3;
        }
    }
    for (size_t j = 0; j < rows; ++j) {
        for (size_t i = 0; i < columns; ++i) {
            const size_t c = j * columns + i;
            const auto move = [&](size_t to, double volume, double blood) {
                if (volume == 0) return;
                pool.volume_m3[c] -= volume;
                pool.volume_m3[to] += volume;
                pool.blood_m3[c] -= blood;
                pool.blood_m3[to] += blood;
            };
            if (i + 1 < columns) move(c + 1, flux.x[c], flux.blood_x[c]);
            if (j + 1 < rows) move(c + columns, flux.y[c], flux.blood_y[c]);
        }
    }
    for (size_t c = 0; c < grid.cells(); ++c) {
        if (grid.drain[c] == 0 || pool.volume_m3[c] == 0) continue;
        pool.run_off_m3 += pool.volume_m3[c];
        pool.volume_m3[c] = pool.blood_m3[c] = 0;
    }
    pool.calm = most > kRestM * grid.cell_m2() ? 0 : pool.calm + 1;
}

double drain_pool(const PoolGrid& grid, Pool& pool, const Vec2& place, double radius_m,
                  double low_m, double most_m3) noexcept {
    const double film = kFilmM * grid.cell_m2();
    const int reach = static_cast<int>(std::ceil(radius_m / grid.cell_m));
    const int i0 = static_cast<int>(std::floor((place.x() - grid.x_m) / grid.cell_m)),
              j0 = static_cast<int>(std::floor((place.y() - grid.y_m) / grid.cell_m));
    const auto each = [&](const auto& visit) {
        for (int j = std::max(0, j0 - reach); j <= std::min(grid.rows - 1, j0 + reach); ++j) {
            for (int i = std::max(0, i0 - reach); i <= std::min(grid.columns - 1, i0 + reach);
                 ++i) {
                const int32_t c = j * grid.columns + i;
                const double there = pool.volume_m3[as_index(c)] - film;
                if (!(there > 0) || (grid.middle(c) - place).norm() > radius_m) continue;
                if (pool_level_m(grid, pool, c) > low_m) visit(as_index(c), there);
            }
        }
    };
    double all = 0;
    each([&](size_t, double there) { all += there; });
    if (!(all > 0)) return 0;
    const double share = std::min(1.0, most_m3 / all);
    double got = 0;
    each([&](size_t c, double there) {
        const double volume = share * there;
        pool.blood_m3[c] -= pool.blood_m3[c] * (volume / pool.volume_m3[c]);
        pool.volume_m3[c] -= volume;
        got += volume;
    });
    pool.sucked_m3 += got;
    pool.calm = 0;
    return got;
}

double standing_m3(const PoolGrid& grid, const Pool& pool) noexcept {
    const double least = kStandingM * grid.cell_m2();
    double sum = 0;
    for (const double v : pool.volume_m3)
        if (v > least) sum += v;
    return sum;
}

double stored_m3(const Pool& pool) noexcept {
    return std::accumulate(pool.volume_m3.begin(), pool.volume_m3.end(), 0.0);
}

double cell_hidden(const PoolGrid& grid, const Pool& pool, int32_t cell) noexcept {
    return 1 - exp_portable(-kBloodPerM * pool.blood_m3[as_index(cell)] / grid.cell_m2());
}

double view_hidden(const Irrigation& irrigation, const Pool& pool) noexcept {
    if (irrigation.view.empty()) return 0;
    double sum = 0;
    for (const int32_t c : irrigation.view) sum += cell_hidden(irrigation.grid, pool, c);
    return sum / static_cast<double>(irrigation.view.size());
}

}  // namespace placode::sim
