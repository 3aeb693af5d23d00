// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/closed_forms.h"
#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/rod/rod_step.h"

namespace placode::bench {
namespace {

using sim::as_index;
using sim::Vec2;
using sim::Vec3;

constexpr double kLength = 0.02;  // m
constexpr int kSegments = 40;

sim::RodSpec thread_of_20_mm() {
    sim::RodSpec spec;
    spec.segments = kSegments;
    spec.length_m = kLength;
    return spec;
}

/// Steps until no node moves faster than 1 nm/s.
void settle(const sim::Rod& rod, sim::RodState& state, const sim::RodDrive& drive) {
    sim::RodScratch scratch(rod);
    for (int i = 0; i < 100000; ++i) {
        sim::step_rod(rod, state, drive, scratch);
        double fastest = 0;
        for (const Vec3& v : state.v) fastest = std::max(fastest, v.norm());
        if (i > 20 && fastest < 1e-9) return;
    }
}

/// Shape of a clamped horizontal rod of length 1 whose weight is `load` = w L^3 / EI, by shooting
/// on theta'' = load (1 - s) cos theta, theta downwards: no stretch, no shear. (steps + 1) places.
std::vector<Vec2> heavy_elastica(double load) {
    constexpr int kSteps = 4000;
    const auto shape = [&](double slope, double& moment) {
        const double h = 1.0 / kSteps;
        Vec2 y(0, slope), place(0, 0);
        std::vector<Vec2> places{place};
        const auto rate = [&](double s, const Vec2& a) {
            return Vec2(a[1], -load * (1 - s) * std::cos(a[0]));
        };
        for (int i = 0; i < kSteps; ++i) {  // Runge-Kutta of fourth order
            const double s = i * h;
            const Vec2 k1 = rate(s, y), k2 = rate(s + h / 2, y + h / 2 * k1),
                       k3 = rate(s + h / 2, y + h / 2 * k2), k4 = rate(s + h, y + h * k3);
            const double before = y[0];
            y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
            const double middle = 0.5 * (before + y[0]);
            place += h * Vec2(std::cos(middle), -std::sin(middle));
            places.push_back(place);
        }
        moment = y[1];
        return places;
    };
    double low = 0, high = load, moment = 0;
    for (int i = 0; i < 100; ++i) {  // the free end bears no moment
        const double slope = 0.5 * (low + high);
        (void)shape(slope, moment);
        (moment > 0 ? high : low) = slope;
    }
    return shape(0.5 * (low + high), moment);
}

ClosedFormPanel cantilever() {
    ClosedFormPanel panel{"Clamped thread under its weight",
                          "x / L",
                          "z / L",
                          "largest distance of a node, of the sag",
                          "elastica",
                          0.003,
                          {}};
    const sim::Rod rod(thread_of_20_mm());
    const sim::RodSpec& spec = rod.spec();
    const double mass_per_m = spec.density_kg_m3 * std::numbers::pi * spec.radius_m * spec.radius_m;
    for (const double load : {2.0, 10.0, 50.0}) {
        std::vector<Vec3> straight;
        for (int i = 0; i <= kSegments; ++i) straight.emplace_back(kLength * i / kSegments, 0, 0);
        sim::RodState state(rod, straight);
        sim::hold_node(state, 0);
        sim::clamp_end(state, 0);
        sim::RodDrive drive;
        drive.h_s = 2e-3;
        drive.gravity_m_s2 =
            Vec3(0, 0, -load * spec.stiffness.bend_n_m2 / (mass_per_m * std::pow(kLength, 3)));
        settle(rod, state, drive);
        ClosedFormSeries series{"w L^3 / EI = " + sim::fixed_text(load, 0), {}, {}, 0};
        const std::vector<Vec2> exact = heavy_elastica(load);
        const size_t every = (exact.size() - 1) / kSegments;
        for (int i = 0; i <= kSegments; ++i) {
            const Vec3& x = state.x[as_index(i)];
            const Vec2 place(x.x() / kLength, x.z() / kLength), should = exact[as_index(i) * every];
            if (i % 4 == 0) series.found.push_back(place);
            series.exact.push_back(should);
            series.error =
                std::max(series.error, (place - should).norm() / std::abs(exact.back().y()));
        }
        panel.series.push_back(series);
    }
    return panel;
}

/// Load of a pinned column that has buckled, over Euler's, and its shortening, by the largest slope
/// at its ends: P = (2 K(k) / pi)^2, shortening 2 (1 - E(k) / K(k)), k = sin(slope / 2).
Vec2 buckled(double slope_rad) {
    const double k = std::sin(slope_rad / 2), first = std::comp_ellint_1(k);
    return {100 * 2 * (1 - std::comp_ellint_2(k) / first),
            std::pow(2 * first / std::numbers::pi, 2)};
}

double load_at(double shortening_percent) {
    double low = 1e-3, high = 2;
    for (int i = 0; i < 100; ++i) {
        const double slope = 0.5 * (low + high);
        (buckled(slope).x() > shortening_percent ? high : low) = slope;
    }
    return buckled(low).y();
}

ClosedFormPanel column() {
    ClosedFormPanel panel{"Pinned thread pushed together",
                          "shortening [% of L]",
                          "load / Euler's load",
                          "largest difference, of Euler's load",
                          "elastica",
                          0.003,
                          {}};
    const sim::Rod rod(thread_of_20_mm());
    const double euler = std::pow(std::numbers::pi / kLength, 2) * rod.spec().stiffness.bend_n_m2;
    std::vector<Vec3> places;  // 1 um off the straight line
    for (int i = 0; i <= kSegments; ++i) {
        const double s = static_cast<double>(i) / kSegments;
        places.emplace_back(kLength * s, 0, 1e-6 * std::sin(std::numbers::pi * s));
    }
    sim::RodState state(rod, places);
    sim::hold_node(state, 0);
    sim::hold_node(state, kSegments);
    sim::RodDrive drive;
    drive.h_s = 2e-3;
    drive.gravity_m_s2.setZero();
    ClosedFormSeries series{"thread of 40 segments", {}, {}, 0};
    for (const double percent : {0.5, 2.5, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0}) {
        state.node_target[kSegments].x() = kLength * (1 - percent / 100);
        settle(rod, state, drive);
        const double load = -sim::segment_force(rod, state, kSegments / 2).x() / euler;
        series.found.emplace_back(percent, load);
        series.error = std::max(series.error, std::abs(load - load_at(percent)));
    }
    series.exact.emplace_back(0, 1);
    for (double slope = 0.05; buckled(slope).x() < 32; slope += 0.05)
        series.exact.push_back(buckled(slope));
    panel.series.push_back(series);
    return panel;
}

}  // namespace

ClosedFormFigure thread_closed_forms() {
    return {"thread", "Suture thread against the elastica", {cantilever(), column()}};
}

}  // namespace placode::bench
