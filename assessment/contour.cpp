// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The planned line and what was removed along it.

#include <algorithm>
#include <cassert>
#include <cmath>

#include "assessment/statistics.h"
#include "assessment/tissue_metric_parts.h"

namespace placode::assessment {

namespace {

constexpr double kBinM = 0.0005;       // about the default ring element
constexpr double kToleranceM = 0.001;  // counts as cutting the planned line
constexpr double kReachM = 0.004;      // further away it is no part of the ring
constexpr double kTowardPlacodeM = 0.0005;

double directed_hausdorff(std::span<const Vec3> from, std::span<const Vec3> to) {
    double worst = 0;
    for (const Vec3& a : from) {
        double best = INFINITY;
        for (const Vec3& b : to) best = std::min(best, (a - b).head<2>().squaredNorm());
        worst = std::max(worst, best);
    }
    return std::sqrt(worst);
}

/// Edge of the regular tet of this volume: the size of a removed element.
double element_size(double volume_m3) { return std::cbrt(6 * std::sqrt(2.0) * volume_m3); }

struct Removed {
    ClosedContour::Foot foot;
    double volume_m3, depth_m, time_s, to_skin_m, to_placode_m;
};

std::vector<Removed> removed_near(const sim::Recording& recording, const ClosedContour& plan) {
    const sim::FieldGeometry& geometry = recording.header.geometry;
    std::optional<ClosedContour> skin, placode;
    if (geometry.skin_edge.size() >= 3) skin.emplace(geometry.skin_edge);
    if (geometry.placode_edge.size() >= 3) placode.emplace(geometry.placode_edge);
    std::vector<Removed> removed;
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kVaporised || !(event.value > 0)) continue;
        const Vec2 at(event.rest_position_m[0], event.rest_position_m[1]);
        if (!at.allFinite()) continue;
        const ClosedContour::Foot foot = plan.nearest(at);
        if (std::abs(foot.offset) > kReachM) continue;
        removed.push_back({foot, event.value, event.value2, event.time_s,
                           skin ? skin->nearest(at).offset : -1,
                           placode ? placode->nearest(at).offset : 1});
    }
    return removed;
}

}  // namespace

ClosedContour::ClosedContour(std::span<const Vec3> points) {
    assert(points.size() >= 3 && points.front() != points.back());
    double arc = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i].head<2>(), b = points[(i + 1) % points.size()].head<2>();
        points_.push_back(a);
        arc_.push_back(arc);
        arc += (b - a).norm();
    }
    arc_.push_back(arc);
}

ClosedContour::Foot ClosedContour::nearest(const Vec2& point) const noexcept {
    Foot foot;
    double best = INFINITY;
    for (size_t i = 0; i < points_.size(); ++i) {
        const Vec2& a = points_[i];
        const Vec2 edge = points_[(i + 1) % points_.size()] - a;
        const double length2 = edge.squaredNorm();
        if (!(length2 > 0)) continue;
        const double u = std::clamp((point - a).dot(edge) / length2, 0.0, 1.0);
        const Vec2 away = point - a - u * edge;
        if (away.squaredNorm() >= best) continue;
        best = away.squaredNorm();
        foot.arc = arc_[i] + u * std::sqrt(length2);
        foot.offset = std::sqrt(best);
    }
    // Inside by the winding rule: safe at corners, where the nearest edge's side is not.
    bool inside = false;
    for (size_t i = 0, j = points_.size() - 1; i < points_.size(); j = i++) {
        const Vec2 &a = points_[i], &b = points_[j];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    if (inside) foot.offset = -foot.offset;
    return foot;
}

Vec2 ClosedContour::at(double arc) const noexcept {
    arc = std::fmod(arc, length());
    if (arc < 0) arc += length();
    const size_t i = std::min<size_t>(
        static_cast<size_t>(std::upper_bound(arc_.begin(), arc_.end(), arc) - arc_.begin()) - 1,
        points_.size() - 1);
    const double span = arc_[i + 1] - arc_[i];
    const double u = span > 0 ? (arc - arc_[i]) / span : 0;
    return (1 - u) * points_[i] + u * points_[(i + 1) % points_.size()];
}

void ArcCover::add(double from, double to) {
    if (!(to > from)) return;
    if (to - from >= length_) {
        arcs_.emplace_back(0, length_);
        return;
    }
    from = std::fmod(std::fmod(from, length_) + length_, length_);
    to = std::fmod(std::fmod(to, length_) + length_, length_);
    if (from <= to) {
        arcs_.emplace_back(from, to);
    } else {
        arcs_.emplace_back(from, length_);
        arcs_.emplace_back(0, to);
    }
}

ArcCover::Result ArcCover::result() const {
    Result result;
    if (arcs_.empty()) {
        result.largest_gap = length_;
        result.gap_middle = length_ / 2;
        result.gaps = 1;
        return result;
    }
    std::vector<std::pair<double, double>> sorted = arcs_;
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::pair<double, double>> merged{sorted.front()};
    for (const auto& arc : sorted) {
        // Round-off between neighbours is no gap.
        if (arc.first <= merged.back().second + 1e-9 * length_)
            merged.back().second = std::max(merged.back().second, arc.second);
        else
            merged.push_back(arc);
    }
    double covered = 0;
    for (size_t i = 0; i < merged.size(); ++i) {
        covered += merged[i].second - merged[i].first;
        const bool last = i + 1 == merged.size();
        const double next = last ? merged.front().first + length_ : merged[i + 1].first;
        const double gap = next - merged[i].second;
        if (gap <= 1e-9 * length_) continue;
        ++result.gaps;
        if (gap > result.largest_gap) {
            result.largest_gap = gap;
            result.gap_middle = std::fmod(merged[i].second + gap / 2, length_);
        }
    }
    result.covered = std::min(1.0, covered / length_);
    return result;
}

ContourComparison compare_contours(std::span<const Vec3> plan_points, std::span<const Vec3> cut,
                                   double tolerance) {
    ContourComparison c;
    if (plan_points.size() < 3 || cut.empty()) return c;
    const ClosedContour plan(plan_points);
    std::vector<ClosedContour::Foot> feet;
    std::vector<double> distance;
    double square = 0, cut_length = 0;
    const double n = static_cast<double>(cut.size());
    for (const Vec3& point : cut) {
        feet.push_back(plan.nearest(point.head<2>()));
        const double d = std::abs(feet.back().offset);
        distance.push_back(d);
        c.mean_abs += d / n;
        c.mean_signed += feet.back().offset / n;
        square += d * d / n;
    }
    c.rms = std::sqrt(square);
    std::sort(distance.begin(), distance.end());
    c.max = distance.back();
    c.p95 = quantile(distance, 0.95);
    c.hausdorff_cut_to_plan = directed_hausdorff(cut, plan_points);
    c.hausdorff_plan_to_cut = directed_hausdorff(plan_points, cut);
    c.hausdorff = std::max(c.hausdorff_cut_to_plan, c.hausdorff_plan_to_cut);

    for (size_t i = 1; i < cut.size(); ++i) cut_length += (cut[i] - cut[i - 1]).norm();
    const bool closed =
        cut.size() > 3 && (cut.back() - cut.front()).norm() <= 2.5 * cut_length / (n - 1);
    ArcCover cover(plan.length());
    for (size_t i = 0; i + (closed ? 0 : 1) < cut.size(); ++i) {
        const ClosedContour::Foot &a = feet[i], &b = feet[(i + 1) % cut.size()];
        if (std::abs(a.offset) > tolerance || std::abs(b.offset) > tolerance) continue;
        // The shorter way round from foot to foot is the one that was cut.
        double step = b.arc - a.arc;
        step -= plan.length() * std::round(step / plan.length());
        step >= 0 ? cover.add(a.arc, a.arc + step) : cover.add(a.arc + step, a.arc);
    }
    const ArcCover::Result covered = cover.result();
    c.completeness = covered.covered;
    c.largest_gap = covered.largest_gap;
    c.gaps = covered.gaps;
    return c;
}

std::optional<Incision> analyse_incision(const sim::Recording& recording) {
    const sim::FieldGeometry& geometry = recording.header.geometry;
    if (geometry.planned_contour.size() < 3) return std::nullopt;
    const ClosedContour plan(geometry.planned_contour);
    if (!(plan.length() > 0)) return std::nullopt;

    Incision incision;
    incision.perimeter_m = plan.length();
    const size_t count = std::max<size_t>(8, static_cast<size_t>(plan.length() / kBinM));
    incision.bin_m = plan.length() / static_cast<double>(count);
    incision.bins.resize(count);
    for (size_t i = 0; i < count; ++i) {
        incision.bins[i].arc_m = (static_cast<double>(i) + 0.5) * incision.bin_m;
        incision.bins[i].at_m = plan.at(incision.bins[i].arc_m);
    }

    std::vector<double> low(count, INFINITY), high(count, -INFINITY);
    ArcCover cover(plan.length());
    for (const Removed& r : removed_near(recording, plan)) {
        const size_t i = std::min(count - 1, static_cast<size_t>(r.foot.arc / incision.bin_m));
        KerfBin& bin = incision.bins[i];
        const double half = element_size(r.volume_m3) / 2;
        bin.offset_m += r.volume_m3 * r.foot.offset;
        bin.volume_m3 += r.volume_m3;
        if (bin.time_s < 0) bin.time_s = r.time_s;
        low[i] = std::min(low[i], r.foot.offset - half);
        high[i] = std::max(high[i], r.foot.offset + half);
        bin.outside_band = bin.outside_band || r.to_skin_m > kOutsideSkinM;
        bin.toward_placode = bin.toward_placode || r.to_placode_m < kTowardPlacodeM;
        // The event carries the centroid: an element that reaches the target depth has its centroid
        // in the lower half of the way there.
        if (r.depth_m >= geometry.target_depth_m / 2 && std::abs(r.foot.offset) <= kToleranceM)
            cover.add(r.foot.arc - half, r.foot.arc + half);
    }
    for (size_t i = 0; i < count; ++i) {
        KerfBin& bin = incision.bins[i];
        if (!(bin.volume_m3 > 0)) continue;
        bin.offset_m /= bin.volume_m3;
        bin.width_m = high[i] - low[i];
    }
    incision.cover = cover.result();
    incision.gap_at_m = plan.at(incision.cover.gap_middle);
    return incision;
}

}  // namespace placode::assessment
