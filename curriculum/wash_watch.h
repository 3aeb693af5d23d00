// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Watches fluid and debris while a field is washed: what is left, and where to go on. Physics
// thread; allocates nothing. Private to curriculum.

#include "assessment/practice.h"
#include "sim/step/step.h"

namespace placode::curriculum {

/// What is left to wash and to suck.
struct WashNow {
    assessment::WashSight sight;
    /// Stuck debris next to the tip of the irrigator; fluid that stands deepest, or what floats.
    sim::Vec3 stuck_m = sim::Vec3::Zero(), fluid_m = sim::Vec3::Zero();
    bool fluid = false;  ///< There is some.
};
[[nodiscard]] WashNow look_at_wash(const sim::Scene& scene, const sim::State& state) noexcept;

class WashWatch {
 public:
    WashWatch() = default;  ///< Of a scene without irrigation: not there().
    explicit WashWatch(const sim::Scene& scene) : there_(scene.irrigation.has_value()) {}

    [[nodiscard]] bool there() const noexcept { return there_; }
    /// One sample later.
    void look(const sim::Scene& scene, const sim::State& state) noexcept {
        now_ = look_at_wash(scene, state);
    }
    [[nodiscard]] const assessment::WashSight& sight() const noexcept { return now_.sight; }
    /// Sets the target of a step.
    void show(sim::PracticeGoal& goal) const noexcept;

 private:
    bool there_ = false;
    WashNow now_;
};

}  // namespace placode::curriculum
