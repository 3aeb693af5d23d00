// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/reference_sheet.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <complex>

#include "sim/core/as_index.h"
#include "sim/mesh/dihedral.h"
#include "sim/solver/soft_body.h"

namespace placode::sim {
namespace {

using Coordinates = ReferenceSheet::Coordinates;

/// adj(C) = det(C) C^-1 of a symmetric 2 x 2 matrix; linear in C.
Eigen::Matrix2d adjugate(const Eigen::Matrix2d& c) {
    Eigen::Matrix2d out;
    out << c(1, 1), -c(0, 1), -c(1, 0), c(0, 0);
    return out;
}

/// One edge with a neighbour: its four vertices and where it stands.
struct Hinge {
    std::array<int32_t, 4> v{};
    HingePoints<double> p;
    double s = 0;
    bool sound = false;
};

std::array<Hinge, 3> hinges_of(const SheetElement& t, const Coordinates& x) {
    std::array<Hinge, 3> out;
    for (size_t i = 0; i < 3; ++i) {
        if (t.flap[i] < 0) continue;
        Hinge& h = out[i];
        h.v = {t.v[i], t.v[(i + 1) % 3], t.v[(i + 2) % 3], t.flap[i]};
        for (size_t k = 0; k < 4; ++k) h.p[k] = x.segment<3>(3 * h.v[k]);
        h.sound = has_hinge(h.p);
        if (h.sound) h.s = angle_from(hinge_angle(h.p), t.rest_angle[i]);
    }
    return out;
}

Vec3 angles_of(const std::array<Hinge, 3>& hinges) {
    return {hinges[0].s, hinges[1].s, hinges[2].s};
}

/// Second derivative of the angle, exact: the gradient differentiated with an imaginary step.
/// Source: Squire & Trapp 1998.
Eigen::Matrix<double, 12, 12> hinge_hessian(const HingePoints<double>& p) {
    constexpr double kStep = 1e-30;
    using Complex = std::complex<double>;
    Eigen::Matrix<double, 12, 12> out;
    for (int column = 0; column < 12; ++column) {
        HingePoints<Complex> q;
        for (size_t k = 0; k < 4; ++k) q[k] = p[k].cast<Complex>();
        q[as_index(column / 3)][column % 3] += Complex(0, kStep);
        const HingePoints<Complex> g = hinge_gradient<Complex>(q);
        for (int row = 0; row < 12; ++row)
            out(row, column) = g[as_index(row / 3)][row % 3].imag() / kStep;
    }
    return out;
}

template <class Matrix>
void keep_positive(Matrix& k) {
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(k);
    if (eigen.eigenvalues()[0] >= 0) return;
    k = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
        eigen.eigenvectors().transpose();
}

bool bends(const SheetElement& t) { return t.bending.trace() > 0; }

}  // namespace

ReferenceSheet::ReferenceSheet(const SoftBodySpec& spec) : elements_(sheet_elements(spec)) {
    for (const SheetTriangle& t : spec.sheet) {
        Membrane m;
        m.v = t.vertex;
        const Vec3& origin = spec.mesh.rest[as_index(t.vertex[0])];
        const Vec3 e1 = spec.mesh.rest[as_index(t.vertex[1])] - origin;
        const Vec3 e2 = spec.mesh.rest[as_index(t.vertex[2])] - origin;
        const Vec3 axis = e1.normalized(), across = (e2 - axis.dot(e2) * axis).normalized();
        Eigen::Matrix2d edges;
        edges << axis.dot(e1), axis.dot(e2), across.dot(e1), across.dot(e2);
        const Eigen::Matrix2d inverse = edges.inverse();
        m.b[1] = inverse.row(0).transpose();
        m.b[2] = inverse.row(1).transpose();
        m.b[0] = -m.b[1] - m.b[2];
        m.volume_m3 = edges.determinant() / 2 * t.thickness_m;
        const Material& material = material_of(spec, t);
        const NeoHookean c = neo_hookean(material.youngs_modulus_pa, material.poissons_ratio);
        m.material = {c.mu_pa, c.lambda_pa};
        membranes_.push_back(m);
    }
}

ReferenceSheet::Matrix32 ReferenceSheet::deformation(const Membrane& t, const Coordinates& x) {
    const Vec3 x0 = x.segment<3>(3 * t.v[0]);
    Matrix32 f = Matrix32::Zero();
    for (size_t k = 1; k < 3; ++k) f += (x.segment<3>(3 * t.v[k]) - x0) * t.b[k].transpose();
    return f;
}

/// P V = V (mu F + 2 W'(q) F adj(C)), because d det(C) = 2 F adj(C) : dF.
ReferenceSheet::Matrix32 ReferenceSheet::stress(const Membrane& t, const Matrix32& f) {
    const Eigen::Matrix2d c = f.transpose() * f;
    return t.volume_m3 *
           (t.material.mu_pa * f + 2 * t.material.slope(c.determinant()) * f * adjugate(c));
}

double ReferenceSheet::energy(const Coordinates& x) const {
    double sum = 0;
    for (const Membrane& t : membranes_) {
        const Matrix32 f = deformation(t, x);
        const double q = (f.transpose() * f).determinant();
        const double mu = t.material.mu_pa, lambda = t.material.lambda_pa;
        // W(q) - W(1) = mu (lambda + mu) (1 - q) / (2 (mu + lambda q))
        sum += t.volume_m3 * (mu / 2 * (f.squaredNorm() - 2) +
                              mu * (lambda + mu) * (1 - q) / (2 * (mu + lambda * q)));
    }
    for (const SheetElement& t : elements_.triangles) {
        if (!bends(t)) continue;
        const Vec3 s = angles_of(hinges_of(t, x));
        sum += 0.5 * s.dot(t.bending * s);
    }
    return sum;
}

void ReferenceSheet::add_gradient(const Coordinates& x, Coordinates& gradient) const {
    for (const Membrane& t : membranes_) {
        const Matrix32 p = stress(t, deformation(t, x));
        for (size_t k = 0; k < 3; ++k) gradient.segment<3>(3 * t.v[k]) += p * t.b[k];
    }
    for (const SheetElement& t : elements_.triangles) {
        if (!bends(t)) continue;
        const std::array<Hinge, 3> hinges = hinges_of(t, x);
        const Vec3 moment = t.bending * angles_of(hinges);
        for (size_t i = 0; i < 3; ++i) {
            if (!hinges[i].sound) continue;
            const HingePoints<double> g = hinge_gradient<double>(hinges[i].p);
            for (size_t k = 0; k < 4; ++k)
                gradient.segment<3>(3 * hinges[i].v[k]) += moment[static_cast<int>(i)] * g[k];
        }
    }
}

Eigen::Matrix<double, 9, 9> ReferenceSheet::membrane_stiffness(const Membrane& t,
                                                               const Matrix32& f) {
    const Eigen::Matrix2d c = f.transpose() * f, adj = adjugate(c);
    const double q = c.determinant(), slope = t.material.slope(q);
    const Matrix32 dq = 2 * f * adj;
    Eigen::Matrix<double, 9, 9> out;
    for (int column = 0; column < 9; ++column) {
        const Matrix32 df = Vec3::Unit(column % 3) *
                            t.b[as_index(column / 3)].transpose();  // of a corner's unit step
        const Eigen::Matrix2d dc = df.transpose() * f + f.transpose() * df;
        const Matrix32 dp = t.material.mu_pa * df +
                            t.material.curvature(q) * dq.cwiseProduct(df).sum() * dq +
                            2 * slope * (df * adj + f * adjugate(dc));
        for (int k = 0; k < 3; ++k)
            out.block<3, 1>(3 * k, column) = t.volume_m3 * dp * t.b[as_index(k)];
    }
    return out;
}

void ReferenceSheet::add_stiffness(const Coordinates& x, bool projected, Triplets& out) const {
    for (const Membrane& t : membranes_) {
        Eigen::Matrix<double, 9, 9> k = membrane_stiffness(t, deformation(t, x));
        if (projected) keep_positive(k);
        for (int i = 0; i < 9; ++i) {
            for (int j = 0; j < 9; ++j)
                out.emplace_back(3 * t.v[as_index(i / 3)] + i % 3, 3 * t.v[as_index(j / 3)] + j % 3,
                                 k(i, j));
        }
    }
    for (const SheetElement& t : elements_.triangles) {
        if (!bends(t)) continue;
        const std::array<Hinge, 3> hinges = hinges_of(t, x);
        const Vec3 moment = t.bending * angles_of(hinges);
        std::array<HingePoints<double>, 3> g;
        for (size_t i = 0; i < 3; ++i) {
            if (hinges[i].sound) g[i] = hinge_gradient<double>(hinges[i].p);
        }
        for (size_t i = 0; i < 3; ++i) {
            if (!hinges[i].sound) continue;
            Eigen::Matrix<double, 12, 12> second = Eigen::Matrix<double, 12, 12>::Zero();
            if (!projected) second = moment[static_cast<int>(i)] * hinge_hessian(hinges[i].p);
            for (size_t j = 0; j < 3; ++j) {
                if (!hinges[j].sound) continue;
                const double b = t.bending(static_cast<int>(i), static_cast<int>(j));
                for (int r = 0; r < 12; ++r) {
                    for (int c = 0; c < 12; ++c) {
                        double value =
                            b * g[i][as_index(r / 3)][r % 3] * g[j][as_index(c / 3)][c % 3];
                        if (i == j) value += second(r, c);
                        out.emplace_back(3 * hinges[i].v[as_index(r / 3)] + r % 3,
                                         3 * hinges[j].v[as_index(c / 3)] + c % 3, value);
                    }
                }
            }
        }
    }
}

double ReferenceSheet::largest_term_n() const {
    double largest = 0;
    for (const Membrane& t : membranes_) {
        for (const auto& b : t.b)
            largest = std::max(largest, t.material.mu_pa * t.volume_m3 * b.norm());
    }
    return largest;
}

}  // namespace placode::sim
