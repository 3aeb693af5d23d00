// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/field_suture.h"

#include <algorithm>
#include <numbers>

#include "sim/core/portable_math.h"

namespace placode::sim {
namespace {

constexpr double kHeldShare = 1.0 / 3;  // of the jaws' length behind their tips
constexpr double kDegree = std::numbers::pi / 180;

/// The wire goes across the jaws, its swage to the right (+x of T).
Pose in_jaws(const FieldSuture& start, const Needle& needle, const ToolSpec& driver) {
    const ArcPoint held = needle.at(start.held_share * needle.arc_m());
    const SineAndCosine plane = sin_cos_portable(start.plane_deg * kDegree);
    const Vec3 back_T = Vec3::UnitX(), radial_T(0, plane.cosine, plane.sine);
    Mat3 to_T, to_N;
    to_T << radial_T, back_T, radial_T.cross(back_T);
    to_N << held.radial, held.back, held.radial.cross(held.back);
    const Quat q(Mat3(to_T * to_N.transpose()));
    return {Vec3(0, 0, -kHeldShare * driver.tip_length_m) - q * held.place_m, q};
}

}  // namespace

void add_suture(const OperativeFieldSpec& spec, Scene& scene) {
    if (!spec.suture) return;
    const FieldSuture& start = *spec.suture;
    SutureSpec suture = start.suture;
    suture.gravity_m_s2 = spec.solver.gravity_m_s2;
    suture.floor_m = 0;
    for (const Vec3& x : scene.body.mesh().rest) suture.floor_m = std::min(suture.floor_m, x.z());
    scene.suture.emplace(suture);
    NeedleStart& out = scene.needle_start;
    out.in_jaws = start.in_jaws;
    if (start.in_jaws) {
        const auto driver =
            std::find_if(spec.tools.begin(), spec.tools.end(),
                         [](const ToolSpec& t) { return t.kind == ToolKind::kNeedleDriver; });
        out.held_arc_m = start.held_share * scene.suture->needle().arc_m();
        out.X_TN = in_jaws(start, scene.suture->needle(), *driver);
    } else {
        const SineAndCosine half = sin_cos_portable(start.yaw_deg * kDegree / 2);
        out.X_WN = {start.position_m, Quat(half.cosine, 0, 0, half.sine)};
    }
}

}  // namespace placode::sim
