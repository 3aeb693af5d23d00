// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/equilibrium.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/number_text.h"

namespace placode::sim {
namespace {

// x E x edge: overlap of some 1e-5 of the indentation.
constexpr double kNewtonContactStiffness = 1000;
constexpr double kUnbalanced = 1e-9;  // of all forces: what is left of sums that cancel
constexpr Eigen::Index kMostUnknowns = 60000;

/// What acts on one piece, and which axes hold it.
struct WeighedPiece {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), place = Vec3::Zero();
    double force_size = 0, moment_size = 0;
    int vertices = 0;
    uint8_t held = 0;
};

std::vector<WeighedPiece> weigh(const SolveSetup& setup, const Coordinates& force_n) {
    const std::vector<int32_t>& number = setup.pieces.of_vertex;
    std::vector<WeighedPiece> pieces(setup.pieces.held.size());
    const Coordinates& x = setup.body->rest();  // a random start turns what is in balance
    for (size_t v = 0; v < number.size(); ++v) {
        WeighedPiece& piece = pieces[as_index(number[v])];
        piece.place += x.segment<3>(static_cast<Eigen::Index>(3 * v));
        ++piece.vertices;
    }
    for (size_t i = 0; i < pieces.size(); ++i) {
        pieces[i].place /= pieces[i].vertices;
        pieces[i].held = setup.pieces.held[i];
    }
    for (size_t v = 0; v < number.size(); ++v) {
        WeighedPiece& piece = pieces[as_index(number[v])];
        const Vec3 f = force_n.segment<3>(static_cast<Eigen::Index>(3 * v));
        const Vec3 arm = Vec3(x.segment<3>(static_cast<Eigen::Index>(3 * v))) - piece.place;
        piece.force += f;
        piece.force_size += f.norm();
        piece.moment += arm.cross(f);
        piece.moment_size += arm.norm() * f.norm();
    }
    return pieces;
}

std::string name_of(const WeighedPiece& piece, size_t count) {
    if (count == 1) return "the body";
    std::string place;
    for (int a = 0; a < 3; ++a) place += (a == 0 ? "" : ", ") + rounded_text(piece.place[a], 4);
    return "the piece of " + std::to_string(piece.vertices) + " vertices around [" + place +
           "] m, one of " + std::to_string(count) + ",";
}

}  // namespace

StaticProblem static_problem(const SolveSetup& setup, double time_s) {
    const VerificationScene& scene = setup.scene;
    const Eigen::Index n = 3 * setup.body->vertex_count();
    StaticProblem problem;
    problem.body = setup.body.get();
    problem.held.assign(as_index(n), 0);
    problem.held_at = setup.body->rest();
    problem.force_n = Coordinates::Zero(n);
    setup.add_loads(time_s, problem.force_n);
    for (int v = 0; v < setup.body->vertex_count(); ++v) {
        problem.force_n.segment<3>(3 * v) +=
            setup.body->mass_kg()[as_index(v)] * scene.gravity_m_s2;
        for (int a = 0; a < 3; ++a) {
            if ((setup.held[as_index(v)] >> a & 1) == 0) continue;
            problem.held[as_index(3 * v + a)] = 1;
            problem.held_at[3 * v + a] = setup.held_at(v, a, time_s);
        }
    }
    if (setup.contacts) {
        problem.contacts = setup.contacts.get();
        problem.contact_n_m = kNewtonContactStiffness * scene.material.youngs_modulus_pa *
                              setup.contacts->mean_edge_m();
        problem.contact_time_s = time_s;
    }
    return problem;
}

void check_support(const SolveSetup& setup, const Coordinates& force_n) {
    if (setup.contacts) return;
    const std::vector<WeighedPiece> pieces = weigh(setup, force_n);
    for (const WeighedPiece& piece : pieces) {
        const std::string name = name_of(piece, pieces.size());
        for (int a = 0; a < 3; ++a) {
            if ((piece.held >> a & 1) != 0 ||
                !(std::abs(piece.force[a]) > kUnbalanced * piece.force_size))
                continue;
            throw VerificationError(
                "/fixed", "nothing holds " + name + " along " + "xyz"[a] +
                              ", but gravity and loads add up to " +
                              rounded_text(piece.force[a], 4) +
                              " N there: newton finds no equilibrium; expected a fixed or "
                              "prescribed region along that axis, or another method");
        }
        if (piece.held == 0 && piece.moment.norm() > kUnbalanced * piece.moment_size)
            throw VerificationError(
                "/fixed", "nothing holds " + name + " but loads turn it with " +
                              rounded_text(piece.moment.norm(), 4) +
                              " N m: newton finds no equilibrium; expected a fixed or prescribed "
                              "region, or another method");
    }
}

bool is_held(const SolveSetup& setup) {
    const std::vector<uint8_t>& held = setup.pieces.held;
    return std::all_of(held.begin(), held.end(), [](uint8_t axes) { return axes == 7; });
}

std::optional<Coordinates> step_to_equilibrium(const SolveSetup& setup, const Coordinates& x,
                                               double time_s) {
    if (setup.contacts || x.size() > kMostUnknowns || !x.allFinite() || !is_held(setup))
        return std::nullopt;
    auto step = newton_step(static_problem(setup, time_s), x);
    if (!step || !(largest_displacement(*step) < setup.extent_m())) return std::nullopt;
    return step;
}

}  // namespace placode::sim
