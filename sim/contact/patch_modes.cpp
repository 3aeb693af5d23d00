// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_modes.h"

#include "sim/contact/patch_contact.h"
#include "sim/contact/whole_body.h"
#include "sim/core/as_index.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kModesLongest = 0.25;  // of an edge, in a substep

class PatchModes {
 public:
    PatchModes(const Scene& scene, State& state, double h) noexcept
        : scene_(scene),
          patch_(*scene.patch),
          state_(state),
          h_(h),
          fall_m_s_(h * scene.body.spec().solver.gravity_m_s2),
          from_(to_vec(state.body.x_start[as_index(patch_.first_vertex)])) {}

    void move() noexcept {
        // Jaws often hold one of the last vertices: asked before anything is summed up.
        for (int32_t i = 0; i < patch_.vertex_count; ++i) {
            if (state_.body.x[as_index(patch_.first_vertex + i)].w == 0) return;
        }
        for (int32_t i = 0; i < patch_.vertex_count; ++i) add_vertex(i);
        add_instruments(
            state_.scratch->contacts, state_.body, from_, h_ * h_,
            [&](int32_t v) noexcept { return patch_.owns(v); }, pushes_);
        const auto step = whole_step(sums_, pushes_);
        if (!step) return;
        const auto edge =
            static_cast<double>(scene_.body.shortest_edge_m()[as_index(patch_.first_vertex)]);
        move_whole(state_.body, from_, *step, patch_.vertex_count, kModesLongest * edge,
                   [&](int32_t i) noexcept { return patch_.first_vertex + i; });
    }

 private:
    void add_vertex(int32_t i) noexcept {
        const size_t v = as_index(patch_.first_vertex + i);
        const SoftBodyState& body = state_.body;
        const Vec3 r = to_vec(body.x[v]) - from_, before = to_vec(body.x_start[v]) - from_;
        sums_.add(static_cast<double>(scene_.body.mass_kg()[v]), r, before,
                  h_ * (to_vec(body.v[v]) + fall_m_s_));
        const PatchTie& tie = state_.scratch->patch.ties[as_index(i)];
        if (!tie.holds) return;
        const Mat3 k = h_ * h_ * tie.k_n_m;
        pushes_.add(r, k * (tie.place - from_ - r), k);
    }

    const Scene& scene_;
    const Patch& patch_;
    State& state_;
    double h_;
    Vec3 fall_m_s_, from_;  // all places are from there
    WholeSums sums_;
    Pushes pushes_;
};

}  // namespace

void move_patch_whole(const Scene& scene, State& state, double h) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    PatchModes(scene, state, h).move();
}

}  // namespace placode::sim
