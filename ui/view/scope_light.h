// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The light of the fetoscope, a ring of fibres round the lens, and what it falls on: uniforms that
// every program of the world takes (shaders/shared.glsl).

#include <vector>

#include "ui/view/camera.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

/// Of the brighter side of the fibre ring [mm].
[[nodiscard]] sim::Vec3 light_place(const Camera& camera);

/// Camera, light, shadows of the instruments, and units of the maps. The program is in use.
/// @param capsules the first six throw shadows.
void set_light(GlProgram& program, const Camera& camera, const std::vector<ShadowCapsule>& capsules,
               double time_s);

}  // namespace placode::view
