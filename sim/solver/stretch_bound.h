// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which tets are surely below a stretch, without an eigenvalue: nearly all of them, so that only
// the few others have to be looked at closely.

#include <array>
#include <cstdint>
#include <span>

#include "sim/solver/soft_body.h"

namespace placode::sim {

inline constexpr int kStretchGroup = 4;  ///< Tets that are looked at side by side.

/// By tissue, from the materials as they are now.
struct StretchLimits {
    explicit StretchLimits(const MaterialTable& materials) noexcept;
    std::array<float, kTissueCount> stretch{};  ///< The least that matters: injury or failure; > 1.
    std::array<float, kTissueCount> mu_pa{};
};

/// Bit i is set when no principal stretch of tet i of the group (at most kStretchGroup) reaches the
/// limit of its tissue. The greatest one, L, leaves the two others the product J / L, so that
/// tr C >= L^2 + 2 J / L, which grows with L above the cube root of J. In floats with a margin:
/// where it is close the answer is no.
[[nodiscard]] uint32_t surely_below(const SoftBody& body, const SoftBodyState& state,
                                    std::span<const int32_t> tets,
                                    const StretchLimits& limits) noexcept;

}  // namespace placode::sim
