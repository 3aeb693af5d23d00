// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/kernel_layout.h"

#include <Eigen/LU>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout_parts.h"

namespace placode::sim {
void check_span(int32_t first, int32_t last) {
    // Offsets are 16 bit in steps of 8 bytes.
    if (last - first > 32767) {
        throw MeshError("vertices " + std::to_string(first) + " and " + std::to_string(last) +
                        " are worked on together but more than 32767 apart; expected RCM order, "
                        "a coarser mesh or one of smaller cross-section");
    }
}

Mat3 rest_stretch(const SoftBodySpec& spec, int tet) noexcept {
    if (spec.rest_scale.empty()) return Mat3::Identity();
    const double plane = spec.rest_scale[as_index(tet)][0],
                 normal = spec.rest_scale[as_index(tet)][1];
    if (spec.rest_normal.empty()) return Vec3(plane, plane, normal).asDiagonal();
    const Vec3 n = spec.rest_normal[as_index(tet)].cast<double>();
    return plane * Mat3::Identity() + (normal - plane) * n * n.transpose();
}

TetConstants tet_constants(const SoftBodySpec& spec, int t) {
    std::array<Vec3, 4> rest;
    for (size_t k = 0; k < 4; ++k)
        rest[k] = spec.mesh.rest[as_index(spec.mesh.tets[as_index(t)][k])];
    return tet_constants(spec, t, rest);
}

TetConstants tet_constants(const SoftBodySpec& spec, int t,
                           const std::array<Vec3, 4>& rest) noexcept {
    const auto i = static_cast<size_t>(t);
    const Mat3 scale = rest_stretch(spec, t);
    Mat3 dm;
    for (int k = 0; k < 3; ++k) dm.col(k) = scale * (rest[as_index(k) + 1] - rest[0]);
    const Mat3 inverse = dm.inverse();  // rows are the gradients of corners 1, 2, 3
    std::array<Vec3, 4> gradient;
    gradient[0].setZero();
    for (int k = 0; k < 3; ++k) {
        gradient[as_index(k) + 1] = inverse.row(k).transpose();
        gradient[0] -= gradient[as_index(k) + 1];
    }
    TetConstants out;
    for (size_t a = 0; a < 4; ++a) {
        for (size_t b = a + 1; b < 4; ++b)
            out.a[as_index(kEdge[a][b])] = -gradient[a].dot(gradient[b]);
    }
    out.volume_m3 = dm.determinant() / 6;
    const Material& m = spec.materials[static_cast<size_t>(spec.mesh.tissue[i])];
    const double percent = spec.stiffness_percent.empty() ? 100.0 : spec.stiffness_percent[i];
    out.material = neo_hookean(m.youngs_modulus_pa * percent / 100, m.poissons_ratio);
    return out;
}

KernelLayout pack(const SoftBody& body) {
    KernelLayout out;
    pack_vertices(body, out);
    if (body.spec().solver.method != Method::kVbd) pack_tets(body, out);
    give_back_slack(out);
    return out;
}

void give_back_slack(KernelLayout& packed) {
    packed.batches.shrink_to_fit();
    packed.strip.shrink_to_fit();
    packed.keep.shrink_to_fit();
    packed.springs.shrink_to_fit();
    packed.tether_start.shrink_to_fit();
    packed.tet_batches.shrink_to_fit();
    packed.tet_index.shrink_to_fit();
    packed.tet_rows.shrink_to_fit();
}

AlignedVector<float> initial_lanes(const SoftBody& body, const KernelLayout& packed) {
    AlignedVector<float> lanes(as_index(packed.lane_count), 0.0F);
    for (int t = 0; t < body.tet_count(); ++t) {
        const TetConstants k = tet_constants(body.spec(), t);
        const double six_v = 6 * k.volume_m3;
        for (size_t corner = 0; corner < 4 && has_strips(packed); ++corner) {
            const size_t row = as_index(packed.corner_lane[4 * as_index(t) + corner]);
            const double sign = packed.corner_sign[as_index(t)] >> corner & 1 ? -1 : 1;
            lanes[row] = static_cast<float>(k.material.lambda_pa * k.volume_m3 / (six_v * six_v));
            lanes[row + kLanes] = static_cast<float>(sign * six_v * k.material.gamma);
        }
        if (!packed.tet_slot.empty()) {
            lanes[as_index(packed.tet_lane_start + packed.tet_slot[as_index(t)])] =
                static_cast<float>(k.material.mu_pa * k.volume_m3);
        }
    }
    for (int v = 0; v < body.vertex_count(); ++v) {
        set_vertex_weights(body, packed, {}, v, lanes.data());
    }
    return lanes;
}

}  // namespace placode::sim
