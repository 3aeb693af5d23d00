// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An instrument whose tip lies below the surface that it should have touched: pushed through, it
// has no force until it is out again (sim/step/step.cpp), so that nobody feels it. Read only.

#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {

/// Less is an overlap of touch, or the last bit of a kerf that was not burned away [m].
inline constexpr double kBuriedM = 5e-4;

struct Burial {
    double depth_m = 0;        ///< Of the tip below the surface, along its normal; 0 = not buried.
    double length_m = 0;       ///< Of the shaft that is in tissue, from the tip.
    Vec3 rest = Vec3::Zero();  ///< Where the shaft goes in, on the rest shape [m].
    Tissue tissue = Tissue::kSkin;  ///< What it goes into.
};

/// How deep tool `t` is below the present surface: along its shaft, from the tip towards the hand,
/// tissue has to be left again. A needle that is cutting makes its own way and is not buried, nor
/// is a tip in a kerf, nor jaws that hold tissue (a patch is none); scissors count from their
/// hinge, since what lies between blades is meant to be there; but open blades count from their
/// tips where they come out of placode. Exact zero below kBuriedM.
[[nodiscard]] Burial burial_of(const Scene& scene, const State& state, int t) noexcept;

}  // namespace placode::sim
