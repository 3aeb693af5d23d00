// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines drawn on the tissue: the planned incision where the trainee wants help, and the outline of
// tissue that is to come out, which is ink and always there.

#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/camera.h"

namespace placode::view {

class MarkRenderer {
 public:
    MarkRenderer();
    [[nodiscard]] GlProgram& program() { return program_; }
    /// Takes the points of a picture. False when there is nothing to draw.
    /// @param contour with the planned incision.
    [[nodiscard]] bool follow(const sim::Snapshot& snapshot, const Camera& camera, bool contour);
    /// @param size of the picture [px]. The program is in use and knows the light.
    void draw(int size);

 private:
    GlProgram program_{"guide_vertex", "guide"};
    GlMesh mesh_;
    std::vector<float> points_;
};

}  // namespace placode::view
