// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A needle, the jaws that hold it, the channels that it makes and the thread that follows: what
// never changes (Suture), what changes (SutureState), and what a substep tells (SutureReport). How
// it works: docs/suture.md.

#include <array>
#include <vector>

#include "sim/core/fields.h"
#include "sim/suture/needle.h"
#include "sim/suture/thread.h"

namespace placode::sim {

inline constexpr int kMostSutureEvents = 32;

/// How a needle is held. Planning values.
struct JawSpec {
    double force_n = 10;         ///< Of one jaw on the other: above 0, at most 100.
    double friction = 0.3;       ///< Of jaws on wire: 0 to 2.
    double width_m = 2e-3;       ///< Of the jaws, the lever of what resists turning: to 10e-3.
    double pull_n_m = 600;       ///< Stiffness of the hand's hold: 10 to 10,000.
    double turn_n_m_rad = 0.06;  ///< The same against turning: 1e-3 to 10.
};

/// What a tissue puts up against needle and thread. Planning values that a fetal surgeon has to
/// confirm; sources in docs/suture.md.
struct SutureStrength {
    double puncture_n = 0.20;       ///< On the point, at which the surface opens: 1e-3 to 10.
    double cutting_share = 0.61;    ///< Of it, that goes on cutting inside: 0 to 1.
    double wall_friction_n_m = 40;  ///< Of needle in channel, by length (0.04 N/mm): 0 to 1000.
    /// Thread that presses sideways by more, per length, cuts through: 1 to 1e6. 0.5 N on a skin of
    /// 0.8 mm.
    double tear_n_m = 600;
};

struct SutureSpec {
    NeedleSpec needle;
    JawSpec jaws;
    ThreadSpec thread;
    std::array<SutureStrength, kTissueCount> strength{};
    /// Of the point on a surface that it has not opened yet, Coulomb: a point bites. 0 to 5.
    double point_friction = 1.0;
    Vec3 gravity_m_s2 = Vec3(0, 0, -9.81);  ///< On the needle.
    double drag_per_s = 20;  ///< Velocity that a free needle loses to the fluid: 0 to 1000.
    double floor_m = -10;    ///< No free needle sinks below this height [m].
};

/// Constant part.
class Suture {
 public:
    /// @throws SutureError
    explicit Suture(const SutureSpec& spec);
    [[nodiscard]] const SutureSpec& spec() const noexcept { return spec_; }
    [[nodiscard]] const Needle& needle() const noexcept { return needle_; }
    [[nodiscard]] const SutureStrength& strength(Tissue tissue) const noexcept {
        return spec_.strength[static_cast<size_t>(tissue)];
    }

 private:
    SutureSpec spec_;
    Needle needle_;
};

enum class PointMode : uint8_t {
    kFree,       ///< In no contact.
    kPresses,    ///< Against a surface from outside.
    kInside,     ///< In tissue, cutting when it is pushed.
    kAtFarSide,  ///< Against a surface from inside.
};

/// The needle's point: the tissue that it last reached is bonded to it.
struct NeedlePoint {
    PointMode mode = PointMode::kFree;
    TissuePoint at;
    Tissue tissue = Tissue::kSkin;
    double hold_n_m = 0;         ///< Of the bond, along the needle and across.
    double since_passage_m = 0;  ///< Cut since the last passage.
};
template <class Visit>
void fields(Of<NeedlePoint> auto& s, Visit&& visit) {
    auto& [mode, at, tissue, hold_n_m, since_passage_m] = s;
    visit.state(mode, at, tissue, hold_n_m, since_passage_m);
}

/// A hand's hold.
struct NeedleHold {
    uint8_t held = 0;
    Pose hand;                    ///< X_WH at the end of the last substep.
    Pose X_HN;                    ///< Needle in the hand; slips.
    double arc_m = 0;             ///< Where the jaws hold it.
    Vec3 held_N = Vec3::Zero();   ///< The same as a place in N.
    Vec3 back_N = Vec3::UnitY();  ///< And the wire's direction there.
    Vec3 force_n = Vec3::Zero();  ///< Of the hand on the needle, at the grip [N].
    Vec3 torque_n_m = Vec3::Zero();
};
template <class Visit>
void fields(Of<NeedleHold> auto& s, Visit&& visit) {
    auto& [held, hand, X_HN, arc_m, held_N, back_N, force_n, torque_n_m] = s;
    visit.state(held, hand, X_HN, arc_m, held_N, back_N, force_n, torque_n_m);
}

/// Other jaws that hold the needle at the same time: who hands it over and who takes it.
struct SecondHold {
    NeedleHold hold;
    /// Share of the jaws' force, of the first and of these, 0 to 1: jaws that open give way.
    std::array<double, 2> firm{1, 1};
};
template <class Visit>
void fields(Of<SecondHold> auto& s, Visit&& visit) {
    auto& [hold, firm] = s;
    visit.state(hold, firm);
}

/// Where energy went [J]. Stored energy is that of suture_energy(); what dissipates here was
/// stored in a bond before. Motion and the tissue's damping are not in it.
struct SutureWork {
    double hand = 0;      ///< Done by the hands on their holds.
    double puncture = 0;  ///< Dissipated: surfaces opened, and tissue cut.
    double friction = 0;  ///< Dissipated in channels and under the point.
    double jaws = 0;      ///< Dissipated by slip in the jaws.
    double made = 0;      ///< Came in with new bonds, less what left with old ones.
};
template <class Visit>
void fields(Of<SutureWork> auto& s, Visit&& visit) {
    auto& [hand, puncture, friction, jaws, made] = s;
    visit.state(hand, puncture, friction, jaws, made);
}

/// Changing part. Sized by the constructor, never grows.
struct SutureState {
    /// A free needle at X_WN.
    SutureState(const Suture& suture, const Pose& X_WN);

    Pose needle;            ///< X_WN.
    Vec3 v = Vec3::Zero();  ///< Of the centre of mass [m/s].
    Vec3 w = Vec3::Zero();  ///< In W [rad/s].
    NeedleHold hold;
    SecondHold second;
    NeedlePoint point;
    std::vector<Passage> passages;  ///< First `passage_count`.
    int32_t passage_count = 0;
    int32_t channels = 0;  ///< Entries so far.
    SutureWork work;
    ThreadState thread;
};
template <class Visit>
void fields(Of<SutureState> auto& s, Visit&& visit) {
    auto& [needle, v, w, hold, second, point, passages, passage_count, channels, work, thread] = s;
    visit.state(needle, v, w, hold, second, point, passages, passage_count, channels, work, thread);
}

enum class SutureEventKind : uint8_t {
    kEntered,     ///< The point opened a surface: force = on the point [N].
    kLeft,        ///< It came out on the far side: force [N].
    kWithdrawn,   ///< It was drawn back out of its entry.
    kSlipped,     ///< The needle slipped in the jaws: force = pull [N].
    kTurned,      ///< It turned in the jaws: force = torque [N m].
    kLost,        ///< Tissue of a passage is gone (burned, torn): it was given up.
    kRanOff,      ///< The swage has gone through a passage.
    kThreaded,    ///< The swage has left a channel: thread runs through it from end to end.
    kThreadOut,   ///< An end of the thread has left a channel, which is empty.
    kCutThrough,  ///< Thread has cut through the mouth of its channel: force = load [N/m].
    kToreOut,     ///< And through the last of it: the channel is gone.
};
struct SutureEvent {
    SutureEventKind kind = SutureEventKind::kEntered;
    Tissue tissue = Tissue::kSkin;
    double force_n = 0;
    Vec3 rest_place_m = Vec3::Zero();
    int32_t channel = -1;
    int32_t tet = -1;  ///< There.
    /// kEntered, kLeft: of the angle between the point's way and the surface as it is at rest.
    double sine = 0;
    int hold = 0;  ///< kSlipped, kTurned: 0 in the first jaws, 1 in the second ones.
};

/// What a substep tells.
struct SutureReport {
    std::array<SutureEvent, kMostSutureEvents> events{};
    int event_count = 0;
    double point_force_n = 0;  ///< Of the tissue on the point, against the way it is driven [N].
    double wall_force_n = 0;   ///< Sum of friction along the channels, without sign [N].
    double thread_pull_n = 0;  ///< The largest along the thread [N].
    double deepest_m = 0;      ///< Largest distance of a passage from the wire's axis [m].
    bool dropped = false;      ///< A list was full.
    bool not_finite = false;   ///< The needle was put back where it was, at rest.
};

/// Hash over everything that decides the future. A second hold that does not hold is no part of it.
[[nodiscard]] uint64_t state_hash(const SutureState& state) noexcept;

/// The hand at X_WH takes the needle where it is.
/// @param arc_m where the jaws hold it, cut to the arc.
void take_needle(const Suture& suture, SutureState& state, const Pose& X_WH, double arc_m) noexcept;
/// Another hand takes it as well; both hold it from now on.
void take_needle_too(const Suture& suture, SutureState& state, const Pose& X_WH,
                     double arc_m) noexcept;
/// The hand lets go. One that holds it as well goes on as the only one.
void let_go_needle(SutureState& state) noexcept;
/// The second hand lets go.
void let_go_second(SutureState& state) noexcept;

}  // namespace placode::sim
