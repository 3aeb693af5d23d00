// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/scene.h"

namespace placode::sim {

Scene::Scene(SoftBody tissue, std::optional<Patch> sheet)
    : body(std::move(tissue)), surface(body.mesh()), patch(std::move(sheet)) {
    const size_t triangles = body.spec().sheet.size();
    if (triangles != (patch ? patch->triangles.size() : 0)) {
        throw MeshError("sheet: " + std::to_string(triangles) +
                        " triangles in an operative scene that are no patch; instruments, heat and "
                        "cutting know tetrahedra only (verification scenes take sheets)");
    }
}

}  // namespace placode::sim
