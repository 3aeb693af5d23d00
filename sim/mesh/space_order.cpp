// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh/space_order.h"

#include <algorithm>
#include <array>

namespace placode::sim {
namespace {

constexpr uint32_t kBits = 10;

/// Skilling's transform from the axes to the transposed index.
uint32_t key_of(std::array<uint32_t, 3> x) {
    for (uint32_t q = 1U << (kBits - 1); q > 1; q >>= 1) {
        const uint32_t p = q - 1;
        for (uint32_t& axis : x) {
            if ((axis & q) != 0) {
                x[0] ^= p;
            } else {
                const uint32_t t = (x[0] ^ axis) & p;
                x[0] ^= t;
                axis ^= t;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    uint32_t t = 0;
    for (uint32_t q = 1U << (kBits - 1); q > 1; q >>= 1) {
        if ((x[2] & q) != 0) t ^= q - 1;
    }
    for (uint32_t& axis : x) axis ^= t;
    uint32_t key = 0;
    for (uint32_t bit = kBits; bit-- > 0;) {
        for (const uint32_t axis : x) key = key << 1 | (axis >> bit & 1);
    }
    return key;
}

}  // namespace

std::vector<uint32_t> hilbert_keys(const std::vector<Vec3>& points) {
    std::vector<uint32_t> keys;
    if (points.empty()) return keys;
    Vec3 low = points.front(), high = low;
    for (const Vec3& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double size = (high - low).maxCoeff();
    const double scale = size > 0 ? ((1U << kBits) - 1) / size : 0;
    keys.reserve(points.size());
    for (const Vec3& p : points) {
        std::array<uint32_t, 3> cell{};
        for (Eigen::Index k = 0; k < 3; ++k)
            cell[static_cast<size_t>(k)] = static_cast<uint32_t>((p[k] - low[k]) * scale);
        keys.push_back(key_of(cell));
    }
    return keys;
}

}  // namespace placode::sim
