// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/body_pieces.h"

#include "sim/core/as_index.h"

namespace placode::sim {
BodyPieces pieces_of(const VerificationScene& scene, const std::vector<uint8_t>& held) {
    std::vector<int32_t> root(scene.mesh.rest.size());
    for (size_t v = 0; v < root.size(); ++v) root[v] = static_cast<int32_t>(v);
    const auto find = [&](int32_t v) {
        while (root[as_index(v)] != v) v = root[as_index(v)] = root[as_index(root[as_index(v)])];
        return v;
    };
    const auto join = [&](const auto& corners) {
        for (const int32_t v : corners) root[as_index(find(v))] = find(corners[0]);
    };
    for (const auto& tet : scene.mesh.tets) join(tet);
    for (const SheetTriangle& t : scene.sheet) join(t.vertex);
    BodyPieces out;
    out.of_vertex.assign(root.size(), -1);
    for (size_t v = 0; v < root.size(); ++v) {
        int32_t& number = out.of_vertex[as_index(find(static_cast<int32_t>(v)))];
        if (number < 0) {
            number = static_cast<int32_t>(out.held.size());
            out.held.push_back(0);
        }
        out.of_vertex[v] = number;
        out.held[as_index(number)] |= held[v];
    }
    return out;
}

}  // namespace placode::sim
