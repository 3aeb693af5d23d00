// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/blade_slides.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/cutting/slide_choice.h"
#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr double kStretch = 6e-4;  // of the blades that a frame looks at [m]
constexpr int kSlidesPerFrame = 8;

/// Lists the vertices beside the plane whose edges it crosses along this stretch of the blades.
void list_choices(State& state, const SlideChooser& chooser, double from_m, double to_m) noexcept {
    State::Scratch& scratch = *state.scratch;
    scratch.choices.clear();
    const double pad = scratch.longest_edge_m;
    const auto vertices = static_cast<int>(state.body.x.size());
    for (int v = 0; v < vertices; ++v) {
        const Vec3 p = chooser.place(v);
        if (std::abs(p.x()) > pad || p.z() < from_m || p.z() >= to_m) continue;
        if (scratch.choices.size() == kMostChoices) return;
        if (!can_split(state.body, v) || state.body.x[v].w == 0 || !chooser.crossed(v)) continue;
        scratch.choices.push_back(chooser.choose(v));
    }
}

/// The shortest slide that is left; nullptr = none.
SlideChoice* shortest(State::Scratch& scratch) noexcept {
    SlideChoice* best = nullptr;
    for (SlideChoice& one : scratch.choices) {
        if (one.shift_m >= 0 && (best == nullptr || one.shift_m < best->shift_m)) best = &one;
    }
    return best;
}

/// After a slide: what the vertices around it can do now.
void choose_again(const Scene& scene, State& state, const SlideChooser& chooser,
                  int32_t slid) noexcept {
    const uint32_t stamp = ++state.scratch->stamp;
    auto& near = state.scratch->near_blade;
    for (const int32_t t : tets_around(scene.body, state.body, slid)) {
        for (const int32_t v : corners(scene.body, state.body, t)) near[as_index(v)] = stamp;
    }
    for (SlideChoice& one : state.scratch->choices) {
        const int32_t v = one.slide.vertex;
        if (near[as_index(v)] != stamp) continue;
        one = chooser.crossed(v) ? chooser.choose(v) : SlideChoice{};
        one.slide.vertex = v;
    }
}

}  // namespace

void begin_slides(const Scene& scene, const State& state, Scissors& s,
                  const BladeReach& reach) noexcept {
    s.sliding = scene.cut_snap > 0 && !s.met_T.empty() ? 1 : 0;
    s.slid_to_m = static_cast<float>(-reach.length_m - 2 * reach.pad_m);
    s.met_count = s.sliding == 0 ? 0 : state.body.topology->vertices;
    for (int32_t v = 0; v < s.met_count; ++v) {
        const Vec3f p = (s.plane * position(state.body, v)).cast<float>();
        s.met_T[as_index(v)] = {p.x(), p.y(), p.z()};
    }
}

bool slide_to_blades(const Scene& scene, State& state, Scissors& s,
                     const BladeReach& reach) noexcept {
    const double end = 2 * reach.pad_m;
    const double from = s.slid_to_m, to = std::min(end, from + kStretch);
    const SlideChooser chooser(scene, state, s, reach);
    list_choices(state, chooser, from, to);
    for (int made = 0; made < kSlidesPerFrame;) {
        SlideChoice* one = shortest(*state.scratch);
        if (one == nullptr) {
            s.slid_to_m = static_cast<float>(to);
            break;
        }
        const Slide slide = one->slide;
        one->shift_m = -1;
        if (!slide_vertex(scene.body, state.body, slide, SlideLimits{})) {
            ++state.slides_refused;
            continue;
        }
        Vec3 met = chooser.place(slide.vertex);
        const Vec3 from_there = met;
        for (size_t i = 0; i < 3; ++i) {
            if (slide.towards[i] >= 0)
                met += static_cast<double>(slide.share[i]) *
                       (chooser.place(slide.towards[i]) - from_there);
        }
        // On the plane, exactly.
        if (slide.vertex < s.met_count)
            s.met_T[as_index(slide.vertex)] = {0, static_cast<float>(met.y()),
                                               static_cast<float>(met.z())};
        ++state.slides;
        ++made;
        choose_again(scene, state, chooser, slide.vertex);
    }
    return s.slid_to_m < static_cast<float>(end);
}

}  // namespace placode::sim
