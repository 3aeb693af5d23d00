// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Blunt dissection: subcutis parts from the fascia below it (Scene::plane) face by face where it is
// pulled off or along it harder than it holds. Nothing is removed; vertices split as in a cut
// (separation.h). Pressed together it bears more shear, as with friction.

#include <cstdint>
#include <vector>

#include "sim/core/event.h"
#include "sim/core/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// One frame: looks at a sixteenth of the faces. A face parts that was found above its strength
/// three times in a row. Nothing in a scene without a plane.
void part_plane(const Scene& scene, State& state) noexcept;

/// Cauchy traction on a face of the plane [Pa], seen from below: positive along `normal` (upwards,
/// where the face lies now) pulls it off. The mean over the prism above it.
[[nodiscard]] Vec3 traction_on(const Scene& scene, const State& state, int face,
                               Vec3& normal) noexcept;

/// The tissue above a face of the plane has come off, or is gone.
[[nodiscard]] bool is_parted(const Scene& scene, const State& state, int face) noexcept;

/// The tissue above a face has come off the tissue below it, and both are there: what was torn away
/// frees nothing.
[[nodiscard]] bool is_freed(const Scene& scene, const State& state, int face) noexcept;

/// How far skin is undermined from a slit's edge, along a ray of the plane [m]: up to the first
/// face that holds or is torn away.
[[nodiscard]] double undermined_m(const Scene& scene, const State& state, int ray) noexcept;

/// Freed area on one side of the slit (1 = left, -1 = right), at rest [m^2].
[[nodiscard]] double undermined_m2(const Scene& scene, const State& state, int side) noexcept;

/// Areas on one side of the slit, at rest [m^2].
struct UnderminedArea {
    double wanted_m2 = 0;  ///< To be freed,
    double parted_m2 = 0;  ///< of that what holds no longer,
    double freed_m2 = 0;   ///< and of that what is not torn away.
    double beyond_m2 = 0;  ///< Parted farther from the edges than skin may be freed.
};
[[nodiscard]] UnderminedArea undermined_area(const Scene& scene, const State& state,
                                             int side) noexcept;

}  // namespace placode::sim
