// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tissue's energy once more, in double precision and from the deformation gradient: the truth
// that the fast solvers are measured against. It shares no formula with their kernels (edge form)
// but the material constants.
//
// Psi = lambda/2 (J - gamma)^2 + mu/2 (tr F^T F - 3), P = mu F + lambda (J - gamma) cof F.
// Source: Macklin & Mueller 2021. Energies count from the rest shape (Psi(I) = 0).

#include <Eigen/Sparse>
#include <array>
#include <cstdint>
#include <vector>

#include "sim/solver/soft_body.h"
#include "sim/verify/reference_sheet.h"

namespace placode::sim {

/// Coordinates of all vertices one behind the other (3 V).
using Coordinates = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Forces and stiffness of the tetrahedra, the sheet and the anchor springs of a body; no tethers,
/// no solver.
class ReferenceBody {
 public:
    /// Uses mesh, materials, rest_scale, stiffness_percent, sheet and springs of `spec`.
    /// @throws MeshError as check_mesh does.
    explicit ReferenceBody(const SoftBodySpec& spec);

    [[nodiscard]] int vertex_count() const noexcept { return vertices_; }
    [[nodiscard]] int tet_count() const noexcept { return static_cast<int>(tets_.size()); }
    [[nodiscard]] const std::vector<double>& mass_kg() const noexcept { return mass_kg_; }  ///< (V)
    /// Velocity damping of each vertex [1/s] (V), the mean of its tets by mass.
    [[nodiscard]] const std::vector<double>& damping_per_s() const noexcept {
        return damping_per_s_;
    }
    [[nodiscard]] const Coordinates& rest() const noexcept { return rest_; }

    /// Elastic energy of tets, sheet and springs at x [J].
    [[nodiscard]] double energy(const Coordinates& x) const;
    /// Adds dE/dx [N].
    void add_gradient(const Coordinates& x, Coordinates& gradient) const;
    /// dE/dx of tets [first, last) in their corners [N], for a team of threads.
    void corner_gradients(const Coordinates& x, int first, int last,
                          std::vector<std::array<Vec3, 4>>& out) const;
    /// Adds d2E/dx2 [N/m]. @param projected takes the nearest positive semidefinite matrix of every
    /// tet instead of the exact one.
    void add_stiffness(const Coordinates& x, bool projected, Triplets& out) const;
    /// Adds the gradient of all but the tets: springs and sheet [N].
    void add_other_gradients(const Coordinates& x, Coordinates& gradient) const;

    [[nodiscard]] double deformation_determinant(const Coordinates& x, int tet) const;
    /// Tets with J <= 0.
    [[nodiscard]] int inverted_tets(const Coordinates& x) const;
    [[nodiscard]] const std::array<int32_t, 4>& corners(int tet) const {
        return tets_[static_cast<size_t>(tet)].v;
    }

    /// Largest of the terms that cancel in a vertex at rest, (mu + lambda) V |b| [N]: the scale of
    /// rounding.
    [[nodiscard]] double largest_term_n() const;

    /// Largest eigenvalue of M^-1 K at rest by power iteration, as an angular frequency [rad/s]. A
    /// symplectic step is stable below 2 / omega.
    [[nodiscard]] double highest_frequency_rad_s() const;

 private:
    struct Tet {
        std::array<int32_t, 4> v{};
        std::array<Vec3, 4> b{};  ///< Rest gradients of the barycentric coordinates [1/m].
        double volume_m3 = 0, mu_pa = 0, lambda_pa = 0;
    };
    struct Spring {
        int32_t vertex = 0;
        Vec3 anchor = Vec3::Zero();
        Mat3 stiffness = Mat3::Zero();
    };
    [[nodiscard]] static Mat3 deformation(const Tet& tet, const Coordinates& x);
    [[nodiscard]] static Eigen::Matrix<double, 12, 12> tet_stiffness(const Tet& tet,
                                                                     const Coordinates& x);

    int vertices_ = 0;
    std::vector<Tet> tets_;
    std::vector<Spring> springs_;
    std::vector<double> mass_kg_, damping_per_s_;
    Coordinates rest_;
    ReferenceSheet sheet_;
};

}  // namespace placode::sim
