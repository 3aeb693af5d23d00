// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/step/step.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "sim/contact/contact.h"
#include "sim/contact/free_pieces.h"
#include "sim/contact/patch_contact.h"
#include "sim/contact/patch_modes.h"
#include "sim/contact/self_contact.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/diathermy.h"
#include "sim/cutting/grasp.h"
#include "sim/cutting/pieces.h"
#include "sim/cutting/plane_parting.h"
#include "sim/cutting/sac.h"
#include "sim/cutting/scissors.h"
#include "sim/cutting/separation.h"
#include "sim/fluid/irrigation.h"
#include "sim/ledger/ledger.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/step/sleep_and_wake.h"
#include "sim/step/suturing.h"
#include "sim/step/tip_gap.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kLooseInterval = 128;     // frames between two searches for loose tissue
constexpr int kRestoreInterval = 256;   // frames between two searches for collapsed tissue
constexpr float kSettleDamping = 0.9f;  // of the velocity per substep while settling
constexpr double kEmbedded = 3e-5;      // deeper than any overlap of mere touch [m]
constexpr double kThrough = 1.5;        // deeper than this, in radii of the tip, it is through
constexpr double kShareRecovery = 0.2;  // seconds until the whole contact force is back
constexpr float kTouchForce = 1e-5f;    // less is rounding, not a touch [N]

int64_t now_ns() noexcept {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Takes over the hand's poses; a lost or senseless one is not engaged and exerts no force.
void take_inputs(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                 std::array<Pose, kMaxTools>& from, std::array<Pose, kMaxTools>& to) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        Pose hand = inputs[t].pose();
        const double norm = hand.q.norm();
        const bool sound =
            hand.p.allFinite() && std::isfinite(norm) && norm > 1e-6 && hand.p.norm() < 10;
        const bool engaged = sound && inputs[t].engaged != 0;
        if (sound) hand.q.coeffs() /= norm;
        tool.previous = tool.proxy;
        tool.force_n = tool.steel_n = tool.needle_n = Vec3::Zero();
        tool.stiffness_n_m = tool.placode_force_n = 0;
        state.grasps[t].force_n = Vec3::Zero();
        tool.gap_m = 1;
        if (!engaged) {
            if (sound) tool.proxy = tool.hand = hand;
            tool.substep_force_n = Vec3::Zero();
            tool.substep_stiffness_n_m = tool.substep_overlap_m = 0;
            tool.bare_gap_m = 1;
        } else if (!tool.engaged) {
            // The hand comes back, perhaps inside tissue: its force comes up slowly.
            tool.proxy = tool.hand = hand;
            tool.contact_share = 0;
        }
        tool.engaged = engaged ? 1 : 0;
        tool.pedals = inputs[t].pedals;
        tool.jaw_rad = inputs[t].jaw_rad;
        from[t] = tool.hand;
        to[t] = engaged ? hand : tool.hand;
        tool.hand = to[t];
    }
}

enum CostItem : size_t { kSolve, kContact, kHeat, kCut, kRest };  // as in StepReport::cost_ns

/// Charges the wall clock of a frame to the items of its report, stretch by stretch.
class CostClock {
 public:
    explicit CostClock(StepReport& report) noexcept : report_(report), mark_(now_ns()) {}
    /// What passed since the last charge goes to `item`.
    void charge(CostItem item) noexcept {
        const int64_t now = now_ns();
        report_.cost_ns[item] += now - mark_;
        mark_ = now;
    }

 private:
    StepReport& report_;
    int64_t mark_;
};

/// Hands, instruments and tissue from the end of one frame to the end of the next.
void run_substeps(const Scene& scene, State& state, const std::array<Pose, kMaxTools>& from,
                  const std::array<Pose, kMaxTools>& to, CostClock& costs) noexcept {
    const SolverSettings& solver = scene.body.spec().solver;
    const double h = solver.frame_s / state.substeps;
    hold_sleepers(state.body);
    state.body.backward = false;
    for (int s = 0; s < state.substeps; ++s) {
        move_tools(scene, state, from, to, static_cast<double>(s + 1) / state.substeps);
        carry_grasped(scene, state);
        costs.charge(kContact);
        begin_substep(scene.body, state.body, h, *state.workers);
        costs.charge(kSolve);
        find_contacts(scene, state);
        press_patch(scene, state, h);
        begin_suture_substep(scene, state, h);
        costs.charge(kContact);
        for (int i = 0; i < solver.iterations; ++i) {
            solve_contacts(scene, state, h, false);
            solve_suture_substep(scene, state, h, false);
            costs.charge(kContact);
            sweep(scene.body, state.body, h, *state.workers);
            costs.charge(kSolve);
            solve_suture_substep(scene, state, h, true);
            solve_contacts(scene, state, h, true);
            costs.charge(kContact);
        }
        move_patch_whole(scene, state, h);
        move_free_pieces(scene, state, h);
        finish_contacts(state);
        bear_patch(scene, state, h);
        feel_grasped(scene, state);
        finish_suture_substep(scene, state, h);
        costs.charge(kContact);
        end_substep(scene.body, state.body, h, *state.workers);
        costs.charge(kSolve);
    }
    release_sleepers(state.body);
}

/// How much of its contact force tool `t` has in the next frame. The whole of it comes back at once
/// in the open, over a while where the tip only touches, and not at all while the needle is still
/// stuck in what it has not removed.
float contact_share_of(const Scene& scene, const State& state, int t) noexcept {
    const ToolState& tool = state.tools[t];
    if (tool.gap_m >= 0) return 1;
    // Right through the surface (a hand that jumps, a shaft that swings): pushing would only tear
    // the field apart. It is let out without force, as one that comes back.
    const double radius = state.scratch->contacts.shapes[t].parts[0].near_radius_m;
    if (tool.gap_m < -kThrough * radius) return 0;
    const bool touches = tool.gap_m > -kEmbedded || (scene.tools[t].kind == ToolKind::kScissors &&
                                                     !blades_in_cut(scene, state, t));
    if (!touches) return tool.contact_share;
    const double frame_s = scene.body.spec().solver.frame_s;
    return std::min(1.0f, tool.contact_share + static_cast<float>(frame_s / kShareRecovery));
}

/// Of a needle in the jaws of tool `t`, in its frame; zero without one.
Vec3 needle_centre(const State& state, int t) noexcept {
    if (state.suturing.placed == 0 || hold_of(state, t) == nullptr) return Vec3::Zero();
    return state.tools[t].proxy.inverse() * state.suturing.needle[0].needle.p;
}

void give_feedback(const Scene& scene, State& state, std::span<ToolFeedback> feedback) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        ToolState& tool = state.tools[t];
        tool.contact_share = contact_share_of(scene, state, t);
        tool.in_contact = (tool.force_n - tool.needle_n).norm() > kTouchForce ? 1 : 0;
        feedback[t] = {tool.proxy, tool.force_n + tool.steel_n, tool.stiffness_n_m, state.time_s,
                       needle_centre(state, t)};
    }
}

/// Cuts, tears, and what has come loose by them.
void part_tissue(const Scene& scene, State& state) noexcept {
    run_scissors(scene, state);
    tear(scene, state);
    part_plane(scene, state);
    separate(scene, state);
    update_pieces(scene, state);
    // A flood over the whole body: now and then is enough to notice what has come loose.
    if (state.frame % kLooseInterval == 0 && state.surface.version() != state.loose_version) {
        state.loose_version = state.surface.version();
        update_free_vertices(scene.body, state.body);
    }
}

}  // namespace

StepReport step(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                std::span<ToolFeedback> feedback) noexcept {
    assert(inputs.size() == scene.tools.size() && feedback.size() == scene.tools.size());
    StepReport report;
    CostClock costs(report);
    const Workers::Frame measured(*state.workers);
    const double frame_s = scene.body.spec().solver.frame_s;
    state.substeps = std::clamp(state.substeps, 1, 64);
    ++state.frame;
    state.time_s = static_cast<double>(state.frame) * frame_s;
    state.event_count = 0;
    state.flags = 0;
    state.body.flags = 0;

    std::array<Pose, kMaxTools> from, to;
    take_inputs(scene, state, inputs, from, to);
    begin_suturing(scene, state);
    collect_candidates(scene, state);
    collect_tissue_pairs(scene, state);
    collect_patch_faces(scene, state, state.frame);
    update_irrigation(scene, state, frame_s);
    update_sac(scene, state, frame_s, false);
    wake_tissue(scene, state);
    collect_free_pieces(scene, state);
    costs.charge(kContact);
    run_substeps(scene, state, from, to, costs);
    measure_tips(scene, state);
    give_feedback(scene, state, feedback);
    update_grasps(scene, state, frame_s);
    update_suturing(scene, state, frame_s);
    costs.charge(kContact);
    std::array<uint8_t, kMaxTools> active{};
    report.vaporised = run_diathermy(scene, state, inputs, active, frame_s);
    costs.charge(kHeat);
    part_tissue(scene, state);
    costs.charge(kCut);
    doze(scene, state);
    // Tissue shrunk to a point feels no force and raises no flag: it has to be looked for.
    if (state.frame % kRestoreInterval == 0) restore_collapsed(scene.body, state.body);
    state.flags |= state.body.flags;
    update_ledger(scene, state, active, frame_s);
    costs.charge(kRest);
    report.flags = state.flags;
    report.contacts = state.scratch->contacts.most_contacts;
    return report;
}

void settle(const Scene& scene, State& state, double seconds) noexcept {
    const SolverSettings& solver = scene.body.spec().solver;
    const int substeps = std::clamp(state.substeps, 1, 64);
    const double h = solver.frame_s / substeps;
    const auto count = static_cast<int64_t>(std::ceil(seconds / h));
    hold_sleepers(state.body);
    for (int64_t n = 0; n < count; ++n) {
        if (n % substeps == 0) update_sac(scene, state, solver.frame_s, true);
        if (n % substeps == 0 && scene.patch) {
            state.surface.refit(state.body.x);
            collect_patch_faces(scene, state, n / substeps);
        }
        begin_substep(scene.body, state.body, h, *state.workers);
        press_patch(scene, state, h);
        for (int i = 0; i < solver.iterations; ++i) {
            sweep(scene.body, state.body, h, *state.workers);
        }
        move_patch_whole(scene, state, h);
        bear_patch(scene, state, h);
        end_substep(scene.body, state.body, h, *state.workers);
        for (Float4& v : state.body.v) {
            v.x *= kSettleDamping;
            v.y *= kSettleDamping;
            v.z *= kSettleDamping;
        }
    }
    release_sleepers(state.body);
    for (Float4& v : state.body.v) v.x = v.y = v.z = 0;
}

void deformed_contour(const Scene& scene, const State& state, std::span<Vec3> out) noexcept {
    const size_t count = std::min(out.size(), scene.contour_anchors.size());
    for (size_t i = 0; i < count; ++i) {
        const ContourAnchor& a = scene.contour_anchors[i];
        out[i] = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            out[i] += a.weight[k] * position(state.body, a.vertex[k]);
        }
    }
}

}  // namespace placode::sim
