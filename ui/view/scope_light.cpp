// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/scope_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace placode::view {

using sim::Vec3;

Vec3 light_place(const Camera& camera) {
    return camera.position_mm + 2.6 * camera.up - 2.0 * camera.right;
}

void set_light(GlProgram& program, const Camera& camera, const std::vector<ShadowCapsule>& capsules,
               double time_s) {
    program.set("view_projection", camera.view_projection());
    program.set("eye", camera.position_mm);
    program.set("view_axis", camera.forward);
    program.set("light_a", light_place(camera));
    program.set("light_b", Vec3(camera.position_mm - 2.0 * camera.up + 1.5 * camera.right));
    program.set("cone_cos", static_cast<float>(std::cos(camera.half_angle_rad + 0.03)));
    program.set("time_s", static_cast<float>(time_s));
    const int count = static_cast<int>(std::min<size_t>(capsules.size(), 6));
    std::array<float, 24> a{}, b{};
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 3; ++k) {
            a[static_cast<size_t>(4 * i + k)] =
                static_cast<float>(capsules[static_cast<size_t>(i)].a[k]);
            b[static_cast<size_t>(4 * i + k)] =
                static_cast<float>(capsules[static_cast<size_t>(i)].b[k]);
        }
        a[static_cast<size_t>(4 * i + 3)] =
            static_cast<float>(capsules[static_cast<size_t>(i)].radius);
    }
    program.set_array("capsule_a", a.data(), 6);
    program.set_array("capsule_b", b.data(), 6);
    program.set("capsule_count", count);
    program.set("border_map", 0);
    program.set("vessel_map", 1);
    program.set("skin_map", 2);
    program.set("noise_map", 3);
}

}  // namespace placode::view
