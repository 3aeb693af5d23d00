// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Is a sewn slit watertight? Fluid that stands at its floor is put under rising pressure. It flows
// through what gapes and presses the walls apart on its way, so that gap and flow are found
// together. The skin around is not lifted from below, and holes of needle and thread do not leak.

#include <array>
#include <span>
#include <vector>

#include "sim/core/event.h"
#include "sim/core/geometry.h"
#include "sim/world/slit.h"

namespace placode::sim {

struct Scene;
struct State;

/// What fluid does in a slit: flow by its gaps, loads on its walls and floor by the flow.
class SlitPressure {
 public:
    /// @pre scene.slit.watertight.
    SlitPressure(const Scene& scene, State& state);
    /// Before a frame: the flow at this pressure through the slit as it stands, and its loads. They
    /// follow it within some frames, so that wall and flow do not chase each other.
    void push(double pressure_pa) noexcept;
    [[nodiscard]] double flow_m3_s() const noexcept;
    /// Of each station [m3/s].
    [[nodiscard]] std::span<const double> flows() const noexcept { return flow_m3_s_; }
    /// Of each station how far its walls stood apart when it was pushed [m], the least over the
    /// depth.
    [[nodiscard]] std::span<const double> gaps() const noexcept { return gap_m_; }

 private:
    void flow_at(int station, double pressure_pa) noexcept;
    void press(const std::array<int32_t, 4>& corners, double pressure_pa) noexcept;

    const Scene& scene_;
    State& state_;
    std::vector<double> length_m_, flow_m3_s_, gap_m_;  // of each station
    /// Of each station, between a level and the next.
    std::vector<std::array<double, Slit::kMostLevels>> wall_pa_;
    std::vector<int32_t> vertices_;  // that bear loads, rising
    std::vector<Vec3> load_n_;
};

/// A station is open once it lets more than this share of a burst through: 0.1 ml/min where a burst
/// is 10. Planning value: a drop every half minute.
inline constexpr double kOpenShare = 0.01;

/// kWatertight: the leak at kPassPa and at kGoodPa, the pressure that the slit held, and what each
/// station leaks at each of them; with it kSlitPressed, and kSlitOpened of each station. Spoils
/// this state, in which no hand touches the tissue. Nothing for a scene without such a test. The
/// same on every number of threads. Allocates.
[[nodiscard]] std::vector<Event> watertight_events(const Scene& scene, State& state);

}  // namespace placode::sim
