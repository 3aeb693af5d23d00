// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/cutting.h"

#include <algorithm>
#include <cmath>

#include "sim/cutting/grasp.h"
#include "sim/cutting/separation.h"
#include "sim/cutting/tissue_stretch.h"
#include "sim/solver/stretch_bound.h"
#include "sim/world/add_event.h"
#include "sim/world/cut_columns.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kTearShare = 64;  // 1/64 of the tets a frame
constexpr int kTearPerFrame = 8;
// Checks in a row before a tet tears: 20 frames beside an instrument; elsewhere, where a check
// comes every 64 frames, two checks.
constexpr int kTearCount = 20, kTearCountFar = 10;
constexpr double kOverStretchPause = 0.5;  // between ledger entries of one tissue [s]

/// A tet that is below all limits.
void forget_stretch(State& state, int tet) noexcept {
    state.stretch_count[tet] = 0;
    state.ledger.over_stretch.below(tet);
}

/// Checks one tet; tears it or writes over-stretch into the ledger. Returns tets torn (0 or 1).
int check_stretch(const Scene& scene, State& state, int tet, int weight, int tool) noexcept {
    const Tissue tissue = scene.body.mesh().tissue[tet];
    const Material& material = scene.body.spec().materials[static_cast<int>(tissue)];
    OverStretch& sums = state.ledger.over_stretch;
    double stretch = principal_stretch(scene, state, tet);
    // The mean costs more, so that it is asked only where one tet is beyond a limit.
    if (stretch > std::min(material.injury_stretch, material.fail_stretch))
        stretch = mean_stretch(scene, state, tet, scene.tear_radius_m);
    if (stretch > material.injury_stretch && !state.ledger.stretch_reported[tet]) {
        state.ledger.stretch_reported[tet] = 1;
        float& pause = state.ledger.over_stretch_pause_s[static_cast<int>(tissue)];
        if (pause <= 0) {
            pause = static_cast<float>(kOverStretchPause);
            Event e = tissue_event(scene, state, EventKind::kOverStretch, tet);
            e.tool = static_cast<int8_t>(tool);
            e.value = static_cast<float>(stretch);
            add_event(state, e);
        }
    }
    if (stretch > material.injury_stretch) {
        const auto volume = static_cast<double>(rest_volume_of(scene.body, state.body, tet));
        sums.beyond(tet, state.frame, stretch, volume, tissue);
    } else {
        sums.below(tet);
    }
    if (!(stretch > material.fail_stretch)) {
        state.stretch_count[tet] = 0;
        return 0;
    }
    state.stretch_count[tet] =
        static_cast<uint8_t>(std::min(200, state.stretch_count[tet] + weight));
    if (state.stretch_count[tet] < kTearCount) return 0;
    remove_tissue(scene, state, tet, EventKind::kTorn, tool, stretch);
    return 1;
}

/// Tets that wait to be checked, until there are enough to be looked at side by side.
struct StretchGroup {
    explicit StretchGroup(const Scene& scene) noexcept : limits(scene.body.spec().materials) {}

    StretchLimits limits;
    std::array<int32_t, kStretchGroup> tets{};
    size_t count = 0;

    [[nodiscard]] bool full() const noexcept { return count == tets.size(); }
    void add(int32_t tet) noexcept { tets[count++] = tet; }
    /// Checks all of them, until `most` have torn. Returns how many have.
    int check(const Scene& scene, State& state, int weight, int tool,
              int most = kStretchGroup) noexcept {
        if (count == 0) return 0;
        const uint32_t below =
            surely_below(scene.body, state.body, std::span(tets).first(count), limits);
        int torn = 0;
        for (size_t i = 0; i < count && torn < most; ++i) {
            if ((below >> i & 1) != 0)
                forget_stretch(state, tets[i]);
            else
                torn += check_stretch(scene, state, tets[i], weight, tool);
        }
        count = 0;
        return torn;
    }
};

}  // namespace

int32_t linked_across(const Scene& scene, const State& state, int tet, int face) noexcept {
    if (state.surface.on_surface(tet, face)) return -1;
    const int32_t other = scene.surface.neighbours()[tet][face];
    return other >= 0 && state.body.tet_alive[other] ? other : -1;
}

double tet_depth(const Scene& scene, int tet) noexcept {
    if (scene.field.depth_m.empty()) return 0;
    double sum = 0;
    for (const int32_t v : scene.body.mesh().tets[tet]) sum += scene.field.depth_m[v];
    return sum / 4;
}

void take_out(const Scene& scene, State& state, int tet) noexcept {
    if (!state.body.tet_alive[tet]) return;
    remove_tet(scene.body, state.body, tet);
    const auto& alive = state.body.tet_alive;
    state.surface.remove_tet(scene.surface, scene.body.mesh(), alive, tet,
                             current_tets(state.body));
    if (!state.heat.empty()) {
        remove_heat_of_tet(scene.body, *scene.heat, state.heat[0], scene.surface.neighbours(),
                           alive, tet);
    }
    // A vertex that nothing holds any more would fall for ever: it stays where it is.
    for (const int32_t v : corners(scene.body, state.body, tet)) {
        const auto around = tets_around(scene.body, state.body, v);
        queue_separation(scene, state, v);
        if (std::any_of(around.begin(), around.end(), [&](int32_t t) { return alive[t] != 0; })) {
            continue;
        }
        let_go_vertex(scene, state, v);
        state.body.x[v].w = 0;
        state.body.v[v] = {};
    }
    if (!scene.marked.empty() && scene.marked[tet]) {
        const auto volume = static_cast<double>(scene.body.volume_m3()[tet]);
        const int8_t piece = state.pieces.of[tet];
        state.pieces.marked_gone_m3 += volume;
        if (piece < 0 || state.pieces.list[piece].leaving != kDrawnOut)
            state.pieces.marked_lost_m3 += volume;
    }
    const CutTables& tables = state.scratch->cut;
    for (int i = tables.start[tet]; i < tables.start[tet + 1]; ++i) {
        const int column = tables.column[i], point = column / kColumnsPerPoint;
        if (--state.progress.column_left[column] > 0 || state.progress.cut[point]) continue;
        state.progress.cut[point] = 1;
        ++state.progress.cut_count;
    }
}

void remove_tissue(const Scene& scene, State& state, int tet, EventKind cause, int tool,
                   double value2) noexcept {
    if (!state.body.tet_alive[tet]) return;
    take_out(scene, state, tet);
    if (cause == EventKind::kVaporised) state.gone_by_heat[tet] = 1;
    const float volume = rest_volume_of(scene.body, state.body, tet);
    state.removed_m3 += volume;
    Event e = tissue_event(scene, state, cause, tet);
    e.tool = static_cast<int8_t>(tool);
    e.value = volume;
    e.value2 = static_cast<float>(value2);
    add_event(state, e);
}

void tear(const Scene& scene, State& state) noexcept {
    int torn = 0;
    StretchGroup group(scene);
    const ContactSet& set = state.scratch->contacts;
    for (int i = 0; i < set.vertex_count && torn < kTearPerFrame; ++i) {
        const auto check = [&]() noexcept {
            torn += group.check(scene, state, 1, set.vertices[i].side);
        };
        for (const int32_t t : tets_around(scene.body, state.body, set.vertices[i].vertex)) {
            const auto& c = corners(scene.body, state.body, t);
            // Once per tet: from the first of its corners that is in the colour.
            int first = -1;
            for (const int32_t v : c) {
                if (first < 0 && set.slot[v] >= 0) first = v;
            }
            if (first != set.vertices[i].vertex || !state.body.tet_alive[t]) continue;
            group.add(t);
            if (group.full()) check();
        }
        check();
    }
    // Around what jaws pull on.
    for (int tool = 0; tool < static_cast<int>(scene.tools.size()); ++tool) {
        const Grasp& g = state.grasps[tool];
        for (int i = 0; i < g.count && torn < kTearPerFrame; ++i) {
            const int32_t v = g.held[i].vertex;
            for (const int32_t t : tets_around(scene.body, state.body, v)) {
                int32_t first = -1;  // once per tet: from the first of its held corners
                for (const int32_t c : corners(scene.body, state.body, t)) {
                    if (first < 0 && state.held_by[c] == tool) first = c;
                }
                if (first != v || !state.body.tet_alive[t]) continue;
                group.add(t);
                torn += group.check(scene, state, 1, tool);
                if (state.held_by[v] != tool) break;
            }
        }
    }
    // Everywhere else in turns; neighbours in number share their corners.
    const int tets = scene.body.tet_count(), turn = tets / kTearShare + 1;
    const int from = static_cast<int>(state.frame % kTearShare) * turn;
    const int last = std::min(tets, from + turn);
    for (int t = from; t < last && torn < kTearPerFrame; ++t) {
        // What sleeps has been looked at before it fell asleep.
        if (state.body.tet_alive[t] && !state.sleep.sleeps(corners(scene.body, state.body, t)))
            group.add(t);
        if (group.full() || t + 1 == last)
            torn += group.check(scene, state, kTearCountFar, -1, kTearPerFrame - torn);
    }
}

}  // namespace placode::sim
