// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The drawn patch: its vertices alone, with smooth normals and its places at rest.
#include "ui/view/patch_renderer.h"

#include <gtest/gtest.h>

#include "ui/view/tissue_mesh.h"
#include "ui/view/tool_renderer.h"

namespace placode::view {
namespace THIS_TEST {

constexpr size_t kRow = kTissueVertexFloats;

/// Two vertices of tissue, then a square of two triangles, bent by a right angle over its diagonal.
sim::Snapshot bent() {
    sim::Snapshot out;
    out.x = {{9, 9, 9}, {9, 9, 9}, {0, 0, 0}, {0.001F, 0, 0}, {0.001F, 0.001F, 0}, {0, 0.001F, 0}};
    out.patch = {{2, 3, 4}, {2, 4, 5}};
    return out;
}

TEST(PatchRenderer, DrawsNothingWithoutAPatch) {
    sim::Snapshot empty = bent();
    empty.patch.clear();
    PatchMesh mesh;
    mesh.build(empty, empty.x);
    EXPECT_TRUE(mesh.vertices.empty());
    EXPECT_TRUE(mesh.indices.empty());
}

TEST(PatchRenderer, TakesItsOwnVerticesInMillimetresWithTheirPlacesAtRest) {
    sim::Snapshot snapshot = bent();
    std::vector<std::array<float, 3>> rest = snapshot.x;
    rest[3] = {0.004F, 0.005F, 0};
    snapshot.x[5][2] = 0.001F;
    PatchMesh mesh;
    mesh.build(snapshot, rest);
    ASSERT_EQ(mesh.vertices.size(), 4 * kRow);
    EXPECT_EQ(mesh.indices, (std::vector<unsigned>{0, 1, 2, 0, 2, 3}));
    const float* second = mesh.vertices.data() + kRow;
    EXPECT_FLOAT_EQ(second[0], 1);
    EXPECT_FLOAT_EQ(second[5], 1) << "only in the flat triangle: its normal looks up";
    EXPECT_FLOAT_EQ(second[6], static_cast<float>(ToolMaterial::kPatch));
    EXPECT_FLOAT_EQ(second[7], 4);
    EXPECT_FLOAT_EQ(second[8], 5);
    const float* first = mesh.vertices.data();
    EXPECT_GT(first[3], 0.1F) << "of both triangles: it leans";
    EXPECT_NEAR(first[3] * first[3] + first[4] * first[4] + first[5] * first[5], 1, 1e-5);
}

TEST(PatchRenderer, KnowsWhereItsEdgeIs) {
    // A square of 4 x 4 vertices: four of them lie inside.
    sim::Snapshot flat;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            flat.x.push_back({0.001F * static_cast<float>(i), 0.001F * static_cast<float>(j), 0});
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const int a = 4 * j + i;
            flat.patch.push_back({a, a + 1, a + 5});
            flat.patch.push_back({a, a + 5, a + 4});
        }
    PatchMesh mesh;
    mesh.build(flat, flat.x);
    mesh.build(flat, flat.x);  // as in the next picture: what was found stays
    for (size_t v = 0; v < 16; ++v) {
        const bool inside = v == 5 || v == 6 || v == 9 || v == 10;
        EXPECT_EQ(mesh.vertices[v * kRow + 9], inside ? 0 : 1) << v;
    }
    // Two corners have a triangle whose vertices all lie at the edge: the middle of its inner side
    // lies half an edge inside.
    ASSERT_EQ(mesh.vertices.size(), 18 * kRow);
    EXPECT_EQ(mesh.indices.size(), 3 * (18 + 2 * 2));
    EXPECT_NEAR(mesh.vertices[16 * kRow + 0], 2.5, 1e-5) << "between 2 and 7";
    EXPECT_NEAR(mesh.vertices[16 * kRow + 1], 0.5, 1e-5);
    EXPECT_EQ(mesh.vertices[16 * kRow + 9], 0.5F);
    // It is the same square: no triangle is turned or lost.
    double area = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto at = [&](size_t k, size_t c) {
            return static_cast<double>(mesh.vertices[kRow * mesh.indices[i + k] + c]);
        };
        const double twice = (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
                             (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1));
        EXPECT_GT(twice, 0);
        area += 0.5 * twice;
    }
    EXPECT_NEAR(area, 9, 1e-5);
}

}  // namespace THIS_TEST
}  // namespace placode::view
