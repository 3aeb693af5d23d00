// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A bar held at one end and twisted at the other: places and reactions of the same runs. A method
// may put every vertex right and still give a wrong force: the reaction is made of strains, which
// are differences of places.
#include <Eigen/Geometry>
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kLength = 0.04, kWidth = 0.01, kEdge = 2e-3, kTwist = 0.5;  // m, rad

/// Every vertex of the far end has a region of its own, which carries it round the axis.
VerificationScene twisted_bar() {
    const int n = static_cast<int>(std::lround(kWidth / kEdge));
    VerificationScene scene =
        accuracy_scene(Vec3(kLength, kWidth, kWidth), {4 * n, n, n}, 5e3, 0.45);
    scene.held.push_back(held_plane(0, 0, 7));
    const Vec3 middle(kLength, kWidth / 2, kWidth / 2);
    const Mat3 turn = Eigen::AngleAxisd(kTwist, Vec3::UnitX()).toRotationMatrix();
    for (const Vec3& p : scene.mesh.rest) {
        if (p.x() < kLength - 1e-9) continue;
        HeldRegion region;
        region.box = {p, p};
        region.displacement_m = turn * (p - middle) + middle - p;
        region.ramp_s = 0.2;
        region.pointer = "/prescribed/" + std::to_string(scene.held.size() - 1);
        scene.held.push_back(region);
    }
    scene.material.damping_per_s = 60;
    scene.end_s = 1.2;
    scene.sample_s = 1;
    return scene;
}

/// |f - reference| / |reference| over what holds the twisted end, L2.
double reaction_error(const SolveResult& result, const SolveResult& reference) {
    double off = 0, size = 0;
    for (size_t i = 1; i < result.reactions.size(); ++i) {
        off += (result.reactions[i].force_n - reference.reactions[i].force_n).squaredNorm();
        size += reference.reactions[i].force_n.squaredNorm();
    }
    return std::sqrt(off / size);
}

}  // namespace

void measure_twist(AccuracyTable& table) {
    VerificationScene scene = twisted_bar();
    use_method(scene, {SolveMethod::kNewton, 1});
    const SolveResult reference = solve(scene);
    for (const MethodChoice& choice :
         std::initializer_list<MethodChoice>{{SolveMethod::kVbd, 4},
                                             {SolveMethod::kVbd, 8},
                                             {SolveMethod::kVbd, 8, true},
                                             {SolveMethod::kXpbd, 4},
                                             {SolveMethod::kXpbd, 8},
                                             {SolveMethod::kXpbd, 16},
                                             {SolveMethod::kXpbd, 16, true},
                                             {SolveMethod::kXpbdPair, 16}}) {
        use_method(scene, choice);
        const SolveResult result = solve(scene);
        AccuracyRow row = row_of(scene, result, "twisted bar",
                                 "40 x 10 x 10 mm, 5 kPa, nu 0.45, 2 mm, one end turned by 0.5 rad",
                                 "displacement against newton on the same mesh (L2)", kEdge);
        row.value = row.error = displacement_error(scene, result, reference);
        table.add(row);
        set_text(row.quantity, "reaction at the turned end against newton (L2)");
        row.value = row.error = reaction_error(result, reference);
        table.add(row);
    }
}

}  // namespace placode::sim
