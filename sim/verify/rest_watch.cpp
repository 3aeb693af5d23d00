// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/rest_watch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/core/number_text.h"
#include "sim/verify/equilibrium.h"

namespace placode::sim {
namespace {

constexpr int kQuietFrames = 10;
constexpr double kThere = 5e-3;    // of the displacement: what may be left of the way
constexpr double kNothing = 1e-7;  // of the body: no way at all

}  // namespace

bool RestWatch::frame(double time_s, const Coordinates& x) {
    const auto& limit = setup_.scene.rest_speed_m_s;
    if (!limit || time_s < setup_.longest_ramp_s()) return false;
    const double path = before_.size() > 0 ? largest_displacement(x - before_)
                                           : std::numeric_limits<double>::infinity();
    before_ = x;
    for (const SphereObstacle& s : setup_.scene.spheres) {
        if (s.velocity_m_s.norm() > 0) return false;
    }
    ++recent_frames_;
    if (!(path < *limit * setup_.scene.solver.frame_s)) {
        quiet_ = 0;
        last_ = {};  // what moved is compared anew
    } else if (quiet_++ % kQuietFrames == 0) {
        recent_ = x;
        recent_frames_ = 0;
    }
    if (quiet_ < kQuietFrames || recent_frames_ < kQuietFrames / 2 || time_s < next_check_s_)
        return false;
    const auto begin = std::chrono::steady_clock::now();
    const bool there = arrived(time_s, x);
    out_.check_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return there;
}

bool RestWatch::arrived(double time_s, const Coordinates& x) {
    const double moved = largest_displacement(x - setup_.body->rest());
    const double little = std::max(kThere * moved, kNothing * setup_.extent_m());
    const auto step = step_to_equilibrium(setup_, x, time_s);
    if (!step) return stays(time_s, x, little);
    const double left = largest_displacement(*step);
    out_.equilibrium_error_m = left;
    if (left <= little) return true;
    const double length = step->norm();
    const double toward =
        (x - recent_).dot(*step) / length / (recent_frames_ * setup_.scene.solver.frame_s);
    const bool first = last_.length == 0, moves = std::abs(toward) * time_s > 0.1 * length;
    if (!first && !moves && !sets_out(length, toward) && !came_nearer(length)) {
        warn(left, moved);
        return true;
    }
    last_ = {length, toward, length * std::exp(-std::max(0.0, toward) * time_s / length)};
    next_check_s_ = 2 * time_s;
    return false;
}

/// Where no step tells: doubling the time moved it by little. What nothing holds may drift.
bool RestWatch::stays(double time_s, const Coordinates& x, double little) {
    if (!is_held(setup_)) return true;
    const bool stayed = checked_.size() > 0 && largest_displacement(x - checked_) <= little;
    checked_ = x;
    next_check_s_ = 2 * time_s;
    return stayed;
}

/// Faster than before, and not by noise: at that speed it gets there in this scene, or nearly.
bool RestWatch::sets_out(double length, double toward) const {
    return toward > 1.5 * std::max(0.0, last_.toward) && length < 10 * setup_.scene.end_s * toward;
}

/// By a tenth, or by half of what its speed promised: what creeps leaves less exponentially.
bool RestWatch::came_nearer(double length) const {
    const double tenth = 0.1 * last_.length, promised = last_.length - last_.promised;
    return last_.length - length > (promised > 0 ? std::min(0.5 * promised, tenth) : tenth);
}

void RestWatch::warn(double left_m, double moved_m) {
    out_.warnings.push_back("at rest, but about " + rounded_text(left_m, 2) + " m (" +
                            rounded_text(100 * left_m / moved_m, 3) +
                            " % of the largest displacement) from equilibrium, and nearer slowly "
                            "or not at all; expected more substeps, or method newton");
}

void RestWatch::end(double time_s, const Coordinates& x) {
    if (!setup_.scene.rest_speed_m_s || out_.at_rest || !x.allFinite()) return;
    out_.at_rest = quiet_ >= kQuietFrames;
    const auto step = step_to_equilibrium(setup_, x, time_s);
    const double moved = largest_displacement(x - setup_.body->rest());
    if (step) out_.equilibrium_error_m = largest_displacement(*step);
    if (out_.at_rest && step && *out_.equilibrium_error_m > kThere * moved)
        warn(*out_.equilibrium_error_m, moved);
    if (!out_.at_rest)
        out_.warnings.push_back("not at rest after " + rounded_text(time_s, 4) +
                                " s; expected more time (\"max_s\"), damping, or method newton");
}

}  // namespace placode::sim
