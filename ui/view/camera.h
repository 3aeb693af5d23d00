// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fetoscope as a pinhole camera in millimetres. Lens distortion is added by the post process.

#include <optional>

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::view {

struct Camera {
    sim::Vec3 position_mm = sim::Vec3(-22, 0, 38);
    sim::Vec3 right = sim::Vec3::UnitY(), up = sim::Vec3::UnitZ(), forward = sim::Vec3::UnitX();
    double half_angle_rad = 0.61;  ///< Half of the diagonal (circle) field of view.

    [[nodiscard]] Mat4f view_projection() const;
};

/// No hand has moved it yet: until the first input it has no place.
[[nodiscard]] bool is_nowhere(const sim::ToolSnapshot& tool);

/// From the scope among the snapshot's tools, whose axes are x right, y down, z into the picture
/// (turned down by the angle of an oblique optic). Before anybody holds the scope from where it
/// begins; a default view of the lesion when there is none.
[[nodiscard]] Camera camera_of(const sim::Snapshot& snapshot,
                               const std::vector<sim::ToolSpec>& tools);

/// Looks from `eye_mm` at `target_mm` with cranial up.
[[nodiscard]] Camera look_at(const sim::Vec3& eye_mm, const sim::Vec3& target_mm,
                             double field_of_view_deg);

/// Where the lens, with its distortion, shows a point [mm] in the round picture: its centre is the
/// origin, its radius 1, y up. Nothing behind the lens. May lie outside the round picture.
[[nodiscard]] std::optional<sim::Vec2> place_in_picture(const Camera& camera, const sim::Vec3& mm);

}  // namespace placode::view
