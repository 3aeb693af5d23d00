// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Follows the present step of a practice task from picture to picture: where the tip was when it
// began, which of two end marks is next, and for how long nothing has come of it.

#include "sim/core/practice.h"

namespace placode::view {

inline constexpr double kStuckS = 8;  ///< Without progress: then the hint comes.

class StepWatch {
 public:
    /// One picture. `clock_s` runs with the watcher; while `waits` (menu, help) nobody is stuck;
    /// `present` = the instrument of the step is in the field.
    void look(const sim::PracticeGoal& goal, double clock_s, bool waits, bool present = true);
    [[nodiscard]] bool stuck() const { return idle_s_ >= kStuckS; }
    /// True from the first picture of a step until the instrument is there: what is anchored is
    /// anchored now.
    [[nodiscard]] bool fresh() const { return fresh_; }

    sim::Vec3 anchor_mm =
        sim::Vec3::Zero();  ///< Of the step: the tip, or what the scope looked at.
    sim::Vec3 right_mm = sim::Vec3::UnitX();  ///< Sideways in the picture, then.
    sim::Vec3 shaft = sim::Vec3::UnitZ();     ///< Of the tool, then.
    double deepest_mm = 5;                    ///< How far down is asked for from there.
    int side = 1;                             ///< The mark that is next: +1 or -1.

 private:
    int step_ = -1;
    double progress_ = 0, idle_s_ = 0, last_s_ = 0;
    bool fresh_ = false, begun_ = false, anchored_ = false;
};

/// "12 of 30 mm": how much of a step is done, and its unit; empty where only done counts.
struct StepAmount {
    double done = 0, whole = 0;
    int digits = 0;
    const char* unit = "";  ///< Right behind the number.
};
[[nodiscard]] StepAmount step_amount(const sim::PracticeGoal& goal);

/// Energy of a step flows beside the tissue: cutting takes away what the tip stood on.
/// @param gap_mm between tip and tissue.
[[nodiscard]] bool contact_lost(const sim::PracticeStep& step, uint8_t pedals, bool touches,
                                double gap_mm) noexcept;

}  // namespace placode::view
