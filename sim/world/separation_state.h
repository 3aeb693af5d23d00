// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Vertices that a cut has touched and that may have to part.
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"

namespace placode::sim {

struct Scene;

/// Vertices to look at again. Sized once.
struct SeparationQueue {
    explicit SeparationQueue(const Scene& scene);
    std::vector<int32_t> vertex;   // (V + spares) ring
    std::vector<uint8_t> waiting;  // (V + spares)
    int32_t head = 0, count = 0;
};
template <class Visit>
void fields(Of<SeparationQueue> auto& s, Visit&& visit) {
    auto& [vertex, waiting, head, count] = s;
    visit.state(vertex, waiting, head, count);
}

}  // namespace placode::sim
