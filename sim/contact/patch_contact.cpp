// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_contact.h"

#include <algorithm>

#include "sim/contact/patch_fold.h"
#include "sim/contact/patch_vertex.h"
#include "sim/contact/surface_face.h"
#include "sim/core/as_index.h"
#include "sim/core/float_lanes.h"
#include "sim/core/tool_shape.h"

namespace placode::sim {
namespace {

constexpr int kPatchGroups = 4;       // one is looked up anew in every frame
constexpr double kPatchFast2 = 1e-4;  // square of a speed at which all are [m2/s2]
constexpr double kPatchReach = 8e-4;  // at 0.1 m/s it moves 0.4 mm until it is looked up again [m]
constexpr double kPatchLost = 3e-3;   // deeper in tissue than that a vertex is let go [m]
constexpr double kPatchStale = 1e-4;  // boxes may be those of the frame before [m]
constexpr float kFloatSlackM = 1e-8F, kFloatSlack = 1.0001F;  // more than floats are off
constexpr double kTellN = 1e-6;  // a change of load that wakes tissue [N]
constexpr int kPatchJob = 32;    // vertices; a multiple of the groups

/// The nearest face of the tissue within reach; tet -1 when there is none.
class FaceBelow {
 public:
    FaceBelow(const Scene& scene, const State& state, int32_t v) noexcept
        : scene_(scene),
          state_(state),
          at_(position(state.body, v)),
          near_(lanes_of(state.body.x[as_index(v)])) {}

    /// What was next to it the last time leaves most of the tree out from the start.
    void find(PatchTouch& out) noexcept {
        const SurfaceTriangle* found = nullptr;
        const bool known = out.tet >= 0 && is_on_surface(state_, out.tet, out.face) &&
                           is_known(corners_of_face(scene_, state_, out.tet, out.face));
        state_.surface.tree().walk(
            [&](const SurfaceTree::Box& box) noexcept {
                return surely_beyond(lanes_of(box.low), lanes_of(box.high), kPatchStale);
            },
            [&](int slot) noexcept {
                const SurfaceTriangle& face = state_.surface.triangles()[as_index(slot)];
                if (is_nearer(face.vertex)) found = &face;
            });
        if (found == nullptr && known) return;
        out.tet = found == nullptr ? -1 : found->tet;
        out.face = found == nullptr
                       ? 0
                       : local_face(corners(scene_.body, state_.body, found->tet), found->vertex);
    }

 private:
    /// What is within reach, or what the vertex lies behind: it is searched for deeper.
    [[nodiscard]] bool is_known(const std::array<int32_t, 3>& face) noexcept {
        if (is_nearer(face)) return true;
        const Vec3 a = position(state_.body, face[0]), b = position(state_.body, face[1]),
                   c = position(state_.body, face[2]);
        if (!((b - a).cross(c - a).dot(at_ - a) < 0)) return false;
        best2_ = kPatchLost * kPatchLost;
        return is_nearer(face);
    }
    /// In floats, which say so in most cases and never wrongly: whether a box, grown by `stale_m`,
    /// is as far as the best. What is not finite is not.
    [[nodiscard]] bool surely_beyond(FloatLanes low, FloatLanes high,
                                     double stale_m) const noexcept {
        const auto grown = every_lane(static_cast<float>(stale_m) + kFloatSlackM);
        const FloatLanes offset = most(most(low - near_, near_ - high) - grown, every_lane(0));
        return dot3(offset, offset) > kFloatSlack * static_cast<float>(best2_);
    }
    [[nodiscard]] bool is_nearer(const std::array<int32_t, 3>& face) noexcept {
        const FloatLanes a = lanes_of(state_.body.x[as_index(face[0])]),
                         b = lanes_of(state_.body.x[as_index(face[1])]),
                         c = lanes_of(state_.body.x[as_index(face[2])]);
        if (surely_beyond(least(least(a, b), c), most(most(a, b), c), 0)) return false;
        Triangle x;
        for (size_t k = 0; k < 3; ++k) x[k] = position(state_.body, face[k]);
        const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]),
                   high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
        if ((low - at_).cwiseMax(at_ - high).cwiseMax(0.0).squaredNorm() >= best2_) return false;
        const Vec3 w = closest_on_triangle(at_, x);
        const double d2 = (at_ - w.x() * x[0] - w.y() * x[1] - w.z() * x[2]).squaredNorm();
        if (!(d2 < best2_)) return false;
        best2_ = d2;
        return true;
    }

    const Scene& scene_;
    const State& state_;
    Vec3 at_;
    FloatLanes near_;  // the same
    double best2_ = kPatchReach * kPatchReach;
};

/// All vertices of a patch. No two of them write the same, in whatever order they come.
class PatchTeam {
 public:
    PatchTeam(const Scene& scene, State& state, double h, int32_t group = 0) noexcept
        : scene_(scene), state_(state), h_(h), group_(group) {}

    [[nodiscard]] int jobs() const noexcept {
        return (scene_.patch->vertex_count + kPatchJob - 1) / kPatchJob;
    }
    void look(int job) noexcept {
        for (int32_t i = kPatchJob * job; i < end_of(job); ++i) {
            const int32_t v = scene_.patch->first_vertex + i;
            // A face that it has left by half an edge would push it on.
            const bool fast = to_vec(state_.body.v[as_index(v)]).squaredNorm() > kPatchFast2;
            if (i % kPatchGroups != group_ && !fast) continue;
            FaceBelow(scene_, state_, v).find(state_.patch.touch[as_index(i)]);
        }
    }
    void press(int job) noexcept {
        for (int32_t i = kPatchJob * job; i < end_of(job); ++i)
            PatchVertex(scene_, state_, i, h_).press();
    }
    void bear(int job) noexcept {
        for (int32_t i = kPatchJob * job; i < end_of(job); ++i)
            PatchVertex(scene_, state_, i, h_).bear();
    }

 private:
    [[nodiscard]] int32_t end_of(int job) const noexcept {
        return std::min(scene_.patch->vertex_count, kPatchJob * (job + 1));
    }
    const Scene& scene_;
    State& state_;
    double h_;
    int32_t group_;
};

/// Adds a share of a force to what a vertex of the tissue bears.
void add_patch_load(const Patch& patch, PatchState& state, int32_t v, const Vec3& force) noexcept {
    if (patch.bears[as_index(v)] == 0) return;
    auto& load = state.load_n[as_index(v)];
    if (state.listed[as_index(v)] == 0) {
        state.listed[as_index(v)] = 1;
        state.loaded[as_index(state.loaded_count++)] = v;
    }
    for (int k = 0; k < 3; ++k) load[as_index(k)] += static_cast<float>(force[k]);
}

/// Gives the tissue its loads, wakes it where they have changed, forgets those that are gone.
void give_loads(const Scene& scene, State& state) noexcept {
    PatchState& patch = state.patch;
    int32_t kept = 0;
    for (int32_t i = 0; i < patch.loaded_count; ++i) {
        const int32_t v = patch.loaded[as_index(i)];
        const auto& load = patch.load_n[as_index(v)];
        auto& told = patch.told_n[as_index(v)];
        const Vec3f f(load[0], load[1], load[2]);
        set_load(scene.body, state.body, v, f, Vec3f::Zero(), Vec3f::Zero());
        if ((f - Vec3f(told[0], told[1], told[2])).norm() > static_cast<float>(kTellN)) {
            told = load;
            rouse(state.body, v);
        }
        if (load == std::array<float, 3>{}) {
            told = {};
            patch.listed[as_index(v)] = 0;
        } else {
            patch.loaded[as_index(kept++)] = v;
        }
    }
    patch.loaded_count = kept;
}

/// What touches is held, as if by anchor springs: its weight is then a force like that of its ties,
/// and no part of the start guess. One sweep answers the ties of a stiff sheet only in part; a
/// weight that was there in full would press it in until they bore many times as much.
void hold_by_touch(const Patch& patch, State& state) noexcept {
    bool held = false;
    for (int32_t i = 0; i < patch.vertex_count && !held; ++i) {
        held = state.patch.touch[as_index(i)].presses != 0 ||
               state.body.x[as_index(patch.first_vertex + i)].w == 0;
    }
    const auto first = state.body.free_vertex.begin() + patch.first_vertex;
    std::fill_n(first, patch.vertex_count, static_cast<uint8_t>(held ? 0 : 1));
}

}  // namespace

PatchState::PatchState(const Scene& scene) {
    if (!scene.patch) return;
    touch.resize(as_index(scene.patch->vertex_count));
    const auto bearing = std::count(scene.patch->bears.begin(), scene.patch->bears.end(), 1);
    loaded.assign(static_cast<size_t>(bearing), -1);
    load_n.resize(as_index(scene.body.vertex_count()));
    told_n.resize(load_n.size());
    listed.resize(load_n.size());
}

const SurfaceTriangle& touched_triangle(const Scene& scene, const State& state,
                                        int32_t number) noexcept {
    if (number >= kPatchCandidate)
        return scene.patch->triangles[as_index(number - kPatchCandidate)];
    return state.surface.triangles()[as_index(number)];
}

bool patch_sleeps(const Scene& scene, const State& state) noexcept {
    if (!scene.patch || !state.sleep.enabled()) return false;
    const int32_t block = state.sleep.block[as_index(scene.patch->first_vertex)];
    return block >= 0 && state.sleep.asleep[as_index(block)] != 0;
}

bool patch_shaken(const Scene& scene, const State& state) noexcept {
    for (const PatchTouch& t : state.patch.touch) {
        if (t.tet < 0) continue;
        for (const int32_t v : corners(scene.body, state.body, t.tet)) {
            if (v >= static_cast<int32_t>(state.sleep.block.size())) return true;  // a copy
            const int32_t block = state.sleep.block[as_index(v)];
            if (block >= 0 && state.sleep.asleep[as_index(block)] == 0) return true;
        }
    }
    return false;
}

void collect_patch_faces(const Scene& scene, State& state, int64_t frame) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    collect_patch_folds(scene, state);
    PatchTeam team(scene, state, 0, static_cast<int32_t>(frame % kPatchGroups));
    state.workers->run<&PatchTeam::look>(team.jobs(), team);
}

void press_patch(const Scene& scene, State& state, double h) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    PatchTeam team(scene, state, h);
    state.workers->run<&PatchTeam::press>(team.jobs(), team);
    hold_by_touch(*scene.patch, state);
}

void bear_patch(const Scene& scene, State& state, double h) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    PatchState& patch = state.patch;
    for (int32_t i = 0; i < patch.loaded_count; ++i)
        patch.load_n[as_index(patch.loaded[as_index(i)])] = {};
    PatchTeam team(scene, state, h);
    state.workers->run<&PatchTeam::bear>(team.jobs(), team);
    for (const PatchTie& tie : state.scratch->patch.ties) {
        for (size_t k = 0; k < 3 && tie.holds; ++k)
            add_patch_load(*scene.patch, patch, tie.face[k],
                           tie.weight[static_cast<int>(k)] * tie.load_n);
    }
    give_loads(scene, state);
}

}  // namespace placode::sim
