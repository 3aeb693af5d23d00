// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz: a frictionless sphere on a half-space, as a quarter of a block with graded edges. The
// block is ten contact radii wide and deep, and d / R = 0.04; together with the mesh (edge a / 5 at
// the contact) a few per cent remain, whatever the method: newton on the same mesh shows how many.
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kRadius = 5e-3, kDepth = 2e-4, kE = 50e3, kNu = 0.45;

/// Coordinates 0 .. size: three eighths of the `cells` are `first` long, so that the whole contact
/// lies on them; the others grow by a constant ratio.
std::vector<double> graded(double size, double first, int cells) {
    const int even = 3 * cells / 8;
    double low = 1.0000001, high = 3;
    for (int i = 0; i < 200; ++i) {
        const double r = 0.5 * (low + high), rest = size - even * first;
        (first * r * (std::pow(r, cells - even) - 1) / (r - 1) < rest ? low : high) = r;
    }
    std::vector<double> out{0};
    double step = first;
    for (int i = 0; i < cells; ++i) {
        if (i >= even) step *= low;
        out.push_back(out.back() + step);
    }
    for (double& x : out) x *= size / out.back();
    return out;
}

VerificationScene block(int cells, double edge_m) {
    const double size = 10 * std::sqrt(kRadius * kDepth);
    VerificationScene scene = accuracy_scene(Vec3::Constant(size), {cells, cells, cells}, kE, kNu);
    const std::vector<double> at = graded(size, edge_m, cells);
    const auto moved = [&](const Vec3& p) {
        Vec3 q;
        for (int a = 0; a < 3; ++a) {
            // Fine at x = y = 0 and at the top.
            const int i = static_cast<int>(std::lround(p[a] / size * cells));
            q[a] = a < 2 ? at[static_cast<size_t>(i)] : size - at[static_cast<size_t>(cells - i)];
        }
        return q;
    };
    for (Vec3& p : scene.mesh.rest) p = moved(p);
    for (Vec3& p : scene.output_points) p = moved(p);
    scene.held.push_back(held_plane(2, 0, 7));
    scene.held.push_back(held_plane(0, 0, kAxisX, "/fixed/1"));
    scene.held.push_back(held_plane(1, 0, kAxisY, "/fixed/2"));
    // Down to the depth at constant speed: slow against the waves (6 ms through the block).
    scene.end_s = 0.5;
    SphereObstacle sphere;
    sphere.centre_m = Vec3(0, 0, size + kRadius);
    sphere.radius_m = kRadius;
    sphere.velocity_m_s = Vec3(0, 0, -kDepth / scene.end_s);
    scene.spheres.push_back(sphere);
    scene.material.damping_per_s = 100;
    return scene;
}

}  // namespace

void measure_indentation(AccuracyTable& table) {
    const int cells = table.quick() ? 8 : 16;
    const double edge = (table.quick() ? 0.3 : 0.2) * std::sqrt(kRadius * kDepth);
    const double hertz =
        4.0 / 3 * kE / (1 - kNu * kNu) * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
    double newton_force = 0;
    for (const auto& [method, substeps] : {std::pair{SolveMethod::kNewton, 1},
                                           {SolveMethod::kVbd, 2},
                                           {SolveMethod::kVbd, 4},
                                           {SolveMethod::kVbd, 8}}) {
        VerificationScene scene = block(cells, edge);
        use_method(scene, method, substeps);
        const SolveResult result = solve(scene);
        const double force = 4 * result.contact_force_n.z();
        AccuracyRow row =
            row_of(scene, result, "sphere indentation",
                   "R 5 mm, d 0.2 mm, 50 kPa, nu 0.45, quarter block", "force against Hertz", edge);
        set_text(row.unit, "N");
        row.value = force;
        row.expected = hertz;
        row.error = std::abs(force / hertz - 1);
        row.target = 0.1;
        table.add(row);
        if (method == SolveMethod::kNewton) {
            newton_force = force;
            continue;
        }
        set_text(row.quantity, "force against newton on the same mesh");
        row.expected = newton_force;
        row.error = std::abs(force / newton_force - 1);
        row.target = 0.05;
        table.add(row);
    }
}

}  // namespace placode::sim
