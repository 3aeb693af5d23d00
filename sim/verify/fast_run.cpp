// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// xpbd, xpbd_pair and vbd on a verification scene: the kernels of the product, with held axes,
// loads and spheres around them. Vertices that a sphere touches are solved as those that an
// instrument touches (sim/contact/contact_core.h); those that only some axes hold take a Newton
// step of their own as well. A projection onto the axis after an xpbd sweep would be cheaper, and
// wrong: the tets see the vertex on its way off the axis (uniaxial, Co 0.14: 2.9 % of the stress).
// The kernels work in floats: they get the scene in units of its own (KernelUnits), so that it
// moves in the same way whatever units it is written in.
#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/core/number_text.h"
#include "sim/solver/double_float.h"
#include "sim/solver/kernel_layout.h"
#include "sim/solver/restore_rest_shape.h"
#include "sim/verify/axis_holds.h"
#include "sim/verify/method_checks.h"
#include "sim/verify/pressed_vertices.h"
#include "sim/verify/rest_watch.h"
#include "sim/verify/rigid_modes.h"

namespace placode::sim {
namespace {

constexpr double kTorn = 1000;  // no tissue is stretched so far: the method has lost it

/// Of vbd, where the scene names none. A vertex steps as if its neighbours stayed where they are,
/// and so by 1 / (1 + k h^2 / m) of what it would without their stiffness k; that they follow takes
/// half of k away again: (1 + 2 a) / (1 + a) with 2 a = k h^2 / m, in the mean of a mesh 3.2 Co^2.
/// Measured: the best values on cantilevers of nu 0.3 and 0.45, Co 0.04 to 0.43, within 0.015.
/// Above that the coupling wins, and 1.2 is what stays stable. Nearly incompressible tissue
/// trembles with more than 1: a cantilever of nu 0.49, edges of 2 mm and h = 0.25 ms comes to rest
/// within 0.03 % of newton with 1, 7 % off with 1.2.
double usual_over_relaxation(double courant, double poissons_ratio) {
    if (poissons_ratio > kVbdExactPoissonsRatio) return 1;
    const double a = 1.6 * courant * courant;
    return std::min(1.2, (1 + 2 * a) / (1 + a));
}

class FastRun {
 public:
    FastRun(const SolveSetup& setup, SolveResult& out)
        : setup_(setup),
          out_(out),
          units_(setup.scene),
          h_(setup.scene.solver.frame_s / setup.scene.solver.substeps),
          h_body_(h_ * units_.time),
          body_(units_.scaled(make_spec())),
          state_(body_),
          pressed_(setup, units_, body_, state_, h_body_),
          holds_(setup, units_, body_, state_, h_body_),
          modes_(setup, body_, state_, h_body_),
          workers_(setup.scene.solver.threads) {
        out.kernels = kernel_target();
        if (!setup.scene.solver.single_precision) use_double_float(state_);
        for (int v = 0; v < body_.vertex_count(); ++v) {
            put_vertex(state_, v, units_.place(setup.start.segment<3>(3 * v)));
            if (setup.held[as_index(v)] != 0) held_.push_back(v);
        }
        state_.x_start = state_.x;
        state_.x_start_low = state_.x_low;
        find_free();
    }

    void run() {
        const VerificationSolver& s = setup_.scene.solver;
        const auto total = static_cast<int64_t>(std::ceil(setup_.scene.end_s / h_ - 1e-9));
        RestWatch rest(setup_, out_);
        double next_sample = 0;
        take_sample(0, next_sample);
        int64_t n = 0;
        while (n < total) {
            if (n % s.substeps == 0) start_frame();
            ++n;
            substep(static_cast<double>(n) * h_);
            setup_.report_time(static_cast<double>(n) * h_);
            take_sample(static_cast<double>(n) * h_, next_sample);
            if (n % s.substeps == 0 && rest.frame(static_cast<double>(n) * h_, positions())) {
                out_.at_rest = true;
                break;
            }
        }
        rest.end(static_cast<double>(n) * h_, positions());
        out_.substeps_total = n;
        finish(static_cast<double>(n) * h_);
    }

 private:
    SoftBodySpec make_spec() const {
        SoftBodySpec spec = setup_.spec;
        const VerificationSolver& s = setup_.scene.solver;
        spec.solver.method = s.method == SolveMethod::kVbd    ? Method::kVbd
                             : s.method == SolveMethod::kXpbd ? Method::kXpbd
                                                              : Method::kXpbdPair;
        // Substeps are counted here: frames of one substep, so that any number is possible.
        spec.solver.frame_s = h_;
        spec.solver.substeps = 1;
        spec.solver.iterations = s.iterations;
        spec.solver.over_relaxation =
            s.over_relaxation > 0
                ? s.over_relaxation
                : usual_over_relaxation(setup_.max_courant, setup_.scene.material.poissons_ratio);
        spec.solver.allow_invalid = true;  // checked below, with the scene's own numbers
        for (size_t v = 0; v < setup_.held.size(); ++v) {
            if (setup_.held[v] == 7) spec.fixed.push_back(static_cast<int32_t>(v));
        }
        check_method(setup_, units_, out_);
        return spec;
    }

    /// Gravity and loads enter the start guess where nothing holds against them
    /// (sim/solver/soft_body.h). Axes that are held count here, which the body does not know.
    void find_free() {
        const Vec3 g = setup_.scene.gravity_m_s2;
        uint8_t against = 0;
        for (int a = 0; a < 3; ++a) {
            bool acts = g[a] != 0;
            for (const LoadRegion& load : setup_.scene.loads)
                acts = acts || load.total_force_n[a] != 0;
            against |= static_cast<uint8_t>(acts ? 1 << a : 0);
        }
        std::vector<int32_t> stack;
        for (const int32_t v : setup_.partly_held()) {
            if ((setup_.held[as_index(v)] & against) != 0 && state_.free_vertex[as_index(v)] != 0) {
                stack.push_back(v);
                state_.free_vertex[as_index(v)] = 0;
            }
        }
        while (!stack.empty()) {
            const int32_t v = stack.back();
            stack.pop_back();
            const auto reach = [&](int32_t other) {
                if (state_.free_vertex[as_index(other)] == 0) return;
                state_.free_vertex[as_index(other)] = 0;
                stack.push_back(other);
            };
            for (const int32_t t : body_.tets_of(v)) {
                for (const int32_t other : body_.mesh().tets[as_index(t)]) reach(other);
            }
            for (const int32_t t : body_.packed().sheet.around(v)) {
                for (const int32_t other : body_.packed().sheet.triangles[as_index(t)].v)
                    reach(other);
            }
        }
    }

    void start_frame() {
        pressed_.start_frame();
        state_.backward = false;
        // Slow against the waves of this tissue, as kRestoreSlow is in soft tissue of 5 kPa.
        const Material& m = setup_.scene.material;
        const double slow =
            kRestoreSlow / std::sqrt(5.0) * std::sqrt(m.youngs_modulus_pa / m.density_kg_m3);
        const int placed = restore_collapsed(body_, state_, slow * units_.speed());
        if (placed > 0)
            out_.warnings.push_back("t = " + rounded_text(time_, 4) +
                                    " s: " + std::to_string(placed) +
                                    " vertices of tissue shrunk to a point, or at rest in a fold, "
                                    "were re-seeded from the rest shape");
    }

    void substep(double time_s) {
        time_ = time_s;
        pressed_.set_time(time_s);
        holds_.set_time(time_s);
        move_held();
        push();
        // Rounded as the simulator rounds is solved as it solves.
        const bool with_modes = modes_.any() && !setup_.scene.solver.single_precision;
        if (with_modes && pressed_.spheres() > 0) modes_.begin();
        begin_substep(body_, state_, h_body_, workers_);
        pressed_.find(with_modes ? &modes_ : nullptr);
        holds_.begin(pressed_);
        for (int i = 0; i < setup_.scene.solver.iterations; ++i) solve_once();
        if (with_modes) modes_.solve([this]() -> const auto& { return pressed_.pushes(); });
        end_substep(body_, state_, h_body_, workers_);
        pressed_.finish();
        flags_ |= state_.flags;
        last_flags_ = state_.flags;
        state_.flags = 0;
    }

    /// The simulator's passes over the contacts, there and back, read too large a force while
    /// things move (docs/contact.md). Two passes after the sweep are used where it is not to be
    /// measured.
    void solve_once() {
        const bool as_simulator = setup_.scene.solver.single_precision;
        if (as_simulator) pressed_.solve(false);
        sweep(body_, state_, h_body_, workers_);
        holds_.solve(pressed_);
        if (!as_simulator) pressed_.solve(false);
        pressed_.solve(as_simulator);
    }

    /// Held vertices go where their region is at the end of the substep.
    void move_held() {
        for (const int32_t v : held_) {
            if (setup_.held[as_index(v)] == 7) put_vertex(state_, v, holds_.held_place(v));
        }
    }

    void push() {
        if (!setup_.has_loads() || (pushed_ && time_ > setup_.longest_ramp_s() + h_)) return;
        Coordinates force = Coordinates::Zero(3 * body_.vertex_count());
        setup_.add_loads(time_, force);
        state_.force_n.resize(state_.x.size());
        for (int v = 0; v < body_.vertex_count(); ++v) {
            const Vec3f f = (units_.force() * force.segment<3>(3 * v)).cast<float>();
            state_.force_n[as_index(v)] = {f.x(), f.y(), f.z(), 0};
        }
        pushed_ = true;
    }

    void take_sample(double time_s, double& next) {
        if (time_s < next - h_ / 2) return;
        setup_.sample(time_s, positions(), out_);
        const double each = std::max(setup_.scene.sample_s, h_);  // not more than there are
        while (next <= time_s + h_ / 2) next += each;
    }

    [[nodiscard]] Coordinates positions() const {
        Coordinates out(3 * static_cast<Eigen::Index>(body_.vertex_count()));
        for (int v = 0; v < body_.vertex_count(); ++v)
            out.segment<3>(3 * v) = units_.scene_place(exact_position(state_, v));
        return out;
    }

    static Coordinates flat(const std::vector<Float4>& points) {
        Coordinates out(3 * static_cast<Eigen::Index>(points.size()));
        for (size_t i = 0; i < points.size(); ++i)
            out.segment<3>(3 * static_cast<Eigen::Index>(i)) = to_vec(points[i]);
        return out;
    }

    void finish(double time_s) {
        for (size_t i = 0; i < pressed_.spheres(); ++i)
            out_.contact_forces.push_back(
                {"/sdf_contacts/" + std::to_string(i), pressed_.force(i)});
        out_.penetration_m = pressed_.deepest() / units_.length;
        out_.state_hash = state_hash(state_);
        if ((last_flags_ & kNotFinite) != 0) {
            out_.diverged = true;
            out_.warnings.emplace_back(
                "diverged: to the end vertices were not finite and were put back; expected smaller "
                "loads, or softer or denser tissue");
        } else if ((flags_ & kNotFinite) != 0)
            out_.warnings.emplace_back("vertices were not finite at times and were put back");
        if ((flags_ & kStepLimited) != 0)
            out_.warnings.emplace_back(
                "steps were limited to a quarter of the shortest edge at times: the motion was "
                "faster than the method follows");
        if (const double stretch = longest_stretch(); stretch > kTorn) {
            out_.diverged = true;
            out_.warnings.push_back("diverged: an edge is " + rounded_text(stretch, 3) +
                                    " times as long as at rest");
        }
        setup_.finish(positions(), flat(state_.v) / units_.speed(), time_s, out_);
    }

    /// Of an edge of a tet, against its rest length.
    [[nodiscard]] double longest_stretch() const {
        double longest = 0;
        for (const auto& tet : body_.mesh().tets) {
            for (size_t k = 1; k < 4; ++k) {
                const double rest =
                    (body_.mesh().rest[as_index(tet[k])] - body_.mesh().rest[as_index(tet[0])])
                        .norm();
                const double now =
                    (to_vec(state_.x[as_index(tet[k])]) - to_vec(state_.x[as_index(tet[0])]))
                        .norm();
                longest = std::max(longest, now / rest);
            }
        }
        return longest;
    }

    const SolveSetup& setup_;
    SolveResult& out_;
    const KernelUnits units_;
    const double h_, h_body_;  // of a substep, in the scene's units and in the kernels'
    double time_ = 0;          // the scene's; all below is in the kernels' units
    bool pushed_ = false;
    SoftBody body_;
    SoftBodyState state_;
    PressedVertices pressed_;
    AxisHolds holds_;
    RigidModes modes_;
    Workers workers_;
    std::vector<int32_t> held_;
    uint32_t flags_ = 0, last_flags_ = 0;  // of all substeps, of the last one
};

}  // namespace

void run_fast(const SolveSetup& setup, SolveResult& out) { FastRun(setup, out).run(); }

}  // namespace placode::sim
