// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/tissue.h"

#include <cassert>

namespace placode::sim {

std::string_view tissue_name(Tissue tissue) noexcept {
    constexpr std::array<std::string_view, kTissueCount> kNames{
        "skin", "thin_skin", "subcutis", "muscle", "zone", "placode", "gel", "dura"};
    const auto i = static_cast<size_t>(tissue);
    return i < kNames.size() ? kNames[i] : "unknown";
}

NeoHookean neo_hookean(double youngs_modulus_pa, double poissons_ratio) noexcept {
    assert(youngs_modulus_pa > 0 && poissons_ratio > -1 && poissons_ratio < 0.5);
    // Linearising the energy at rest gives lambda_Lame = lambda - mu, hence the sum below.
    NeoHookean c;
    c.mu_pa = youngs_modulus_pa / (2 * (1 + poissons_ratio));
    const double lame =
        youngs_modulus_pa * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    c.lambda_pa = lame + c.mu_pa;
    c.gamma = 1 + c.mu_pa / c.lambda_pa;
    return c;
}

}  // namespace placode::sim
