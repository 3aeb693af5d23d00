// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/separation.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "sim/cutting/grasp.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kMostDirty = 40;  // strips to rebuild a frame, some 4 us each

/// Groups of the living tets around a vertex.
struct Groups {
    std::array<int32_t, kMostAround> tet{};
    std::array<int8_t, kMostAround> group{};
    int tets = 0, groups = 0;
};

void find_groups(const Scene& scene, const State& state, int v, Groups& out) noexcept {
    for (const int32_t t : tets_around(scene.body, state.body, v)) {
        if (state.body.tet_alive[t] && out.tets < kMostAround) out.tet[out.tets++] = t;
    }
    out.group.fill(-1);
    std::array<int16_t, kMostAround> stack;
    for (int seed = 0; seed < out.tets; ++seed) {
        if (out.group[seed] >= 0) continue;
        int top = 0;
        const auto reach = [&](int i) {
            out.group[i] = static_cast<int8_t>(out.groups);
            stack[top++] = static_cast<int16_t>(i);
        };
        reach(seed);
        while (top > 0) {
            const int t = out.tet[stack[--top]];
            const auto& c = corners(scene.body, state.body, t);
            for (int f = 0; f < 4; ++f) {
                if (c[f] == v || state.surface.on_surface(t, f)) continue;
                const int other = scene.surface.neighbours()[t][f];
                for (int i = 0; i < out.tets; ++i) {
                    if (out.tet[i] == other && out.group[i] < 0) reach(i);
                }
            }
        }
        ++out.groups;
    }
}

/// Gives every group but the largest a vertex of its own.
void split(const Scene& scene, State& state, int v, const Groups& groups) noexcept {
    std::array<int, kMostAround> size{};
    for (int i = 0; i < groups.tets; ++i) ++size[groups.group[i]];
    const int stays = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    for (int g = 0; g < groups.groups; ++g) {
        if (g == stays) continue;
        std::array<int32_t, kMostAround> moved;
        int count = 0;
        for (int i = 0; i < groups.tets; ++i) {
            if (groups.group[i] == g) moved[count++] = groups.tet[i];
        }
        const int copy =
            split_vertex(scene.body, state.body, v, {moved.data(), static_cast<size_t>(count)});
        if (copy < 0) {
            state.flags |= kCutRefused;
            return;
        }
        for (int i = 0; i < count; ++i) {
            state.surface.follow_corners(moved[i], current_tets(state.body));
        }
        hold_copy(scene, state, v, copy);
        ++state.splits;
    }
}

/// True while there are spare vertices for one more face beside those that wait: each of its
/// corners may need one. What is cut without them would count as cut and hang together still.
bool has_room_to_cut(const State& state) noexcept {
    return spares_left(state.body) >= state.separation.count + 3;
}

}  // namespace

SeparationQueue::SeparationQueue(const Scene& scene)
    : vertex(scene.body.vertex_capacity()), waiting(scene.body.vertex_capacity(), 0) {}

void queue_separation(const Scene&, State& state, int vertex) noexcept {
    SeparationQueue& queue = state.separation;
    if (!can_split(state.body, vertex) || queue.waiting[vertex]) return;
    queue.waiting[vertex] = 1;
    const auto size = static_cast<int32_t>(queue.vertex.size());
    queue.vertex[(queue.head + queue.count++) % size] = vertex;
}

bool cut_face(const Scene& scene, State& state, int tet, int f) noexcept {
    assert(state.body.tet_alive[tet] != 0);
    if (!state.body.topology || state.surface.on_surface(tet, f)) return false;
    if (!has_room_to_cut(state)) {
        state.flags |= kCutRefused;
        return false;
    }
    state.surface.cut_face(scene.surface, scene.body.mesh(), tet, f, current_tets(state.body));
    const auto& c = corners(scene.body, state.body, tet);
    for (int k = 0; k < 4; ++k) {
        if (k != f) queue_separation(scene, state, c[k]);
    }
    return true;
}

void separate(const Scene& scene, State& state) noexcept {
    SeparationQueue& queue = state.separation;
    if (queue.count == 0) return;
    const auto size = static_cast<int32_t>(queue.vertex.size());
    while (queue.count > 0 && state.body.topology->dirty_count < kMostDirty) {
        const int v = queue.vertex[queue.head];
        queue.head = (queue.head + 1) % size;
        --queue.count;
        queue.waiting[v] = 0;
        Groups groups;
        find_groups(scene, state, v, groups);
        if (groups.groups > 1) split(scene, state, v, groups);
    }
    repack(state.body);
}

}  // namespace placode::sim
