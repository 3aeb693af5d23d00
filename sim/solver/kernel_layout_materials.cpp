// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernels take from materials and tethers: weights of edges, damping, tethers of a vertex.

#include <vector>

#include "sim/core/as_index.h"
#include "sim/solver/kernel_layout_parts.h"

namespace placode::sim {
namespace {

/// The same mean with the sheet's mass; vertices without tets have no other.
void add_sheet_damping(const SoftBody& body, KernelLayout& packed) {
    std::vector<double> damping(as_index(body.vertex_count()), 0.0);
    for (int t = 0; t < body.tet_count(); ++t) {
        const auto& m =
            body.spec().materials[as_index(static_cast<int>(body.mesh().tissue[as_index(t)]))];
        for (const int32_t v : body.mesh().tets[as_index(t)])
            damping[as_index(v)] +=
                m.density_kg_m3 * body.volume_m3()[as_index(t)] / 4 * m.damping_per_s;
    }
    for (const SheetTriangle& t : body.spec().sheet) {
        const Material& m = material_of(body.spec(), t);
        const double mass = m.density_kg_m3 * area_of(body.mesh().rest, t) * t.thickness_m / 3;
        for (const int32_t v : t.vertex) damping[as_index(v)] += mass * m.damping_per_s;
    }
    for (const SheetTriangle& t : body.spec().sheet) {
        for (const int32_t v : t.vertex)
            packed.damping_per_s[as_index(v)] =
                static_cast<float>(damping[as_index(v)] / body.mass_kg()[as_index(v)]);
    }
}

}  // namespace

void pack_vertex_constants(const SoftBody& body, KernelLayout& packed) {
    const int tets = body.tet_count();
    packed.edge_weight_n_m.resize(6 * as_index(tets));
    for (int t = 0; t < tets; ++t) {
        const TetConstants k = tet_constants(body.spec(), t);
        for (size_t e = 0; e < 6; ++e) {
            packed.edge_weight_n_m[6 * as_index(t) + e] =
                static_cast<float>(k.material.mu_pa * k.volume_m3 * k.a[e]);
        }
    }
    packed.damping_per_s.assign(as_index(body.vertex_count()), 0.0F);
    for (int v = 0; v < body.vertex_count(); ++v) {
        double damping = 0, mass = 0;
        for (const int32_t t : body.tets_of(v)) {
            const auto& m =
                body.spec().materials[as_index(static_cast<int>(body.mesh().tissue[as_index(t)]))];
            const double share = m.density_kg_m3 * body.volume_m3()[as_index(t)];
            damping += share * m.damping_per_s;
            mass += share;
        }
        packed.damping_per_s[as_index(v)] = static_cast<float>(damping / mass);
    }
    if (!body.spec().sheet.empty()) add_sheet_damping(body, packed);
}

void pack_tethers(const SoftBody& body, KernelLayout& packed) {
    const auto& tethers = body.spec().tethers;
    std::vector<std::vector<int32_t>> of(as_index(body.vertex_count()));
    for (size_t i = 0; i < tethers.size(); ++i) {
        for (const int32_t v : tethers[i].vertex)
            of[as_index(v)].push_back(static_cast<int32_t>(i));
    }
    packed.tether_start.push_back(0);
    for (size_t v = 0; v < of.size(); ++v) {
        packed.tether_of.insert(packed.tether_of.end(), of[v].begin(), of[v].end());
        packed.tether_start.push_back(static_cast<int32_t>(packed.tether_of.size()));
        if (!of[v].empty()) packed.single_vertices.push_back(static_cast<int32_t>(v));
    }
}

}  // namespace placode::sim
