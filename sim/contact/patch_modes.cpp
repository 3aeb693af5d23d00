// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/contact/patch_modes.h"

#include <Eigen/Cholesky>

#include "sim/contact/contact_core.h"
#include "sim/contact/patch_contact.h"
#include "sim/core/as_index.h"
#include "sim/core/turn.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"

namespace placode::sim {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr double kModesLongest = 0.25;  // of an edge, in a substep
// What moves less than floats resolve a few centimetres from the origin is at rest: it must not
// creep by rounding [m].
constexpr double kModesRounding = 1e-10;

/// Forces on a body and how they change as it moves and turns about a point. Times h^2.
struct Pushes {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Mat3 moves = Mat3::Zero(), mixed = Mat3::Zero(), turns = Mat3::Zero();

    /// @param stiffness symmetric, of a force that acts at r.
    void add(const Vec3& r, const Vec3& push, const Mat3& stiffness) noexcept {
        force += push;
        torque += r.cross(push);
        const Mat3 by_turn = stiffness * cross_matrix(r);
        moves += stiffness;
        mixed += by_turn;
        turns += cross_matrix(r).transpose() * by_turn;
    }
    /// The same about a point that lies at c.
    [[nodiscard]] Pushes about(const Vec3& c) const noexcept {
        const Mat3 shift = cross_matrix(c);
        Pushes out = *this;
        out.torque -= c.cross(force);
        out.mixed -= moves * shift;
        out.turns += -shift.transpose() * mixed - mixed.transpose() * shift +
                     shift.transpose() * moves * shift;
        return out;
    }
};

class PatchModes {
 public:
    PatchModes(const Scene& scene, State& state, double h) noexcept
        : scene_(scene),
          patch_(*scene.patch),
          state_(state),
          h_(h),
          fall_m_s_(h * scene.body.spec().solver.gravity_m_s2),
          from_(to_vec(state.body.x_start[as_index(patch_.first_vertex)])) {}

    void move() noexcept {
        // Jaws often hold one of the last vertices: asked before anything is summed up.
        for (int32_t i = 0; i < patch_.vertex_count; ++i) {
            if (state_.body.x[as_index(patch_.first_vertex + i)].w == 0) return;
        }
        for (int32_t i = 0; i < patch_.vertex_count; ++i) add_vertex(i);
        add_instruments();
        const Vec3 centre = place_ / mass_, start = start_ / mass_;
        const Pushes pushes = pushes_.about(centre);
        Mat6 system;
        system << mass_ * Mat3::Identity() + pushes.moves, -pushes.mixed, -pushes.mixed.transpose(),
            inertia_ - inertia_of(mass_, centre) + pushes.turns;
        Vec6 rest;
        rest << planned_ - went_ + pushes.force,
            missing_turn_ + centre.cross(went_) - start.cross(planned_) + pushes.torque;
        const Eigen::LLT<Mat6> solved(system);
        if (solved.info() != Eigen::Success) return;
        const Vec6 step = solved.solve(rest);
        if (step.allFinite()) turn_about(centre, step.head<3>(), step.tail<3>());
    }

 private:
    void add_vertex(int32_t i) noexcept {
        const size_t v = as_index(patch_.first_vertex + i);
        const SoftBodyState& body = state_.body;
        const double m = static_cast<double>(scene_.body.mass_kg()[v]);
        const Vec3 r = to_vec(body.x[v]) - from_, before = to_vec(body.x_start[v]) - from_;
        const Vec3 offset = r - before, wanted = h_ * (to_vec(body.v[v]) + fall_m_s_);
        mass_ += m;
        place_ += m * r;
        start_ += m * before;
        went_ += m * offset;
        planned_ += m * wanted;
        missing_turn_ += m * (before.cross(wanted) - r.cross(offset));
        inertia_ += inertia_of(m, r);
        const PatchTie& tie = state_.scratch->patch.ties[as_index(i)];
        if (!tie.holds) return;
        const Mat3 k = h_ * h_ * tie.k_n_m;
        pushes_.add(r, k * (tie.place - from_ - r), k);
    }

    /// What presses on the patch, and friction there, at the present places.
    void add_instruments() noexcept {
        const ContactSet& set = state_.scratch->contacts;
        const double h2 = h_ * h_;
        for (int32_t i = 0; i < set.contact_count; ++i) {
            const Contact& c = set.contacts[as_index(i)];
            if (c.side < 0 || !patch_.owns(c.vertex[0])) continue;
            const double gap = gap_of(c, state_.body);
            if (gap >= 0) continue;
            Vec3 at = Vec3::Zero();
            for (size_t k = 0; k < as_index(c.corners); ++k)
                at += c.b[k] * (position(state_.body, c.vertex[k]) - from_);
            const double k = h2 * c.stiffness_n_m;
            pushes_.add(at, -k * gap * c.n, k * c.n * c.n.transpose());
        }
        for (int32_t i = 0; i < set.vertex_count; ++i) {
            const ContactVertex& touched = set.vertices[as_index(i)];
            if (touched.side < 0 || !patch_.owns(touched.vertex)) continue;
            const Friction f = friction_of(touched, state_.body);
            if (!(f.stiffness_n_m > 0)) continue;
            const double k = h2 * f.stiffness_n_m;
            pushes_.add(position(state_.body, touched.vertex) - from_, -k * f.slide,
                        k * (Mat3::Identity() - f.normal * f.normal.transpose()));
        }
    }

    /// A rotation by Cayley's form: exact, and without the library's sine, whose last bit depends
    /// on the processor.
    void turn_about(const Vec3& centre, const Vec3& offset, const Vec3& turn) noexcept {
        Quat q;
        q.coeffs() << turn / 2, 1;
        const Mat3 change = q.normalized().toRotationMatrix() - Mat3::Identity();
        double longest = 0;
        for (int32_t i = 0; i < patch_.vertex_count; ++i)
            longest = std::max(longest, moved(i, centre, offset, change).squaredNorm());
        longest = std::sqrt(longest);
        if (longest < kModesRounding) return;
        const double most =
            kModesLongest *
            static_cast<double>(scene_.body.shortest_edge_m()[as_index(patch_.first_vertex)]);
        const double share = longest > most ? most / longest : 1;
        for (int32_t i = 0; i < patch_.vertex_count; ++i) {
            const Vec3 to = share * moved(i, centre, offset, change);
            Float4& x = state_.body.x[as_index(patch_.first_vertex + i)];
            x = {static_cast<float>(static_cast<double>(x.x) + to.x()),
                 static_cast<float>(static_cast<double>(x.y) + to.y()),
                 static_cast<float>(static_cast<double>(x.z) + to.z()), x.w};
        }
    }
    [[nodiscard]] Vec3 moved(int32_t i, const Vec3& centre, const Vec3& offset,
                             const Mat3& change) const noexcept {
        const Vec3 r = position(state_.body, patch_.first_vertex + i) - from_ - centre;
        return offset + change * r;
    }

    const Scene& scene_;
    const Patch& patch_;
    State& state_;
    double h_;
    Vec3 fall_m_s_, from_;  // all places are from there
    double mass_ = 0;
    Vec3 place_ = Vec3::Zero(), start_ = Vec3::Zero();   // sum m r now, and at the start
    Vec3 went_ = Vec3::Zero(), planned_ = Vec3::Zero();  // sum m of ways, real and without forces
    Vec3 missing_turn_ = Vec3::Zero();  // sum m (r x plan at the start - r x way now)
    Mat3 inertia_ = Mat3::Zero();
    Pushes pushes_;
};

}  // namespace

void move_patch_whole(const Scene& scene, State& state, double h) noexcept {
    if (!scene.patch || patch_sleeps(scene, state)) return;
    PatchModes(scene, state, h).move();
}

}  // namespace placode::sim
