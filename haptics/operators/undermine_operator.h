// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator that undermines skin beside a wound: one hand takes the edge and lifts it, the
// other goes in below it along the fascia with its jaws shut, spreads them across the plane, shuts
// them and goes on deeper, at several places along the edge; then the other side with hands
// exchanged. Levels differ by how high they lift, how near to the fascia they stay, how far and how
// wide they spread.

#include <array>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level at undermining. Chosen by trial so that the levels order by what they tear.
struct UndermineHabits {
    double lift_m = 0.002;      ///< Of the edge.
    double lift_m_s = 0.003;    ///< How fast.
    double below_m = 0.0009;    ///< Tip below the skin's surface while it goes in.
    double aim_m = 1e-4;        ///< Error of that and of the place along the edge, rms.
    double spread_rad = 0.10;   ///< Jaws that spread.
    double raise_m = 0.0018;    ///< The wrist rises with them: the lower jaw stays on the fascia.
    double raise_m_s = 0.006;   ///< How fast.
    double push_m_s = 0.0065;   ///< How fast it goes in.
    double first_m = 0.0016;    ///< Out from the edge, the first spread;
    double step_m = 0.0017;     ///< from one to the next;
    double deepest_m = 0.0068;  ///< and none beyond this.
    double apart_m = 0.002;     ///< Between places along the edge.
    int places = 4;             ///< Of them; more only where too little has come free.
    int most_places = 9;        ///< Then it gives up.
};
[[nodiscard]] const UndermineHabits& undermine_habits(OperatorLevel level) noexcept;

class UndermineOperator final : public ScriptedOperator {
 public:
    /// `right` and `left`: the two graspers; the others stay where they are.
    UndermineOperator(OperatorLevel level, uint64_t seed, std::array<size_t, 2> tools,
                      std::span<const sim::ToolSpec> specs, std::span<const Vec3> homes);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;
    /// After the last act: both hands go home. True when they are there.
    [[nodiscard]] bool go_home(double dt_s, std::span<HandAction> hands) noexcept;

 private:
    enum class Stage : uint8_t {
        kLook,
        kOver,
        kDown,
        kClose,
        kLift,
        kAside,
        kEnter,
        kPush,
        kSpread,
        kShut,
        kOut,
        kAway,
        kRelease,
        kDone
    };
    struct Worker {
        size_t tool = 0;
        HandMotion motion;
        Vec3 pivot = Vec3::Zero(), opening = Vec3::Zero();
        bool holds = false;
    };
    void stage(Stage next) noexcept;
    void take_edge(double dt_s) noexcept;
    void next_place() noexcept;
    void dig(double dt_s) noexcept;
    void release(double dt_s) noexcept;
    /// Below the edge, so far out and up.
    [[nodiscard]] Vec3 below_edge(double out_m, double up_m) const noexcept;
    [[nodiscard]] Worker& lifter() noexcept { return workers_[lifting_]; }
    [[nodiscard]] Worker& digger() noexcept { return workers_[1 - lifting_]; }

    UndermineHabits habits_;
    OperatorProfile profile_;
    std::array<Worker, 2> workers_;
    size_t lifting_ = 1;  // the left hand first
    // What is seen.
    sim::PracticeGoal goal_;
    // What is done.
    Stage stage_ = Stage::kLook;
    Vec3 edge_ = Vec3::Zero(), out_ = Vec3::UnitY();  // where it was taken; away from the digger
    double time_s_ = 0, stage_s_ = 0, along_m_ = 0, depth_m_ = 0, height_m_ = 0;
    int place_ = 0, tries_ = 0;
    bool going_home_ = false;
};

}  // namespace placode::haptics
