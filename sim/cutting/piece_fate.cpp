// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/piece_fate.h"

#include <algorithm>
#include <array>
#include <vector>

#include "sim/core/healthy_skin.h"
#include "sim/cutting/attempt_progress.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/diathermy.h"
#include "sim/solver/topology.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kRemovedPerFrame = 8;
constexpr double kOutShare = 0.62;     // of the way from lesion to port left: the piece is out
constexpr float kLying = 1e-4F;        // this near to the field's height a fallen piece lies [m]
constexpr float kCalmSpeed = 0.005F;   // of every vertex, where tissue lies on tissue [m/s]
constexpr uint16_t kCalmFrames = 100;  // until it sticks
constexpr float kLost = -0.004F;       // below that it lies in any case [m]

/// True when a fallen piece has reached the field.
bool lies(const Scene& scene, const State& state, int piece) noexcept {
    bool down = false;
    for_tets_of_piece(scene, state, piece, [&](int32_t t) {
        const Float4& x = state.body.x[corners(scene.body, state.body, t)[0]];
        const float ground = state.scratch->pieces.ground_m[ground_cell(x.x, x.y)];
        down = down || x.z < ground + kLying || x.z < kLost;
    });
    return down;
}

/// True when a piece has lain still on other tissue for a while, or has fallen past everything.
bool lies_on_tissue(const Scene& scene, State& state, int piece) noexcept {
    float fastest2 = 0;
    bool touches = false, lost = false;
    for_tets_of_piece(scene, state, piece, [&](int32_t t) {
        for (const int32_t v : corners(scene.body, state.body, t)) {
            const Float4& speed = state.body.v[static_cast<size_t>(v)];
            fastest2 =
                std::max(fastest2, speed.x * speed.x + speed.y * speed.y + speed.z * speed.z);
            touches = touches || state.body.contact_vertex[static_cast<size_t>(v)] != 0;
            lost = lost || state.body.x[static_cast<size_t>(v)].z < kLost;
        }
    });
    Piece& p = state.pieces.list[piece];
    p.calm = touches && fastest2 < kCalmSpeed * kCalmSpeed ? static_cast<uint16_t>(p.calm + 1)
                                                           : uint16_t{0};
    return lost || p.calm >= kCalmFrames;
}

/// No tissue is marked for removal, and no instrument could remove any.
bool nothing_is_to_go(const Scene& scene) noexcept {
    const auto cuts = [](const ToolSpec& tool) noexcept {
        return tool.kind == ToolKind::kScissors || conducts(tool.kind);
    };
    return scene.marked_volume_m3 == 0 &&
           std::none_of(scene.tools.begin(), scene.tools.end(), cuts);
}

/// Skin that is not marked and lies farther out than a cut may reach: in any task it is to stay.
/// Where a scene has no lesion, nothing excuses the loss.
bool is_healthy_skin(const Scene& scene, int32_t tet) noexcept {
    const auto t = static_cast<size_t>(tet);
    if (!is_skin(scene.body.mesh().tissue[t])) return false;
    if (!scene.marked.empty() && scene.marked[t] != 0) return false;
    if (scene.field.to_skin_m.empty()) return true;
    double to_skin_m = 0;
    for (const int32_t v : scene.body.mesh().tets[t])
        to_skin_m += static_cast<double>(scene.field.to_skin_m[static_cast<size_t>(v)]) / 4;
    return to_skin_m > kOutsideSkinM;
}

void take_away(const Scene& scene, State& state, int piece) noexcept {
    Piece& p = state.pieces.list[piece];
    int removed = 0;
    for (int32_t t = 0; t < scene.body.tet_count() && removed < kRemovedPerFrame; ++t) {
        if (state.pieces.of[t] != piece || !state.body.tet_alive[t]) continue;
        take_out(scene, state, t);
        ++removed;
    }
    if (removed < kRemovedPerFrame) p = {};
}

/// Past the port: it counts as taken out, with what of it was marked.
void draw_out(const Scene& scene, State& state, int piece) noexcept {
    Piece& p = state.pieces.list[piece];
    p.leaving = kDrawnOut;
    ++state.pieces.out;
    state.pieces.out_m3 += p.volume_m3;
    Event e = piece_event(scene, state, EventKind::kPieceOut, p);
    if (scene.marked_volume_m3 > 0) {
        double marked = 0;
        for_tets_of_piece(scene, state, piece, [&](int32_t t) {
            if (scene.marked[t]) marked += static_cast<double>(scene.body.volume_m3()[t]);
        });
        state.pieces.marked_out_m3 += marked;
        e.value2 =
            static_cast<float>((state.pieces.marked_gone_m3 + marked) / scene.marked_volume_m3);
        add_event(state, taken_out_event(scene, state));
    }
    add_event(state, e);
    note_lost_tissue(scene, state, piece);
}

}  // namespace

void note_lost_tissue(const Scene& scene, State& state, int piece) noexcept {
    const std::vector<Tissue>& tissue = scene.body.mesh().tissue;
    const bool all = nothing_is_to_go(scene);
    std::array<int32_t, kTissueCount> first{};
    std::array<double, kTissueCount> volume_m3{};
    first.fill(-1);
    for_tets_of_piece(scene, state, piece, [&](int32_t t) {
        if (!all && tissue[t] != Tissue::kPlacode && !is_healthy_skin(scene, t)) return;
        const auto kind = static_cast<size_t>(tissue[t]);
        if (first[kind] < 0) first[kind] = t;
        volume_m3[kind] += static_cast<double>(scene.body.volume_m3()[t]);
    });
    for (size_t kind = 0; kind < first.size(); ++kind) {
        if (first[kind] < 0) continue;
        Event e = tissue_event(scene, state, EventKind::kTorn, first[kind]);
        e.value = static_cast<float>(volume_m3[kind]);
        e.tool = state.pieces.list[piece].held_by;
        add_event(state, e);
    }
}

void stick_piece(const Scene& scene, State& state, int piece, bool resting) noexcept {
    Piece& p = state.pieces.list[piece];
    p.resting = resting ? 1 : 0;
    for_tets_of_piece(scene, state, piece, [&](int32_t t) {
        for (const int32_t v : corners(scene.body, state.body, t)) {
            if (state.held_by[v] >= 0) continue;
            state.pieces.resting[v] = p.resting;
            state.body.v[v] = {};
            state.body.x[v].w = resting ? 0.0F : 1.0F / mass_of(scene.body, state.body, v);
        }
    });
}

int holder_of_piece(const Scene& scene, const State& state, int piece) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const Grasp& g = state.grasps[t];
        for (int i = 0; i < g.count; ++i) {
            for (const int32_t tet : tets_around(scene.body, state.body, g.held[i].vertex)) {
                if (state.body.tet_alive[tet] && state.pieces.of[tet] == piece) return t;
            }
        }
    }
    return -1;
}

Event piece_event(const Scene& scene, const State& state, EventKind kind, const Piece& p) noexcept {
    Event e = tissue_event(scene, state, kind, p.seed);
    e.value = static_cast<float>(p.volume_m3);
    e.tool = p.held_by;
    return e;
}

void follow_piece(const Scene& scene, State& state, int piece) noexcept {
    Piece& p = state.pieces.list[piece];
    if (p.leaving) {
        take_away(scene, state, piece);
        return;
    }
    const bool was_held = p.held_by >= 0;
    p.held_by = static_cast<int8_t>(holder_of_piece(scene, state, piece));
    if (p.held_by >= 0) {
        if (p.resting) stick_piece(scene, state, piece, false);
        const Vec3 pivot = scene.tools[p.held_by].pivot_m;
        const Vec3 tip = state.tools[p.held_by].proxy.p;
        if ((tip - pivot).norm() < kOutShare * pivot.norm()) draw_out(scene, state, piece);
    } else if (!p.resting) {
        if (was_held) update_free_vertices(scene.body, state.body);
        const bool down = state.self_contact.enabled() ? lies_on_tissue(scene, state, piece)
                                                       : lies(scene, state, piece);
        if (down) stick_piece(scene, state, piece, true);
    }
}

}  // namespace placode::sim
