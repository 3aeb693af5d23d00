// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far the tips of instruments are from the tissue.

namespace placode::sim {

struct Scene;
struct State;

/// End of a frame: signed distance of every tip to the surface, up to 3 mm, for display and
/// metrics; and what lies next to it.
void measure_tips(const Scene& scene, State& state) noexcept;

/// Signed distance of the tip of tool `t` to the surface [m], negative inside; 1 where no surface
/// lies within `search_m`. After a frame, before the next; costs more the farther it searches.
[[nodiscard]] double tip_gap(const State& state, int t, double search_m) noexcept;

}  // namespace placode::sim
