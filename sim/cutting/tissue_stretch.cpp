// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/tissue_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "sim/cutting/cutting.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr size_t kMostNear = 512;  // tets of a neighbourhood; the nearest are found first

/// Largest eigenvalue of a symmetric positive matrix: Newton on the characteristic polynomial from
/// an upper bound, where it runs down monotonically. Plain arithmetic gives the same bits on every
/// processor; the trigonometric closed form does not.
double largest_eigenvalue(const Mat3& m) noexcept {
    const double mean = m.trace() / 3;
    const Mat3 d = m - mean * Mat3::Identity();
    const double half = d.squaredNorm() / 2, det = d.determinant();
    double x = std::sqrt(4 * half / 3);  // bound: x^3 - half x - det >= 0 from here on
    for (int i = 0; i < 40 && x > 0; ++i) {
        const double slope = 3 * x * x - half;
        if (!(slope > 0)) break;
        const double next = x - (x * x * x - half * x - det) / slope;
        if (!(next < x)) break;
        x = next;
    }
    return mean + x;
}

/// Root of a symmetric positive matrix by Denman and Beavers' iteration (1976), again in plain
/// arithmetic. Converges quadratically: stretches of 0.2 to 5 are exact to 1e-9 after these steps.
Mat3 root_of(const Mat3& m) noexcept {
    constexpr int kSteps = 8;
    Mat3 root = m, inverse = Mat3::Identity();
    for (int i = 0; i < kSteps; ++i) {
        const Mat3 next = 0.5 * (root + inverse.inverse());
        inverse = 0.5 * (inverse + root.inverse()).eval();
        root = next;
    }
    return root;
}

Vec3 centre_at_rest(const Scene& scene, const State& state, int tet) noexcept {
    Vec3 sum = Vec3::Zero();
    for (const int32_t v : corners(scene.body, state.body, tet))
        sum += rest_place(scene.body, state.body, v);
    return sum / 4;
}

}  // namespace

Mat3 cauchy_green(const Scene& scene, const State& state, int tet) noexcept {
    const auto& c = corners(scene.body, state.body, tet);
    Mat3 rest, now;
    for (int i = 0; i < 3; ++i) {
        rest.col(i) =
            rest_place(scene.body, state.body, c[i + 1]) - rest_place(scene.body, state.body, c[0]);
        now.col(i) = position(state.body, c[i + 1]) - position(state.body, c[0]);
    }
    rest = rest_stretch(scene.body.spec(), tet) * rest;
    const Mat3 f = now * rest.inverse();
    return f.transpose() * f;
}

double principal_stretch(const Scene& scene, const State& state, int tet) noexcept {
    return std::sqrt(largest_eigenvalue(cauchy_green(scene, state, tet)));
}

double mean_stretch(const Scene& scene, const State& state, int tet, double radius_m) noexcept {
    if (!(radius_m > 0)) return principal_stretch(scene, state, tet);
    const Vec3 centre = centre_at_rest(scene, state, tet);
    const Tissue tissue = scene.body.mesh().tissue[tet];
    std::array<int32_t, kMostNear> near;
    size_t count = 0;
    near[count++] = tet;
    Mat3 sum = Mat3::Zero();
    double weights = 0;
    // Breadth first over uncut faces, in the order of the mesh: the same sum everywhere.
    for (size_t next = 0; next < count; ++next) {
        const int t = near[next];
        const double far =
            (centre_at_rest(scene, state, t) - centre).squaredNorm() / (radius_m * radius_m);
        const double weight =
            static_cast<double>(rest_volume_of(scene.body, state.body, t)) * (1 - far) * (1 - far);
        // Not of C = U^2: near the tip of a cut that grows as 1 / r, and hangs on the mesh longer.
        sum += weight * root_of(cauchy_green(scene, state, t));
        weights += weight;
        for (int face = 0; face < 4 && count < kMostNear; ++face) {
            const int32_t other = linked_across(scene, state, t, face);
            if (other < 0 || scene.body.mesh().tissue[other] != tissue) continue;
            if ((centre_at_rest(scene, state, other) - centre).norm() >= radius_m) continue;
            if (std::find(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), other) ==
                near.begin() + static_cast<std::ptrdiff_t>(count))
                near[count++] = other;
        }
    }
    return largest_eigenvalue(sum / weights);
}

}  // namespace placode::sim
