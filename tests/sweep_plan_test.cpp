// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sweep_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/mesh/mesh.h"
#include "sim/solver/kernel_layout.h"

using namespace placode::sim;

namespace THIS_TEST {

TetMesh slab(int nx, int ny, int nz) {
    const TetMesh box = box_mesh(Vec3(nx, ny, nz) * 1e-3, {nx, ny, nz});
    return renumbered(box, rcm_order(box));
}

/// Vertices of all tets of job j.
std::set<int32_t> vertices_of_job(const TetMesh& mesh, const SweepPlan& plan, int32_t j) {
    std::set<int32_t> out;
    for (int32_t b = plan.job_start[static_cast<size_t>(j)];
         b < plan.job_start[static_cast<size_t>(j) + 1]; ++b) {
        for (const int32_t t : plan.batches[static_cast<size_t>(b)]) {
            const auto& tet = mesh.tets[static_cast<size_t>(t)];
            out.insert(tet.begin(), tet.end());
        }
    }
    return out;
}

TEST(SweepPlan, VisitsEveryTetOnceInBatchesThatShareNoVertex) {
    const TetMesh mesh = slab(20, 20, 3);
    const SweepPlan plan = plan_tets(mesh.tets, static_cast<int>(mesh.rest.size()), 2);
    std::vector<int> visits(mesh.tets.size(), 0);
    for (const auto& batch : plan.batches) {
        EXPECT_FALSE(batch.empty());
        EXPECT_LE(batch.size(), static_cast<size_t>(kLanes));
        std::set<int32_t> used;
        for (const int32_t t : batch) {
            ++visits[static_cast<size_t>(t)];
            for (const int32_t v : mesh.tets[static_cast<size_t>(t)]) {
                EXPECT_TRUE(used.insert(v).second) << "vertex " << v << " twice in a batch";
            }
        }
    }
    for (const int n : visits) EXPECT_EQ(n, 1);
    // Batches that are not full waste lanes: few of them.
    EXPECT_LT(plan.batches.size(), mesh.tets.size() / kLanes * 115 / 100);
}

TEST(SweepPlan, ABatchSeldomSharesVerticesWithTheOneBefore) {
    const TetMesh mesh = slab(60, 30, 4);
    const SweepPlan plan = plan_tets(mesh.tets, static_cast<int>(mesh.rest.size()), 4);
    std::set<int32_t> before;
    int waits = 0;
    ASSERT_EQ(plan.apart.size(), plan.batches.size());
    for (size_t b = 0; b < plan.batches.size(); ++b) {
        const auto& batch = plan.batches[b];
        std::set<int32_t> here;
        bool shares = false;
        for (const int32_t t : batch) {
            for (const int32_t v : mesh.tets[static_cast<size_t>(t)]) {
                shares = shares || before.count(v) > 0;
                here.insert(v);
            }
        }
        waits += shares ? 1 : 0;
        const bool begins =
            std::find(plan.job_start.begin(), plan.job_start.end(), b) != plan.job_start.end();
        EXPECT_TRUE(begins || (plan.apart[b] != 0) == !shares) << "batch " << b;
        before = std::move(here);
    }
    // In the order in which they fill, nearly all do; what is left are ends of jobs.
    EXPECT_LT(waits, std::ssize(plan.batches) / 20);
}

TEST(SweepPlan, JobsOfAPhaseTouchNothingInCommon) {
    const TetMesh mesh = slab(40, 20, 3);
    for (const int domains : {1, 2, 4, 8}) {
        const SweepPlan plan = plan_tets(mesh.tets, static_cast<int>(mesh.rest.size()), domains);
        ASSERT_EQ(plan.phase_start.front(), 0);
        ASSERT_EQ(static_cast<size_t>(plan.phase_start.back()) + 1, plan.job_start.size());
        EXPECT_EQ(plan.phase_start[1], domains) << "one job inside every domain";
        for (size_t p = 0; p + 1 < plan.phase_start.size(); ++p) {
            std::set<int32_t> used;
            size_t sum = 0;
            for (int32_t j = plan.phase_start[p]; j < plan.phase_start[p + 1]; ++j) {
                const auto vertices = vertices_of_job(mesh, plan, j);
                used.insert(vertices.begin(), vertices.end());
                sum += vertices.size();
            }
            EXPECT_EQ(used.size(), sum) << "phase " << p << " of " << domains << " domains";
        }
    }
}

TEST(SweepPlan, BadNumberingEndsInOneJobAtTheEndAndIsStillWhole) {
    // Tets across more than two domains, as a mesh without RCM order has them.
    std::vector<std::array<int32_t, 4>> tets;
    for (int32_t i = 0; i < 100; ++i) tets.push_back({i, 100 + i, 200 + i, 300 + i});
    const SweepPlan plan = plan_tets(tets, 400, 4);
    size_t n = 0;
    for (const auto& batch : plan.batches) n += batch.size();
    EXPECT_EQ(n, tets.size());
}

TEST(SweepPlan, DomainsGrowWithTheMesh) {
    EXPECT_EQ(domains_for(100), 1);
    EXPECT_EQ(domains_for(43200), 4);
    EXPECT_EQ(domains_for(640000), 8);
}

}  // namespace THIS_TEST
