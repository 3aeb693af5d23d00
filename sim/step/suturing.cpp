// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/suturing.h"

#include <algorithm>

#include "sim/contact/contact.h"
#include "sim/core/as_index.h"
#include "sim/step/needle_jaws.h"
#include "sim/suture/passage_load.h"
#include "sim/suture/suture_step.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

/// The tissue as the needle sees it; a vertex that instruments touch is solved with both.
SuturedTissue tissue_of(const Scene& scene, State& state) noexcept {
    const auto touch = [](void* of, int32_t vertex, VertexSystem& system) noexcept {
        add_contacts(*static_cast<State*>(of), vertex, system);
    };
    return {scene.body, state.body, scene.surface, state.surface, {touch, &state}};
}

bool works(const Scene& scene, const State& state) noexcept {
    return scene.suture && state.suturing.placed != 0;
}

/// What the needle does to a driver whose jaws hold it.
void feel_needle(const Scene& scene, State& state, int t) noexcept {
    ToolState& tool = state.tools[as_index(t)];
    const Vec3 pull = -hold_of(state, t)->force_n / state.substeps;
    tool.force_n += pull;
    tool.needle_n += pull;
    tool.stiffness_n_m += needle_pull(scene, state, t).stiffness_n_m / state.substeps;
}

}  // namespace

void begin_suturing(const Scene& scene, State& state) noexcept {
    if (!scene.suture) return;
    state.scratch->suture_report = {};
    state.suturing.point_n = state.suturing.thread_n = 0;
    if (state.suturing.placed == 0) place_in_jaws(scene, state);
}

void begin_suture_substep(const Scene& scene, State& state, double h_s) noexcept {
    if (!works(scene, state)) return;
    SutureState& needle = state.suturing.needle[0];
    const int t = state.suturing.driver, second = state.suturing.handover.second;
    const Pose hand = t >= 0 ? state.tools[as_index(t)].proxy : needle.hold.hand;
    if (second >= 0)
        move_second_hand(needle, state.scratch->suture[0], state.tools[as_index(second)].proxy);
    begin_suture(*scene.suture, needle, tissue_of(scene, state), state.scratch->suture[0], hand,
                 h_s, state.scratch->suture_report);
}

void solve_suture_substep(const Scene& scene, State& state, double h_s, bool backward) noexcept {
    if (!works(scene, state)) return;
    solve_suture(*scene.suture, state.suturing.needle[0], tissue_of(scene, state),
                 state.scratch->suture[0], h_s, backward);
}

void finish_suture_substep(const Scene& scene, State& state, double h_s) noexcept {
    if (!works(scene, state)) return;
    Suturing& s = state.suturing;
    SutureReport& report = state.scratch->suture_report;
    const double placode_n =
        s.driver < 0 ? 0
                     : passage_load_n(*scene.suture, s.needle[0], tissue_of(scene, state),
                                      state.scratch->suture[0], Tissue::kPlacode);
    finish_suture(*scene.suture, s.needle[0], tissue_of(scene, state), state.scratch->suture[0],
                  h_s, report);
    // What instruments touch stays out of the sweep until they are looked for anew.
    const ContactSet& contacts = state.scratch->contacts;
    for (int i = 0; i < contacts.vertex_count; ++i)
        state.body.contact_vertex[as_index(contacts.vertices[as_index(i)].vertex)] = 1;
    s.point_n = std::max(s.point_n, static_cast<float>(report.point_force_n));
    s.thread_n = std::max(s.thread_n, static_cast<float>(report.thread_pull_n));
    if (s.driver < 0) return;
    feel_needle(scene, state, s.driver);
    if (s.handover.second >= 0) feel_needle(scene, state, s.handover.second);
    ToolState& tool = state.tools[as_index(s.driver)];
    // Whoever pricks the placode touches it, and who draws wire or thread through it.
    tool.placode_force_n += placode_n / state.substeps;
    // Of a point that is free this is the force it had.
    const NeedlePoint& point = s.needle[0].point;
    if (point.mode != PointMode::kFree && point.tissue == Tissue::kPlacode)
        tool.placode_force_n += report.point_force_n / state.substeps;
}

void update_suturing(const Scene& scene, State& state, double dt) noexcept {
    if (!scene.suture) return;
    if (works(scene, state)) tell_of_suture(scene, state, dt);
    update_needle_jaws(scene, state, dt);
}

}  // namespace placode::sim
