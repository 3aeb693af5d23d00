// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A scripted operator for the diathermy ring: what a hand of a given level does with what it sees.
// Free motion is minimum jerk (Flash & Hogan 1985), physiological tremor 8 to 12 Hz. Levels differ
// by behaviour only; nobody tells the score who is at work. Same seed, same bits.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "haptics/device.h"

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
    int tries = 6;                  ///< Passes over one place before giving it up.
    double patience_s = 60;         ///< Gives up after.
};
[[nodiscard]] const OperatorProfile& operator_profile(OperatorLevel level) noexcept;

/// What the hand wants now.
struct OperatorAction {
    Vec3 tip_m = Vec3::Zero();  ///< Tip in W.
    uint8_t pedals = 0;
    bool finish = false;
};

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

/// One operator at work. Allocates in `see` only while the contour's size is new.
class OperatorModel {
 public:
    OperatorModel(const OperatorProfile& profile, uint64_t seed, const Vec3& home_tip_m);
    void see(const Perception& perception, const sim::ToolFeedback& own);
    /// Next wish, `dt_s` after the last one.
    [[nodiscard]] OperatorAction act(double dt_s) noexcept;

 private:
    enum class Stage : uint8_t { kLook, kMove, kDescend, kCut, kLift, kLeave, kDone };
    struct Run {  // A piece of contour to cut, in arc length, end > begin.
        double begin_m = 0, end_m = 0;
    };
    struct Frame {  // Contour at one arc length.
        Vec3 point, normal, inward;
    };

    void remember(const Perception& seen);
    void stage(Stage next) noexcept;
    [[nodiscard]] bool plan_run(double from_m) noexcept;
    [[nodiscard]] Frame frame(double s_m) const noexcept;
    [[nodiscard]] size_t index(double s_m) const noexcept;
    [[nodiscard]] double wrapped(double s_m) const noexcept;
    void begin_move(const Vec3& from_m) noexcept;
    void do_move(double dt_s) noexcept;
    void do_descend(double dt_s) noexcept;
    void do_cut(double dt_s) noexcept;
    void do_lift(double dt_s) noexcept;
    [[nodiscard]] bool wanted() const noexcept;
    void press(double dt_s) noexcept;
    void advance(double dt_s) noexcept;
    void slip(double dt_s) noexcept;
    void pedal_habits(double dt_s) noexcept;
    void noise(double dt_s) noexcept;
    [[nodiscard]] Vec3 tremor() const noexcept;

    OperatorProfile profile_;
    OperatorRandom random_;
    Vec3 home_m_;
    // What is seen.
    std::vector<Vec3> contour_, normal_;
    std::vector<uint8_t> cut_;
    std::vector<double> arc_;  // of each point; arc_.back() = length of the closed ring
    std::vector<uint8_t> tries_;
    Vec3 centre_ = Vec3::Zero();
    bool contact_ = false;
    double force_n_ = 0, seen_s_ = 0;
    // What is done.
    Stage stage_ = Stage::kLook;
    double time_s_ = 0, stage_s_ = 0;
    Vec3 tip_m_;  // without tremor
    Run run_;
    double s_m_ = 0, start_m_ = -1, lift_m_ = 0;
    Vec3 move_from_ = Vec3::Zero(), move_error_ = Vec3::Zero();
    double move_s_ = 1;
    int pieces_left_ = 0;
    double rest_s_ = 0;  // still to wait
    double speed_ = 0, speed_noise_ = 0, wander_ = 0, wander_smooth_ = 0, slip_offset_ = 0;
    double waited_s_ = 0, hold_s_ = 0, skip_m_ = 0, burst_s_ = 0, pause_s_ = 0, contact_s_ = 0;
    double press_ = 0, early_lift_m_ = 0;
    int passes_ = 0, slips_left_ = 0;
    double slip_at_m_ = -1, slip_s_ = -1;
    bool pedal_ = false;
    std::array<double, 6> tremor_phase_{}, tremor_hz_{};
};

}  // namespace placode::haptics
