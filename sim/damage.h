// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Damage that is summed up while an attempt runs and told in few events: tissue held stretched, and
// how far heat went beyond the edge of the incision. Nothing here decides the future.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/event.h"
#include "sim/geometry.h"

namespace placode::sim {

struct Scene;
struct State;

/// Events of these sums, apart from those of sim/event.h; append only.
/// Over-stretch of one tissue since the last such event: value = rest volume x time [m^3 s],
/// value2 = largest principal stretch, element and place = where that was. An attempt has one at
/// its first frame, so that its absence says "not recorded".
inline constexpr EventKind kStretchSum{80};
/// At the end of an attempt, one for each ray that crosses an incision: value = how far beyond the
/// edge Omega is above 1 [m], value2 = the same for CEM43 above 240 min [m], rest_position = the
/// edge, element = 2 * point of the planned contour + side (0 towards the placode, 1 outwards). The
/// first has element -1 and value = number of rays: its absence says "not recorded".
inline constexpr EventKind kThermalSpread{81};

/// A spell beyond the injury stretch counts from here on, then with its whole length [s].
inline constexpr double kOverStretchS = 0.05;
inline constexpr double kSpreadDamage = 1, kSpreadDoseMin = 240;  ///< The iso-lines.
inline constexpr double kSpreadFarthestM = 0.004;                 ///< A ray ends here.

/// Which tets are beyond their injury stretch, since when, and what that comes to.
class OverStretch {
 public:
    OverStretch(int tets, double frame_s);
    /// A check found the tet beyond its limit. The time between two such checks in a row counts.
    void beyond(int tet, int64_t frame, double stretch, double volume_m3, Tissue tissue) noexcept;
    /// A check found it below.
    void below(int tet) noexcept { since_[static_cast<size_t>(tet)] = -1; }
    /// Tissue asleep keeps its stretch and is not checked: brings its spells up to this frame.
    void catch_up(const Scene& scene, const State& state) noexcept;

    struct Sum {
        double volume_time_m3_s = 0, stretch = 0;
        int32_t tet = -1;
    };
    /// What came together since the last call, by tissue.
    [[nodiscard]] std::array<Sum, kTissueCount> take() noexcept;

 private:
    /// True when the spell is long enough to count.
    bool extend(int tet, int64_t frame, double volume_m3, Tissue tissue) noexcept;
    std::vector<int32_t> since_, last_;  // (T) frames; since -1 = not beyond
    std::array<Sum, kTissueCount> sum_{};
    double frame_s_;
};

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

/// What remains to be told after the last frame: open sums of over-stretch, thermal spread.
[[nodiscard]] std::vector<Event> closing_events(const Scene& scene, State& state);

}  // namespace placode::sim
