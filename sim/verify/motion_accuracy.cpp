// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Free motion: period and decay of an oscillation, momentum, energy, free fall.
#include <algorithm>
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

struct Oscillation {
    double period_s = 0;
    double decay_per_s = 0;  ///< Of the amplitude.
};

/// From the extremes of the probe's height, refined by a parabola through three samples: the period
/// is the mean over whole swings, the decay a fit to the swings between neighbouring extremes.
Oscillation oscillation(const SolveResult& result) {
    const auto z = [&](size_t i) { return result.probe_m[i][0].z(); };
    std::vector<double> when, what;
    for (size_t i = 1; i + 1 < result.probe_m.size(); ++i) {
        const double before = z(i) - z(i - 1), after = z(i + 1) - z(i);
        if (before * after > 0 || before == 0) continue;
        const double bend = after - before;
        const double shift = bend != 0 ? -0.5 * (before + after) / bend : 0;
        const double dt = result.sample_time_s[i] - result.sample_time_s[i - 1];
        when.push_back(result.sample_time_s[i] + shift * dt);
        what.push_back(z(i) + 0.25 * shift * (before + after));
    }
    Oscillation out;
    if (when.size() < 4) return out;
    const size_t swings = (when.size() - 1) / 2;
    out.period_s = (when[2 * swings] - when[0]) / static_cast<double>(swings);
    double n = 0, t = 0, y = 0, tt = 0, ty = 0;
    for (size_t i = 0; i + 1 < when.size(); ++i) {
        const double middle = 0.5 * (when[i] + when[i + 1]);
        const double size = std::log(std::max(std::abs(what[i + 1] - what[i]), 1e-300));
        n += 1;
        t += middle;
        y += size;
        tt += middle * middle;
        ty += middle * size;
    }
    out.decay_per_s = -(n * ty - t * y) / (n * tt - t * t);
    return out;
}

/// A soft beam swings about its sag after gravity is switched on; damping 2 / s takes 1 / s off the
/// amplitude. Probe once a frame.
void free_oscillation(AccuracyTable& table) {
    Oscillation truth;
    for (const auto& [method, substeps] : {std::pair{SolveMethod::kExplicit, 40},
                                           {SolveMethod::kExplicit, 16},
                                           {SolveMethod::kVbd, 4},
                                           {SolveMethod::kVbd, 8},
                                           {SolveMethod::kVbd, 16},
                                           {SolveMethod::kXpbd, 8},
                                           {SolveMethod::kXpbd, 16},
                                           {SolveMethod::kXpbdPair, 16}}) {
        VerificationScene scene = accuracy_scene(Vec3(0.02, 4e-3, 4e-3), {10, 2, 2}, 5e3, 0.45);
        scene.gravity_m_s2 = Vec3(0, 0, -0.2);
        scene.material.damping_per_s = 2;
        scene.held.push_back(held_plane(0, 0, 7));
        scene.probes.push_back({"tip", held_plane(0, 0.02, 7).box, "/probes/0"});
        scene.end_s = 1.0;
        use_method(scene, method, substeps);
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
        set_text(row.quantity, "decay of the amplitude against damping / 2 = 1 / s");
        set_text(row.unit, "1/s");
        row.value = found.decay_per_s;
        row.expected = 1;
        row.error = std::abs(found.decay_per_s - 1);
        row.target = 0;
        table.add(row);
    }
}

/// A free block let go from a stretch of 30 %: nothing outside acts on it.
void conservation(AccuracyTable& table) {
    for (const auto& [method, substeps] : {std::pair{SolveMethod::kExplicit, 20},
                                           {SolveMethod::kVbd, 4},
                                           {SolveMethod::kXpbd, 16},
                                           {SolveMethod::kXpbdPair, 16}}) {
        VerificationScene scene = accuracy_scene(Vec3(8e-3, 4e-3, 4e-3), {8, 4, 4}, 5e3, 0.45);
        scene.start = {StartKind::kStretch, 0.3, 1};
        use_method(scene, method, substeps);
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
        row.target = method == SolveMethod::kExplicit ? 0.01 : 0;
        table.add(row);
    }
}

void free_fall(AccuracyTable& table) {
    for (const auto& [method, substeps] :
         {std::pair{SolveMethod::kExplicit, 16}, {SolveMethod::kVbd, 4}, {SolveMethod::kXpbd, 8}}) {
        VerificationScene scene = accuracy_scene(Vec3(4e-3, 4e-3, 4e-3), {4, 4, 4}, 5e3, 0.45);
        scene.gravity_m_s2 = Vec3(0, 0, -9.81);
        scene.probes.push_back({"all", {Vec3::Constant(-1), Vec3::Constant(1)}, "/probes/0"});
        scene.end_s = 0.2;
        use_method(scene, method, substeps);
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
