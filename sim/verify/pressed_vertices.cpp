// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/verify/pressed_vertices.h"

#include <algorithm>

#include "sim/contact/contact_core.h"
#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/solver/double_float.h"

namespace placode::sim {
namespace {

// Stiffness of a contact: x E x edge at most, so that the penetration is far below the indentation.
constexpr double kContactStiffness = 300;
constexpr double kMarginOfEdge = 0.2;  // contact starts this far out, and twice a substep's way

/// Of a point from the surface of a sphere, away from it.
Distance distance_to_sphere(const Vec3& centre, double radius_m, const Vec3& p) {
    const Vec3 offset = p - centre;
    const double length = offset.norm();
    if (!(length > 0)) return {-radius_m, Vec3::UnitX()};
    return {length - radius_m, offset / length};
}

}  // namespace

PressedVertices::PressedVertices(const SolveSetup& setup, const KernelUnits& units,
                                 const SoftBody& body, SoftBodyState& state, double h_body)
    : setup_(setup),
      units_(units),
      body_(body),
      state_(state),
      h_(setup.scene.solver.frame_s / setup.scene.solver.substeps),
      h_body_(h_body),
      spheres_(units.scaled(setup.scene.spheres)),
      lists_(body.vertex_count(), 0, 0) {
    if (!setup.contacts) return;
    contacts_ = std::make_unique<SphereContacts>(body_.mesh(), spheres_, setup.free_sheet());
    anchor_.resize(as_index(body_.vertex_count()));
    most_n_m_ = kContactStiffness * units_.stress() * setup.scene.material.youngs_modulus_pa *
                contacts_->mean_edge_m();
    force_.assign(spheres_.size(), Vec3::Zero());
}

void PressedVertices::start_frame() {
    std::fill(force_.begin(), force_.end(), Vec3::Zero());
    frame_substeps_ = 0;
    ++frame_;
}

Vec3 PressedVertices::centre(int32_t sphere, double time_s) const {
    return spheres_[as_index(sphere)].centre_at(time_s);
}

bool PressedVertices::touches(int32_t v) const { return lists_.slot[as_index(v)] >= 0; }

Vec3 PressedVertices::force(size_t sphere) const {
    return force_[sphere] / (units_.force() * std::max(1, frame_substeps_));
}

void PressedVertices::find(const RigidModes* modes) {
    if (!contacts_) return;
    clear_contacts(lists_, colour_, state_);
    touch_near_triangles();
    recall_anchors();
    if (modes != nullptr) anchor_newcomers();
    begin_contacts(lists_, body_, state_, {most_n_m_, h_body_, frame_});
    if (modes != nullptr) go_with(*modes);
}

void PressedVertices::touch_near_triangles() {
    double fastest = 0;
    for (const SphereObstacle& s : spheres_) fastest = std::max(fastest, s.velocity_m_s.norm());
    const double margin = kMarginOfEdge * contacts_->mean_edge_m() + 2 * h_ * fastest;
    const auto x = [this](int32_t v) { return to_vec(state_.x_start[as_index(v)]); };
    contacts_->near(x, time_, margin, near_);
    // Three corners and the nearest point of each.
    const auto most = static_cast<int>(near_.size());
    lists_.make_room(4 * most, 3 * most);
    for (const SphereTouch& t : near_) {
        const SphereObstacle& sphere = spheres_[as_index(t.sphere)];
        const Vec3 at = sphere.centre_at(time_);
        NearTriangle triangle;
        triangle.vertex = t.vertex;
        triangle.both_sides = t.both_sides;
        triangle.friction = static_cast<float>(sphere.friction);
        triangle.nearest = {t.gap_m, t.b, t.n, 0, false};
        for (size_t k = 0; k < 3; ++k) {
            triangle.x[k] = x(t.vertex[k]);
            triangle.corner[k] = distance_to_sphere(at, sphere.radius_m, triangle.x[k]);
        }
        RigidSide side{t.sphere, margin};
        [[maybe_unused]] const bool room = touch_triangle(lists_, state_, side, triangle);
        assert(room);
    }
}

/// Where the vertices of the colour stick. Who left it has lifted off.
void PressedVertices::recall_anchors() {
    for (const int32_t v : colour_) {
        if (!touches(v)) anchor_[as_index(v)] = {};
    }
    colour_.clear();
    for (int i = 0; i < lists_.vertex_count; ++i) {
        ContactVertex& touched = lists_.vertices[as_index(i)];
        colour_.push_back(touched.vertex);
        const Anchor& anchor = anchor_[as_index(touched.vertex)];
        if (anchor.sphere < 0) continue;
        touched.sticks_to = anchor.sphere;
        touched.slipping = anchor.slipping;
        touched.sticks_at = centre(anchor.sphere, time_) + anchor.from_centre;
    }
}

/// Of bodies that nothing holds: who may be touched for the first time sticks to where it comes
/// from. A block that slides chatters, and its contacts last for no more than a substep.
void PressedVertices::anchor_newcomers() {
    for (int i = 0; i < lists_.vertex_count; ++i) {
        ContactVertex& touched = lists_.vertices[as_index(i)];
        if (touched.sticks_to >= 0) continue;
        touched.sticks_to = touched.side;
        touched.sticks_at = exact_position(state_, touched.vertex) -
                            moved_in_substep(state_, touched.vertex) + centre(touched.side, time_) -
                            centre(touched.side, time_ - h_);
    }
}

/// A vertex that begins where it was goes with its body as a whole, or a body that slides would be
/// held back by it. Not into the sphere: what overlaps much at the start of an impact is pressed
/// and rubbed too hard.
void PressedVertices::go_with(const RigidModes& modes) {
    for (int i = 0; i < lists_.vertex_count; ++i) {
        const ContactVertex& touched = lists_.vertices[as_index(i)];
        if (state_.x[as_index(touched.vertex)].w == 0) continue;
        Vec3 offset = modes.displacement(touched.vertex);
        for (int n = touched.first; n < touched.first + touched.count; ++n) {
            const Vec3& normal = lists_.contacts[as_index(lists_.incidence[as_index(n)] / 4)].n;
            offset -= std::min(0.0, normal.dot(offset)) * normal;
        }
        move_vertex(state_, touched.vertex, offset);
    }
}

void PressedVertices::solve(bool backward) {
    for (int turn = 0; turn < lists_.vertex_count; ++turn) {
        const int i = backward ? lists_.vertex_count - 1 - turn : turn;
        ContactVertex& touched = lists_.vertices[as_index(i)];
        if (state_.x[as_index(touched.vertex)].w == 0) continue;
        const VertexStep taken = solve_contact(lists_, body_, state_, touched, h_body_,
                                               setup_.held[as_index(touched.vertex)]);
        if (!taken.finite) state_.flags |= kNotFinite;
        if (taken.limited) state_.flags |= kStepLimited;
    }
}

const std::vector<ContactPush>& PressedVertices::pushes() {
    pushes_.clear();
    weigh_contacts(lists_, state_, [this](const Contact& c, double, double force) {
        Vec3 place = Vec3::Zero();
        for (size_t k = 0; k < as_index(c.corners); ++k)
            place += c.b[k] * exact_position(state_, c.vertex[k]);
        pushes_.push_back(
            {c.side, c.vertex[0], place, force * c.n, c.stiffness_n_m * c.n * c.n.transpose()});
    });
    for (int i = 0; i < lists_.vertex_count; ++i) {
        const ContactVertex& touched = lists_.vertices[as_index(i)];
        const Friction f = friction_of(touched, state_);
        if (!(f.stiffness_n_m > 0)) continue;
        pushes_.push_back({touched.side, touched.vertex, exact_position(state_, touched.vertex),
                           -f.stiffness_n_m * f.slide,
                           f.stiffness_n_m * (Mat3::Identity() - f.normal * f.normal.transpose())});
    }
    return pushes_;
}

void PressedVertices::finish() {
    if (!contacts_) return;
    ++frame_substeps_;
    for (const ContactPush& push : pushes()) force_[as_index(push.sphere)] -= push.force_n;
    deepest_ = 0;
    for (int i = 0; i < lists_.contact_count; ++i)
        deepest_ = std::max(deepest_, -gap_of(lists_.contacts[as_index(i)], state_));
    for (int i = 0; i < lists_.vertex_count; ++i) {
        ContactVertex& touched = lists_.vertices[as_index(i)];
        stick(touched, state_);
        Anchor& anchor = anchor_[as_index(touched.vertex)];
        anchor = {touched.sticks_to, touched.slipping};
        if (anchor.sphere >= 0)
            anchor.from_centre = touched.sticks_at - centre(anchor.sphere, time_);
    }
}

}  // namespace placode::sim
