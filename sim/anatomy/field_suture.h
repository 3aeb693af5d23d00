// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/anatomy/operative_field.h"

namespace placode::sim {

/// Gives a scene its needle and where it starts; nothing where the spec has none.
/// @pre check_field_spec() has passed it.
void add_suture(const OperativeFieldSpec& spec, Scene& scene);

}  // namespace placode::sim
