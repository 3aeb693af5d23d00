// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/cutting/scissors.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/cutting/blade_slides.h"
#include "sim/cutting/cutting.h"
#include "sim/cutting/separation.h"
#include "sim/solver/topology.h"
#include "sim/world/add_event.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr float kBegin = 0.01f;    // closing by so much begins a snip [rad]
constexpr double kPastTip = 2e-4;  // the tips' own roundness [m]
constexpr double kEdge = 1e-4;     // tissue this far beside the blades' edges is still met [m]
constexpr int kFacesPerFrame = 24;
constexpr double kSlidPad = 4e-4;  // half of a long edge next to the planned incision [m]

/// Of a tet, where the blades met it.
Vec3 centroid_T(const Scene& scene, const State& state, const Scissors& s, int tet) noexcept {
    Vec3 sum = Vec3::Zero();
    if (s.met_count > 0) {
        for (const int32_t v : corners(scene.body, state.body, tet))
            sum += met_at(s, state.body, v);
        return sum / 4;
    }
    for (const int32_t v : corners(scene.body, state.body, tet)) sum += position(state.body, v);
    return s.plane * Vec3(sum / 4);
}

Vec3 face_centre_T(const Scene& scene, const State& state, const Scissors& s, int tet,
                   int f) noexcept {
    const auto& c = corners(scene.body, state.body, tet);
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
        if (k != f)
            sum += s.met_count > 0 ? met_at(s, state.body, c[k]) : position(state.body, c[k]);
    }
    return s.met_count > 0 ? Vec3(sum / 3) : s.plane * Vec3(sum / 3);
}

/// Plans the faces around one tet: those to neighbours whose centroid lies across the plane.
void plan_tet(const Scene& scene, State& state, Scissors& s, int t, double length,
              double slope) noexcept {
    const Vec3 here = centroid_T(scene, state, s, t);
    if (here.x() < 0) return;  // each face once, from its positive side
    for (int f = 0; f < 4; ++f) {
        const int other = linked_across(scene, state, t, f);
        if (other < 0) continue;
        if (centroid_T(scene, state, s, other).x() >= 0) continue;
        const Vec3 p = face_centre_T(scene, state, s, t, f);
        // Written so that a place that is no number is not between the blades.
        if (!(p.z() <= kPastTip && p.z() >= -length)) continue;
        if (!(std::abs(p.y()) <= slope * (length + p.z()) + kEdge)) continue;
        if (s.planned_count == kMostPlanned) {
            state.flags |= kCutRefused;
            return;
        }
        s.planned[s.planned_count++] = {4 * t + f, static_cast<float>(p.z())};
    }
}

void plan(const Scene& scene, State& state, int tool) noexcept {
    Scissors& s = state.scissors[tool];
    s.planned_count = s.next = 0;
    const double length = scene.tools[tool].tip_length_m;
    const double slope = half_tangent(s.start_rad);
    const double pad = state.scratch->longest_edge_m;
    const double wide = slope * length + kEdge + pad;
    auto& seen = state.scratch->tet_seen;
    const auto stamp = ++state.scratch->stamp;
    for (int v = 0; v < static_cast<int>(state.body.x.size()); ++v) {
        const Vec3 p = met_at(s, state.body, v);
        if (std::abs(p.x()) > pad || std::abs(p.y()) > wide || p.z() > pad ||
            p.z() < -length - pad) {
            continue;
        }
        for (const int32_t t : tets_around(scene.body, state.body, v)) {
            if (!state.body.tet_alive[t] || seen[t] == stamp) continue;
            seen[t] = stamp;
            plan_tet(scene, state, s, t, length, slope);
        }
    }
    std::sort(s.planned.begin(), s.planned.begin() + s.planned_count,
              [](const PlannedFace& a, const PlannedFace& b) {
                  return a.z_m != b.z_m ? a.z_m < b.z_m : a.face < b.face;
              });
}

BladeReach reach_of(const Scene& scene, const State& state, int tool) noexcept {
    return {scene.tools[tool].tip_length_m, half_tangent(state.scissors[tool].start_rad), kSlidPad};
}

/// Blades that begin to close: what they meet first is moved onto their plane, if the scene does.
void begin_snip(const Scene& scene, State& state, int tool) noexcept {
    Scissors& s = state.scissors[tool];
    s.closing = 1;
    s.plane = state.tools[tool].proxy.inverse();
    s.planned_count = s.next = 0;
    begin_slides(scene, state, s, reach_of(scene, state, tool));
    if (s.sliding == 0) plan(scene, state, tool);
}

/// One frame of slides; plans the faces behind the last one.
void slide(const Scene& scene, State& state, int tool) noexcept {
    Scissors& s = state.scissors[tool];
    if (slide_to_blades(scene, state, s, reach_of(scene, state, tool))) return;
    s.sliding = 0;
    plan(scene, state, tool);
}

void note(const Scene& scene, const State& state, Scissors& s, int tet, int f) noexcept {
    const auto& c = corners(scene.body, state.body, tet);
    std::array<Vec3, 3> x;
    for (int i = 0; i < 3; ++i) x[i] = rest_place(scene.body, state.body, c[kTetFaces[f][i]]);
    const double area = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
    const int other = scene.surface.neighbours()[tet][f];
    const Tissue mine = scene.body.mesh().tissue[tet], yours = scene.body.mesh().tissue[other];
    s.area_m2 += static_cast<float>(area);
    s.area_of[static_cast<int>(mine)] += static_cast<float>(area);
    // Parting the placode from what it hangs on releases it; parting it from itself cuts it.
    if (mine == Tissue::kPlacode && yours == Tissue::kPlacode) {
        s.placode_m2 += static_cast<float>(area);
    }
    s.depth_m = std::max(s.depth_m, static_cast<float>(tet_depth(scene, tet)));
    s.rest_sum += (x[0] + x[1] + x[2]) / 3;
    s.tet = tet;
    ++s.faces;
}

/// Tissue that was left whole because the scene has no vertices left.
void note_refused(State& state, int tool) noexcept {
    Scissors& s = state.scissors[tool];
    if (s.refused == 0) return;
    Event e = tool_event(state, EventKind::kNoRoomToCut, tool);
    e.value = static_cast<float>(s.refused);
    add_event(state, e);
    s.refused = 0;
}

void end_snip(State& state, int tool) noexcept {
    Scissors& s = state.scissors[tool];
    note_refused(state, tool);
    if (s.faces > 0) {
        Event e;
        e.time_s = state.time_s;
        e.kind = EventKind::kSnipped;
        e.tool = static_cast<int8_t>(tool);
        e.tissue = static_cast<Tissue>(std::max_element(s.area_of.begin(), s.area_of.end()) -
                                       s.area_of.begin());
        e.value = s.area_m2;
        e.value2 = s.depth_m;
        e.element = s.tet;
        for (int k = 0; k < 3; ++k) {
            e.rest_position_m[k] = static_cast<float>(s.rest_sum[k] / s.faces);
        }
        add_event(state, e);
        if (s.placode_m2 > 0) {
            e.kind = EventKind::kPlacodeCut;
            e.tissue = Tissue::kPlacode;
            e.value = s.placode_m2;
            add_event(state, e);
        }
    }
    s.area_m2 = s.placode_m2 = s.depth_m = 0;
    s.area_of.fill(0);
    s.rest_sum = Vec3::Zero();
    s.faces = 0;
}

void close(const Scene& scene, State& state, int tool, float jaw) noexcept {
    Scissors& s = state.scissors[tool];
    const double length = scene.tools[tool].tip_length_m + kPastTip;
    // The crossing runs from hinge to tips, in step with the closing.
    const double share = 1 - jaw / std::max(s.start_rad, kBladesOpen);
    const double reached = -scene.tools[tool].tip_length_m + share * length;
    int cut = 0;
    while (s.next < s.planned_count && s.planned[s.next].z_m <= reached && cut < kFacesPerFrame) {
        const int face = s.planned[s.next++].face, t = face / 4, f = face % 4;
        if (!state.body.tet_alive[t] || state.surface.on_surface(t, f)) continue;
        const int other = scene.surface.neighbours()[t][f];
        if (!state.body.tet_alive[other]) continue;
        if (cut_face(scene, state, t, f)) {
            note(scene, state, s, t, f);
            ++cut;
        } else {
            ++s.refused;  // it is not on the surface: there are no spare vertices
        }
    }
    if (blades_in_cut(scene, state, tool)) state.tools[tool].contact_share = 0;
}

}  // namespace

void run_scissors(const Scene& scene, State& state) noexcept {
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        if (scene.tools[t].kind != ToolKind::kScissors) continue;
        Scissors& s = state.scissors[t];
        const ToolState& tool = state.tools[t];
        float jaw = s.jaw_rad;
        if (std::isfinite(tool.jaw_rad)) {
            jaw = std::clamp(tool.jaw_rad, 0.0f, static_cast<float>(scene.tools[t].jaw_open_rad));
        }
        // A hand or an encoder that gives way a little has not opened the blades again.
        if (s.closing && jaw < s.jaw_rad + kBegin) jaw = std::min(jaw, s.jaw_rad);
        if (!tool.engaged) {
            end_snip(state, t);
            s.closing = s.sliding = 0;
            s.planned_count = s.next = 0;
            s.start_rad = std::min(s.start_rad, jaw);  // what closed meanwhile has cut nothing
        } else if (jaw > s.jaw_rad) {
            if (s.closing) end_snip(state, t);
            s.start_rad = s.closing ? jaw : std::max(s.start_rad, jaw);
            s.closing = s.sliding = 0;
        } else if (!s.closing && s.start_rad > kBladesOpen && jaw < s.start_rad - kBegin) {
            begin_snip(scene, state, t);
            close(scene, state, t, jaw);
        } else if (s.closing) {
            if (s.sliding) slide(scene, state, t);
            close(scene, state, t, jaw);
            if (jaw <= 0 && !s.sliding && s.next >= s.planned_count) {
                end_snip(state, t);
                if (s.planned_count == 0) s.planned_count = kMetNothing;
                s.closing = 0;
                s.start_rad = 0;
            }
        }
        // Closed blades touch what open ones did not, perhaps deep inside: that comes up slowly.
        if (s.jaw_rad > kBladesOpen && jaw <= kBladesOpen) state.tools[t].contact_share = 0;
        s.jaw_rad = jaw;
    }
}

}  // namespace placode::sim
