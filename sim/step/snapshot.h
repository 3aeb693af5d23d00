// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the view (and any other watcher) gets to see: a copy, never the State.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/step/step.h"

namespace placode::sim {

struct ToolSnapshot {
    ToolKind kind = ToolKind::kNeedle;
    Pose pose;  ///< Proxy.
    std::array<float, 3> force_n{};
    float jaw_rad = 0;
    float tip_gap_m = 1;
    float buried_m = 0, buried_length_m = 0;  ///< As sim/ledger/burial.h says; 0 = not buried.
    uint8_t pedals = 0, energised = 0, in_contact = 0, engaged = 0;
    Tissue touched = Tissue::kSkin;
};

/// A suture needle, and its thread from the needle to the tail as it is seen (needle_snapshot.h):
/// over the tissue from the swage to where it goes in, along its channels, and a stretch of its
/// free end.
struct NeedleSnapshot {
    uint8_t present = 0;
    int8_t driver = -1;  ///< Tool whose jaws hold it, -1 = none.
    Pose pose;           ///< X_WN.
    float arc_m = 0, wire_radius_m = 0;
    std::vector<std::array<float, 3>> thread;  ///< [m]; empty = no thread.
    std::vector<std::array<float, 3>>
        loop;  ///< At its tail [m], closed; empty = none, or not seen.
};

/// Standing fluid by cells, debris, jets; empty in scenes without irrigation.
struct FluidSnapshot {
    double x_m = 0, y_m = 0, cell_m = 1;  ///< Of the grid.
    int columns = 0, rows = 0;
    std::vector<float> ground_m, depth_m, blood_m;  ///< (columns x rows); blood as a depth.
    struct Speck {
        std::array<float, 3> at_m{};
        float radius_m = 0;
        uint8_t blood = 0, loose = 0;
    };
    std::vector<Speck> specks;  ///< Debris that is left.
    std::array<float, kMaxTools> jet_m{}, jet_radius_m{}, jet_end_radius_m{};  ///< 0 = no jet.
};

struct Snapshot {
    int64_t frame = 0;
    double time_s = 0;
    std::vector<std::array<float, 3>> x;  ///< (V) [m]
    std::vector<std::array<float, 4>>
        damage;  ///< (V) blanch (Omega clamped 0..1), dried 0..1, charred 0..1, temperature [C]
    std::vector<SurfaceTriangle> triangles;  ///< Current surface.
    uint32_t surface_version = 0;
    std::vector<std::array<int32_t, 3>> patch;  ///< Triangles of a patch; empty = there is none.
    /// (V) At rest [m]; empty while every vertex is where the mesh has it. Cuts slide some.
    std::vector<std::array<float, 3>> rest;
    int32_t slides = 0;  ///< Changes with `rest`.
    std::array<ToolSnapshot, kMaxTools> tools{};
    int tool_count = 0;
    NeedleSnapshot needle;
    FluidSnapshot fluid;
    std::vector<uint8_t> contour_cut;           ///< Per planned-contour point.
    std::vector<std::array<float, 3>> contour;  ///< Deformed planned contour [m].
    std::vector<int32_t> origin;  ///< Of the copies that cutting made: vertex of the field (V0 ..).
    std::vector<std::array<float, 3>> resect_line;  ///< Deformed outline of the marked tissue [m].
    std::vector<uint8_t> resect_cut;                ///< Per point: parted there.
    int free_sectors = 0, pieces_out = 0;
    float resected_fraction = -1;  ///< gone_share().
    Phase phase = Phase::kInspect;
    float cut_fraction = 0;  ///< ring_share().
    float vapour_rate_m3_s = 0;
    float placode_peak_cem43_min = 0, placode_peak_c = 37;
    uint32_t step_flags = 0;
    float physics_hz = 0, servo_p999_us = 0;  ///< Filled by the loop, for the performance overlay.
    int substeps = 0;
    uint8_t finished = 0, paused = 0;
    uint8_t slit = 0;                ///< The scene has one (Scene::slit).
    std::array<char, 64> message{};  ///< Newest warning, one short phrase; empty = none.
    float message_age_s = 1e9f;
};

/// Copies the visible part of `state`. Reuses the capacity of `out`: allocates on first use only.
void fill_snapshot(const Scene& scene, const State& state, Snapshot& out);

}  // namespace placode::sim
