// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/reference_body.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"

namespace placode::sim {
namespace {

/// Two tets side by side. Every instruction set has it, and no operation is fused.
using TwoDoubles = double __attribute__((vector_size(16)));

template <class T>
constexpr size_t kTets = sizeof(T) / sizeof(double);

/// `value_of(i)` of each tet.
template <class T, class ValueOf>
T of_each(ValueOf&& value_of) noexcept {
    if constexpr (kTets<T> == 1)
        return value_of(0);
    else
        return T{value_of(0), value_of(1)};
}
inline double of_one(double all, size_t) noexcept { return all; }
inline double of_one(TwoDoubles all, size_t i) noexcept { return all[i]; }

/// Rows by columns.
template <class T>
using Matrix = std::array<std::array<T, 3>, 3>;

/// Cofactor matrix.
template <class T>
Matrix<T> cofactors(const Matrix<T>& f) noexcept {
    Matrix<T> out;
    for (size_t r = 0; r < 3; ++r) {
        for (size_t c = 0; c < 3; ++c) {
            const size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            out[r][c] = f[r1][c1] * f[r2][c2] - f[r2][c1] * f[r1][c2];
        }
    }
    return out;
}

template <class T>
T determinant(const Matrix<T>& f) noexcept {
    const auto term = [&](size_t a, size_t b, size_t c) {
        return f[0][a] * (f[1][b] * f[2][c] - f[1][c] * f[2][b]);
    };
    return term(0, 1, 2) - term(1, 0, 2) + term(2, 0, 1);
}

/// dE/dx of a tet, or of two, in the corners: volume x P x b. Three times as fast as by Eigen's
/// matrices, which an explicit run would spend most of its time in; sums in Eigen's order, so that
/// the bits are those of add_gradient().
template <class T, class Tet>
void corner_gradients_of(const Tet* tets, const double* x, std::array<Vec3, 4>* out) noexcept {
    std::array<std::array<T, 3>, 4> b;
    Matrix<T> edge, f, stress;  // `edge` by corner
    for (size_t k = 0; k < 4; ++k)
        for (size_t c = 0; c < 3; ++c)
            b[k][c] = of_each<T>([&](size_t i) { return tets[i].b[k].data()[c]; });
    // From edges: the position of the body does not enter the rounding.
    for (size_t k = 0; k < 3; ++k) {
        for (size_t r = 0; r < 3; ++r) {
            edge[k][r] = of_each<T>([&](size_t i) {
                const auto& v = tets[i].v;
                return x[3 * as_index(v[k + 1]) + r] - x[3 * as_index(v[0]) + r];
            });
        }
    }
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c)
            f[r][c] = T{} + edge[0][r] * b[1][c] + edge[1][r] * b[2][c] + edge[2][r] * b[3][c];
    const T volume = of_each<T>([&](size_t i) { return tets[i].volume_m3; }),
            mu = of_each<T>([&](size_t i) { return tets[i].mu_pa; }),
            lambda = of_each<T>([&](size_t i) { return tets[i].lambda_pa; });
    const T pressure = lambda * (determinant(f) - 1.0) - mu;
    const Matrix<T> cofactor = cofactors(f);
    for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c)
            stress[r][c] = volume * (mu * f[r][c] + pressure * cofactor[r][c]);
    for (size_t k = 0; k < 4; ++k) {
        for (size_t r = 0; r < 3; ++r) {
            const T p = stress[r][0] * b[k][0], q = stress[r][1] * b[k][1],
                    s = stress[r][2] * b[k][2], sum = r < 2 ? (p + q) + s : p + (q + s);
            for (size_t i = 0; i < kTets<T>; ++i) out[i][k].data()[r] = of_one(sum, i);
        }
    }
}

/// Cofactor matrix, J F^-T, also where F is singular.
Mat3 cofactor(const Mat3& f) {
    Mat3 out;
    out.col(0) = f.col(1).cross(f.col(2));
    out.col(1) = f.col(2).cross(f.col(0));
    out.col(2) = f.col(0).cross(f.col(1));
    return out;
}

}  // namespace

ReferenceBody::ReferenceBody(const SoftBodySpec& spec) {
    check_sheet(spec.mesh.rest, spec.sheet);
    check_mesh(spec.mesh, sheet_vertices(spec));
    if (!spec.sheet.empty()) sheet_ = ReferenceSheet(spec);
    vertices_ = static_cast<int>(spec.mesh.rest.size());
    mass_kg_.assign(as_index(vertices_), 0.0);
    damping_per_s_.assign(as_index(vertices_), 0.0);
    rest_.resize(3 * vertices_);
    for (int v = 0; v < vertices_; ++v) rest_.segment<3>(3 * v) = spec.mesh.rest[as_index(v)];
    for (size_t t = 0; t < spec.mesh.tets.size(); ++t) {
        Tet tet;
        tet.v = spec.mesh.tets[t];
        const Mat3 scale = rest_stretch(spec, static_cast<int>(t));
        Mat3 edges;
        for (int k = 0; k < 3; ++k) {
            edges.col(k) = scale * (spec.mesh.rest[as_index(tet.v[as_index(k) + 1])] -
                                    spec.mesh.rest[as_index(tet.v[0])]);
        }
        const Mat3 inverse = edges.inverse();
        tet.b[0].setZero();
        for (int k = 0; k < 3; ++k) {
            tet.b[as_index(k) + 1] = inverse.row(k).transpose();
            tet.b[0] -= tet.b[as_index(k) + 1];
        }
        tet.volume_m3 = edges.determinant() / 6;
        const Material& m = spec.materials[static_cast<size_t>(spec.mesh.tissue[t])];
        const double share =
            spec.stiffness_percent.empty() ? 1.0 : spec.stiffness_percent[t] / 100.0;
        const NeoHookean c = neo_hookean(m.youngs_modulus_pa * share, m.poissons_ratio);
        tet.mu_pa = c.mu_pa;
        tet.lambda_pa = c.lambda_pa;
        tets_.push_back(tet);
        const double mass = rest_volume(spec.mesh, static_cast<int>(t)) * m.density_kg_m3 / 4;
        for (const int32_t v : tet.v) {
            mass_kg_[as_index(v)] += mass;
            damping_per_s_[as_index(v)] += mass * m.damping_per_s;
        }
    }
    for (const SheetTriangle& t : spec.sheet) {
        const Material& m = material_of(spec, t);
        const double mass = area_of(spec.mesh.rest, t) * t.thickness_m * m.density_kg_m3 / 3;
        for (const int32_t v : t.vertex) {
            mass_kg_[as_index(v)] += mass;
            damping_per_s_[as_index(v)] += mass * m.damping_per_s;
        }
    }
    for (int v = 0; v < vertices_; ++v) damping_per_s_[as_index(v)] /= mass_kg_[as_index(v)];
    for (const AnchorSpring& s : spec.springs) {
        const Vec3 n = s.normal.normalized();
        springs_.push_back({s.vertex, s.anchor,
                            s.tangent_n_m * Mat3::Identity() +
                                (s.normal_n_m - s.tangent_n_m) * n * n.transpose()});
    }
}

Mat3 ReferenceBody::deformation(const Tet& tet, const Coordinates& x) {
    // From edges: the position of the body does not enter the rounding.
    const Vec3 x0 = x.segment<3>(3 * tet.v[0]);
    Mat3 f = Mat3::Zero();
    for (size_t k = 1; k < 4; ++k) f += (x.segment<3>(3 * tet.v[k]) - x0) * tet.b[k].transpose();
    return f;
}

double ReferenceBody::deformation_determinant(const Coordinates& x, int tet) const {
    return deformation(tets_[as_index(tet)], x).determinant();
}

double ReferenceBody::energy(const Coordinates& x) const {
    double sum = 0;
    for (const Tet& tet : tets_) {
        const Mat3 f = deformation(tet, x);
        const double j = f.determinant();
        // lambda/2 (J - gamma)^2 - lambda/2 (1 - gamma)^2 = lambda/2 (J - 1)(J - 1 - 2 mu/lambda)
        sum += tet.volume_m3 * (0.5 * (j - 1) * (tet.lambda_pa * (j - 1) - 2 * tet.mu_pa) +
                                0.5 * tet.mu_pa * (f.squaredNorm() - 3));
    }
    for (const Spring& s : springs_) {
        const Vec3 moved = x.segment<3>(3 * s.vertex) - s.anchor;
        sum += 0.5 * moved.dot(s.stiffness * moved);
    }
    return sum + sheet_.energy(x);
}

void ReferenceBody::corner_gradients(const Coordinates& x, int first, int last,
                                     std::vector<std::array<Vec3, 4>>& out) const {
    const auto gradients = [&]<class T>(int t, T) {
        corner_gradients_of<T>(&tets_[as_index(t)], x.data(), &out[as_index(t)]);
    };
    int t = first;
    for (; t + 1 < last; t += 2) gradients(t, TwoDoubles{});
    if (t < last) gradients(t, 0.0);
}

void ReferenceBody::add_gradient(const Coordinates& x, Coordinates& gradient) const {
    for (const Tet& tet : tets_) {
        const Mat3 f = deformation(tet, x);
        const Mat3 stress =
            tet.volume_m3 *
            (tet.mu_pa * f + (tet.lambda_pa * (f.determinant() - 1) - tet.mu_pa) * cofactor(f));
        for (size_t k = 0; k < 4; ++k) gradient.segment<3>(3 * tet.v[k]) += stress * tet.b[k];
    }
    add_other_gradients(x, gradient);
}

void ReferenceBody::add_other_gradients(const Coordinates& x, Coordinates& gradient) const {
    for (const Spring& s : springs_) {
        gradient.segment<3>(3 * s.vertex) += s.stiffness * (x.segment<3>(3 * s.vertex) - s.anchor);
    }
    sheet_.add_gradient(x, gradient);
}

Eigen::Matrix<double, 12, 12> ReferenceBody::tet_stiffness(const Tet& tet, const Coordinates& x) {
    const Mat3 f = deformation(tet, x);
    const Mat3 cof = cofactor(f);
    const double pressure = tet.lambda_pa * (f.determinant() - 1) - tet.mu_pa;
    Eigen::Matrix<double, 12, 12> k;
    for (size_t i = 0; i < 4; ++i) {
        const Vec3 ci = cof * tet.b[i];
        for (size_t j = 0; j < 4; ++j) {
            const Vec3 cj = cof * tet.b[j];
            // d c_i / d x_j u = u x F (b_i x b_j), because cof(F)(a x b) = (F a) x (F b).
            k.block<3, 3>(3 * static_cast<int>(i), 3 * static_cast<int>(j)) =
                tet.volume_m3 * (tet.mu_pa * tet.b[i].dot(tet.b[j]) * Mat3::Identity() +
                                 tet.lambda_pa * ci * cj.transpose() -
                                 pressure * cross_matrix(f * tet.b[i].cross(tet.b[j])));
        }
    }
    return k;
}

void ReferenceBody::add_stiffness(const Coordinates& x, bool projected, Triplets& out) const {
    for (const Tet& tet : tets_) {
        Eigen::Matrix<double, 12, 12> k = tet_stiffness(tet, x);
        if (projected) {
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> eigen(k);
            if (eigen.eigenvalues()[0] < 0) {
                k = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
                    eigen.eigenvectors().transpose();
            }
        }
        for (int i = 0; i < 12; ++i) {
            for (int j = 0; j < 12; ++j) {
                out.emplace_back(3 * tet.v[as_index(i / 3)] + i % 3,
                                 3 * tet.v[as_index(j / 3)] + j % 3, k(i, j));
            }
        }
    }
    for (const Spring& s : springs_) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                out.emplace_back(3 * s.vertex + i, 3 * s.vertex + j, s.stiffness(i, j));
            }
        }
    }
    sheet_.add_stiffness(x, projected, out);
}

int ReferenceBody::inverted_tets(const Coordinates& x) const {
    int count = 0;
    for (int t = 0; t < tet_count(); ++t) count += deformation_determinant(x, t) > 0 ? 0 : 1;
    return count;
}

double ReferenceBody::largest_term_n() const {
    double largest = sheet_.largest_term_n();
    for (const Tet& tet : tets_) {
        for (const Vec3& b : tet.b)
            largest = std::max(largest, (tet.mu_pa + tet.lambda_pa) * tet.volume_m3 * b.norm());
    }
    return largest;
}

double ReferenceBody::highest_frequency_rad_s() const {
    Triplets triplets;
    add_stiffness(rest_, false, triplets);
    SparseMatrix k(3 * vertices_, 3 * vertices_);
    k.setFromTriplets(triplets.begin(), triplets.end());
    Coordinates inverse_root_mass(3 * vertices_), u(3 * vertices_);
    uint32_t seed = 1;
    for (int i = 0; i < 3 * vertices_; ++i) {
        inverse_root_mass[i] = 1 / std::sqrt(mass_kg_[as_index(i / 3)]);
        seed = seed * 1664525U + 1013904223U;
        u[i] = static_cast<double>(seed >> 8) / (1 << 24) - 0.5;
    }
    u.normalize();
    double value = 0;
    for (int i = 0; i < 400; ++i) {
        Coordinates next =
            inverse_root_mass.cwiseProduct(k * Coordinates(inverse_root_mass.cwiseProduct(u)));
        const double before = value;
        value = next.norm();
        if (!(value > 0)) return 0;
        u = next / value;
        if (i > 20 && value - before < 1e-5 * value) break;
    }
    return std::sqrt(value);
}

}  // namespace placode::sim
