// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/wound_map.h"

#include <gtest/gtest.h>

#include <numbers>

#include "drawn_field.h"

namespace placode::view {
namespace THIS_TEST {

using namespace sim;
constexpr double kContour = 0.44;  // kRim of shaders/tissue.glsl
const Vec2 kLow(-24, -20), kHigh(24, 20);

// Length over that of the circle with the same mean radius; rms distance from it [mm].
struct Roughness {
    double length = 0, rms = 0, radius = 0;
};

Roughness roughness(const std::vector<Vec2>& line) {
    Roughness out;
    double length = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        length += (line[(i + 1) % line.size()] - line[i]).norm();
        out.radius += line[i].norm() / static_cast<double>(line.size());
    }
    for (const Vec2& p : line) out.rms += std::pow(p.norm() - out.radius, 2);
    out.rms = std::sqrt(out.rms / static_cast<double>(line.size()));
    out.length = length / (2 * std::numbers::pi * out.radius);
    return out;
}

// Where the share that is gone falls below the contour, outwards from the middle.
std::vector<Vec2> contour(const WoundMap& map) {
    std::vector<Vec2> line;
    for (int i = 0; i < 720; ++i) {
        const double a = 2 * std::numbers::pi * i / 720;
        const Vec2 ray(std::cos(a), std::sin(a));
        double r = 0;
        while (r < 10 && map.gone_at(r * ray) > kContour) r += 0.005;
        line.emplace_back(r * ray);
    }
    return line;
}

// The edge of the triangles that are left, in order around the middle.
std::vector<Vec2> edge_of_triangles(const DrawnField& field) {
    std::vector<std::pair<double, Vec2>> by_angle;
    for (const SurfaceTriangle& t : field.snapshot.triangles) {
        if (t.fresh == 0) continue;
        for (const int v : t.vertex) {
            if (v >= DrawnField::kNx * DrawnField::kNy) continue;
            const Vec2 p = field.rest_mm(v);
            by_angle.emplace_back(std::atan2(p.y(), p.x()), p);
        }
    }
    std::sort(by_angle.begin(), by_angle.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vec2> line;
    for (const auto& [angle, p] : by_angle)
        if (line.empty() || (line.back() - p).norm() > 1e-6) line.push_back(p);
    return line;
}

TEST(WoundMap, TheContourOfAHoleIsSmootherThanItsTriangles) {
    DrawnField field;
    WoundMap map(field.view, kLow, kHigh);
    EXPECT_GT(map.update(field.snapshot).width + 1, 0);
    EXPECT_DOUBLE_EQ(map.gone_at(Vec2(0, 0)), 0);
    field.cut([](const Vec2& p) { return p.norm() < 4; });
    EXPECT_GT(map.update(field.snapshot).width, 0);
    EXPECT_EQ(map.update(field.snapshot).width, 0) << "nothing changed";
    const Roughness drawn = roughness(contour(map)),
                    triangles = roughness(edge_of_triangles(field));
    EXPECT_NEAR(drawn.radius, 4, 0.15);
    EXPECT_GT(triangles.length, 1.10) << "or the field proves nothing";
    EXPECT_LT(drawn.length, 1.03);
    EXPECT_LT(drawn.rms, 0.5 * triangles.rms);
}

TEST(WoundMap, AKerfOfOneElementIsStillOneLine) {
    DrawnField field;
    WoundMap map(field.view, kLow, kHigh);
    field.cut([](const Vec2& p) { return std::abs(p.y()) < 0.33 && std::abs(p.x()) < 6; });
    static_cast<void>(map.update(field.snapshot));
    for (double x = -5; x <= 5; x += 0.05) {
        double most = 0;
        for (double y = -0.7; y < 0.7; y += 0.05) most = std::max(most, map.gone_at(Vec2(x, y)));
        EXPECT_GT(most, kContour) << x;
    }
    EXPECT_LT(map.gone_at(Vec2(0, 1.5)), 0.02);
}

TEST(WoundMap, WhatIsThereAgainIsDrawnAgain) {
    DrawnField field;
    WoundMap map(field.view, kLow, kHigh);
    const auto before = field.snapshot;
    field.cut([](const Vec2& p) { return p.norm() < 3; });
    static_cast<void>(map.update(field.snapshot));
    EXPECT_GT(map.gone_at(Vec2(0, 0)), 0.9);
    static_cast<void>(map.update(before));  // a replay went back
    EXPECT_DOUBLE_EQ(map.gone_at(Vec2(0, 0)), 0);
}

TEST(WoundMap, WhatIsOpenFromTheStartIsGoneInTheFirstPicture) {
    DrawnField field;
    for (auto* triangles : {&field.view.rest_triangles, &field.snapshot.triangles}) {
        for (SurfaceTriangle& t : *triangles) {
            Vec2 middle = Vec2::Zero();
            for (const int v : t.vertex) middle += field.rest_mm(v) / 3;
            t.fresh = middle.norm() < 3 ? 1 : 0;
        }
    }
    WoundMap map(field.view, kLow, kHigh);
    EXPECT_GT(map.update(field.snapshot).width, 0);
    EXPECT_GT(map.gone_at(Vec2(0, 0)), 0.9);
    EXPECT_DOUBLE_EQ(map.gone_at(Vec2(8, 0)), 0);
    const auto before = field.snapshot;
    field.cut([](const Vec2& p) { return (p - Vec2(8, 0)).norm() < 2; });
    static_cast<void>(map.update(field.snapshot));
    EXPECT_GT(map.gone_at(Vec2(8, 0)), 0.9);
    static_cast<void>(map.update(before));
    EXPECT_DOUBLE_EQ(map.gone_at(Vec2(8, 0)), 0);
    EXPECT_GT(map.gone_at(Vec2(0, 0)), 0.9) << "still open";
}

TEST(WoundMap, APieceOfTheMapIsTheSameAsTheWhole) {
    DrawnField field;
    WoundMap by_steps(field.view, kLow, kHigh), at_once(field.view, kLow, kHigh);
    for (const double r : {1.0, 2.0, 3.0, 5.0}) {
        field.cut([&](const Vec2& p) { return (p - Vec2(2, 1)).norm() < r; });
        static_cast<void>(by_steps.update(field.snapshot));
    }
    static_cast<void>(at_once.update(field.snapshot));
    EXPECT_EQ(by_steps.pixels(), at_once.pixels());
}

}  // namespace THIS_TEST
}  // namespace placode::view
