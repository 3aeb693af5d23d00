// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sheets once more in double precision: the energy in the plane from the deformation gradient, with
// its exact tangent. With the fast solver it shares the rest values of sim/solver/sheet.h and the
// angle of sim/mesh/dihedral.h, both of which are held against closed forms and finite differences.

#include <Eigen/Sparse>
#include <vector>

#include "sim/solver/sheet.h"

namespace placode::sim {

class ReferenceSheet {
 public:
    using Coordinates = Eigen::VectorXd;
    using Triplets = std::vector<Eigen::Triplet<double>>;

    ReferenceSheet() = default;
    explicit ReferenceSheet(const SoftBodySpec& spec);

    [[nodiscard]] bool empty() const noexcept { return membranes_.empty(); }
    /// From the rest shape [J].
    [[nodiscard]] double energy(const Coordinates& x) const;
    /// Adds dE/dx [N].
    void add_gradient(const Coordinates& x, Coordinates& gradient) const;
    /// Adds d2E/dx2 [N/m], exact or (projected) positive semidefinite triangle by triangle.
    void add_stiffness(const Coordinates& x, bool projected, Triplets& out) const;
    /// mu V |b|: the scale of rounding [N].
    [[nodiscard]] double largest_term_n() const;

 private:
    using Matrix32 = Eigen::Matrix<double, 3, 2>;
    struct Membrane {
        std::array<int32_t, 3> v{};
        std::array<Eigen::Vector2d, 3> b{};  ///< Rest gradients in the plane [1/m].
        double volume_m3 = 0;
        SheetMaterial material;
    };
    [[nodiscard]] static Matrix32 deformation(const Membrane& t, const Coordinates& x);
    [[nodiscard]] static Matrix32 stress(const Membrane& t, const Matrix32& f);
    [[nodiscard]] static Eigen::Matrix<double, 9, 9> membrane_stiffness(const Membrane& t,
                                                                        const Matrix32& f);

    std::vector<Membrane> membranes_;
    SheetElements elements_;  ///< For bending.
};

}  // namespace placode::sim
