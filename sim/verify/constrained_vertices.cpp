// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/constrained_vertices.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/core/as_index.h"
#include "sim/solver/double_float.h"

namespace placode::sim {
namespace {

constexpr int kPasses = 2;  // over what is touched, for each sweep, as in sim/step
// Stiffness of a contact: x E x edge at most, so that the penetration is far below the indentation.
constexpr double kContactStiffness = 300;

}  // namespace

ConstrainedVertices::ConstrainedVertices(const SolveSetup& setup, const KernelUnits& units,
                                         const SoftBody& body, SoftBodyState& state, double h_body)
    : setup_(setup),
      units_(units),
      body_(body),
      state_(state),
      h_body_(h_body),
      spheres_(units.scaled(setup.scene.spheres)),
      slot_(as_index(body.vertex_count()), -1) {
    if (!setup.contacts) return;
    contacts_ = std::make_unique<SphereContacts>(body_.mesh(), spheres_, setup.free_sheet());
    anchor_.resize(as_index(body_.vertex_count()));
    k_ = kContactStiffness * units_.stress() * setup.scene.material.youngs_modulus_pa *
         contacts_->mean_edge_m();
    force_.assign(spheres_.size(), Vec3::Zero());
}

void ConstrainedVertices::start_frame() {
    std::fill(force_.begin(), force_.end(), Vec3::Zero());
    frame_substeps_ = 0;
}

Vec3 ConstrainedVertices::force(size_t sphere) const {
    return force_[sphere] / (units_.force() * std::max(1, frame_substeps_));
}

double ConstrainedVertices::held_at(int32_t v, int axis) const {
    // The way as a float, which is the same in all units.
    const auto way = static_cast<float>(units_.length * setup_.held_way(v, axis, time_));
    return body_.mesh().rest[as_index(v)][axis] + static_cast<double>(way);
}

void ConstrainedVertices::put_on_axes(int32_t v) {
    const uint8_t axes = setup_.held[as_index(v)];
    if (axes == 0) return;
    Vec3 place = exact_position(state_, v);
    for (int a = 0; a < 3; ++a) {
        if ((axes >> a & 1) != 0) place[a] = held_at(v, a);
    }
    put_vertex(state_, v, place);
}

void ConstrainedVertices::add(int32_t v) {
    if (slot_[as_index(v)] >= 0) return;
    slot_[as_index(v)] = static_cast<int32_t>(special_.size());
    special_.push_back(v);
    state_.contact_vertex[as_index(v)] = 1;
}

void ConstrainedVertices::find(const RigidModes* modes) {
    for (const int32_t v : special_) {
        slot_[as_index(v)] = -1;
        state_.contact_vertex[as_index(v)] = 0;
    }
    special_.clear();
    for (const int32_t v : setup_.partly_held()) add(v);
    find_touches();
    set_stiffness();
    incidence_.assign(special_.size(), {});
    for (size_t t = 0; t < touches_.size(); ++t) {
        for (int i = 0; i < 3; ++i)
            incidence_[as_index(slot_[as_index(touches_[t].vertex[as_index(i)])])].push_back(
                static_cast<int32_t>(4 * t) + i);
    }
    start_where_they_were(modes);
    anchor_newcomers();
}

/// Between sphere and tissue a vertex starts from where it was, see sim/contact/contact.cpp; and
/// goes with the body as a whole, or a body that slides would be held back by it. Not into the
/// sphere: what overlaps much at the start of an impact is pressed and rubbed too hard.
void ConstrainedVertices::start_where_they_were(const RigidModes* modes) {
    for (size_t i = 0; i < special_.size(); ++i) {
        if (incidence_[i].empty()) continue;
        const int32_t v = special_[i];
        Float4& x = state_.x[as_index(v)];
        if (x.w == 0) continue;
        const Float4& before = state_.x_start[as_index(v)];
        x = {before.x, before.y, before.z, x.w};
        if (!state_.x_low.empty()) state_.x_low[as_index(v)] = state_.x_start_low[as_index(v)];
        if (modes == nullptr) continue;
        Vec3 way = modes->way(v);
        for (const int32_t entry : incidence_[i]) {
            const Vec3& n = touches_[as_index(entry / 4)].n;
            way -= std::min(0.0, n.dot(way)) * n;
        }
        move_vertex(state_, v, way);
    }
}

/// Who may be touched for the first time sticks to where it comes from: friction acts from the
/// first substep on, and contacts that last for no more than one are not without.
void ConstrainedVertices::anchor_newcomers() {
    const double h = setup_.scene.solver.frame_s / setup_.scene.solver.substeps;
    for (size_t i = 0; i < special_.size(); ++i) {
        if (incidence_[i].empty()) continue;
        Anchor& anchor = anchor_[as_index(special_[i])];
        if (anchor.sphere >= 0) continue;
        const int sphere = touches_[as_index(incidence_[i].front() / 4)].sphere;
        const Vec3 before =
            exact_position(state_, special_[i]) - way_in_substep(state_, special_[i]);
        anchor = {sphere, before - spheres_[as_index(sphere)].centre_at(time_ - h)};
    }
}

void ConstrainedVertices::find_touches() {
    touches_.clear();
    if (!contacts_) return;
    double fastest = 0;
    for (const SphereObstacle& s : spheres_) fastest = std::max(fastest, s.velocity_m_s.norm());
    const VerificationSolver& solver = setup_.scene.solver;
    const double h = solver.frame_s / solver.substeps;  // velocities are those of the scene's time
    const double margin = 0.2 * contacts_->mean_edge_m() + 2 * h * fastest;
    contacts_->find([this](int32_t v) { return to_vec(state_.x_start[as_index(v)]); }, time_,
                    margin, touches_);
    drop_doubles();
    for (SphereTouch& t : touches_) {
        double place = 0;
        for (int i = 0; i < 3; ++i) {
            add(t.vertex[as_index(i)]);
            place += t.b[i] * t.n.dot(to_vec(state_.x_start[as_index(t.vertex[as_index(i)])]));
        }
        t.gap_m -= place;  // from here on the offset of gap = n . (sum b x) + offset
    }
}

/// A corner or an edge is touched once, however many triangles meet there.
void ConstrainedVertices::drop_doubles() {
    std::set<std::array<int32_t, 4>> seen;
    std::erase_if(touches_, [&](const SphereTouch& t) {
        std::array<int32_t, 4> key{-1, -1, -1, t.sphere};
        for (int i = 0; i < 3; ++i) {
            if (t.b[i] > 0) key[as_index(i)] = t.vertex[as_index(i)];
        }
        std::sort(key.begin(), key.begin() + 3);
        return !seen.insert(key).second;
    });
}

void ConstrainedVertices::set_stiffness() {
    answer_.resize(special_.size());
    for (size_t i = 0; i < special_.size() && !touches_.empty(); ++i)
        answer_[i] = vertex_system(body_, state_, special_[i], h_body_).hessian;
    touch_n_m_.clear();
    for (const SphereTouch& t : touches_) {
        double gives = 0;
        for (int i = 0; i < 3; ++i) {
            const Mat3& k = answer_[as_index(slot_[as_index(t.vertex[as_index(i)])])];
            gives += t.b[i] * t.b[i] / t.n.dot(k * t.n);
        }
        touch_n_m_.push_back(std::min(k_, kContactRatio / gives));
    }
}

double ConstrainedVertices::gap(const SphereTouch& t) const {
    double g = t.gap_m;
    for (int i = 0; i < 3; ++i)
        g += t.b[i] * t.n.dot(exact_position(state_, t.vertex[as_index(i)]));
    return g;
}

double ConstrainedVertices::friction_n_m(int32_t v) const {
    return std::min(k_, kContactRatio * answer_[as_index(slot_[as_index(v)])].trace() / 3);
}

/// Friction of a vertex that a sphere presses.
Friction ConstrainedVertices::friction_of(int32_t v, const Vec3& load) const {
    const Anchor& a = anchor_[as_index(v)];
    const double size = load.norm();
    if (a.sphere < 0 || !(size > 0)) return {};
    const SphereObstacle& s = spheres_[as_index(a.sphere)];
    const Vec3 sticks_at = s.centre_at(time_) + a.from_centre;
    return dry_friction(load, exact_position(state_, v) - sticks_at, s.friction * size,
                        friction_n_m(v));
}

void ConstrainedVertices::hold_axes(int32_t v, VertexSystem& system) const {
    for (int a = 0; a < 3; ++a) {
        if ((setup_.held[as_index(v)] >> a & 1) == 0) continue;
        system.gradient[a] = 0;
        system.hessian.row(a).setZero();
        system.hessian.col(a).setZero();
        system.hessian(a, a) = 1;
    }
}

/// What only axes hold is a vertex among others: as they, over-relaxed and once a sweep.
double ConstrainedVertices::relaxation_of(size_t i) const {
    const SolverSettings& solver = body_.spec().solver;
    return solver.method == Method::kVbd && incidence_[i].empty() ? solver.over_relaxation : 1;
}

void ConstrainedVertices::solve_vertex(size_t i) {
    const int32_t v = special_[i];
    if (state_.x[as_index(v)].w == 0) return;
    put_on_axes(v);
    VertexSystem system = vertex_system(body_, state_, v, h_body_);
    Vec3 load = Vec3::Zero();
    for (const int32_t entry : incidence_[i]) {
        const SphereTouch& t = touches_[as_index(entry / 4)];
        const double b = t.b[entry % 4], g = gap(t), k = touch_n_m_[as_index(entry / 4)];
        if (g >= 0 || b == 0) continue;
        add_normal_contact(system, k, b, g, t.n);
        load -= k * g * b * t.n;
    }
    if (load.squaredNorm() > 0) add_friction(system, friction_of(v, load));
    hold_axes(v, system);
    const VertexStep way =
        vertex_step(system, relaxation_of(i), body_.shortest_edge_m()[as_index(v)]);
    if (way.finite) move_vertex(state_, v, way.step);
}

void ConstrainedVertices::solve() {
    for (int pass = 0; pass < kPasses; ++pass) {
        for (size_t i = 0; i < special_.size(); ++i) {
            if (pass == 0 || !incidence_[i].empty()) solve_vertex(i);
        }
    }
}

const std::vector<ContactPush>& ConstrainedVertices::pushes() {
    pushes_.clear();
    load_.assign(special_.size(), Vec3::Zero());
    load_sphere_.assign(special_.size(), -1);
    for (size_t n = 0; n < touches_.size(); ++n) {
        const SphereTouch& t = touches_[n];
        const double g = gap(t), k = touch_n_m_[n];
        if (g >= 0) continue;
        Vec3 place = Vec3::Zero();
        for (int i = 0; i < 3; ++i) {
            const int32_t v = t.vertex[as_index(i)];
            place += t.b[i] * exact_position(state_, v);
            load_[as_index(slot_[as_index(v)])] -= k * g * t.b[i] * t.n;
            load_sphere_[as_index(slot_[as_index(v)])] = t.sphere;
        }
        pushes_.push_back({t.sphere, t.vertex[0], place, -k * g * t.n, k * t.n * t.n.transpose()});
    }
    for (size_t i = 0; i < special_.size(); ++i) {
        const int32_t v = special_[i];
        if (load_sphere_[i] < 0 || anchor_[as_index(v)].sphere != load_sphere_[i]) continue;
        const Friction f = friction_of(v, load_[i]);
        pushes_.push_back({load_sphere_[i], v, exact_position(state_, v),
                           -f.stiffness_n_m * f.slide,
                           f.stiffness_n_m * (Mat3::Identity() - f.normal * f.normal.transpose())});
    }
    return pushes_;
}

void ConstrainedVertices::finish() {
    if (!contacts_) return;
    ++frame_substeps_;
    for (const ContactPush& p : pushes()) force_[as_index(p.sphere)] -= p.force_n;
    deepest_ = 0;
    for (const SphereTouch& t : touches_) deepest_ = std::max(deepest_, -gap(t));
    stick();
}

/// Anchors of friction are dragged along where they slip.
void ConstrainedVertices::stick() {
    for (size_t i = 0; i < special_.size(); ++i) {
        const int32_t v = special_[i];
        Anchor& anchor = anchor_[as_index(v)];
        if (!(load_[i].norm() > 0)) {
            anchor.sphere = -1;
            continue;
        }
        Vec3 place = exact_position(state_, v);
        if (anchor.sphere == load_sphere_[i]) {
            const Friction f = friction_of(v, load_[i]);
            place -= f.stiffness_n_m / friction_n_m(v) * f.slide;
        }
        anchor = {load_sphere_[i], place - spheres_[as_index(load_sphere_[i])].centre_at(time_)};
    }
}

}  // namespace placode::sim
