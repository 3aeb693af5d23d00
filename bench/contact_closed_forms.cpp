// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/closed_forms.h"
#include "sim/core/number_text.h"
#include "sim/verify/felt_block.h"

namespace placode::bench {
namespace {

/// Force against depth, after a wait at each.
ClosedFormPanel indentation(double wait_s) {
    constexpr double kStep = 2e-5, kDeepest = 2e-4, kMilli = 1e3;
    sim::FeltBlock block = sim::hertz_block();
    // A tip that rests at every depth would put the tissue around it to sleep, step by step.
    block.sleep = false;
    sim::FeltHand hand(block, 4);
    ClosedFormPanel panel{"Tip of radius 1.5 mm in skin",
                          "depth [mm]",
                          "force [mN]",
                          "largest difference, of the force at 0.2 mm",
                          "Hertz",
                          0.1,
                          {}};
    ClosedFormSeries series{"felt by the hand", {}, {}, 0};
    const double full = sim::hertz_force(block.tip_radius_m, kDeepest);
    for (int i = 1; i <= std::lround(kDeepest / kStep); ++i) {
        const double depth = i * kStep, force = hand.press(depth, wait_s).z();
        series.found.emplace_back(depth * kMilli, force * kMilli);
        series.error = std::max(
            series.error, std::abs(force - sim::hertz_force(block.tip_radius_m, depth)) / full);
    }
    for (int i = 0; i <= 60; ++i) {
        const double depth = kDeepest * i / 60;
        series.exact.emplace_back(depth * kMilli,
                                  sim::hertz_force(block.tip_radius_m, depth) * kMilli);
    }
    panel.series.push_back(series);
    return panel;
}

/// Share of the force along the surface while a plane is drawn over tissue: it sticks, then slides.
ClosedFormPanel friction() {
    constexpr int kFrames = 300;  // of 1 um each
    ClosedFormPanel panel{"Plane drawn over skin",
                          "path of the plane [mm]",
                          "tangential / normal force",
                          "difference of the last point, of mu",
                          "Coulomb",
                          0.01,
                          {}};
    for (const double mu : {0.1, 0.3, 0.5}) {
        ClosedFormSeries series{"mu = " + sim::fixed_text(mu, 1), {}, {}, 0};
        sim::FeltHand hand(sim::incline_block(mu), 4);
        hand.press(5e-5, 0.05);
        for (int i = 0; i <= kFrames; ++i) {
            const sim::Vec3 force = hand.frame(sim::Vec3(1e-6 * i, 0, -5e-5));
            if (i % 20 == 0) series.found.emplace_back(1e-3 * i, -force.x() / force.z());
        }
        series.exact = {{0, mu}, {1e-3 * kFrames, mu}};
        series.error = std::abs(series.found.back().y() / mu - 1);
        panel.series.push_back(series);
    }
    return panel;
}

}  // namespace

ClosedFormFigure contact_closed_forms(double wait_s) {
    return {"contact", "Contact against Hertz and Coulomb", {indentation(wait_s), friction()}};
}

}  // namespace placode::bench
