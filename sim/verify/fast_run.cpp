// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// xpbd, xpbd_pair and vbd on a verification scene: the kernels of the product, with held axes,
// loads and spheres around them. Vertices that touch a sphere, and with vbd those that only some
// axes hold, form the contact colour: they are left out of the sweep and take a Newton step of
// their own (sim/contact.h). With xpbd a held axis is a projection after every sweep.
// The kernels work in floats: they get the scene in units of its own (KernelUnits), so that it
// moves in the same way whatever units it is written in.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "sim/event.h"
#include "sim/number_text.h"
#include "sim/packing.h"
#include "sim/verify/solve_setup.h"

namespace placode::sim {
namespace {

constexpr int kPasses = 2;      // over the contact colour for each sweep, as in sim/step
constexpr double kTorn = 1000;  // no tissue is stretched so far: the method has lost it
// Stiffness of a contact: x E x edge at most, so that the penetration is far below the indentation,
// and x what the touched vertices answer at once, as in sim/contact.cpp: more bursts on fine
// patches.
constexpr double kContactStiffness = 300, kContactRatio = 6;

size_t at(int64_t i) { return static_cast<size_t>(i); }

/// What a length, time and mass of the scene are for the kernels. A scene written in other units
/// gives the kernels the same numbers to the last digit of a double, which almost never is another
/// float: without this, motion that is not damped away differs by 0.1 to 3e-3 after 0.3 s.
struct KernelUnits {
    explicit KernelUnits(const VerificationScene& scene) {
        Vec3 low = scene.mesh.rest.front(), high = low;
        for (const Vec3& p : scene.mesh.rest) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        // A body of 20 mm and the density of water at 0.25 ms: the sizes of an operative field.
        length = 0.02 / (high - low).norm();
        time = 2.5e-4 / (scene.solver.frame_s / scene.solver.substeps);
        mass = 1000 * std::pow(length, 3) / scene.material.density_kg_m3;
    }
    double length = 1, time = 1, mass = 1;
    [[nodiscard]] double speed() const { return length / time; }
    [[nodiscard]] double acceleration() const { return length / (time * time); }
    [[nodiscard]] double force() const { return mass * acceleration(); }
    [[nodiscard]] double stress() const { return force() / (length * length); }

    [[nodiscard]] SoftBodySpec scaled(SoftBodySpec spec) const {
        for (Vec3& p : spec.mesh.rest) p *= length;
        for (Material& m : spec.materials) {
            m.youngs_modulus_pa *= stress();
            m.density_kg_m3 *= mass / std::pow(length, 3);
            m.damping_per_s /= time;
        }
        for (SheetTriangle& t : spec.sheet) t.thickness_m *= length;
        spec.solver.gravity_m_s2 *= acceleration();
        spec.solver.frame_s *= time;
        return spec;
    }
    [[nodiscard]] std::vector<SphereObstacle> scaled(std::vector<SphereObstacle> spheres) const {
        for (SphereObstacle& s : spheres) {
            s.centre_m *= length;
            s.radius_m *= length;
            s.velocity_m_s *= length;  // its time stays the scene's
        }
        return spheres;
    }
};

class FastRun {
 public:
    FastRun(const SolveSetup& setup, SolveResult& out)
        : setup_(setup),
          out_(out),
          units_(setup.scene),
          h_(setup.scene.solver.frame_s / setup.scene.solver.substeps),
          h_body_(h_ * units_.time),
          spheres_(units_.scaled(setup.scene.spheres)),
          body_(units_.scaled(make_spec())),
          state_(body_),
          workers_(setup.scene.solver.threads) {
        vbd_ = setup.scene.solver.method == SolveMethod::kVbd;
        out.kernels = kernel_target();
        for (int v = 0; v < body_.vertex_count(); ++v) {
            const Vec3f x = (units_.length * setup.start.segment<3>(3 * v)).cast<float>();
            state_.x[at(v)] = {x.x(), x.y(), x.z(), state_.x[at(v)].w};
            if (setup.held[at(v)] != 0) held_.push_back(v);
        }
        state_.x_start = state_.x;
        find_free();
        if (setup.contacts) {
            contacts_ =
                std::make_unique<SphereContacts>(body_.mesh(), spheres_, setup.free_sheet());
            anchor_.resize(at(body_.vertex_count()));
            k_ = kContactStiffness * units_.stress() * setup.scene.material.youngs_modulus_pa *
                 contacts_->mean_edge_m();
            force_.assign(spheres_.size(), Vec3::Zero());
        }
        slot_.assign(at(body_.vertex_count()), -1);
    }

    void run() {
        const VerificationSolver& s = setup_.scene.solver;
        const auto total = static_cast<int64_t>(std::ceil(setup_.scene.end_s / h_ - 1e-9));
        RestWatch rest(setup_);
        double next_sample = 0;
        take_sample(0, next_sample);
        int64_t n = 0;
        while (n < total) {
            if (n % s.substeps == 0) start_frame();
            ++n;
            substep(static_cast<double>(n) * h_);
            take_sample(static_cast<double>(n) * h_, next_sample);
            if (n % s.substeps == 0 && rest.frame(static_cast<double>(n) * h_, positions())) {
                out_.at_rest = true;
                break;
            }
        }
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
        // Nearly incompressible tissue trembles with more than 1: a cantilever of nu 0.49, edges of
        // 2 mm and h = 0.25 ms comes to rest within 0.03 % of newton with 1, 7 % off with 1.2.
        const double usual = setup_.scene.material.poissons_ratio > 0.46 ? 1.0 : 1.2;
        spec.solver.over_relaxation = s.over_relaxation > 0 ? s.over_relaxation : usual;
        spec.solver.allow_invalid = true;  // checked below, with the scene's own numbers
        for (size_t v = 0; v < setup_.held.size(); ++v) {
            if (setup_.held[v] == 7) spec.fixed.push_back(static_cast<int32_t>(v));
        }
        check_method();
        return spec;
    }

    void check_method() const {
        const VerificationSolver& s = setup_.scene.solver;
        if (s.method == SolveMethod::kVbd) return;
        const double limit = s.method == SolveMethod::kXpbd ? kXpbdMaxCourant : kXpbdPairMaxCourant;
        if (setup_.max_courant > limit) {
            const std::string text =
                "Courant number " + rounded_text(setup_.max_courant, 4) + " is above " +
                rounded_text(limit, 4) + ", the limit of " + method_name(s.method) + "; with " +
                std::to_string(s.substeps) + " substeps a frame expected at least " +
                rounded_text(std::ceil(s.substeps * setup_.max_courant / limit), 4) +
                ", or method vbd, which is valid at any";
            if (!s.allow_invalid)
                throw VerificationError("/solver/substeps",
                                        text + " (\"allow_invalid\": true runs it nevertheless)");
            out_.warnings.push_back("not valid: " + text);
        } else if (setup_.max_courant > kXpbdGoodCourant) {
            out_.warnings.push_back("inexact: Courant number " +
                                    rounded_text(setup_.max_courant, 4) +
                                    ", xpbd is up to about 7 % too soft (good up to " +
                                    rounded_text(kXpbdGoodCourant, 4) + ")");
        }
        if (s.iterations > 1)
            out_.warnings.push_back(
                "xpbd with more than one iteration a substep settles beside the equilibrium; "
                "smaller substeps are the cure");
    }

    /// Gravity and loads enter the start guess where nothing holds against them (sim/soft_body.h).
    /// Axes that are held count here, which the body does not know.
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
            if ((setup_.held[at(v)] & against) != 0 && state_.free_vertex[at(v)] != 0) {
                stack.push_back(v);
                state_.free_vertex[at(v)] = 0;
            }
        }
        while (!stack.empty()) {
            const int32_t v = stack.back();
            stack.pop_back();
            const auto reach = [&](int32_t other) {
                if (state_.free_vertex[at(other)] == 0) return;
                state_.free_vertex[at(other)] = 0;
                stack.push_back(other);
            };
            for (const int32_t t : body_.tets_of(v)) {
                for (const int32_t other : body_.mesh().tets[at(t)]) reach(other);
            }
            for (const int32_t t : body_.packed().sheet.around(v)) {
                for (const int32_t other : body_.packed().sheet.triangles[at(t)].v) reach(other);
            }
        }
    }

    void start_frame() {
        std::fill(force_.begin(), force_.end(), Vec3::Zero());
        frame_substeps_ = 0;
        if (const int placed = reseed_collapsed(body_, state_); placed > 0)
            out_.warnings.push_back("t = " + rounded_text(time_, 4) +
                                    " s: " + std::to_string(placed) +
                                    " vertices of tissue shrunk to a point were re-seeded from the "
                                    "rest shape");
    }

    void substep(double time_s) {
        time_ = time_s;
        move_held();
        push();
        begin_substep(body_, state_, h_body_, workers_);
        find_touches();
        for (int i = 0; i < setup_.scene.solver.iterations; ++i) {
            sweep(body_, state_, h_body_, workers_);
            if (!vbd_) project_axes();
            for (int pass = 0; pass < kPasses; ++pass) solve_special();
        }
        end_substep(body_, state_, h_body_, workers_);
        finish_touches();
        flags_ |= state_.flags;
        last_flags_ = state_.flags;
        state_.flags = 0;
    }

    /// Held vertices go where their region is at the end of the substep.
    void move_held() {
        for (const int32_t v : held_) {
            if (setup_.held[at(v)] != 7) continue;
            Float4& x = state_.x[at(v)];
            x = {held_at(v, 0), held_at(v, 1), held_at(v, 2), 0};
        }
    }

    [[nodiscard]] float held_at(int32_t v, int axis) const {
        return static_cast<float>(units_.length * setup_.held_at(v, axis, time_));
    }

    void project_axes() {
        for (const int32_t v : setup_.partly_held()) put_on_axes(v);
    }

    void put_on_axes(int32_t v) {
        Float4& x = state_.x[at(v)];
        const uint8_t axes = setup_.held[at(v)];
        if (axes & kAxisX) x.x = held_at(v, 0);
        if (axes & kAxisY) x.y = held_at(v, 1);
        if (axes & kAxisZ) x.z = held_at(v, 2);
    }

    void push() {
        if (!setup_.has_loads() || (pushed_ && time_ > setup_.longest_ramp_s() + h_)) return;
        Coordinates force = Coordinates::Zero(3 * body_.vertex_count());
        setup_.add_loads(time_, force);
        state_.force_n.resize(state_.x.size());
        for (int v = 0; v < body_.vertex_count(); ++v) {
            const Vec3f f = (units_.force() * force.segment<3>(3 * v)).cast<float>();
            state_.force_n[at(v)] = {f.x(), f.y(), f.z(), 0};
        }
        pushed_ = true;
    }

    void find_touches() {
        for (const int32_t v : special_) {
            slot_[at(v)] = -1;
            state_.contact_vertex[at(v)] = 0;
        }
        special_.clear();
        if (vbd_) {
            for (const int32_t v : setup_.partly_held()) add_special(v);
        }
        touches_.clear();
        if (contacts_) {
            double fastest = 0;
            for (const SphereObstacle& s : spheres_)
                fastest = std::max(fastest, s.velocity_m_s.norm());
            const double margin = 0.2 * contacts_->mean_edge_m() + 2 * h_ * fastest;
            contacts_->find([this](int32_t v) { return to_vec(state_.x_start[at(v)]); }, time_,
                            margin, touches_);
            drop_doubles();
            for (SphereTouch& t : touches_) {
                double place = 0;
                for (int i = 0; i < 3; ++i) {
                    add_special(t.vertex[at(i)]);
                    place += t.b[i] * t.n.dot(to_vec(state_.x_start[at(t.vertex[at(i)])]));
                }
                t.gap_m -= place;  // from here on the offset of gap = n . (sum b x) + offset
            }
        }
        set_stiffness();
        incidence_.assign(special_.size(), {});
        for (size_t t = 0; t < touches_.size(); ++t) {
            for (int i = 0; i < 3; ++i)
                incidence_[at(slot_[at(touches_[t].vertex[at(i)])])].push_back(
                    static_cast<int32_t>(4 * t) + i);
        }
        for (size_t i = 0; i < special_.size(); ++i) {
            if (incidence_[i].empty()) continue;
            // Between sphere and tissue a vertex starts from where it was, see sim/contact.cpp.
            Float4& x = state_.x[at(special_[i])];
            if (x.w == 0) continue;
            const Float4& before = state_.x_start[at(special_[i])];
            x = {before.x, before.y, before.z, x.w};
        }
    }

    /// A corner or an edge is touched once, however many triangles meet there.
    void drop_doubles() {
        std::set<std::array<int32_t, 4>> seen;
        std::erase_if(touches_, [&](const SphereTouch& t) {
            std::array<int32_t, 4> key{-1, -1, -1, t.sphere};
            for (int i = 0; i < 3; ++i) {
                if (t.b[i] > 0) key[at(i)] = t.vertex[at(i)];
            }
            std::sort(key.begin(), key.begin() + 3);
            return !seen.insert(key).second;
        });
    }

    void set_stiffness() {
        answer_.resize(special_.size());
        for (size_t i = 0; i < special_.size() && !touches_.empty(); ++i)
            answer_[i] = vertex_system(body_, state_, special_[i], h_body_).hessian;
        touch_n_m_.clear();
        for (const SphereTouch& t : touches_) {
            double gives = 0;
            for (int i = 0; i < 3; ++i) {
                const Mat3& k = answer_[at(slot_[at(t.vertex[at(i)])])];
                gives += t.b[i] * t.b[i] / t.n.dot(k * t.n);
            }
            touch_n_m_.push_back(std::min(k_, kContactRatio / gives));
        }
    }

    void add_special(int32_t v) {
        if (slot_[at(v)] >= 0) return;
        slot_[at(v)] = static_cast<int32_t>(special_.size());
        special_.push_back(v);
        state_.contact_vertex[at(v)] = 1;
    }

    [[nodiscard]] double gap(const SphereTouch& t) const {
        double g = t.gap_m;
        for (int i = 0; i < 3; ++i) g += t.b[i] * t.n.dot(to_vec(state_.x[at(t.vertex[at(i)])]));
        return g;
    }

    struct Grip {
        Vec3 slide = Vec3::Zero(), normal = Vec3::UnitZ();
        double stiffness_n_m = 0, limit_n = 0;
    };

    /// Dry friction with a memory: a spring to the place where the vertex sticks to the sphere.
    [[nodiscard]] Grip grip_of(int32_t v, const Vec3& load) const {
        Grip grip;
        const Anchor& a = anchor_[at(v)];
        const double size = load.norm();
        if (a.sphere < 0 || !(size > 0)) return grip;
        const SphereObstacle& s = spheres_[at(a.sphere)];
        grip.normal = load / size;
        const Vec3 way = to_vec(state_.x[at(v)]) - (s.centre_at(time_) + a.from_centre);
        grip.slide = way - grip.normal * grip.normal.dot(way);
        grip.limit_n = s.friction * size;
        grip.stiffness_n_m = grip_n_m(v);
        const double length = grip.slide.norm();
        if (length * grip.stiffness_n_m > grip.limit_n) grip.stiffness_n_m = grip.limit_n / length;
        return grip;
    }

    [[nodiscard]] double grip_n_m(int32_t v) const {
        return std::min(k_, kContactRatio * answer_[at(slot_[at(v)])].trace() / 3);
    }

    void solve_special() {
        for (size_t i = 0; i < special_.size(); ++i) {
            const int32_t v = special_[i];
            Float4& x = state_.x[at(v)];
            if (x.w == 0) continue;
            put_on_axes(v);
            VertexSystem system = vertex_system(body_, state_, v, h_body_);
            Vec3 load = Vec3::Zero();
            for (const int32_t entry : incidence_[i]) {
                const SphereTouch& t = touches_[at(entry / 4)];
                const double b = t.b[entry % 4], g = gap(t), k = touch_n_m_[at(entry / 4)];
                if (g >= 0 || b == 0) continue;
                system.gradient += k * g * b * t.n;
                system.hessian += k * b * b * t.n * t.n.transpose();
                load -= k * g * b * t.n;
            }
            if (load.squaredNorm() > 0) {
                const Grip grip = grip_of(v, load);
                system.gradient += grip.stiffness_n_m * grip.slide;
                system.hessian +=
                    grip.stiffness_n_m * (Mat3::Identity() - grip.normal * grip.normal.transpose());
            }
            for (int a = 0; a < 3; ++a) {
                if ((setup_.held[at(v)] >> a & 1) == 0) continue;
                system.gradient[a] = 0;
                system.hessian.row(a).setZero();
                system.hessian.col(a).setZero();
                system.hessian(a, a) = 1;
            }
            Vec3 step = -system.hessian.llt().solve(system.gradient);
            const double longest = static_cast<double>(body_.shortest_edge_m()[at(v)]) / 4;
            const double length = step.norm();
            if (!std::isfinite(length)) continue;
            if (length > longest) step *= longest / length;
            x.x += static_cast<float>(step.x());
            x.y += static_cast<float>(step.y());
            x.z += static_cast<float>(step.z());
        }
    }

    /// Forces on the spheres, and where vertices stick from now on.
    void finish_touches() {
        if (!contacts_) return;
        ++frame_substeps_;
        std::vector<Vec3> load(special_.size(), Vec3::Zero());
        std::vector<int> sphere(special_.size(), -1);
        deepest_ = 0;
        for (size_t n = 0; n < touches_.size(); ++n) {
            const SphereTouch& t = touches_[n];
            const double g = gap(t), k = touch_n_m_[n];
            if (g >= 0) continue;
            deepest_ = std::max(deepest_, -g);
            force_[at(t.sphere)] += k * g * t.n;
            for (int i = 0; i < 3; ++i) {
                const auto slot = at(slot_[at(t.vertex[at(i)])]);
                load[slot] -= k * g * t.b[i] * t.n;
                sphere[slot] = t.sphere;
            }
        }
        for (size_t i = 0; i < special_.size(); ++i) {
            const int32_t v = special_[i];
            Anchor& anchor = anchor_[at(v)];
            if (!(load[i].norm() > 0)) {
                anchor.sphere = -1;
                continue;
            }
            const SphereObstacle& s = spheres_[at(sphere[i])];
            Vec3 place = to_vec(state_.x[at(v)]);
            if (anchor.sphere == sphere[i]) {
                const Grip grip = grip_of(v, load[i]);
                force_[at(sphere[i])] += grip.stiffness_n_m * grip.slide;
                // Dragged along where it slips.
                place -= grip.stiffness_n_m / grip_n_m(v) * grip.slide;
            }
            anchor = {sphere[i], place - s.centre_at(time_)};
        }
    }

    void take_sample(double time_s, double& next) {
        if (time_s < next - h_ / 2) return;
        setup_.sample(time_s, positions(), out_);
        while (next <= time_s + h_ / 2) next += setup_.scene.sample_s;
    }

    [[nodiscard]] Coordinates positions() const { return flat(state_.x) / units_.length; }

    static Coordinates flat(const std::vector<Float4>& points) {
        Coordinates out(3 * static_cast<Eigen::Index>(points.size()));
        for (size_t i = 0; i < points.size(); ++i)
            out.segment<3>(3 * static_cast<Eigen::Index>(i)) = to_vec(points[i]);
        return out;
    }

    void finish(double time_s) {
        for (size_t i = 0; i < force_.size(); ++i)
            out_.contact_forces.push_back(
                {"/sdf_contacts/" + std::to_string(i),
                 force_[i] / (units_.force() * std::max(1, frame_substeps_))});
        out_.penetration_m = deepest_ / units_.length;
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
                    (body_.mesh().rest[at(tet[k])] - body_.mesh().rest[at(tet[0])]).norm();
                const double now =
                    (to_vec(state_.x[at(tet[k])]) - to_vec(state_.x[at(tet[0])])).norm();
                longest = std::max(longest, now / rest);
            }
        }
        return longest;
    }

    struct Anchor {
        int sphere = -1;
        Vec3 from_centre = Vec3::Zero();
    };

    const SolveSetup& setup_;
    SolveResult& out_;
    const KernelUnits units_;
    const double h_, h_body_;  // of a substep, in the scene's units and in the kernels'
    double time_ = 0;          // the scene's; all below is in the kernels' units
    double k_ = 0, deepest_ = 0;
    const std::vector<SphereObstacle> spheres_;
    std::unique_ptr<SphereContacts> contacts_;
    bool vbd_ = true, pushed_ = false;
    SoftBody body_;
    SoftBodyState state_;
    Workers workers_;
    std::vector<int32_t> held_, special_, slot_;
    std::vector<std::vector<int32_t>> incidence_;  // touch * 4 + corner, of each special vertex
    std::vector<SphereTouch> touches_;
    std::vector<double> touch_n_m_;  // stiffness of each
    std::vector<Mat3> answer_;       // Hessian of each special vertex, its neighbours held
    std::vector<Anchor> anchor_;
    std::vector<Vec3> force_;
    int frame_substeps_ = 0;
    uint32_t flags_ = 0, last_flags_ = 0;  // of all substeps, of the last one
};

}  // namespace

void run_fast(const SolveSetup& setup, SolveResult& out) { FastRun(setup, out).run(); }

}  // namespace placode::sim
