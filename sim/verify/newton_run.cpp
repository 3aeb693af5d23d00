// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// `newton` on a verification scene: the equilibrium at the end of its time.
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/bounds.h"
#include "sim/core/fnv_hash.h"
#include "sim/core/number_text.h"
#include "sim/verify/equilibrium.h"

namespace placode::sim {
namespace {

int load_steps(const SolveSetup& setup, double time_s) {
    double farthest = 0;
    for (const HeldRegion& r : setup.scene.held)
        farthest = std::max(farthest, r.displacement_m.norm());
    const double size = bounds_of(setup.scene.mesh.rest).diagonal().norm();
    double steps = std::ceil(farthest / (0.1 * size));
    for (const SphereObstacle& s : setup.scene.spheres)
        steps = std::max(steps, std::ceil(s.velocity_m_s.norm() * time_s / (0.2 * s.radius_m)));
    return static_cast<int>(std::clamp(steps, 1.0, 50.0));
}

/// What moves or rubs makes the answer depend on the way there, which newton does not know.
double time_of_equilibrium(const SolveSetup& setup, SolveResult& out) {
    const VerificationScene& scene = setup.scene;
    bool moving = false, friction = false;
    for (const SphereObstacle& s : scene.spheres) {
        moving = moving || s.velocity_m_s.norm() > 0;
        friction = friction || s.friction > 0;
    }
    if (friction) out.warnings.emplace_back("newton: friction depends on the path and is left out");
    // Rest: after the last ramp. With a moving sphere there is no rest, the end counts.
    if (!scene.rest_speed_m_s || moving) return scene.end_s;
    return std::min(scene.end_s, setup.longest_ramp_s());
}

NewtonSettings newton_settings(const SolveSetup& setup, double time_s) {
    NewtonSettings settings;
    settings.load_steps = load_steps(setup, time_s);
    settings.watch = [&setup](double share, const NewtonReport& report) {
        setup.report([&] {
            return rounded_text(100 * share, 4) + " % of the load, " +
                   std::to_string(report.iterations) + " iterations, residual " +
                   rounded_text(report.residual_n, 2) + " N";
        });
    };
    // Touches that come and go make the last digits slow.
    if (setup.contacts) settings.tolerance = 1e-7;
    return settings;
}

/// From the scene's start shape to equilibrium in `x`.
NewtonReport find_equilibrium(const SolveSetup& setup, const StaticProblem& problem,
                              const NewtonSettings& settings, Coordinates& x, SolveResult& out) {
    const VerificationScene& scene = setup.scene;
    NewtonReport report = solve_static(problem, x, settings);
    if (scene.start.kind != StartKind::kRest && setup.body->inverted_tets(x) > 0) {
        // A body crushed to a point or a plane is a local minimum of this energy as well.
        out.warnings.emplace_back(
            "newton: from this start it ended with inverted tets; re-seeded from the rest shape");
        x = setup.body->rest();
        report = solve_static(problem, x, settings);
    }
    return report;
}

void tell_convergence(const NewtonReport& report, SolveResult& out) {
    out.newton_iterations = report.iterations;
    out.newton_residual_n = report.residual_n;
    out.at_rest = report.converged;
    if (report.converged) return;
    out.diverged = true;
    out.warnings.push_back("newton: no equilibrium found, residual " +
                           rounded_text(report.residual_n, 4) + " N of " +
                           rounded_text(report.force_scale_n, 4) + " N after " +
                           std::to_string(report.iterations) + " iterations");
}

void tell_contacts(const SolveSetup& setup, const StaticProblem& problem, double time_s,
                   const Coordinates& x, SolveResult& out) {
    Coordinates unused = Coordinates::Zero(x.size());
    const auto forces =
        add_contact(*setup.contacts, x, time_s, problem.contact_n_m, unused, nullptr);
    for (size_t i = 0; i < forces.size(); ++i)
        out.contact_forces.push_back({"/sdf_contacts/" + std::to_string(i), forces[i]});
    std::vector<SphereTouch> touches;
    setup.contacts->find([&x](int32_t v) { return Vec3(x.segment<3>(3 * v)); }, time_s, 0, touches);
    for (const SphereTouch& t : touches) out.penetration_m = std::max(out.penetration_m, -t.gap_m);
}

}  // namespace

void run_newton(const SolveSetup& setup, SolveResult& out) {
    const double time_s = time_of_equilibrium(setup, out);
    const StaticProblem problem = static_problem(setup, time_s);
    check_support(setup, problem.force_n);
    Coordinates x = setup.start;
    if (setup.scene.start.kind == StartKind::kPoint && setup.scene.start.amount > 0.999) {
        x = setup.body->rest();
        out.warnings.emplace_back("tissue shrunk to a point was re-seeded from the rest shape");
    }
    setup.sample(0, x, out);
    const NewtonSettings settings = newton_settings(setup, time_s);
    tell_convergence(find_equilibrium(setup, problem, settings, x, out), out);
    if (setup.scene.rest_speed_m_s && time_s < setup.longest_ramp_s()) {
        out.at_rest = false;
        out.warnings.push_back("not at rest after " + rounded_text(time_s, 4) +
                               " s: a ramp takes " + rounded_text(setup.longest_ramp_s(), 4) +
                               " s; expected a longer max_s");
    }
    setup.sample(time_s, x, out);
    if (setup.contacts) tell_contacts(setup, problem, time_s, x, out);
    FnvHash hash;
    hash.bytes(x.data(), sizeof(double) * as_index(x.size()));
    out.state_hash = hash.value();
    setup.finish(x, Coordinates::Zero(x.size()), time_s, out);
}

}  // namespace placode::sim
