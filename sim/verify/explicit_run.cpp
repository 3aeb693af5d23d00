// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Symplectic Euler in double precision: below its limit nothing beats it, and it is the dynamic
// reference. Forces are computed by tet and gathered by vertex, so that the bits do not depend on
// the number of threads.
#include "sim/verify/explicit_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sim/core/as_index.h"
#include "sim/core/fnv_hash.h"
#include "sim/core/number_text.h"
#include "sim/verify/rest_watch.h"

namespace placode::sim {
namespace {

constexpr double kStiffestContact = 300;  // x E x edge, where the step allows it

}  // namespace

ExplicitDynamics::ExplicitDynamics(const ReferenceBody& body, const Vec3& gravity_m_s2, double h_s,
                                   Workers& workers)
    : body_(body),
      gravity_(gravity_m_s2),
      h_(h_s),
      workers_(workers),
      corner_(as_index(body.tet_count())),
      spring_(Coordinates::Zero(3 * body.vertex_count())) {
    x = body.rest();
    v = Coordinates::Zero(x.size());
    outer_force_n = Coordinates::Zero(x.size());
    start_.assign(as_index(body.vertex_count()) + 1, 0);
    for (int t = 0; t < body.tet_count(); ++t) {
        for (const int32_t i : body.corners(t)) ++start_[as_index(i) + 1];
    }
    for (size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    tet_corner_.resize(4 * as_index(body.tet_count()));
    std::vector<int32_t> fill(start_.begin(), start_.end() - 1);
    for (int t = 0; t < body.tet_count(); ++t) {
        for (size_t k = 0; k < 4; ++k)
            tet_corner_[as_index(fill[as_index(body.corners(t)[k])]++)] =
                4 * t + static_cast<int32_t>(k);
    }
}

void ExplicitDynamics::step() {
    spring_.setZero();
    body_.add_other_gradients(x, spring_);
    parts_ = workers_.threads();
    workers_.run<&ExplicitDynamics::load>(parts_, *this);
    workers_.run<&ExplicitDynamics::integrate>(parts_, *this);
}

void ExplicitDynamics::load(int part) noexcept {
    const int64_t tets = body_.tet_count();
    body_.corner_gradients(x, static_cast<int>(tets * part / parts_),
                           static_cast<int>(tets * (part + 1) / parts_), corner_);
}

void ExplicitDynamics::integrate(int part) noexcept {
    const int n = body_.vertex_count();
    for (int i = static_cast<int>(int64_t{n} * part / parts_);
         i < static_cast<int>(int64_t{n} * (part + 1) / parts_); ++i) {
        Vec3 force = outer_force_n.segment<3>(3 * i) - spring_.segment<3>(3 * i);
        for (int32_t c = start_[as_index(i)]; c < start_[as_index(i) + 1]; ++c)
            force -= corner_[as_index(tet_corner_[as_index(c)] / 4)]
                            [as_index(tet_corner_[as_index(c)] % 4)];
        const double keep = 1 / (1 + h_ * body_.damping_per_s()[as_index(i)]);
        Vec3 u = v.segment<3>(3 * i);
        u = keep * (u + h_ * (force / body_.mass_kg()[as_index(i)] + gravity_));
        v.segment<3>(3 * i) = u;
        x.segment<3>(3 * i) += h_ * u;
    }
}

namespace {

/// Limit of the step with 5 % in hand: compressed tissue is stiffer than at rest.
void check_step(const SolveSetup& setup, double omega, SolveResult& out) {
    const VerificationSolver& s = setup.scene.solver;
    const double h = s.frame_s / s.substeps, limit = 0.95 * 2 / omega;
    if (h <= limit) return;
    const std::string text = "explicit: substep " + rounded_text(h, 4) +
                             " s is above the CFL limit " + rounded_text(limit, 4) +
                             " s of this mesh and material; with frames of " +
                             rounded_text(s.frame_s, 4) + " s expected at least " +
                             rounded_text(std::ceil(s.frame_s / limit), 4) + " substeps, found " +
                             std::to_string(s.substeps);
    if (!s.allow_invalid)
        throw VerificationError("/solver/substeps",
                                text + " (\"allow_invalid\": true runs it nevertheless)");
    out.warnings.push_back("not valid: " + text);
}

/// As stiff as wanted, or as the step bears: up to six triangles push one vertex.
double contact_stiffness(const SolveSetup& setup, double omega, SolveResult& out) {
    const VerificationSolver& s = setup.scene.solver;
    const double h = s.frame_s / s.substeps;
    double lightest = 1e300;
    for (const int32_t v : setup.contacts->vertices())
        lightest = std::min(lightest, setup.body->mass_kg()[as_index(v)]);
    const double unit = setup.scene.material.youngs_modulus_pa * setup.contacts->mean_edge_m();
    const double room = std::max(0.1, 3.6 - omega * omega * h * h);
    const double k = std::min(kStiffestContact * unit, room * lightest / (6 * h * h));
    if (k < 30 * unit)
        out.warnings.push_back("explicit: contact of " + rounded_text(k, 4) +
                               " N/m is soft, more substeps make it stiffer");
    return k;
}

class Run {
 public:
    Run(const SolveSetup& setup, SolveResult& out)
        : setup_(setup),
          out_(out),
          h_(setup.scene.solver.frame_s / setup.scene.solver.substeps),
          workers_(setup.scene.solver.threads),
          dynamics_(*setup.body, setup.scene.gravity_m_s2, h_, workers_) {
        const double omega = setup.body->highest_frequency_rad_s();
        check_step(setup, omega, out);
        dynamics_.x = setup.start;
        restore();
        if (setup.contacts) k_ = contact_stiffness(setup, omega, out);
        force_.assign(setup.scene.spheres.size(), Vec3::Zero());
    }

    void run() {
        const VerificationSolver& s = setup_.scene.solver;
        const auto total = static_cast<int64_t>(std::ceil(setup_.scene.end_s / h_ - 1e-9));
        RestWatch rest(setup_, out_);
        double next = 0;
        sample(0, next);
        int64_t n = 0;
        while (n < total) {
            if (n % s.substeps == 0) {
                std::fill(force_.begin(), force_.end(), Vec3::Zero());
                in_frame_ = 0;
            }
            ++n;
            step(static_cast<double>(n) * h_);
            setup_.report_time(static_cast<double>(n) * h_);
            sample(static_cast<double>(n) * h_, next);
            if (n % s.substeps != 0) continue;
            const double fastest = dynamics_.v.lpNorm<Eigen::Infinity>();
            if (!dynamics_.x.allFinite() || !std::isfinite(fastest)) {
                out_.diverged = true;
                out_.warnings.push_back(
                    "explicit: diverged at t = " + rounded_text(static_cast<double>(n) * h_, 4) +
                    " s; expected more substeps");
                break;
            }
            if (rest.frame(static_cast<double>(n) * h_, dynamics_.x)) {
                out_.at_rest = true;
                break;
            }
        }
        rest.end(static_cast<double>(n) * h_, dynamics_.x);
        out_.substeps_total = n;
        for (size_t i = 0; i < force_.size(); ++i)
            out_.contact_forces.push_back(
                {"/sdf_contacts/" + std::to_string(i), force_[i] / std::max(1, in_frame_)});
        FnvHash hash;
        for (const Coordinates* c : {&dynamics_.x, &dynamics_.v})
            hash.bytes(c->data(), sizeof(double) * as_index(c->size()));
        out_.state_hash = hash.value();
        setup_.finish(dynamics_.x, dynamics_.v, static_cast<double>(n) * h_, out_);
    }

 private:
    void restore() {
        const StartShape& s = setup_.scene.start;
        if (s.kind != StartKind::kPoint || s.amount < 0.999) return;
        dynamics_.x = setup_.body->rest();
        out_.warnings.emplace_back(
            "t = 0 s: tissue shrunk to a point was re-seeded from the rest shape");
    }

    void step(double time_s) {
        dynamics_.outer_force_n.setZero();
        setup_.add_loads(time_s, dynamics_.outer_force_n);
        if (setup_.contacts) touch(time_s);
        dynamics_.step();
        for (size_t v = 0; v < setup_.held.size(); ++v) {
            for (int a = 0; a < 3; ++a) {
                if ((setup_.held[v] >> a & 1) == 0) continue;
                const auto i = static_cast<Eigen::Index>(3 * v) + a;
                const double to = setup_.held_at(static_cast<int>(v), a, time_s);
                const double from = setup_.held_at(static_cast<int>(v), a, time_s - h_);
                dynamics_.x[i] = to;
                dynamics_.v[i] = (to - from) / h_;
            }
        }
    }

    /// Penalty of the normal gap, and friction that opposes sliding: at most mu N, and at most what
    /// stops the vertex within the step.
    void touch(double time_s) {
        ++in_frame_;
        Coordinates gradient = Coordinates::Zero(dynamics_.x.size());
        const auto forces =
            add_contact(*setup_.contacts, dynamics_.x, time_s - h_, k_, gradient, nullptr);
        for (size_t i = 0; i < forces.size(); ++i) force_[i] += forces[i];
        std::vector<SphereTouch> touches;
        setup_.contacts->find([this](int32_t v) { return Vec3(dynamics_.x.segment<3>(3 * v)); },
                              time_s - h_, 0, touches);
        out_.penetration_m = 0;
        std::vector<int32_t> done;
        for (const SphereTouch& t : touches) {
            out_.penetration_m = std::max(out_.penetration_m, -t.gap_m);
            const SphereObstacle& sphere = setup_.scene.spheres[as_index(t.sphere)];
            for (int i = 0; i < 3; ++i) {
                const int32_t v = t.vertex[as_index(i)];
                if (std::find(done.begin(), done.end(), v) != done.end()) continue;
                done.push_back(v);
                const Vec3 load = -gradient.segment<3>(3 * v);
                if (!(load.norm() > 0)) continue;
                const Vec3 n = load.normalized();
                const Vec3 relative = Vec3(dynamics_.v.segment<3>(3 * v)) - sphere.velocity_m_s;
                const Vec3 slide = relative - n * n.dot(relative);
                if (!(slide.norm() > 0)) continue;
                const double stop = setup_.body->mass_kg()[as_index(v)] * slide.norm() / h_;
                const Vec3 f = -std::min(sphere.friction * load.norm(), stop) * slide.normalized();
                dynamics_.outer_force_n.segment<3>(3 * v) += f;
                force_[as_index(t.sphere)] -= f;
            }
        }
        dynamics_.outer_force_n -= gradient;
    }

    void sample(double time_s, double& next) {
        if (time_s < next - h_ / 2) return;
        setup_.sample(time_s, dynamics_.x, out_);
        const double each = std::max(setup_.scene.sample_s, h_);  // not more than there are
        while (next <= time_s + h_ / 2) next += each;
    }

    const SolveSetup& setup_;
    SolveResult& out_;
    double h_ = 0, k_ = 0;
    Workers workers_;
    ExplicitDynamics dynamics_;
    std::vector<Vec3> force_;
    int in_frame_ = 0;
};

}  // namespace

void run_explicit(const SolveSetup& setup, SolveResult& out) { Run(setup, out).run(); }

}  // namespace placode::sim
