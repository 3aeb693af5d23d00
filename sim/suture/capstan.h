// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Thread that runs through a channel: how its pull changes from the entry to the exit, and how far
// it slides. At a bend by phi the pull grows by e^(mu phi) in the way that it slides (Euler,
// Eytelwein), and along the wall by a drag. Over a channel of many bends and pieces that is one
// affine law, pull_out = gain * pull_in + drag, so that the slide that brings both ends back to
// friction's bound is found in closed form: no search for segments, no jerks when a node passes.
// Free of the library's exponential and arc tangent, as all that the step uses.

#include <span>

#include "sim/core/geometry.h"
#include "sim/suture/suture_error.h"

namespace placode::sim {

/// Planning values. mu: monofilament 0.15, coated braid 0.20, braid 0.30.
struct ThreadFriction {
    double friction = 0.15;  ///< mu against the channel's wall: 0 to 1.
    double drag_n_m = 0;     ///< Along the wall, by length: 0 to 1000 [N/m].
    double barb_n_m = 0;     ///< Barbs: what holds against the way back, by length [N/m]; 0 = none.
};
/// @throws SutureError
void check(const ThreadFriction& friction);

/// One piece of a channel, from the entry on: the bend before it, then its length.
struct ChannelPiece {
    double bend_rad = 0;  ///< 0 to pi.
    double length_m = 0;
};

/// pull at the far end = gain * pull at the near end + drag, where it slides towards the far end.
struct CapstanLaw {
    double gain = 1;
    double drag_n = 0;
};
/// Towards the exit (last piece), or back. Barbs count on the way back.
[[nodiscard]] CapstanLaw capstan_law(const ThreadFriction& friction,
                                     std::span<const ChannelPiece> pieces,
                                     bool towards_exit) noexcept;

/// What happens to thread under two pulls.
struct ThreadSlide {
    double slid_m = 0;           ///< Of thread, towards the exit; negative: back. 0: it sticks.
    double out_n = 0, in_n = 0;  ///< Pulls after it.
    double lost_j = 0;           ///< Taken by the wall, never negative.
};
/// @param in_n, out_n pulls at entry and exit, not negative [N].
/// @param in_n_m, out_n_m how they change with the slide [N/m]; not both zero.
[[nodiscard]] ThreadSlide slide_thread(const CapstanLaw& out, const CapstanLaw& back, double in_n,
                                       double out_n, double in_n_m, double out_n_m) noexcept;

/// Pull in every piece, for pulls at the ends between which it sticks or slides; ends with out_n.
/// Between the bounds the wall takes the same share everywhere of what it could.
/// @pre pull_n.size() == pieces.size().
void pull_along(const ThreadFriction& friction, std::span<const ChannelPiece> pieces, double in_n,
                double out_n, std::span<double> pull_n) noexcept;

/// e^x from sums and products. @pre |x| < 20.
[[nodiscard]] double exponential(double x) noexcept;
/// Angle between two directions, 0 to pi; their lengths do not matter. 0 where one of them is zero.
[[nodiscard]] double angle_between(const Vec3& a, const Vec3& b) noexcept;

}  // namespace placode::sim
