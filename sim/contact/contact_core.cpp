// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How touched vertices answer: stiffness, friction, and their step.

#include <algorithm>
#include <cmath>

#include "sim/contact/contact_core.h"
#include "sim/solver/vertex_stiffness.h"

namespace placode::sim {
namespace {

constexpr uint8_t kSlipMemory = 8;       // substeps without slip until static friction is back
constexpr double kTissueFriction = 0.2;  // of wet tissue on wet tissue

/// What a vertex answers along `n` with its neighbours held [N/m].
double answer_along(const ContactLists& lists, int32_t v, const Vec3& n) noexcept {
    const auto& k = lists.hessian[as_index(v)];
    return k[0] * n.x() * n.x() + k[3] * n.y() * n.y() + k[5] * n.z() * n.z() +
           2 * (k[1] * n.x() * n.y() + k[2] * n.x() * n.z() + k[4] * n.y() * n.z());
}

/// Stiffness of every contact and friction spring, from the tissue's. Once a frame for each vertex.
void set_stiffness(ContactLists& lists, const SoftBody& body, const SoftBodyState& state,
                   const ContactStiffness& by) noexcept {
    for (int i = 0; i < lists.vertex_count; ++i) {
        ContactVertex& touched = lists.vertices[as_index(i)];
        const int32_t v = touched.vertex;
        auto& k = lists.hessian[as_index(v)];
        if (lists.hessian_frame[as_index(v)] != by.frame) {
            lists.hessian_frame[as_index(v)] = by.frame;
            const Mat3 m = vertex_stiffness(body, state, v, by.h_s);
            const double values[6] = {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
            for (size_t n = 0; n < 6; ++n) k[n] = static_cast<float>(values[n]);
        }
        touched.friction_n_m = std::min(by.most_n_m, kContactRatio * (k[0] + k[3] + k[5]) / 3);
    }
    for (int i = 0; i < lists.contact_count; ++i) {
        Contact& c = lists.contacts[as_index(i)];
        double gives = 0;
        for (size_t n = 0; n < as_index(c.corners); ++n) {
            if (state.x[as_index(c.vertex[n])].w == 0) continue;
            const double answer = answer_along(lists, c.vertex[n], c.n);
            if (answer > 0) gives += c.b[n] * c.b[n] / answer;
        }
        c.stiffness_n_m *=
            gives * by.most_n_m > kContactRatio ? kContactRatio / gives : by.most_n_m;
    }
}

/// Incidence lists: contacts of each vertex, in the order of the contacts.
void build_incidence(ContactLists& lists) noexcept {
    const auto vertex_at = [&](int contact, int corner) -> ContactVertex& {
        const int32_t v = lists.contacts[as_index(contact)].vertex[as_index(corner)];
        return lists.vertices[as_index(lists.slot[as_index(v)])];
    };
    for (int i = 0; i < lists.contact_count; ++i) {
        for (int n = 0; n < lists.contacts[as_index(i)].corners; ++n) ++vertex_at(i, n).count;
    }
    int sum = 0;
    for (int i = 0; i < lists.vertex_count; ++i) {
        ContactVertex& touched = lists.vertices[as_index(i)];
        touched.first = sum;
        sum += touched.count;
        touched.count = 0;
    }
    for (int i = 0; i < lists.contact_count; ++i) {
        for (int n = 0; n < lists.contacts[as_index(i)].corners; ++n) {
            ContactVertex& touched = vertex_at(i, n);
            lists.incidence[as_index(touched.first + touched.count++)] = i * 4 + n;
        }
    }
}

/// Friction of tissue on tissue within the substep: a spring against the way since its start,
/// softer where the cone ends. It takes energy only, and forgets: what shall lie still sticks
/// (sim/cutting/pieces.h).
void rub(const SoftBodyState& body, const Contact& c, double b, double load_n,
         VertexSystem& system) noexcept {
    Vec3 offset = Vec3::Zero();
    for (size_t i = 0; i < as_index(c.corners); ++i) {
        offset += c.b[i] *
                  (exact_position(body, c.vertex[i]) - to_vec(body.x_start[as_index(c.vertex[i])]));
    }
    offset -= c.n * c.n.dot(offset);
    double k = c.stiffness_n_m;
    const double length = offset.norm();
    if (length * k > kTissueFriction * load_n) k = kTissueFriction * load_n / length;
    system.gradient += k * b * offset;
    system.hessian += k * b * b * (Mat3::Identity() - c.n * c.n.transpose());
}

}  // namespace

void begin_contacts(ContactLists& lists, const SoftBody& body, SoftBodyState& state,
                    const ContactStiffness& stiffness) noexcept {
    // A vertex between instrument and tissue starts from where it was: with the momentum of the
    // others a deeply pressed patch of fine triangles bursts into oscillation (60 kPa, edges of
    // 0.1 mm, sphere of 1.5 mm dug 0.5 mm in, h = 0.25 ms).
    for (int i = 0; i < lists.vertex_count; ++i) {
        const size_t v = as_index(lists.vertices[as_index(i)].vertex);
        Float4& x = state.x[v];
        const Float4& before = state.x_start[v];
        x = {before.x, before.y, before.z, x.w};
        if (!state.x_low.empty()) state.x_low[v] = state.x_start_low[v];
    }
    set_stiffness(lists, body, state, stiffness);
    build_incidence(lists);
}

Friction friction_of(const ContactVertex& touched, const SoftBodyState& state) noexcept {
    const double load = touched.normal_force_n.norm();
    if (touched.sticks_to < 0 || !(load > 0)) return {};
    const double limit =
        touched.friction * load * (touched.slipping ? 1.0f : touched.friction_static_ratio);
    return dry_friction(touched.normal_force_n,
                        exact_position(state, touched.vertex) - touched.sticks_at, limit,
                        touched.friction_n_m);
}

void add_touch(ContactLists& lists, const SoftBodyState& state, ContactVertex& touched,
               VertexSystem& system) noexcept {
    const Mat3 tissue = system.hessian;
    Vec3 load = Vec3::Zero();
    for (int n = touched.first; n < touched.first + touched.count; ++n) {
        const int32_t entry = lists.incidence[as_index(n)];
        const Contact& c = lists.contacts[as_index(entry / 4)];
        const double b = c.b[as_index(entry % 4)], gap = gap_of(c, state);
        const double k = c.stiffness_n_m;
        if (gap >= 0) continue;
        add_normal_contact(system, k, b, gap, c.n);
        if (c.side == kTissueSide)
            rub(state, c, b, -k * gap, system);
        else
            load -= k * gap * b * c.n;
    }
    touched.normal_force_n = load;
    const double size = load.norm();
    touched.stiffness_n_m = size > 0 ? load.dot(tissue * load) / (size * size) : 0.0;
    const Friction f = friction_of(touched, state);
    if (f.stiffness_n_m > 0) add_friction(system, f);
}

VertexStep solve_contact(ContactLists& lists, const SoftBody& body, SoftBodyState& state,
                         ContactVertex& touched, double h_s, uint8_t held) noexcept {
    VertexSystem system = vertex_system(body, state, touched.vertex, h_s);
    add_touch(lists, state, touched, system);
    if (held != 0) hold_axes(system, held);
    VertexStep taken =
        vertex_step(system, 1, body.shortest_edge_m()[as_index(origin_of(state, touched.vertex))]);
    if (taken.finite) move_vertex(state, touched.vertex, taken.step);
    return taken;
}

void stick(ContactVertex& touched, const SoftBodyState& state) noexcept {
    if (!(touched.normal_force_n.norm() > 0)) {
        touched.sticks_to = kTissueSide;
        touched.slipping = 0;
        return;
    }
    const Vec3 x = exact_position(state, touched.vertex);
    Vec3 at = x;
    if (touched.sticks_to == touched.side) {
        const Friction f = friction_of(touched, state);
        const double k = touched.friction_n_m, length = f.slide.norm();
        const double dynamic = touched.friction * touched.normal_force_n.norm();
        if (length * k > f.limit_n) {
            touched.slipping = kSlipMemory;
        } else if (touched.slipping > 0) {
            --touched.slipping;
        }
        const double keep = touched.slipping && length * k > dynamic ? dynamic / (length * k) : 1.0;
        at = x - keep * f.slide;
    } else {
        touched.slipping = 0;
    }
    touched.sticks_to = touched.side;
    touched.sticks_at = at;
}

}  // namespace placode::sim
