// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/spring_sums.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "sim/core/as_index.h"

namespace placode::sim {

SpringSums::SpringSums(const SoftBody& body, KernelLayout& packed) {
    of_.assign(as_index(body.vertex_count()), -1);
    for (const AnchorSpring& s : body.spec().springs) {
        int32_t& slot = of_[as_index(s.vertex)];
        if (slot < 0) {
            slot = static_cast<int32_t>(k_.size());
            k_.push_back(Mat3::Zero());
            f_.push_back(Vec3::Zero());
        }
        const Vec3 n = s.normal.normalized();
        const Mat3 k =
            s.tangent_n_m * Mat3::Identity() + (s.normal_n_m - s.tangent_n_m) * n * n.transpose();
        // The kernels measure from the float image of the rest position.
        const Vec3 rest = body.mesh().rest[as_index(s.vertex)].cast<float>().cast<double>();
        k_[as_index(slot)] += k;
        f_[as_index(slot)] += k * (rest - s.anchor);
    }
    for (int v = 0; v < body.vertex_count(); ++v) {
        const int32_t slot = of_[as_index(v)];
        if (slot >= 0 && !k_[as_index(slot)].isZero(0)) packed.spring_vertices.push_back(v);
    }
}

void SpringSums::add(const SoftBody& body, VertexBatch& b, KernelLayout& packed) const {
    const bool any = std::any_of(b.vertex.begin(), b.vertex.begin() + b.count,
                                 [&](int32_t v) { return holds(v); });
    if (!any) return;
    b.spring_start = static_cast<int64_t>(packed.springs.size());
    packed.springs.resize(packed.springs.size() + kSpringRows * kLanes, 0.0F);
    for (size_t lane = 0; lane < as_index(b.count); ++lane) {
        const int32_t slot = of_[as_index(b.vertex[lane])];
        if (slot < 0) continue;
        const Mat3& k = k_[as_index(slot)];
        const Vec3& f = f_[as_index(slot)];
        const Vec3 rest = body.mesh().rest[as_index(b.vertex[lane])];
        // The mu part is isotropic, so m/h^2 + sum w + the least spring bounds every pivot.
        const double least = std::max(0.0, k.selfadjointView<Eigen::Lower>().eigenvalues()[0]);
        const std::array<double, kSpringRows> rows{k(0, 0), k(0, 1),  k(0, 2),  k(1, 1),  k(1, 2),
                                                   k(2, 2), rest.x(), rest.y(), rest.z(), f.x(),
                                                   f.y(),   f.z(),    least};
        for (size_t r = 0; r < kSpringRows; ++r) {
            packed.springs[as_index(b.spring_start) + kLanes * r + lane] =
                static_cast<float>(rows[r]);
        }
    }
}

}  // namespace placode::sim
