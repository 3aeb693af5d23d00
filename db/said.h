// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the store says to people: sim/core/said.h, under the store's own name.

#include "sim/core/said.h"

namespace placode::db {
using sim::Said;
}
