// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/step/snapshot.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "sim/cutting/attempt_progress.h"
#include "sim/fluid/jet_law.h"
#include "sim/ledger/burial.h"
#include "sim/step/needle_snapshot.h"
#include "sim/world/scene.h"
#include "sim/world/shape_version.h"

namespace placode::sim {
namespace {

ToolSnapshot tool_snapshot(const ToolSpec& spec, const ToolState& tool) {
    ToolSnapshot s;
    s.kind = spec.kind;
    s.pose = tool.proxy;
    for (int i = 0; i < 3; ++i) s.force_n[i] = static_cast<float>(tool.force_n[i]);
    s.jaw_rad = tool.jaw_rad;
    s.tip_gap_m = static_cast<float>(tool.tip_gap_m);
    s.pedals = tool.pedals;
    s.energised = tool.energised;
    s.in_contact = tool.in_contact;
    s.engaged = tool.engaged;
    s.touched = tool.touched;
    return s;
}

void fill_fluid(const Scene& scene, const State& state, FluidSnapshot& out) {
    const Irrigation& irrigation = *scene.irrigation;
    const PoolGrid& grid = irrigation.grid;
    out.x_m = grid.x_m;
    out.y_m = grid.y_m;
    out.cell_m = grid.cell_m;
    out.columns = grid.columns;
    out.rows = grid.rows;
    if (out.ground_m.size() != grid.cells()) out.ground_m = grid.ground_m;
    out.depth_m.resize(grid.cells());
    out.blood_m.resize(grid.cells());
    const Pool& pool = state.irrigation.pool;
    for (size_t c = 0; c < grid.cells(); ++c) {
        out.depth_m[c] = static_cast<float>(pool.volume_m3[c] / grid.cell_m2());
        out.blood_m[c] = static_cast<float>(pool.blood_m3[c] / grid.cell_m2());
    }
    out.specks.clear();
    out.specks.reserve(irrigation.debris.size());
    for (size_t i = 0; i < irrigation.debris.size(); ++i) {
        const DebrisFate fate = state.irrigation.debris[i].fate;
        if (fate != DebrisFate::kStuck && fate != DebrisFate::kLoose) continue;
        FluidSnapshot::Speck& speck = out.specks.emplace_back();
        const Vec3 at = debris_place(scene, state, i);
        for (int k = 0; k < 3; ++k) speck.at_m[k] = static_cast<float>(at[k]);
        speck.radius_m = irrigation.debris[i].radius_m;
        speck.blood = irrigation.debris[i].kind == DebrisKind::kBlood ? 1 : 0;
        speck.loose = fate == DebrisFate::kLoose ? 1 : 0;
    }
    for (size_t t = 0; t < out.jet_m.size(); ++t) {
        const auto length = static_cast<double>(state.irrigation.tips[t].jet_m);
        out.jet_m[t] = static_cast<float>(length);
        out.jet_radius_m[t] = static_cast<float>(irrigation.jet.bore_m / 2);
        out.jet_end_radius_m[t] = static_cast<float>(
            std::max(irrigation.jet.bore_m / 2, 0.6 * jet_width_m(irrigation.jet, length)));
    }
}

/// Where every vertex is, and what heat did to it.
void fill_tissue(const Scene& scene, const State& state, Snapshot& out) {
    const size_t vertices = state.body.x.size();
    out.x.resize(vertices);
    out.damage.resize(vertices);
    const HeatState* heat = state.heat.empty() ? nullptr : &state.heat[0];
    const auto whole = static_cast<size_t>(scene.body.vertex_count());
    out.origin.resize(vertices - whole);
    for (size_t v = 0; v < vertices; ++v) {
        const Float4& x = state.body.x[v];
        out.x[v] = {x.x, x.y, x.z};
        const auto o = static_cast<size_t>(origin_of(state.body, static_cast<int>(v)));
        if (v >= whole) out.origin[v - whole] = static_cast<int32_t>(o);
        if (heat) {
            out.damage[v] = {std::min(1.0f, heat->arrhenius[o]), heat->dried[o], heat->charred[o],
                             heat->temperature_c[o]};
        } else {
            out.damage[v] = {0, 0, 0, 37};
        }
    }
    // Copies lie at rest where the vertex slid that they come from.
    const auto slides = state.slides > 0 ? state.slides + state.splits : 0;
    if (out.slides != slides) {
        out.slides = slides;
        out.rest.resize(vertices);
        for (size_t v = 0; v < vertices; ++v) {
            const Vec3& p = rest_place(scene.body, state.body, static_cast<int>(v));
            for (int k = 0; k < 3; ++k) out.rest[v][k] = static_cast<float>(p[k]);
        }
    }
    // The list is copied only when it changed since this buffer was last filled.
    const uint32_t version = shape_version(state);
    if (out.triangles.empty() || out.surface_version != version) {
        const auto triangles = state.surface.triangles();
        out.triangles.assign(triangles.begin(), triangles.end());
        out.surface_version = version;
    }
    if (scene.patch && out.patch.empty()) {
        for (const SurfaceTriangle& t : scene.patch->triangles) out.patch.push_back(t.vertex);
    }
}

void fill_tools(const Scene& scene, const State& state, Snapshot& out) {
    out.tool_count = static_cast<int>(std::min(scene.tools.size(), out.tools.size()));
    for (int t = 0; t < out.tool_count; ++t) {
        out.tools[t] = tool_snapshot(scene.tools[t], state.tools[t]);
        const Burial burial = burial_of(scene, state, t);
        out.tools[t].buried_m = static_cast<float>(burial.depth_m);
        out.tools[t].buried_length_m = static_cast<float>(burial.length_m);
    }
}

/// Where a line that was drawn on the tissue lies now.
void fill_line(std::span<const ContourAnchor> anchors, const Snapshot& tissue,
               std::vector<std::array<float, 3>>& out) {
    out.resize(anchors.size());
    for (size_t i = 0; i < out.size(); ++i) {
        const ContourAnchor& a = anchors[i];
        out[i] = {};
        for (int k = 0; k < 3; ++k) {
            for (int axis = 0; axis < 3; ++axis)
                out[i][axis] += a.weight[k] * tissue.x[a.vertex[k]][axis];
        }
    }
}

}  // namespace

void fill_snapshot(const Scene& scene, const State& state, Snapshot& out) {
    out.frame = state.frame;
    out.time_s = state.time_s;
    fill_tissue(scene, state, out);
    fill_tools(scene, state, out);
    out.slit = scene.slit.present() ? 1 : 0;
    if (scene.suture) fill_needle(scene, state, out.needle);
    if (scene.irrigation) fill_fluid(scene, state, out.fluid);
    out.contour_cut.assign(state.progress.cut.begin(), state.progress.cut.end());
    fill_line(scene.contour_anchors, out, out.contour);
    out.resected_fraction = static_cast<float>(gone_share(scene, state));
    out.resect_cut.assign(state.resection.cut.begin(), state.resection.cut.end());
    fill_line(scene.resection.anchors, out, out.resect_line);
    out.free_sectors = state.release.free_count;
    out.pieces_out = state.pieces.out;
    out.phase = state.phase;
    out.cut_fraction = static_cast<float>(ring_share(state));
    out.vapour_rate_m3_s = state.vapour_rate_m3_s;
    out.placode_peak_cem43_min = state.ledger.placode_peak_cem43_min;
    out.placode_peak_c = state.ledger.placode_peak_c;
    out.step_flags = state.flags;
    out.substeps = state.substeps;
}

}  // namespace placode::sim
