// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator with two hands: the grasper takes hold of the marked tissue and keeps it under
// tension, the scissors part it along its outline snip by snip, the grasper takes the piece out
// through the port. Where a needle is among the tools, the ring comes first (operator_model.h),
// then the right hand changes to scissors at the port.

#include <memory>
#include <vector>

#include "haptics/operators/hand_motion.h"
#include "haptics/operators/operator_model.h"

namespace placode::haptics {

/// Which tool is which; -1 = not there.
struct ResectionTools {
    int needle = -1, scissors = -1, grasper = -1;
};

class ResectionOperator final : public ScriptedOperator {
 public:
    ResectionOperator(OperatorLevel level, uint64_t seed, const ResectionTools& tools,
                      std::span<const sim::ToolSpec> specs, std::span<const Vec3> homes);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    // Right hand.
    enum class Right : uint8_t {
        kRing,
        kChange,
        kWait,
        kReach,
        kEnter,
        kSnip,
        kOpen,
        kAdvance,
        kRise,
        kAway
    };
    // Left hand.
    enum class Left : uint8_t {
        kLook,
        kReach,
        kLower,
        kClose,
        kTension,
        kHold,
        kLift,
        kCarry,
        kOpen,
        kBack,
        kDone
    };
    static constexpr double kHoverM = 0.005;  // of free motion over the tissue

    void go(Right next) noexcept;
    void go(Left next) noexcept;

    // resection_scissors.cpp
    void right(double dt_s, std::span<HandAction> hands) noexcept;
    void burn_ring(double dt_s, std::span<HandAction> hands) noexcept;
    void cut(double dt_s) noexcept;
    void go_to_the_outline() noexcept;
    void enter_beside_the_line() noexcept;
    void enter(double dt_s) noexcept;
    void advance() noexcept;
    void look_for_more() noexcept;
    [[nodiscard]] bool next_run() noexcept;
    [[nodiscard]] bool open_at(size_t i) const noexcept;
    void aim() noexcept;
    void count_try() noexcept;
    [[nodiscard]] Vec3 tip_goal(double above_m) const noexcept;

    // resection_grasper.cpp
    void left(double dt_s, std::span<HandAction> hands) noexcept;
    void choose_hold() noexcept;
    void lower(double dt_s) noexcept;
    void close(double dt_s) noexcept;
    void hold() noexcept;
    void lift(double dt_s) noexcept;
    void carry() noexcept;
    void carry_out(double dt_s) noexcept;
    void let_go() noexcept;
    void go_back(double dt_s) noexcept;
    [[nodiscard]] bool unfinished() const noexcept;
    void grasp_again() noexcept;
    [[nodiscard]] Vec3 hold_place(double above_m) const noexcept;

    OperatorLevel level_;
    OperatorProfile profile_;
    ResectionTools tools_;
    Vec3 scissors_pivot_ = Vec3::Zero(), grasper_pivot_ = Vec3::Zero();
    std::unique_ptr<OperatorModel> ring_;
    HandMotion scissors_, grasper_;
    // What is seen.
    std::vector<Vec3> line_, normal_;
    std::vector<uint8_t> cut_, tries_;
    Vec3 place_ = Vec3::Zero(), place_normal_ = Vec3::UnitZ();
    bool placed_ = false, holds_ = false, touches_ = false, piece_free_ = false;
    double marked_left_ = 1, marked_held_ = 0, pull_n_ = 0, placode_gap_m_ = 1;
    int pieces_out_ = 0;
    sim::ToolFeedback needle_feedback_;
    // What is done.
    Right right_ = Right::kWait;
    Left left_ = Left::kLook;
    double time_s_ = 0, right_s_ = 0, left_s_ = 0, height_m_ = 0, low_m_ = 0, out_m_ = 0;
    size_t at_ = 0, run_left_ = 0;
    int passes_ = 0, grasps_ = 0, out_before_ = 0;
    bool cutting_done_ = false, wanted_ = false, trust_cut_ = true;
    Vec3 point_ = Vec3::Zero(), up_ = Vec3::UnitZ(), along_ = Vec3::UnitX(), beside_ = Vec3::Zero();
    Vec3 place_error_ = Vec3::Zero();
};

}  // namespace placode::haptics
