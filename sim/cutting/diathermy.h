// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The generator: pedals to power at the bare metal, heat step, and the tets that it vaporises.

#include <cstdint>
#include <span>

#include "sim/core/tool.h"

namespace placode::sim {

struct Scene;
struct State;

/// A needle or hook: its bare metal carries the generator's current.
[[nodiscard]] bool conducts(ToolKind kind) noexcept;

/// Frames between two heat steps (the heat equation is slow: its stable step is several frames).
[[nodiscard]] int heat_interval(const Scene& scene) noexcept;

/// Runs pedals, deposition and, on every heat_interval()-th frame, conduction and vaporisation.
/// `active[t]` becomes 1 while a pedal of tool t drives current. Returns the tets vaporised.
int run_diathermy(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                  std::span<uint8_t> active, double frame_s) noexcept;

}  // namespace placode::sim
