// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where instruments lie in the round picture: their edges are the hard ones, and only there is it
// worth the time to smooth them.

#include <vector>

#include "sim/step/snapshot.h"
#include "ui/view/camera.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {

/// In the round picture: its centre is the origin, its radius 1, y up.
struct PictureBox {
    sim::Vec2 low = sim::Vec2::Zero(), high = sim::Vec2::Zero();
};

/// Capsules of the instruments that can throw a shadow into the picture: the light stands beside
/// the lens, so that it falls close to where the instrument is seen.
[[nodiscard]] std::vector<ShadowCapsule> seen_capsules(const sim::Snapshot& snapshot,
                                                       const std::vector<sim::ToolSpec>& tools,
                                                       const Camera& camera);

/// Boxes around what is seen of the instruments, a little wider.
[[nodiscard]] std::vector<PictureBox> tool_boxes(const sim::Snapshot& snapshot,
                                                 const std::vector<sim::ToolSpec>& tools,
                                                 const Camera& camera);

}  // namespace placode::view
