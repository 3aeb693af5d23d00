// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bonds between the needle and points of the tissue, and the vertices that carry them. Like those
// that instruments touch (sim/contact/contact.h), these vertices leave the kernels' sweep and are
// solved one by one, with their full Hessian plus what every bond adds.
//
// A bond is an energy of the point's place in N, so that what it does to the tissue and to the
// needle are action and reaction at one point by construction, forces and torques:
//   passage   k/2 (radial^2 + across^2) + k/2 (s - s0)^2     the last one up to friction's bound
//   point     k/2 u^2 + k/2 (beside)^2                       u > 0: the point pushes tissue ahead
// Beyond a bound the force is the bound's; the step then moves s0 (and the tissue under the point)
// until the spring carries no more than the bound.

#include <array>
#include <vector>

#include "sim/solver/vertex_step.h"
#include "sim/suture/thread_line.h"

namespace placode::sim {

/// Of one substep, made from a passage or the needle's point.
struct NeedleBond {
    std::array<int32_t, 4> vertex{};
    std::array<double, 4> b{};
    int32_t passage = -1;  ///< -1: the point.
    double hold_n_m = 0;
    double sticks_at_m = 0;    ///< Passages: s0.
    Vec3 near = Vec3::Zero();  ///< Passages: foot when the substep began, its radial direction;
    double near_m = 0;         ///< and its arc coordinate. Zero: not known.
    double along_n = 0;        ///< Bound of the force along the needle; below 0: none.
    double across_ratio = -1;  ///< Point: bound across, times the force along; below 0: none.
};

/// What a bond asks of its point of the tissue, in W.
struct BondForce {
    Vec3 gradient = Vec3::Zero();   ///< Of the energy by the point's place [N].
    Mat3 stiffness = Mat3::Zero();  ///< [N/m], positive semidefinite.
};

/// The needle's pose, once as a matrix.
struct PosedNeedle {
    PosedNeedle(const Needle& needle, const Pose& X_WN) noexcept
        : shape(needle), p(X_WN.p), r(X_WN.q.toRotationMatrix()) {}
    [[nodiscard]] Vec3 to_N(const Vec3& p_W) const noexcept { return r.transpose() * (p_W - p); }
    [[nodiscard]] Vec3 to_W(const Vec3& p_N) const noexcept { return r * p_N + p; }
    const Needle& shape;
    Vec3 p;
    Mat3 r;
};

/// @param slope stiffness of the law itself, none beyond a bound: for the needle, which slides on
/// through all of its bonds at once. With the secant's its steps would be a hundred times too short
/// and the hand would feel a drag. Vertices take the secant's, as those in contact do.
[[nodiscard]] BondForce force_of(const PosedNeedle& needle, const NeedleBond& bond, const Vec3& p_W,
                                 bool slope) noexcept;
/// Whose slope force_of() is: beyond a bound it grows by the bound's force [J].
[[nodiscard]] double energy_of(const PosedNeedle& needle, const NeedleBond& bond,
                               const Vec3& p_W) noexcept;
/// How far the point has pushed the tissue at p_W ahead of itself [m]; negative: it has drawn back.
[[nodiscard]] double pushed_m(const PosedNeedle& needle, const Vec3& p_W) noexcept;

/// Where a needle that nobody holds lies on a surface.
struct NeedleSupport {
    Vec3 at_N = Vec3::Zero();
    Vec3 n = Vec3::UnitZ();  ///< Of the surface, in W.
    double offset_m = 0;     ///< gap = n . place - offset
};
inline constexpr int kMostSupports = 2 * 9;

/// Lists of a substep. Nothing in it decides the future.
class SutureScratch {
 public:
    SutureScratch(const SoftBody& body, const Suture& suture);
    /// As if built anew, between two frames.
    void forget() noexcept;

    /// A vertex and its share of the bonds: entries bond * 4 + corner; then of the thread's
    /// passages: entries ~(passage * 4 + corner), in their order.
    struct Colour {
        int32_t vertex = 0, first = 0, count = 0;
    };
    std::vector<NeedleBond> bonds;  ///< First `bond_count`.
    std::vector<Colour> colour;
    std::vector<int32_t> incidence;
    std::vector<int32_t> slot;  ///< (V) into colour, -1 = none.
    std::vector<Vec3> places;   ///< Of the bonds' points, while the needle is solved.
    std::array<NeedleSupport, kMostSupports> supports{};  ///< First `support_count`.
    ThreadLine thread;
    int bond_count = 0, colour_count = 0, support_count = 0;
    Pose start;          ///< The needle when the substep began.
    Pose hand_before;    ///< And the hand,
    Pose second_before;  ///< and that of the second hold.
};

/// Where the point of a bond is now [m].
[[nodiscard]] Vec3 place_of(const SoftBodyState& state, const NeedleBond& bond) noexcept;

/// The bond of passage i, of the point.
[[nodiscard]] NeedleBond passage_bond(const Suture& suture, const SutureState& state,
                                      const SuturedTissue& tissue, int i) noexcept;
[[nodiscard]] NeedleBond point_bond(const Suture& suture, const SutureState& state,
                                    const SuturedTissue& tissue) noexcept;

/// Bonds of all passages and of the point, and the thread's passages; their vertices leave the
/// sweep and start where they were.
void collect_bonds(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch) noexcept;
/// One pass over the vertices, there or back.
void solve_bonded_vertices(const Suture& suture, const SutureState& state,
                           const SuturedTissue& tissue, SutureScratch& scratch, double h_s,
                           bool backward) noexcept;
/// What needle and thread pull at a bonded vertex, with all of them where they are: for one that a
/// hand holds in place [N].
[[nodiscard]] Vec3 pull_on_vertex(const Suture& suture, const SutureState& state,
                                  const SuturedTissue& tissue, const SutureScratch& scratch,
                                  int32_t vertex) noexcept;
/// The vertices belong to the sweep again.
void release_bonds(const SuturedTissue& tissue, SutureScratch& scratch) noexcept;

}  // namespace placode::sim
