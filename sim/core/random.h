// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Random numbers that are the same on every machine, which those of <random>'s distributions are
// not. Source: Steele, Lea & Flood 2014, SplitMix64.

#include <cstdint>

namespace placode::sim {

/// Spreads a change of one bit over all 64.
[[nodiscard]] constexpr uint64_t mixed_bits(uint64_t z) noexcept {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// What SplitMix64 adds from one number to the next: 2^64 over the golden ratio.
inline constexpr uint64_t kGoldenStep = 0x9e3779b97f4a7c15ULL;

/// A small generator; any seed is as good as another.
class SplitMix64 {
 public:
    explicit constexpr SplitMix64(uint64_t seed) noexcept : state_(seed) {}
    /// Any of the 2^64 numbers.
    constexpr uint64_t next() noexcept { return mixed_bits(state_ += kGoldenStep); }
    /// In [0, 1), in steps of 2^-53.
    constexpr double uniform() noexcept { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    /// In [low, high).
    constexpr double uniform(double low, double high) noexcept {
        return low + (high - low) * uniform();
    }

 private:
    uint64_t state_;
};

}  // namespace placode::sim
