// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The number that recordings carry once a second: replays and threads are compared by it. It leaves
// out what follows from the rest or shows in it some frames later; whole_hash() leaves out nothing
// that decides. Each struct is taken apart into all of its fields: a new one does not compile
// before it is said here whether it counts. What counts, and in which order, stays: recordings hold
// it.

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
        const auto& [p, q] = pose;
        add(p);
        for (int i = 0; i < 4; ++i) add(q.coeffs()[i]);
    }
    template <class T, size_t N>
    void add(const std::array<T, N>& values) noexcept {
        for (const T& value : values) add(value);
    }
    template <class... T>
    void each(const T&... values) noexcept {
        (add(values), ...);
    }
    /// Bytes; an empty list leaves the hash what it is.
    template <class T>
    void all(const std::vector<T>& values) noexcept {
        bytes(values.data(), values.size() * sizeof(T));
    }
    /// Does not count: follows from the rest, belongs to one frame, or shows in the next ones.
    template <class... T>
    void without(const T&...) const noexcept {}
};

void hash_sleep(Hash& hash, const Sleep& sleep) noexcept {
    const auto& [block, member_start, member, border_start, border, unblocked, leaf_start,
                 leaf_block, tets_start, tets, asleep, calm, restless, beside, since, before,
                 vertex_asleep, leaf_moves, chunk, tets_move, asleep_count, known_vertices] = sleep;
    hash.all(asleep);
    hash.all(calm);
    hash.without(block, member_start, member, border_start, border, unblocked, leaf_start,
                 leaf_block, tets_start, tets, restless, beside, since, before, vertex_asleep,
                 leaf_moves, chunk, tets_move, asleep_count, known_vertices);
}

void hash_heat(Hash& hash, const HeatState& heat) noexcept {
    const auto& [temperature_c, dried, cem43_min, arrhenius, charred, warm, warm_list, warm_count,
                 in_order, ordered_count, wakes, power_w, enthalpy_j, capacity_j_k, latent_j,
                 flux_w, edge_w_k, exposed_m2, energy_in_j, energy_vapour_j, energy_lost_j] = heat;
    for (int n = 0; n < warm_count; ++n) {
        const int32_t v = warm_list[n];
        hash.each(v, enthalpy_j[v], dried[v], cem43_min[v], arrhenius[v], charred[v]);
    }
    hash.without(temperature_c, warm, in_order, ordered_count, wakes, power_w, capacity_j_k,
                 latent_j, flux_w, edge_w_k, exposed_m2, energy_in_j, energy_vapour_j,
                 energy_lost_j);
}

void hash_tool(Hash& hash, const ToolState& tool, const ToolLedger& spells) noexcept {
    const auto& [proxy, previous, force_n, steel_n, needle_n, friction_anchor, tip_gap_m, touched,
                 in_contact, energised, power_in_tissue_w, hand, stiffness_n_m, substep_force_n,
                 substep_stiffness_n_m, substep_overlap_m, bare_gap_m, spot, rest_spot, spot_tet,
                 placode_force_n, gap_m, contact_share, jaw_rad, pedals, engaged, coagulating] =
        tool;
    const auto& [contact_s, peak_force_n, quiet_s, energy_on_s, energy_j, air_s, air_until_s,
                 dwell_s, dwell_until_s, dwell_centre, dwell_rest, dwell_tet, dwell_tissue,
                 placode_energised_s, energised_peak_c, over_force_s, over_force_peak_n] = spells;
    hash.each(proxy, hand, force_n, substep_force_n, substep_stiffness_n_m, substep_overlap_m, spot,
              dwell_centre);
    hash.each(contact_s, peak_force_n, energy_on_s, energy_j, air_s, dwell_s, placode_energised_s,
              over_force_s, contact_share, quiet_s, over_force_peak_n, energised_peak_c);
    hash.each(power_in_tissue_w, in_contact, energised, engaged, coagulating);
    hash.without(previous, steel_n, needle_n, friction_anchor, tip_gap_m, touched, stiffness_n_m,
                 bare_gap_m, rest_spot, spot_tet, placode_force_n, gap_m, jaw_rad, pedals,
                 air_until_s, dwell_until_s, dwell_rest, dwell_tet, dwell_tissue);
}

void hash_grasp(Hash& hash, const Grasp& grasp) noexcept {
    const auto& [held, count, grasped, jaw_rad, meet_rad, pinch_n, area_m2, held_s, peak_n, slip_m,
                 slip_shut_m, slip_pause_s, slip_peak_n, traction_s, traction_peak_n,
                 traction_pause_s, tissue, shut, crushed, force_n, rest_m, tet] = grasp;
    hash.add(count);
    for (int i = 0; i < count; ++i) {
        const auto& [vertex, at_T] = held[i];
        hash.each(vertex, at_T);
    }
    hash.each(jaw_rad, meet_rad, pinch_n, held_s, peak_n, slip_m, slip_pause_s, traction_s, shut);
    hash.without(grasped, area_m2, slip_shut_m, slip_peak_n, traction_peak_n, traction_pause_s,
                 tissue, crushed, force_n, rest_m, tet);
}

void hash_scissors(Hash& hash, const Scissors& blades) noexcept {
    const auto& [planned, planned_count, next, jaw_rad, start_rad, closing, sliding, slid_to_m,
                 plane, met_T, met_count, area_m2, placode_m2, depth_m, area_of, rest_sum, faces,
                 tet, refused] = blades;
    hash.each(jaw_rad, start_rad, next, closing);
    hash.without(planned, planned_count, sliding, slid_to_m, plane, met_T, met_count, area_m2,
                 placode_m2, depth_m, area_of, rest_sum, faces, tet, refused);
}

void hash_suturing(Hash& hash, const Suturing& suturing) noexcept {
    const auto& [needle, placed, driver, handover, locked, held_s, peak_n, slide, turn, taken,
                 entered, left, through, entry_m, exit_m, point_n, thread_n] = suturing;
    for (const SutureState& one : needle) hash.each(state_hash(one), placed, driver);
    // Where one hand has the needle its bits are those of scenes with one driver.
    if (handover.second >= 0) hash.each(handover.second);
    hash.without(locked, held_s, peak_n, slide, turn, taken, entered, left, through, entry_m,
                 exit_m, point_n, thread_n);
}

void hash_sac(Hash& hash, const SacState& sac) noexcept {
    const auto& [pressure_pa, content_m3, hole_m2, leaked_m3, roused_pa, looked, filled, opened] =
        sac;
    hash.each(pressure_pa, content_m3);
    hash.without(hole_m2, leaked_m3, roused_pa, looked, filled, opened);
}

void hash_self_contact(Hash& hash, const SelfContact& self) noexcept {
    const auto& [pairs, count, near_moved_until] = self;
    for (size_t g = 0; g < pairs.size(); ++g) {
        for (int32_t i = 0; i < count[g]; ++i) {
            const auto& [vertex, tet, face] = pairs[g][static_cast<size_t>(i)];
            hash.each(vertex, tet, face);
        }
    }
    hash.without(near_moved_until);
}

/// Of the first `count` vertices of a list: which, and the load.
void hash_load(Hash& hash, const std::vector<int32_t>& vertices, int32_t count,
               const std::vector<std::array<float, 3>>& load_n) noexcept {
    for (int32_t i = 0; i < count; ++i) {
        const int32_t v = vertices[static_cast<size_t>(i)];
        hash.each(v, load_n[static_cast<size_t>(v)]);
    }
}

void hash_patch(Hash& hash, const PatchState& patch) noexcept {
    const auto& [touch, loaded, loaded_count, listed, load_n, told_n] = patch;
    for (const PatchTouch& one : touch) {
        const auto& [tet, face, presses, anchor] = one;
        const auto& [anchor_tet, anchor_face, weight] = anchor;
        hash.each(tet, face, presses, anchor_tet, anchor_face, weight);
    }
    hash_load(hash, loaded, loaded_count, load_n);
    hash.without(listed, told_n);
}

void hash_irrigation(Hash& hash, const IrrigationState& fluid) noexcept {
    const auto& [pool, debris, tips, placode_pa, hidden, jet_m3, peak_pa, over_s, hidden_s, held_s,
                 placode_held_s, peak_rest_m, pressed, held, loaded, loaded_count, listed, load_n,
                 told_n] = fluid;
    const auto& [volume_m3, blood_m3, given_m3, sucked_m3, run_off_m3, calm] = pool;
    hash.all(volume_m3);
    hash.all(blood_m3);
    hash.all(debris);
    hash_load(hash, loaded, loaded_count, load_n);
    if (!volume_m3.empty()) {
        for (const TipFlow& tip : tips) {
            const auto& [tip_jet_m, shut, sucked] = tip;
            hash.add(shut);
            hash.without(tip_jet_m, sucked);
        }
        hash.each(given_m3, sucked_m3, run_off_m3, peak_pa, over_s, hidden, hidden_s, held_s,
                  placode_held_s, jet_m3);
    }
    hash.without(placode_pa, peak_rest_m, pressed, held, listed, told_n, calm);
}

void hash_undermining(Hash& hash, const UnderminingState& undermining) noexcept {
    const auto& [jaws, over_count] = undermining;
    hash.all(over_count);
    for (const SpreadJaws& one : jaws) {
        const auto& [rad, push_n] = one;
        hash.each(rad, push_n);
    }
}

/// How far the work has come.
void hash_progress(Hash& hash, const ReleaseProgress& release, const Pieces& loose,
                   const ResectionProgress& resection, const CutProgress& incision) noexcept {
    const auto& [free, free_checked, free_count, next] = release;
    const auto& [list, of, resting, searched, out, crumbs, out_m3, marked_gone_m3, marked_out_m3,
                 marked_lost_m3] = loose;
    const auto& [line_cut, line_checked, line_cut_count, line_next] = resection;
    const auto& [cut, cut_count, column_left] = incision;
    hash.each(free_count, next, out, crumbs);
    hash.all(of);
    hash.all(line_cut);
    hash.all(cut);
    hash.all(column_left);
    hash.without(free, free_checked, list, resting, searched, out_m3, marked_gone_m3, marked_out_m3,
                 marked_lost_m3, line_checked, line_cut_count, line_next, cut_count);
}

/// Friction of the vertices in contact, in their order; scratch has it as well, but may be
/// forgotten.
void hash_friction(Hash& hash, const std::vector<FrictionAnchor>& friction,
                   const ContactColour& colour) noexcept {
    for (int i = 0; i < colour.count; ++i) {
        const auto& [anchor_T, tool, slipping] = friction[colour.vertex[i]];
        hash.each(tool, slipping, anchor_T);
    }
}

}  // namespace

uint64_t state_hash(const State& state) noexcept {
    const auto& [frame, time_s, substeps, phase, body, sleep, surface, self_contact, sac, heat,
                 tools, tool_side, grasps, scissors, suturing, release, resection, pieces, splits,
                 slides, slides_refused, held_by, progress, removed_m3, vapour_rate_m3_s, colour,
                 separation, flood, ledger, gone_by_heat, friction, stretch_count, loose_version,
                 patch, events, event_count, flags, workers, scratch, irrigation, undermining] =
        state;
    const auto& [spells, over_stretch, tether_known, stretch_reported, dose_reported,
                 over_stretch_pause_s, overheat_pause_s, burn_pause_s, idle_s,
                 placode_peak_cem43_min, placode_peak_c, placode_burned_m3, placode_now_c,
                 last_substeps] = ledger;
    Hash hash;
    hash.each(frame, substeps, phase, state_hash(body));
    hash_sleep(hash, sleep);
    hash.all(body.tether_alive);
    hash.add(surface.version());
    for (const SurfaceTriangle& t : surface.triangles()) hash.add(t.vertex);
    for (const HeatState& one : heat) hash_heat(hash, one);
    for (size_t t = 0; t < tools.size(); ++t) hash_tool(hash, tools[t], spells[t]);
    hash.add(tool_side);
    for (const Grasp& one : grasps) hash_grasp(hash, one);
    for (const Scissors& one : scissors) hash_scissors(hash, one);
    hash_suturing(hash, suturing);
    hash_sac(hash, sac);
    hash.add(splits);
    hash_self_contact(hash, self_contact);
    hash_patch(hash, patch);
    hash_irrigation(hash, irrigation);
    hash_undermining(hash, undermining);
    hash_progress(hash, release, pieces, resection, progress);
    hash.all(stretch_count);
    hash.all(stretch_reported);
    hash.all(dose_reported);
    hash.add(over_stretch_pause_s);
    hash_friction(hash, friction, colour);
    hash.each(placode_peak_cem43_min, placode_peak_c, placode_burned_m3, removed_m3,
              vapour_rate_m3_s, overheat_pause_s, burn_pause_s, idle_s);
    hash.without(time_s, slides, slides_refused, held_by, colour, separation, flood, gone_by_heat,
                 loose_version, events, event_count, flags, workers, scratch, over_stretch,
                 tether_known, placode_now_c, last_substeps);
    return hash.value();
}

}  // namespace placode::sim
