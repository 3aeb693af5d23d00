// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/suture/suture.h"

#include <algorithm>
#include <type_traits>

#include "sim/core/as_index.h"
#include "sim/core/fnv_hash.h"

namespace placode::sim {
namespace {

void check(const SutureSpec& s) {
    // Zero is no strength: what nothing holds would open at a touch.
    need_within("jaws.force_n", s.jaws.force_n, 1e-3, 100);
    need_within("jaws.friction", s.jaws.friction, 0, 2);
    need_within("jaws.width_m", s.jaws.width_m, 1e-4, 10e-3);
    need_within("jaws.pull_n_m", s.jaws.pull_n_m, 10, 10000);
    need_within("jaws.turn_n_m_rad", s.jaws.turn_n_m_rad, 1e-3, 10);
    for (const SutureStrength& t : s.strength) {
        need_within("strength.puncture_n", t.puncture_n, 1e-3, 10);
        need_within("strength.cutting_share", t.cutting_share, 0, 1);
        need_within("strength.wall_friction_n_m", t.wall_friction_n_m, 0, 1000);
        need_within("strength.tear_n_m", t.tear_n_m, 1, 1e6);
    }
    check(s.thread);
    need_within("point_friction", s.point_friction, 0, 5);
    need_within("gravity_m_s2", s.gravity_m_s2.norm(), 0, 100);
    need_within("drag_per_s", s.drag_per_s, 0, 1000);
    need_within("floor_m", s.floor_m, -10, 10);
}

/// Every field by its list, as bytes.
class Hash {
 public:
    template <class... Values>
    void state(const Values&... values) noexcept {
        (add(values), ...);
    }
    [[nodiscard]] uint64_t value() const noexcept { return hash_.value(); }

 private:
    template <class T>
    void add(const T& value) noexcept {
        if constexpr (kPlainBytes<T>)
            hash_.bytes(&value, sizeof value);
        else
            fields(value, *this);
    }
    void add(const SecondHold& second) noexcept {
        if (second.hold.held != 0) fields(second, *this);
    }
    template <class T, size_t N>
    requires(!kPlainBytes<T>) void add(const std::array<T, N>& values) noexcept {
        for (const T& value : values) add(value);
    }
    template <class T>
    void add(const std::vector<T>& values) noexcept {
        for (const T& value : values) add(value);
    }
    FnvHash hash_;
};

}  // namespace

Suture::Suture(const SutureSpec& spec) : spec_(spec), needle_(spec.needle) { check(spec_); }

SutureState::SutureState(const Suture& suture, const Pose& X_WN)
    : needle(X_WN), thread(suture.spec().thread) {
    needle.q.normalize();
    passages.resize(kMostPassages);
}

uint64_t state_hash(const SutureState& state) noexcept {
    Hash hash;
    fields(state, hash);
    return hash.value();
}

namespace {

void take(const Suture& suture, const SutureState& state, NeedleHold& hold, const Pose& X_WH,
          double arc_m) noexcept {
    hold.held = 1;
    hold.hand = X_WH;
    hold.hand.q.normalize();
    hold.X_HN = hold.hand.inverse() * state.needle;
    hold.arc_m = std::clamp(arc_m, 0.0, suture.needle().arc_m());
    const ArcPoint at = suture.needle().at(hold.arc_m);
    hold.held_N = at.place_m;
    hold.back_N = at.back;
    hold.force_n = hold.torque_n_m = Vec3::Zero();
}

}  // namespace

void take_needle(const Suture& suture, SutureState& state, const Pose& X_WH,
                 double arc_m) noexcept {
    take(suture, state, state.hold, X_WH, arc_m);
}

void take_needle_too(const Suture& suture, SutureState& state, const Pose& X_WH,
                     double arc_m) noexcept {
    state.second = {};
    take(suture, state, state.second.hold, X_WH, arc_m);
}

void let_go_needle(SutureState& state) noexcept {
    if (state.second.hold.held != 0) {
        state.hold = state.second.hold;
        state.second = {};
        return;
    }
    state.hold.held = 0;
    state.hold.force_n = state.hold.torque_n_m = Vec3::Zero();
}

void let_go_second(SutureState& state) noexcept { state.second = {}; }

}  // namespace placode::sim
