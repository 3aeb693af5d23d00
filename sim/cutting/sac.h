// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The fluid of a cystic lesion (meningomyelocele): no fluid solver, one pressure. The membrane with
// the placode on it closes a sac over the canal. Its pressure follows from what the sac holds and
// the volume under the membrane, pushes on the underside, and drops as fluid leaves through what
// has been cut open (orifice flow). Empty, the membrane sinks onto the canal's floor.

#include "sim/world/sac_state.h"

namespace placode::sim {

struct Scene;
struct State;

/// Volume between the underside and the origin's fan [m^3]: differences count, and the gradient in
/// a vertex off the rim is a third of the area vectors around it.
[[nodiscard]] double sac_volume(const Sac& sac, const State& state) noexcept;

/// Start of a frame of `dt_s`: pressure, leak, loads on the underside, floor. While `held`, the
/// pressure stays what the scene says (the field settles). Never allocates.
void update_sac(const Scene& scene, State& state, double dt_s, bool held) noexcept;

}  // namespace placode::sim
