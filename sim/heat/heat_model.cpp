// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The constant part of heat: capacities, conductances and free areas of the rest mesh.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <map>

#include "sim/heat/heat_parts.h"
#include "sim/mesh/surface.h"

namespace placode::sim {
namespace {

constexpr double kSafety = 0.9;  // of the explicit stability limit

/// Free boundary area of every vertex at rest.
std::vector<float> exposed_areas(const TetMesh& mesh) {
    std::map<std::array<int32_t, 3>, std::pair<int, double>> faces;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
        for (int f = 0; f < 4; ++f) {
            std::array<int32_t, 3> key{};
            for (int i = 0; i < 3; ++i) key[i] = mesh.tets[t][kTetFaces[f][i]];
            std::sort(key.begin(), key.end());
            auto& entry = faces[key];
            ++entry.first;
            entry.second = face_area(mesh, t, f);
        }
    }
    std::vector<float> area(mesh.rest.size(), 0.0f);
    for (const auto& [key, entry] : faces) {
        if (entry.first != 1) continue;
        for (const int32_t v : key) area[v] += static_cast<float>(entry.second / 3);
    }
    return area;
}

}  // namespace

Eigen::Matrix<double, 3, 4> shape_gradients(const TetMesh& mesh, int tet, double& volume) noexcept {
    const auto& v = mesh.tets[tet];
    Mat3 edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = mesh.rest[v[i + 1]] - mesh.rest[v[0]];
    volume = edges.determinant() / 6;
    const Mat3 inverse = edges.inverse();
    Eigen::Matrix<double, 3, 4> g;
    for (int i = 0; i < 3; ++i) g.col(i + 1) = inverse.row(i).transpose();
    g.col(0) = -(g.col(1) + g.col(2) + g.col(3));
    return g;
}

double face_area(const TetMesh& mesh, int tet, int face) noexcept {
    const auto& v = mesh.tets[tet];
    const Vec3& a = mesh.rest[v[kTetFaces[face][0]]];
    const Vec3& b = mesh.rest[v[kTetFaces[face][1]]];
    const Vec3& c = mesh.rest[v[kTetFaces[face][2]]];
    return 0.5 * (b - a).cross(c - a).norm();
}

HeatModel::HeatModel(const TetMesh& mesh, const MaterialTable& materials,
                     const HeatSettings& settings)
    : settings_(settings), exposed_area_m2_(exposed_areas(mesh)) {
    const int vertices = static_cast<int>(mesh.rest.size());
    for (int i = 0; i < kTissueCount; ++i) {
        const Material& m = materials[i];
        capacity_j_m3k_[i] = static_cast<float>(m.density_kg_m3 * m.heat_capacity_j_kgk);
        latent_j_m3_[i] =
            static_cast<float>(m.density_kg_m3 * m.water_fraction * settings.latent_heat_j_kg);
        conductivity_w_mk_[i] = static_cast<float>(m.heat_conductivity_w_mk);
    }
    std::vector<double> capacity(vertices, 0.0), latent(vertices, 0.0);
    std::vector<std::map<int32_t, double>> rows(vertices);
    double fastest = 0;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
        const int tissue = static_cast<int>(mesh.tissue[t]);
        double volume = 0;
        const Eigen::Matrix<double, 3, 4> g = shape_gradients(mesh, t, volume);
        const double k = conductivity_w_mk_[tissue];
        for (int i = 0; i < 4; ++i) {
            const int32_t vi = mesh.tets[t][i];
            capacity[vi] += capacity_j_m3k_[tissue] * volume / 4;
            latent[vi] += latent_j_m3_[tissue] * volume / 4;
            for (int j = 0; j < 4; ++j) {
                if (j != i) rows[vi][mesh.tets[t][j]] -= k * volume * g.col(i).dot(g.col(j));
            }
        }
        // K_e = k V G^T G against lumped C_e = rho c V / 4: rate = 4 k/(rho c) eig(G G^T).
        Eigen::SelfAdjointEigenSolver<Mat3> eigen;
        // Not computeDirect(), which asks the C library for angles: portable_math.h.
        eigen.compute(g * g.transpose(), Eigen::EigenvaluesOnly);
        fastest = std::max(fastest, 4 * k / capacity_j_m3k_[tissue] * eigen.eigenvalues()[2]);
    }
    stable_step_s_ = fastest > 0 ? kSafety * 2 / fastest : 1e9;
    capacity_j_k_.assign(capacity.begin(), capacity.end());
    latent_j_.assign(latent.begin(), latent.end());
    edge_start_.reserve(vertices + 1);
    edge_start_.push_back(0);
    for (const auto& row : rows) {
        for (const auto& [to, w] : row) {
            edge_to_.push_back(to);
            edge_w_k_.push_back(static_cast<float>(w));
        }
        edge_start_.push_back(static_cast<int32_t>(edge_to_.size()));
    }
    edge_to_.shrink_to_fit();
    edge_w_k_.shrink_to_fit();
}

}  // namespace placode::sim
