// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/vertex_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/solver/kernel_layout.h"

using namespace placode::sim;

namespace THIS_TEST {

TetMesh slab(int nx, int ny, int nz) {
    const TetMesh box = box_mesh(Vec3(nx, ny, nz) * 1e-3, {nx, ny, nz});
    return renumbered(box, rcm_order(box));
}

int phase_of(const VertexPlan& plan, int32_t job) {
    return static_cast<int>(
        std::upper_bound(plan.phase_start.begin(), plan.phase_start.end(), job) -
        plan.phase_start.begin());
}

/// No two vertices of a tet are solved at the same time: not in one phase by two jobs, and not in
/// one job in one colour.
void expect_sound(const TetMesh& mesh, const VertexPlan& plan, const std::vector<uint8_t>& skip) {
    for (size_t v = 0; v < skip.size(); ++v) {
        EXPECT_EQ(plan.job[v] < 0, skip[v] != 0) << "vertex " << v;
        EXPECT_EQ(plan.colour[v] < 0, skip[v] != 0) << "vertex " << v;
        EXPECT_LT(plan.job[v], plan.phase_start.back());
    }
    for (const auto& tet : mesh.tets) {
        for (const int32_t a : tet) {
            for (const int32_t b : tet) {
                const auto i = static_cast<size_t>(a), j = static_cast<size_t>(b);
                if (a >= b || skip[i] != 0 || skip[j] != 0) continue;
                if (plan.job[i] == plan.job[j]) {
                    ASSERT_NE(plan.colour[i], plan.colour[j]) << a << " and " << b;
                } else {
                    ASSERT_NE(phase_of(plan, plan.job[i]), phase_of(plan, plan.job[j]))
                        << a << " and " << b;
                }
            }
        }
    }
}

TEST(VertexPlan, WhatIsSolvedAtTheSameTimeIsIndependent) {
    const TetMesh mesh = slab(40, 20, 3);
    const std::vector<int32_t> work(mesh.rest.size(), 1);
    std::vector<uint8_t> skip(mesh.rest.size(), 0);
    for (size_t v = 0; v < skip.size(); v += 7) skip[v] = 1;
    for (const int domains : {1, 2, 4, 8}) {
        const VertexPlan plan = plan_vertices(mesh, skip, work, domains);
        EXPECT_EQ(plan.phase_start[1], domains) << "one job inside every domain";
        expect_sound(mesh, plan, skip);
    }
}

TEST(VertexPlan, DomainsGetEqualWorkAndSeparatorsAreThin) {
    const TetMesh mesh = slab(60, 30, 4);
    const std::vector<uint8_t> skip(mesh.rest.size(), 0);
    const std::vector<int32_t> work(mesh.rest.size(), 1);
    const VertexPlan plan = plan_vertices(mesh, skip, work, 4);
    ASSERT_EQ(plan.phase_start, (std::vector<int32_t>{0, 4, 7})) << "three separators, no rest";
    std::array<int, 7> members{};
    for (const int32_t job : plan.job) ++members[static_cast<size_t>(job)];
    const int total = static_cast<int>(mesh.rest.size());
    for (int d = 0; d < 4; ++d) EXPECT_NEAR(members[static_cast<size_t>(d)], total / 4, total / 40);
    // A level of the numbering is at most a cross-section and its neighbour's: 2 x 31 x 5.
    for (int s = 4; s < 7; ++s) EXPECT_LT(members[static_cast<size_t>(s)], 2 * 31 * 5);
}

TEST(VertexPlan, BadNumberingEndsInOneJobAtTheEndAndIsStillSound) {
    // Tets across all domains, as a mesh without RCM order has them: separators meet.
    TetMesh mesh;
    mesh.rest.resize(400, Vec3::Zero());
    for (int32_t i = 0; i < 100; ++i) {
        mesh.tets.push_back({i, 100 + i, 200 + i, 300 + i});
        mesh.tets.push_back({i, 100 + (i + 1) % 100, 200 + (i + 2) % 100, 300 + (i + 3) % 100});
    }
    const std::vector<uint8_t> skip(400, 0);
    const std::vector<int32_t> work(400, 1);
    const VertexPlan plan = plan_vertices(mesh, skip, work, 4);
    expect_sound(mesh, plan, skip);
    EXPECT_EQ(plan.phase_start.size(), 4U) << "a phase for what meets";
}

TEST(VertexPlan, AMeshThatIsLeftOutHasNoJobs) {
    const TetMesh mesh = slab(2, 2, 2);
    const std::vector<int32_t> work(mesh.rest.size(), 0);
    const VertexPlan plan = plan_vertices(mesh, std::vector<uint8_t>(mesh.rest.size(), 1), work, 1);
    EXPECT_EQ(plan.phase_start, std::vector<int32_t>{0});
}

}  // namespace THIS_TEST
