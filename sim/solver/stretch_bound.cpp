// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/stretch_bound.h"

#include <algorithm>

#include "sim/core/float_lanes.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

// Of tr C and of what it is compared with. The terms of tr C are larger than the sum by the square
// of one over the tet's quality: seven times their rounding at a quality of 0.05.
constexpr float kMargin = 1e-3F;

struct Point {
    FloatLanes x, y, z;
};

Point operator-(const Point& a, const Point& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
FloatLanes dot(const Point& a, const Point& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point cross(const Point& a, const Point& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Against the mesh at rest: the modulus, and the volume of the stress-free shape.
struct Scale {
    float stiffness = 1, volume = 1;
};

Scale scale_of(const SoftBodySpec& spec, size_t tet) noexcept {
    Scale out;
    if (!spec.stiffness_percent.empty()) out.stiffness = 0.01F * spec.stiffness_percent[tet];
    if (!spec.rest_scale.empty()) {
        const auto& s = spec.rest_scale[tet];
        out.volume = s[0] * s[0] * s[1];
    }
    return out;
}

}  // namespace

StretchLimits::StretchLimits(const MaterialTable& materials) noexcept {
    for (size_t t = 0; t < kTissueCount; ++t) {
        const Material& m = materials[t];
        stretch[t] = static_cast<float>(std::min(m.injury_stretch, m.fail_stretch));
        mu_pa[t] = static_cast<float>(m.youngs_modulus_pa / (2 * (1 + m.poissons_ratio)));
    }
}

uint32_t surely_below(const SoftBody& body, const SoftBodyState& state,
                      std::span<const int32_t> tets, const StretchLimits& limits) noexcept {
    std::array<Point, 4> x;
    std::array<FloatLanes, 6> weight;
    FloatLanes mu_v, six_v, s;
    const float* weights = packed_of(body, state).edge_weight_n_m.data();
    for (size_t i = 0; i < kStretchGroup; ++i) {
        const auto t = static_cast<size_t>(tets[std::min(i, tets.size() - 1)]);
        const auto& c = corners(body, state, static_cast<int>(t));
        for (size_t k = 0; k < 4; ++k) {
            const Float4& p = state.x[static_cast<size_t>(c[k])];
            x[k].x[i] = p.x;
            x[k].y[i] = p.y;
            x[k].z[i] = p.z;
        }
        for (size_t e = 0; e < 6; ++e) weight[e][i] = weights[6 * t + e];
        const auto tissue = static_cast<size_t>(body.mesh().tissue[t]);
        const Scale scale = scale_of(body.spec(), t);
        const float volume = scale.volume * rest_volume_of(body, state, static_cast<int>(t));
        mu_v[i] = limits.mu_pa[tissue] * scale.stiffness * volume;
        six_v[i] = 6 * volume;
        s[i] = limits.stretch[tissue];
    }
    // tr C in edge form, see kernel_layout.h.
    FloatLanes trace = {};
    for (size_t i = 0; i < 4; ++i) {
        for (size_t j = i + 1; j < 4; ++j) {
            const Point edge = x[j] - x[i];
            trace += weight[static_cast<size_t>(kEdge[i][j])] * dot(edge, edge);
        }
    }
    const FloatLanes j = dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / six_v;
    const FloatLanes one = every_lane(1);
    const FloatLanes least = s * s + 2 * j / s;
    const auto below = trace * (one + kMargin) < mu_v * (one - kMargin) * least;
    // Inverted or swollen tets are looked at closely.
    const auto sound = j > every_lane(kMargin) && j * (one + kMargin) < s * s * s;
    uint32_t bits = 0;
    for (size_t i = 0; i < tets.size(); ++i) bits |= below[i] && sound[i] ? 1U << i : 0U;
    return bits;
}

}  // namespace placode::sim
