// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What of the skin nobody may take: one rule for what burns and for what leaves with a piece.

#include "sim/core/tissue.h"

namespace placode::sim {

/// A cut may reach this far beyond the edge of the lesion, wherever the plan runs; farther out skin
/// is healthy and no part of the operation [m].
inline constexpr double kOutsideSkinM = 0.001;

[[nodiscard]] constexpr bool is_skin(Tissue tissue) noexcept {
    return tissue == Tissue::kSkin || tissue == Tissue::kThinSkin;
}

}  // namespace placode::sim
