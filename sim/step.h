// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The heart: one frame of the simulated world. Keeps nothing, throws nothing, allocates nothing.
// The same scene, state and inputs give the same bits at any number of threads.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/event.h"
#include "sim/scene.h"
#include "sim/tool.h"
#include "sim/workers.h"

namespace placode::sim {

inline constexpr int kMaxEventsPerFrame = 256;

/// Where a tool is and what it does, between frames.
struct ToolState {
    Pose proxy;                   ///< Real pose, pushed back by tissue.
    Pose previous;                ///< Proxy at the end of the previous frame.
    Vec3 force_n = Vec3::Zero();  ///< Force of tissue on the tool, mean over the frame [N].
    Vec3 friction_anchor = Vec3::Zero();
    double tip_gap_m = 1;  ///< Signed distance of the tip to the surface, negative inside.
    Tissue touched = Tissue::kSkin;  ///< Tissue next to the tip, valid when in_contact.
    uint8_t in_contact = 0, energised = 0;
    float contact_s = 0, peak_force_n = 0;           ///< Current placode contact.
    float energy_on_s = 0, energy_j = 0, air_s = 0;  ///< Current activation.
    float dwell_s = 0, placode_energised_s = 0, over_force_s = 0;
    Vec3 dwell_centre = Vec3::Zero();
    double power_in_tissue_w = 0;  ///< Delivered in the last frame.
};

/// How far the incision has come: planned contour in bins of equal arc length.
struct CutProgress {
    std::vector<uint8_t> cut;  ///< One per contour point: 1 = cut through to target depth there.
    int cut_count = 0;
};

/// All that changes. Built once per attempt.
struct State {
    State(const Scene& scene, int threads);

    int64_t frame = 0;
    double time_s = 0;
    int substeps = 4;  ///< Used by the next frame (adapts under load, recorded).
    Phase phase = Phase::kInspect;
    SoftBodyState body;
    SurfaceState surface;
    std::vector<HeatState> heat;  ///< Empty or one.
    std::array<ToolState, kMaxTools> tools{};
    CutProgress progress;
    float placode_peak_cem43_min = 0, placode_peak_c = 37, placode_burned_m3 = 0;
    float removed_m3 = 0, vapour_rate_m3_s = 0;
    std::array<Event, kMaxEventsPerFrame> events{};  ///< Of the last frame.
    int event_count = 0;
    std::unique_ptr<Workers> workers;
    struct Scratch;  ///< Contact lists, bounding volumes: sim/contact.cpp.
    std::unique_ptr<Scratch> scratch;
    ~State();
};

struct StepReport {
    uint32_t flags = 0;  ///< StepFlag bits.
    int contacts = 0;
    int vaporised = 0;
    std::array<int64_t, 4> cost_ns{};  ///< solve, contact, heat and cut, rest. Wall clock; never
                                       ///< fed back into the state.
};

/// Advances one frame. @pre inputs.size() == feedback.size() == scene.tools.size().
StepReport step(const Scene& scene, State& state, std::span<const ToolInput> inputs,
                std::span<ToolFeedback> feedback) noexcept;

/// Lets the pre-tension and gravity settle without tools, for `seconds` of simulated time.
void settle(const Scene& scene, State& state, double seconds) noexcept;

/// Hash over everything that decides the future: body, heat, tools, surface, phase.
[[nodiscard]] uint64_t state_hash(const State& state) noexcept;

/// Where the planned contour lies now (contour_anchors.size()), in W [m].
void deformed_contour(const Scene& scene, const State& state, std::span<Vec3> out) noexcept;

}  // namespace placode::sim
