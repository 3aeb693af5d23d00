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

}  // namespace THIS_TEST
}  // namespace placode::view
