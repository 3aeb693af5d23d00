// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One look at the needle in the tissue: what its point does (puncture.cpp) and the passages that it
// leaves behind (needle_passages.cpp). Made anew for each call; owns nothing.

#include <algorithm>

#include "sim/core/as_index.h"
#include "sim/suture/needle_motion.h"
#include "sim/suture/rest_walk.h"

namespace placode::sim {

class NeedleInTissue {
 public:
    NeedleInTissue(const Suture& suture, SutureState& state, const SuturedTissue& tissue,
                   double h_s, SutureReport& report) noexcept
        : suture_(suture),
          state_(state),
          tissue_(tissue),
          h_s_(h_s),
          report_(report),
          needle_(suture.needle(), state.needle),
          forward_(needle_.r * Needle::forward()) {}

    // puncture.cpp
    void meet() noexcept;
    void move_point() noexcept;

    // needle_passages.cpp
    void drop_lost() noexcept;
    void slip_in_walls() noexcept;
    /// What lies ahead of the point, or behind the swage.
    void leave_passages() noexcept;

 private:
    // Stiffness of a bond against what the tissue answers there at once. Contact has 6; a little
    // less, because several passages share their vertices. Other values were not tried.
    static constexpr double kBondRatio = 4;
    static constexpr double kStiffestN_m = 3000;

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
    void lift_off() noexcept { state_.point.mode = PointMode::kFree; }

    // puncture.cpp
    [[nodiscard]] SurfaceHit hit_ahead() const noexcept;
    /// Where the point is pulled sideways by more than it bites, it takes hold where it is now.
    void slide() noexcept;
    void enter(double cutting_n) noexcept;
    /// Moves the point through the tissue until no more than the cutting force is left.
    /// @param before_j energy of the point's bond until now.
    void cut(double cutting_n, double before_j) noexcept;
    /// How far the point has gone in this substep [m].
    [[nodiscard]] double advance_m() const noexcept;
    void go(double path_m) noexcept;
    void leave() noexcept;
    /// The channel closes ahead of the point, which takes hold where it is now.
    void draw_back() noexcept;

    // needle_passages.cpp
    void tell_of(SutureEventKind kind, const TissuePoint& at, int32_t channel,
                 double force_n) noexcept;
    /// Of the angle between the point's way and the face that it goes through. At rest: where the
    /// point presses, it turns the face towards itself.
    [[nodiscard]] double sine_to_surface(const TissuePoint& at) const noexcept;
    void add_passage(PassageKind kind) noexcept;
    /// The point has been drawn back past it.
    void pop_newest() noexcept;
    /// The swage has come back to passages that the thread had taken over.
    void take_back(double last_m) noexcept;
    void give_up(int i, SutureEventKind kind) noexcept;

    const Suture& suture_;
    SutureState& state_;
    const SuturedTissue& tissue_;
    double h_s_;
    SutureReport& report_;
    PosedNeedle needle_;
    Vec3 forward_;
};

}  // namespace placode::sim
