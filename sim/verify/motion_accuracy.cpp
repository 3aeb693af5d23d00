// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Free motion: period and decay of an oscillation, momentum, energy, free fall.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

struct Oscillation {
    double period_s = 0;
    double decay_per_s = 0;  ///< Of the amplitude.
};

/// The Kuhn tets of a square beam are the same when y and z change places, but not when one of them
/// changes its sign: it bends in the diagonal planes with a frequency for each, and anywhere else
/// with a beat of both.
const Vec3 kPlane = Vec3(0, 1, 1).normalized();

/// Squares left over by the best c + e^(-d t) (a cos w t + b sin w t).
double misfit(const SolveResult& result, double omega, double decay) {
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();  // of the three functions and of z itself
    for (size_t i = 0; i < result.probe_m.size(); ++i) {
        const double t = result.sample_time_s[i], e = std::exp(-decay * t);
        const Vec3 offset = result.probe_m[i][0] - result.probe_m[0][0];
        const Eigen::Vector4d f(1, e * std::cos(omega * t), e * std::sin(omega * t),
                                offset.dot(kPlane));
        sums += f * f.transpose();
    }
    const Eigen::Vector3d right = sums.block<3, 1>(0, 3);
    const Eigen::Vector3d best = sums.topLeftCorner<3, 3>().ldlt().solve(right);
    return sums(3, 3) - best.dot(right);
}

/// The damped sine next to the motion (least squares): higher modes stay out of period and decay.
Oscillation oscillation(const SolveResult& result) {
    double omega = 0, decay = 2, least = 1e300;
    for (double w = 10; w < 150; w += 0.5) {
        for (const double d : {0.5, 2.0, 8.0}) {
            if (const double m = misfit(result, w, d); m < least) {
                least = m;
                omega = w;
                decay = d;
            }
        }
    }
    // Pattern search from the best point of the grid.
    for (double dw = 0.25, dd = 1; dw > 1e-5; dw /= 2, dd /= 2) {
        for (bool better = true; better;) {
            better = false;
            for (const auto& [a, b] : {std::pair{dw, 0.0}, {-dw, 0.0}, {0.0, dd}, {0.0, -dd}}) {
                const double m = misfit(result, omega + a, decay + b);
                if (!(m < least)) continue;
                least = m;
                omega += a;
                decay += b;
                better = true;
            }
        }
    }
    return {static_cast<double>(2 * EIGEN_PI) / omega, decay};
}

/// A soft beam swings about its sag after gravity is switched on; damping 2 / s takes 1 / s off the
/// amplitude. Probe once a frame.
void free_oscillation(AccuracyTable& table) {
    Oscillation truth;
    for (const MethodChoice& choice :
         std::initializer_list<MethodChoice>{{SolveMethod::kExplicit, 40},
                                             {SolveMethod::kExplicit, 16},
                                             {SolveMethod::kVbd, 4},
                                             {SolveMethod::kVbd, 8},
                                             {SolveMethod::kVbd, 16},
                                             {SolveMethod::kVbd, 16, true},
                                             {SolveMethod::kXpbd, 8},
                                             {SolveMethod::kXpbd, 16},
                                             {SolveMethod::kXpbd, 16, true},
                                             {SolveMethod::kXpbdPair, 16},
                                             {SolveMethod::kXpbdPair, 16, true}}) {
        VerificationScene scene = accuracy_scene(Vec3(0.02, 4e-3, 4e-3), {10, 2, 2}, 5e3, 0.45);
        scene.gravity_m_s2 = -0.2 * kPlane;
        scene.material.damping_per_s = 2;
        scene.held.push_back(held_plane(0, 0, 7));
        scene.probes.push_back({"tip", held_plane(0, 0.02, 7).box, "/probes/0"});
        scene.end_s = 1.0;
        use_method(scene, choice);
        const SolveResult result = solve(scene);
        const Oscillation found = oscillation(result);
        if (truth.period_s == 0) truth = found;
        AccuracyRow row = row_of(scene, result, "free oscillation",
                                 "20 x 4 x 4 mm, 5 kPa, nu 0.45, 2 mm, damping 2 / s",
                                 "period against explicit at 25 us", 2e-3);
        set_text(row.unit, "s");
        row.value = found.period_s;
        row.expected = truth.period_s;
        row.error = std::abs(row.value / row.expected - 1);
        row.target = 0.03;
        table.add(row);
        // An implicit step takes w^2 h / 2 off by itself.
        const bool implicit = choice.method != SolveMethod::kExplicit;
        const double omega = static_cast<double>(2 * EIGEN_PI) / truth.period_s;
        set_text(row.quantity, implicit ? "decay of the amplitude against damping / 2 + w^2 h / 2"
                                        : "decay of the amplitude against damping / 2");
        set_text(row.unit, "1/s");
        row.value = found.decay_per_s;
        row.expected = 1 + (implicit ? omega * omega * row.h_s / 2 : 0);
        row.error = std::abs(row.value / row.expected - 1);
        row.target = 0.01;
        table.add(row);
    }
}

/// A free block let go from a stretch of 30 %: nothing outside acts on it.
void conservation(AccuracyTable& table) {
    for (const MethodChoice& choice :
         std::initializer_list<MethodChoice>{{SolveMethod::kExplicit, 20},
                                             {SolveMethod::kVbd, 4},
                                             {SolveMethod::kVbd, 4, true},
                                             {SolveMethod::kVbd, 64, true},
                                             {SolveMethod::kXpbd, 16},
                                             {SolveMethod::kXpbd, 16, true},
                                             {SolveMethod::kXpbd, 64, true},
                                             {SolveMethod::kXpbd, 256, true},
                                             {SolveMethod::kXpbdPair, 16},
                                             {SolveMethod::kXpbdPair, 16, true}}) {
        VerificationScene scene = accuracy_scene(Vec3(8e-3, 4e-3, 4e-3), {8, 4, 4}, 5e3, 0.45);
        scene.start = {StartKind::kStretch, 0.3, 1};
        use_method(scene, choice);
        scene.end_s = 1e-3;
        const SolveResult early = solve(scene);
        scene.end_s = 0.2;
        const SolveResult late = solve(scene);
        const double most = std::max(early.momentum_scale_kg_m_s, late.momentum_scale_kg_m_s);
        const double turn =
            std::max(early.angular_momentum_scale_kg_m2_s, late.angular_momentum_scale_kg_m2_s);
        AccuracyRow row = row_of(scene, late, "conservation", "8 x 4 x 4 mm, let go from 30 %",
                                 "momentum gained in 0.2 s over sum m |v|", 1e-3);
        row.value = row.error = late.momentum_kg_m_s.norm() / most;
        row.target = 1e-6;
        table.add(row);
        set_text(row.quantity, "angular momentum gained in 0.2 s over sum m |r| |v|");
        row.value = row.error = late.angular_momentum_kg_m2_s.norm() / turn;
        row.target = 1e-4;
        table.add(row);
        // The method's own loss: there is no damping in the scene.
        set_text(row.quantity, "energy kept after 0.2 s (1 = none lost or gained)");
        row.expected = early.kinetic_energy_j + early.elastic_energy_j;
        row.value = (late.kinetic_energy_j + late.elastic_energy_j) / row.expected;
        row.expected = 1;
        row.error = std::abs(row.value - 1);
        row.target = choice.method == SolveMethod::kExplicit ? 0.01 : 0;
        table.add(row);
    }
}

void free_fall(AccuracyTable& table) {
    for (const MethodChoice& choice :
         std::initializer_list<MethodChoice>{{SolveMethod::kExplicit, 16},
                                             {SolveMethod::kVbd, 4},
                                             {SolveMethod::kXpbd, 8},
                                             {SolveMethod::kXpbd, 8, true}}) {
        VerificationScene scene = accuracy_scene(Vec3(4e-3, 4e-3, 4e-3), {4, 4, 4}, 5e3, 0.45);
        scene.gravity_m_s2 = Vec3(0, 0, -9.81);
        scene.probes.push_back({"all", {Vec3::Constant(-1), Vec3::Constant(1)}, "/probes/0"});
        scene.end_s = 0.2;
        use_method(scene, choice);
        const SolveResult result = solve(scene);
        AccuracyRow row = row_of(scene, result, "free fall", "4 mm cube, 0.2 s",
                                 "way against g t^2 / 2 (first order: h / t more)", 1e-3);
        set_text(row.unit, "m");
        row.value = result.probe_m.front()[0].z() - result.probe_m.back()[0].z();
        row.expected = 0.5 * 9.81 * 0.04;
        row.error = std::abs(row.value / row.expected - 1);
        row.target = 2e-3;
        table.add(row);
    }
}

}  // namespace

void measure_motion(AccuracyTable& table) {
    free_oscillation(table);
    conservation(table);
    free_fall(table);
}

}  // namespace placode::sim
