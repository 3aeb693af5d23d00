// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/core/as_index.h"
#include "sim/core/portable_math.h"
#include "sim/fluid/jet_law.h"
#include "sim/fluid/pool.h"
#include "sim/fluid/surface_ray.h"
#include "sim/fluid/tip_flow.h"

namespace placode::sim {
namespace {

constexpr double kJetReachM = 0.08;
constexpr std::array<int, 4> kRings{1, 6, 12, 18};
constexpr int kRays = 37;
constexpr double kPushShearPa = 1;  // what is loose on wet ground goes with more than that
constexpr double kPushM_s = 0.03;   // away from where the jet lands
constexpr double kSplash = 3;       // the flow along the wall carries water on, in widths again
constexpr double kShearReach = 8;   // in widths of the jet: farther it does nothing

/// Where a line of the jet runs: its distance from the axis in widths b, and its direction there.
/// Momentum within r is 1 - exp(-(r/b)^2); every line stands in the middle of its share.
std::array<Vec2, kRays> jet_lines() noexcept {
    std::array<Vec2, kRays> out{};
    size_t n = 0;
    int before = 0;
    for (const int count : kRings) {
        const double share = (before + 0.5 * count) / kRays;
        const double r = count == 1 ? 0 : std::sqrt(-log_portable(1 - share));
        for (int k = 0; k < count; ++k) {
            const double a = 2 * std::numbers::pi * (k + 0.5 * (count % 4)) / count;
            const SineAndCosine of = sin_cos_portable(a);
            out[n++] = r * Vec2(of.cosine, of.sine);
        }
        before += count;
    }
    return out;
}

const std::array<Vec2, kRays> kLines = jet_lines();

Vec3 at_rest(const Scene& scene, const State& state, const SurfaceTriangle& face,
             const Vec3& weight) noexcept {
    Vec3 p = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        p += weight[k] *
             scene.body.mesh().rest[as_index(origin_of(state.body, face.vertex[as_index(k)]))];
    return p;
}

/// Shear of the jet on debris: loosens it, or pushes what lies loose.
void wash_debris(const Scene& scene, State& state, const Pose& tip, double hit_m,
                 double dt_s) noexcept {
    const Irrigation& irrigation = *scene.irrigation;
    IrrigationState& now = state.irrigation;
    const double width = jet_width_m(irrigation.jet, hit_m);
    for (size_t i = 0; i < now.debris.size(); ++i) {
        DebrisNow& one = now.debris[i];
        if (one.fate != DebrisFate::kStuck && one.fate != DebrisFate::kLoose) continue;
        const Vec3 place = debris_place(scene, state, i), seen = tip.inverse() * place;
        const double r = seen.head<2>().norm();
        // What lies behind a fold from where the jet lands is not reached.
        if (r > kShearReach * width || std::abs(seen.z() - hit_m) > kShearReach * width) continue;
        const double shear = jet_shear_pa(irrigation.jet, hit_m, r);
        const auto kind = static_cast<size_t>(irrigation.debris[i].kind);
        if (one.fate == DebrisFate::kLoose) {
            if (shear < kPushShearPa) continue;
            const Vec3 middle = tip * Vec3(0, 0, hit_m);
            const Vec2 away = (place - middle).head<2>();
            if (!(away.norm() > 1e-6)) continue;
            const Vec2 offset = kPushM_s * dt_s * away.normalized();
            for (int k = 0; k < 2; ++k) one.at_m[as_index(k)] += static_cast<float>(offset[k]);
            continue;
        }
        if (shear < irrigation.law.adhesion_pa[kind]) continue;
        one.dose_s += static_cast<float>(dt_s);
        if (static_cast<double>(one.dose_s) < irrigation.law.hold_s[kind]) continue;
        one.at_m = {static_cast<float>(place.x()), static_cast<float>(place.y())};
        // A spot of blood dissolves; a crumb floats off.
        const bool blood = irrigation.debris[i].kind == DebrisKind::kBlood;
        const int32_t cell = irrigation.grid.cell_at(place.x(), place.y());
        one.fate = blood ? DebrisFate::kRunOff : DebrisFate::kLoose;
        if (blood) add_fluid(now.pool, cell, irrigation.law.blood_m3, irrigation.law.blood_m3);
    }
}

}  // namespace

void load_vertex(const Scene& scene, State& state, int32_t vertex, const Vec3& force_n) noexcept {
    if (scene.irrigation->bears[as_index(vertex)] == 0) return;
    IrrigationState& now = state.irrigation;
    if (now.listed[as_index(vertex)] == 0) {
        now.listed[as_index(vertex)] = 1;
        now.loaded[as_index(now.loaded_count++)] = vertex;
    }
    auto& load = now.load_n[as_index(vertex)];
    for (int k = 0; k < 3; ++k) load[as_index(k)] += static_cast<float>(force_n[k]);
}

void run_jet(const Scene& scene, State& state, int t, double dt_s) noexcept {
    const Irrigation& irrigation = *scene.irrigation;
    IrrigationState& now = state.irrigation;
    const Pose& tip = state.tools[as_index(t)].proxy;
    const Vec3 along = tip.q * Vec3::UnitZ();
    const RayHit axis = first_hit(state, tip.p, along, kJetReachM);
    now.tips[as_index(t)].jet_m =
        static_cast<float>(axis.triangle < 0 ? kJetReachM : axis.distance_m);
    const double flow = jet_flow_m3_s(irrigation.jet) * dt_s;
    now.jet_m3 += flow;
    const double hit_m = std::max(axis.distance_m, 1e-4);
    const double width = jet_width_m(irrigation.jet, hit_m), bore = jet_width_m(irrigation.jet, 0);
    const Vec3 middle = tip * Vec3(0, 0, hit_m);
    for (const Vec2& line : kLines) {
        const Vec3 from = tip * Vec3(bore * line.x(), bore * line.y(), 0);
        const Vec3 offset = tip * Vec3(width * line.x(), width * line.y(), hit_m) - from;
        const RayHit hit = first_hit(state, from, offset.normalized(), kJetReachM);
        if (hit.triangle < 0) {
            add_fluid(now.pool, -1, flow / kRays, 0);
            continue;
        }
        const SurfaceTriangle& face = state.surface.triangles()[as_index(hit.triangle)];
        const double cosine = std::max(0.0, -along.dot(hit.normal));
        const Vec3 push = -cosine * jet_momentum_n(irrigation.jet) / kRays * hit.normal;
        Vec3 place = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            load_vertex(scene, state, face.vertex[as_index(k)], hit.weight[k] * push);
            place += hit.weight[k] * position(state.body, face.vertex[as_index(k)]);
        }
        const Vec3 lands = place + kSplash * (place - middle);
        const int32_t cell = irrigation.grid.cell_at(lands.x(), lands.y());
        add_fluid(now.pool, cell, flow / kRays, 0);
        if (face.tissue != Tissue::kPlacode) continue;
        const double x = (tip.inverse() * place).z();
        const double pressure = jet_pressure_pa(
            irrigation.jet, x, jet_width_m(irrigation.jet, x) * line.norm(), cosine);
        if (pressure <= now.placode_pa) continue;
        now.placode_pa = pressure;
        if (pressure <= now.peak_pa) continue;
        now.peak_pa = pressure;
        const Vec3 rest = at_rest(scene, state, face, hit.weight);
        for (int k = 0; k < 3; ++k) now.peak_rest_m[as_index(k)] = static_cast<float>(rest[k]);
    }
    if (axis.triangle >= 0) wash_debris(scene, state, tip, axis.distance_m, dt_s);
}

}  // namespace placode::sim
