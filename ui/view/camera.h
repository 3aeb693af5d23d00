// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fetoscope as a pinhole camera in millimetres. Lens distortion is added by the post process.

#include "sim/step/snapshot.h"
#include "ui/view/gl_program.h"

namespace placode::sim {

struct Camera {
    Vec3 position_mm = Vec3(-22, 0, 38);
    Vec3 right = Vec3::UnitY(), up = Vec3::UnitZ(), forward = Vec3::UnitX();
    double half_angle_rad = 0.61;  ///< Half of the diagonal (circle) field of view.

    [[nodiscard]] Mat4f view_projection() const;
};

/// From the scope among the snapshot's tools, whose axes are x right, y down, z into the picture
/// (turned down by the angle of an oblique optic); a default view of the lesion when there is none.
[[nodiscard]] Camera camera_of(const Snapshot& snapshot, const std::vector<ToolSpec>& tools);

/// Looks from `eye_mm` at `target_mm` with cranial up.
[[nodiscard]] Camera look_at(const Vec3& eye_mm, const Vec3& target_mm, double field_of_view_deg);

}  // namespace placode::sim
