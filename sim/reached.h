// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an attempt has reached so far: how much of the ring is cut and how much of the marked tissue
// is out. The one place for it: picture, samples and ledger ask here, and the score reads what the
// ledger keeps.

#include <vector>

#include "sim/event.h"

namespace placode::sim {

struct Scene;
struct State;

/// Events of these sums, apart from those of sim/event.h; append only.
/// Marked tissue drawn out of the field as pieces: value = its rest volume so far [m^3], value2 =
/// its share of all that is marked. One at the first frame, one with every piece that goes, one
/// after the last frame (value2 of kPieceOut counts all that is gone). The last has where most of
/// the rest hangs in rest_position (0 0 0 = none).
inline constexpr EventKind kTakenOut{82};
/// After the last frame: marked tissue that went otherwise (burned, torn, washed away as crumbs),
/// as above.
inline constexpr EventKind kMarkedLost{83};
/// After the last frame, one for each stretch of the planned contour that is not cut: value = its
/// length [m], rest_position = its middle. The first has element -1, value = their number, value2 =
/// ring_share().
inline constexpr EventKind kRingGap{84};
/// At the first frame: value = kLedgerVersion. What a ledger without it lacks is not known.
inline constexpr EventKind kLedgerWritten{85};

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
