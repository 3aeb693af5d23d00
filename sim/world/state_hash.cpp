// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that decides the future, in one number: replays and threads are compared by it.

#include <cstring>
#include <type_traits>

#include "sim/core/fnv_hash.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

class Hash : public FnvHash {
 public:
    template <class T>
    void add(const T& value) noexcept {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        bytes(&value, sizeof value);
    }
    void add(const Vec3& v) noexcept {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    void add(const Pose& pose) noexcept {
        add(pose.p);
        for (int i = 0; i < 4; ++i) add(pose.q.coeffs()[i]);
    }
    template <class T>
    void all(const std::vector<T>& values) noexcept {
        bytes(values.data(), values.size() * sizeof(T));
    }
};

void hash_tool(Hash& hash, const ToolState& t, const ToolLedger& l) noexcept {
    hash.add(t.proxy);
    hash.add(t.hand);
    hash.add(t.force_n);
    hash.add(t.substep_force_n);
    hash.add(t.substep_stiffness_n_m);
    hash.add(t.substep_overlap_m);
    hash.add(t.spot);
    hash.add(l.dwell_centre);
    for (const float f : {l.contact_s, l.peak_force_n, l.energy_on_s, l.energy_j, l.air_s,
                          l.dwell_s, l.placode_energised_s, l.over_force_s, t.contact_share,
                          l.quiet_s, l.over_force_peak_n, l.energised_peak_c}) {
        hash.add(f);
    }
    hash.add(t.power_in_tissue_w);
    for (const uint8_t b : {t.in_contact, t.energised, t.engaged, t.coagulating}) hash.add(b);
}

void hash_grasp(Hash& hash, const Grasp& g) noexcept {
    hash.add(g.count);
    for (int i = 0; i < g.count; ++i) {
        hash.add(g.held[i].vertex);
        for (const float f : g.held[i].at_T) hash.add(f);
    }
    for (const float f : {g.jaw_rad, g.meet_rad, g.pinch_n, g.held_s, g.peak_n, g.slip_m,
                          g.slip_pause_s, g.traction_s}) {
        hash.add(f);
    }
    hash.add(g.shut);
}

}  // namespace

uint64_t state_hash(const State& state) noexcept {
    Hash hash;
    hash.add(state.frame);
    hash.add(state.substeps);
    hash.add(state.phase);
    hash.add(state_hash(state.body));
    hash.all(state.sleep.asleep);
    hash.all(state.sleep.calm);
    hash.all(state.body.tether_alive);
    hash.add(state.surface.version());
    for (const SurfaceTriangle& t : state.surface.triangles()) {
        for (const int32_t v : t.vertex) hash.add(v);
    }
    for (const HeatState& heat : state.heat) {
        for (int n = 0; n < heat.warm_count; ++n) {
            const int v = heat.warm_list[n];
            hash.add(v);
            hash.add(heat.enthalpy_j[v]);
            hash.add(heat.dried[v]);
            hash.add(heat.cem43_min[v]);
            hash.add(heat.arrhenius[v]);
            hash.add(heat.charred[v]);
        }
    }
    for (size_t t = 0; t < state.tools.size(); ++t)
        hash_tool(hash, state.tools[t], state.ledger.tools[t]);
    for (const auto& row : state.tool_side) {
        for (const Vec3& side : row) hash.add(side);
    }
    for (const Grasp& grasp : state.grasps) hash_grasp(hash, grasp);
    for (const Scissors& s : state.scissors) {
        hash.add(s.jaw_rad);
        hash.add(s.start_rad);
        hash.add(s.next);
        hash.add(s.closing);
    }
    for (const SutureState& needle : state.suturing.needle) {
        hash.add(state_hash(needle));
        hash.add(state.suturing.placed);
        hash.add(state.suturing.driver);
    }
    hash.add(state.sac.pressure_pa);
    hash.add(state.sac.content_m3);
    hash.add(state.splits);
    for (size_t g = 0; g < state.self_contact.pairs.size(); ++g) {
        for (int32_t i = 0; i < state.self_contact.count[g]; ++i) {
            const TissuePair& pair = state.self_contact.pairs[g][static_cast<size_t>(i)];
            for (const int32_t part : {pair.vertex, pair.tet, pair.face}) hash.add(part);
        }
    }
    for (const PatchTouch& t : state.patch.touch) {
        for (const int32_t part : {t.tet, t.face, t.presses, t.anchor.tet, t.anchor.face})
            hash.add(part);
        for (const float w : t.anchor.weight) hash.add(w);
    }
    for (int32_t i = 0; i < state.patch.loaded_count; ++i) {
        const auto v = static_cast<size_t>(state.patch.loaded[static_cast<size_t>(i)]);
        hash.add(static_cast<int32_t>(v));
        for (const float n : state.patch.load_n[v]) hash.add(n);
    }
    // An empty list leaves the hash what it is.
    const IrrigationState& fluid = state.irrigation;
    hash.all(fluid.pool.volume_m3);
    hash.all(fluid.pool.blood_m3);
    hash.all(fluid.debris);
    for (int32_t i = 0; i < fluid.loaded_count; ++i) {
        const auto v = static_cast<size_t>(fluid.loaded[static_cast<size_t>(i)]);
        hash.add(static_cast<int32_t>(v));
        for (const float n : fluid.load_n[v]) hash.add(n);
    }
    if (!fluid.pool.volume_m3.empty()) {
        for (const TipFlow& tip : fluid.tips) hash.add(tip.shut);
        for (const double d : {fluid.pool.given_m3, fluid.pool.sucked_m3, fluid.pool.run_off_m3,
                               fluid.peak_pa, fluid.over_s, fluid.hidden, fluid.hidden_s,
                               fluid.held_s, fluid.placode_held_s, fluid.jet_m3})
            hash.add(d);
    }
    hash.all(state.undermining.over_count);
    for (const SpreadJaws& jaws : state.undermining.jaws) {
        hash.add(jaws.rad);
        hash.add(jaws.push_n);
    }
    hash.add(state.release.free_count);
    hash.add(state.release.next);
    hash.add(state.pieces.out);
    hash.add(state.pieces.crumbs);
    hash.all(state.pieces.of);
    hash.all(state.resection.cut);
    hash.all(state.progress.cut);
    hash.all(state.progress.column_left);
    hash.all(state.stretch_count);
    hash.all(state.ledger.stretch_reported);
    hash.all(state.ledger.dose_reported);
    for (const float f : state.ledger.over_stretch_pause_s) hash.add(f);
    const ContactSet& contacts = state.scratch->contacts;
    for (int i = 0; i < contacts.vertex_count; ++i) {
        const FrictionAnchor& anchor = state.friction[contacts.vertices[i].vertex];
        hash.add(anchor.tool);
        hash.add(anchor.slipping);
        for (const float f : anchor.anchor_T) hash.add(f);
    }
    for (const float f :
         {state.ledger.placode_peak_cem43_min, state.ledger.placode_peak_c,
          state.ledger.placode_burned_m3, state.removed_m3, state.vapour_rate_m3_s,
          state.ledger.overheat_pause_s, state.ledger.burn_pause_s, state.ledger.idle_s}) {
        hash.add(f);
    }
    return hash.value();
}

}  // namespace placode::sim
