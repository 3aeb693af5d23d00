// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/operator_random.h"

#include "sim/core/random.h"

namespace placode::haptics {

OperatorRandom::OperatorRandom(uint64_t seed) noexcept {
    sim::SplitMix64 spread(seed);  // a small seed over the whole state
    for (auto& word : state_) word = spread.next();
}

double OperatorRandom::uniform() noexcept {
    const auto rotated = [](uint64_t x, int k) { return (x << k) | (x >> (64 - k)); };
    const uint64_t result = rotated(state_[1] * 5, 7) * 9, t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotated(state_[3], 45);
    return static_cast<double>(result >> 11) * 0x1.0p-53;
}

double OperatorRandom::uniform(const std::array<double, 2>& range) noexcept {
    return range[0] + (range[1] - range[0]) * uniform();
}

double OperatorRandom::normal() noexcept {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
}

}  // namespace placode::haptics
