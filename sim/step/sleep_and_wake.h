// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What wakes sleeping tissue and what lets it fall asleep (sim/solver/sleep.h), once a frame.

namespace placode::sim {

struct Scene;
struct State;

/// Start of a frame, after collect_candidates(): wakes what is touched, held, cut or shaken.
void wake_tissue(const Scene& scene, State& state) noexcept;

/// End of a frame: now and then looks for blocks that have come to rest.
void doze(const Scene& scene, State& state) noexcept;

}  // namespace placode::sim
