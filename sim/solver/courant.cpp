// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/solver/courant.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/solver/kernel_layout.h"

namespace placode::sim {
namespace {

/// L of the Courant number: shortest edge, or sqrt(2) x smallest height.
double courant_length(const TetMesh& mesh, size_t t) {
    const auto& tet = mesh.tets[t];
    double shortest = std::numeric_limits<double>::infinity(), largest_area = 0;
    for (size_t i = 0; i < 4; ++i) {
        const Vec3& a = mesh.rest[static_cast<size_t>(tet[(i + 1) % 4])];
        const Vec3 ab = mesh.rest[static_cast<size_t>(tet[(i + 2) % 4])] - a;
        const Vec3 ac = mesh.rest[static_cast<size_t>(tet[(i + 3) % 4])] - a;
        largest_area = std::max(largest_area, ab.cross(ac).norm() / 2);
        for (size_t j = i + 1; j < 4; ++j) {
            shortest = std::min(shortest, (mesh.rest[static_cast<size_t>(tet[i])] -
                                           mesh.rest[static_cast<size_t>(tet[j])])
                                              .norm());
        }
    }
    const double height = 3 * rest_volume(mesh, static_cast<int>(t)) / largest_area;
    return std::min(shortest, std::sqrt(2.0) * height);
}

}  // namespace

std::array<double, kTissueCount> courant_numbers(const SoftBodySpec& spec) {
    std::array<double, kTissueCount> out{};
    const double h = spec.solver.frame_s / spec.solver.substeps;
    for (size_t t = 0; t < spec.mesh.tets.size(); ++t) {
        const auto tissue = static_cast<size_t>(spec.mesh.tissue[t]);
        const NeoHookean c = tet_constants(spec, static_cast<int>(t)).material;
        const double wave =
            std::sqrt((c.lambda_pa + c.mu_pa) / spec.materials[tissue].density_kg_m3);
        out[tissue] = std::max(out[tissue], wave * h / courant_length(spec.mesh, t));
    }
    for (const SheetTriangle& t : spec.sheet) {
        if (spec.sheet_material) break;  // no tissue: it has no number among these
        // The wave of a plate in its plane, over the smallest height.
        const auto tissue = static_cast<size_t>(t.tissue);
        const Material& m = spec.materials[tissue];
        const double wave = std::sqrt(
            m.youngs_modulus_pa / ((1 - m.poissons_ratio * m.poissons_ratio) * m.density_kg_m3));
        double longest = 0;
        for (size_t k = 0; k < 3; ++k) {
            const Vec3& a = spec.mesh.rest[static_cast<size_t>(t.vertex[k])];
            const Vec3& b = spec.mesh.rest[static_cast<size_t>(t.vertex[(k + 1) % 3])];
            longest = std::max(longest, (b - a).norm());
        }
        const double height = 2 * area_of(spec.mesh.rest, t) / longest;
        out[tissue] = std::max(out[tissue], wave * h / height);
    }
    return out;
}

}  // namespace placode::sim
