// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/capstan.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/suture/arc_tangent.h"

namespace placode::sim {

void check(const ThreadFriction& friction) {
    need_within("thread.friction", friction.friction, 0, 1);
    need_within("thread.drag_n_m", friction.drag_n_m, 0, 1000);
    need_within("thread.barb_n_m", friction.barb_n_m, 0, 10000);
}

double exponential(double x) noexcept {
    assert(std::abs(x) < 20);
    // A 64th of it by the series, then squared six times: 1e-14.
    const double y = x / 64;
    double sum = 1;
    for (int k = 12; k >= 1; --k) sum = 1 + y / k * sum;
    for (int i = 0; i < 6; ++i) sum *= sum;
    return sum;
}

double angle_between(const Vec3& a, const Vec3& b) noexcept {
    const double across = std::sqrt(a.cross(b).squaredNorm()), along = a.dot(b);
    // tan of half the angle, by the form that does not cancel.
    const double whole = std::sqrt(across * across + along * along);
    if (!(whole > 0)) return 0;
    if (along >= 0) return 2 * arc_tangent(across / (whole + along));
    return 2 * (across > 0 ? arc_tangent((whole - along) / across) : arc_tangent(1e18));
}

CapstanLaw capstan_law(const ThreadFriction& friction, std::span<const ChannelPiece> pieces,
                       bool towards_exit) noexcept {
    CapstanLaw law;
    const double drag = friction.drag_n_m + (towards_exit ? 0 : friction.barb_n_m);
    for (size_t n = 0; n < pieces.size(); ++n) {
        const ChannelPiece& p = pieces[towards_exit ? n : pieces.size() - 1 - n];
        const double gain = exponential(friction.friction * p.bend_rad);
        const double by_wall = drag * p.length_m;
        // A piece is a bend and then its wall; backwards the wall comes first.
        law.gain *= gain;
        law.drag_n = towards_exit ? law.drag_n * gain + by_wall : (law.drag_n + by_wall) * gain;
    }
    return law;
}

ThreadSlide slide_thread(const CapstanLaw& out, const CapstanLaw& back, double in_n, double out_n,
                         double in_n_m, double out_n_m) noexcept {
    ThreadSlide slide{0, out_n, in_n, 0};
    const double over = out_n - out.gain * in_n - out.drag_n;
    const double over_back = in_n - back.gain * out_n - back.drag_n;
    if (over > 0)
        slide.slid_m = over / (out_n_m + out.gain * in_n_m);
    else if (over_back > 0)
        slide.slid_m = -over_back / (in_n_m + back.gain * out_n_m);
    else
        return slide;
    slide.out_n = std::max(0.0, out_n - out_n_m * slide.slid_m);
    slide.in_n = std::max(0.0, in_n + in_n_m * slide.slid_m);
    // What the ends let go of and do not take up, with the mean pulls on the way.
    slide.lost_j = 0.5 * slide.slid_m * (out_n + slide.out_n - in_n - slide.in_n);
    return slide;
}

void pull_along(const ThreadFriction& friction, std::span<const ChannelPiece> pieces, double in_n,
                double out_n, std::span<double> pull_n) noexcept {
    assert(pull_n.size() == pieces.size());
    // The pull where it would slide out, and where it would slide back, both from in_n on.
    const auto walk = [&](auto&& visit) {
        double most = in_n, least = in_n;
        for (size_t n = 0; n < pieces.size(); ++n) {
            const double gain = exponential(friction.friction * pieces[n].bend_rad);
            const double length = pieces[n].length_m;
            most = most * gain + friction.drag_n_m * length;
            least = std::max(0.0, least / gain - (friction.drag_n_m + friction.barb_n_m) * length);
            visit(n, most, least);
        }
    };
    double most = in_n, least = in_n;
    walk([&](size_t, double m, double l) {
        most = m;
        least = l;
    });
    const double share = most > least ? std::clamp((out_n - least) / (most - least), 0.0, 1.0) : 0;
    walk([&](size_t n, double m, double l) { pull_n[n] = l + share * (m - l); });
}

}  // namespace placode::sim
