// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The default operative field with its pre-tension, bed and thin stiff layers: (a) gravity, (b) a
// patch of skin pulled 1 mm by a grasp, (c) the placode pushed 0.7 mm. Against newton on the same
// mesh, started from where vbd has settled (the equilibrium does not depend on the start guess).
// Then fast drives of the skin edge and of an undermined flap: the grasp's reaction while it moves,
// against a symplectic step of 4 us in double precision.
#include <cmath>
#include <ctime>

#include "sim/anatomy/operative_field.h"
#include "sim/core/as_index.h"
#include "sim/verify/accuracy_table.h"
#include "sim/verify/newton.h"

namespace placode::sim {
namespace {

struct Load {
    const char* name;
    std::vector<int32_t> patch;  ///< Held vertices that move.
    Vec3 displacement_m = Vec3::Zero();
};

/// Surface vertices within `radius_m` of a point of the plane.
std::vector<int32_t> patch(const Scene& scene, const Vec2& centre, double radius_m) {
    std::vector<int32_t> out;
    for (int v = 0; v < scene.body.vertex_count(); ++v) {
        const Vec3& p = scene.body.mesh().rest[as_index(v)];
        if (scene.field.depth_m[as_index(v)] > 0 || (p.head<2>() - centre).norm() > radius_m)
            continue;
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
            const Vec3 offset = std::min(1.0, frame / 300.0) * load_.displacement_m;
            for (const int32_t v : load_.patch) {
                const Vec3f p = (body.mesh().rest[as_index(v)] + offset).cast<float>();
                state.x[as_index(v)] = {p.x(), p.y(), p.z(), 0};
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
        problem.held.assign(as_index(x.size()), 0);
        problem.held_at = x;
        problem.force_n = Coordinates::Zero(x.size());
        for (int v = 0; v < body.vertex_count(); ++v)
            problem.force_n.segment<3>(3 * v) =
                body.mass_kg()[as_index(v)] * spec_.solver.gravity_m_s2;
        for (const int32_t v : spec_.fixed) {
            problem.held_at.segment<3>(3 * v) = spec_.mesh.rest[as_index(v)];
            for (size_t a = 0; a < 3; ++a) problem.held[3 * as_index(v) + a] = 1;
        }
        for (const int32_t v : load_.patch)
            problem.held_at.segment<3>(3 * v) += load_.displacement_m;
        return solve_static(problem, x);
    }

    /// The grasp moves evenly over its whole way in `frames` frames of 1 ms, from rest. Its
    /// reaction after every frame.
    [[nodiscard]] std::vector<Vec3> drive_vbd(int substeps, int frames, const Coordinates& start,
                                              double& cpu_s) const {
        SoftBodySpec spec = spec_;
        spec.solver.method = Method::kVbd;
        spec.solver.substeps = substeps;
        const SoftBody body(std::move(spec));
        SoftBodyState state(body);
        for (size_t v = 0; v < state.x.size(); ++v) {
            const Vec3f p = start.segment<3>(3 * static_cast<Eigen::Index>(v)).cast<float>();
            state.x[v] = {p.x(), p.y(), p.z(), state.x[v].w};
        }
        Workers workers(1);
        std::vector<Vec3> out;
        std::clock_t spent = 0;
        for (int n = 1; n <= frames * substeps; ++n) {
            const Vec3 offset = load_.displacement_m * n / (frames * substeps);
            for (const int32_t v : load_.patch) {
                const Vec3f p = (body.mesh().rest[as_index(v)] + offset).cast<float>();
                state.x[as_index(v)] = {p.x(), p.y(), p.z(), 0};
            }
            const std::clock_t before = std::clock();
            run_substeps(body, state, 1, workers);
            spent += std::clock() - before;
            if (n % substeps == 0) out.push_back(reaction(positions(state)));
        }
        cpu_s = static_cast<double>(spent) / CLOCKS_PER_SEC;
        courant_ = 0;
        for (const double c : body.courant_numbers()) courant_ = std::max(courant_, c);
        return out;
    }

    /// The same by symplectic steps of 1/250 frame.
    [[nodiscard]] std::vector<Vec3> drive_explicit(int frames, const Coordinates& start) const {
        constexpr int kSteps = 250;
        constexpr double h = 1e-3 / kSteps;
        const ReferenceBody body(spec_);
        std::vector<uint8_t> held(as_index(body.vertex_count()), 0);
        for (const int32_t v : spec_.fixed) held[as_index(v)] = 1;
        Coordinates x = start, v = Coordinates::Zero(start.size()), gradient(start.size());
        std::vector<Vec3> out;
        for (int n = 1; n <= frames * kSteps; ++n) {
            gradient.setZero();
            body.add_gradient(x, gradient);
            for (int i = 0; i < body.vertex_count(); ++i) {
                if (held[as_index(i)] != 0) continue;
                const Vec3 a = spec_.solver.gravity_m_s2 -
                               gradient.segment<3>(3 * i) / body.mass_kg()[as_index(i)];
                v.segment<3>(3 * i) =
                    (v.segment<3>(3 * i) + h * a) / (1 + h * body.damping_per_s()[as_index(i)]);
            }
            x += h * v;
            for (const int32_t i : load_.patch)
                x.segment<3>(3 * i) =
                    spec_.mesh.rest[as_index(i)] + load_.displacement_m * n / (frames * kSteps);
            if (n % kSteps == 0) out.push_back(reaction(x));
        }
        return out;
    }

    /// What lies below a place of the skin hardly holds it any more.
    void undermine(const Vec2& centre, double radius_m) {
        spec_.stiffness_percent.assign(spec_.mesh.tets.size(), 100);
        for (size_t t = 0; t < spec_.mesh.tets.size(); ++t) {
            const Tissue tissue = spec_.mesh.tissue[t];
            if (tissue == Tissue::kSkin || tissue == Tissue::kThinSkin) continue;
            Vec3 middle = Vec3::Zero();
            for (const int32_t v : spec_.mesh.tets[t]) middle += spec_.mesh.rest[as_index(v)] / 4;
            if ((middle.head<2>() - centre).norm() < radius_m) spec_.stiffness_percent[t] = 1;
        }
    }

    [[nodiscard]] Vec3 reaction(const Coordinates& x) const {
        const ReferenceBody body(spec_);
        Coordinates gradient = Coordinates::Zero(x.size());
        body.add_gradient(x, gradient);
        Vec3 sum = Vec3::Zero();
        for (const int32_t v : load_.patch)
            sum += Vec3(gradient.segment<3>(3 * v)) -
                   body.mass_kg()[as_index(v)] * spec_.solver.gravity_m_s2;
        return sum;
    }

    /// The same grasp, not moved.
    [[nodiscard]] FieldCase at_rest() const {
        FieldCase out = *this;
        out.load_.displacement_m.setZero();
        return out;
    }
    [[nodiscard]] const Load& load() const { return load_; }
    [[nodiscard]] int tet_count() const { return static_cast<int>(spec_.mesh.tets.size()); }
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

/// Reaction of the grasp over a fast drive, all frames together.
void measure_drive(AccuracyTable& table, const FieldCase& one, double target) {
    constexpr int kFrames = 30;
    Coordinates start;
    (void)one.at_rest().run_vbd(4, start);
    const std::vector<Vec3> truth = one.drive_explicit(kFrames, start);
    const Vec3 before = one.reaction(start);
    for (const int substeps : {2, 4, 8}) {
        double cpu_s = 0, off = 0, size = 0;
        const std::vector<Vec3> found = one.drive_vbd(substeps, kFrames, start, cpu_s);
        for (size_t i = 0; i < truth.size(); ++i) {
            off += (found[i] - truth[i]).squaredNorm();
            size += (truth[i] - before).squaredNorm();
        }
        AccuracyRow row;
        set_text(row.study, "fast drives");
        row.setting = one.load().name;
        set_text(row.method, "vbd");
        set_text(row.quantity, "reaction of the grasp against explicit at 4 us (RMS over 30 ms)");
        row.h_s = 1e-3 / substeps;
        row.edge_m = 5e-4;
        row.tets = one.tet_count();
        row.courant = one.courant();
        row.cost = cpu_s / (1e-3 * kFrames);
        row.value = row.error = std::sqrt(off / size);
        row.target = substeps >= 4 ? target : 0;
        table.add(row);
    }
}

}  // namespace

void measure_drives(AccuracyTable& table) {
    const auto scene = build_operative_field(OperativeFieldSpec{});
    const Vec2 edge(0, 0.0090), flap(0, 0.0095);
    measure_drive(table,
                  FieldCase(*scene, {"skin edge drawn in by 1 mm at 33 mm/s",
                                     patch(*scene, edge, 0.0008), Vec3(0, -1e-3, 0)}),
                  0.02);
    FieldCase undermined(*scene, {"undermined flap lifted by 2.6 mm at 85 mm/s",
                                  patch(*scene, flap, 0.0010), Vec3(0, 0, 2.6e-3)});
    undermined.undermine(flap, 0.004);
    measure_drive(table, undermined, 0.12);
}

void measure_field(AccuracyTable& table) {
    const auto scene = build_operative_field(OperativeFieldSpec{});
    Coordinates rest(3 * scene->body.vertex_count()), unloaded;
    for (int v = 0; v < scene->body.vertex_count(); ++v)
        rest.segment<3>(3 * v) = scene->body.mesh().rest[as_index(v)];
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
