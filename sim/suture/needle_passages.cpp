// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The passages of the needle through faces and inside of tets: made behind the point, sliding along
// the needle, handed over to the thread and taken back, given up with their tissue.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/suture/needle_in_tissue.h"
#include "sim/suture/thread_channel.h"

namespace placode::sim {
namespace {

// Passages go over to the thread when the swage is so far ahead that the way to it has a direction,
// and come back a little later.
constexpr double kFollowsM = 0.2e-3, kComesBackM = 0.1e-3;

}  // namespace

void NeedleInTissue::drop_lost() noexcept {
    for (int i = state_.passage_count - 1; i >= 0; --i) {
        if (alive(state_.passages[as_index(i)].at)) continue;
        give_up(i, SutureEventKind::kLost);
    }
    NeedlePoint& point = state_.point;
    if (point.mode != PointMode::kFree && !alive(point.at)) point.mode = PointMode::kFree;
}

void NeedleInTissue::slip_in_walls() noexcept {
    for (int i = 0; i < state_.passage_count; ++i) {
        const NeedleBond bond = passage_bond(suture_, state_, tissue_, i);
        const ArcFoot foot = suture_.needle().foot(needle_.to_N(place_of(tissue_.state, bond)));
        report_.deepest_m = std::max(report_.deepest_m, std::sqrt(foot.radial_m * foot.radial_m +
                                                                  foot.across_m * foot.across_m));
        const double along = foot.s_m - bond.sticks_at_m;
        const double most = bond.along_n / bond.hold_n_m;
        report_.wall_force_n += std::min(bond.hold_n_m * std::abs(along), bond.along_n);
        if (std::abs(along) <= most) continue;
        state_.passages[as_index(i)].sticks_at_m = foot.s_m - std::copysign(most, along);
        state_.work.friction += bond.along_n * (std::abs(along) - most);
    }
}

void NeedleInTissue::leave_passages() noexcept {
    while (state_.passage_count > 0 && coordinate(state_.passage_count - 1) < 0) pop_newest();
    const bool threaded = state_.thread.ends[1].mode == ThreadEndMode::kSwage;
    const double last = suture_.needle().arc_m() + (threaded ? kFollowsM : 0);
    while (state_.passage_count > 0 && coordinate(0) > last) {
        if (threaded) take_passage(suture_, state_, tissue_, state_.passages[0], h_s_, report_);
        give_up(0, SutureEventKind::kRanOff);
    }
    if (threaded) take_back(last - kComesBackM);
}

void NeedleInTissue::tell_of(SutureEventKind kind, const TissuePoint& at, int32_t channel,
                             double force_n) noexcept {
    SutureEvent event{kind, tissue_at(at.tet), force_n, rest_place_of(tissue_, at), channel};
    event.tet = at.tet;
    if (kind == SutureEventKind::kEntered || kind == SutureEventKind::kLeft)
        event.sine = sine_to_surface(at);
    tell(report_, event);
}

double NeedleInTissue::sine_to_surface(const TissuePoint& at) const noexcept {
    const auto& c = corners(tissue_.body, tissue_.state, at.tet);
    for (int f = 0; f < 4; ++f) {
        if (at.b[as_index(f)] != 0 || !tissue_.faces.on_surface(at.tet, f)) continue;
        const auto& face = kTetFaces[as_index(f)];
        std::array<Vec3, 3> x;
        for (size_t k = 0; k < 3; ++k)
            x[k] = rest_place(tissue_.body, tissue_.state, c[as_index(face[k])]);
        const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
        return std::abs(normal.dot(forward_)) / normal.norm();
    }
    return 0;
}

void NeedleInTissue::add_passage(PassageKind kind) noexcept {
    NeedlePoint& point = state_.point;
    if (state_.passage_count == kMostPassages) {
        report_.dropped = true;
        return;
    }
    Passage& p = state_.passages[as_index(state_.passage_count++)];
    p.at = point.at;
    p.kind = kind;
    p.channel = state_.channels;
    p.gap_m = kind == PassageKind::kEntry ? 0 : point.since_passage_m;
    p.hold_n_m = hold_at(point.at);
    p.sticks_at_m = coordinate(state_.passage_count - 1);
    point.since_passage_m = 0;
    state_.work.made += passage_energy(state_.passage_count - 1);
}

void NeedleInTissue::pop_newest() noexcept {
    const int i = state_.passage_count - 1;
    const Passage gone = state_.passages[as_index(i)];
    state_.work.made -= passage_energy(i);
    state_.passages[as_index(i)] = {};
    --state_.passage_count;
    NeedlePoint& point = state_.point;
    if (gone.kind == PassageKind::kEntry) {
        if (point.mode != PointMode::kFree) state_.work.made -= energy();
        tell_of(SutureEventKind::kWithdrawn, gone.at, gone.channel, 0);
        point.mode = PointMode::kFree;
        return;
    }
    if (gone.kind == PassageKind::kExit) {
        // Back in the tissue.
        point.mode = PointMode::kAtFarSide;
        point.at = gone.at;
        point.tissue = tissue_at(gone.at.tet);
        point.hold_n_m = gone.hold_n_m;
        state_.work.made += energy();
    }
    point.since_passage_m = std::max(0.0, gone.gap_m + std::min(0.0, pushed()));
}

void NeedleInTissue::take_back(double last_m) noexcept {
    for (const Passage* p = nullptr; (p = newest_open(state_.thread)) != nullptr;) {
        const ArcFoot foot = suture_.needle().foot(needle_.to_N(place_of(tissue_, p->at)));
        if (foot.s_m > last_m || state_.passage_count == kMostPassages) return;
        auto* const all = state_.passages.data();
        std::copy_backward(all, all + state_.passage_count, all + state_.passage_count + 1);
        all[0] = *p;
        all[0].sticks_at_m = foot.s_m;
        ++state_.passage_count;
        state_.work.made += passage_energy(0);
        drop_passage(suture_, state_, tissue_, state_.thread.passage_count - 1);
    }
}

void NeedleInTissue::give_up(int i, SutureEventKind kind) noexcept {
    const Passage gone = state_.passages[as_index(i)];
    if (alive(gone.at)) state_.work.made -= passage_energy(i);
    if (kind == SutureEventKind::kLost || gone.kind == PassageKind::kExit)
        tell_of(kind, gone.at, gone.channel, 0);
    auto* const first = state_.passages.data() + i;
    std::copy(first + 1, state_.passages.data() + state_.passage_count, first);
    state_.passages[as_index(--state_.passage_count)] = {};
}

}  // namespace placode::sim
