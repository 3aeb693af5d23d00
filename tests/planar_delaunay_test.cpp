// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/anatomy/planar_delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "sim/mesh/mesh.h"

namespace placode::sim {
namespace THIS_TEST {

std::vector<Vec2> corners(double half) {
    return {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)};
}

double doubled_area(const std::vector<Vec2>& p, const std::array<int32_t, 3>& t) {
    const Vec2 e = p[t[1]] - p[t[0]], f = p[t[2]] - p[t[0]];
    return e.x() * f.y() - e.y() * f.x();
}

// Every point in use, all triangles counter-clockwise, the rectangle covered once.
void expect_triangulation(const std::vector<Vec2>& points,
                          const std::vector<std::array<int32_t, 3>>& triangles, double area) {
    std::vector<int> used(points.size(), 0);
    std::map<std::pair<int, int>, int> edges;
    double sum = 0;
    for (const auto& t : triangles) {
        EXPECT_GT(doubled_area(points, t), 0);
        sum += doubled_area(points, t) / 2;
        for (int i = 0; i < 3; ++i) {
            used[t[i]] = 1;
            EXPECT_EQ(++edges[std::pair(t[i], t[(i + 1) % 3])], 1) << "an edge used twice";
        }
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
    EXPECT_NEAR(sum, area, 1e-9 * area);  // rounding of the sum
}

// No point strictly inside of any circumcircle, up to the rounding of this double computation.
void expect_empty_circles(const std::vector<Vec2>& points,
                          const std::vector<std::array<int32_t, 3>>& triangles) {
    for (const auto& t : triangles) {
        const Vec2 b = points[t[1]] - points[t[0]], c = points[t[2]] - points[t[0]];
        const double d = 2 * (b.x() * c.y() - b.y() * c.x());
        const Vec2 centre((c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / d,
                          (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / d);
        const double radius = centre.norm();
        for (const Vec2& p : points) {
            EXPECT_GT((p - points[t[0]] - centre).norm(), radius * (1 - 1e-6));
        }
    }
}

TEST(PlanarDelaunay, LeavesEveryCircumcircleEmpty) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(-0.0099, 0.0099);
    std::vector<Vec2> points = corners(0.01);
    for (int i = 0; i < 300; ++i) points.push_back(on_grid(Vec2(place(random), place(random))));
    const auto triangles = delaunay(points);
    expect_triangulation(points, triangles, 4e-4);
    // Euler: 2 n - 2 - hull.
    EXPECT_EQ(triangles.size(), 2 * points.size() - 2 - 4);
    expect_empty_circles(points, triangles);
}

TEST(PlanarDelaunay, SurvivesALatticeWhereAllCirclesTie) {
    // Four points of every cell are cocircular, and many lie on the sides of the rectangle.
    std::vector<Vec2> points = corners(0.005);
    for (int i = 0; i <= 10; ++i) {
        for (int j = 0; j <= 10; ++j) {
            if (i % 10 == 0 && j % 10 == 0) continue;
            points.push_back(on_grid(Vec2(0.001 * i - 0.005, 0.001 * j - 0.005)));
        }
    }
    std::shuffle(points.begin() + 4, points.end(), std::mt19937_64(5));
    const auto triangles = delaunay(points);
    expect_triangulation(points, triangles, 1e-4);
    EXPECT_EQ(triangles.size(), 200u);
}

TEST(PlanarDelaunay, RefusesPointsThatCoincideOrLieOutside) {
    std::vector<Vec2> points = corners(0.005);
    points.emplace_back(0.001, 0.001);
    points.emplace_back(0.001, 0.001);
    EXPECT_THROW((void)delaunay(points), MeshError);
    points.back() = Vec2(0.006, 0);
    EXPECT_THROW((void)delaunay(points), MeshError);
}

TEST(PlanarDelaunay, DividesALineInUnitsOfTheSizeField) {
    // Edge length 1 mm on the left, 2 mm on the right half: 10 + 5 pieces.
    const std::vector<Vec2> line{Vec2(-0.01, 0), Vec2(0.01, 0)};
    const auto points =
        divided(line, false, [](const Vec2& p) { return p.x() < 0 ? 0.001 : 0.002; });
    ASSERT_EQ(points.size(), 16u);
    EXPECT_NEAR(points.front().x(), -0.01, 1e-12);
    EXPECT_NEAR(points.back().x(), 0.01, 1e-12);
    // The piece that holds the jump is measured with one size: 0.25 edges in 10.
    EXPECT_NEAR(points[1].x() - points[0].x(), 0.001, 0.000025);
    EXPECT_NEAR(points[15].x() - points[14].x(), 0.002, 0.00005);
}

TEST(PlanarDelaunay, GradedMeshFollowsSizeAndKeepsItsAnglesWide) {
    const auto size = [](const Vec2& p) { return 0.0005 + 0.2 * p.norm(); };
    const PlanarMesh mesh = graded_mesh(Vec2(0.01, 0.008), {}, size, 1, 10000);
    expect_triangulation(mesh.points, mesh.triangles, 4 * 0.01 * 0.008);
    double least_angle = 180, log_ratio = 0;
    int edges = 0;
    for (const auto& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const Vec2 p = mesh.points[t[i]], e = mesh.points[t[(i + 1) % 3]] - p,
                       f = mesh.points[t[(i + 2) % 3]] - p;
            least_angle = std::min(least_angle,
                                   std::acos(e.dot(f) / (e.norm() * f.norm())) * 180 / 3.14159265);
            log_ratio += std::log(e.norm() / size(p + e / 2));
            ++edges;
        }
    }
    // Smoothed meshes of this kind stay above 20 degrees; 12 leaves room for another seed.
    EXPECT_GT(least_angle, 12);
    // Edges come out about 1.1 sizes long, see graded_mesh.cpp.
    EXPECT_NEAR(std::exp(log_ratio / edges), 1.1, 0.1);
}

TEST(PlanarDelaunay, GradedMeshKeepsPointsAlongItsCurves) {
    std::vector<Vec2> circle;
    for (int i = 0; i < 200; ++i) {
        circle.emplace_back(0.004 * std::cos(i * 0.0314159265), 0.004 * std::sin(i * 0.0314159265));
    }
    const std::vector<std::vector<Vec2>> curves{circle};
    const PlanarMesh mesh = graded_mesh(
        Vec2(0.01, 0.008), curves, [](const Vec2&) { return 0.0008; }, 1, 10000);
    const auto on_circle = std::count_if(mesh.points.begin(), mesh.points.end(), [](const Vec2& p) {
        return std::abs(p.norm() - 0.004) < 2e-6;
    });
    EXPECT_EQ(on_circle, 31);  // 2 pi 4 mm / 0.8 mm
}

TEST(PlanarDelaunay, GradedMeshRefusesEndlessWork) {
    EXPECT_THROW((void)graded_mesh(
                     Vec2(0.01, 0.01), {}, [](const Vec2&) { return 1e-5; }, 1, 10000),
                 MeshError);
}

}  // namespace THIS_TEST
}  // namespace placode::sim
