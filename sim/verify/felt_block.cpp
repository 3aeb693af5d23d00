// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/felt_block.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

constexpr int kFine = 12, kBeside = 8, kBelow = 10;  // planes of 0.1 mm, and growing ones

double graded_for_hertz(int axis, double x) {
    const double reach = axis == 2 ? 0.012 : 0.006, n = std::abs(x);
    constexpr double kEdge = 1e-4;
    if (n <= kFine) return kEdge * x;
    double outer = 0, all = 0;
    for (int i = 1; i <= (axis == 2 ? kBelow : kBeside); ++i) {
        all += std::pow(1.35, i);
        if (i <= n - kFine + 0.5) outer += std::pow(1.35, i);
    }
    return std::copysign(kEdge * kFine + (reach - kEdge * kFine) * outer / all, x);
}

Scene felt_scene(const FeltBlock& block, int substeps) {
    SoftBodySpec spec;
    spec.mesh = box_mesh(block.size_m, block.cells, Tissue::kSkin);
    double bottom = 0;
    for (Vec3& x : spec.mesh.rest) {
        x -= Vec3(block.size_m.x() / 2, block.size_m.y() / 2, block.size_m.z());
        for (int k = 0; k < 3 && block.graded != nullptr; ++k) x[k] = block.graded(k, x[k]);
        bottom = std::min(bottom, x.z());
    }
    spec.mesh = renumbered(spec.mesh, rcm_order(spec.mesh));
    Material material;
    material.youngs_modulus_pa = kFeltE;
    material.poissons_ratio = kFeltNu;
    material.density_kg_m3 = 1050;
    material.damping_per_s = 30;
    material.friction = block.friction;
    material.friction_static_ratio = 1;
    material.fail_stretch = material.injury_stretch = 100;
    spec.materials.fill(material);
    spec.solver.substeps = substeps;
    spec.solver.over_relaxation = 1;  // 1.2 makes a lattice of stiff tissue tremble
    spec.solver.gravity_m_s2.setZero();
    spec.solver.sleep = block.sleep;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v) {
        if (spec.mesh.rest[as_index(v)].z() < bottom + 1e-9) spec.fixed.push_back(v);
    }
    Scene scene{SoftBody(std::move(spec))};
    scene.id = "block";
    ToolSpec tool;
    tool.kind = ToolKind::kProbe;
    tool.tip_radius_m = tool.shaft_radius_m = block.tip_radius_m;
    tool.tip_length_m = block.tip_length_m;
    tool.length_m = block.length_m;
    tool.hand_n_m = block.hand_n_m;
    scene.tools = {tool};
    for (const Vec3& x : scene.body.mesh().rest)
        scene.field.depth_m.push_back(static_cast<float>(-x.z()));
    return scene;
}

}  // namespace

FeltBlock hertz_block() {
    FeltBlock block;
    const int beside = 2 * (kFine + kBeside);
    block.size_m = Vec3(beside, beside, kFine + kBelow);  // only numbers of planes
    block.cells = {beside, beside, kFine + kBelow};
    block.tip_radius_m = 1.5e-3;
    block.graded = graded_for_hertz;
    return block;
}

FeltBlock incline_block(double friction) {
    FeltBlock block;
    block.size_m = Vec3(4e-3, 4e-3, 2e-3);
    block.cells = {8, 8, 4};
    block.friction = friction;
    block.tip_radius_m = 50;
    block.length_m = 200;
    block.hand_n_m = 1e9;
    return block;
}

double hertz_force(double radius_m, double depth_m) {
    return 4.0 / 3 * kFeltE / (1 - kFeltNu * kFeltNu) * std::sqrt(radius_m) *
           std::pow(depth_m, 1.5);
}

FeltHand::FeltHand(const FeltBlock& block, int substeps)
    : scene_(felt_scene(block, substeps)), state_(scene_, 1) {}

Vec3 FeltHand::frame(const Vec3& tip) {
    ToolInput input;
    input.set_pose({tip, Quat(0, 1, 0, 0)});  // distal is down
    input.engaged = 1;
    const std::clock_t start = std::clock();
    (void)step(scene_, state_, {&input, 1}, {&feedback_, 1});
    cpu_s_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    ++frames_;
    return feedback_.force_n;
}

Vec3 FeltHand::press(double depth_m, double wait_s) {
    for (; tip_z_m_ > -depth_m; tip_z_m_ -= 2e-5) frame(Vec3(0, 0, tip_z_m_));
    Vec3 force = Vec3::Zero();
    for (int i = 0; i < static_cast<int>(wait_s * 1000); ++i) force = frame(Vec3(0, 0, -depth_m));
    return force;
}

double FeltHand::cost() const { return cpu_s_ / (frames_ * scene_.body.spec().solver.frame_s); }

}  // namespace placode::sim
