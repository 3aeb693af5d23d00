// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes that hang together as they should, and overlap or gape all the same.
#include "sim/mesh_io/mesh_overlap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/verify/verification_scene.h"

using namespace placode::sim;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace THIS_TEST {

/// A box as a file would hold it; points and tets are numbered from 1.
FileMesh box_file(const Vec3& size, const std::array<int, 3>& cells) {
    const TetMesh box = box_mesh(size, cells);
    FileMesh out;
    out.points = box.rest;
    for (size_t p = 0; p < box.rest.size(); ++p)
        out.point_id.push_back(static_cast<int64_t>(p) + 1);
    for (size_t t = 0; t < box.tets.size(); ++t)
        out.tets.push_back({box.tets[t], static_cast<int64_t>(t) + 1, 0});
    return out;
}

TEST(MeshOverlap, SoundMeshesHaveNone) {
    EXPECT_THAT(overlap_warnings(box_file({1, 1, 1}, {1, 1, 1})), IsEmpty());
    EXPECT_THAT(overlap_warnings(box_file({0.04, 0.01, 0.01}, {8, 3, 3})), IsEmpty());
    // Cells of 1:1000, so that the grid of the search is not that of the mesh.
    FileMesh graded = box_file({1, 1, 1}, {10, 10, 10});
    for (Vec3& p : graded.points) p.x() = std::pow(p.x(), 3);
    EXPECT_THAT(overlap_warnings(graded), IsEmpty());
    FileMesh flat = box_file({1, 1, 1e-4}, {6, 6, 1});
    EXPECT_THAT(overlap_warnings(flat), IsEmpty());
    EXPECT_THAT(overlap_warnings(FileMesh{}), IsEmpty());
}

TEST(MeshOverlap, ATetInsideAFilledBoxIsNamed) {
    FileMesh mesh = box_file({1, 1, 1}, {1, 1, 1});
    // Between corners that the box has already, and with faces that none of its six tets has.
    mesh.tets.push_back({{1, 2, 4, 7}, 7, 0});
    EXPECT_THAT(overlap_warnings(mesh),
                ElementsAre(AllOf(HasSubstr("inside another (the first: "),
                                  HasSubstr("weight and stiffness count twice"))));
}

TEST(MeshOverlap, AMeshThatIsThereTwiceIsFoundEverywhere) {
    FileMesh mesh = box_file({1, 1, 1}, {3, 3, 3});
    const FileMesh again = mesh;
    const auto points = static_cast<int32_t>(mesh.points.size());
    for (size_t p = 0; p < again.points.size(); ++p) {
        mesh.points.push_back(again.points[p] + Vec3(0.01, 0.02, 0.03));
        mesh.point_id.push_back(static_cast<int64_t>(mesh.point_id.size()) + 1);
    }
    for (FileTet tet : again.tets) {
        for (int32_t& p : tet.point) p += points;
        tet.id += static_cast<int64_t>(again.tets.size());
        mesh.tets.push_back(tet);
    }
    const auto warnings = overlap_warnings(mesh);
    EXPECT_THAT(warnings, ::testing::Contains(HasSubstr("tetrahedra have their middle inside")));
    EXPECT_THAT(warnings, ::testing::Contains(HasSubstr("points lie inside a tetrahedron")));
}

TEST(MeshOverlap, PointsThatWereNotJoinedAreCounted) {
    // Two boxes side by side as two meshes: the four points between them are there twice.
    FileMesh mesh = box_file({1, 1, 1}, {1, 1, 1});
    const FileMesh again = mesh;
    for (const Vec3& p : again.points) {
        mesh.points.push_back(p + Vec3(1, 0, 0));
        mesh.point_id.push_back(static_cast<int64_t>(mesh.point_id.size()) + 1);
    }
    for (FileTet tet : again.tets) {
        for (int32_t& p : tet.point) p += 8;
        mesh.tets.push_back(tet);
    }
    EXPECT_THAT(overlap_warnings(mesh),
                ElementsAre(AllOf(HasSubstr("4 points lie on another"), HasSubstr("parted"))));
}

}  // namespace THIS_TEST
