// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/rigid_modes.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/turn.h"
#include "sim/solver/double_float.h"

namespace placode::sim {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr uint8_t kAllAxes = 7;
constexpr double kThin = 1e-9;     // of the trace: a body shrunk to a line has no spin
constexpr double kSettled = 1e-7;  // of an edge: what such a step leaves is its square

bool can_turn(const Mat3& inertia) {
    const Vec3 principal = inertia.selfadjointView<Eigen::Lower>().eigenvalues();
    return principal.minCoeff() > kThin * inertia.trace();
}

}  // namespace

RigidModes::RigidModes(const SolveSetup& setup, const SoftBody& body, SoftBodyState& state,
                       double h_body)
    : body_(body), state_(state), h_(h_body), gravity_(body.spec().solver.gravity_m_s2) {
    const BodyPieces& found = setup.pieces;
    std::vector<int32_t> number(found.held.size(), -1);
    for (size_t i = 0; i < found.held.size(); ++i) {
        if (found.held[i] == kAllAxes) continue;
        number[i] = static_cast<int32_t>(pieces_.size());
        pieces_.emplace_back().held = found.held[i];
    }
    piece_of_.reserve(found.of_vertex.size());
    for (size_t v = 0; v < found.of_vertex.size(); ++v) {
        piece_of_.push_back(number[as_index(found.of_vertex[v])]);
        if (piece_of_[v] < 0) continue;
        Piece& piece = pieces_[as_index(piece_of_[v])];
        piece.vertices.push_back(static_cast<int32_t>(v));
        piece.mass += body.mass_kg()[v];
    }
}

void RigidModes::begin() {
    for (Piece& piece : pieces_) {
        const Vec3 from = exact_position(state_, piece.vertices.front());
        Vec3 place = Vec3::Zero(), momentum = Vec3::Zero(), turn = Vec3::Zero();
        Mat3 inertia = Mat3::Zero();
        for (const int32_t v : piece.vertices) {
            const double m = body_.mass_kg()[as_index(v)];
            const Vec3 r = exact_position(state_, v) - from, p = m * to_vec(state_.v[as_index(v)]);
            place += m * r;
            momentum += p;
            turn += r.cross(p);
            inertia += inertia_of(m, r);
        }
        place /= piece.mass;
        inertia -= inertia_of(piece.mass, place);
        turn -= place.cross(momentum);
        piece.centre = from + place;
        piece.speed = momentum / piece.mass;
        piece.spin.setZero();
        if (piece.held == 0 && can_turn(inertia)) piece.spin = inertia.ldlt().solve(turn);
    }
}

Vec3 RigidModes::displacement(int32_t vertex) const {
    if (piece_of_[as_index(vertex)] < 0) return Vec3::Zero();
    const Piece& piece = pieces_[as_index(piece_of_[as_index(vertex)])];
    const Vec3 r = to_vec(state_.x_start[as_index(vertex)]) - piece.centre;
    Vec3 offset = h_ * (piece.speed + piece.spin.cross(r));
    for (int a = 0; a < 3; ++a) {
        if ((piece.held >> a & 1) != 0) offset[a] = 0;
    }
    return offset;
}

/// Where a vertex would go in this substep if it had no neighbours.
Vec3 RigidModes::plan(int32_t vertex) const {
    Vec3 speed = to_vec(state_.v[as_index(vertex)]) + h_ * gravity_;
    if (!state_.force_n.empty())
        speed += h_ / body_.mass_kg()[as_index(vertex)] * to_vec(state_.force_n[as_index(vertex)]);
    return h_ * speed;
}

RigidModes::Sums RigidModes::sum(const Piece& piece) const {
    Sums out;
    const int32_t first = piece.vertices.front();
    const Vec3 from = exact_position(state_, first), first_moved = moved_in_substep(state_, first);
    Vec3 place = Vec3::Zero(), start = Vec3::Zero(), went = Vec3::Zero(), planned = Vec3::Zero();
    for (const int32_t v : piece.vertices) {
        const double m = body_.mass_kg()[as_index(v)];
        const Vec3 r = exact_position(state_, v) - from;
        const Vec3 offset = moved_in_substep(state_, v), wanted = plan(v);
        const Vec3 before = r - (offset - first_moved);  // from where the first vertex was
        place += m * r;
        start += m * before;
        went += m * offset;
        planned += m * wanted;
        out.missing_turn += m * (before.cross(wanted) - r.cross(offset));
        out.inertia += inertia_of(m, r);
    }
    place /= piece.mass;
    start /= piece.mass;
    out.missing = planned - went;
    out.missing_turn += place.cross(went) - start.cross(planned);
    out.inertia -= inertia_of(piece.mass, place);
    out.centre = from + place;
    return out;
}

bool RigidModes::solve_once(const std::vector<ContactPush>& pushes) {
    bool moved = false;
    for (size_t number = 0; number < pieces_.size(); ++number) {
        const int32_t first = pieces_[number].vertices.front();
        const auto edge = static_cast<double>(body_.shortest_edge_m()[as_index(first)]);
        const double path = move(static_cast<int32_t>(number), pushes);
        moved = moved || path > kSettled * edge;
    }
    return moved;
}

/// One Newton step of the six unknowns; returns the longest way of a vertex [m].
double RigidModes::move(int32_t number, const std::vector<ContactPush>& pushes) {
    const Piece& piece = pieces_[as_index(number)];
    const Sums sums = sum(piece);
    const bool turns = piece.held == 0 && can_turn(sums.inertia);
    // Times h^2: masses and modes instead of forces.
    Mat6 system = Mat6::Zero();
    Vec6 rest;
    system.topLeftCorner<3, 3>() = piece.mass * Mat3::Identity();
    system.bottomRightCorner<3, 3>() = sums.inertia;
    rest << sums.missing, sums.missing_turn;
    for (const ContactPush& push : pushes) {
        if (piece_of_[as_index(push.vertex)] != number) continue;
        const Vec3 r = push.at - sums.centre;
        Eigen::Matrix<double, 3, 6> modes;  // of that place, for each unknown
        modes << Mat3::Identity(), -cross_matrix(r);
        rest += h_ * h_ * modes.transpose() * push.force_n;
        system += h_ * h_ * modes.transpose() * push.stiffness_n_m * modes;
    }
    for (int k = 0; k < 6; ++k) {
        if (k < 3 ? (piece.held >> k & 1) == 0 : turns) continue;
        system.row(k).setZero();
        system.col(k).setZero();
        system(k, k) = 1;
        rest[k] = 0;
    }
    const Vec6 step = system.ldlt().solve(rest);
    if (!step.allFinite()) return 0;
    const Vec3 offset = step.head<3>(), turn = step.tail<3>();
    const double angle = turn.norm();
    const Mat3 rotation =
        angle > 0 ? Mat3(Eigen::AngleAxisd(angle, turn / angle)) : Mat3::Identity();
    double longest = 0;
    for (const int32_t v : piece.vertices) {
        const Vec3 r = exact_position(state_, v) - sums.centre;
        const Vec3 moved = offset + (rotation * r - r);
        longest = std::max(longest, moved.squaredNorm());
        move_vertex(state_, v, moved);
    }
    return std::sqrt(longest);
}

}  // namespace placode::sim
