// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A block that is cut along the faces of its tets and worked at with one grasper.

#include <functional>
#include <vector>

#include "sim/cutting/cutting.h"
#include "sim/cutting/separation.h"
#include "sim/world/add_event.h"
#include "tests/box_scene.h"

namespace placode::sim::test {

using Inside = std::function<bool(const Vec3&)>;

/// Soft tissue that can be cut, with a grasper over it.
inline BoxOptions grasped_block(const Vec3& size_m, const std::array<int, 3>& cells) {
    BoxOptions options;
    options.size_m = size_m;
    options.cells = cells;
    options.tissue = Tissue::kZone;
    options.material.youngs_modulus_pa = 10000;
    options.material.damping_per_s = 60;
    options.material.fail_stretch = options.material.injury_stretch = 100;
    options.gravity = Vec3(0, 0, -9.81);
    options.heat = false;
    options.spare_vertices = 2000;
    options.tool.kind = ToolKind::kGrasper;
    options.tool.tip_radius_m = 0.0005;
    options.tool.tip_length_m = 0.010;
    options.tool.hand_n_m = 1e7;
    options.tool.pivot_m = Vec3(0, 0, 0.080);
    return options;
}

struct CutField {
    CutField(Scene made, int threads) : scene(std::move(made)), state(scene, threads) {}

    /// Parts every face between tets inside and outside of a region at rest, but where it hangs.
    void cut_out(
        const Inside& inside, const Inside& hangs = [](const Vec3&) { return false; }) {
        for (int t = 0; t < scene.body.tet_count(); ++t) {
            const Vec3 here = rest_centroid(scene, t);
            if (!state.body.tet_alive[static_cast<size_t>(t)] || !inside(here) || hangs(here))
                continue;
            for (int f = 0; f < 4; ++f) {
                const int other =
                    scene.surface.neighbours()[static_cast<size_t>(t)][static_cast<size_t>(f)];
                if (other >= 0 && !inside(rest_centroid(scene, other)))
                    cut_face(scene, state, t, f);
            }
        }
    }
    void run(const Vec3& tip_m, double jaw_rad, int frames) {
        ToolInput input = upright(tip_m);
        input.jaw_rad = static_cast<float>(jaw_rad);
        for (int i = 0; i < frames; ++i) {
            frame(scene, state, input, feedback);
            for (int e = 0; e < state.event_count; ++e) events.push_back(state.events[e]);
        }
    }

    Scene scene;
    State state;
    ToolFeedback feedback;
    std::vector<Event> events;
};

}  // namespace placode::sim::test
