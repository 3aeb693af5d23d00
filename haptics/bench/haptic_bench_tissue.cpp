// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/bench/haptic_bench_tissue.h"

#include <algorithm>
#include <cmath>

namespace placode::haptics {

namespace {

constexpr double kSubstepS = 2.5e-4;  // as in the default field

sim::Scene block(const sim::ToolSpec& tool, double youngs_modulus_pa, double frame_s) {
    const sim::Vec3 size(0.008, 0.008, 0.003);
    sim::SoftBodySpec spec;
    spec.mesh = sim::box_mesh(size, {12, 12, 5}, sim::Tissue::kSkin);
    for (sim::Vec3& x : spec.mesh.rest) x -= sim::Vec3(size.x() / 2, size.y() / 2, size.z());
    spec.mesh = sim::renumbered(spec.mesh, sim::rcm_order(spec.mesh));
    sim::Material material;
    material.youngs_modulus_pa = youngs_modulus_pa;
    material.poissons_ratio = 0.45;
    spec.materials.fill(material);
    spec.solver.method = sim::Method::kVbd;
    spec.solver.frame_s = frame_s;
    spec.solver.substeps = std::max(1, static_cast<int>(std::lround(frame_s / kSubstepS)));
    spec.solver.over_relaxation = 1.0;
    spec.solver.gravity_m_s2 = sim::Vec3::Zero();
    spec.solver.allow_invalid = true;
    for (int v = 0; v < static_cast<int>(spec.mesh.rest.size()); ++v)
        if (spec.mesh.rest[static_cast<size_t>(v)].z() < -size.z() + 1e-9) spec.fixed.push_back(v);
    sim::Scene scene{sim::SoftBody(std::move(spec))};
    scene.id = "port bench";
    scene.tools = {tool};
    for (const sim::Vec3& x : scene.body.mesh().rest)
        scene.field.depth_m.push_back(static_cast<float>(-x.z()));
    return scene;
}

}  // namespace

struct HapticBenchTissue::Impl {
    sim::Scene scene;
    sim::State state;
    Impl(const sim::ToolSpec& tool, double modulus, double frame_s)
        : scene(block(tool, modulus, frame_s)), state(scene, 1) {}
};

HapticBenchTissue::HapticBenchTissue(const sim::ToolSpec& tool, double youngs_modulus_pa,
                                     double frame_s)
    : impl_(std::make_unique<Impl>(tool, youngs_modulus_pa, frame_s)) {}
HapticBenchTissue::~HapticBenchTissue() = default;
HapticBenchTissue::HapticBenchTissue(HapticBenchTissue&&) noexcept = default;
HapticBenchTissue& HapticBenchTissue::operator=(HapticBenchTissue&&) noexcept = default;

void HapticBenchTissue::frame(const sim::ToolInput& input, sim::ToolFeedback& feedback) {
    (void)sim::step(impl_->scene, impl_->state, {&input, 1}, {&feedback, 1});
}

}  // namespace placode::haptics
