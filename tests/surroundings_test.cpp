// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/surroundings.h"

#include <gtest/gtest.h>

#include "drawn_field.h"
#include "ui/view/tissue_mesh.h"

namespace placode::view {
namespace THIS_TEST {

using namespace sim;

const float* row(const DrawnMesh& mesh, size_t i) {
    return &mesh.vertices[i * kTissueVertexFloats];
}
size_t rows(const DrawnMesh& mesh) { return mesh.vertices.size() / kTissueVertexFloats; }

TEST(Bed, LiesBesideAndBelowTheFieldAndFacesIt) {
    const DrawnField field;
    const Bed bed(field.view);
    // Every triangle of sides and bottom, none of the top.
    constexpr int nx = DrawnField::kNx - 1, ny = DrawnField::kNy - 1;
    EXPECT_EQ(bed.mesh().indices.size(), size_t{3} * 2 * (nx * ny + 2 * (nx + ny)));
    for (size_t i = 0; i < rows(bed.mesh()); ++i) {
        const float* r = row(bed.mesh(), i);
        const Eigen::Vector3f p(r[0], r[1], r[2]), n(r[3], r[4], r[5]);
        EXPECT_NEAR(n.norm(), 1, 1e-3);
        const bool side = std::abs(p.x()) > 19.9F || std::abs(p.y()) > 14.9F;
        EXPECT_GT(side ? -n.head<2>().dot(p.head<2>()) : n.z(), 0.5F) << p.transpose();
    }
}

TEST(Bed, YieldsWithWhatIsPressedAndDoesNotFollowWhatIsLifted) {
    DrawnField field;
    Bed bed(field.view);
    const DrawnMesh before = bed.mesh();
    for (auto& x : field.snapshot.x) x[2] += 0.003F;
    bed.follow(field.snapshot);
    EXPECT_EQ(bed.mesh().vertices, before.vertices);
    for (auto& x : field.snapshot.x) x[2] -= 0.004F;
    bed.follow(field.snapshot);
    for (size_t i = 0; i < rows(before); ++i)
        EXPECT_NEAR(row(bed.mesh(), i)[2], row(before, i)[2] - 1, 1e-3);
}

// Distance along a ray at which it meets a triangle, or -1. Source: Moeller & Trumbore 1997.
float meets(const Eigen::Vector3f& from, const Eigen::Vector3f& offset,
            const std::array<Eigen::Vector3f, 3>& p) {
    const Eigen::Vector3f e1 = p[1] - p[0], e2 = p[2] - p[0], h = offset.cross(e2);
    const float a = e1.dot(h);
    if (std::abs(a) < 1e-9F) return -1;
    const Eigen::Vector3f s = from - p[0], q = s.cross(e1);
    const float u = s.dot(h) / a, v = offset.dot(q) / a;
    constexpr float kSlack = 1e-4F;
    return u < -kSlack || v < -kSlack || u + v > 1 + kSlack ? -1 : e2.dot(q) / a;
}

bool hits(const std::vector<float>& vertices, const std::vector<unsigned>& indices,
          const Eigen::Vector3f& from, const Eigen::Vector3f& offset) {
    for (size_t k = 0; k + 2 < indices.size(); k += 3) {
        std::array<Eigen::Vector3f, 3> p;
        for (size_t e = 0; e < 3; ++e)
            p[e] = Eigen::Map<const Eigen::Vector3f>(
                &vertices[static_cast<size_t>(indices[k + e]) * kTissueVertexFloats]);
        if (meets(from, offset, p) > 0) return true;
    }
    return false;
}

// Holes through everything, in the middle and through each side of the field: whichever way one
// looks into them, there is tissue.
TEST(Bed, NothingBehindTheSceneIsSeenThroughAHole) {
    int without = 0;
    for (const Vec2& hole : {Vec2(0, 0), Vec2(19, 2), Vec2(-19, -2), Vec2(3, 14), Vec2(2, -14)}) {
        DrawnField field;
        field.cut([&](const Vec2& p) { return (p - hole).norm() < 2.5; });
        TissueMesh mesh(field.view);
        mesh.set_fine(true);
        static_cast<void>(mesh.update(field.snapshot));
        Bed bed(field.view);
        bed.choose(field.snapshot);
        bed.follow(field.snapshot);
        const DrawnMesh skirt = build_skirt(field.view);
        for (const Eigen::Vector3f& eye : {Eigen::Vector3f(-15, 0, 26), Eigen::Vector3f(0, 12, 30),
                                           Eigen::Vector3f(6, -15, 20)}) {
            for (int k = 0; k < 40; ++k) {
                const double r = 2.4 * std::sqrt((k + 0.5) / 40), a = 2.39996 * k;
                const Vec2 at = hole + r * Vec2(std::cos(a), std::sin(a));
                if (std::abs(at.x()) > 19.9 || std::abs(at.y()) > 14.9) continue;
                const double top = -at.y() * at.y() / 64 - at.x() * at.x() / 240;
                const Eigen::Vector3f offset =
                    Eigen::Vector3f(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                    static_cast<float>(top)) -
                    eye;
                const bool tissue = hits(mesh.vertices(), mesh.indices(), eye, offset) ||
                                    hits(skirt.vertices, skirt.indices, eye, offset);
                without += tissue ? 0 : 1;
                EXPECT_TRUE(tissue || hits(bed.mesh().vertices, bed.mesh().indices, eye, offset))
                    << hole.transpose() << " at " << at.transpose() << " from " << eye.transpose();
            }
        }
    }
    EXPECT_GT(without, 100) << "the holes show nothing of what lies behind";
}

TEST(Bed, IsDrawnBelowWhatWasCutOnly) {
    DrawnField field;
    Bed bed(field.view);
    const size_t all = bed.mesh().indices.size();
    bed.choose(field.snapshot);
    EXPECT_TRUE(bed.mesh().indices.empty());
    field.cut([](const Vec2& p) { return (p - Vec2(5, 0)).norm() < 2; });
    bed.choose(field.snapshot);
    EXPECT_LT(bed.mesh().indices.size(), all / 4);
    size_t below = 0;  // corners of its bottom right below the hole
    for (const unsigned i : bed.mesh().indices) {
        const float* r = row(bed.mesh(), i);
        below += std::hypot(r[0] - 5, r[1]) < 2 ? 1 : 0;
    }
    EXPECT_GT(below, 100U);
}

TEST(Floor, ReachesOnBelowTheSkin) {
    CanalFloor floor;
    floor.cell_m = 0.00025;
    floor.columns = floor.rows = 41;
    floor.x_m = floor.y_m = -0.005;
    double edge_m = 0;
    for (int j = 0; j < floor.rows; ++j) {
        for (int i = 0; i < floor.columns; ++i) {
            const double r = std::hypot(floor.x_m + i * floor.cell_m, floor.y_m + j * floor.cell_m);
            const bool inside = r < 0.0045;
            floor.height_m.push_back(inside ? static_cast<float>(-0.003 + r * r * 20) : -1.0F);
            if (inside) edge_m = std::max(edge_m, r);
        }
    }
    const DrawnMesh mesh = build_floor(floor);
    // Around the canal's edge the floor is drawn in every direction, at about its height there.
    for (int k = 0; k < 90; ++k) {
        const double a = 2 * 3.14159265358979 * k / 90;
        const Eigen::Vector2f at(static_cast<float>(5.5 * std::cos(a)),
                                 static_cast<float>(5.5 * std::sin(a)));
        bool covered = false;
        for (size_t i = 0; i + 2 < mesh.indices.size() && !covered; i += 3) {
            float low = 1e9F, height = 0;
            for (size_t e = 0; e < 3; ++e) {
                const float* r = row(mesh, mesh.indices[i + e]);
                low = std::min(low, (Eigen::Vector2f(r[0], r[1]) - at).norm());
                height = r[2];
            }
            covered = low < 0.2F && height > -3.2F && height < -2.2F;
        }
        EXPECT_TRUE(covered) << k;
    }
    for (size_t i = 0; i < mesh.vertices.size(); ++i) ASSERT_TRUE(std::isfinite(mesh.vertices[i]));
    EXPECT_TRUE(build_floor({}).indices.empty());
}

TEST(Skirt, ClosesTheFourSidesOfTheField) {
    const DrawnField field;
    const DrawnMesh skirt = build_skirt(field.view);
    EXPECT_EQ(skirt.indices.size() % 6, 0U);
    EXPECT_GT(skirt.indices.size(), 1000U);
}

}  // namespace THIS_TEST
}  // namespace placode::view
