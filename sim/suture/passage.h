// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Places of the tissue through which a needle has gone, and its thread after it.

#include "sim/suture/tissue_point.h"

namespace placode::sim {

inline constexpr int kMostPassages = 1024;

enum class PassageKind : uint8_t { kEntry, kInner, kExit };

/// A place of the tissue through which the needle has gone. Ordered along needle and thread: the
/// newest, nearest to the needle's point, is the last.
struct Passage {
    TissuePoint at;
    PassageKind kind = PassageKind::kInner;
    int32_t channel = 0;     ///< Counts up with every entry.
    double gap_m = 0;        ///< Cut between the passage before it and this one; 0 at an entry.
    double hold_n_m = 0;     ///< Stiffness of its bond, for life: a change would make energy.
    double sticks_at_m = 0;  ///< Arc coordinate at which friction holds it.
};
template <class Visit>
void fields(Of<Passage> auto& s, Visit&& visit) {
    auto& [at, kind, channel, gap_m, hold_n_m, sticks_at_m] = s;
    visit.state(at, kind, channel, gap_m, hold_n_m, sticks_at_m);
}

}  // namespace placode::sim
