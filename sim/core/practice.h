// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steps of a practice task: what the trainee is to do next, where, and how exactly. The task's JSON
// says them, assessment/practice.h watches them, the overlay and scripted operators see the goal.

#include <array>
#include <cstdint>

#include "sim/core/event.h"
#include "sim/core/geometry.h"
#include "sim/core/tool.h"

namespace placode::sim {

enum class PracticeKind : uint8_t {
    kMove,      ///< Move a tip across its shaft by `distance_m` in all.
    kDepth,     ///< Move it along its shaft by that much.
    kTurn,      ///< Turn it about its shaft by `turn_rad` in all.
    kTouch,     ///< Touch the target.
    kCut,       ///< Touch it and press the yellow pedal for `hold_s`.
    kCoag,      ///< And the blue one.
    kGrasp,     ///< Take hold of tissue at the target.
    kRelease,   ///< Let it go; with two drivers, the needle.
    kTrace,     ///< Follow the planned line with the tip at the surface, without energy.
    kTraction,  ///< Both hands hold tissue and pull with `low_n` to `high_n` for `hold_s`.
    kWithdraw,  ///< Take the instrument `distance_m` away from the tissue.
    kNeedleIn,  ///< The needle's point goes in at the first mark; the second is where it comes out.
    kNeedleOut,      ///< It comes out at the second mark.
    kNeedleTake,     ///< Jaws take it again; with two drivers, those of this hand.
    kNeedleThrough,  ///< All of the needle is drawn through.
    kThreadDraw,     ///< The thread is drawn until a slit is shut between the marks.
    kPatchTake,      ///< Jaws take the patch.
    kPatchLay,       ///< It lies so that it reaches `distance_m` beyond the placode's edge.
    kPatchSpread,    ///< Nobody holds it, it lies so, and flat, for `hold_s`.
    kWash,           ///< The jet has loosened all debris.
    kSuck,           ///< Nothing floats any more and the field is dry, for `hold_s`.
    kUndermine,      ///< Skin on the side away from the hand's port has come off the fascia.
    kNeedleShow,     ///< This hand holds the needle with its point at the mark for `hold_s`.
    kNeedleLay       ///< The needle lies at the mark, let go, for `hold_s`.
};
inline constexpr int kPracticeKinds = 24;
inline constexpr int kMaxPracticeSteps = 24;
inline constexpr int kTraceBins = 72;  ///< Of the planned contour, by arc length.

struct PracticeStep {
    PracticeKind kind = PracticeKind::kMove;
    Hand hand = Hand::kRight;  ///< Who does it; traction needs both.
    double distance_m = 0.02;  ///< Move, depth, withdraw; overlap of a patch.
    double turn_rad = 1;       ///< Turn.
    double hold_s = 0;         ///< Touch, cut, coag, traction, patch that lies.
    double hour = 12;          ///< Target on the clock of the planned contour, 12 = cranial.
    double hour_left = 12;     ///< Traction: target of the left hand; needle: where it comes out.
    double outward_m = 0;      ///< Target this far outside the planned contour.
    bool placed = false;       ///< Targets at `place_m` instead.
    std::array<Vec2, 2> place_m{Vec2::Zero(), Vec2::Zero()};  ///< In the field's plane at rest [m].
    double tolerance_m = 0.001;  ///< Distance from target or line, or gap, that still counts.
    double take_share = 0;  ///< Needle taken about here along its arc, from the point; 0: anywhere.
    double low_n = 0.01,
           high_n = 0.1;  ///< Traction of each hand; pull on a thread, from 0 or more.
    /// Thread: whoever held this much [N] for `hold_s` and then eases off has drawn it, too loosely
    /// or not, where the edges met. 0 = only `low_n` ends the step.
    double enough_n = 0;
};

/// Where practice stands: what a person sees in the overlay.
struct PracticeGoal {
    int count = 0, index = 0;                                  ///< index == count: all done.
    PracticeStep step;                                         ///< The present one.
    std::array<Vec3, 2> target_m{Vec3::Zero(), Vec3::Zero()};  ///< Where they lie now, in W.
    int targets = 0;
    int bites = 0, bite = 0;  ///< A needle's, in all; number of the present one.
    double progress = 0;      ///< Of the present step, 0..1.
    /// 1 = this stretch of the contour was followed; of a patch: at this point of the placode's
    /// edge it reaches as far as it shall.
    std::array<uint8_t, kTraceBins> traced{};
    /// Of a patch: where its rim shall be at least, `distance_m` outside of the placode's edge.
    std::array<std::array<float, 3>, kTraceBins> margin_m{};
    bool margin = false;
};

/// Its targets are on the patch and the placode, and no places of the task's own.
[[nodiscard]] constexpr bool is_patch_step(PracticeKind kind) noexcept {
    return kind == PracticeKind::kPatchTake || kind == PracticeKind::kPatchLay ||
           kind == PracticeKind::kPatchSpread;
}

/// Its target is the next debris or the deepest fluid.
[[nodiscard]] constexpr bool is_wash_step(PracticeKind kind) noexcept {
    return kind == PracticeKind::kWash || kind == PracticeKind::kSuck;
}

/// Its targets are found while it is done; a task names no places for it.
[[nodiscard]] constexpr bool finds_targets(PracticeKind kind) noexcept {
    return is_patch_step(kind) || is_wash_step(kind) || kind == PracticeKind::kUndermine;
}

/// Places that the picture shows for a step.
[[nodiscard]] constexpr int targets_of(PracticeKind kind) noexcept {
    switch (kind) {
        case PracticeKind::kTouch:
        case PracticeKind::kCut:
        case PracticeKind::kCoag:
        case PracticeKind::kGrasp:
        case PracticeKind::kPatchTake:
        case PracticeKind::kWash:
        case PracticeKind::kSuck:
        case PracticeKind::kUndermine:
        case PracticeKind::kNeedleShow:
        case PracticeKind::kNeedleLay:
            return 1;
        case PracticeKind::kTraction:
        case PracticeKind::kNeedleIn:
        case PracticeKind::kNeedleOut:
        case PracticeKind::kThreadDraw:
        case PracticeKind::kPatchLay:
        case PracticeKind::kPatchSpread:
            return 2;
        default:
            return 0;
    }
}

}  // namespace placode::sim
