// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_fold.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/patch_contact.h"
#include "sim/core/as_index.h"
#include "sim/core/float_lanes.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

// A patch all of whose triangles look within 84 degrees of the mean cannot meet itself.
constexpr double kFoldFacing = 0.1;
constexpr double kFoldReach = 4e-4;  // beyond the thickness: at 0.2 m/s both ways, in a frame [m]
constexpr double kFoldHardest = 6;   // times as stiff where half of the thickness is gone
constexpr int kFoldJob = 32;         // vertices

Triangle places_of(const State& state, const std::array<int32_t, 3>& v) noexcept {
    return {position(state.body, v[0]), position(state.body, v[1]), position(state.body, v[2])};
}

Vec3 start_of(const State& state, int32_t v) noexcept {
    return to_vec(state.body.x_start[as_index(v)]);
}

/// Where a vertex gets by its velocity alone.
Vec3 coasting(const State& state, int32_t v, double h) noexcept {
    const Vec3 start = start_of(state, v);
    if (state.body.x[as_index(v)].w == 0) return start;
    return start + h * to_vec(state.body.v[as_index(v)]);
}

class PatchFolds {
 public:
    PatchFolds(const Scene& scene, State& state) noexcept
        : patch_(*scene.patch),
          state_(state),
          rest_(scene.body.mesh().rest),
          scratch_(state.scratch->patch),
          reach_(patch_.thickness_m + kFoldReach),
          // A triangle within reach has its centre within two thirds of an edge more.
          per_cell_(1 / (reach_ + scratch_.apart_m / 3)) {}

    [[nodiscard]] bool any() const noexcept {
        Vec3 sum = Vec3::Zero();
        for (const SurfaceTriangle& t : patch_.triangles) sum += normal_of(t);
        const double least = kFoldFacing * sum.norm();
        return std::any_of(patch_.triangles.begin(), patch_.triangles.end(),
                           [&](const SurfaceTriangle& t) {
                               const Vec3 n = normal_of(t);
                               // Written so that what is not finite counts as folded.
                               return !(n.dot(sum) > least * n.norm());
                           });
    }
    /// Counting sort of the triangles by their cells.
    void fill_cells() noexcept {
        std::fill(scratch_.cell_start.begin(), scratch_.cell_start.end(), 0);
        for (size_t t = 0; t < patch_.triangles.size(); ++t) {
            const Vec3 centre = centre_of(patch_.triangles[t]);
            scratch_.cell_of[t] = centre.allFinite() ? cell(cell_at(centre)) : -1;
            if (scratch_.cell_of[t] >= 0) ++scratch_.cell_start[as_index(scratch_.cell_of[t]) + 1];
        }
        for (size_t c = 1; c < scratch_.cell_start.size(); ++c)
            scratch_.cell_start[c] += scratch_.cell_start[c - 1];
        for (size_t t = patch_.triangles.size(); t-- > 0;) {
            if (scratch_.cell_of[t] < 0) continue;
            int32_t& end = scratch_.cell_start[as_index(scratch_.cell_of[t]) + 1];
            scratch_.cell_triangle[as_index(--end)] = static_cast<int32_t>(t);
            const Vec3f centre = centre_of(patch_.triangles[t]).cast<float>();
            centre_[as_index(end)] = {centre.x(), centre.y(), centre.z(), 0};
        }
        // Every end has become the start of its cell: one place back.
        std::rotate(scratch_.cell_start.begin(), scratch_.cell_start.begin() + 1,
                    scratch_.cell_start.end());
        scratch_.cell_start.back() = static_cast<int32_t>(
            patch_.triangles.size() -
            as_index(std::count(scratch_.cell_of.begin(), scratch_.cell_of.end(), -1)));
    }
    [[nodiscard]] int jobs() const noexcept {
        return (patch_.vertex_count + kFoldJob - 1) / kFoldJob;
    }
    void look(int job) noexcept {
        const int32_t end = std::min(patch_.vertex_count, kFoldJob * (job + 1));
        for (int32_t i = kFoldJob * job; i < end; ++i) {
            auto& found = scratch_.folds[as_index(i)];
            found = {-1, -1};
            Vec3 to_first = Vec3::Zero(), ignored;
            found[0] = nearest(i, Vec3::Zero(), to_first);
            if (found[0] >= 0) found[1] = nearest(i, to_first, ignored);
        }
    }

 private:
    using Cell = std::array<int64_t, 3>;

    [[nodiscard]] Vec3 normal_of(const SurfaceTriangle& t) const noexcept {
        const Triangle x = places_of(state_, t.vertex);
        return (x[1] - x[0]).cross(x[2] - x[0]);
    }
    [[nodiscard]] Vec3 centre_of(const SurfaceTriangle& t) const noexcept {
        const Triangle x = places_of(state_, t.vertex);
        return (x[0] + x[1] + x[2]) / 3;
    }
    [[nodiscard]] Cell cell_at(const Vec3& p) const noexcept {
        Cell out{};
        for (int k = 0; k < 3; ++k)
            out[as_index(k)] =
                static_cast<int64_t>(std::floor(std::clamp(p[k] * per_cell_, -1e6, 1e6)));
        return out;
    }
    [[nodiscard]] int32_t cell(const Cell& c) const noexcept {
        return bucket_of(hash_part(0, c[0]) ^ hash_part(1, c[1]) ^ hash_part(2, c[2]));
    }
    [[nodiscard]] static uint64_t hash_part(size_t axis, int64_t i) noexcept {
        constexpr std::array<uint64_t, 3> kPrimes{73856093, 19349663, 83492791};
        return static_cast<uint64_t>(i) * kPrimes[axis];
    }
    [[nodiscard]] int32_t bucket_of(uint64_t hash) const noexcept {
        return static_cast<int32_t>(hash & (scratch_.cell_start.size() - 2));
    }

    /// The nearest triangle within reach that is no neighbour at rest; with `not_towards`, of those
    /// that lie to the other side.
    int32_t nearest(int32_t number, const Vec3& not_towards, Vec3& to) const noexcept {
        const int32_t v = patch_.first_vertex + number;
        const Vec3 p = position(state_.body, v);
        if (!p.allFinite()) return -1;
        const Vec3& rest = rest_[as_index(v)];
        const bool second = not_towards != Vec3::Zero();
        double best2 = reach_ * reach_;
        int32_t best = -1;
        const FloatLanes near = lanes_of(state_.body.x[as_index(v)]);
        const auto within2 = static_cast<float>(1.0001 / (per_cell_ * per_cell_));
        const Cell middle = cell_at(p);
        // Of the cells around, by axis.
        std::array<std::array<uint64_t, 3>, 3> parts{};
        for (size_t k = 0; k < 3; ++k) {
            for (size_t side = 0; side < 3; ++side)
                parts[k][side] = hash_part(k, middle[k] + static_cast<int64_t>(side) - 1);
        }
        for (size_t c = 0; c < 27; ++c) {
            const auto bucket =
                as_index(bucket_of(parts[0][c % 3] ^ parts[1][c / 3 % 3] ^ parts[2][c / 9]));
            for (int32_t i = scratch_.cell_start[bucket]; i < scratch_.cell_start[bucket + 1];
                 ++i) {
                // What costs least is asked first: most of what is near is a neighbour.
                const FloatLanes away = lanes_of(centre_[as_index(i)]) - near;
                if (dot3(away, away) > within2) continue;
                const int32_t t = scratch_.cell_triangle[as_index(i)];
                const Vec3 apart = scratch_.rest_centre[as_index(t)] - rest;
                if (apart.squaredNorm() < scratch_.apart_m * scratch_.apart_m) continue;
                const Triangle x = places_of(state_, patch_.triangles[as_index(t)].vertex);
                const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]),
                           high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
                if ((low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm() >= best2) continue;
                const Vec3 w = closest_on_triangle(p, x);
                const Vec3 offset = w.x() * x[0] + w.y() * x[1] + w.z() * x[2] - p;
                if (offset.squaredNorm() >= best2 || (second && offset.dot(not_towards) >= 0))
                    continue;
                best2 = offset.squaredNorm();
                best = t;
                to = offset;
            }
        }
        return best;
    }

    const Patch& patch_;
    State& state_;
    const std::vector<Vec3>& rest_;
    PatchScratch& scratch_;
    double reach_, per_cell_;
    std::array<Float4, 2 * as_index(kMostPatchVertices)> centre_;  // now, as cell_triangle
};

}  // namespace

void collect_patch_folds(const Scene& scene, State& state) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    PatchFolds folds(scene, state);
    state.scratch->patch.folded = folds.any();
    if (!state.scratch->patch.folded) return;
    folds.fill_cells();
    state.workers->run<&PatchFolds::look>(folds.jobs(), folds);
}

bool add_patch_folds(const Scene& scene, const State& state, int32_t number, double press_pa_m,
                     double h, PatchSpring& spring) noexcept {
    const Patch& patch = *scene.patch;
    const int32_t v = patch.first_vertex + number;
    bool any = false;
    for (const int32_t face : state.scratch->patch.folds[as_index(number)]) {
        if (face < 0) continue;
        const auto& corners = patch.triangles[as_index(face)].vertex;
        Triangle start;
        for (size_t k = 0; k < 3; ++k) start[k] = start_of(state, corners[k]);
        const Vec3 x = start_of(state, v), w = closest_on_triangle(x, start);
        Vec3 at = Vec3::Zero(), ahead = Vec3::Zero();
        for (size_t k = 0; k < 3; ++k) {
            const double share = w[static_cast<Eigen::Index>(k)];
            at += share * start[k];
            ahead += share * coasting(state, corners[k], h);
        }
        const double distance = (x - at).norm();
        if (!(distance > 1e-7)) continue;  // in the middle of the other part: no way is better
        const Vec3 n = (x - at) / distance, guess = coasting(state, v, h);
        const double overlap = n.dot(ahead - guess) + patch.thickness_m;
        if (!(overlap > 0)) continue;
        const double deep = std::min(1.0, 2 * overlap / patch.thickness_m);
        const double press = press_pa_m * (1 + (kFoldHardest - 1) * deep * deep) *
                             static_cast<double>(patch.area_m2[as_index(number)]);
        // Friction by what moves within the substep: it forgets, as that of tissue on tissue.
        const Vec3 moved_on = x + (ahead - at);
        Vec3 slide = guess - moved_on;
        slide -= n * n.dot(slide);
        const double most = patch.friction * press * overlap;
        const double rub = press * slide.norm() > most ? most / slide.norm() : press;
        const Mat3 along = n * n.transpose();
        const Mat3 k = press * along + rub * (Mat3::Identity() - along);
        spring.k_n_m += k;
        spring.k_place_n +=
            press * (n.dot(ahead) + patch.thickness_m) * n + rub * (moved_on - n * n.dot(moved_on));
        any = true;
    }
    return any;
}

}  // namespace placode::sim
