// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A block of tissue and a hand that holds an instrument on it, through the simulator's own frame
// (sim/step): what measures contact as it is felt.

#include <array>

#include "sim/step/step.h"

namespace placode::sim {

/// Skin of every felt block: Young's modulus [Pa] and Poisson's ratio.
inline constexpr double kFeltE = 60e3, kFeltNu = 0.45;

/// A block of one tissue, its top at z = 0 about the z axis, held at its bottom.
struct FeltBlock {
    Vec3 size_m = Vec3::Zero();
    std::array<int, 3> cells{};
    double friction = 0;
    double tip_radius_m = 1e-3;
    double tip_length_m = 2.5e-3;
    double hand_n_m = 1e7;  ///< A machine's: the instrument is where it is put.
    double length_m = 0.2;
    bool sleep = true;  ///< As in the simulator: tissue that hardly moves is not solved.
    /// New coordinate along an axis of a plane of the lattice; nullptr = as it is.
    double (*graded)(int axis, double x) = nullptr;
};
/// For a round tip of 1.5 mm pressed in by up to 0.2 mm: edges of 0.1 mm around the contact, which
/// grow to the sides (6 mm) and below (12 mm). 211,200 tetrahedra.
[[nodiscard]] FeltBlock hertz_block();
/// For a plane (a tip of 50 m) on 4 x 4 x 2 mm.
[[nodiscard]] FeltBlock incline_block(double friction);

/// The force [N] that holds a sphere of this radius pressed `depth_m` into a half-space of the
/// blocks' skin. Source: Hertz 1882.
[[nodiscard]] double hertz_force(double radius_m, double depth_m);

/// Frames of a hand that holds the instrument upright.
class FeltHand {
 public:
    FeltHand(const FeltBlock& block, int substeps);

    /// One frame with the tip at `tip`; the force on the hand [N].
    Vec3 frame(const Vec3& tip);
    /// Lowers the tip at 20 mm/s to this depth and waits; the force in the last frame [N].
    Vec3 press(double depth_m, double wait_s);

    [[nodiscard]] const SoftBody& body() const { return scene_.body; }
    /// CPU time for one simulated second.
    [[nodiscard]] double cost() const;

 private:
    const Scene scene_;
    State state_;
    ToolFeedback feedback_;
    double tip_z_m_ = 3e-4;
    double cpu_s_ = 0;
    int frames_ = 0;
};

}  // namespace placode::sim
