// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Working memory of standing fluid (sim/fluid/pool.h).

#include <algorithm>
#include <cstddef>
#include <vector>

namespace placode::sim {

/// From a cell to the next one along x and y: what flowed in the last sweep [m3], written before it
/// is read; nothing of it is part of the state.
struct PoolFlux {
    std::vector<double> x, y, blood_x, blood_y;  ///< (cells)
    explicit PoolFlux(size_t cells)
        : x(cells, 0), y(cells, 0), blood_x(cells, 0), blood_y(cells, 0) {}
    /// Nothing flows.
    void clear() noexcept {
        for (std::vector<double>* all : {&x, &y, &blood_x, &blood_y})
            std::fill(all->begin(), all->end(), 0.0);
    }
};

}  // namespace placode::sim
