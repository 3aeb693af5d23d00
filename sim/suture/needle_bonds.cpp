// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/needle_bonds.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/core/event.h"
#include "sim/suture/thread_vertices.h"

namespace placode::sim {
namespace {

constexpr int kMostBonds = kMostPassages + 1;

/// A spring k x whose force ends at `bound` (below 0: never), as force and stiffness along x; and
/// the energy whose slope that force is.
/// @param slope the stiffness is that of the law, none beyond the bound; else that of the secant.
struct BoundedSpring {
    BoundedSpring(double k, double x, double bound, bool slope) noexcept
        : n(k * x), n_m(k), j(0.5 * k * x * x) {
        if (bound < 0 || std::abs(n) <= bound) return;
        n_m = bound / std::abs(x);
        n = n_m * x;
        if (slope) n_m = 0;
        j = bound * (std::abs(x) - 0.5 * bound / k);
    }
    double n, n_m, j;
};

BondForce passage_force(const PosedNeedle& needle, const NeedleBond& bond, const Vec3& p_W,
                        bool slope) noexcept {
    const ArcFoot f = needle.shape.foot_near(needle.to_N(p_W), bond.near, bond.near_m);
    const double k = bond.hold_n_m;
    const BoundedSpring along(k, f.s_m - bond.sticks_at_m, bond.along_n, slope);
    // ds = R / ring of the way along the circle.
    const double lever = f.ring_m > 0 ? needle.shape.radius_m() / f.ring_m : 1;
    const Vec3 z = Vec3::UnitZ();
    const Vec3 g = k * f.radial_m * f.radial + k * f.across_m * z + along.n * lever * f.back;
    const Mat3 h = k * (f.radial * f.radial.transpose() + z * z.transpose()) +
                   along.n_m * lever * lever * f.back * f.back.transpose();
    return {needle.r * g, needle.r * h * needle.r.transpose()};
}

BondForce point_force(const PosedNeedle& needle, const NeedleBond& bond, const Vec3& p_W,
                      bool slope) noexcept {
    const Vec3 p = needle.to_N(p_W) - needle.shape.tip_m();
    const double u = p.y(), k = bond.hold_n_m;
    const BoundedSpring along(k, std::max(u, 0.0), bond.along_n, slope);
    const double across_m = std::sqrt(p.x() * p.x() + p.z() * p.z());
    const double bound = bond.across_ratio < 0 ? -1 : bond.across_ratio * along.n;
    const BoundedSpring across(k, across_m, bound, false);
    const Vec3 g(across.n_m * p.x(), along.n, across.n_m * p.z());
    const Vec3 h(across.n_m, u > 0 ? along.n_m : 0, across.n_m);
    return {needle.r * g, needle.r * h.asDiagonal() * needle.r.transpose()};
}

void take_corners(NeedleBond& bond, const SuturedTissue& tissue, const TissuePoint& at) noexcept {
    bond.vertex = corners(tissue.body, tissue.state, at.tet);
    bond.b = at.b;
}

/// Half of the channel to either neighbour; of the last one, all that was cut since.
double wall_length_m(const SutureState& state, int i) noexcept {
    const Passage& me = state.passages[as_index(i)];
    double length = 0.5 * me.gap_m;
    if (i + 1 < state.passage_count) {
        const Passage& next = state.passages[as_index(i + 1)];
        if (next.channel == me.channel) length += 0.5 * next.gap_m;
    } else if (state.point.mode == PointMode::kInside ||
               state.point.mode == PointMode::kAtFarSide) {
        length += state.point.since_passage_m;
    }
    return length;
}

void add_corners(SutureScratch& scratch, SoftBodyState& state,
                 const std::array<int32_t, 4>& vertices) noexcept {
    for (const int32_t v : vertices) {
        int32_t& slot = scratch.slot[as_index(v)];
        if (slot < 0) {
            slot = scratch.colour_count++;
            scratch.colour[as_index(slot)] = {v, 0, 0};
            state.contact_vertex[as_index(v)] = 1;
        }
        ++scratch.colour[as_index(slot)].count;
    }
}

void add_bond(SutureScratch& scratch, SoftBodyState& state, const NeedleBond& bond) noexcept {
    scratch.bonds[as_index(scratch.bond_count++)] = bond;
    add_corners(scratch, state, bond.vertex);
}

void add_entry(SutureScratch& scratch, int32_t vertex, int32_t entry) noexcept {
    SutureScratch::Colour& c = scratch.colour[as_index(scratch.slot[as_index(vertex)])];
    scratch.incidence[as_index(c.first + c.count++)] = entry;
}

std::span<const int32_t> entries_of(const SutureScratch& scratch,
                                    const SutureScratch::Colour& c) noexcept {
    return {&scratch.incidence[as_index(c.first)], as_index(c.count)};
}

/// The needle's bonds at a vertex. Returns the entries that are the thread's.
std::span<const int32_t> add_bonds(const PosedNeedle& needle, const SuturedTissue& tissue,
                                   const SutureScratch& scratch, std::span<const int32_t> entries,
                                   VertexSystem& system) noexcept {
    size_t bonds = 0;
    for (; bonds < entries.size() && entries[bonds] >= 0; ++bonds) {
        const NeedleBond& bond = scratch.bonds[as_index(entries[bonds] / 4)];
        const double b = bond.b[as_index(entries[bonds] % 4)];
        if (b == 0) continue;
        const BondForce f = force_of(needle, bond, place_of(tissue.state, bond), false);
        system.gradient += b * f.gradient;
        system.hessian += b * b * f.stiffness;
    }
    return entries.subspan(bonds);
}

}  // namespace

SutureScratch::SutureScratch(const SoftBody& body, const Suture& suture)
    : bonds(kMostBonds),
      slot(as_index(body.vertex_capacity()), -1),
      places(kMostBonds, Vec3::Zero()),
      thread(suture.spec().thread) {
    const bool threaded = suture.spec().thread.length_m > 0;
    const auto corners_at_most = 4 * as_index(kMostBonds + (threaded ? kMostPassages : 0));
    colour.resize(corners_at_most);
    incidence.resize(corners_at_most);
}

double pushed_m(const PosedNeedle& needle, const Vec3& p_W) noexcept {
    return needle.to_N(p_W).y();
}

BondForce force_of(const PosedNeedle& needle, const NeedleBond& bond, const Vec3& p_W,
                   bool slope) noexcept {
    return bond.passage < 0 ? point_force(needle, bond, p_W, slope)
                            : passage_force(needle, bond, p_W, slope);
}

double energy_of(const PosedNeedle& needle, const NeedleBond& bond, const Vec3& p_W) noexcept {
    const Vec3 p_N = needle.to_N(p_W);
    const double k = bond.hold_n_m;
    if (bond.passage < 0) {
        const Vec3 p = p_N - needle.shape.tip_m();
        const BoundedSpring along(k, std::max(p.y(), 0.0), bond.along_n, true);
        const double bound = bond.across_ratio < 0 ? -1 : bond.across_ratio * along.n;
        return along.j + BoundedSpring(k, std::sqrt(p.x() * p.x() + p.z() * p.z()), bound, true).j;
    }
    const ArcFoot f = needle.shape.foot(p_N);
    return BoundedSpring(k, f.s_m - bond.sticks_at_m, bond.along_n, true).j +
           0.5 * k * (f.radial_m * f.radial_m + f.across_m * f.across_m);
}

Vec3 place_of(const SoftBodyState& state, const NeedleBond& bond) noexcept {
    Vec3 p = Vec3::Zero();
    for (size_t k = 0; k < 4; ++k) p += bond.b[k] * position(state, bond.vertex[k]);
    return p;
}

NeedleBond passage_bond(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                        int i) noexcept {
    const Passage& passage = state.passages[as_index(i)];
    NeedleBond bond;
    bond.passage = i;
    take_corners(bond, tissue, passage.at);
    bond.hold_n_m = passage.hold_n_m;
    bond.sticks_at_m = passage.sticks_at_m;
    const Tissue kind = tissue.body.mesh().tissue[as_index(passage.at.tet)];
    bond.along_n = suture.strength(kind).wall_friction_n_m * wall_length_m(state, i);
    return bond;
}

NeedleBond point_bond(const Suture& suture, const SutureState& state,
                      const SuturedTissue& tissue) noexcept {
    const NeedlePoint& point = state.point;
    NeedleBond bond;
    take_corners(bond, tissue, point.at);
    bond.hold_n_m = point.hold_n_m;
    bond.along_n = -1;
    const SutureStrength& strength = suture.strength(point.tissue);
    if (point.mode == PointMode::kInside)
        bond.along_n = strength.cutting_share * strength.puncture_n;
    if (point.mode == PointMode::kPresses) bond.across_ratio = suture.spec().point_friction;
    return bond;
}

void collect_bonds(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                   SutureScratch& scratch) noexcept {
    scratch.bond_count = scratch.colour_count = 0;
    const PosedNeedle needle(suture.needle(), state.needle);
    for (int i = 0; i < state.passage_count; ++i) {
        NeedleBond bond = passage_bond(suture, state, tissue, i);
        const ArcFoot foot = needle.shape.foot(needle.to_N(place_of(tissue.state, bond)));
        bond.near = foot.radial;
        bond.near_m = foot.s_m;
        add_bond(scratch, tissue.state, bond);
    }
    if (state.point.mode != PointMode::kFree)
        add_bond(scratch, tissue.state, point_bond(suture, state, tissue));
    const ThreadState& thread = state.thread;
    for (int i = 0; i < thread.passage_count; ++i)
        add_corners(scratch, tissue.state,
                    corners(tissue.body, tissue.state, thread.passages[as_index(i)].at.tet));
    int sum = 0;
    for (int i = 0; i < scratch.colour_count; ++i) {
        SutureScratch::Colour& c = scratch.colour[as_index(i)];
        c.first = sum;
        sum += c.count;
        c.count = 0;
        // As in contact: without momentum of its own.
        Float4& x = tissue.state.x[as_index(c.vertex)];
        const Float4& before = tissue.state.x_start[as_index(c.vertex)];
        x = {before.x, before.y, before.z, x.w};
    }
    for (int n = 0; n < scratch.bond_count; ++n) {
        for (int k = 0; k < 4; ++k)
            add_entry(scratch, scratch.bonds[as_index(n)].vertex[as_index(k)], 4 * n + k);
    }
    for (int i = 0; i < thread.passage_count; ++i) {
        const auto& at = corners(tissue.body, tissue.state, thread.passages[as_index(i)].at.tet);
        for (int k = 0; k < 4; ++k) add_entry(scratch, at[as_index(k)], ~(4 * i + k));
    }
}

void solve_bonded_vertices(const Suture& suture, const SutureState& state,
                           const SuturedTissue& tissue, SutureScratch& scratch, double h_s,
                           bool backward) noexcept {
    const PosedNeedle needle(suture.needle(), state.needle);
    scratch.thread.refresh(tissue, state.thread);
    for (int turn = 0; turn < scratch.colour_count; ++turn) {
        const int i = backward ? scratch.colour_count - 1 - turn : turn;
        const SutureScratch::Colour& c = scratch.colour[as_index(i)];
        Float4& x = tissue.state.x[as_index(c.vertex)];
        if (x.w == 0) continue;
        VertexSystem system = vertex_system(tissue.body, tissue.state, c.vertex, h_s);
        const std::span<const int32_t> entries = entries_of(scratch, c);
        const auto threaded = add_bonds(needle, tissue, scratch, entries, system);
        const bool pulled = scratch.thread.active() && !threaded.empty();
        if (pulled) add_thread(scratch.thread, state.thread, threaded, system);
        if (tissue.others.add != nullptr) tissue.others.add(tissue.others.of, c.vertex, system);
        const int origin = origin_of(tissue.state, c.vertex);
        const VertexStep taken = vertex_step(
            system, 1, static_cast<double>(tissue.body.shortest_edge_m()[as_index(origin)]));
        if (!taken.finite) tissue.state.flags |= kNotFinite;
        if (taken.limited) tissue.state.flags |= kStepLimited;
        const Vec3 before = position(tissue.state, c.vertex);
        x.x += static_cast<float>(taken.step.x());
        x.y += static_cast<float>(taken.step.y());
        x.z += static_cast<float>(taken.step.z());
        if (pulled)
            move_thread(scratch.thread, state.thread, threaded,
                        position(tissue.state, c.vertex) - before);
    }
    scratch.thread.slide();
}

Vec3 pull_on_vertex(const Suture& suture, const SutureState& state, const SuturedTissue& tissue,
                    const SutureScratch& scratch, int32_t vertex) noexcept {
    const int32_t slot = scratch.slot[as_index(vertex)];
    if (slot < 0) return Vec3::Zero();
    const PosedNeedle needle(suture.needle(), state.needle);
    VertexSystem system;
    const auto entries = entries_of(scratch, scratch.colour[as_index(slot)]);
    const auto threaded = add_bonds(needle, tissue, scratch, entries, system);
    if (scratch.thread.active() && !threaded.empty())
        add_thread(scratch.thread, state.thread, threaded, system);
    return -system.gradient;
}

void SutureScratch::forget() noexcept {
    std::fill(slot.begin(), slot.end(), -1);
    bond_count = colour_count = support_count = 0;
}

void release_bonds(const SuturedTissue& tissue, SutureScratch& scratch) noexcept {
    for (int i = 0; i < scratch.colour_count; ++i) {
        const int32_t v = scratch.colour[as_index(i)].vertex;
        scratch.slot[as_index(v)] = -1;
        tissue.state.contact_vertex[as_index(v)] = 0;
    }
    scratch.bond_count = scratch.colour_count = 0;
}

}  // namespace placode::sim
