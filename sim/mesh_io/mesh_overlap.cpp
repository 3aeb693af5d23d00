// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh_io/mesh_overlap.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "sim/core/as_index.h"
#include "sim/core/bounds.h"

namespace placode::sim {
namespace {

constexpr double kInside = 1e-6;  // barycentric: on a face or nearly so is not inside
// Of the point that stands for a tet: near its middle, but on none of the planes that regular
// meshes have there.
constexpr std::array<double, 4> kNearMiddle{0.31, 0.27, 0.23, 0.19};

/// Points in the cells of a regular grid over their box, some two in each.
class PointGrid {
 public:
    explicit PointGrid(const std::vector<Vec3>& points) {
        const Eigen::AlignedBox3d box = bounds_of(points);
        low_ = box.min();
        const Vec3 size = box.sizes().cwiseMax(1e-9 * box.sizes().maxCoeff());
        const double cell = std::cbrt(2 * size.prod() / static_cast<double>(points.size()));
        for (int a = 0; a < 3; ++a)
            cells_[as_index(a)] = std::clamp<int64_t>(std::llround(size[a] / cell), 1, 1024);
        step_ = Vec3(size.x() / static_cast<double>(cells_[0]),
                     size.y() / static_cast<double>(cells_[1]),
                     size.z() / static_cast<double>(cells_[2]));
        start_.assign(as_index(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
        for (const Vec3& p : points) ++start_[as_index(number_of(cell_of(p))) + 1];
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        std::vector<int32_t> fill(start_.begin(), start_.end() - 1);
        inside_.resize(points.size());
        for (size_t i = 0; i < points.size(); ++i)
            inside_[as_index(fill[as_index(number_of(cell_of(points[i])))]++)] =
                static_cast<int32_t>(i);
    }

    /// Calls `take` (index) for every point in the cells that a box meets.
    template <class Take>
    void in_box(const Vec3& low, const Vec3& high, Take&& take) const {
        const auto from = cell_of(low), to = cell_of(high);
        for (int64_t z = from[2]; z <= to[2]; ++z) {
            for (int64_t y = from[1]; y <= to[1]; ++y) {
                const int64_t first = number_of({from[0], y, z}), last = first + to[0] - from[0];
                for (int32_t i = start_[as_index(first)]; i < start_[as_index(last) + 1]; ++i)
                    take(inside_[as_index(i)]);
            }
        }
    }

 private:
    using Cell = std::array<int64_t, 3>;
    [[nodiscard]] Cell cell_of(const Vec3& p) const {
        Cell out{};
        for (int a = 0; a < 3; ++a) {
            const double c = std::floor((p[a] - low_[a]) / step_[a]);
            out[as_index(a)] = static_cast<int64_t>(
                std::clamp(c, 0.0, static_cast<double>(cells_[as_index(a)] - 1)));
        }
        return out;
    }
    [[nodiscard]] int64_t number_of(const Cell& c) const {
        return (c[2] * cells_[1] + c[1]) * cells_[0] + c[0];
    }

    Vec3 low_ = Vec3::Zero(), step_ = Vec3::Ones();
    std::array<int64_t, 3> cells_{1, 1, 1};
    std::vector<int32_t> start_, inside_;
};

class TetShape {
 public:
    TetShape(const FileMesh& file, const FileTet& tet)
        : origin_(file.points[as_index(tet.point[0])]) {
        low = high = origin_;
        Mat3 edges;
        for (size_t k = 1; k < 4; ++k) {
            const Vec3& p = file.points[as_index(tet.point[k])];
            edges.col(static_cast<Eigen::Index>(k) - 1) = p - origin_;
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        inverse_ = edges.inverse();
    }
    [[nodiscard]] bool holds(const Vec3& p) const {
        const Vec3 b = inverse_ * (p - origin_);
        return b.minCoeff() > kInside && b.sum() < 1 - kInside;
    }
    Vec3 low, high;

 private:
    Vec3 origin_;
    Mat3 inverse_;
};

/// Tets around the middle of another.
std::string tets_in_tets(const FileMesh& file, const std::vector<TetShape>& shapes) {
    std::vector<Vec3> middle;
    for (const FileTet& tet : file.tets) {
        Vec3 sum = Vec3::Zero();
        for (size_t k = 0; k < 4; ++k) sum += kNearMiddle[k] * file.points[as_index(tet.point[k])];
        middle.push_back(sum);
    }
    const PointGrid grid(middle);
    int64_t count = 0, first = -1, second = -1;
    for (size_t t = 0; t < shapes.size(); ++t) {
        grid.in_box(shapes[t].low, shapes[t].high, [&](int32_t i) {
            if (as_index(i) == t || !shapes[t].holds(middle[as_index(i)])) return;
            if (count++ > 0) return;
            first = file.tets[as_index(i)].id;
            second = file.tets[t].id;
        });
    }
    if (count == 0) return {};
    return std::to_string(count) +
           " tetrahedra have their middle inside another (the first: " + std::to_string(first) +
           " in " + std::to_string(second) +
           "): where they overlap weight and stiffness count twice";
}

/// Points that a tet has, ascending.
std::vector<int32_t> used_points(const FileMesh& file) {
    std::vector<int32_t> used;
    for (const FileTet& tet : file.tets)
        used.insert(used.end(), tet.point.begin(), tet.point.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
}

/// Tets around a point that is not their corner.
std::string points_in_tets(const FileMesh& file, const std::vector<TetShape>& shapes) {
    const std::vector<int32_t> used = used_points(file);
    std::vector<Vec3> place;
    for (const int32_t p : used) place.push_back(file.points[as_index(p)]);
    const PointGrid grid(place);
    int64_t count = 0, point = -1, tet = -1;
    for (size_t t = 0; t < shapes.size(); ++t) {
        grid.in_box(shapes[t].low, shapes[t].high, [&](int32_t i) {
            // A corner of its own has two barycentric coordinates of 0.
            if (!shapes[t].holds(place[as_index(i)]) || count++ > 0) return;
            point = file.point_id[as_index(used[as_index(i)])];
            tet = file.tets[t].id;
        });
    }
    if (count == 0) return {};
    return std::to_string(count) + " points lie inside a tetrahedron (the first: point " +
           std::to_string(point) + " in tetrahedron " + std::to_string(tet) +
           "): tetrahedra overlap there, weight and stiffness count twice";
}

/// Points of tets that have the place of another.
std::string points_on_points(const FileMesh& file) {
    std::vector<int32_t> used = used_points(file);
    const auto before = [&](int32_t a, int32_t b) {
        const Vec3 &p = file.points[as_index(a)], &q = file.points[as_index(b)];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::stable_sort(used.begin(), used.end(), before);
    int64_t count = 0;
    size_t first = 0;
    for (size_t i = 1; i < used.size(); ++i) {
        if (before(used[i - 1], used[i])) continue;
        if (count++ == 0) first = i;
    }
    if (count == 0) return {};
    return std::to_string(count) +
           " points lie on another and are not joined with it (the first: " +
           std::to_string(file.point_id[as_index(used[first])]) + " on " +
           std::to_string(file.point_id[as_index(used[first - 1])]) +
           "): the tissue is parted there";
}

}  // namespace

std::vector<std::string> overlap_warnings(const FileMesh& file) {
    std::vector<std::string> out;
    if (file.tets.empty()) return out;
    std::vector<TetShape> shapes;
    shapes.reserve(file.tets.size());
    for (const FileTet& tet : file.tets) shapes.emplace_back(file, tet);
    for (std::string& text : std::array{tets_in_tets(file, shapes), points_in_tets(file, shapes),
                                        points_on_points(file)}) {
        if (!text.empty()) out.push_back(std::move(text));
    }
    return out;
}

}  // namespace placode::sim
