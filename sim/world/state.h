// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All that changes while an attempt runs, composed of one state per subsystem.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>
#include "sim/core/event.h"
#include "sim/core/tool.h"
#include "sim/core/workers.h"
#include "sim/heat/heat.h"
#include "sim/mesh/surface.h"
#include "sim/solver/sleep.h"
#include "sim/solver/soft_body.h"
#include "sim/world/contact_state.h"
#include "sim/world/cut_state.h"
#include "sim/world/grasp_state.h"
#include "sim/world/irrigation_state.h"
#include "sim/world/ledger_state.h"
#include "sim/world/patch_state.h"
#include "sim/world/pieces_state.h"
#include "sim/world/sac_state.h"
#include "sim/world/scissors_state.h"
#include "sim/world/separation_state.h"
#include "sim/world/suturing_state.h"
#include "sim/world/tool_state.h"
#include "sim/world/undermining_state.h"

namespace placode::sim {

struct Scene;

inline constexpr int kMaxEventsPerFrame = 256;

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
    /// From tool a to tool b > a while they touch or nearly do, else zero:
    /// sim/contact/tool_contact.h.
    std::array<std::array<Vec3, kMaxTools>, kMaxTools> tool_side;
    std::array<Grasp, kMaxTools> grasps{};
    std::array<Scissors, kMaxTools> scissors{};
    Suturing suturing;
    ReleaseProgress release;
    ResectionProgress resection;
    Pieces pieces;
    int32_t splits = 0;                      ///< Vertices that cutting has split.
    int32_t slides = 0, slides_refused = 0;  ///< That blades asked for: blade_slides.h.
    std::vector<int8_t> held_by;             ///< (V) Tool whose jaws hold the vertex, -1 = none.
    CutProgress progress;
    float removed_m3 = 0, vapour_rate_m3_s = 0;
    ContactColour colour;
    SeparationQueue separation;
    PieceFlood flood;
    LedgerState ledger;
    std::vector<uint8_t> gone_by_heat;     ///< (T) 1 = vaporised.
    std::vector<FrictionAnchor> friction;  ///< (V)
    std::vector<uint8_t> stretch_count;    ///< (T) Checks in a row above the tear limit.
    uint32_t loose_version = 0;            ///< Surface version at the last search for loose tissue.
    PatchState patch;
    std::array<Event, kMaxEventsPerFrame> events{};  ///< Of the last frame.
    int event_count = 0;
    uint32_t flags = 0;  ///< StepFlag bits of this frame.
    std::unique_ptr<Workers> workers;
    struct Scratch;  ///< Lists of one frame: sim/world/scratch.h.
    std::unique_ptr<Scratch> scratch;
    IrrigationState irrigation;
    UnderminingState undermining;
    ~State();
};

// The order is that of the declaration.
template <class Visit>
void fields(Of<State> auto& s, Visit&& visit) {
    auto& [frame, time_s, substeps, phase, body, sleep, surface, self_contact, sac, heat, tools,
           tool_side, grasps, scissors, suturing, release, resection, pieces, splits, slides,
           slides_refused, held_by, progress, removed_m3, vapour_rate_m3_s, colour, separation,
           flood, ledger, gone_by_heat, friction, stretch_count, loose_version, patch, events,
           event_count, flags, workers, scratch, irrigation, undermining] = s;
    visit.state(frame, time_s, substeps, phase, body, sleep, surface, self_contact, sac, heat,
                tools, tool_side, grasps, scissors, suturing, release, resection, pieces, splits,
                slides, slides_refused, held_by, progress, removed_m3, vapour_rate_m3_s, colour,
                separation, flood, ledger, gone_by_heat, friction, stretch_count, loose_version,
                patch, irrigation, undermining);
    // Of one frame; threads; lists of one frame.
    visit.constant(events, event_count, flags, workers, scratch);
}

/// What recordings carry once a second: body, heat, tools, surface, phase. whole_hash() knows all
/// that decides the future.
[[nodiscard]] uint64_t state_hash(const State& state) noexcept;

}  // namespace placode::sim
