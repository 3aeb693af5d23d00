// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Contact as it is felt: the simulator's own frame (sim/step) with an instrument in a hand, on
// blocks of tissue. The force that goes to the hand is held against Hertz, against Coulomb's cone,
// and, of a needle that is dragged, against the same frames in many more substeps.
#include <algorithm>
#include <cmath>

#include "sim/verify/accuracy_table.h"
#include "sim/verify/felt_block.h"

namespace placode::sim {
namespace {

AccuracyRow felt_row(const FeltHand& hand, const char* setting, const char* quantity) {
    const SolverSettings& s = hand.body().spec().solver;
    AccuracyRow out;
    set_text(out.study, "contact as felt");
    set_text(out.setting, setting);
    set_text(out.method, "vbd");
    set_text(out.quantity, quantity);
    out.h_s = s.frame_s / s.substeps;
    out.tets = hand.body().tet_count();
    const auto courant = hand.body().courant_numbers();
    out.courant = *std::max_element(courant.begin(), courant.end());
    out.cost = hand.cost();
    return out;
}

/// A round tip that a machine presses into skin: the force of Hertz.
void hertz(AccuracyTable& table) {
    constexpr double kDepth = 1e-4;
    const FeltBlock block = hertz_block();
    for (const int substeps : {2, 4, 8}) {
        FeltHand hand(block, substeps);
        const Vec3 force = hand.press(kDepth, table.quick() ? 0.05 : 0.2);
        AccuracyRow row = felt_row(hand, "probe of 1.5 mm pressed 0.1 mm into 60 kPa, nu 0.45",
                                   "force on the hand against Hertz");
        set_text(row.unit, "N");
        row.edge_m = 1e-4;
        row.value = force.z();
        row.expected = hertz_force(block.tip_radius_m, kDepth);
        row.error = std::abs(row.value / row.expected - 1);
        row.target = 0.1;
        table.add(row);
    }
}

/// A plane (a tip of 50 m) drawn over tissue: its force leans by the angle of friction, the slope
/// at which a block begins to slide.
void incline(AccuracyTable& table) {
    for (const double mu : {0.1, 0.3, 0.5}) {
        FeltHand hand(incline_block(mu), 4);
        hand.press(5e-5, 0.05);
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < 350; ++i) force = hand.frame(Vec3(1e-6 * i, 0, -5e-5));
        AccuracyRow row = felt_row(hand,
                                   mu < 0.2   ? "plane drawn over 60 kPa, friction 0.1"
                                   : mu < 0.4 ? "plane drawn over 60 kPa, friction 0.3"
                                              : "plane drawn over 60 kPa, friction 0.5",
                                   "tangent of the angle of the force against friction");
        row.edge_m = 5e-4;
        row.value = -force.x() / force.z();
        row.expected = mu;
        row.error = std::abs(row.value / mu - 1);
        row.target = 0.01;
        table.add(row);
    }
}

/// Forces of a needle's tip pressed in and dragged, frame by frame.
std::vector<Vec3> drag(FeltHand& hand) {
    constexpr double kDepth = 3e-4, kSpeed = 3e-3;
    hand.press(kDepth, 0.1);
    std::vector<Vec3> out;
    for (int i = 0; i < 500; ++i) out.push_back(hand.frame(Vec3(kSpeed * 1e-3 * i, 0, -kDepth)));
    return out;
}

void dragged_needle(AccuracyTable& table) {
    FeltBlock block;
    block.size_m = Vec3(8e-3, 8e-3, 3e-3);
    block.cells = {20, 20, 8};
    block.friction = 0.1;
    block.tip_radius_m = 2.5e-4;
    block.hand_n_m = 600;
    FeltHand truth(block, 64);
    const std::vector<Vec3> expected = drag(truth);
    for (const int substeps : {2, 4, 8}) {
        FeltHand hand(block, substeps);
        const std::vector<Vec3> found = drag(hand);
        double off = 0, size = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            off += (found[i] - expected[i]).squaredNorm();
            size += expected[i].squaredNorm();
        }
        AccuracyRow row =
            felt_row(hand, "needle of 0.25 mm, 0.3 mm deep in 60 kPa, dragged at 3 mm/s",
                     "force on the hand against 64 substeps a frame (RMS)");
        row.edge_m = 4e-4;
        row.value = row.error = std::sqrt(off / size);
        // A hand tells two forces apart from 7 to 10 % on.
        row.target = substeps >= 4 ? 0.1 : 0;
        table.add(row);
    }
}

}  // namespace

void measure_felt(AccuracyTable& table) {
    hertz(table);
    incline(table);
    dragged_needle(table);
}

}  // namespace placode::sim
