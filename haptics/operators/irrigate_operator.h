// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripted operator that washes a lesion: jet beside each crumb until it is off, from a distance
// that spares the tissue; then suction until the field is dry. Levels differ by how near they come
// with the jet and with the sucker, how well they aim, how soon they suck, and what they leave.

#include "haptics/operators/hand_motion.h"

namespace placode::haptics {

/// Habits of one level. Chosen by trial so that the levels order by what the jet and the sucker do.
struct IrrigateHabits {
    double away_m = 0.0095;      ///< From the tip to what the jet shall loosen, along the shaft,
    double away_noise_m = 4e-4;  ///< and rms about that.
    double aim_m = 3e-4;         ///< Error of aiming, rms.
    double wash_s = 2.5;         ///< At one place before it tries from nearer.
    double nearer_m = 0.0015;    ///< So much nearer at the next try.
    double suck_gap_m = 7e-4;    ///< Tip over the ground while it sucks,
    double suck_noise_m = 5e-5;  ///< rms about that.
    double bite_m = 0;           ///< So much deeper now and then: the sucker touches.
    double blind = 0.3;          ///< Sucks before it goes on where blood hides more than that.
    int left_behind = 0;         ///< Debris that it does not bother about.
    double content_m3 = 2.2e-8;  ///< Fluid that it leaves.
    double run_on_s = 0.1;       ///< The jet runs so long while the hand goes to the next place.
};
[[nodiscard]] const IrrigateHabits& irrigate_habits(OperatorLevel level) noexcept;

class IrrigateOperator final : public ScriptedOperator {
 public:
    /// `tool`: the irrigator that does it; the others stay where they are.
    IrrigateOperator(OperatorLevel level, uint64_t seed, size_t tool, const sim::ToolSpec& spec,
                     const Vec3& home_m);
    void see(const Perception& seen) override;
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override;

 private:
    enum class Stage : uint8_t {
        kLook,
        kChoose,
        kAim,
        kWash,
        kOver,
        kDown,
        kSuck,
        kRise,
        kLeave,
        kDone
    };
    void stage(Stage next) noexcept;
    void choose() noexcept;
    void wash(double dt_s) noexcept;
    void suck(double dt_s) noexcept;
    /// Where the tip has to be for the jet to land at `target`, `away_m` before it.
    [[nodiscard]] Vec3 jet_place(const Vec3& target, double away_m) const noexcept;

    IrrigateHabits habits_;
    OperatorProfile profile_;
    HandMotion hand_;
    size_t tool_;
    Vec3 pivot_;
    // What is seen.
    double stuck_ = 0, floating_ = 0, standing_m3_ = 0, hidden_ = 0, tip_gap_m_ = 1;
    Vec3 stuck_m_ = Vec3::Zero(), fluid_m_ = Vec3::Zero();
    bool touches_ = false;
    // What is done.
    Stage stage_ = Stage::kLook;
    Vec3 target_ = Vec3::Zero(), place_ = Vec3::Zero(), error_ = Vec3::Zero();
    double time_s_ = 0, stage_s_ = 0, stuck_before_ = 0, away_m_ = 0, gap_m_ = 0;
    int tries_ = 0, sucks_ = 0;
    uint8_t pedals_ = 0;
};

}  // namespace placode::haptics
