// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/step/needle_jaws.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/shared_hand.h"
#include "sim/cutting/grasp.h"
#include "sim/step/needle_holds.h"
#include "sim/suture/needle_motion.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

constexpr int kWirePlaces = 129;    // looked at along the arc: every 0.13 mm of 17
constexpr double kReach = 0.0006;   // wire this far beyond the tips is still bitten [m]
constexpr double kCentring = 0.05;  // of its way to the jaws' middle that the wire goes in a frame

/// A driver that makes room for another instrument keeps a needle that is in no tissue: both wait
/// outside of the port.
void carry_out(const Scene& scene, State& state, int t) noexcept {
    Suturing& s = state.suturing;
    SutureState& needle = s.needle[0];
    s.placed = 0;
    needle.needle.p = scene.tools[as_index(t)].pivot_m;
    needle.v = needle.w = Vec3::Zero();
    needle.hold.force_n = needle.hold.torque_n_m = Vec3::Zero();
}

/// As it was held; the driver's jaws are closed when it comes in.
void bring_back(const Scene& scene, State& state) noexcept {
    Suturing& s = state.suturing;
    const ToolState& tool = state.tools[as_index(s.driver)];
    if (tool.engaged == 0) return;
    SutureState& needle = s.needle[0];
    needle.needle = tool.proxy * needle.hold.X_HN;
    needle.needle.q.normalize();
    needle.hold.hand = tool.proxy;
    s.placed = 1;
    const double meet = grip_angle(scene.tools[as_index(s.driver)]);
    s.locked = static_cast<double>(tool.jaw_rad) <= meet ? kLockedUntilOpened : kLockedUntilClosed;
}

/// Closed jaws bring the wire to their middle.
void centre_wire(const Scene& scene, SutureState& needle, NeedleHold& hold) noexcept {
    const double before = hold_energy(*scene.suture, hold, needle.needle);
    hold.X_HN.p.y() -= kCentring * (hold.X_HN * hold.held_N).y();
    needle.work.hand += hold_energy(*scene.suture, hold, needle.needle) - before;
}

}  // namespace

double wire_between(const ToolSpec& spec, const Pose& X_WT, const Needle& needle,
                    const Pose& X_WN) noexcept {
    const Pose X_TN = X_WT.inverse() * X_WN;
    // As tissue between jaws (sim/cutting/grasp.cpp): they meet at an angle.
    const double half_angle = std::max(0.0, grip_angle(spec)) / 2;
    const double slope = half_angle + half_angle * half_angle * half_angle / 3;
    double best_m = -1, best2 = 0;
    for (int i = 0; i < kWirePlaces; ++i) {
        const double s = needle.arc_m() * i / (kWirePlaces - 1);
        const Vec3 p = X_TN * needle.at(s).place_m;
        if (p.z() > kReach || p.z() < -spec.tip_length_m) continue;
        if (std::abs(p.x()) > spec.jaw_width_m / 2) continue;
        const double gap = std::max(slope * (spec.tip_length_m + p.z()), 0.25 * spec.jaw_touch_m);
        if (std::abs(p.y()) > gap + needle.spec().wire_radius_m) continue;
        const double off2 = p.x() * p.x() + p.y() * p.y();
        if (best_m >= 0 && off2 >= best2) continue;
        best_m = s;
        best2 = off2;
    }
    return best_m;
}

void place_in_jaws(const Scene& scene, State& state) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    if (s.driver >= 0) return bring_back(scene, state);
    for (size_t t = 0; t < scene.tools.size(); ++t) {
        if (scene.tools[t].kind != ToolKind::kNeedleDriver || state.tools[t].engaged == 0) continue;
        s.needle[0].needle = state.tools[t].proxy * scene.needle_start.X_TN;
        s.needle[0].needle.q.normalize();
        s.placed = 1;
        s.locked = kLockedUntilClosed;
        begin_hold(scene, state, static_cast<int>(t), scene.needle_start.held_arc_m);
        return;
    }
}

void update_needle_jaws(const Scene& scene, State& state, double dt) noexcept {
    assert(scene.suture && !state.suturing.needle.empty());
    Suturing& s = state.suturing;
    if (s.placed == 0) return;
    SutureState& needle = s.needle[0];
    // It slid out of the jaws.
    if (s.handover.second >= 0 && needle.second.hold.held == 0)
        end_hold(scene, state, s.handover.second);
    if (s.driver >= 0 && needle.hold.held == 0) end_hold(scene, state, s.driver);
    for (int t = 0; t < static_cast<int>(scene.tools.size()); ++t) {
        const ToolSpec& spec = scene.tools[as_index(t)];
        if (spec.kind != ToolKind::kNeedleDriver) continue;
        const ToolState& tool = state.tools[as_index(t)];
        Grasp& jaws = state.grasps[as_index(t)];
        const auto meet = static_cast<float>(grip_angle(spec));
        const float jaw = std::isfinite(tool.jaw_rad) ? std::max(0.0F, tool.jaw_rad) : jaws.jaw_rad;
        const bool closed = jaw <= meet, open = jaw > kLetGo * meet;
        if (s.driver == t) {
            const bool awaits = s.locked == kLockedUntilEngaged && tool.engaged == 0;
            if (!awaits && s.locked == kLockedUntilEngaged) s.locked = kLockedUntilClosed;
            if (s.locked == kLockedUntilOpened)
                s.locked = open ? kLockedUntilClosed : kLockedUntilOpened;
            else if (closed && !awaits)
                s.locked = 0;
            if (!awaits && tool.engaged == 0 && s.handover.second < 0 &&
                shares_hand(scene.tools, spec) && needle_in_the_open(needle)) {
                carry_out(scene, state, t);
            } else if (!awaits && (tool.engaged == 0 || (open && s.locked == 0))) {
                end_hold(scene, state, t);
            } else {
                s.held_s += static_cast<float>(dt);
                s.peak_n = std::max(s.peak_n, static_cast<float>(needle.hold.force_n.norm()));
                centre_wire(scene, needle, needle.hold);
            }
        } else if (s.handover.second == t) {
            if (tool.engaged == 0 || open)
                end_hold(scene, state, t);
            else
                centre_wire(scene, needle, needle.second.hold);
        }
        if (open) {
            jaws.shut = 0;
        } else if (closed && jaws.shut == 0 && tool.engaged != 0) {
            jaws.shut = 1;
            const double at =
                hold_of(state, t) != nullptr
                    ? -1
                    : wire_between(spec, tool.proxy, scene.suture->needle(), needle.needle);
            if (at >= 0) begin_hold(scene, state, t, at);
        }
        jaws.jaw_rad = jaw;
    }
    count_holds(scene, state, dt);
}

}  // namespace placode::sim
