// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes of one block of tissue for the tests of the simulation: top face at z = 0, bottom held.

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/step/step.h"

namespace placode::sim::test {

struct BoxOptions {
    Vec3 size_m = Vec3(0.008, 0.008, 0.003);
    std::array<int, 3> cells{16, 16, 6};
    Tissue tissue = Tissue::kSkin;
    Material material;
    Method method = Method::kVbd;
    int substeps = 4;
    int iterations = 1;
    double over_relaxation = 1.0;  ///< 1.2 makes this lattice of stiff tissue tremble.
    Vec3 gravity = Vec3::Zero();
    bool heat = true;
    bool hold_bottom = true;
    bool sleep = true;
    int spare_vertices = 0;
    ToolSpec tool;
    /// Moves the lattice: new coordinate along `axis` (0, 1, 2) of a plane of it; empty = as it is.
    std::function<double(int axis, double x)> graded;
    /// Of a tet, by its centroid; empty = `tissue` everywhere.
    std::function<Tissue(const Vec3&)> tissue_at;
};

/// Block centred on the z axis with its top at z = 0 and one tool; depth known to the field.
inline Scene box_scene(const BoxOptions& options) {
    SoftBodySpec spec;
    spec.mesh = box_mesh(options.size_m, options.cells, options.tissue);
    for (Vec3& x : spec.mesh.rest) {
        x -= Vec3(options.size_m.x() / 2, options.size_m.y() / 2, options.size_m.z());
    }
    if (options.graded) {
        for (Vec3& x : spec.mesh.rest) {
            for (int k = 0; k < 3; ++k) x[k] = options.graded(k, x[k]);
        }
    }
    for (size_t t = 0; t < spec.mesh.tets.size() && options.tissue_at; ++t) {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : spec.mesh.tets[t]) sum += spec.mesh.rest[static_cast<size_t>(v)];
        spec.mesh.tissue[t] = options.tissue_at(sum / 4);
    }
    spec.mesh = renumbered(spec.mesh, rcm_order(spec.mesh));
    spec.materials.fill(options.material);
    spec.solver.method = options.method;
    spec.solver.substeps = options.substeps;
    spec.solver.iterations = options.iterations;
    spec.solver.over_relaxation = options.over_relaxation;
    spec.solver.gravity_m_s2 = options.gravity;
    spec.solver.sleep = options.sleep;
    spec.solver.allow_invalid = true;
    spec.spare_vertices = options.spare_vertices;
    double bottom = 0;
    for (const Vec3& x : spec.mesh.rest) bottom = std::min(bottom, x.z());
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        if (options.hold_bottom && spec.mesh.rest[v].z() < bottom + 1e-9) {
            spec.fixed.push_back(v);
        }
    }
    Scene scene{SoftBody(std::move(spec))};
    scene.id = "box";
    const TetMesh& mesh = scene.body.mesh();
    if (options.heat) scene.heat.emplace(mesh, scene.body.spec().materials, HeatSettings{});
    scene.tools = {options.tool};
    for (const Vec3& x : mesh.rest) scene.field.depth_m.push_back(static_cast<float>(-x.z()));
    return scene;
}

/// Input of a tool whose tip is at `p` and whose shaft points straight up.
inline ToolInput upright(const Vec3& p, uint8_t pedals = 0) {
    ToolInput input;
    // A half turn about x: the tool's distal z axis looks down.
    input.set_pose({p, Quat(0, 1, 0, 0)});
    input.pedals = pedals;
    input.engaged = 1;
    return input;
}

/// One frame with one tool.
inline StepReport frame(const Scene& scene, State& state, const ToolInput& input,
                        ToolFeedback& feedback) {
    return step(scene, state, {&input, 1}, {&feedback, 1});
}

}  // namespace placode::sim::test
