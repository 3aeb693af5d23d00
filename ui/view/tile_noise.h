// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Noise that tiles: gradient noise on a torus, and a sum of octaves of it.

#include <random>
#include <vector>

namespace placode::view {

/// (size x size) values around 0: `octaves` of gradient noise, the first with `period` cells, each
/// next one with twice as many and `gain` times the amplitude.
[[nodiscard]] std::vector<double> fbm_field(int size, int period, int octaves, double gain,
                                            std::mt19937_64& random);

}  // namespace placode::view
