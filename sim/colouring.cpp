// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/colouring.h"

#include <algorithm>

namespace placode::sim {
namespace {

std::vector<std::vector<int32_t>> tets_by_vertex(const TetMesh& mesh) {
    std::vector<std::vector<int32_t>> out(mesh.rest.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const int32_t v : mesh.tets[t]) {
            out[static_cast<size_t>(v)].push_back(static_cast<int32_t>(t));
        }
    }
    return out;
}

/// Smallest colour whose mark in `taken` is not `stamp`; `taken` grows by what is marked.
int32_t first_free(const std::vector<int32_t>& taken, int32_t stamp) {
    int32_t colour = 0;
    while (static_cast<size_t>(colour) < taken.size() &&
           taken[static_cast<size_t>(colour)] == stamp) {
        ++colour;
    }
    return colour;
}

void mark(std::vector<int32_t>& taken, int32_t colour, int32_t stamp) {
    if (colour < 0) return;
    if (taken.size() <= static_cast<size_t>(colour)) {
        taken.resize(static_cast<size_t>(colour) + 1, -1);
    }
    taken[static_cast<size_t>(colour)] = stamp;
}

}  // namespace

std::vector<int32_t> colour_vertices(const TetMesh& mesh, const std::vector<uint8_t>& skip) {
    const auto around = tets_by_vertex(mesh);
    std::vector<int32_t> colour(mesh.rest.size(), -1), taken;
    for (size_t v = 0; v < colour.size(); ++v) {
        if (!skip.empty() && skip[v] != 0) continue;
        const auto stamp = static_cast<int32_t>(v);
        for (const int32_t t : around[v]) {
            for (const int32_t other : mesh.tets[static_cast<size_t>(t)]) {
                mark(taken, colour[static_cast<size_t>(other)], stamp);
            }
        }
        colour[v] = first_free(taken, stamp);
    }
    return colour;
}

}  // namespace placode::sim
