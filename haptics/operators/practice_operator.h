// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator for tasks with steps (sim/core/practice.h): does the step that the overlay
// shows, with the hand that it asks for, and goes on when it is ticked off. Levels differ by aim,
// pressure, patience with the pedal and force of traction.

#include <array>
#include <vector>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level with small exercises. Chosen by trial so that the levels order by what they
/// do to the tissue.
struct PracticeHabits {
    double aim_error_m = 1e-4;   ///< Of the first approach, rms; the next one is half of it.
    double press_m = 1e-4;       ///< Below the first touch.
    bool feels = true;           ///< Stays where it met tissue; else it goes after what it pushes.
    double early_pedal_s = 0;    ///< Pedal down before the tip has arrived.
    double late_pedal_s = 0.05;  ///< Pedal still down after the step is done.
    double trace_m_s = 0.006;    ///< Along the contour.
    double trace_wander_m = 1e-4, trace_inward_m = 0;
    double pull = 0.4;  ///< Traction: share of the way from the least to the most allowed; over 1
                        ///< is too much.
    double pull_m_s = 0.0015;
};
[[nodiscard]] const PracticeHabits& practice_habits(OperatorLevel level) noexcept;

class PracticeOperator final : public ScriptedOperator {
 public:
    PracticeOperator(OperatorLevel level, uint64_t seed, std::span<const sim::ToolSpec> tools,
                     std::span<const Vec3> homes);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    enum class Stage : uint8_t { kLook, kRise, kGo, kDown, kDo, kAgain, kGiveUp };
    /// One hand at work.
    struct Worker {
        HandMotion motion;
        bool touches = false, holds = false;
        double pull_n = 0, height_m = 0.005, turned_rad = 0, gone_m = 0;
        Vec3 error = Vec3::Zero(), anchor = Vec3::Zero(), opening = Vec3::Zero();
        uint8_t pedals = 0;
        bool forth = false;
    };
    void stage(Stage next) noexcept;
    void begin_step() noexcept;
    [[nodiscard]] int tool_of(sim::Hand hand) const noexcept;
    [[nodiscard]] Vec3 place(const Worker& worker, int target) const noexcept;
    [[nodiscard]] bool aims() const noexcept;
    void wander_about(Worker& worker, size_t tool, double dt_s) noexcept;
    void rise(double dt_s) noexcept;
    void go(double dt_s) noexcept;
    void down(double dt_s) noexcept;
    void do_step(double dt_s) noexcept;
    void press(Worker& worker, double press_m, double dt_s) noexcept;
    void do_touch(Worker& worker, double dt_s) noexcept;
    void do_grasp(Worker& worker, double dt_s) noexcept;
    void do_trace(Worker& worker, double dt_s) noexcept;
    void do_traction(double dt_s) noexcept;
    void leave(double dt_s) noexcept;
    void aim() noexcept;

    OperatorLevel level_;
    OperatorProfile profile_;
    PracticeHabits habits_;
    std::vector<sim::ToolSpec> tools_;
    std::vector<Worker> workers_;
    sim::PracticeGoal goal_;
    std::vector<Vec3> contour_, normal_;
    std::array<int, 2> at_work_{-1, -1};  // tool for each target
    int busy_ = 0;                        // of these
    Stage stage_ = Stage::kLook;
    int step_ = -1, tries_ = 0;
    double time_s_ = 0, stage_s_ = 0, step_s_ = 0, arc_m_ = 0, wander_ = 0, late_s_ = 0;
};

}  // namespace placode::haptics
