// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator for a needle between two drivers. A hand that has it turns it about its own
// shaft until the wire lies square to the other driver where this is to take it, in front of it and
// clear of the tissue; the other comes along its own shaft, takes it, and only then the first lets
// go. Laid down, a needle is turned as flat as the driver can.

#include <array>
#include <span>
#include <vector>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level. Chosen by trial on the pad with two drivers.
struct HandoverHabits {
    double speed_m_s = 0.015;      ///< Of a needle that is carried.
    double turn_rad_s = 1.2;       ///< And turned.
    double aim_error_m = 2e-4;     ///< Of the place on the wire, rms.
    double turn_error_rad = 0.03;  ///< Of the needle as it is held out, and of the jaws, rms.
    double tug_m = 0;              ///< That the taker draws before the other hand has let go.
    int early = 0;                 ///< Times that a hand lets go before the other one has it.
    int swings = 0;                ///< Of each carry: turned past where it shall be and back.
};
[[nodiscard]] const HandoverHabits& handover_habits(OperatorLevel level) noexcept;

class HandoverOperator final : public ScriptedOperator {
 public:
    /// @param drivers of which hand each is, is said by `tools`.
    HandoverOperator(OperatorLevel level, uint64_t seed, const std::array<size_t, 2>& drivers,
                     std::span<const sim::ToolSpec> tools, std::span<const Vec3> homes_m);
    void see(const Perception& seen) override { seen_ = seen; }
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    static constexpr double kHeldShare = 1.0 / 3;  // of the jaws behind their tips
    static constexpr double kLyingShare = 0.12;  // the same of wire that lies: tips off the tissue
    static constexpr double kLyingUpM = 3e-4;    // likewise
    static constexpr double kOpenRad = 0.5, kJawRadS = 1.5;
    static constexpr double kHoverM = 0.007;        // over a needle that lies
    static constexpr double kClearM = 0.010;        // back along the shaft, off the wire
    static constexpr double kClearNeedleM = 0.012;  // of the needle's middle, over the tissue
    static constexpr double kShownM = 1e-3;         // of its point over the tissue,
    static constexpr double kLaidM = 8e-4;          // of its wire
    static constexpr double kTurnedUpM = 0.008;     // over its goal, while it is turned
    static constexpr double kPatienceS = 15;
    static constexpr int kMostTries = 4;
    static constexpr int kWirePlaces = 17, kTurns = 120;
    static constexpr double kApproachM_s = 0.012, kLowerM_s = 0.005;

    enum class Stage : uint8_t {
        kLook,
        kPlan,
        kLift,
        kCarry,
        kHover,
        kCome,
        kClose,
        kTug,
        kOpen,
        kBack,
        kWait,
        kDone
    };
    /// One driver.
    struct Driver {
        size_t tool = 0;
        sim::ToolSpec spec;
        HandMotion motion;
        Vec3 across = Vec3::Zero();
    };
    /// The needle in the jaws of one driver, brought to a place and turned about its shaft.
    struct Carry {
        sim::Pose X_TN;
        Vec3 at_N = Vec3::Zero(), goal_m = Vec3::Zero();  ///< This place of the needle there.
        double turn_rad = 0, turned_rad = 0;
    };
    void stage(Stage next) noexcept;
    /// Of the needle's centre, between the hands.
    [[nodiscard]] static Vec3 meeting_m() noexcept { return {0.001, 0, 0.0135}; }

    // handover_plan.cpp
    void plan() noexcept;
    void plan_take() noexcept;
    void hold_out() noexcept;
    void show_point() noexcept;
    void lay_down() noexcept;
    void begin_carry(double turn_rad, const Vec3& at_N, const Vec3& goal_m) noexcept;
    template <class Cost>
    [[nodiscard]] double best_turn(const Driver& d, Cost&& cost) const noexcept;

    // handover_operator.cpp
    void carry(double dt_s) noexcept;
    void hover(double dt_s) noexcept;
    void come(double dt_s) noexcept;
    void close(double dt_s) noexcept;
    void try_again() noexcept;
    void go_on(double dt_s) noexcept;
    [[nodiscard]] size_t driver_of(sim::Hand hand) const noexcept;
    [[nodiscard]] sim::Pose pose(const Driver& d, const Vec3& tip_m,
                                 const Vec3& across) const noexcept;
    [[nodiscard]] sim::Pose pose_now(const Driver& d) const noexcept;
    [[nodiscard]] sim::Pose turned(const Driver& d, double turn_rad) const noexcept;
    [[nodiscard]] Vec3 wire_N(double arc_m) const noexcept;
    [[nodiscard]] Vec3 grip_goal(Driver& d) noexcept;

    const HandoverHabits& habits_;
    OperatorProfile profile_;
    std::array<Driver, 2> drivers_;
    size_t hand_ = 0;  ///< At work, of drivers_.
    Perception seen_{};
    Carry carry_;
    Stage stage_ = Stage::kLook, after_ = Stage::kWait;  ///< What follows a carry.
    Vec3 goal_ = Vec3::Zero();
    double time_s_ = 0, stage_s_ = 0, take_m_ = 0, miss_rad_ = 0;
    bool lying_ = false;  ///< It is taken from the tissue.
    int step_ = -1, tries_ = 0, early_ = 0, swings_ = 0;
};

}  // namespace placode::haptics
