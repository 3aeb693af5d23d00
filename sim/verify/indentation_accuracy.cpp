// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hertz: a frictionless sphere on a half-space, as a quarter of a block with graded edges and
// d / R = 0.04. A block of 10 contact radii, clamped below, would be 11 % too stiff by its
// thickness alone (Dimitriadis et al. 2002), so that it is 30 wide and deep; what the mesh adds
// (edge a / 5 at the contact) is the rest. newton is too dear on that mesh: the methods meet it on
// a coarser one.
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kRadius = 5e-3, kDepth = 2e-4, kHertzE = 50e3, kHertzNu = 0.45;

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

VerificationScene block(int cells, double radii, double edge_m) {
    const double size = radii * std::sqrt(kRadius * kDepth);
    VerificationScene scene =
        accuracy_scene(Vec3::Constant(size), {cells, cells, cells}, kHertzE, kHertzNu);
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
    // Down to the depth at constant speed: shear waves cross the larger block in 7 ms.
    scene.end_s = 1;
    SphereObstacle sphere;
    sphere.centre_m = Vec3(0, 0, size + kRadius);
    sphere.radius_m = kRadius;
    sphere.velocity_m_s = Vec3(0, 0, -kDepth / scene.end_s);
    scene.spheres.push_back(sphere);
    scene.material.damping_per_s = 100;
    return scene;
}

/// One method on one block. Returns the force [N].
double indent(AccuracyTable& table, VerificationScene scene, double edge_m, const char* setting,
              double newton_force_n, bool half_space) {
    const double hertz =
        4.0 / 3 * kHertzE / (1 - kHertzNu * kHertzNu) * std::sqrt(kRadius) * std::pow(kDepth, 1.5);
    const SolveResult result = solve(scene);
    const double force = 4 * result.contact_force_n.z();
    AccuracyRow row =
        row_of(scene, result, "sphere indentation", setting, "force against Hertz", edge_m);
    set_text(row.unit, "N");
    row.value = force;
    row.expected = hertz;
    row.error = std::abs(force / hertz - 1);
    if (half_space) row.target = 0.1;
    table.add(row);
    if (newton_force_n <= 0) return force;
    set_text(row.quantity, "force against newton on the same mesh");
    row.expected = newton_force_n;
    row.error = std::abs(force / newton_force_n - 1);
    row.target = 0.05;
    table.add(row);
    return force;
}

}  // namespace

void measure_indentation(AccuracyTable& table) {
    const double edge = (table.quick() ? 0.3 : 0.2) * std::sqrt(kRadius * kDepth);
    const auto with = [](VerificationScene scene, SolveMethod method, int substeps) {
        use_method(scene, {method, substeps});
        return scene;
    };
    const VerificationScene small = block(table.quick() ? 8 : 16, 10, edge);
    const char* const thin = "R 5 mm, d 0.2 mm, 50 kPa, nu 0.45, block 10 a";
    const double newton = indent(table, with(small, SolveMethod::kNewton, 1), edge, thin, 0, false);
    for (const int substeps : {2, 4, 8}) {
        indent(table, with(small, SolveMethod::kVbd, substeps), edge, thin, newton, false);
    }
    if (table.quick()) return;
    const VerificationScene wide = block(28, 30, edge);
    for (const int substeps : {2, 4, 8}) {
        indent(table, with(wide, SolveMethod::kVbd, substeps), edge,
               "R 5 mm, d 0.2 mm, 50 kPa, nu 0.45, block 30 a", 0, true);
    }
}

}  // namespace placode::sim
