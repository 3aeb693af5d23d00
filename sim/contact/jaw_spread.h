// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Jaws that open in tissue (ToolSpec::jaws_spread): each is where the picture shows it and pushes
// what lies beside it away. A hand spreads them no harder than ToolSpec::jaw_force_n each, so that
// they stop where tissue withstands that.

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame: opens the shapes of the jaws towards what the hand asks, as far as the force
/// and speed of a hand go, and sets ToolState::jaw_rad to where they are.
void spread_jaws(const Scene& scene, State& state) noexcept;

/// End of a substep: what tissue pushes on each jaw.
void weigh_jaws(State& state) noexcept;

}  // namespace placode::sim
