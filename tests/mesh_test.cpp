// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/mesh/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace placode::sim;

namespace THIS_TEST {

int bandwidth(const TetMesh& mesh) {
    int widest = 0;
    for (const auto& tet : mesh.tets) {
        const auto [lo, hi] = std::minmax_element(tet.begin(), tet.end());
        widest = std::max(widest, *hi - *lo);
    }
    return widest;
}

double total_volume(const TetMesh& mesh) {
    double sum = 0;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) sum += rest_volume(mesh, t);
    return sum;
}

std::string message_of(const TetMesh& mesh) {
    try {
        check_mesh(mesh);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "";
}

TEST(Mesh, BoxIsFilledExactlyAndConforms) {
    const TetMesh mesh = box_mesh(Vec3(3e-3, 2e-3, 1e-3), {3, 4, 5}, Tissue::kMuscle);
    EXPECT_EQ(mesh.rest.size(), 4u * 5u * 6u);
    EXPECT_EQ(mesh.tets.size(), 6u * 3u * 4u * 5u);
    EXPECT_EQ(mesh.tissue.front(), Tissue::kMuscle);
    EXPECT_NO_THROW(check_mesh(mesh));
    EXPECT_NEAR(total_volume(mesh), 6e-9, 6e-9 * 1e-12);
    // Conforming: every face belongs to two tets, or to one and lies on the boundary. A box of
    // nx, ny, nz cells has 4 (nx ny + ny nz + nz nx) boundary triangles.
    std::map<std::array<int32_t, 3>, int> faces;
    for (const auto& tet : mesh.tets) {
        for (size_t k = 0; k < 4; ++k) {
            std::array<int32_t, 3> face{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
            std::sort(face.begin(), face.end());
            ++faces[face];
        }
    }
    int boundary = 0;
    for (const auto& [face, count] : faces) {
        ASSERT_LE(count, 2);
        boundary += count == 1;
    }
    EXPECT_EQ(boundary, 4 * (3 * 4 + 4 * 5 + 5 * 3));
}

TEST(Mesh, QualityIsOneForTheRegularTetAndSmallForAFlatOne) {
    TetMesh mesh;
    mesh.rest = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
    mesh.tets = {{0, 1, 2, 3}};
    if (rest_volume(mesh, 0) < 0) std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    EXPECT_NEAR(tet_quality(mesh, 0), 1.0, 1e-12);
    mesh.rest = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.3, 0.3, 1e-3)};
    mesh.tets = {{0, 1, 2, 3}};
    EXPECT_GT(tet_quality(mesh, 0), 0.0);
    EXPECT_LT(tet_quality(mesh, 0), 0.01);
}

TEST(Mesh, ChecksNameTheElementThatIsWrong) {
    const TetMesh good = box_mesh(Vec3(1, 1, 1), {1, 1, 1});
    TetMesh mesh = good;
    mesh.tets[2][1] = 99;
    EXPECT_NE(message_of(mesh).find("tet 2: vertex index 99"), std::string::npos);
    mesh = good;
    std::swap(mesh.tets[3][0], mesh.tets[3][1]);
    EXPECT_NE(message_of(mesh).find("tet 3: volume"), std::string::npos);
    mesh = good;
    mesh.rest[5].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(message_of(mesh).find("vertex 5"), std::string::npos);
    mesh = good;
    mesh.rest.push_back(Vec3::Zero());
    EXPECT_NE(message_of(mesh).find("vertex 8 is used by no tet"), std::string::npos);
    mesh = good;
    mesh.tets.push_back({mesh.tets[1][1], mesh.tets[1][2], mesh.tets[1][0], mesh.tets[1][3]});
    mesh.tissue.push_back(Tissue::kSkin);
    EXPECT_NE(message_of(mesh).find("duplicates"), std::string::npos);
    mesh = good;
    mesh.tissue.pop_back();
    EXPECT_NE(message_of(mesh).find("tissue labels"), std::string::npos);
}

TEST(Mesh, DegeneracyDoesNotDependOnTheUnitSystem) {
    for (const double unit : {1e-3, 1.0, 1e3}) {
        TetMesh mesh = box_mesh(Vec3::Constant(1e-3 * unit), {1, 1, 1});
        EXPECT_NO_THROW(check_mesh(mesh)) << unit;
        // All but one tet of the cell hang on vertex 1 or 6; press the whole box flat.
        for (Vec3& p : mesh.rest) p.z() *= 1e-10;
        EXPECT_THROW(check_mesh(mesh), MeshError) << unit;
    }
}

TEST(Mesh, RcmNarrowsAScrambledMeshAndRenumberingKeepsTheShape) {
    const TetMesh box = box_mesh(Vec3(8, 3, 3), {16, 4, 4});
    std::vector<int32_t> scramble(box.rest.size());
    for (size_t i = 0; i < scramble.size(); ++i) scramble[i] = static_cast<int32_t>(i);
    std::mt19937 random(7);
    std::shuffle(scramble.begin(), scramble.end(), random);
    const TetMesh scrambled = renumbered(box, scramble);
    const std::vector<int32_t> order = rcm_order(scrambled);
    std::vector<int32_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<int32_t>(i));
    const TetMesh tidy = renumbered(scrambled, order);
    EXPECT_NO_THROW(check_mesh(tidy));
    EXPECT_NEAR(total_volume(tidy), total_volume(box), 1e-9);
    // A cross-section has 25 vertices; neighbours of a breadth-first level lie within two levels.
    EXPECT_LT(bandwidth(tidy), 110);
    EXPECT_GT(bandwidth(scrambled), 250);
    for (size_t t = 1; t < tidy.tets.size(); ++t) {
        EXPECT_LE(*std::min_element(tidy.tets[t - 1].begin(), tidy.tets[t - 1].end()),
                  *std::min_element(tidy.tets[t].begin(), tidy.tets[t].end()));
    }
    EXPECT_EQ(rcm_order(scrambled), order);
}

TEST(Mesh, RenumberingRefusesWhatIsNoPermutation) {
    const TetMesh box = box_mesh(Vec3(1, 1, 1), {1, 1, 1});
    EXPECT_THROW(static_cast<void>(renumbered(box, {0, 1, 2})), MeshError);
    EXPECT_THROW(static_cast<void>(renumbered(box, {0, 1, 2, 3, 4, 5, 6, 6})), MeshError);
}

}  // namespace THIS_TEST
