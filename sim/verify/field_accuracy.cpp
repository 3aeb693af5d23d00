// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The default operative field with its pre-tension, bed and thin stiff layers: (a) gravity, (b) a
// patch of skin pulled 1 mm by a grasp, (c) the placode pushed 0.7 mm. Against newton on the same
// mesh, started from where vbd has settled (the equilibrium does not depend on the start guess).
#include <cmath>
#include <ctime>

#include "sim/anatomy/operative_field.h"
#include "sim/verify/accuracy_table.h"
#include "sim/verify/newton.h"

namespace placode::sim {
namespace {

struct Load {
    const char* name;
    std::vector<int32_t> patch;  ///< Held vertices that move.
    Vec3 way_m = Vec3::Zero();
};

size_t at(int64_t i) { return static_cast<size_t>(i); }

/// Surface vertices within `radius_m` of a point of the plane.
std::vector<int32_t> patch(const Scene& scene, const Vec2& centre, double radius_m) {
    std::vector<int32_t> out;
    for (int v = 0; v < scene.body.vertex_count(); ++v) {
        const Vec3& p = scene.body.mesh().rest[at(v)];
        if (scene.field.depth_m[at(v)] > 0 || (p.head<2>() - centre).norm() > radius_m) continue;
        out.push_back(v);
    }
    return out;
}

Coordinates positions(const SoftBodyState& state) {
    Coordinates x(3 * static_cast<Eigen::Index>(state.x.size()));
    for (size_t i = 0; i < state.x.size(); ++i)
        x.segment<3>(3 * static_cast<Eigen::Index>(i)) =
            Vec3(state.x[i].x, state.x[i].y, state.x[i].z);
    return x;
}

class FieldCase {
 public:
    FieldCase(const Scene& scene, Load load) : scene_(scene), load_(std::move(load)) {
        spec_ = scene.body.spec();
        for (const int32_t v : load_.patch) spec_.fixed.push_back(v);
    }

    /// 0.3 s ramp, then settled until 1 s. Returns CPU seconds.
    double run_vbd(int substeps, Coordinates& x) const {
        SoftBodySpec spec = spec_;
        spec.solver.method = Method::kVbd;
        spec.solver.substeps = substeps;
        const SoftBody body(std::move(spec));
        SoftBodyState state(body);
        Workers workers(1);
        const std::clock_t start = std::clock();
        for (int frame = 1; frame <= 1000; ++frame) {
            const Vec3 way = std::min(1.0, frame / 300.0) * load_.way_m;
            for (const int32_t v : load_.patch) {
                const Vec3f p = (body.mesh().rest[at(v)] + way).cast<float>();
                state.x[at(v)] = {p.x(), p.y(), p.z(), 0};
            }
            run_substeps(body, state, substeps, workers);
        }
        x = positions(state);
        courant_ = 0;
        for (const double c : body.courant_numbers()) courant_ = std::max(courant_, c);
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }

    NewtonReport run_newton(Coordinates& x) const {
        const ReferenceBody body(spec_);
        StaticProblem problem;
        problem.body = &body;
        problem.held.assign(at(x.size()), 0);
        problem.held_at = x;
        problem.force_n = Coordinates::Zero(x.size());
        for (int v = 0; v < body.vertex_count(); ++v)
            problem.force_n.segment<3>(3 * v) = body.mass_kg()[at(v)] * spec_.solver.gravity_m_s2;
        for (const int32_t v : spec_.fixed) {
            problem.held_at.segment<3>(3 * v) = spec_.mesh.rest[at(v)];
            for (size_t a = 0; a < 3; ++a) problem.held[3 * at(v) + a] = 1;
        }
        for (const int32_t v : load_.patch) problem.held_at.segment<3>(3 * v) += load_.way_m;
        return solve_static(problem, x);
    }

    [[nodiscard]] Vec3 reaction(const Coordinates& x) const {
        const ReferenceBody body(spec_);
        Coordinates gradient = Coordinates::Zero(x.size());
        body.add_gradient(x, gradient);
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : load_.patch)
            sum += Vec3(gradient.segment<3>(3 * v)) -
                   body.mass_kg()[at(v)] * spec_.solver.gravity_m_s2;
        return sum;
    }

    [[nodiscard]] const Load& load() const { return load_; }
    [[nodiscard]] double courant() const { return courant_; }

 private:
    const Scene& scene_;
    Load load_;
    SoftBodySpec spec_;
    mutable double courant_ = 0;
};

void add_rows(AccuracyTable& table, const FieldCase& one, const Coordinates& truth,
              const Coordinates& unloaded, const SoftBody& body) {
    const Vec3 reaction = one.load().patch.empty() ? Vec3::Zero() : one.reaction(truth);
    for (const int substeps : {2, 4, 8}) {
        Coordinates x;
        const double cpu = one.run_vbd(substeps, x);
        AccuracyRow row;
        set_text(row.study, "operative field");
        row.setting = one.load().name;
        set_text(row.method, "vbd");
        set_text(row.quantity, "displacement by the load against newton on the same mesh (L2)");
        row.h_s = 1e-3 / substeps;
        row.edge_m = 5e-4;
        row.tets = body.tet_count();
        row.courant = one.courant();
        row.cost = cpu;
        row.value = row.error = (x - truth).norm() / (truth - unloaded).norm();
        row.target = substeps >= 4 ? 0.005 : 0;
        table.add(row);
        if (one.load().patch.empty()) continue;
        set_text(row.quantity, "reaction of the grasp against newton");
        set_text(row.unit, "N");
        row.value = one.reaction(x).norm();
        row.expected = reaction.norm();
        row.error = (one.reaction(x) - reaction).norm() / reaction.norm();
        table.add(row);
    }
}

}  // namespace

void measure_field(AccuracyTable& table) {
    const auto scene = build_operative_field(OperativeFieldSpec{});
    Coordinates rest(3 * scene->body.vertex_count()), unloaded;
    for (int v = 0; v < scene->body.vertex_count(); ++v)
        rest.segment<3>(3 * v) = scene->body.mesh().rest[at(v)];
    for (const Load& load :
         {Load{"a: gravity and pre-tension", {}, Vec3::Zero()},
          Load{"b: skin pulled 1 mm", patch(*scene, Vec2(0, 0.0098), 0.0012), Vec3(0, 0, 1e-3)},
          Load{"c: placode pushed 0.7 mm", patch(*scene, Vec2(0, 0), 0.0012), Vec3(0, 0, -7e-4)}}) {
        const FieldCase one(*scene, load);
        Coordinates truth;
        (void)one.run_vbd(4, truth);
        const NewtonReport report = one.run_newton(truth);
        AccuracyRow row;
        set_text(row.study, "operative field");
        row.setting = load.name;
        set_text(row.method, "newton");
        set_text(row.quantity, "residual over the largest force");
        row.tets = scene->body.tet_count();
        row.edge_m = 5e-4;
        row.value = row.error = report.residual_n / report.force_scale_n;
        row.target = 1e-8;
        table.add(row);
        if (load.patch.empty()) unloaded = truth;
        add_rows(table, one, truth, load.patch.empty() ? rest : unloaded, scene->body);
    }
}

}  // namespace placode::sim
