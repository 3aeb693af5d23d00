// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A hand without sense: every instrument stabs, presses, drags and withdraws at random, at up to
// 0.5 m/s. Measures how far instruments get into tissue and whether anything ceases to be a number.

#include <cstdint>
#include <functional>

#include "sim/step/step.h"

namespace placode::sim {

struct PokeOptions {
    int64_t frames = 10000;
    uint64_t seed = 1;
    double fastest_m_s = 0.5;   ///< Hand speed of a poke: 0.02 to this.
    double deepest_m = 0.0015;  ///< The hand goes up to this far below the surface.
    double longest_drag_m = 0.003;
    std::function<void(int64_t done)> progress;  ///< Called every 10,000 frames; may be empty.
};

struct PokeReport {
    int64_t frames = 0, touching = 0;  ///< Frames; those with an instrument in touch.
    double median_m = 0, p99_m = 0, p999_m = 0, deepest_m = 0;  ///< Penetration, of the touching.
    double largest_force_n = 0, fastest_m_s = 0;                ///< On a tool; of any vertex.
    int64_t not_finite = 0, dropped = 0, step_limited = 0;      ///< Frames with these flags.
    int64_t deepest_frame = -1;
};

/// How far the instrument overlaps the surface [m]; 0 or less = apart, at most `reach_m` away.
/// Faces that look away from the instrument do not count unless its axis runs through them.
[[nodiscard]] double penetration(const State& state, int tool, double reach_m);

/// Pokes at random places of the upper surface. The scope stays out of the way.
[[nodiscard]] PokeReport random_pokes(const Scene& scene, State& state, const PokeOptions& options);

}  // namespace placode::sim
