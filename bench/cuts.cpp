// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/cuts.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim/cutting/blade_slides.h"
#include "sim/cutting/cutting.h"
#include "sim/solver/slide_vertex.h"
#include "sim/solver/topology.h"
#include "sim/step/step.h"
#include "sim/verify/cut_rim.h"
#include "sim/world/state.h"

namespace placode::bench {
namespace {

using sim::Scene;
using sim::State;
using sim::Vec3;

constexpr double kBladeM = 0.006, kOpenRad = 0.7, kPadM = 4e-4;

struct Cut {
    Vec3 tip, ahead;
    [[nodiscard]] sim::Pose pose() const {
        sim::Mat3 axes;
        axes.col(2) = ahead;
        axes.col(1) = Vec3::UnitZ();
        axes.col(0) = axes.col(1).cross(axes.col(2));
        return {tip, sim::Quat(axes)};
    }
};

/// Evenly over the planned incision, turned against it by up to 35 degrees.
Cut cut_number(const Scene& scene, int i, int of) {
    const auto& contour = scene.geometry.planned_contour;
    const size_t k = contour.size() * static_cast<size_t>(i) / static_cast<size_t>(of);
    const Vec3 along = contour[(k + 1) % contour.size()] - contour[k];
    const double angle = std::atan2(along.y(), along.x()) + 1.2 * (i - of / 2) / of;
    const Vec3 ahead(std::cos(angle), std::sin(angle), 0);
    return {contour[k] + 0.003 * ahead - 0.0003 * Vec3::UnitZ(), ahead};
}

void run(const Scene& scene, State& state, const sim::Pose& pose, double jaw_rad) {
    sim::ToolInput input;
    input.set_pose(pose);
    input.engaged = 1;
    input.jaw_rad = static_cast<float>(jaw_rad);
    sim::ToolFeedback feedback;
    sim::step(scene, state, {&input, 1}, {&feedback, 1});
}

/// Elastic energy of an uncut body [J], zero at rest without pre-tension.
double energy_of(const Scene& scene, const State& state) {
    double sum = 0;
    for (int t = 0; t < scene.body.tet_count(); ++t) {
        const auto& c = sim::corners(scene.body, state.body, t);
        sim::Mat3 rest, now;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<size_t>(i) + 1;
            rest.col(i) = sim::rest_place(scene.body, state.body, c[k]) -
                          sim::rest_place(scene.body, state.body, c[0]);
            now.col(i) = sim::position(state.body, c[k]) - sim::position(state.body, c[0]);
        }
        const sim::Mat3 scaled = sim::rest_stretch(scene.body.spec(), t) * rest;
        const sim::Mat3 f = now * scaled.inverse();
        const auto tissue = static_cast<size_t>(scene.body.mesh().tissue[static_cast<size_t>(t)]);
        const sim::Material& m = scene.body.spec().materials[tissue];
        const sim::NeoHookean n = sim::neo_hookean(m.youngs_modulus_pa, m.poissons_ratio);
        const double j = f.determinant() - n.gamma;
        sum += scaled.determinant() / 6 *
               (n.mu_pa / 2 * (f.squaredNorm() - 3) + n.lambda_pa / 2 * j * j -
                n.lambda_pa / 2 * (1 - n.gamma) * (1 - n.gamma));
    }
    return sum;
}

/// The slides alone, without a frame around them: time, energy, surface.
void measure_slides(const Scene& scene, State& state, const Cut& cut, CutRow& row,
                    std::vector<double>& frames_us) {
    sim::Scissors& s = state.scissors[0];
    s.plane = cut.pose().inverse();
    const sim::BladeReach reach{kBladeM, std::tan(kOpenRad / 2), kPadM};
    sim::begin_slides(scene, state, s, reach);
    while (s.sliding != 0) {
        const double before = energy_of(scene, state);
        const int slides = state.slides;
        const auto start = std::chrono::steady_clock::now();
        if (!sim::slide_to_blades(scene, state, s, reach)) s.sliding = 0;
        const std::chrono::duration<double, std::micro> took =
            std::chrono::steady_clock::now() - start;
        if (state.slides == slides) continue;
        frames_us.push_back(took.count());
        const double after = energy_of(scene, state);
        row.energy_jump = std::max(row.energy_jump, std::abs(after / before - 1));
    }
    s.met_count = 0;
}

}  // namespace

CutRow measure_cuts(sim::OperativeFieldSpec spec, double snap, int snips) {
    spec.cut_snap = snap;
    spec.heat = false;
    spec.tools.assign(1, {});
    spec.tools[0].kind = sim::ToolKind::kScissors;
    spec.tools[0].tip_radius_m = 0.0003;
    spec.tools[0].tip_length_m = kBladeM;
    const auto scene = sim::build_operative_field(spec);
    CutRow row;
    row.snap = snap;
    row.snips = snips;
    double squares = 0, length = 0, path = 0;
    int count = 0;
    std::vector<double> frames_us;
    for (int i = 0; i < snips; ++i) {
        const Cut cut = cut_number(*scene, i, snips);
        State state(*scene, 1);
        constexpr int kFrames = 60;
        run(*scene, state, cut.pose(), 0);
        for (int k = 0; k <= kFrames; ++k)
            run(*scene, state, cut.pose(), kOpenRad * (kFrames - k) / kFrames);
        for (int k = 0; k < 40; ++k) run(*scene, state, cut.pose(), 0);
        const auto rim = sim::cut_rim_mm(*scene, state, cut.tip, cut.ahead);
        for (size_t k = 0; k < rim.size(); ++k) {
            squares += rim[k][1] * rim[k][1];
            row.max_mm = std::max(row.max_mm, std::abs(rim[k][1]));
            if (k == 0) continue;
            length += std::hypot(rim[k][0] - rim[k - 1][0], rim[k][1] - rim[k - 1][1]);
            path += rim[k][0] - rim[k - 1][0];
        }
        count += static_cast<int>(rim.size());
        row.slides += state.slides;
        row.refused += state.slides_refused;
        row.least_quality =
            std::min(row.least_quality, sim::least_quality(scene->body, state.body));
        if (!(snap > 0)) continue;
        State untouched(*scene, 1);
        for (int k = 0; k < 200; ++k)
            run(*scene, untouched, {Vec3(0, 0, 0.03), sim::Quat::Identity()}, 0);
        measure_slides(*scene, untouched, cut, row, frames_us);
    }
    row.rms_mm = count > 0 ? std::sqrt(squares / count) : 0;
    row.length_over_path = path > 0 ? length / path : 0;
    if (!frames_us.empty()) {
        std::sort(frames_us.begin(), frames_us.end());
        row.frame_us = frames_us[frames_us.size() / 2];
        row.worst_us = frames_us.back();
    }
    return row;
}

}  // namespace placode::bench
