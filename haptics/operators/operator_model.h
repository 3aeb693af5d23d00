// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A scripted operator for the diathermy ring: what a hand of a given level does with what it sees.
// Free motion is minimum jerk (Flash & Hogan 1985), physiological tremor 8 to 12 Hz. Levels differ
// by behaviour only; nobody tells the score who is at work. Same seed, same bits.

#include <array>
#include <cstdint>

#include "haptics/device.h"
#include "haptics/operators/incision_line.h"
#include "haptics/operators/operator_profile.h"
#include "haptics/operators/operator_random.h"

namespace placode::haptics {

/// What the hand wants now.
struct OperatorAction {
    Vec3 tip_m = Vec3::Zero();  ///< Tip in W.
    uint8_t pedals = 0;
    bool finish = false;
};

/// One operator at work. Allocates in `see` only while the contour's size is new.
class OperatorModel {
 public:
    OperatorModel(const OperatorProfile& profile, uint64_t seed, const Vec3& home_tip_m);
    void see(const Perception& perception, const sim::ToolFeedback& own);
    /// Next wish, `dt_s` after the last one.
    [[nodiscard]] OperatorAction act(double dt_s) noexcept;

 private:
    enum class Stage : uint8_t { kLook, kMove, kDescend, kCut, kLift, kWatch, kLeave, kDone };

    static constexpr double kOverrunM = 5e-4;  // A piece is cut past both of its ends.

    void next_or_leave(double from_m) noexcept;
    void leave() noexcept;
    void stage(Stage next) noexcept;
    [[nodiscard]] bool plan_run(double from_m) noexcept;
    void begin_move(const Vec3& from_m) noexcept;
    void do_move(double dt_s) noexcept;
    void do_descend(double dt_s) noexcept;
    void do_lift(double dt_s) noexcept;

    // operator_cut.cpp
    void do_cut(double dt_s) noexcept;
    void follow(const Vec3& goal_m, double dt_s) noexcept;
    [[nodiscard]] bool wanted() const noexcept;
    [[nodiscard]] bool cooling() const noexcept;
    [[nodiscard]] double short_of_m() const noexcept;  ///< Missing to the placode's clearance.
    [[nodiscard]] bool too_near() const noexcept { return short_of_m() > 0; }
    void keep_clear(double dt_s) noexcept;
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
    IncisionLine line_;
    bool contact_ = false;
    double force_n_ = 0, placode_gap_m_ = 1, metal_gap_m_ = 1, clear_out_m_ = 0;
    // What is done.
    Stage stage_ = Stage::kLook;
    double time_s_ = 0, stage_s_ = 0;
    Vec3 tip_m_;  // without tremor
    IncisionLine::Run run_;
    double s_m_ = 0, lift_m_ = 0;
    Vec3 move_from_ = Vec3::Zero(), move_error_ = Vec3::Zero();
    double move_s_ = 1;
    int pieces_left_ = 0;
    double rest_s_ = 0;  // still to wait
    double speed_ = 0, speed_noise_ = 0, wander_ = 0, wander_smooth_ = 0, slip_offset_ = 0;
    double waited_s_ = 0, hold_s_ = 0, skip_m_ = 0, slid_m_ = 0, burst_s_ = 0, pause_s_ = 0,
           contact_s_ = 0;
    double press_ = 0, early_lift_m_ = 0;
    int passes_ = 0, slips_left_ = 0;
    double slip_at_m_ = -1, slip_s_ = -1;
    bool pedal_ = false;
    std::array<double, 6> tremor_phase_{}, tremor_hz_{};
};

}  // namespace placode::haptics
