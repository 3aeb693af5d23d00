// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a pair of blades is about to cut, and the snip so far.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/fields.h"
#include "sim/core/geometry.h"
#include "sim/core/tissue.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {

struct Scene;
struct State;

inline constexpr float kBladesOpen = 0.08F;  ///< Blades nearer than this count as closed [rad].
inline constexpr int32_t kMetNothing = -1;   ///< planned_count of blades that closed on nothing.
inline constexpr int kMostPlanned = 1024;

/// One face that the blades are about to part.
struct PlannedFace {
    int32_t face = -1;  ///< 4 tet + local vertex opposite
    float z_m = 0;      ///< Along the blades, 0 at the tips.
};
template <class Visit>
void fields(Of<PlannedFace> auto& s, Visit&& visit) {
    auto& [face, z_m] = s;
    visit.state(face, z_m);
}

/// One pair of blades.
struct Scissors {
    std::array<PlannedFace, kMostPlanned> planned{};
    int32_t planned_count = 0, next = 0;
    float jaw_rad = 0;    ///< Opening in the last frame; while they close, the least so far.
    float start_rad = 0;  ///< Opening from which they close.
    uint8_t closing = 0;
    uint8_t sliding = 0;  ///< Vertices still slide onto the plane: blade_slides.h.
    float slid_to_m = 0;  ///< Along the blades, as PlannedFace: done up to here.
    Pose plane;           ///< Of the blades when they began to close, from W to T.
    /// (V + spares) Where the vertices were then, in T; slides move them. Only where cuts snap.
    std::vector<std::array<float, 3>> met_T;
    int32_t met_count = 0;  ///< Later vertices are copies: where they are now counts.
    // The current snip, for the ledger.
    float area_m2 = 0, placode_m2 = 0, depth_m = 0;
    std::array<float, kTissueCount> area_of{};  ///< By tissue, where it was cut.
    Vec3 rest_sum = Vec3::Zero();
    int32_t faces = 0, tet = -1;
    int32_t refused = 0;  ///< Faces that stayed whole for want of spare vertices.
};
template <class Visit>
void fields(Of<Scissors> auto& s, Visit&& visit) {
    auto& [planned, planned_count, next, jaw_rad, start_rad, closing, sliding, slid_to_m, plane,
           met_T, met_count, area_m2, placode_m2, depth_m, area_of, rest_sum, faces, tet, refused] =
        s;
    visit.state(planned, planned_count, next, jaw_rad, start_rad, closing, sliding, slid_to_m,
                plane, met_T, met_count, area_m2, placode_m2, depth_m, area_of, rest_sum, faces,
                tet, refused);
}

/// tan of half an opening without the library's last bit: angles stay below 0.8 rad.
[[nodiscard]] inline double half_tangent(double angle) noexcept {
    const double a = angle / 2, a2 = a * a;
    return a * (1 + a2 * (1.0 / 3 + a2 * (2.0 / 15 + a2 * 17.0 / 315)));
}

/// Where blades met a vertex when they began to close, in T.
[[nodiscard]] inline Vec3 met_at(const Scissors& s, const SoftBodyState& body, int v) noexcept {
    if (v >= s.met_count) return s.plane * position(body, v);
    const auto& p = s.met_T[static_cast<size_t>(v)];
    return {p[0], p[1], p[2]};
}

/// Blades that stand open are thin edges: they pass beside tissue instead of pushing it.
[[nodiscard]] bool blades_open(const Scene& scene, const State& state, int tool) noexcept;

/// Closed blades that lie in the gap of their own snip, as far as they know: they do not burst it.
[[nodiscard]] bool blades_in_cut(const Scene& scene, const State& state, int tool) noexcept;

}  // namespace placode::sim
