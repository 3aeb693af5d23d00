// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bodies of triangles: a free grid, and a flap welded to a block of tets.

#include <cstdint>
#include <vector>

#include "sim/core/as_index.h"
#include "sim/solver/soft_body.h"

namespace placode::sim::test {

inline constexpr double kE = 200e3, kNu = 0.45, kThickness = 0.1e-3;

enum class Diagonal { kRising, kFalling, kCrossed };

/// nx x ny squares of `edge`, each of two triangles (kCrossed alternates their diagonal).
inline void add_grid(SoftBodySpec& spec, int nx, int ny, double edge, Diagonal diagonal,
                     const Vec3& origin = Vec3::Zero()) {
    const auto first = static_cast<int32_t>(spec.mesh.rest.size());
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) spec.mesh.rest.push_back(origin + edge * Vec3(i, j, 0));
    }
    const auto vertex = [&](int i, int j) { return first + j * (nx + 1) + i; };
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
            const bool rising = diagonal == Diagonal::kRising ||
                                (diagonal == Diagonal::kCrossed && (i + j) % 2 == 0);
            if (rising) {
                spec.sheet.push_back({{a, b, c}, Tissue::kSkin, kThickness});
                spec.sheet.push_back({{a, c, d}, Tissue::kSkin, kThickness});
            } else {
                spec.sheet.push_back({{a, b, d}, Tissue::kSkin, kThickness});
                spec.sheet.push_back({{b, c, d}, Tissue::kSkin, kThickness});
            }
        }
    }
}

inline SoftBodySpec grid(int nx, int ny, double edge, Diagonal diagonal = Diagonal::kCrossed,
                         double nu = kNu) {
    SoftBodySpec spec;
    for (Material& m : spec.materials) {
        m.youngs_modulus_pa = kE;
        m.poissons_ratio = nu;
        m.density_kg_m3 = 1000;
        m.damping_per_s = 0;
    }
    add_grid(spec, nx, ny, edge, diagonal);
    return spec;
}

/// A block of tets, 4 x 4 x 2 mm, with a sheet welded along x = 4 mm, y = 0 .. 4 mm at half height
/// and reaching 4 mm beyond.
inline SoftBodySpec flap_spec(Method method = Method::kVbd) {
    SoftBodySpec spec = grid(0, 0, 1);
    spec.mesh = box_mesh(Vec3(4e-3, 4e-3, 2e-3), {4, 4, 2});
    for (Material& m : spec.materials) m.damping_per_s = 40;
    Material& soft = spec.materials[static_cast<size_t>(Tissue::kSubcutis)];
    soft.youngs_modulus_pa = 20e3;
    const auto tets_have = static_cast<int32_t>(spec.mesh.rest.size());
    add_grid(spec, 4, 4, 1e-3, Diagonal::kCrossed, Vec3(4e-3, 0, 1e-3));
    for (SheetTriangle& t : spec.sheet) {
        for (int32_t& v : t.vertex) {  // weld: the same place is the same vertex
            for (int32_t w = 0; w < tets_have; ++w) {
                if ((spec.mesh.rest[as_index(v)] - spec.mesh.rest[as_index(w)]).norm() < 1e-9)
                    v = w;
            }
        }
    }
    // Points that were welded away are left out.
    std::vector<int32_t> number(spec.mesh.rest.size(), -1);
    std::vector<Vec3> rest(spec.mesh.rest.begin(), spec.mesh.rest.begin() + tets_have);
    for (int32_t v = 0; v < tets_have; ++v) number[as_index(v)] = v;
    for (SheetTriangle& t : spec.sheet) {
        for (int32_t& v : t.vertex) {
            if (number[as_index(v)] < 0) {
                number[as_index(v)] = static_cast<int32_t>(rest.size());
                rest.push_back(spec.mesh.rest[as_index(v)]);
            }
            v = number[as_index(v)];
        }
    }
    spec.mesh.rest = rest;
    for (int32_t v = 0; v < tets_have; ++v) {
        if (rest[as_index(v)].x() == 0) spec.fixed.push_back(v);
    }
    spec.solver.method = method;
    return spec;
}

}  // namespace placode::sim::test
