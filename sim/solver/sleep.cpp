// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/sleep.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/mesh/space_order.h"
#include "sim/mesh/surface_tree.h"
#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

constexpr int kBlock = 32;  // vertices
/// Compressed rows of the lists, sorted and each entry once.
void compress(std::vector<std::vector<int32_t>>& lists, std::vector<int32_t>& start,
              std::vector<int32_t>& entries) {
    for (auto& list : lists) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        start.push_back(static_cast<int32_t>(entries.size()));
        entries.insert(entries.end(), list.begin(), list.end());
    }
    start.push_back(static_cast<int32_t>(entries.size()));
}

/// (V) Block of each vertex; blocks() stands for those without one, -1 for what is fixed.
std::vector<int32_t> homes(const Sleep& sleep) {
    std::vector<int32_t> home = sleep.block;
    for (const int32_t v : sleep.unblocked) home[as_index(v)] = sleep.blocks();
    return home;
}

/// Vertices of a sheet that hangs on no tissue, ascending: it sleeps or wakes as a whole, in a
/// block of its own behind the others.
std::vector<int32_t> loose_sheet(const SoftBody& body) {
    std::vector<int32_t> out;
    if (!body.spec().sheet_material) return out;
    for (const SheetTriangle& t : body.spec().sheet)
        out.insert(out.end(), t.vertex.begin(), t.vertex.end());
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    const auto& fixed = body.spec().fixed;
    const bool hangs = std::any_of(out.begin(), out.end(), [&](int32_t v) {
        return !body.tets_of(v).empty() || std::find(fixed.begin(), fixed.end(), v) != fixed.end();
    });
    if (hangs || !body.packed().single_vertices.empty()) out.clear();
    return out;
}

}  // namespace

Sleep::Sleep(const SoftBody& body) {
    const SolverSettings& solver = body.spec().solver;
    const int vertices = body.vertex_count();
    vertex_asleep.assign(as_index(body.vertex_capacity()), 0);
    known_vertices = vertices;
    block.assign(as_index(vertices), -1);
    if (!solver.sleep || solver.method == Method::kXpbdPair) return;
    std::vector<uint8_t> fixed(as_index(vertices), 0);
    for (const int32_t v : body.spec().fixed) fixed[as_index(v)] = 1;
    const KernelLayout& packed = body.packed();
    const int32_t swept = packed.job_start.back();
    const std::vector<int32_t> loose = loose_sheet(body);
    std::vector<int32_t> order;
    for (int32_t v = 0; v < vertices; ++v) {
        if (packed.slot[as_index(v)] / kLanes < swept)
            order.push_back(v);
        else if (std::binary_search(loose.begin(), loose.end(), v))
            continue;
        else if (fixed[as_index(v)] == 0)
            unblocked.push_back(v);
    }
    const auto keys = hilbert_keys(body.mesh().rest);
    std::stable_sort(order.begin(), order.end(),
                     [&](int32_t a, int32_t b) { return keys[as_index(a)] < keys[as_index(b)]; });
    const int of_tissue = static_cast<int>(order.size() + kBlock - 1) / kBlock;
    const int count = of_tissue + (loose.empty() ? 0 : 1);
    member = order;
    for (size_t i = 0; i < order.size(); ++i)
        block[as_index(order[i])] = static_cast<int32_t>(i) / kBlock;
    std::vector<std::vector<int32_t>> around(as_index(count));
    for (int b = 0; b < of_tissue; ++b) {
        member_start.push_back(b * kBlock);
        const size_t end = std::min(order.size(), as_index(b + 1) * kBlock);
        for (size_t i = as_index(b) * kBlock; i < end; ++i) {
            for (const int32_t t : body.tets_of(order[i])) {
                for (const int32_t v : body.mesh().tets[as_index(t)]) {
                    if (block[as_index(v)] != b && fixed[as_index(v)] == 0)
                        around[as_index(b)].push_back(v);
                }
            }
        }
    }
    if (!loose.empty()) {
        member_start.push_back(static_cast<int32_t>(member.size()));
        member.insert(member.end(), loose.begin(), loose.end());
        for (const int32_t v : loose) block[as_index(v)] = of_tissue;
    }
    member_start.push_back(static_cast<int32_t>(member.size()));
    compress(around, border_start, border);
    for (std::vector<uint8_t>* flags : {&asleep, &calm, &restless, &near_awake})
        flags->assign(as_index(count), 0);
    since.resize(member.size());
    before.resize(border.size());
    chunk.resize((as_index(body.vertex_capacity()) + kChunk - 1) / kChunk);
    if (solver.method != Method::kVbd) list_tets(body);
}

void Sleep::list_tets(const SoftBody& body) {
    const KernelLayout& packed = body.packed();
    std::vector<std::vector<int32_t>> of(as_index(blocks() + 1));
    const std::vector<int32_t> home = homes(*this);
    for (int t = 0; t < body.tet_count(); ++t) {
        for (const int32_t v : body.mesh().tets[as_index(t)]) {
            if (home[as_index(v)] >= 0)
                of[as_index(home[as_index(v)])].push_back(packed.tet_slot[as_index(t)] / kLanes);
        }
    }
    compress(of, tets_start, tets);
    tets_move.assign(packed.tet_batches.size(), 0);
}

void Sleep::follow_leaves(const SurfaceTree& tree, const TetMesh& mesh) {
    if (!enabled()) return;
    std::vector<std::vector<int32_t>> in(as_index(tree.nodes()));
    const std::vector<int32_t> home = homes(*this);
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        auto& leaf = in[as_index(tree.leaf_of(static_cast<int>(t)))];
        for (const int32_t v : mesh.tets[t]) {
            if (home[as_index(v)] >= 0)
                leaf.push_back(home[as_index(v)]);  // what is fixed does not move
        }
    }
    compress(in, leaf_start, leaf_block);
    leaf_moves.assign(in.size(), 1);
}

}  // namespace placode::sim
