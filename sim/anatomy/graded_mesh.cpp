// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Placing points by a size field: curves first, then random points that keep their distance, then
// smoothing. Source of the smoothing: Du, Faber, Gunzburger 1999 (centroidal Voronoi), in the
// cheaper form of Chen & Holst 2011 (centroids of the patch, weighted by the size field).

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "sim/anatomy/planar_delaunay.h"
#include "sim/mesh/mesh.h"

namespace placode::sim {

namespace {

constexpr int kSmoothingRounds = 12;
// Random points that keep a distance d cover the plane as densely as a hexagonal lattice of
// 1.28 d (an edge of about 1.1 sizes here); tried on the default field for 42,000 tets.
constexpr double kDistancePerSize = 0.86;
constexpr double kCandidatesPerDistance = 5;
// Points of two curves closer than this share of the size would make slivers.
constexpr double kLeastCurveDistance = 0.55;

// Buckets of points for "is anything within d of p".
class PointGrid {
 public:
    PointGrid(const Vec2& half, double cell_m)
        : half_(half),
          cell_(cell_m),
          nx_(static_cast<int>(2 * half.x() / cell_m) + 1),
          ny_(static_cast<int>(2 * half.y() / cell_m) + 1),
          buckets_(static_cast<size_t>(nx_) * ny_) {}

    void add(const Vec2& p) {
        const auto [i, j] = cell_of(p);
        buckets_[static_cast<size_t>(j) * nx_ + i].push_back(p);
    }

    [[nodiscard]] bool anything_within(const Vec2& p, double distance) const {
        const int reach = static_cast<int>(std::ceil(distance / cell_));
        const auto [ci, cj] = cell_of(p);
        for (int j = std::max(0, cj - reach); j <= std::min(ny_ - 1, cj + reach); ++j) {
            for (int i = std::max(0, ci - reach); i <= std::min(nx_ - 1, ci + reach); ++i) {
                for (const Vec2& q : buckets_[static_cast<size_t>(j) * nx_ + i]) {
                    if ((p - q).squaredNorm() < distance * distance) return true;
                }
            }
        }
        return false;
    }

 private:
    [[nodiscard]] std::pair<int, int> cell_of(const Vec2& p) const {
        return {std::clamp(static_cast<int>((p.x() + half_.x()) / cell_), 0, nx_ - 1),
                std::clamp(static_cast<int>((p.y() + half_.y()) / cell_), 0, ny_ - 1)};
    }

    Vec2 half_;
    double cell_;
    int nx_, ny_;
    std::vector<std::vector<Vec2>> buckets_;
};

// Corners, sides and curves: these points never move.
std::vector<Vec2> fixed_points(const Vec2& half, std::span<const std::vector<Vec2>> curves,
                               std::span<const Vec2> kept, const SizeField& size) {
    std::vector<Vec2> points{Vec2(-half.x(), -half.y()), Vec2(half.x(), -half.y()),
                             Vec2(half.x(), half.y()), Vec2(-half.x(), half.y())};
    for (int side = 0; side < 4; ++side) {
        const std::vector<Vec2> line{points[side], points[(side + 1) % 4]};
        const std::vector<Vec2> cut = divided(line, false, size);
        for (size_t i = 1; i + 1 < cut.size(); ++i) points.push_back(cut[i]);
    }
    points.insert(points.end(), kept.begin(), kept.end());
    for (const std::vector<Vec2>& curve : curves) {
        const size_t others = points.size();
        for (const Vec2& p : divided(curve, true, size)) {
            const double least = kLeastCurveDistance * size(p);
            const bool near =
                std::any_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(others),
                            [&](const Vec2& q) { return (p - q).squaredNorm() < least * least; });
            if (!near) points.push_back(p);
        }
    }
    for (Vec2& p : points) p = on_grid(p);
    return points;
}

// Smallest and mean-density view of the size field: cells are half the smallest edge.
struct SizeSurvey {
    double smallest_m = 1e9;
    double triangles = 0;
};

SizeSurvey survey(const Vec2& half, const SizeField& size) {
    constexpr int kCells = 200;
    SizeSurvey out;
    const double area = 4 * half.x() * half.y() / (kCells * kCells);
    for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
            const double h = size(Vec2(half.x() * (2 * (i + 0.5) / kCells - 1),
                                       half.y() * (2 * (j + 0.5) / kCells - 1)));
            out.smallest_m = std::min(out.smallest_m, h);
            out.triangles += area / (std::sqrt(3.0) / 4 * h * h);
        }
    }
    return out;
}

// Candidates on a fine lattice in random order; each is taken when nothing taken is too near.
void fill(std::vector<Vec2>& points, const Vec2& half, const SizeField& size, double smallest_m,
          uint64_t seed) {
    const double step = kDistancePerSize * smallest_m / kCandidatesPerDistance;
    const int nx = static_cast<int>(2 * half.x() / step),
              ny = static_cast<int>(2 * half.y() / step);
    std::vector<int32_t> order(static_cast<size_t>(nx) * ny);
    for (size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int32_t>(i);
    std::mt19937_64 random(seed);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    PointGrid grid(half, kDistancePerSize * smallest_m);
    for (const Vec2& p : points) grid.add(p);
    for (const int32_t cell : order) {
        const Vec2 p((cell % nx + 0.5) * step - half.x(), (cell / nx + 0.5) * step - half.y());
        const double distance = kDistancePerSize * size(p);
        const Vec2 margin = half - p.cwiseAbs();
        if (margin.minCoeff() < 0.5 * distance || grid.anything_within(p, distance)) continue;
        points.push_back(on_grid(p));
        grid.add(points.back());
    }
}

// Every free point moves to the mean of the centroids around it, each weighted by its area in units
// of the local size. Centroids of triangles cannot leave the rectangle.
void smooth(PlanarMesh& mesh, size_t fixed, const SizeField& size) {
    std::vector<Vec2> sum(mesh.points.size(), Vec2::Zero());
    std::vector<double> weight(mesh.points.size(), 0);
    for (const auto& t : mesh.triangles) {
        const Vec2 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const Vec2 centroid = (a + b + c) / 3, e = b - a, f = c - a;
        const double h = size(centroid), w = (e.x() * f.y() - e.y() * f.x()) / (h * h);
        for (const int32_t v : t) {
            sum[v] += w * centroid;
            weight[v] += w;
        }
    }
    for (size_t v = fixed; v < mesh.points.size(); ++v) {
        mesh.points[v] = on_grid(sum[v] / weight[v]);
    }
    mesh.triangles = delaunay(mesh.points);
}

}  // namespace

std::vector<Vec2> divided(std::span<const Vec2> polyline, bool closed, const SizeField& size) {
    const size_t count = polyline.size(), segments = closed ? count : count - 1;
    // Short pieces, so that the size may be taken as constant on each.
    std::vector<Vec2> fine;
    for (size_t s = 0; s < segments; ++s) {
        const Vec2 &a = polyline[s], &b = polyline[(s + 1) % count];
        const int pieces = 1 + static_cast<int>((b - a).norm() / (0.25 * size((a + b) / 2)));
        for (int i = 0; i < pieces; ++i) fine.push_back(a + (b - a) * i / pieces);
    }
    fine.push_back(closed ? polyline.front() : polyline.back());
    std::vector<double> along(fine.size(), 0);
    for (size_t i = 1; i < fine.size(); ++i) {
        along[i] =
            along[i - 1] + (fine[i] - fine[i - 1]).norm() / size((fine[i] + fine[i - 1]) / 2);
    }
    const int parts = std::max(closed ? 12 : 1, static_cast<int>(std::lround(along.back())));
    std::vector<Vec2> out;
    size_t at = 0;
    for (int i = 0; i < (closed ? parts : parts + 1); ++i) {
        const double wanted = along.back() * i / parts;
        while (at + 2 < fine.size() && along[at + 1] < wanted) ++at;
        const double share = (wanted - along[at]) / (along[at + 1] - along[at]);
        out.push_back(fine[at] + std::clamp(share, 0.0, 1.0) * (fine[at + 1] - fine[at]));
    }
    return out;
}

PlanarMesh graded_mesh(const Vec2& half, std::span<const std::vector<Vec2>> curves,
                       const SizeField& size, uint64_t seed, int most_triangles,
                       std::span<const Vec2> kept) {
    const SizeSurvey found = survey(half, size);
    if (found.triangles > most_triangles) {
        throw MeshError(
            "edges this short would need about " + std::to_string(std::llround(found.triangles)) +
            " triangles in the plane, allowed at most " + std::to_string(most_triangles));
    }
    PlanarMesh mesh;
    mesh.points = fixed_points(half, curves, kept, size);
    const size_t fixed = mesh.points.size();
    fill(mesh.points, half, size, found.smallest_m, seed);
    mesh.triangles = delaunay(mesh.points);
    for (int round = 0; round < kSmoothingRounds; ++round) smooth(mesh, fixed, size);
    return mesh;
}

}  // namespace placode::sim
