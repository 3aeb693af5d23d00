// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a sewn slit leaks: what each station along it lets through, how far it stands open, when it
// opened, and which bites lie beside it. From the last events of a recording; nothing is simulated.

#include <array>
#include <optional>
#include <vector>

#include "assessment/reason.h"
#include "sim/core/geometry.h"
#include "sim/step/recording.h"

namespace placode::assessment {

inline constexpr double kMlMinPerM3S = 6e7, kPaPerCmH2O = 98.0665;

/// A stretch that leaks less counts as tight in words [m3/s]: 0.1 ml/min.
inline constexpr double kTightM3S = 0.1 / kMlMinPerM3S;

/// Pressures at which each station was looked at: 6 and 12.5 cmH2O, and where the slit burst or the
/// test ended.
enum class LeakStage : uint8_t { kPass, kGood, kLast };
inline constexpr size_t kLeakStages = 3;

/// Numbers of one station at each LeakStage.
using PerStage = std::array<double, kLeakStages>;

struct LeakStation {
    int number = 0;                      ///< In the recording, from 0.
    sim::Vec2 at_m = sim::Vec2::Zero();  ///< Between its walls, at rest.
    double along_m = 0;                  ///< From LeakMap's first end.
    double length_m = 0;                 ///< That it stands for: half the way to its neighbours.
    double gap_m = 0;                    ///< Between its walls, hands off and without pressure.
    PerStage leak_m3_s{};
    PerStage pressed_gap_m{};  ///< Between its walls under that pressure.
    double opened_pa = -1;     ///< Where it began to leak; -1 = it never did.
};

/// A bite beside the slit: along it from the first end, and aside from it [m], above 0 upwards in a
/// picture in which the first end lies left.
struct LeakBite {
    int number = 0;  ///< From 1.
    sim::Vec2 entry_m = sim::Vec2::Zero(), exit_m = sim::Vec2::Zero();
    bool entered = false, left = false, done = false;
    /// Where it crosses the slit. @pre entered and left.
    [[nodiscard]] double along_m() const { return 0.5 * (entry_m.x() + exit_m.x()); }
};

/// Its first end is the left one as the scope shows it, or the upper one where the slit runs rather
/// up and down. Ends lie as far beyond the outermost stations as these from their neighbours.
struct LeakMap {
    std::vector<LeakStation> stations;  ///< From the first end on; two or more.
    std::vector<LeakBite> bites;        ///< Begun ones, in the order of the task.
    double length_m = 0;                ///< From end to end.
    bool upright = false;               ///< The ends are an upper and a lower one.
    PerStage all_m3_s{};                ///< Leak of the whole slit.
    double held_pa = 0;                 ///< It burst here, or the pressure rose no further.
    /// The recording tells what happened at LeakStage::kLast and when each station opened; older
    /// ones do not, then these numbers are 0, and -1 of opened_pa says nothing.
    bool whole = false;
    bool burst = false;  ///< As far as it is whole.
};
/// Absent where no slit was put under pressure, or the test is not all there. Never throws on odd
/// data.
[[nodiscard]] std::optional<LeakMap> leak_map(const sim::Recording& recording);

/// Of the stretches into which done bites divide the slit the one that leaks most.
struct LeakPlace {
    BetweenBites between;                ///< The bites, or ends, beside the stretch.
    int stretch = 0;                     ///< Bites between the first end and it.
    double along_m = 0;                  ///< Of its station that leaks most, from the first end.
    sim::Vec2 at_m = sim::Vec2::Zero();  ///< The same, at rest.
    double leak_m3_s = 0;                ///< Of the whole stretch ..
    double rest_m3_s = 0;                ///< .. and of all others.
};
/// Nothing where nothing leaks, or this was not recorded.
[[nodiscard]] std::optional<LeakPlace> worst_leak(const LeakMap& map, LeakStage stage);

}  // namespace placode::assessment
