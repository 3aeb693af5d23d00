// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Puffs of smoke as soft discs that face the lens, the farthest first.

#include <vector>

#include "ui/view/camera.h"
#include "ui/view/smoke.h"

namespace placode::view {

class SmokeRenderer {
 public:
    SmokeRenderer();
    [[nodiscard]] GlProgram& program() { return program_; }
    /// Over what was drawn; the program is in use and knows the light.
    void draw(const std::vector<Puff>& puffs, const Camera& camera);

 private:
    GlProgram program_{"smoke_vertex", "smoke"};
    GlMesh mesh_;
};

}  // namespace placode::view
