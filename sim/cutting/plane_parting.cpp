// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/cutting/plane_parting.h"

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/cutting/separation.h"
#include "sim/world/scene.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr int kShare = 16;         // 1/16 of the faces a frame
constexpr uint8_t kPartCount = 3;  // checks in a row
constexpr double kRub = 0.5;       // share of a pressure that is taken off a shear: friction

/// Cauchy stress of a tet [Pa]: mu/J F F^T + lambda (J - gamma) I of sim/core/tissue.h's energy.
Mat3 stress_of(const Scene& scene, const State& state, int tet) noexcept {
    const auto& c = corners(scene.body, state.body, tet);
    Mat3 rest, now;
    for (int i = 0; i < 3; ++i) {
        rest.col(i) =
            rest_place(scene.body, state.body, c[i + 1]) - rest_place(scene.body, state.body, c[0]);
        now.col(i) = position(state.body, c[i + 1]) - position(state.body, c[0]);
    }
    const Mat3 f = now * (rest_stretch(scene.body.spec(), tet) * rest).inverse();
    const Material& material =
        scene.body.spec().materials[as_index(static_cast<int>(scene.body.mesh().tissue[tet]))];
    const NeoHookean m = neo_hookean(material.youngs_modulus_pa, material.poissons_ratio);
    const double j = f.determinant();
    if (!(j > 0.05)) return Mat3::Zero();  // crushed: no pull
    return m.mu_pa / j * f * f.transpose() + m.lambda_pa * (j - m.gamma) * Mat3::Identity();
}

/// What pulls a face off or along, to be held against its strength. What is pressed together rubs.
double parting_pull(const Vec3& traction, const Vec3& normal) noexcept {
    const double off = traction.dot(normal);
    if (off >= 0) return traction.norm();
    return (traction - off * normal).norm() + kRub * off;
}

void check(const Scene& scene, State& state, size_t i) noexcept {
    const DissectionPlane::Face& face = scene.plane.faces[i];
    uint8_t& count = state.undermining.over_count[i];
    Vec3 normal;
    const Vec3 pull = traction_on(scene, state, static_cast<int>(i), normal);
    const bool over = parting_pull(pull, normal) > scene.plane.strength_pa;
    count = over ? static_cast<uint8_t>(count + 1) : uint8_t{0};
    if (count < kPartCount) return;
    count = 0;
    static_cast<void>(cut_face(scene, state, face.above[0], face.face));
}

}  // namespace

Vec3 traction_on(const Scene& scene, const State& state, int face, Vec3& normal) noexcept {
    const DissectionPlane::Face& f = scene.plane.faces[as_index(face)];
    const auto& c = corners(scene.body, state.body, f.above[0]);
    const auto& three = kTetFaces[as_index(f.face)];
    const Vec3 a = position(state.body, c[as_index(three[0])]);
    const Vec3 b = position(state.body, c[as_index(three[1])]) - a;
    const Vec3 d = position(state.body, c[as_index(three[2])]) - a;
    normal = -b.cross(d).normalized();  // out of the tet is down
    Mat3 sum = Mat3::Zero();
    double weights = 0;
    for (const int32_t t : f.above) {
        if (!state.body.tet_alive[as_index(t)]) continue;
        const auto weight = static_cast<double>(rest_volume_of(scene.body, state.body, t));
        sum += weight * stress_of(scene, state, t);
        weights += weight;
    }
    return weights > 0 ? Vec3(sum * normal / weights) : Vec3::Zero();
}

bool is_parted(const Scene& scene, const State& state, int face) noexcept {
    const DissectionPlane::Face& f = scene.plane.faces[as_index(face)];
    return !state.body.tet_alive[as_index(f.above[0])] ||
           state.surface.on_surface(f.above[0], f.face);
}

bool is_freed(const Scene& scene, const State& state, int face) noexcept {
    const DissectionPlane::Face& f = scene.plane.faces[as_index(face)];
    const int32_t above = f.above[0],
                  below = scene.surface.neighbours()[as_index(above)][as_index(f.face)];
    return state.surface.on_surface(above, f.face) && state.body.tet_alive[as_index(above)] != 0 &&
           below >= 0 && state.body.tet_alive[as_index(below)] != 0;
}

void part_plane(const Scene& scene, State& state) noexcept {
    const std::vector<DissectionPlane::Face>& faces = scene.plane.faces;
    if (faces.empty()) return;
    const size_t turn = faces.size() / kShare + 1;
    const size_t from = static_cast<size_t>(state.frame % kShare) * turn;
    for (size_t i = from; i < std::min(faces.size(), from + turn); ++i) {
        const int32_t tet = faces[i].above[0];
        // What sleeps has been looked at before it fell asleep.
        if (is_parted(scene, state, static_cast<int>(i)) ||
            state.sleep.sleeps(corners(scene.body, state.body, tet)))
            continue;
        check(scene, state, i);
    }
}

double undermined_m(const Scene& scene, const State& state, int ray) noexcept {
    double reach = 0;
    for (const DissectionPlane::Stretch& s : scene.plane.rays[as_index(ray)].stretches) {
        if (!is_freed(scene, state, s.face)) break;
        reach = static_cast<double>(s.until_m);
    }
    return reach;
}

double undermined_m2(const Scene& scene, const State& state, int side) noexcept {
    double area = 0;
    for (size_t i = 0; i < scene.plane.faces.size(); ++i) {
        const DissectionPlane::Face& face = scene.plane.faces[i];
        if (face.side == side && is_freed(scene, state, static_cast<int>(i)))
            area += static_cast<double>(face.area_m2);
    }
    return area;
}

UnderminedArea undermined_area(const Scene& scene, const State& state, int side) noexcept {
    UnderminedArea sum;
    for (size_t i = 0; i < scene.plane.faces.size(); ++i) {
        const DissectionPlane::Face& face = scene.plane.faces[i];
        if (face.side != side || !(face.wanted || face.beyond)) continue;
        const auto area = static_cast<double>(face.area_m2);
        const bool parted = is_parted(scene, state, static_cast<int>(i));
        if (face.wanted) sum.wanted_m2 += area;
        if (face.wanted && parted) sum.parted_m2 += area;
        if (face.wanted && is_freed(scene, state, static_cast<int>(i))) sum.freed_m2 += area;
        if (face.beyond && parted) sum.beyond_m2 += area;
    }
    return sum;
}

}  // namespace placode::sim
