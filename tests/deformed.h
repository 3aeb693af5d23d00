// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Deformed states of reference bodies.

#include <cstdint>

#include "sim/verify/reference_body.h"

namespace placode::sim::test {

/// x = F X with noise, so that nothing cancels by accident.
inline Coordinates deformed(const Coordinates& rest, const Mat3& f, double noise, uint32_t seed) {
    Coordinates x = rest;
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
        x.segment<3>(i) = f * x.segment<3>(i);
        for (int a = 0; a < 3; ++a) {
            seed = seed * 1664525U + 1013904223U;
            x[i + a] += noise * (static_cast<double>(seed >> 8) / (1 << 24) - 0.5);
        }
    }
    return x;
}

}  // namespace placode::sim::test
