// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/planar_delaunay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

#include "sim/mesh/mesh.h"

namespace placode::sim {

namespace {

__extension__ using Int128 = __int128;

constexpr double kGridPerM = 1e9;

struct GridPoint {
    int64_t x = 0, y = 0;
};

GridPoint grid_point(const Vec2& p) {
    return {std::llround(p.x() * kGridPerM), std::llround(p.y() * kGridPerM)};
}

// Twice the signed area of a, b, c; exact: differences of coordinates have at most 30 bits.
int64_t orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether p lies strictly inside of the circle through the counter-clockwise a, b, c. Exact: lifted
// terms and cross products have at most 61 bits, the sum of three products 124.
bool in_circle(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& p) {
    const int64_t ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, cx = c.x - p.x,
                  cy = c.y - p.y;
    const Int128 lift_a = Int128(ax) * ax + Int128(ay) * ay;
    const Int128 lift_b = Int128(bx) * bx + Int128(by) * by;
    const Int128 lift_c = Int128(cx) * cx + Int128(cy) * cy;
    return lift_a * (Int128(bx) * cy - Int128(by) * cx) -
               lift_b * (Int128(ax) * cy - Int128(ay) * cx) +
               lift_c * (Int128(ax) * by - Int128(ay) * bx) >
           0;
}

struct Triangle {
    std::array<int32_t, 3> v{};  // counter-clockwise; v[0] = -1 marks a free slot
    std::array<int32_t, 3> n{};  // neighbour over the edge v[i] -> v[i + 1], -1 = side of rectangle
};

class Triangulation {
 public:
    explicit Triangulation(std::span<const Vec2> points)
        : fan_from_(points.size(), -1), fan_to_(points.size(), -1) {
        points_.reserve(points.size());
        for (const Vec2& p : points) points_.push_back(grid_point(p));
        triangles_.push_back({{0, 1, 2}, {-1, -1, 1}});
        triangles_.push_back({{0, 2, 3}, {0, -1, -1}});
        mark_.assign(2, -1);
    }

    void insert(int32_t p) {
        find_cavity(p, locate(p));
        fill_cavity(p);
    }

    [[nodiscard]] std::vector<std::array<int32_t, 3>> triangles() const {
        std::vector<std::array<int32_t, 3>> out;
        for (const Triangle& t : triangles_) {
            if (t.v[0] >= 0) out.push_back(t.v);
        }
        return out;
    }

 private:
    // Visibility walk: always ends in a Delaunay triangulation.
    [[nodiscard]] int32_t locate(int32_t p) const {
        int32_t t = last_;
        for (;;) {
            int32_t next = t;
            for (int e = 0; e < 3 && next == t; ++e) {
                const Triangle& tri = triangles_[t];
                if (orientation(points_[tri.v[e]], points_[tri.v[(e + 1) % 3]], points_[p]) < 0) {
                    next = tri.n[e];
                }
            }
            if (next == t) return t;
            if (next < 0) {
                throw MeshError("point " + std::to_string(p) +
                                " lies outside of the rectangle of the triangulation");
            }
            t = next;
        }
    }

    // All triangles whose circumcircle holds p: connected, and star-shaped as seen from p.
    void find_cavity(int32_t p, int32_t start) {
        for (const int32_t v : triangles_[start].v) {
            if (points_[v].x == points_[p].x && points_[v].y == points_[p].y) {
                throw MeshError("points " + std::to_string(v) + " and " + std::to_string(p) +
                                " of the triangulation coincide within 1 nm");
            }
        }
        cavity_.assign(1, start);
        border_.clear();
        mark_[start] = p;
        for (size_t i = 0; i < cavity_.size(); ++i) {
            const Triangle tri = triangles_[cavity_[i]];
            for (int e = 0; e < 3; ++e) {
                const int32_t other = tri.n[e];
                if (other >= 0 && mark_[other] == p) continue;
                if (other >= 0 && circle_holds(triangles_[other], p)) {
                    mark_[other] = p;
                    cavity_.push_back(other);
                } else {
                    border_.push_back({tri.v[e], tri.v[(e + 1) % 3], other});
                }
            }
        }
    }

    [[nodiscard]] bool circle_holds(const Triangle& t, int32_t p) const {
        return in_circle(points_[t.v[0]], points_[t.v[1]], points_[t.v[2]], points_[p]);
    }

    // Joins p to every border edge; an edge on a side of the rectangle through p is split instead.
    void fill_cavity(int32_t p) {
        for (const int32_t t : cavity_) triangles_[t].v[0] = -1;
        size_t reuse = 0;
        fan_.clear();
        for (const auto& [a, b, outer] : border_) {
            if (orientation(points_[a], points_[b], points_[p]) == 0) continue;
            int32_t t = static_cast<int32_t>(triangles_.size());
            if (reuse < cavity_.size()) {
                t = cavity_[reuse++];
            } else {
                triangles_.emplace_back();
                mark_.push_back(-1);
            }
            triangles_[t] = {{a, b, p}, {outer, -1, -1}};
            if (outer >= 0) {
                Triangle& o = triangles_[outer];
                for (int e = 0; e < 3; ++e) {
                    if (o.v[e] == b) o.n[e] = t;
                }
            }
            fan_from_[a] = t;
            fan_to_[b] = t;
            fan_.push_back(t);
        }
        for (const int32_t t : fan_) {
            triangles_[t].n[1] = fan_from_[triangles_[t].v[1]];
            triangles_[t].n[2] = fan_to_[triangles_[t].v[0]];
        }
        for (const auto& [a, b, outer] : border_) fan_from_[a] = fan_to_[b] = -1;
        last_ = fan_.front();
    }

    struct BorderEdge {
        int32_t a, b, outer;
    };
    std::vector<GridPoint> points_;
    std::vector<Triangle> triangles_;
    std::vector<int32_t> mark_;  // last point whose cavity the triangle was in
    std::vector<int32_t> fan_from_,
        fan_to_;  // by vertex: new triangle whose border edge starts/ends
    std::vector<int32_t> cavity_, fan_;
    std::vector<BorderEdge> border_;
    int32_t last_ = 0;
};

// Boustrophedon through about sqrt(n) strips, so that each walk is short.
std::vector<int32_t> insertion_order(std::span<const Vec2> points) {
    std::vector<int32_t> order(points.size() - 4);
    std::iota(order.begin(), order.end(), 4);
    const double strips = std::max(1.0, std::sqrt(static_cast<double>(points.size()) / 2));
    const double low = points[0].y(), height = points[2].y() - points[0].y();
    const auto strip = [&](int32_t i) {
        return static_cast<int>((points[i].y() - low) / height * strips);
    };
    std::sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
        const int sa = strip(a), sb = strip(b);
        if (sa != sb) return sa < sb;
        const double xa = points[a].x(), xb = points[b].x();
        if (xa != xb) return sa % 2 == 0 ? xa < xb : xa > xb;
        return a < b;
    });
    return order;
}

}  // namespace

Vec2 on_grid(const Vec2& p) {
    return {static_cast<double>(std::llround(p.x() * kGridPerM)) / kGridPerM,
            static_cast<double>(std::llround(p.y() * kGridPerM)) / kGridPerM};
}

std::vector<std::array<int32_t, 3>> delaunay(std::span<const Vec2> points) {
    assert(std::ranges::all_of(points, [](const Vec2& p) { return p.norm() < 0.5; }));
    if (points.size() < 4) throw MeshError("a triangulation needs its four corners first");
    Triangulation triangulation(points);
    for (const int32_t p : insertion_order(points)) triangulation.insert(p);
    return triangulation.triangles();
}

}  // namespace placode::sim
