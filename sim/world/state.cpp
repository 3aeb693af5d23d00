// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What an attempt starts with.

#include <algorithm>

#include "sim/world/cut_columns.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kVaporisedPerStep = 64;
constexpr double kFoldApart = 2;     // of the longest edge: neighbours of a patch do not meet
constexpr size_t kFoldCells = 2048;  // of space, by a hash; a power of two

}  // namespace

PatchScratch::PatchScratch(const Scene& scene) {
    if (!scene.patch) return;
    const Patch& patch = *scene.patch;
    const auto& rest = scene.body.mesh().rest;
    ties.resize(static_cast<size_t>(patch.vertex_count));
    folds.assign(ties.size(), {-1, -1});
    cell_start.assign(kFoldCells + 1, 0);
    cell_triangle.assign(patch.triangles.size(), -1);
    cell_of.assign(patch.triangles.size(), -1);
    double longest_m = patch.thickness_m;
    for (const SurfaceTriangle& t : patch.triangles) {
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : t.vertex) sum += rest[static_cast<size_t>(v)];
        rest_centre.emplace_back(sum / 3);
        for (size_t k = 0; k < 3; ++k) {
            longest_m = std::max(longest_m, (rest[static_cast<size_t>(t.vertex[k])] -
                                             rest[static_cast<size_t>(t.vertex[(k + 1) % 3])])
                                                .norm());
        }
    }
    apart_m = kFoldApart * longest_m;
}

FreePieces::FreePieces(const Scene& scene) {
    if (scene.body.spec().spare_vertices == 0) return;
    vertex.assign(static_cast<size_t>(scene.body.vertex_capacity()), -1);
    found = vertex;
    of.assign(vertex.size(), -1);
}

void FreePieces::forget() noexcept {
    std::fill(of.begin(), of.end(), int8_t{-1});
    found_count = 0;
    any = false;
}

State::Scratch::Scratch(const Scene& scene, CutProgress* untouched)
    : contacts(scene),
      vaporised(kVaporisedPerStep),
      candidates(scene.body.vertex_count()),
      placode_volume_m3(scene.body.vertex_count(), 0.0f),
      pieces(scene),
      free_pieces(scene),
      patch(scene),
      sac_thirds(scene.sac.triangles.size()),
      sector_stack(scene.body.tet_count()),
      tet_seen(scene.body.tet_count(), 0),
      near_blade(scene.body.spec().spare_vertices > 0 ? scene.body.vertex_capacity() : 0, 0),
      pool(scene.irrigation ? scene.irrigation->grid.cells() : 0) {
    if (scene.suture) suture.emplace_back(scene.body, *scene.suture);
    choices.reserve(scene.body.spec().spare_vertices > 0 ? kMostChoices : 0);
    CutProgress nobodys;
    cut = make_cut_tables(scene, untouched != nullptr ? *untouched : nobodys);
    const TetMesh& mesh = scene.body.mesh();
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        for (int i = 1; i < 4; ++i) {
            const Vec3 edge = mesh.rest[mesh.tets[t][i]] - mesh.rest[mesh.tets[t][i - 1]];
            longest_edge_m = std::max(longest_edge_m, edge.norm());
        }
        if (mesh.tissue[t] != Tissue::kPlacode) continue;
        for (const int32_t v : mesh.tets[t]) placode_volume_m3[v] += scene.body.volume_m3()[t] / 4;
    }
}

void State::Scratch::forget() noexcept {
    std::fill(contacts.slot.begin(), contacts.slot.end(), -1);
    std::fill(contacts.hessian_frame.begin(), contacts.hessian_frame.end(), -1);
    std::fill(contacts.feature.begin(), contacts.feature.end(), 0);
    contacts.near.fill(0);
    contacts.candidate_count = contacts.contact_count = contacts.vertex_count = 0;
    contacts.feature_count = contacts.most_contacts = 0;
    for (PieceSearch::Path& path : pieces.path) path.count = 0;
    free_pieces.forget();
    for (SutureScratch& lists : suture) lists.forget();
    tip_triangle.fill(-1);
    heat_stepped = false;
    pool.clear();
}

State::State(const Scene& scene, int threads)
    : substeps(scene.body.spec().solver.substeps),
      body(scene.body),
      sleep(scene.body),
      surface(scene.surface, scene.body.mesh(), scene.body.spec().spare_vertices > 0),
      self_contact(scene),
      suturing(scene),
      held_by(scene.body.vertex_capacity(), -1),
      separation(scene),
      ledger(scene),
      gone_by_heat(scene.body.tet_count(), 0),
      friction(scene.body.vertex_capacity()),
      stretch_count(scene.body.tet_count(), 0),
      patch(scene),
      workers(std::make_unique<Workers>(threads)),
      scratch(std::make_unique<Scratch>(scene, &progress)),
      irrigation(scene),
      undermining(scene) {
    sleep.follow_leaves(surface.tree(), scene.body.mesh());
    for (auto& row : tool_side) row.fill(Vec3::Zero());
    colour.vertex.assign(kMostContactVertices, -1);
    flood.reached.assign(scene.body.tet_count(), 0);
    flood.stack.assign(scene.body.tet_count(), -1);
    pieces.of.assign(scene.body.tet_count(), -1);
    pieces.resting.assign(scene.body.vertex_capacity(), 0);
    pieces.searched = surface.version();
    release.checked.fill(~surface.version());  // every sector is looked at once before any cut
    resection.cut.assign(scene.resection.line.size(), 0);
    resection.checked.assign(scene.resection.line.size(), 0);
    for (size_t t = 0; t < scene.tools.size() && scene.cut_snap > 0; ++t) {
        if (scene.tools[t].kind == ToolKind::kScissors && body.topology)
            scissors[t].met_T.resize(scene.body.vertex_capacity());
    }
    if (scene.heat) {
        heat.emplace_back(*scene.heat, scene.body.vertex_count(), scene.body.tet_count());
    }
}

State::~State() = default;

}  // namespace placode::sim
