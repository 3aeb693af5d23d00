// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From who is awake to what the kernels go over. Internal to sleep.h.

#include "sim/solver/sleep.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

/// Runs of batches and vertices, and who is beside whom, after blocks woke or fell asleep.
void set_runs(const SoftBody& body, SoftBodyState& state, Sleep& sleep) noexcept;

}  // namespace placode::sim
