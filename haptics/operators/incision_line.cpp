// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/incision_line.h"

#include <algorithm>
#include <cmath>

namespace placode::haptics {

namespace {

constexpr size_t kNormalSpan = 7;   // Points over which the surface's direction is judged.
constexpr double kRememberS = 1.0;  // Time constant of the remembered line.
constexpr double kNearTipM = 2e-3, kMostDriftM = 1.2e-3;
constexpr double kSunkM = 8e-4;  // The whole line lies this much lower: the sac is open.
constexpr double kStillM = 2e-4, kStillS = 0.8, kMostWatchS = 5;  // It lies still again.
constexpr double kLongAgoS = 1e3;
constexpr double kRoundShare = 0.6;  // of the line over a sunk sac is cut: look for bridges
constexpr int kSectorsBeside =
    3;  // are held by a bridge as well: kSectorsAside in sim/cutting/release.cpp
constexpr double kLeastUp = 0.45;  // normals lean no further: a flap's edge may fold over

/// A unit normal, leaned back towards the vertical where it leans too far.
Vec3 upright(const Vec3& n) noexcept {
    if (n.z() >= kLeastUp) return n;
    const double flat = n.head<2>().norm();
    if (flat < 1e-9) return Vec3::UnitZ();
    const double side = std::sqrt(1 - kLeastUp * kLeastUp) / flat;
    return {side * n.x(), side * n.y(), kLeastUp};
}

}  // namespace

// Seen at rest, and corrected slowly where the tissue has moved as a whole. Not corrected where the
// cut has let an edge curl, and not under the needle.
void IncisionLine::see(const Perception& seen, const Vec3& tip_m, double watched_s) {
    const size_t n = seen.contour.size();
    if (contour_.size() != n) {
        learn(seen);
        tries_.assign(n, 0);
        heated_s_.assign(n, -kLongAgoS);
        cut_.assign(n, 0);
        arc_.assign(n + 1, 0.0);
    }
    const double share = std::clamp(seen.time_s - seen_s_, 0.0, 0.05) / kRememberS;
    seen_s_ = seen.time_s;
    look_for_bridges(seen);
    for (size_t i = 0; i < n; ++i) {
        if (by_bridges_)
            cut_[i] = bridge_[static_cast<size_t>(sim::sector_of(seen.contour[i]))] == 0;
        else
            cut_[i] = i < seen.contour_cut.size() ? seen.contour_cut[i] : 0;
        const Vec3 drift = seen.contour[i] - contour_[i];
        const bool near_tip = (contour_[i] - tip_m).norm() < kNearTipM;
        if (cut_[i] == 0 && !near_tip && drift.norm() < kMostDriftM) contour_[i] += share * drift;
    }
    watch_sinking(seen, watched_s);
    measure();
}

// The line as it lies now, with normals over a few points: a single facet says little about the
// surface.
void IncisionLine::learn(const Perception& seen) {
    const size_t n = seen.contour.size();
    contour_.assign(seen.contour.begin(), seen.contour.end());
    normal_.assign(n, Vec3::UnitZ());
    for (size_t i = 0; i < n && seen.contour_normal.size() == n; ++i) {
        Vec3 sum = Vec3::Zero();
        for (size_t k = 0; k < kNormalSpan; ++k) {
            const Vec3& normal = seen.contour_normal[(i + n + k - kNormalSpan / 2) % n];
            if (normal.allFinite() && normal.norm() > 0.5) sum += normal.normalized();
        }
        if (sum.norm() > 0.5) normal_[i] = sum.normalized();
    }
}

// Once round, what counts is where the placode still hangs on: over a sunk sac as soon as most of
// the line is cut, else when nothing is left of it (`seek_bridges`). A placode that is free all
// round needs no more energy.
void IncisionLine::look_for_bridges(const Perception& seen) noexcept {
    if (seen.sector_free.empty()) return;
    hangs_on_ = seen.released < 1;
    if (!by_bridges_ && has_sunk_) {
        const auto cut = std::count(seen.contour_cut.begin(), seen.contour_cut.end(), 1);
        if (static_cast<double>(cut) > kRoundShare * static_cast<double>(seen.contour_cut.size()))
            seek_bridges();
    }
    if ((has_sunk_ || by_bridges_) && !hangs_on_) freed_ = true;
    // A bridge holds the sectors beside its own as well: it is in the middle of those that are
    // held.
    constexpr int kN = sim::kSectors;
    const auto held = [&](int s, int step) {
        int n = 0;
        while (n <= kSectorsBeside && seen.sector_free[(s + n * step + kN) % kN] == 0) ++n;
        return n;
    };
    for (int s = 0; s < kN; ++s) {
        const int back = held(s, -1), on = held(s, 1);
        bridge_[s] = back > 0 && std::abs(back - on) <= 1;
    }
}

void IncisionLine::seek_bridges() noexcept {
    by_bridges_ = true;
    std::fill(tries_.begin(), tries_.end(), uint8_t{0});  // also where the line was given up
}

// An opened sac sinks by millimetres, too far for a memory of single points: then the hand is
// lifted until everything has come to rest, and the line is looked at anew.
void IncisionLine::watch_sinking(const Perception& seen, double watched_s) {
    double now = 0, remembered = 0;
    int count = 0;
    for (size_t i = 0; i < contour_.size(); ++i) {
        if (cut_[i] != 0) continue;
        now += seen.contour[i].z();
        remembered += contour_[i].z();
        ++count;
    }
    if (count == 0) return;
    sunk_m_ = (remembered - now) / count;
    if (std::abs(now / count - still_z_m_) > kStillM) {
        still_z_m_ = now / count;
        still_since_s_ = seen.time_s;
    }
    sinks_ |= sunk_m_ > kSunkM;
    const bool still = seen.time_s - still_since_s_ > kStillS || watched_s > kMostWatchS;
    if (watched_s < 0 || !still) return;
    learn(seen);
    has_sunk_ |= sinks_;
    sunk_m_ = 0;
    sinks_ = false;
}

// Arc lengths, and where the line begins.
void IncisionLine::measure() noexcept {
    const size_t n = contour_.size();
    arc_[0] = 0;
    centre_.setZero();
    for (size_t i = 0; i < n; ++i) {
        arc_[i + 1] = arc_[i] + (contour_[(i + 1) % n] - contour_[i]).norm();
        centre_ += contour_[i] / static_cast<double>(n);
    }
    if (start_m_ < 0 && n > 2) {  // Caudal start: the end of the ring nearest to the operator.
        size_t first = 0;
        for (size_t i = 1; i < n; ++i)
            if (contour_[i].x() < contour_[first].x()) first = i;
        start_m_ = arc_[first];
    }
}

double IncisionLine::wrapped(double s_m) const noexcept {
    const double length = arc_.back();
    s_m = std::fmod(s_m, length);
    return s_m < 0 ? s_m + length : s_m;
}

size_t IncisionLine::index(double s_m) const noexcept {
    const auto next = std::upper_bound(arc_.begin(), arc_.end() - 1, wrapped(s_m));
    return static_cast<size_t>(std::max<std::ptrdiff_t>(0, next - arc_.begin() - 1));
}

IncisionLine::Place IncisionLine::place(double s_m) const noexcept {
    const size_t n = contour_.size(), i = index(s_m), j = (i + 1) % n;
    const double length = arc_[i + 1] - arc_[i];
    const double w = length > 0 ? std::clamp((wrapped(s_m) - arc_[i]) / length, 0.0, 1.0) : 0;
    Place f;
    f.point = (1 - w) * contour_[i] + w * contour_[j];
    f.normal = upright(((1 - w) * normal_[i] + w * normal_[j]).normalized());
    // The tangent over a few points, because single segments of a deformed contour are noisy, and
    // blended like the rest: a hand beside the line must not jump where the segments meet.
    const auto tangent = [&](size_t k) {
        return Vec3(contour_[(k + 2) % n] - contour_[(k + n - 2) % n]);
    };
    const Vec3 along = (1 - w) * tangent(i) + w * tangent(j);
    Vec3 inward = f.normal.cross(along);
    inward = inward.norm() > 0 ? Vec3(inward.normalized()) : Vec3(Vec3::UnitY());
    // Which side is inside is told from above: in the tissue's own plane a folded edge turns it.
    const Vec3 level = Vec3::UnitZ().cross(along);
    const bool turned = level.dot(centre_ - f.point) < 0;
    f.inward = inward.dot(turned ? Vec3(-level) : level) < 0 ? Vec3(-inward) : inward;
    return f;
}

bool IncisionLine::next_run(double from_m, int most_tries, double least_m,
                            Run& run) const noexcept {
    const size_t n = contour_.size();
    if (n < 3) return false;
    const size_t first = index(from_m);
    const auto open = [&](size_t i) { return cut_[i] == 0 && tries_[i] < most_tries; };
    for (size_t k = 0; k < n; ++k) {
        if (!open((first + k) % n)) continue;
        size_t m = k;
        while (m < k + n && open((first + m) % n)) ++m;
        const double length = arc_.back() / static_cast<double>(n) * static_cast<double>(m - k);
        if (length < least_m) {
            k = m;
            continue;
        }
        run.begin_m = arc_[(first + k) % n];
        run.end_m = run.begin_m + length;
        return true;
    }
    return false;
}

size_t IncisionLine::points(double reach_m) const noexcept {
    return static_cast<size_t>(reach_m / (arc_.back() / static_cast<double>(contour_.size()))) + 1;
}

bool IncisionLine::left_near(double s_m, double reach_m) const noexcept {
    const size_t n = contour_.size(), reach = points(reach_m), here = index(s_m);
    for (size_t k = 0; k <= 2 * reach; ++k)
        if (cut_[(here + 2 * n + k - reach) % n] == 0) return true;
    return false;
}

bool IncisionLine::warm_ahead(double s_m, double reach_m, double time_s,
                              double cool_s) const noexcept {
    const size_t n = contour_.size(), here = index(s_m);
    for (size_t k = 1; k <= points(reach_m); ++k) {
        const size_t ahead = (here + k) % n;
        if (cut_[ahead] == 0 && time_s - heated_s_[ahead] < cool_s) return true;
    }
    return false;
}

void IncisionLine::count_try(size_t point) noexcept {
    if (tries_[point] < 255) ++tries_[point];
}

}  // namespace placode::haptics
