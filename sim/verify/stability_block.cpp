// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/stability_block.h"

#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"

namespace placode::sim {
namespace {

std::string describe(const BlockShape& shape) {
    if (!shape.finite) return "not finite";
    return std::to_string(shape.inverted) + " inverted tets, worst edge off by " +
           rounded_text(100 * shape.worst_edge, 3) + " %";
}

}  // namespace

SoftBodySpec block_spec(const StabilityBlock& block, Method method) {
    SoftBodySpec spec;
    TetMesh box = box_mesh(Vec3(1, 1, 1) * (kCells * kCell), {kCells, kCells, kCells});
    for (Vec3& x : box.rest) {
        x -= Vec3(1, 1, 1) * (kCells * kCell / 2);
        if (block.thin_m > 0 && x.z() > kCell / 2) x.z() -= kCell - block.thin_m;
    }
    for (size_t t = 0; t < box.tets.size(); ++t) {
        double z = 0;
        for (const int32_t v : box.tets[t]) z += box.rest[static_cast<size_t>(v)].z() / 4;
        if (z > 0) box.tissue[t] = Tissue::kMuscle;
    }
    spec.mesh = renumbered(box, rcm_order(box));
    Material m;
    m.poissons_ratio = block.poissons_ratio;
    m.damping_per_s = block.damping_per_s;
    m.fail_stretch = m.injury_stretch = 1000;
    spec.materials.fill(m);
    spec.materials[static_cast<size_t>(Tissue::kMuscle)].density_kg_m3 = block.dense_kg_m3;
    spec.solver.method = method;
    spec.solver.frame_s = block.frame_s;
    spec.solver.substeps = method == Method::kVbd ? 4 : 8;
    spec.solver.over_relaxation = 1.0;
    spec.solver.gravity_m_s2 = block.gravity;
    for (size_t v = 0; v < spec.mesh.rest.size(); ++v) {
        if (block.hold_bottom && spec.mesh.rest[v].z() < -kCells * kCell / 2 + 1e-9) {
            spec.fixed.push_back(static_cast<int32_t>(v));
        }
    }
    return spec;
}

Vec3 place_of(const SoftBodyState& state, int32_t v) {
    const Float4& x = state.x[static_cast<size_t>(v)];
    return {x.x, x.y, x.z};
}

BlockShape shape_of(const SoftBody& body, const SoftBodyState& state) {
    BlockShape shape;
    for (int t = 0; t < body.tet_count(); ++t) {
        const auto& k = body.mesh().tets[static_cast<size_t>(t)];
        Mat3 edges;
        for (int i = 1; i < 4; ++i)
            edges.col(i - 1) = place_of(state, k[i]) - place_of(state, k[0]);
        if (!edges.allFinite()) shape.finite = false;
        if (!(edges.determinant() > 0)) ++shape.inverted;
        for (int i = 1; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                const double rest = (body.mesh().rest[static_cast<size_t>(k[i])] -
                                     body.mesh().rest[static_cast<size_t>(k[j])])
                                        .norm();
                const double now = (place_of(state, k[i]) - place_of(state, k[j])).norm();
                shape.worst_edge = std::max(shape.worst_edge, std::abs(now / rest - 1));
            }
        }
    }
    return shape;
}

std::string length_text(double metres) {
    return metres < 999.5e-6 ? rounded_text(1e6 * metres, 3) + " um"
                             : rounded_text(1e3 * metres, 3) + " mm";
}

void BlockWatch::look(double time, const BlockShape& shape) {
    last_ = shape;
    if (shape.sound()) {
        if (back_ < 0) back_ = time;
    } else {
        back_ = -1;
        left_ = true;
    }
    if (!shape.finite) never_finite_ = true;
}

void BlockWatch::finish(StabilityResult& result, bool restored) const {
    result.error = last_.worst_edge;
    result.seconds = std::max(back_, 0.0);
    if (never_finite_ || back_ < 0) {
        result.verdict = StabilityVerdict::kFails;
        result.detail = never_finite_ ? "not finite" : "at the end " + describe(last_);
    } else {
        result.verdict = restored ? StabilityVerdict::kRestored
                         : left_  ? StabilityVerdict::kRecovers
                                  : StabilityVerdict::kHolds;
    }
}

}  // namespace placode::sim
