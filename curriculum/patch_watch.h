// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Watches how a patch lies while it is laid, a part of it with every sample, so that a frame takes
// no longer for it: all of it is seen anew five times a second. Physics thread; allocates in the
// constructor only. Private to curriculum.

#include <array>
#include <vector>

#include "assessment/practice.h"
#include "sim/contact/patch_cover.h"
#include "sim/step/step.h"

namespace placode::curriculum {

class PatchWatch {
 public:
    PatchWatch() = default;  ///< Of a scene without a patch: not there().
    /// `overlap_m`: how far the patch shall reach beyond the placode's edge.
    PatchWatch(const sim::Scene& scene, double overlap_m);

    [[nodiscard]] bool there() const noexcept { return cover_.there(); }
    /// One sample later.
    void look(const sim::Scene& scene, const sim::State& state) noexcept;
    [[nodiscard]] const assessment::PatchSight& sight() const noexcept { return sight_; }
    /// Of the goal: where the patch reaches as far as it shall, and the line that shows how far
    /// that is.
    void show(sim::PracticeGoal& goal) const noexcept;

 private:
    static constexpr size_t kRounds = 18;  // samples until all was seen anew

    sim::PatchCover cover_;
    double overlap_m_ = 0;
    assessment::PatchSight sight_;
    std::array<uint8_t, sim::kPatchEdgePoints> laid_{};
    std::array<float, sim::kPatchEdgePoints> height_m_{};  // of the tissue below the line
    std::vector<float> folded_m2_, area_m2_;               // (faces)
    size_t round_ = 0;
};

}  // namespace placode::curriculum
