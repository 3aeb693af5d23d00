// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The two parts of add_sheet(), with the same bits, for those who need one: half of the work.

#include "sim/solver/sheet.h"

namespace placode::sim {

/// dE/dx [N].
void add_sheet_force(const SheetElements& sheet, const Float4* x, int32_t vertex,
                     Vec3& gradient) noexcept;
/// The positive semidefinite Hessian [N/m].
void add_sheet_stiffness(const SheetElements& sheet, const Float4* x, int32_t vertex,
                         Mat3& hessian) noexcept;

}  // namespace placode::sim
