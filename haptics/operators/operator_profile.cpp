// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/operator_profile.h"

#include "sim/core/random.h"

namespace placode::haptics {

namespace {

constexpr std::array kLevels{OperatorLevel::kExpert, OperatorLevel::kIntermediate,
                             OperatorLevel::kNovice};

OperatorProfile expert() {
    OperatorProfile p;
    p.look_s = 2;
    p.free_speed_m_s = 0.02;
    p.cut_speed_m_s = 0.0038;
    p.press_m = 4e-4;
    p.press_limit_m = 6e-4;
    p.wander_m = 7e-5;
    p.wander_inward_m = -2.5e-4;  // Keeps a little outside the line: heat runs inwards as well.
    p.second_out_m = 1.5e-4;
    p.clear_m = 9e-4;
    p.clear_metal_m = 4.5e-4;
    p.cool_s = 12;
    p.seeks_bridges = true;
    p.tries = 4;
    p.lean_out_m = 5e-4;
    p.lean_up_m = 3e-4;
    p.watch = 0.55;
    p.wait_s = 0.3;
    p.burst_s = 3;
    p.pause_s = 0.3;
    p.patience_s = 140;
    return p;
}

OperatorProfile intermediate() {
    OperatorProfile p;
    p.look_s = 4;
    p.free_speed_m_s = 0.012;
    p.descend_m_s = 0.004;
    p.cut_speed_m_s = 0.0032;
    p.wander_inward_m = -2.4e-4;
    p.lean_out_m = 4e-4;
    p.lean_up_m = 2.5e-4;
    p.press_m = 4e-4;
    p.press_limit_m = 7e-4;
    p.speed_noise = 0.25;
    p.tremor_m = 1.2e-4;
    p.wander_m = 1.8e-4;
    p.watch = 0.55;
    p.wait_s = 0.4;
    p.burst_s = 2;
    p.pause_s = 1.2;
    p.settle_s = 0.25;
    p.early_chance = 0.4;
    p.early_s = 0.5;
    p.hesitate_hz = 0.1;
    p.hesitate_s = {0.2, 0.4};
    p.skip_per_m = 40;
    p.skip_m = {0.8e-3, 1.4e-3};
    p.submovements = 2;
    p.aim_error_m = 1e-3;
    p.notice_gap_m = 6e-4;
    p.second_care = 0.5;
    p.second_out_m = 2e-4;
    p.clear_m = 9.5e-4;
    p.clear_metal_m = 3e-4;
    p.cool_s = 12;
    p.tries = 4;
    p.patience_s = 80;
    return p;
}

OperatorProfile novice() {
    OperatorProfile p;
    p.look_s = 3;
    p.free_speed_m_s = 0.014;
    p.descend_m_s = 0.004;
    p.cut_speed_m_s = 0.0026;
    p.speed_noise = 0.6;
    p.tremor_m = 3e-4;
    p.wander_m = 6e-4;
    p.wander_s = 0.6;
    p.wander_inward_m = 4e-4;
    p.press_m = 4e-4;
    p.press_limit_m = 1.4e-3;
    p.force_limit_n = 0.12;
    p.watch = 0.2;
    p.wait_s = 0.3;
    p.burst_s = 3;
    p.pause_s = 0.9;
    p.settle_s = 0.1;
    p.early_chance = 0.9;
    p.early_s = 1.3;
    p.hesitate_hz = 0.14;
    p.hesitate_s = {1.1, 2.0};
    p.skip_per_m = 120;
    p.skip_m = {1e-3, 3e-3};
    p.overshoots = 2;
    p.overshoot_m = 3.2e-3;
    p.overshoot_notice_s = 0.25;
    p.submovements = 3;
    p.aim_error_m = 2.5e-3;
    p.notice_gap_m = 2.5e-3;
    p.second_care = 0.9;
    p.tries = 2;
    p.patience_s = 80;
    return p;
}

}  // namespace

std::span<const OperatorLevel> operator_levels() noexcept { return kLevels; }

std::string_view operator_name(OperatorLevel level) noexcept {
    switch (level) {
        case OperatorLevel::kExpert:
            return "expert";
        case OperatorLevel::kIntermediate:
            return "intermediate";
        case OperatorLevel::kNovice:
            return "novice";
    }
    return "";
}

std::optional<OperatorLevel> operator_level(std::string_view name) noexcept {
    for (const auto level : kLevels)
        if (operator_name(level) == name) return level;
    return std::nullopt;
}

const OperatorProfile& operator_profile(OperatorLevel level) noexcept {
    static const std::array profiles{expert(), intermediate(), novice()};
    return profiles[static_cast<size_t>(level)];
}

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
