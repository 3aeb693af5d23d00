// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/contact/whole_body.h"

#include <Eigen/Cholesky>

namespace placode::sim {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

}  // namespace

Pushes Pushes::about(const Vec3& c) const noexcept {
    const Mat3 shift = cross_matrix(c);
    Pushes out = *this;
    out.torque -= c.cross(force);
    out.mixed -= moves * shift;
    out.turns +=
        -shift.transpose() * mixed - mixed.transpose() * shift + shift.transpose() * moves * shift;
    return out;
}

std::optional<WholeStep> whole_step(const WholeSums& sums, const Pushes& pushes,
                                    bool turns) noexcept {
    const Vec3 centre = sums.place / sums.mass_kg, start = sums.start / sums.mass_kg;
    if (!turns) {
        const Eigen::LLT<Mat3> solved(sums.mass_kg * Mat3::Identity() + pushes.moves);
        if (solved.info() != Eigen::Success) return std::nullopt;
        const Vec3 offset = solved.solve(sums.planned - sums.went + pushes.force);
        if (!offset.allFinite()) return std::nullopt;
        return WholeStep{centre, offset, Vec3::Zero()};
    }
    const Pushes there = pushes.about(centre);
    Mat6 system;
    system << sums.mass_kg * Mat3::Identity() + there.moves, -there.mixed, -there.mixed.transpose(),
        sums.inertia - inertia_of(sums.mass_kg, centre) + there.turns;
    Vec6 rest;
    rest << sums.planned - sums.went + there.force,
        sums.missing_turn + centre.cross(sums.went) - start.cross(sums.planned) + there.torque;
    const Eigen::LLT<Mat6> solved(system);
    if (solved.info() != Eigen::Success) return std::nullopt;
    const Vec6 step = solved.solve(rest);
    if (!step.allFinite()) return std::nullopt;
    return WholeStep{centre, step.head<3>(), step.tail<3>()};
}

}  // namespace placode::sim
