// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Damage that is summed up while an attempt runs and told in few events: tissue held stretched, and
// how far heat went beyond the edge of the incision. Nothing here decides the future.

#include <vector>

#include "sim/core/event.h"
#include "sim/core/geometry.h"
#include "sim/world/ledger_state.h"

namespace placode::sim {

struct Scene;
struct State;

inline constexpr double kSpreadDamage = 1, kSpreadDoseMin = 240;  ///< The iso-lines.
inline constexpr double kSpreadFarthestM = 0.004;                 ///< A ray ends here.

/// Adds the sums of over-stretch to the events of this frame.
void ledger_stretch(const Scene& scene, State& state) noexcept;

/// One ray across the incision on the surface at rest, to one side of it.
struct SpreadRay {
    int point = 0;               ///< Of the planned contour.
    bool outward = false;        ///< Away from the placode.
    Vec3 edge_m = Vec3::Zero();  ///< Where the vaporised tissue ends, at rest.
    double damage_m = 0;         ///< From there to Omega = 1; 0 when it is below at the edge.
    double dose_m = 0;           ///< From there to CEM43 = 240 min.
};
/// Rays perpendicular to the planned contour, one for each of its points and sides, where tissue
/// was vaporised within 2 mm of it. Doses are interpolated on the surface by their logarithms,
/// which go nearly straight with temperature. Allocates: after the last frame only.
[[nodiscard]] std::vector<SpreadRay> thermal_spread(const Scene& scene, const State& state);

/// Omega of a vertex beyond the 10 at which the state freezes it: what one second at the
/// temperature that gives the same CEM43 in a second would do.
[[nodiscard]] double continued_damage(const Scene& scene, double arrhenius,
                                      double cem43_min) noexcept;

/// kThermalSpread as of now: nothing without heat or without a planned contour. Allocates.
[[nodiscard]] std::vector<Event> spread_events(const Scene& scene, const State& state);

/// What remains to be told after the last frame: open sums of over-stretch, spells that are not
/// over, thermal spread.
[[nodiscard]] std::vector<Event> closing_events(const Scene& scene, State& state);

}  // namespace placode::sim
