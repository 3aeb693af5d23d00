// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/wound_refinement.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "drawn_field.h"
#include "ui/view/tissue_mesh.h"

namespace placode::view {
namespace THIS_TEST {

using namespace sim;
using Point = std::array<float, 3>;

Point place(const TissueMesh& mesh, unsigned index) {
    const float* row = &mesh.vertices()[static_cast<size_t>(index) * kTissueVertexFloats];
    return {row[0], row[1], row[2]};
}

// Edges of one triangle only, by the places of their ends.
int open_edges(const TissueMesh& mesh) {
    std::map<std::pair<Point, Point>, int> count;
    const auto& t = mesh.indices();
    for (size_t k = 0; k + 2 < t.size(); k += 3) {
        for (size_t e = 0; e < 3; ++e) {
            const Point a = place(mesh, t[k + e]), b = place(mesh, t[k + (e + 1) % 3]);
            ++count[{std::min(a, b), std::max(a, b)}];
        }
    }
    return static_cast<int>(std::count_if(count.begin(), count.end(),
                                          [](const auto& entry) { return entry.second == 1; }));
}

TEST(WoundRefinement, OpensNoGapAndKeepsWhatIsFarAway) {
    DrawnField field;
    field.cut([](const Vec2& p) { return p.norm() < 3; });
    TissueMesh coarse(field.view), fine(field.view);
    fine.set_fine(true);
    static_cast<void>(coarse.update(field.snapshot));
    static_cast<void>(fine.update(field.snapshot));
    EXPECT_GT(fine.indices().size(), coarse.indices().size());
    EXPECT_LT(fine.indices().size(), 2 * coarse.indices().size());
    constexpr int kAround = 2 * (DrawnField::kNx - 1 + DrawnField::kNy - 1);
    const int bottom = open_edges(coarse) - kAround;  // of the wall: nothing lies below it
    ASSERT_GT(bottom, 10);
    EXPECT_EQ(open_edges(fine), kAround + 2 * bottom);
}

TEST(WoundRefinement, TheRimIsACurveAndNotAPolygon) {
    DrawnField field;
    field.cut([](const Vec2& p) { return p.norm() < 4; });
    const auto sharpest = [&](bool fine) {
        TissueMesh mesh(field.view);
        mesh.set_fine(fine);
        static_cast<void>(mesh.update(field.snapshot));
        // Neighbours along the rim: edges between skin (fresh < 1) and wall (fresh = 1).
        std::map<std::pair<Point, Point>, int> sides;
        const auto& t = mesh.indices();
        for (size_t k = 0; k + 2 < t.size(); k += 3) {
            float most = 0;
            for (size_t e = 0; e < 3; ++e)
                most = std::max(most, mesh.vertices()[size_t{t[k + e]} * kTissueVertexFloats + 15]);
            for (size_t e = 0; e < 3; ++e) {
                const Point a = place(mesh, t[k + e]), b = place(mesh, t[k + (e + 1) % 3]);
                sides[{std::min(a, b), std::max(a, b)}] |= most > 0.99F ? 2 : 1;
            }
        }
        std::map<Point, std::vector<Point>> next;
        for (const auto& [edge, side] : sides) {
            if (side != 3) continue;
            next[edge.first].push_back(edge.second);
            next[edge.second].push_back(edge.first);
        }
        double most = 0;
        int count = 0;
        for (const auto& [at, ends] : next) {
            if (ends.size() != 2) continue;
            const auto direction = [&](const Point& from, const Point& to) {
                return Vec3(to[0] - from[0], to[1] - from[1], to[2] - from[2]).normalized();
            };
            const double turn = std::acos(
                std::clamp(direction(ends[0], at).dot(direction(at, ends[1])), -1.0, 1.0));
            most = std::max(most, turn);
            ++count;
        }
        EXPECT_GT(count, 20);
        return most;
    };
    const double polygon = sharpest(false), curve = sharpest(true);
    EXPECT_LT(curve, 0.75 * polygon) << polygon;
}

// What the eye sees of a hole is as wide as the hole, also of a small one.
TEST(WoundSmoothing, DoesNotCloseSmallHoles) {
    for (const double radius : {1.2, 2.0, 4.0}) {
        DrawnField field;
        field.cut([&](const Vec2& p) { return p.norm() < radius; });
        TissueMesh mesh(field.view);
        static_cast<void>(mesh.update(field.snapshot));
        double before = 0, seen = 0;
        int count = 0;
        for (size_t c = 0; c < mesh.vertices().size(); c += kTissueVertexFloats) {
            const float* row = &mesh.vertices()[c];
            const bool rim = row[15] > 0.5F && row[15] < 0.7F;
            if (!rim) continue;
            seen += std::hypot(row[0], row[1]);
            ++count;
        }
        for (const SurfaceTriangle& t : field.snapshot.triangles) {
            for (const int v : t.vertex)
                if (t.fresh != 0 && v < DrawnField::kNx * DrawnField::kNy)
                    before = std::max(before, field.rest_mm(v).norm());
        }
        ASSERT_GT(count, 6);
        EXPECT_GT(seen / count, 0.80 * before) << radius;
        EXPECT_LT(seen / count, before) << radius;
    }
}

TEST(TissueMesh, StaysFiniteWhateverIsTakenOut) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> x(-20, 20), y(-15, 15), r(0.2, 4);
    DrawnField field;
    TissueMesh mesh(field.view);
    mesh.set_fine(true);
    for (int cut = 0; cut < 40; ++cut) {
        const Vec2 at(x(random), y(random));
        const double radius = r(random);
        field.cut([&](const Vec2& p) { return (p - at).norm() < radius; });
        static_cast<void>(mesh.update(field.snapshot));
        const size_t rows = mesh.vertices().size() / kTissueVertexFloats;
        for (const unsigned i : mesh.indices()) ASSERT_LT(i, rows);
        for (size_t i = 0; i < rows; ++i) {
            const float* row = &mesh.vertices()[i * kTissueVertexFloats];
            for (int k = 0; k < kTissueVertexFloats; ++k) ASSERT_TRUE(std::isfinite(row[k])) << k;
            const Eigen::Vector3f n(row[3], row[4], row[5]);
            ASSERT_GT(n.norm(), 0.009F);
            ASSERT_LT(n.norm(), 1.001F);
        }
    }
}

// The eye's smoothing moves rest place and picture alike: a pattern may not be squeezed at the rim.
TEST(TissueMesh, ColoursStayOnTheTissueAtARim) {
    DrawnField field;
    field.cut([](const Vec2& p) { return p.norm() < 4; });
    TissueMesh mesh(field.view);
    static_cast<void>(mesh.update(field.snapshot));
    for (size_t c = 0; c < mesh.vertices().size(); c += kTissueVertexFloats) {
        const float* row = &mesh.vertices()[c];
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(row[k], row[6 + k], 1e-4);
    }
}

}  // namespace THIS_TEST
}  // namespace placode::view
