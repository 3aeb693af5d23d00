// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/sheet_cover.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/core/portable_math.h"

namespace placode::sim {
namespace {

constexpr double kSeam = 1e-6;         // of the way: neighbours that share an edge leave no gap
constexpr double kStandsCosine = 0.5;  // of 60 degrees

double cross(const Vec2& a, const Vec2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

bool is_inside(std::span<const Vec3> line, const Vec2& p) noexcept {
    bool inside = false;
    for (size_t i = 0, j = line.size() - 1; i < line.size(); j = i++) {
        const Vec3 &a = line[i], &b = line[j];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (p.x() < x) inside = !inside;
    }
    return inside;
}

}  // namespace

SheetCover::SheetCover(size_t faces) : face_(faces) { crossed_.reserve(faces); }

void SheetCover::place(std::span<const std::array<Vec3, 3>> corners) noexcept {
    assert(corners.size() == face_.size());
    for (size_t i = 0; i < face_.size(); ++i) {
        Face& face = face_[i];
        const auto& [a, b, c] = corners[i];
        face.at = {a.head<2>(), b.head<2>(), c.head<2>()};
        face.middle = (face.at[0] + face.at[1] + face.at[2]) / 3;
        double radius2 = 0;
        for (const Vec2& p : face.at) radius2 = std::max(radius2, (p - face.middle).squaredNorm());
        face.radius_m = std::sqrt(radius2);
        const Vec3 twice = (b - a).cross(c - a);
        const double norm = twice.norm();
        face.area_m2 = norm / 2;
        face.normal = norm > 0 ? Vec3(twice / norm) : Vec3::Zero();
    }
}

bool SheetCover::holds(const Face& face, const Vec2& p) noexcept {
    if ((p - face.middle).squaredNorm() > face.radius_m * face.radius_m) return false;
    const double ab = cross(face.at[1] - face.at[0], p - face.at[0]),
                 bc = cross(face.at[2] - face.at[1], p - face.at[1]),
                 ca = cross(face.at[0] - face.at[2], p - face.at[2]);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool SheetCover::covers(const Vec2& p) const noexcept {
    return std::any_of(face_.begin(), face_.end(),
                       [&](const Face& face) { return holds(face, p); });
}

double SheetCover::reach(const Vec2& from, const Vec2& direction, double most) noexcept {
    const double seam = kSeam * most;
    crossed_.clear();
    for (const Face& face : face_) {
        const Vec2 there = face.middle - from;
        const double along = there.dot(direction), radius = face.radius_m + seam;
        if (along < -radius || along > most + radius || std::abs(cross(direction, there)) > radius)
            continue;
        // The stretch of the ray within the triangle, from one side's crossing to another's.
        double low = std::numeric_limits<double>::max(), high = -low;
        for (size_t k = 0; k < 3; ++k) {
            const Vec2 &a = face.at[k], &b = face.at[(k + 1) % 3];
            const double sa = cross(direction, a - from), sb = cross(direction, b - from);
            if ((sa > 0 && sb > 0) || (sa < 0 && sb < 0)) continue;
            const double ta = (a - from).dot(direction), tb = (b - from).dot(direction);
            const bool along_it = sa == sb;  // both on the ray
            const double t = along_it ? ta : ta + sa / (sa - sb) * (tb - ta);
            low = std::min({low, t, along_it ? tb : t});
            high = std::max({high, t, along_it ? tb : t});
        }
        if (high < -seam || low > most || high <= low) continue;
        crossed_.push_back({low, high});
    }
    std::sort(crossed_.begin(), crossed_.end());
    double reached = 0;
    bool begun = false;
    for (const auto& [low, high] : crossed_) {
        if (low > reached + seam) break;
        begun = true;
        reached = std::max(reached, high);
        if (reached >= most) return most;
    }
    return begun ? reached : 0;
}

double SheetCover::margin(const Vec2& from, const Vec2& outward, int directions,
                          double most) noexcept {
    assert(directions >= 1);
    double least = reach(from, outward, most);
    const double step = 0.5 * std::numbers::pi / directions;
    for (int i = 1; i <= directions && least > 0; ++i) {
        for (const int side : {-1, 1}) {
            const auto [s, c] = sin_cos_portable(side * i * step);
            const Vec2 direction(c * outward.x() - s * outward.y(),
                                 s * outward.x() + c * outward.y());
            least = std::min(least, reach(from, direction, most));
        }
    }
    return least;
}

double SheetCover::folded(size_t face, const Vec3& most_look) const noexcept {
    const Face& own = face_[face];
    int layers = 1;
    for (size_t i = 0; i < face_.size(); ++i)
        if (i != face && holds(face_[i], own.middle)) ++layers;
    if (layers > 1) return 1 - 1.0 / layers;
    return own.normal.dot(most_look) < kStandsCosine ? 1 : 0;
}

Vec3 SheetCover::most_look() const noexcept {
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (const Face& face : face_) {
        sum += face.area_m2 * face.normal;
        area += face.area_m2;
    }
    // Folded in two, or crumpled, it looks nowhere.
    return sum.norm() > kSeam * area ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

std::vector<EdgePoint> points_of_edge(std::span<const Vec3> line, int count) {
    assert(line.size() >= 3 && count >= 1);
    double whole = 0, area = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec2 a = line[i].head<2>(), b = line[(i + 1) % line.size()].head<2>();
        whole += (b - a).norm();
        area += cross(a, b);
    }
    std::vector<EdgePoint> points;
    size_t i = 0;
    double behind = 0;  // length up to point i
    for (int n = 0; n < count; ++n) {
        const double wanted = whole * n / count;
        double length = (line[(i + 1) % line.size()] - line[i]).head<2>().norm();
        while (behind + length < wanted && i + 1 < line.size()) {
            behind += length;
            ++i;
            length = (line[(i + 1) % line.size()] - line[i]).head<2>().norm();
        }
        const Vec2 a = line[i].head<2>(), b = line[(i + 1) % line.size()].head<2>();
        const Vec2 along = length > 0 ? Vec2((b - a) / length) : Vec2::UnitX();
        const double side = area >= 0 ? 1 : -1;  // counter-clockwise: out is to the right
        points.push_back(
            {a + std::min(wanted - behind, length) * along, side * Vec2(along.y(), -along.x())});
    }
    return points;
}

std::vector<Vec2> points_within(std::span<const Vec3> line, double spacing_m) {
    std::vector<Vec2> points;
    if (line.size() < 3) return points;
    Vec2 low = line[0].head<2>(), high = low;
    for (const Vec3& p : line) {
        low = low.cwiseMin(p.head<2>());
        high = high.cwiseMax(p.head<2>());
    }
    for (double y = low.y() + spacing_m / 2; y < high.y(); y += spacing_m)
        for (double x = low.x() + spacing_m / 2; x < high.x(); x += spacing_m)
            if (is_inside(line, Vec2(x, y))) points.emplace_back(x, y);
    return points;
}

}  // namespace placode::sim
