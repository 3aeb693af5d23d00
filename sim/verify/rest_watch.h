// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// When a verification scene is at rest, and whether it rests where it should. Private to
// sim/verify.

#include "sim/verify/solve_setup.h"

namespace placode::sim {

/// Watches for rest: nothing faster than the limit for 10 frames after the last ramp. Slow is not
/// there yet, for tissue sets out slowly, creeps and turns back in a swing: a Newton step of the
/// reference tells how far it is from equilibrium. The scene goes on until 0.5 % of the
/// displacement are left, or doubling the time brings it no nearer; that is said then. With spheres
/// and in large bodies no step tells, and it goes on until doubling the time moves it by no more.
class RestWatch {
 public:
    RestWatch(const SolveSetup& setup, SolveResult& out) : setup_(setup), out_(out) {}
    /// Call once a frame. true = at rest. Speeds are means over the frame: those of single substeps
    /// carry the rounding of positions, which is 10 um/s for a last digit in 30 us.
    [[nodiscard]] bool frame(double time_s, const Coordinates& x);
    /// Says so when the scene was to end at rest and did not.
    void end(double time_s, const Coordinates& x);

 private:
    [[nodiscard]] bool arrived(double time_s, const Coordinates& x);
    [[nodiscard]] bool stays(double time_s, const Coordinates& x, double little);
    [[nodiscard]] bool sets_out(double length, double toward) const;
    [[nodiscard]] bool came_nearer(double length) const;
    void warn(double left_m, double moved_m);

    /// Of the step to equilibrium: how long (2-norm) [m], how fast along it [m/s], how long it is
    /// to be at the next check; 0 = none since it moved.
    struct Check {
        double length = 0, toward = 0, promised = 0;
    };

    const SolveSetup& setup_;
    SolveResult& out_;
    Coordinates before_, recent_, checked_;  // a frame ago; some quiet frames ago; at a check
    int quiet_ = 0, recent_frames_ = 0;
    Check last_;
    double next_check_s_ = 0;
};

}  // namespace placode::sim
