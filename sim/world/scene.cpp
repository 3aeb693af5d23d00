// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/scene.h"

namespace placode::sim {

Scene::Scene(SoftBody tissue) : body(std::move(tissue)), surface(body.mesh()) {
    if (!body.spec().sheet.empty()) {
        throw MeshError("sheet: " + std::to_string(body.spec().sheet.size()) +
                        " triangles in an operative scene; instruments, heat and cutting know "
                        "tetrahedra only (verification scenes take sheets)");
    }
}

}  // namespace placode::sim
