// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/operator_profile.h"

namespace placode::haptics {

namespace {

constexpr std::array kLevels{OperatorLevel::kExpert, OperatorLevel::kIntermediate,
                             OperatorLevel::kNovice};

// What is not said has the default of the header.
constexpr OperatorProfile kExpert{
    .look_s = 2,
    .free_speed_m_s = 0.02,
    .cut_speed_m_s = 0.0038,
    .wander_m = 7e-5,
    .wander_inward_m = -2.5e-4,  // Keeps a little outside the line: heat runs inwards as well.
    .lean_out_m = 5e-4,
    .lean_up_m = 3e-4,
    .press_m = 4e-4,
    .press_limit_m = 6e-4,
    .watch = 0.55,
    .wait_s = 0.3,
    .burst_s = 3,
    .pause_s = 0.3,
    .second_out_m = 1.5e-4,
    .clear_m = 9e-4,
    .clear_metal_m = 4.5e-4,
    .cool_s = 12,
    .seeks_bridges = true,
    .tries = 4,
    .patience_s = 140,
};

constexpr OperatorProfile kIntermediate{
    .look_s = 4,
    .free_speed_m_s = 0.012,
    .descend_m_s = 0.004,
    .cut_speed_m_s = 0.0032,
    .speed_noise = 0.25,
    .tremor_m = 1.2e-4,
    .wander_m = 1.8e-4,
    .wander_inward_m = -2.4e-4,
    .lean_out_m = 4e-4,
    .lean_up_m = 2.5e-4,
    .press_m = 4e-4,
    .press_limit_m = 7e-4,
    .watch = 0.55,
    .wait_s = 0.4,
    .burst_s = 2,
    .pause_s = 1.2,
    .settle_s = 0.25,
    .early_chance = 0.4,
    .early_s = 0.5,
    .hesitate_hz = 0.1,
    .hesitate_s = {0.2, 0.4},
    .skip_per_m = 40,
    .skip_m = {0.8e-3, 1.4e-3},
    .submovements = 2,
    .aim_error_m = 1e-3,
    .notice_gap_m = 6e-4,
    .second_care = 0.5,
    .second_out_m = 2e-4,
    .clear_m = 9.5e-4,
    .clear_metal_m = 3e-4,
    .cool_s = 12,
    .tries = 4,
    .patience_s = 80,
};

constexpr OperatorProfile kNovice{
    .look_s = 3,
    .free_speed_m_s = 0.014,
    .descend_m_s = 0.004,
    .cut_speed_m_s = 0.0026,
    .speed_noise = 0.6,
    .tremor_m = 3e-4,
    .wander_m = 6e-4,
    .wander_s = 0.6,
    .wander_inward_m = 4e-4,
    .press_m = 4e-4,
    .press_limit_m = 1.4e-3,
    .force_limit_n = 0.12,
    .watch = 0.2,
    .wait_s = 0.3,
    .burst_s = 3,
    .pause_s = 0.9,
    .settle_s = 0.1,
    .early_chance = 0.9,
    .early_s = 1.3,
    .hesitate_hz = 0.14,
    .hesitate_s = {1.1, 2.0},
    .skip_per_m = 120,
    .skip_m = {1e-3, 3e-3},
    .overshoots = 2,
    .overshoot_m = 3.2e-3,
    .overshoot_notice_s = 0.25,
    .submovements = 3,
    .aim_error_m = 2.5e-3,
    .notice_gap_m = 2.5e-3,
    .second_care = 0.9,
    .tries = 2,
    .patience_s = 80,
};

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
    static constexpr std::array kProfiles{kExpert, kIntermediate, kNovice};
    return kProfiles[static_cast<size_t>(level)];
}

}  // namespace placode::haptics
