// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tissue_mesh.h"

#include <gtest/gtest.h>

#include "picture_fixture.h"

using namespace placode::sim;
using namespace placode::view;

namespace THIS_TEST {

TEST(TissueMesh, GivesFreshWallsTheirOwnVertices) {
    SmallField f = small_field();
    TissueMesh mesh(f.view);
    EXPECT_TRUE(mesh.update(f.snapshot));
    const size_t before = mesh.vertices().size();
    EXPECT_FALSE(mesh.update(f.snapshot));
    f.snapshot.triangles[100].fresh = 1;
    f.snapshot.surface_version = 2;
    EXPECT_TRUE(mesh.update(f.snapshot));
    EXPECT_EQ(mesh.vertices().size(), before + 3 * kTissueVertexFloats);
    // Its normals still point outwards.
    for (size_t c = 0; c < mesh.vertices().size(); c += kTissueVertexFloats) {
        EXPECT_GT(mesh.vertices()[c + 5], 0.5F);
    }
}

}  // namespace THIS_TEST
