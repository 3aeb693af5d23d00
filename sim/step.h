// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The heart: one frame of the simulated world. Keeps nothing, throws nothing, allocates nothing.
// The same scene, state and inputs give the same bits at any number of threads.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/event.h"
#include "sim/grasp.h"
#include "sim/pieces.h"
#include "sim/scene.h"
#include "sim/scissors.h"
#include "sim/self_contact.h"
#include "sim/sleep.h"
#include "sim/tool.h"
#include "sim/workers.h"

namespace placode::sim {

inline constexpr int kMaxEventsPerFrame = 256;

/// Where a tool is and what it does, between frames.
struct ToolState {
    Pose proxy;                   ///< Real pose, pushed back by tissue.
    Pose previous;                ///< Proxy at the end of the previous frame.
    Vec3 force_n = Vec3::Zero();  ///< Force of tissue on the tool, mean over the frame [N].
    Vec3 steel_n = Vec3::Zero();  ///< Force of other instruments on it, mean over the frame [N].
    Vec3 friction_anchor = Vec3::Zero();
    double tip_gap_m = 1;  ///< Signed distance of the tip to the surface, negative inside.
    Tissue touched = Tissue::kSkin;  ///< Tissue next to the tip, valid when in_contact.
    uint8_t in_contact = 0, energised = 0;
    float contact_s = 0, peak_force_n = 0;           ///< Current placode contact.
    float energy_on_s = 0, energy_j = 0, air_s = 0;  ///< Current activation.
    float dwell_s = 0, placode_energised_s = 0, over_force_s = 0;
    Vec3 dwell_centre = Vec3::Zero();
    double power_in_tissue_w = 0;  ///< Delivered in the last frame.

    Pose hand;  ///< Where the hand held it at the end of the last frame.
    double stiffness_n_m =
        0;  ///< What the touched tissue answers at once, mean of the frame [N/m].
    Vec3 substep_force_n = Vec3::Zero();  ///< Of the last substep.
    double substep_stiffness_n_m = 0;     ///< Of the last substep.
    double substep_overlap_m = 0;         ///< Deepest contact at its end.
    double bare_gap_m = 1;  ///< Signed distance of bare metal to the surface, 1 = farther than the
                            ///< contact margin.
    Vec3 spot = Vec3::Zero();       ///< Point of the surface next to the bare metal, in W [m].
    Vec3 rest_spot = Vec3::Zero();  ///< The same at rest [m].
    int32_t spot_tet = -1;          ///< Tet behind it.
    double placode_force_n = 0;     ///< Mean over the frame.
    double gap_m = 1;  ///< Signed distance of the whole instrument to the surface, 1 = farther than
                       ///< the contact margin.
    float contact_share = 1;  ///< Share of the contact force that is let through: small while the
                              ///< needle cuts, and rising after it or after the hand came back.
    float quiet_s = 0;        ///< Placode: time since the last contact (debounce).
    float over_force_peak_n = 0, energised_peak_c = 0;
    float jaw_rad = 0;
    uint8_t pedals = 0, engaged = 0, coagulating = 0;
};

/// Where a vertex sticks to an instrument (dry friction has a memory).
struct FrictionAnchor {
    std::array<float, 3> anchor_T{};  ///< Point of the tool, in T [m].
    int8_t tool = -1;                 ///< -1 = none.
    uint8_t slipping = 0;             ///< Counts down the substeps since it slipped; 0 = sticks.
};

/// How far the incision has come. A contour point counts as cut when one of its eleven columns is
/// gone: straight lines along the surface normal at rest, at 0, +-0.2 .. +-1.0 mm across the
/// contour, from the surface to the target depth. A column is gone when every tet that it crosses
/// in that range of depths has left the body. What was cut stays cut.
struct CutProgress {
    std::vector<uint8_t> cut;  ///< One per contour point: 1 = cut through to target depth there.
    int cut_count = 0;
    std::vector<uint8_t> column_left;  ///< Tets that a column still holds (11 per contour point).
};

/// All that changes. Built once per attempt.
struct State {
    State(const Scene& scene, int threads);

    int64_t frame = 0;
    double time_s = 0;
    int substeps = 4;  ///< Used by the next frame (adapts under load, recorded).
    Phase phase = Phase::kInspect;
    SoftBodyState body;
    Sleep sleep;
    SurfaceState surface;
    SelfContact self_contact;
    SacState sac;
    std::vector<HeatState> heat;  ///< Empty or one.
    std::array<ToolState, kMaxTools> tools{};
    /// From tool a to tool b > a while they touch or nearly do, else zero: sim/tool_contact.h.
    std::array<std::array<Vec3, kMaxTools>, kMaxTools> tool_side;
    std::array<Grasp, kMaxTools> grasps{};
    std::array<Scissors, kMaxTools> scissors{};
    ReleaseProgress release;
    ResectionProgress resection;
    Pieces pieces;
    int32_t splits = 0;           ///< Vertices that cutting has split.
    std::vector<int8_t> held_by;  ///< (V) Tool whose jaws hold the vertex, -1 = none.
    CutProgress progress;
    float placode_peak_cem43_min = 0, placode_peak_c = 37, placode_burned_m3 = 0;
    float removed_m3 = 0, vapour_rate_m3_s = 0;
    std::vector<FrictionAnchor> friction;   ///< (V)
    std::vector<uint8_t> stretch_count;     ///< (T) Checks in a row above the tear limit.
    std::vector<uint8_t> stretch_reported;  ///< (T) 1 = over-stretch is in the ledger.
    std::vector<uint8_t> dose_reported;  ///< (V) bit 0 warning dose, bit 1 injury is in the ledger.
    std::array<float, kTissueCount> over_stretch_pause_s{};
    float overheat_pause_s = 0, burn_pause_s = 0, idle_s = 0;
    float placode_now_c = 37;  ///< Hottest vertex of the placode in this frame.
    int last_substeps = 4;
    uint32_t loose_version = 0;  ///< Surface version at the last search for loose tissue.
    std::array<Event, kMaxEventsPerFrame> events{};  ///< Of the last frame.
    int event_count = 0;
    uint32_t flags = 0;  ///< StepFlag bits of this frame.
    std::unique_ptr<Workers> workers;
    struct Scratch;  ///< Contact lists, bounding volumes: sim/contact.cpp.
    std::unique_ptr<Scratch> scratch;
    ~State();
};

struct StepReport {
    uint32_t flags = 0;  ///< StepFlag bits.
    int contacts = 0;
    int vaporised = 0;
    /// solve, contact, heat, cut, rest. Wall clock; never fed back into the state.
    std::array<int64_t, 5> cost_ns{};
};

/// Advances one frame. Inputs that are not finite count as not engaged; the body's settings say how
/// long a frame is, State::substeps into how many substeps it is cut. @pre inputs.size() ==
/// feedback.size() == scene.tools.size().
StepReport step(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                std::span<ToolFeedback> feedback) noexcept;

/// Lets the pre-tension and gravity settle without tools, for `seconds` of simulated time.
void settle(const Scene& scene, State& state, double seconds) noexcept;

/// Hash over everything that decides the future: body, heat, tools, surface, phase.
[[nodiscard]] uint64_t state_hash(const State& state) noexcept;

/// Where the planned contour lies now (contour_anchors.size()), in W [m].
void deformed_contour(const Scene& scene, const State& state, std::span<Vec3> out) noexcept;

}  // namespace placode::sim
