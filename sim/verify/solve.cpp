// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a verification scene: which method, and what follows from its final state.
#include <algorithm>
#include <chrono>
#include <ctime>

#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/solver/courant.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {
namespace {

/// Kinetic energy, momentum, and angular momentum about the centre of mass.
void add_motion(const ReferenceBody& body, const Coordinates& x, const Coordinates& v,
                SolveResult& out) {
    double mass = 0;
    Vec3 centre = Vec3::Zero();
    for (int i = 0; i < body.vertex_count(); ++i) {
        const double m = body.mass_kg()[as_index(i)];
        const Vec3 place = x.segment<3>(3 * i), speed = v.segment<3>(3 * i);
        out.not_finite += place.allFinite() && speed.allFinite() ? 0 : 1;
        out.kinetic_energy_j += 0.5 * m * speed.squaredNorm();
        mass += m;
        centre += m * place;
    }
    centre /= mass;
    for (int i = 0; i < body.vertex_count(); ++i) {
        const Vec3 p = body.mass_kg()[as_index(i)] * v.segment<3>(3 * i);
        const Vec3 arm = Vec3(x.segment<3>(3 * i)) - centre;
        out.momentum_kg_m_s += p;
        out.momentum_scale_kg_m_s += p.norm();
        out.angular_momentum_kg_m2_s += arm.cross(p);
        out.angular_momentum_scale_kg_m2_s += arm.norm() * p.norm();
    }
}

}  // namespace

const char* method_name(SolveMethod method) noexcept {
    switch (method) {
        case SolveMethod::kXpbd:
            return "xpbd";
        case SolveMethod::kXpbdPair:
            return "xpbd_pair";
        case SolveMethod::kVbd:
            return "vbd";
        case SolveMethod::kExplicit:
            return "explicit";
        case SolveMethod::kNewton:
            return "newton";
    }
    return "?";
}

void SolveSetup::sample(double time_s, const Coordinates& x, SolveResult& out) const {
    out.sample_time_s.push_back(time_s);
    auto& row = out.probe_m.emplace_back();
    for (const auto& vertices : probe_vertices_) {
        Vec3 mean = Vec3::Zero();
        for (const int32_t v : vertices) mean += x.segment<3>(3 * v);
        row.push_back(mean / static_cast<double>(vertices.size()));
    }
}

void SolveSetup::finish(const Coordinates& x, const Coordinates& v, double time_s,
                        SolveResult& out) const {
    out.simulated_s = time_s;
    out.max_courant = max_courant;
    out.warnings.insert(out.warnings.begin(), warnings.begin(), warnings.end());
    out.final_m = scene.output_points;
    for (size_t p = 0; p < scene.output_points.size(); ++p) {
        const int32_t vertex = scene.vertex_of_output[p];
        if (vertex >= 0) out.final_m[p] = x.segment<3>(3 * vertex);
    }
    add_motion(*body, x, v, out);
    out.elastic_energy_j = body->energy(x);
    out.inverted_tets = body->inverted_tets(x);
    if (out.inverted_tets > 0)
        out.warnings.push_back(std::to_string(out.inverted_tets) +
                               " tets are inverted at the end: no tissue can be in that state");
    check_collapse(out);
    add_reactions(x, time_s, out);
    for (const RegionForce& f : out.contact_forces) out.contact_force_n += f.force_n;
}

/// Below a Poisson's ratio of 0 a point has less energy than the rest shape: the minimum at rest is
/// one among its neighbours only, and large loads carry tissue over its edge.
void SolveSetup::check_collapse(SolveResult& out) const {
    double volume = 0;
    for (size_t t = 0; t < scene.mesh.tets.size(); ++t)
        volume += rest_volume(scene.mesh, static_cast<int>(t));
    const double usual = scene.material.youngs_modulus_pa * volume;
    if (scene.material.poissons_ratio >= 0 || out.elastic_energy_j >= -1e-6 * usual) return;
    out.diverged = true;
    out.at_rest = false;
    out.warnings.emplace_back(
        "diverged: tissue has collapsed, as this energy allows below a Poisson's ratio of 0; "
        "expected smaller loads, or 0 and above");
}

/// A support gives what elastic forces, gravity and loads leave over in its coordinates.
void SolveSetup::add_reactions(const Coordinates& x, double time_s, SolveResult& out) const {
    Coordinates support = Coordinates::Zero(x.size());
    body->add_gradient(x, support);
    Coordinates outer = Coordinates::Zero(x.size());
    add_loads(time_s, outer);
    for (int i = 0; i < body->vertex_count(); ++i)
        outer.segment<3>(3 * i) += body->mass_kg()[as_index(i)] * scene.gravity_m_s2;
    support -= outer;
    std::vector<uint8_t> is_fixed;
    for (const HeldRegion& region : scene.held) {
        out.reactions.push_back({region.pointer, Vec3::Zero()});
        is_fixed.push_back(region.pointer.rfind("/fixed", 0) == 0 ? 1 : 0);
    }
    // A region whose coordinates have all been taken over holds nothing.
    bool any_fixed = false;
    for (const auto& by : held_by_) {
        for (const int32_t r : by) any_fixed = any_fixed || (r >= 0 && is_fixed[as_index(r)] != 0);
    }
    for (size_t i = 0; i < held.size(); ++i) {
        for (size_t a = 0; a < 3; ++a) {
            const int32_t by = held_by_[i][a];
            if (by < 0) continue;
            const double f = support[static_cast<Eigen::Index>(3 * i + a)];
            out.reactions[as_index(by)].force_n[static_cast<Eigen::Index>(a)] += f;
            if (is_fixed[as_index(by)] != 0 || !any_fixed)
                out.reaction_n[static_cast<Eigen::Index>(a)] += f;
        }
    }
}

SolveResult solve(const VerificationScene& scene, const SolveWatch& watch) {
    const SolveMethod method = scene.solver.method;
    if (!scene.sheet.empty() && (method == SolveMethod::kXpbd || method == SolveMethod::kXpbdPair))
        throw VerificationError("/solver/method",
                                std::string("found ") + method_name(method) +
                                    ", which knows tetrahedra only, and " +
                                    std::to_string(scene.sheet.size()) +
                                    " triangles of sheets; expected vbd, explicit or newton");
    if (method == SolveMethod::kVbd && scene.material.poissons_ratio > kVbdMaxPoissonsRatio &&
        !scene.mesh.tets.empty())
        throw VerificationError("/material/poissons_ratio",
                                "found " + shortest_text(scene.material.poissons_ratio) +
                                    "; expected at most " + shortest_text(kVbdMaxPoissonsRatio) +
                                    " for vbd, which would tremble, or method explicit or newton");
    SolveSetup setup(scene, watch);
    SoftBodySpec spec = setup.spec;
    spec.solver.frame_s = scene.solver.frame_s / scene.solver.substeps;
    spec.solver.substeps = 1;
    const auto courant = courant_numbers(spec);
    setup.max_courant = *std::max_element(courant.begin(), courant.end());
    SolveResult out;
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    switch (scene.solver.method) {
        case SolveMethod::kExplicit:
            run_explicit(setup, out);
            break;
        case SolveMethod::kNewton:
            run_newton(setup, out);
            break;
        default:
            run_fast(setup, out);
    }
    out.cpu_s = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC - out.check_s;
    out.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() -
                 out.check_s;
    return out;
}

}  // namespace placode::sim
