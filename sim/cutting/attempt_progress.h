// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an attempt has reached so far: how much of the ring is cut and how much of the marked tissue
// is out. The one place for it: picture, samples and ledger ask here, and the score reads what the
// ledger keeps.

#include <vector>

#include "sim/core/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// Of what a program writes into the ledger. 1: tissue taken out, gaps of the ring, buried tips.
inline constexpr int kLedgerVersion = 1;

/// Points of the planned contour that are cut, 0..1; 0 without a contour. See CutProgress.
[[nodiscard]] double ring_share(const State& state) noexcept;

/// Share of the marked tissue that was drawn out of the field in pieces, 0..1; -1 where nothing is
/// marked. What heat removed, force tore or water washed away does not count.
[[nodiscard]] double taken_out_share(const Scene& scene, const State& state) noexcept;

/// Share of the marked tissue that is no longer there, however it went, 0..1: what the picture
/// shows. Pieces count from when they go. -1 where nothing is marked.
[[nodiscard]] double gone_share(const Scene& scene, const State& state) noexcept;

/// kTakenOut as of now, without a place.
[[nodiscard]] Event taken_out_event(const Scene& scene, const State& state) noexcept;

/// kTakenOut, kMarkedLost and kRingGap after the last frame. Allocates.
[[nodiscard]] std::vector<Event> reached_events(const Scene& scene, const State& state);

}  // namespace placode::sim
