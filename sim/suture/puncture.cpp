// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/puncture.h"

#include <algorithm>
#include <cmath>

#include "sim/core/as_index.h"
#include "sim/suture/rest_walk.h"
#include "sim/suture/thread_channel.h"

namespace placode::sim {
namespace {

constexpr double kSpacingM = 0.3e-3;     // of passages inside one tet
constexpr double kNearestM = 0.1e-3;     // a face so close to the last passage gets none
constexpr double kDrawnBackM = 0.05e-3;  // the point lets the channel close behind it
constexpr double kLookBackM = 0.5e-3;    // a hand at 0.5 m/s goes a quarter of it in a substep
// Passages go over to the thread when the swage is so far ahead that the way to it has a direction,
// and come back a little later.
constexpr double kFollowsM = 0.2e-3, kComesBackM = 0.1e-3;
constexpr int kMostFaces = 64;  // crossed in one substep
// Stiffness of a bond against what the tissue answers there at once. Contact has 6; a little less,
// because several passages share their vertices. Other values were not tried.
constexpr double kBondRatio = 4;
constexpr double kStiffestN_m = 3000;

class Puncture {
 public:
    Puncture(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
             SutureReport& report) noexcept
        : suture_(suture),
          state_(state),
          tissue_(tissue),
          h_s_(h_s),
          report_(report),
          needle_(suture.needle(), state.needle),
          forward_(needle_.r * Needle::forward()) {}

    void meet() noexcept {
        NeedlePoint& point = state_.point;
        const SurfaceHit hit = hit_ahead();
        if (hit.at.tet < 0) return;
        point.mode = PointMode::kPresses;
        point.at = hit.at;
        point.tissue = hit.tissue;
        point.hold_n_m = hold_at(point.at);
        state_.work.made += energy();
    }

    void drop_lost() noexcept {
        for (int i = state_.passage_count - 1; i >= 0; --i) {
            if (alive(state_.passages[as_index(i)].at)) continue;
            give_up(i, SutureEventKind::kLost);
        }
        NeedlePoint& point = state_.point;
        if (point.mode != PointMode::kFree && !alive(point.at)) point.mode = PointMode::kFree;
    }

    void slip_in_walls() noexcept {
        for (int i = 0; i < state_.passage_count; ++i) {
            const NeedleBond bond = passage_bond(suture_, state_, tissue_, i);
            const ArcFoot foot = suture_.needle().foot(needle_.to_N(place_of(tissue_.state, bond)));
            report_.deepest_m =
                std::max(report_.deepest_m,
                         std::sqrt(foot.radial_m * foot.radial_m + foot.across_m * foot.across_m));
            const double along = foot.s_m - bond.grips_at_m;
            const double most = bond.along_n / bond.hold_n_m;
            report_.wall_force_n += std::min(bond.hold_n_m * std::abs(along), bond.along_n);
            if (std::abs(along) <= most) continue;
            state_.passages[as_index(i)].grips_at_m = foot.s_m - std::copysign(most, along);
            state_.work.friction += bond.along_n * (std::abs(along) - most);
        }
    }

    void move_point() noexcept {
        NeedlePoint& point = state_.point;
        if (point.mode == PointMode::kFree) return;
        const double u = pushed(), force = point.hold_n_m * u;
        const SutureStrength& strength = suture_.strength(point.tissue);
        const double cutting = strength.cutting_share * strength.puncture_n;
        report_.point_force_n =
            std::max(0.0, point.mode == PointMode::kInside ? std::min(force, cutting) : force);
        switch (point.mode) {
            case PointMode::kPresses:
                if (u <= 0)
                    lift_off();
                else if (force >= strength.puncture_n)
                    enter(cutting);
                else
                    slide();
                break;
            case PointMode::kInside:
                if (force > cutting)
                    cut(cutting, energy());
                else if (u < -kDrawnBackM)
                    draw_back();
                break;
            case PointMode::kAtFarSide:
                if (force >= strength.puncture_n) {
                    leave();
                } else if (u < -kDrawnBackM) {
                    point.mode = PointMode::kInside;
                    draw_back();
                }
                break;
            case PointMode::kFree:
                break;
        }
    }

    /// What lies ahead of the point, or behind the swage.
    void leave_passages() noexcept {
        while (state_.passage_count > 0 && coordinate(state_.passage_count - 1) < 0) pop_newest();
        const bool threaded = state_.thread.ends[1].mode == ThreadEndMode::kSwage;
        const double last = suture_.needle().arc_m() + (threaded ? kFollowsM : 0);
        while (state_.passage_count > 0 && coordinate(0) > last) {
            if (threaded) take_passage(suture_, state_, tissue_, state_.passages[0], h_s_, report_);
            give_up(0, SutureEventKind::kRanOff);
        }
        if (threaded) take_back(last - kComesBackM);
    }

 private:
    [[nodiscard]] double energy() const noexcept {
        const NeedleBond bond = point_bond(suture_, state_, tissue_);
        return energy_of(needle_, bond, place_of(tissue_.state, bond));
    }
    [[nodiscard]] double passage_energy(int i) const noexcept {
        const NeedleBond bond = passage_bond(suture_, state_, tissue_, i);
        return energy_of(needle_, bond, place_of(tissue_.state, bond));
    }
    [[nodiscard]] double pushed() const noexcept {
        return pushed_m(needle_, place_of(tissue_, state_.point.at));
    }
    [[nodiscard]] double coordinate(int i) const noexcept {
        const Vec3 p = place_of(tissue_, state_.passages[as_index(i)].at);
        return suture_.needle().foot(needle_.to_N(p)).s_m;
    }
    [[nodiscard]] bool alive(const TissuePoint& at) const noexcept {
        return tissue_.state.tet_alive[as_index(at.tet)] != 0;
    }
    [[nodiscard]] Tissue tissue_at(int32_t tet) const noexcept {
        return tissue_.body.mesh().tissue[as_index(tet)];
    }
    [[nodiscard]] double hold_at(const TissuePoint& at) const noexcept {
        const double answer = answer_of(tissue_, at, h_s_);
        return answer > 0 ? std::min(kBondRatio * answer, kStiffestN_m) : kStiffestN_m;
    }
    [[nodiscard]] SurfaceHit hit_ahead() const noexcept {
        const Vec3 tip = needle_.to_W(suture_.needle().tip_m());
        return meet_surface(tissue_, tip - kLookBackM * forward_, kLookBackM * forward_);
    }
    void tell_of(SutureEventKind kind, const TissuePoint& at, int32_t channel,
                 double force_n) noexcept {
        SutureEvent event{kind, tissue_at(at.tet), force_n, rest_place_of(tissue_, at), channel};
        event.tet = at.tet;
        if (kind == SutureEventKind::kEntered || kind == SutureEventKind::kLeft)
            event.sine = sine_to_surface(at);
        tell(report_, event);
    }
    /// Of the angle between the point's way and the face that it goes through. At rest: where the
    /// point presses, it turns the face towards itself.
    [[nodiscard]] double sine_to_surface(const TissuePoint& at) const noexcept {
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

    void lift_off() noexcept { state_.point.mode = PointMode::kFree; }

    /// Where the point is pulled sideways by more than it bites, it takes hold where it is now.
    void slide() noexcept {
        NeedlePoint& point = state_.point;
        const Vec3 off = needle_.to_N(place_of(tissue_, point.at)) - suture_.needle().tip_m();
        const double beside = std::sqrt(off.x() * off.x() + off.z() * off.z());
        if (beside <= suture_.spec().point_friction * off.y()) return;
        const double before = energy();
        const SurfaceHit hit = hit_ahead();
        if (hit.at.tet < 0) {
            lift_off();
            state_.work.friction += before;
            return;
        }
        point.at = hit.at;
        point.tissue = hit.tissue;
        point.hold_n_m = hold_at(point.at);
        state_.work.friction += before - energy();
    }

    void enter(double cutting_n) noexcept {
        NeedlePoint& point = state_.point;
        const double before = energy();
        ++state_.channels;
        add_passage(PassageKind::kEntry);
        tell_of(SutureEventKind::kEntered, point.at, state_.channels, report_.point_force_n);
        point.mode = PointMode::kInside;
        point.since_passage_m = 0;
        cut(cutting_n, before);
    }

    /// Moves the point through the tissue until no more than the cutting force is left.
    /// @param before_j energy of the point's bond until now.
    void cut(double cutting_n, double before_j) noexcept {
        NeedlePoint& point = state_.point;
        // Twice: where it comes to, the tissue may answer otherwise.
        for (int turn = 0; turn < 2 && point.mode == PointMode::kInside; ++turn) {
            const double way = pushed() - cutting_n / point.hold_n_m;
            if (way > 0) go(way);
            point.hold_n_m = hold_at(point.at);
        }
        state_.work.puncture += before_j - energy();
    }

    /// How far the point has gone in this substep [m].
    [[nodiscard]] double advance_m() const noexcept {
        const Vec3 lever =
            needle_.to_W(suture_.needle().tip_m()) - needle_.to_W(suture_.needle().centre_m());
        return h_s_ * std::max(0.0, forward_.dot(state_.v + state_.w.cross(lever)));
    }

    void go(double way_m) noexcept {
        NeedlePoint& point = state_.point;
        for (int faces = 0; faces < kMostFaces && way_m > 0;) {
            const bool full = state_.passage_count == kMostPassages;
            const double due = full ? way_m : std::max(0.0, kSpacingM - point.since_passage_m);
            double step = std::min(way_m, due);
            TissueWalk walk = walk_to_face(tissue_, point.at, step * forward_);
            if (walk.end == WalkEnd::kLost) {
                // Soft tissue that is drawn along goes flat. A point that stood still in it would
                // drag it until it tears; so it goes on with the needle, by the shape at rest.
                way_m = step = std::min(step, advance_m());
                walk = walk_at_rest(tissue_, point.at, step * forward_);
            }
            point.at = walk.at;
            point.since_passage_m += walk.share * step;
            way_m -= walk.share * step;
            if (walk.end == WalkEnd::kArrived) {
                if (step >= due) add_passage(PassageKind::kInner);
                continue;
            }
            if (walk.end == WalkEnd::kAtSurface) {
                point.mode = PointMode::kAtFarSide;
                return;
            }
            ++faces;
            const TissuePoint next = across_face(tissue_, point.at, walk.face);
            const Tissue beyond = tissue_at(next.tet);
            if (point.since_passage_m >= kNearestM || beyond != point.tissue)
                add_passage(PassageKind::kInner);
            point.at = next;
            point.tissue = beyond;
        }
    }

    void leave() noexcept {
        NeedlePoint& point = state_.point;
        const double before = energy();
        add_passage(PassageKind::kExit);
        tell_of(SutureEventKind::kLeft, point.at, state_.channels, report_.point_force_n);
        point.mode = PointMode::kFree;
        state_.work.puncture += before;
    }

    /// The channel closes ahead of the point, which takes hold where it is now.
    void draw_back() noexcept {
        NeedlePoint& point = state_.point;
        const double before = energy();
        double way = -pushed();
        for (int faces = 0; faces < kMostFaces && way > 0; ++faces) {
            const TissueWalk walk = walk_to_face(tissue_, point.at, -way * forward_);
            if (walk.end == WalkEnd::kLost) break;
            point.at = walk.at;
            point.since_passage_m = std::max(0.0, point.since_passage_m - walk.share * way);
            way -= walk.share * way;
            if (walk.end == WalkEnd::kAtSurface) {  // out of the tissue
                point.mode = PointMode::kFree;
                state_.work.puncture += before;
                return;
            }
            if (walk.end != WalkEnd::kAtFace) break;
            point.at = across_face(tissue_, point.at, walk.face);
            point.tissue = tissue_at(point.at.tet);
        }
        point.hold_n_m = hold_at(point.at);
        state_.work.puncture += before - energy();
    }

    void add_passage(PassageKind kind) noexcept {
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
        p.grips_at_m = coordinate(state_.passage_count - 1);
        point.since_passage_m = 0;
        state_.work.made += passage_energy(state_.passage_count - 1);
    }

    /// The point has been drawn back past it.
    void pop_newest() noexcept {
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

    /// The swage has come back to passages that the thread had taken over.
    void take_back(double last_m) noexcept {
        for (const Passage* p = nullptr; (p = newest_open(state_.thread)) != nullptr;) {
            const ArcFoot foot = suture_.needle().foot(needle_.to_N(place_of(tissue_, p->at)));
            if (foot.s_m > last_m || state_.passage_count == kMostPassages) return;
            auto* const all = state_.passages.data();
            std::copy_backward(all, all + state_.passage_count, all + state_.passage_count + 1);
            all[0] = *p;
            all[0].grips_at_m = foot.s_m;
            ++state_.passage_count;
            state_.work.made += passage_energy(0);
            drop_passage(suture_, state_, tissue_, state_.thread.passage_count - 1);
        }
    }

    void give_up(int i, SutureEventKind kind) noexcept {
        const Passage gone = state_.passages[as_index(i)];
        if (alive(gone.at)) state_.work.made -= passage_energy(i);
        if (kind == SutureEventKind::kLost || gone.kind == PassageKind::kExit)
            tell_of(kind, gone.at, gone.channel, 0);
        auto* const first = state_.passages.data() + i;
        std::copy(first + 1, state_.passages.data() + state_.passage_count, first);
        state_.passages[as_index(--state_.passage_count)] = {};
    }

    const Suture& suture_;
    SutureState& state_;
    const SuturedTissue& tissue_;
    double h_s_;
    SutureReport& report_;
    PosedNeedle needle_;
    Vec3 forward_;
};

}  // namespace

void begin_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                 SutureReport& report) noexcept {
    Puncture puncture(suture, state, tissue, h_s, report);
    puncture.drop_lost();
    if (state.point.mode == PointMode::kFree) puncture.meet();
}

void finish_point(const Suture& suture, SutureState& state, const SuturedTissue& tissue, double h_s,
                  SutureReport& report) noexcept {
    Puncture puncture(suture, state, tissue, h_s, report);
    puncture.slip_in_walls();
    puncture.move_point();
    puncture.leave_passages();
}

}  // namespace placode::sim
