// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a pair of jaws holds.
#include <array>
#include <cstdint>
#include "sim/core/fields.h"
#include "sim/core/geometry.h"
#include "sim/core/tissue.h"

namespace placode::sim {

inline constexpr int kMaxGrasped = 96;

/// A vertex between the jaws.
struct GraspedVertex {
    int32_t vertex = -1;
    std::array<float, 3> at_T{};  ///< Place in T, y as if the jaws still stood where they met it.
};
template <class Visit>
void fields(Of<GraspedVertex> auto& s, Visit&& visit) {
    auto& [vertex, at_T] = s;
    visit.state(vertex, at_T);
}

/// One pair of jaws. count == 0: holds nothing.
struct Grasp {
    std::array<GraspedVertex, kMaxGrasped> held{};
    int32_t count = 0;
    int32_t grasped = 0;           ///< Vertices when the jaws closed.
    float jaw_rad = 1;             ///< Opening in the last frame.
    float meet_rad = 0;            ///< Opening at which the jaws met the tissue.
    float pinch_n = 0;             ///< Jaw force N.
    float area_m2 = 0;             ///< Bitten area.
    float held_s = 0, peak_n = 0;  ///< Since the grasp; peak of the traction.
    float slip_m = 0;              ///< Way slipped in the current slip.
    float slip_shut_m = 0;         ///< The same, when the jaws last did not open.
    float slip_pause_s = 0;        ///< Until a slip counts as ended.
    float slip_peak_n = 0;
    float traction_s = 0, traction_peak_n = 0;  ///< Current spell above the tissue's limit.
    float traction_pause_s = 0;                 ///< Below it since then, until the spell ends.
    Tissue tissue = Tissue::kSkin;              ///< Most of what is held.
    uint8_t shut = 0;     ///< The jaws have met (with or without tissue): open them to grasp anew.
    uint8_t crushed = 0;  ///< Crushing is in the ledger.
    Vec3 force_n = Vec3::Zero();    ///< Of the tissue on the jaws, mean over the last frame.
    std::array<float, 3> rest_m{};  ///< Where at rest.
    int32_t tet = -1;               ///< A tet there.
};
template <class Visit>
void fields(Of<Grasp> auto& s, Visit&& visit) {
    auto& [held, count, grasped, jaw_rad, meet_rad, pinch_n, area_m2, held_s, peak_n, slip_m,
           slip_shut_m, slip_pause_s, slip_peak_n, traction_s, traction_peak_n, traction_pause_s,
           tissue, shut, crushed, force_n, rest_m, tet] = s;
    visit.state(held, count, grasped, jaw_rad, meet_rad, pinch_n, area_m2, held_s, peak_n, slip_m,
                slip_shut_m, slip_pause_s, slip_peak_n, traction_s, traction_peak_n,
                traction_pause_s, tissue, shut, crushed, force_n, rest_m, tet);
}

}  // namespace placode::sim
