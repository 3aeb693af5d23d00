// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far a wave gets in a substep, which decides where a method is valid. Of a spec: a SoftBody
// packs its mesh for the kernels, which has limits that double precision has not.

#include <array>

#include "sim/solver/soft_body.h"

namespace placode::sim {

/// As SoftBody::courant_numbers.
[[nodiscard]] std::array<double, kTissueCount> courant_numbers(const SoftBodySpec& spec);

}  // namespace placode::sim
