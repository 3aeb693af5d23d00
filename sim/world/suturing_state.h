// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Needle and thread of an attempt, and whose jaws hold the needle.
#include <array>
#include <cstdint>
#include <vector>
#include "sim/core/event.h"
#include "sim/core/fields.h"
#include "sim/suture/suture.h"

namespace placode::sim {

struct Scene;
struct State;

/// Slip of the needle in the jaws that goes on.
struct JawSlip {
    float s = 0;        ///< So far.
    float peak = 0;     ///< Pull [N], or torque [N m].
    float pause_s = 0;  ///< Since it last slipped.
};
template <class Visit>
void fields(Of<JawSlip> auto& s, Visit&& visit) {
    auto& [so_far, peak, pause_s] = s;
    visit.state(so_far, peak, pause_s);
}

/// Suturing::locked of a needle that an attempt began with.
inline constexpr uint8_t kLockedUntilClosed = 1;   ///< Jaws let go once they have closed on it.
inline constexpr uint8_t kLockedUntilEngaged = 2;  ///< The same, when a hand has come.
/// The same, once jaws that came back through their port with it have opened.
inline constexpr uint8_t kLockedUntilOpened = 3;

/// A needle that goes from hand to hand.
struct Handover {
    int8_t second = -1;             ///< Tool whose jaws hold it as well, -1 = none.
    int8_t last = -1;               ///< Tool whose jaws held it last, -1 = none did.
    float held_s = 0, peak_n = 0;   ///< Of the second jaws, as those of the first.
    JawSlip slide, turn;            ///< Likewise.
    float both_s = 0;               ///< Since both hold it.
    float apart_n = 0;              ///< Largest force between them since then [N].
    Quat began = Quat::Identity();  ///< How the needle lay when both began to hold it, X_WN.q.
    /// How it lay when its turning was counted last, and what this came to since it was taken.
    Quat counted = Quat::Identity();
    float swung_rad = 0;
};
template <class Visit>
void fields(Of<Handover> auto& s, Visit&& visit) {
    auto& [second, last, held_s, peak_n, slide, turn, both_s, apart_n, began, counted, swung_rad] =
        s;
    visit.state(second, last, held_s, peak_n, slide, turn, both_s, apart_n, began, counted,
                swung_rad);
}

struct Suturing {
    explicit Suturing(const Scene& scene);

    std::vector<SutureState> needle;  ///< Empty or one.
    uint8_t placed = 0;               ///< The needle is in the field.
    int8_t driver = -1;               ///< Tool whose jaws hold it, also outside; -1 = none.
    Handover handover;                ///< Other jaws that hold it as well.
    uint8_t locked = 0;               ///< As it began: see above; 0 = the jaws may let go.
    float held_s = 0, peak_n = 0;     ///< Since it was taken; peak of its pull on the jaws.
    JawSlip slide, turn;              ///< Along the wire, about the grip.
    int32_t taken = 0, entered = 0, left = 0, through = 0;  ///< So far.
    std::array<float, 3> entry_m{}, exit_m{};               ///< The last ones, at rest [m].
    float point_n = 0;   ///< Of the tissue on the point, largest of the last frame.
    float thread_n = 0;  ///< Pull of the thread, largest of the last frame.
};
template <class Visit>
void fields(Of<Suturing> auto& s, Visit&& visit) {
    auto& [needle, placed, driver, handover, locked, held_s, peak_n, slide, turn, taken, entered,
           left, through, entry_m, exit_m, point_n, thread_n] = s;
    visit.state(needle, placed, driver, handover, locked, held_s, peak_n, slide, turn, taken,
                entered, left, through, entry_m, exit_m, point_n, thread_n);
}

/// What a needle in the jaws of a tool does to it, in the last substep: force of needle, tissue and
/// thread on the tool [N] and how that grows with the tool's way [N/m]. Nothing for other tools,
/// and nothing while the needle is in the open and in no other jaws, where it follows.
struct NeedlePull {
    Vec3 force_n = Vec3::Zero();
    double stiffness_n_m = 0;
};
[[nodiscard]] NeedlePull needle_pull(const Scene& scene, const State& state, int tool) noexcept;

/// The hold of a tool's jaws, nullptr where they hold no needle.
[[nodiscard]] const NeedleHold* hold_of(const State& state, int tool) noexcept;
/// The needle, held by somebody or not, is in no tissue, and neither is its thread.
[[nodiscard]] bool needle_in_the_open(const SutureState& needle) noexcept;
/// Two tools hold it there: what they pull at each other does nothing to the tissue.
[[nodiscard]] bool between_hands(const State& state) noexcept;
/// A needle may go from hand to hand here.
[[nodiscard]] bool has_two_drivers(const Scene& scene) noexcept;

/// kNeedleHandedOver of a needle that two tools hold: how far it turned, how hard they pulled.
/// @param element how long [ms], -1 = it is not handed over.
[[nodiscard]] Event held_by_both(const State& state, int tool, int32_t element) noexcept;

/// Event of a needle in the jaws of a tool, -1 = of none: not on the tissue, but where the jaws
/// are.
[[nodiscard]] Event driver_event(const State& state, EventKind kind, int tool, float value,
                                 float value2) noexcept;

}  // namespace placode::sim
