// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far the walls of a slit stand apart, true to some micrometres: what a suture is to close.

#include <vector>

#include "sim/core/event.h"
#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Distance between the walls at a station and level [m], less kTissueGapM; 0 where they touch,
/// and where one has passed the other by up to 0.3 mm: past that they ride over each other.
/// @pre 0 <= station < stations, 0 <= level < layers.
[[nodiscard]] double slit_gap(const Scene& scene, const State& state, int station,
                              int level) noexcept;

/// The least of open_gap() over the depth: nothing passes a slit that is shut at any depth.
/// @pre 0 <= station < stations.
[[nodiscard]] double narrowest_gap(const Scene& scene, const State& state, int station) noexcept;

/// As slit_gap(), but where tissue of a wall is gone as open as it was at rest, wherever the rags
/// lie: tissue that is torn out lets the edges come together, and must not count as closing them.
/// At the floor (level == layers) between its own two vertices, and where it is torn no less than
/// at the level above. @pre 0 <= station < stations, 0 <= level <= layers.
[[nodiscard]] double open_gap(const Scene& scene, const State& state, int station,
                              int level) noexcept;

/// Nothing has been torn or burned away at this vertex, and it is somewhere.
[[nodiscard]] bool is_whole(const Scene& scene, const State& state, int32_t vertex) noexcept;

/// Between both walls at the surface, at rest [m]. @pre 0 <= station < stations.
[[nodiscard]] Vec3 middle_at_rest(const Scene& scene, int station) noexcept;
/// From the surface down to a level, at rest [m].
/// @pre 0 <= station < stations, 0 <= level <= layers.
[[nodiscard]] double depth_at_rest(const Scene& scene, int station, int level) noexcept;

/// Station whose middle lies nearest to a place in the plane at rest [m]; -1 without a slit.
[[nodiscard]] int nearest_station(const Scene& scene, const Vec2& place) noexcept;

/// Whether a place in the plane at rest [m] lies in the slit or on its walls.
[[nodiscard]] bool in_slit(const Scene& scene, const Vec2& place) noexcept;

/// Whether a place at rest [m] lies on the underside of skin that can be undermined, nearer to the
/// slit's floor than to the surface. False in a scene without a plane.
[[nodiscard]] bool below_skin(const Scene& scene, const Vec3& place) noexcept;

/// kSlitGap of the walls as they stand, without its time; nothing without a slit. Where tissue of a
/// wall is gone the slit counts as open as it was at rest. Allocates.
[[nodiscard]] std::vector<Event> slit_events(const Scene& scene, const State& state);

}  // namespace placode::sim
