// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/rod/rod.h"

#include <cassert>
#include <cmath>
#include <numbers>

#include "sim/core/as_index.h"
#include "sim/core/fnv_hash.h"
#include "sim/core/number_text.h"
#include "sim/core/portable_math.h"
#include "sim/rod/rod_elements-inl.h"

namespace placode::sim {
namespace {

[[noreturn]] void refuse(const char* field, double found, const char* expected) {
    throw RodError(field, "found " + shortest_text(found) + "; expected " + expected);
}
void need_positive(const char* field, double found) {
    if (!(found > 0) || !std::isfinite(found)) refuse(field, found, "a number above 0");
}

void check(const RodSpec& s) {
    if (s.segments < 1 || s.segments > kMaxRodSegments)
        refuse("segments", s.segments, "a whole number from 1 to 300");
    need_positive("length_m", s.length_m);
    need_positive("radius_m", s.radius_m);
    need_positive("density_kg_m3", s.density_kg_m3);
    need_positive("stretch_n", s.stiffness.stretch_n);
    need_positive("shear_n", s.stiffness.shear_n);
    need_positive("bend_n_m2", s.stiffness.bend_n_m2);
    need_positive("twist_n_m2", s.stiffness.twist_n_m2);
    if (!(s.drag_per_s >= 0)) refuse("drag_per_s", s.drag_per_s, "0 or more");
    if (!(s.retardation_s >= 0)) refuse("retardation_s", s.retardation_s, "0 or more");
    const auto n = as_index(s.segments);
    if (!s.segment_m.empty() && s.segment_m.size() != n)
        refuse("segment_m", static_cast<double>(s.segment_m.size()), "a length for every segment");
    if (!s.rest_bend_rad.empty() && s.rest_bend_rad.size() != n - 1)
        refuse("rest_bend_rad", static_cast<double>(s.rest_bend_rad.size()),
               "an angle for every node between two segments");
    double sum = 0;
    for (const double l : s.segment_m) {
        need_positive("segment_m", l);
        sum += l;
    }
    if (!s.segment_m.empty() && std::abs(sum - s.length_m) > 1e-6 * s.length_m)
        refuse("segment_m", sum, "lengths that add up to length_m");
    for (const Vec3& bend : s.rest_bend_rad) {
        if (!(bend.norm() < 1.5)) refuse("rest_bend_rad", bend.norm(), "an angle below 1.5");
    }
}

V3<double> of(const Vec3& a) { return {a.x(), a.y(), a.z()}; }
Q4<double> of(const Quat& q) { return {q.w(), {q.x(), q.y(), q.z()}}; }
Vec3 to_vec(const V3<double>& a) { return {a.x, a.y, a.z}; }

/// The strain at node j: between the segments at its sides, or a clamp and a segment.
/// Nothing where an end is free.
bool bend_at(const Rod& rod, const RodState& state, int node, BendStrain<double>& out) {
    const int n = rod.segments();
    if ((node == 0 && state.end_held[0] == 0) || (node == n && state.end_held[1] == 0))
        return false;
    const Quat& near = node == 0 ? state.end_frame[0] : state.q[as_index(node - 1)];
    const Quat& far = node == n ? state.end_frame[1] : state.q[as_index(node)];
    out = bend_strain(of(near), of(far), of(rod.rest_omega()[as_index(node)]), V3<double>{0, 0, 0},
                      0.0, 1 / rod.bend_length_m()[as_index(node)], rod.spec().stiffness);
    return true;
}

SegmentStrain<double> segment_at(const Rod& rod, const RodState& state, int j) {
    const auto i = as_index(j);
    return segment_strain(of(state.x[i]), of(state.x[i + 1]), third_axis(of(state.q[i])),
                          1 / rod.length_m()[i], rod.spec().stiffness);
}

/// Every field by its list, as bytes.
class Hash : public FnvHash {
 public:
    template <class... Lists>
    void state(const Lists&... lists) noexcept {
        (bytes(lists.data(), lists.size() * sizeof(lists[0])), ...);
    }
};

}  // namespace

RodStiffness round_rod(double radius_m, double youngs_modulus_pa, double poissons_ratio) noexcept {
    const double area = std::numbers::pi * radius_m * radius_m;
    const double shear = youngs_modulus_pa / (2 * (1 + poissons_ratio));
    const double factor = 6 * (1 + poissons_ratio) / (7 + 6 * poissons_ratio);
    const double second = area * radius_m * radius_m / 4;
    return {youngs_modulus_pa * area, factor * shear * area, youngs_modulus_pa * second,
            shear * 2 * second};
}

Rod::Rod(RodSpec spec) : spec_(std::move(spec)) {
    check(spec_);
    const auto n = as_index(spec_.segments);
    length_m_ = spec_.segment_m;
    if (length_m_.empty()) length_m_.assign(n, spec_.length_m / spec_.segments);
    const double r = spec_.radius_m;
    const double per_m = spec_.density_kg_m3 * std::numbers::pi * r * r;
    mass_kg_.assign(n + 1, 0.0);
    bend_m_.assign(n + 1, 0.0);
    for (size_t j = 0; j < n; ++j) {
        for (const size_t node : {j, j + 1}) {
            mass_kg_[node] += 0.5 * per_m * length_m_[j];
            bend_m_[node] += 0.5 * length_m_[j];
        }
        inertia_.push_back(per_m * length_m_[j] * r * r / 4);
    }
    rest_omega_.assign(n + 1, Vec3::Zero());
    for (size_t j = 0; j + 1 < n && !spec_.rest_bend_rad.empty(); ++j) {
        const Vec3& bend = spec_.rest_bend_rad[j];
        const double angle = bend.norm();
        if (angle > 0) rest_omega_[j + 1] = 4 * tan_portable(angle / 4) / angle * bend;
    }
}

RodState::RodState(const Rod& rod, const std::vector<Vec3>& places) : x(places) {
    const auto n = as_index(rod.segments());
    v.assign(n + 1, Vec3::Zero());
    w.assign(n, Vec3::Zero());
    node_held.assign(n + 1, 0);
    node_target = x;
    frame_held.assign(n, 0);
    Vec3 direction = Vec3::UnitZ();
    Quat frame = Quat::Identity();
    for (size_t j = 0; j < n; ++j) {
        const Vec3 next = (x[j + 1] - x[j]).normalized();
        frame = (Quat::FromTwoVectors(direction, next) * frame).normalized();
        direction = next;
        q.push_back(frame);
    }
    frame_target = q;
}

void hold_node(RodState& state, int node) noexcept {
    state.node_held[as_index(node)] = 1;
    state.node_target[as_index(node)] = state.x[as_index(node)];
}

void clamp_end(RodState& state, int end) noexcept {
    state.end_held[as_index(end)] = 1;
    state.end_frame[as_index(end)] = end == 0 ? state.q.front() : state.q.back();
}

uint64_t state_hash(const RodState& state) noexcept {
    Hash hash;
    fields(state, hash);
    return hash.value();
}

double rod_energy(const Rod& rod, const RodState& state) noexcept {
    const RodStiffness& k = rod.spec().stiffness;
    double energy = 0;
    for (int j = 0; j < rod.segments(); ++j) {
        const auto s = segment_at(rod, state, j);
        energy += 0.5 * rod.length_m()[as_index(j)] * dot(s.force, s.gamma);
    }
    BendStrain<double> bend;
    for (int j = 0; j <= rod.segments(); ++j) {
        if (!bend_at(rod, state, j, bend)) continue;
        const Vec3 e = to_vec(bend.omega) - rod.rest_omega()[as_index(j)];
        energy += 0.5 / rod.bend_length_m()[as_index(j)] *
                  (k.bend_n_m2 * (e.x() * e.x() + e.y() * e.y()) + k.twist_n_m2 * e.z() * e.z());
    }
    return energy;
}

void rod_gradient(const Rod& rod, const RodState& state, std::vector<Vec3>& force,
                  std::vector<Vec3>& torque) noexcept {
    assert(std::ssize(force) == rod.segments() + 1 && std::ssize(torque) == rod.segments());
    for (Vec3& f : force) f.setZero();
    for (Vec3& t : torque) t.setZero();
    for (int j = 0; j < rod.segments(); ++j) {
        const auto i = as_index(j);
        const auto s = segment_at(rod, state, j);
        force[i] -= to_vec(s.force);
        force[i + 1] += to_vec(s.force);
        torque[i] += rod.length_m()[i] * to_vec(cross(s.force, s.t));
    }
    BendStrain<double> bend;
    for (int j = 0; j <= rod.segments(); ++j) {
        if (!bend_at(rod, state, j, bend)) continue;
        if (j > 0) torque[as_index(j - 1)] -= to_vec(bend.moment);
        if (j < rod.segments()) torque[as_index(j)] += to_vec(bend.moment);
    }
}

Vec3 segment_force(const Rod& rod, const RodState& state, int segment) noexcept {
    return to_vec(segment_at(rod, state, segment).force);
}

Vec3 node_moment(const Rod& rod, const RodState& state, int node) noexcept {
    BendStrain<double> bend;
    if (!bend_at(rod, state, node, bend)) return Vec3::Zero();
    const Vec3 e = to_vec(bend.omega) - rod.rest_omega()[as_index(node)];
    const RodStiffness& k = rod.spec().stiffness;
    return Vec3(k.bend_n_m2 * e.x(), k.bend_n_m2 * e.y(), k.twist_n_m2 * e.z()) /
           rod.bend_length_m()[as_index(node)];
}

RodMotion rod_motion(const Rod& rod, const RodState& state) noexcept {
    RodMotion out;
    for (size_t i = 0; i < state.x.size(); ++i) {
        const Vec3 p = rod.mass_kg()[i] * state.v[i];
        out.kinetic_j += 0.5 * p.dot(state.v[i]);
        out.momentum_kg_m_s += p;
        out.angular_kg_m2_s += state.x[i].cross(p);
    }
    for (size_t j = 0; j < state.q.size(); ++j) {
        const Vec3 d3 = state.q[j] * Vec3::UnitZ();
        const Vec3 spin = rod.inertia_kg_m2()[j] * (state.w[j] + d3 * d3.dot(state.w[j]));
        out.kinetic_j += 0.5 * spin.dot(state.w[j]);
        out.angular_kg_m2_s += spin;
    }
    return out;
}

}  // namespace placode::sim
