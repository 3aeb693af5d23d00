// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One substep of a rod: implicit Euler, by Newton steps that solve places and frames together.
//
// A thread's stretching, shearing, bending and twisting all have Courant numbers of some hundred,
// so nothing local converges: with the frames fixed while the places are solved, and the other way
// round, a bend would travel one segment a substep. In the order x0 q0 x1 q1 ... xn every unknown
// couples with the next two only; one block elimination from both ends towards the middle, two
// fronts side by side, solves the rod exactly in linear time.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/rod/rod.h"

namespace placode::sim {

/// Stiffness and force that contact adds to a segment: to its first node (aa, a), its second (bb,
/// b) and between them (ab); matrices as xx xy xz yy yz zz [N/m], forces [N].
struct SegmentContact {
    std::array<double, 6> aa{}, ab{}, bb{};
    std::array<double, 3> a{}, b{};
};

/// What acts on a rod during one substep.
struct RodDrive {
    double h_s = 0.25e-3;
    Vec3 gravity_m_s2 = Vec3(0, 0, -9.81);
    std::span<const Vec3> force_n;            ///< (N) or empty.
    std::span<const SegmentContact> contact;  ///< (S) or empty; linearised at the present places.
    /// Newton steps at most. A second one is needed only where a segment turns by more than
    /// `turn_rad` in a substep.
    int iterations = 6;
    double turn_rad = 0.02;
};

struct RodReport {
    int iterations = 0;
    double largest_turn_rad = 0;  ///< In the last Newton step.
    bool not_finite = false;      ///< The rod was left where it was, at rest.
};

/// Memory of the step, made once for a rod.
class RodScratch {
 public:
    explicit RodScratch(const Rod& rod);
    ~RodScratch();
    RodScratch(RodScratch&&) noexcept;
    RodScratch& operator=(RodScratch&&) noexcept;

 private:
    friend class RodStepper;
    struct Lists;
    std::unique_ptr<Lists> lists_;
};

/// Advances the rod by `drive.h_s`. Never throws, never allocates; the same input gives the same
/// bits. `contact` takes part in the first Newton step as it is, in later ones with its forces
/// carried along by its stiffness.
RodReport step_rod(const Rod& rod, RodState& state, const RodDrive& drive,
                   RodScratch& scratch) noexcept;

}  // namespace placode::sim
