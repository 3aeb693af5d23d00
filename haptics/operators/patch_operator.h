// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator that lays a patch: takes it by the side that looks at the lesion, lifts that
// side, draws the patch over the lesion, lays the side down and lets go; who looks afterwards draws
// it right once more. Levels differ by where they take it, how high and how fast they draw, how
// well they judge where it lies, from what height they let go, and whether they look.

#include <array>

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level with a patch. Chosen by trial so that the levels order by how it lies.
struct PatchHabits {
    double beside_m = 0;      ///< Taken so far beside the middle of its side, to either end of it,
    double aside_m = 2e-4;    ///< and rms about that.
    double lift_m = 0.0015;   ///< The side, while it is drawn.
    double draw_m_s = 0.008;  ///< How fast.
    double aim_m = 1e-4;      ///< Error of judging where its middle belongs, rms.
    double aim_bias_m = 0;    ///< Left too short of the place by this much.
    double drop_m = 3e-4;     ///< Height at which it lets go.
    double press_m = 1e-4;    ///< Below the first touch, when it takes it.
    int corrections = 3;      ///< Looks, and draws it right, so many times.
    double content = 0.98;    ///< Share of the edge that satisfies it.
};
[[nodiscard]] const PatchHabits& patch_habits(OperatorLevel level) noexcept;

class PatchOperator final : public ScriptedOperator {
 public:
    /// `tool`: the grasper that does it; the others stay where they are.
    PatchOperator(OperatorLevel level, uint64_t seed, size_t tool, const Vec3& home_m);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    enum class Stage : uint8_t {
        kLook,
        kReach,
        kDown,
        kClose,
        kLift,
        kDraw,
        kLay,
        kOpen,
        kRise,
        kJudge,
        kLeave,
        kDone
    };
    void stage(Stage next) noexcept;
    void begin() noexcept;
    void down(double dt_s) noexcept;
    void close(double dt_s) noexcept;
    void draw(double dt_s) noexcept;
    void lay(double dt_s) noexcept;
    void rise(double dt_s) noexcept;
    void judge() noexcept;
    [[nodiscard]] Vec3 patch_middle() const noexcept;
    [[nodiscard]] Vec3 wanted_middle() const noexcept;
    [[nodiscard]] double laid_share() const noexcept;
    [[nodiscard]] Vec3 rim_towards(const Vec3& offset) const noexcept;

    OperatorLevel level_;
    PatchHabits habits_;
    OperatorProfile profile_;
    HandMotion hand_;
    size_t tool_;
    // What is seen.
    sim::PracticeGoal goal_;
    std::array<Vec3, 4> corner_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    bool patch_ = false, touches_ = false, holds_ = false;
    // What is done.
    Stage stage_ = Stage::kLook;
    Vec3 grip_ = Vec3::Zero(), error_ = Vec3::Zero();
    double time_s_ = 0, stage_s_ = 0, touched_z_ = 0, gripped_z_ = 0;
    int misses_ = 0, corrected_ = 0;
};

}  // namespace placode::haptics
