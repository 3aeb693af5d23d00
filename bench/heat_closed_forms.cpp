// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/closed_forms.h"
#include "sim/core/as_index.h"
#include "sim/core/number_text.h"
#include "sim/heat/heat.h"

namespace placode::bench {
namespace {

using sim::as_index;
using sim::Vec3;

constexpr double kConductivity = 0.5, kDensity = 1050,
                 kCapacity = 3600;                                       // W/(m K), kg/m3, J/(kg K)
constexpr double kDiffusivity = kConductivity / (kDensity * kCapacity);  // m2/s
constexpr double kBody = 37;                                             // degrees Celsius

/// A block of tissue that loses no heat.
class InsulatedBlock {
 public:
    InsulatedBlock(const Vec3& size, const std::array<int, 3>& cells)
        : body_(made(size, cells)),
          model_(body_.mesh(), body_.spec().materials, insulated()),
          tissue_(body_),
          state_(model_, body_.vertex_count(), body_.tet_count()) {}

    [[nodiscard]] const std::vector<Vec3>& places() const { return body_.mesh().rest; }
    void warm(int v) {
        if (state_.warm[as_index(v)] != 0) return;
        state_.warm[as_index(v)] = 1;
        state_.warm_list[as_index(state_.warm_count++)] = v;
    }
    void heat_to(int v, double celsius) {
        warm(v);
        state_.enthalpy_j[as_index(v)] = state_.capacity_j_k[as_index(v)] * (celsius - kBody);
        state_.temperature_c[as_index(v)] = static_cast<float>(celsius);
    }
    void give(int v, double power_w) {
        warm(v);
        state_.power_w[as_index(v)] = power_w;
    }
    void advance(double seconds) {
        std::array<int32_t, 1> gone{};
        (void)sim::step_heat(body_, model_, state_, tissue_.tet_alive, seconds, gone);
    }
    [[nodiscard]] int count() const { return body_.vertex_count(); }
    [[nodiscard]] double celsius(int v) const { return state_.temperature_c[as_index(v)]; }

 private:
    static sim::HeatSettings insulated() {
        sim::HeatSettings settings;
        settings.surface_cooling_w_m2k = 0;
        return settings;
    }
    static sim::SoftBody made(const Vec3& size, const std::array<int, 3>& cells) {
        sim::SoftBodySpec spec;
        spec.mesh = sim::box_mesh(size, cells);
        sim::Material material;
        material.density_kg_m3 = kDensity;
        material.heat_capacity_j_kgk = kCapacity;
        material.heat_conductivity_w_mk = kConductivity;
        spec.materials.fill(material);
        spec.fixed = {0};
        return sim::SoftBody(std::move(spec));
    }

    sim::SoftBody body_;
    sim::HeatModel model_;
    sim::SoftBodyState tissue_;
    sim::HeatState state_;
};

/// A bar, its left half 20 K warmer: T = 37 + 10 erfc(x / sqrt(4 alpha t)).
ClosedFormPanel step_of_temperature() {
    constexpr double kMiddle = 0.006, kStep = 0.01, kMilli = 1e3;
    ClosedFormPanel panel{"Two halves, 20 K apart",
                          "from the border [mm]",
                          "temperature [deg C]",
                          "largest difference, of the 20 K",
                          "error function",
                          0.01,
                          {}};
    InsulatedBlock bar(Vec3(2 * kMiddle, 0.001, 0.001), {48, 4, 4});
    for (int v = 0; v < bar.count(); ++v) {
        const double x = bar.places()[as_index(v)].x() - kMiddle;
        bar.heat_to(v, x < -1e-6 ? 57 : x > 1e-6 ? kBody : 47);
    }
    int steps = 0;
    for (const int seconds : {1, 4, 9}) {
        for (; steps < std::lround(seconds / kStep); ++steps) bar.advance(kStep);
        const auto exact = [&](double x) {
            return kBody + 10 * std::erfc(x / std::sqrt(4 * kDiffusivity * seconds));
        };
        ClosedFormSeries series{"after " + std::to_string(seconds) + " s", {}, {}, 0};
        for (int v = 0; v < bar.count(); ++v) {
            const Vec3& p = bar.places()[as_index(v)];
            const double x = p.x() - kMiddle, found = bar.celsius(v);
            series.error = std::max(series.error, std::abs(found - exact(x)) / 20);
            // One row of vertices, every other one.
            const long cell = std::lround(x / 0.00025);
            if (p.y() < 1e-9 && p.z() < 1e-9 && cell % 2 == 0 && std::abs(x) < 0.0041)
                series.found.emplace_back(x * kMilli, found);
        }
        for (int i = 0; i <= 80; ++i) {
            const double x = -0.004 + 0.008 * i / 80;
            series.exact.emplace_back(x * kMilli, exact(x));
        }
        panel.series.push_back(series);
    }
    return panel;
}

/// Means over vertices in shells about the source: distance, rise, and rise by `exact`. A lattice
/// conducts faster along its axes than along its diagonals, which the mean over directions cancels.
template <class Exact>
std::vector<Vec3> shells(const InsulatedBlock& block, const Vec3& centre, const Exact& exact) {
    constexpr double kWidth = 0.0002, kFirst = 0.001;
    std::vector<Vec3> sum(12, Vec3::Zero());
    std::vector<int> count(sum.size(), 0);
    for (int v = 0; v < block.count(); ++v) {
        const double r = (block.places()[as_index(v)] - centre).norm();
        const long shell = std::lround((r - kFirst) / kWidth);
        if (shell < 0 || shell >= static_cast<long>(sum.size())) continue;
        sum[as_index(shell)] += Vec3(r, block.celsius(v) - kBody, exact(r));
        ++count[as_index(shell)];
    }
    for (size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(1, count[i]);
    return sum;
}

/// A point that gives 30 mW in a cube: rise = q / (4 pi k r) erfc(r / sqrt(4 alpha t)).
ClosedFormPanel point_source() {
    constexpr double kPower = 0.03, kStep = 0.02, kMilli = 1e3;
    ClosedFormPanel panel{"Point source of 30 mW",
                          "from the source [mm]",
                          "rise of temperature [K]",
                          "largest difference of the mean at one distance, of the rise at 1 mm",
                          "Green's function",
                          0.05,
                          {}};
    const Vec3 centre = Vec3::Constant(0.006);
    InsulatedBlock cube(2 * centre, {32, 32, 32});
    const auto nearer = [&](const Vec3& a, const Vec3& b) {
        return (a - centre).norm() < (b - centre).norm();
    };
    const auto source =
        static_cast<int>(std::min_element(cube.places().begin(), cube.places().end(), nearer) -
                         cube.places().begin());
    int steps = 0;
    for (const int seconds : {6, 20}) {
        for (; steps < std::lround(seconds / kStep); ++steps) {
            cube.give(source, kPower);
            cube.advance(kStep);
        }
        const auto exact = [&](double r) {
            return kPower / (4 * std::numbers::pi * kConductivity * r) *
                   std::erfc(r / std::sqrt(4 * kDiffusivity * seconds));
        };
        ClosedFormSeries series{"after " + std::to_string(seconds) + " s", {}, {}, 0};
        for (const Vec3& shell : shells(cube, centre, exact)) {
            series.found.emplace_back(shell.x() * kMilli, shell.y());
            series.error = std::max(series.error, std::abs(shell.y() - shell.z()) / exact(0.001));
        }
        for (int i = 0; i <= 60; ++i) {
            const double r = 0.0009 + 0.0024 * i / 60;
            series.exact.emplace_back(r * kMilli, exact(r));
        }
        panel.series.push_back(series);
    }
    return panel;
}

}  // namespace

ClosedFormFigure heat_closed_forms() {
    return {"heat", "Conduction against closed forms", {step_of_temperature(), point_source()}};
}

}  // namespace placode::bench
