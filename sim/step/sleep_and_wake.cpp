// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/sleep_and_wake.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/contact/patch_contact.h"
#include "sim/core/as_index.h"
#include "sim/solver/sleep_runs.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kLook = 16;  // frames between two looks at what may fall asleep
constexpr uint8_t kCalmLooks = 10;
constexpr float kCalmSpeed = 1e-4F;  // [m/s]
constexpr float kCalmM = 2e-6F;      // from where the calm began
constexpr float kWakeM = 5e-6F;      // of a neighbour since the block fell asleep

std::array<float, 3> place(const Float4& x) noexcept { return {x.x, x.y, x.z}; }

float distance2(const Float4& x, const std::array<float, 3>& from) noexcept {
    const float a = x.x - from[0], b = x.y - from[1], c = x.z - from[2];
    return a * a + b * b + c * c;
}

void wake_block(Sleep& sleep, int block) noexcept {
    if (block < 0) return;
    sleep.calm[as_index(block)] = 0;
    if (sleep.asleep[as_index(block)] == 0) return;
    sleep.asleep[as_index(block)] = 0;
    --sleep.asleep_count;
}

void wake_vertex(Sleep& sleep, int32_t v) noexcept {
    if (v < static_cast<int32_t>(sleep.block.size())) wake_block(sleep, sleep.block[as_index(v)]);
}

/// Around new copies of vertices nothing sleeps any more: borders know the mesh as it was.
void unsettle_cuts(const SoftBody& body, const SoftBodyState& state, Sleep& sleep) noexcept {
    if (!state.topology) return;
    for (; sleep.known_vertices < state.topology->vertices; ++sleep.known_vertices) {
        // Also while nothing sleeps, when no runs are set anew: what sleeps is not looked at for
        // tears.
        sleep.vertex_asleep[as_index(sleep.known_vertices)] = 0;
        for (const int32_t t : tets_around(body, state, sleep.known_vertices)) {
            for (const int32_t v : corners(body, state, t)) {
                const int32_t block = sleep.block[as_index(origin_of(state, v))];
                if (block < 0) continue;
                sleep.restless[as_index(block)] = 1;
                wake_block(sleep, block);
            }
        }
    }
}

void wake_roused(SoftBodyState& state, Sleep& sleep) noexcept {
    if (state.roused_count > static_cast<int32_t>(state.roused.size())) {
        for (int b = 0; b < sleep.blocks(); ++b) wake_block(sleep, b);
    } else {
        for (int32_t i = 0; i < state.roused_count; ++i)
            wake_vertex(sleep, state.roused[as_index(i)]);
    }
    state.roused_count = 0;
}

/// What needle and thread hang on does not sleep.
void wake_bonded(const Scene& scene, State& state, const SutureState& needle) noexcept {
    const auto wake = [&](const TissuePoint& at) {
        if (at.tet < 0) return;
        for (const int32_t v : corners(scene.body, state.body, at.tet)) wake_vertex(state.sleep, v);
    };
    for (int i = 0; i < needle.passage_count; ++i) wake(needle.passages[as_index(i)].at);
    for (int i = 0; i < needle.thread.passage_count; ++i)
        wake(needle.thread.passages[as_index(i)].at);
    if (needle.point.mode != PointMode::kFree) wake(needle.point.at);
}

/// True when a neighbour has moved since the block fell asleep.
bool shaken(const SoftBodyState& state, const Sleep& sleep, int b) noexcept {
    for (int32_t i = sleep.border_start[as_index(b)]; i < sleep.border_start[as_index(b) + 1];
         ++i) {
        const Float4& x = state.x[as_index(sleep.border[as_index(i)])];
        // Written so that a place that is not finite wakes as well.
        if (!(distance2(x, sleep.before[as_index(i)]) <= kWakeM * kWakeM)) return true;
    }
    return false;
}

/// True when every member has stayed where it was at the first look of this calm.
bool is_calm(const State& state, Sleep& sleep, int b) noexcept {
    bool calm = true;
    for (int32_t i = sleep.member_start[as_index(b)];
         calm && i < sleep.member_start[as_index(b) + 1]; ++i) {
        const auto v = as_index(sleep.member[as_index(i)]);
        const Float4& speed = state.body.v[v];
        calm = distance2(speed, {}) <= kCalmSpeed * kCalmSpeed &&
               distance2(state.body.x[v], sleep.since[as_index(i)]) <= kCalmM * kCalmM &&
               state.body.free_vertex[v] == 0 && state.held_by[v] < 0 &&
               state.body.contact_vertex[v] == 0;
    }
    if (calm) return true;
    for (int32_t i = sleep.member_start[as_index(b)]; i < sleep.member_start[as_index(b) + 1];
         ++i) {
        sleep.since[as_index(i)] = place(state.body.x[as_index(sleep.member[as_index(i)])]);
    }
    return false;
}

void fall_asleep(SoftBodyState& state, Sleep& sleep, int b) noexcept {
    sleep.asleep[as_index(b)] = 1;
    ++sleep.asleep_count;
    for (int32_t i = sleep.member_start[as_index(b)]; i < sleep.member_start[as_index(b) + 1];
         ++i) {
        const auto v = as_index(sleep.member[as_index(i)]);
        state.v[v] = {};
        state.x_start[v] = state.x[v];
    }
    for (int32_t i = sleep.border_start[as_index(b)]; i < sleep.border_start[as_index(b) + 1];
         ++i) {
        sleep.before[as_index(i)] = place(state.x[as_index(sleep.border[as_index(i)])]);
    }
}

}  // namespace

void wake_tissue(const Scene& scene, State& state) noexcept {
    Sleep& sleep = state.sleep;
    if (!sleep.enabled()) return;
    const int before = sleep.asleep_count;
    const int32_t known = sleep.known_vertices;
    unsettle_cuts(scene.body, state.body, sleep);
    wake_roused(state.body, sleep);
    if (before == 0) return;
    const ContactSet& contacts = state.scratch->contacts;
    for (int i = 0; i < contacts.candidate_count; ++i) {
        const auto& triangle = touched_triangle(scene, state, contacts.candidates[as_index(i)] / 4);
        for (const int32_t v : triangle.vertex) wake_vertex(sleep, v);
    }
    for (size_t g = 0; g < state.self_contact.pairs.size(); ++g) {
        for (int32_t i = 0; i < state.self_contact.count[g]; ++i) {
            const TissuePair& pair = state.self_contact.pairs[g][as_index(i)];
            wake_vertex(sleep, pair.vertex);
            for (const int32_t v : corners(scene.body, state.body, pair.tet)) wake_vertex(sleep, v);
        }
    }
    for (const Grasp& grasp : state.grasps) {
        for (int i = 0; i < grasp.count; ++i) wake_vertex(sleep, grasp.held[as_index(i)].vertex);
    }
    for (const SutureState& needle : state.suturing.needle) wake_bonded(scene, state, needle);
    for (int b = 0; b < sleep.blocks(); ++b) {
        if (sleep.near_awake[as_index(b)] != 0 && shaken(state.body, sleep, b))
            wake_block(sleep, b);
    }
    if (patch_sleeps(scene, state) && patch_shaken(scene, state))
        wake_vertex(sleep, scene.patch->first_vertex);
    // New copies take part even where nobody had to wake for them.
    if (sleep.asleep_count != before || sleep.known_vertices != known)
        set_runs(scene.body, state.body, sleep);
}

void doze(const Scene& scene, State& state) noexcept {
    Sleep& sleep = state.sleep;
    if (!sleep.enabled() || state.frame % kLook != 0) return;
    bool changed = false;
    for (int b = 0; b < sleep.blocks(); ++b) {
        if (sleep.asleep[as_index(b)] != 0 || sleep.restless[as_index(b)] != 0) continue;
        uint8_t& looks = sleep.calm[as_index(b)];
        looks = is_calm(state, sleep, b) ? static_cast<uint8_t>(looks + 1) : uint8_t{0};
        if (looks < kCalmLooks) continue;
        // What bears a patch falls asleep first.
        const bool patch = scene.patch && b == sleep.block[as_index(scene.patch->first_vertex)];
        if (patch && patch_shaken(scene, state)) {
            looks = kCalmLooks;
            continue;
        }
        fall_asleep(state.body, sleep, b);
        changed = true;
    }
    if (changed) set_runs(scene.body, state.body, sleep);
}

}  // namespace placode::sim
