// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The random numbers of a hand. Same seed, same bits.

#include <array>
#include <cstdint>

namespace placode::haptics {

/// xoshiro256** (Blackman & Vigna): the same numbers with every standard library.
class OperatorRandom {
 public:
    explicit OperatorRandom(uint64_t seed) noexcept;
    [[nodiscard]] double uniform() noexcept;  ///< [0, 1)
    [[nodiscard]] double uniform(const std::array<double, 2>& range) noexcept;
    [[nodiscard]] double normal() noexcept;  ///< Sum of twelve uniforms, minus six.

 private:
    std::array<uint64_t, 4> state_{};
};

}  // namespace placode::haptics
