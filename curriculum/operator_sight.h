// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a scripted operator sees of the tissue: what a person would see on the screen, as often as
// the screen is refreshed. Allocates in the constructor only.

#include <array>
#include <span>
#include <vector>

#include "haptics/device.h"
#include "sim/contact/patch_cover.h"
#include "sim/step/step.h"

namespace placode::curriculum {

class OperatorSight {
 public:
    /// `scene` must outlive it.
    explicit OperatorSight(const sim::Scene& scene);
    /// Looks: once per picture.
    void look(const sim::State& state) noexcept;
    /// What was seen at the last look, with what hands feel now. Spans live as long as this and
    /// `state`; tools, cut_fraction and practice are the caller's.
    [[nodiscard]] haptics::Perception seen(const sim::State& state) const noexcept;

 private:
    void look_at(const sim::State& state, std::span<const sim::ContourAnchor> anchors,
                 std::vector<sim::Vec3>& points, std::vector<sim::Vec3>& normals) const noexcept;
    void look_at_marked(const sim::State& state) noexcept;
    void look_at_placode(const sim::State& state) noexcept;

    const sim::Scene& scene_;
    std::vector<sim::Vec3> contour_, contour_normal_, outline_, outline_normal_;
    std::vector<sim::Vec3> grasp_place_, grasp_normal_;
    std::vector<int32_t> marked_;            // tets
    std::vector<int32_t> placode_vertices_;  // of the placode's tets
    std::array<double, sim::kMaxTools> placode_gap_m_{}, placode_metal_gap_m_{};
    sim::PatchHandles patch_;
    double left_share_ = 1, held_share_ = 0;
    int drawn_through_ =
        0;  ///< Times that the needle had left a channel when last all of it was out.
};

}  // namespace placode::curriculum
