// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who is at work: habits by level, as data. Levels differ by behaviour only; nobody tells the score
// who is at work.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace placode::haptics {

enum class OperatorLevel : uint8_t { kExpert, kIntermediate, kNovice };
[[nodiscard]] std::span<const OperatorLevel> operator_levels() noexcept;
[[nodiscard]] std::string_view operator_name(OperatorLevel level) noexcept;
[[nodiscard]] std::optional<OperatorLevel> operator_level(std::string_view name) noexcept;

/// Habits of one level. Chosen by trial on the default operative field so that the levels order by
/// what they do to the tissue.
struct OperatorProfile {
    double look_s = 1;             ///< Looks before the first motion.
    double free_speed_m_s = 0.03;  ///< Mean speed of a free motion.
    double descend_m_s = 0.006;    ///< Last millimetres down to the tissue.
    double cut_speed_m_s = 0.003;  ///< Along the contour, when it cuts well.
    double speed_noise = 0;        ///< Irregularity of that speed, rms share.
    double tremor_m = 5e-5;        ///< Amplitude, 8 to 12 Hz.
    double wander_m = 1e-4;        ///< Slow deviation from the contour, rms.
    double wander_s = 0.8;         ///< Its correlation time.
    double wander_inward_m = 0;    ///< Mean deviation towards the placode.
    double lean_out_m = 0;         ///< Further out where the needle leans over the placode.
    double lean_up_m = 0;          ///< And less deep there.
    double press_m = 2.5e-4;       ///< Depth of the tip below the contour.
    double press_limit_m = 1e-3;   ///< Deepest search for contact.
    double force_limit_n = 0.05;   ///< Backs off above.
    double watch = 0.85;           ///< Slows by this share while it is not cut behind the tip.
    double wait_s = 0.7;           ///< Longest slow-down at one place.
    double burst_s = 5;            ///< Pedal down at a stretch.
    double pause_s = 0.25;         ///< Between bursts.
    double settle_s = 0.12;        ///< Contact before the pedal goes down.
    double early_chance = 0;       ///< Energises in air before landing.
    double early_s = 0;            ///< For that long.
    double hesitate_hz = 0;        ///< Stops with the pedal down.
    std::array<double, 2> hesitate_s{0, 0};
    double skip_per_m = 0;  ///< Pedal up by mistake: gaps per metre of contour.
    std::array<double, 2> skip_m{0, 0};
    int overshoots = 0;             ///< Slips towards the placode, per attempt.
    double overshoot_m = 0;         ///< How far.
    double overshoot_notice_s = 0;  ///< Pedal still down for that long.
    int submovements = 1;           ///< Free motion in that many pieces.
    double aim_error_m = 0;         ///< Error of all pieces but the last.
    double notice_gap_m = 0;        ///< Shorter gaps are not seen.
    double second_care = 1;         ///< Share of the wandering that is left on a second pass.
    double second_out_m = 0;        ///< Further from the placode on a second pass.
    double clear_m = 0;             ///< No energy with the tip nearer to the placode than that,
    double clear_metal_m = -1;      ///< nor with any of the bare metal nearer than that.
    double cool_s = 0;              ///< A place that was heated is left alone for that long.
    bool seeks_bridges = false;     ///< Line done: goes back to where the placode still hangs on.
    int tries = 6;                  ///< Passes over one place before giving it up.
    double patience_s = 60;         ///< Gives up after.
};
[[nodiscard]] const OperatorProfile& operator_profile(OperatorLevel level) noexcept;

}  // namespace placode::haptics
