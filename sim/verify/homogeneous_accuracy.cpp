// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// States with one deformation gradient everywhere: linear tets represent them exactly, so that any
// error is the method's. Closed forms: Psi of sim/verify/reference_body.h by hand.
#include <cmath>

#include "sim/verify/accuracy_table.h"

namespace placode::sim {
namespace {

constexpr double kSide = 3e-3, kCubeE = 5e3, kCubeNu = 0.45;
constexpr int kCells = 3;

struct Deformation {
    const char* name;
    Mat3 f, p;  ///< Deformation gradient and first Piola stress.
};

std::vector<Deformation> deformations() {
    const NeoHookean c = neo_hookean(kCubeE, kCubeNu);
    std::vector<Deformation> out;
    const double k = 0.5;
    Mat3 shear = Mat3::Identity(), p = Mat3::Zero();
    shear(0, 1) = k;
    p(0, 1) = p(1, 0) = c.mu_pa * k;
    out.push_back({"simple shear, k = 0.5", shear, p});
    for (const double a : {0.9, 1.1}) {
        const double sigma = c.mu_pa / a + c.lambda_pa * (a * a * a - 1) - c.mu_pa;
        out.push_back({a < 1 ? "hydrostatic, a = 0.9" : "hydrostatic, a = 1.1",
                       a * Mat3::Identity(), sigma * a * a * Mat3::Identity()});
    }
    for (const double a : {0.8, 1.2}) {
        const double side = (c.lambda_pa * (a - 1) - c.mu_pa) * a + c.mu_pa;
        out.push_back({a < 1 ? "confined, a = 0.8" : "confined, a = 1.2",
                       Vec3(a, 1, 1).asDiagonal(),
                       Vec3((c.lambda_pa + c.mu_pa) * (a - 1), side, side).asDiagonal()});
    }
    return out;
}

constexpr MethodChoice kChoices[]{{SolveMethod::kNewton, 1},    {SolveMethod::kVbd, 4},
                                  {SolveMethod::kXpbd, 8},      {SolveMethod::kXpbd, 16},
                                  {SolveMethod::kXpbd, 32},     {SolveMethod::kXpbd, 32, true},
                                  {SolveMethod::kXpbdPair, 32}, {SolveMethod::kXpbdPair, 32, true},
                                  {SolveMethod::kExplicit, 16}};

/// Mean stress 1/V sum f X^T over the boundary, whose vertices are held one by one in F X.
void held_boundary(AccuracyTable& table, const Deformation& deformation) {
    for (const MethodChoice& choice : kChoices) {
        VerificationScene scene =
            accuracy_scene(Vec3::Constant(kSide), {kCells, kCells, kCells}, kCubeE, kCubeNu);
        use_method(scene, choice);
        scene.material.damping_per_s = 60;
        scene.end_s = 0.4;
        std::vector<Vec3> places;
        for (const Vec3& p : scene.output_points) {
            const bool inner = p.minCoeff() > 1e-9 && p.maxCoeff() < kSide - 1e-9;
            if (inner) continue;
            HeldRegion region;
            region.box = {p, p};
            region.displacement_m = deformation.f * p - p;
            region.ramp_s = 0.05;
            region.pointer = "/prescribed/" + std::to_string(places.size());
            scene.held.push_back(region);
            places.push_back(p);
        }
        const SolveResult result = solve(scene);
        Mat3 mean = Mat3::Zero();
        for (size_t i = 0; i < places.size(); ++i)
            mean += result.reactions[i].force_n * places[i].transpose() / std::pow(kSide, 3);
        AccuracyRow row = row_of(scene, result, "homogeneous states", deformation.name,
                                 "mean stress against the closed form", kSide / kCells);
        set_text(row.unit, "Pa");
        row.value = mean.norm();
        row.expected = deformation.p.norm();
        row.error = (mean - deformation.p).norm() / deformation.p.norm();
        row.target = choice.method == SolveMethod::kNewton ? 1e-6 : 1e-3;
        table.add(row);
    }
}

void uniaxial(AccuracyTable& table, double a) {
    const NeoHookean c = neo_hookean(kCubeE, kCubeNu);
    const double j = 1 + c.mu_pa / c.lambda_pa * (1 - 1 / a);
    const double p = c.mu_pa * (a - j / (a * a));
    for (const MethodChoice& choice : kChoices) {
        VerificationScene scene =
            accuracy_scene(Vec3::Constant(kSide), {kCells, kCells, kCells}, kCubeE, kCubeNu);
        use_method(scene, choice);
        scene.material.damping_per_s = 60;
        scene.end_s = 0.5;
        for (int axis = 0; axis < 3; ++axis)
            scene.held.push_back(held_plane(axis, 0, static_cast<uint8_t>(1 << axis)));
        scene.held.push_back(held_plane(0, kSide, kAxisX, "/prescribed/0"));
        scene.held.back().displacement_m.x() = (a - 1) * kSide;
        scene.held.back().ramp_s = 0.05;
        const SolveResult result = solve(scene);
        AccuracyRow row = row_of(scene, result, "homogeneous states",
                                 a < 1 ? "uniaxial, a = 0.8" : "uniaxial, a = 1.2",
                                 "axial stress against the closed form", kSide / kCells);
        set_text(row.unit, "Pa");
        row.value = result.reactions[3].force_n.x() / (kSide * kSide);
        row.expected = p;
        row.error = std::abs(row.value / p - 1);
        row.target = choice.method == SolveMethod::kNewton ? 1e-6 : 1e-3;
        table.add(row);
    }
}

}  // namespace

void measure_homogeneous(AccuracyTable& table) {
    for (const double a : {0.8, 1.2}) uniaxial(table, a);
    for (const Deformation& deformation : deformations()) held_boundary(table, deformation);
}

}  // namespace placode::sim
