// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/pull_vertices.h"

#include <cmath>

#include "sim/contact/contact_core.h"
#include "sim/core/as_index.h"
#include "sim/solver/soft_body.h"
#include "sim/step/sleep_and_wake.h"
#include "sim/step/step.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

// The tissue follows within milliseconds at this damping (settle()).
constexpr double kDrawS = 0.2, kRestS = 0.3;

}  // namespace

std::vector<Vec3> pull_vertices(const Scene& scene, State& state,
                                std::span<const PulledVertex> pulled) {
    rouse_all(state.body);
    wake_tissue(scene, state);
    // Who was in contact is solved with the rest.
    clear_contacts(state.scratch->contacts,
                   std::span(state.colour.vertex).first(as_index(state.colour.count)), state.body);
    state.colour.count = 0;
    std::vector<Vec3> from;
    for (const PulledVertex& p : pulled) {
        from.push_back(position(state.body, p.vertex));
        state.body.x[as_index(p.vertex)].w = 0;
    }
    update_free_vertices(scene.body, state.body);
    const double frame_s = scene.body.spec().solver.frame_s;
    const int frames = static_cast<int>(std::ceil(kDrawS / frame_s));
    for (int f = 1; f <= frames; ++f) {
        for (size_t i = 0; i < pulled.size(); ++i) {
            const Vec3 at = from[i] + static_cast<double>(f) / frames * (pulled[i].to_m - from[i]);
            Float4& x = state.body.x[as_index(pulled[i].vertex)];
            x.x = static_cast<float>(at.x());
            x.y = static_cast<float>(at.y());
            x.z = static_cast<float>(at.z());
        }
        settle(scene, state, frame_s);
    }
    settle(scene, state, kRestS);
    std::vector<Vec3> force_n;
    for (const PulledVertex& p : pulled)
        force_n.push_back(elastic_force(scene.body, state.body, p.vertex));
    return force_n;
}

}  // namespace placode::sim
