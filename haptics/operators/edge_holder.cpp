// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/edge_holder.h"

namespace placode::haptics {
namespace {

constexpr double kHolderOverM = 0.004, kHolderIntoM = 0.0005, kHolderDownM_s = 0.006,
                 kHolderUpM_s = 0.004;
constexpr double kHolderOpenRad = 0.35, kHolderHeldRad = 0.15, kHolderJawRad_s = 0.8;
constexpr double kHolderLooseRad = 0.24, kHolderLowM = 3e-4, kHolderSlowS = 0.5;
constexpr double kOtherPlaceM = 0.0025;  // a place this far away is another one
constexpr int kHolderTries = 2;

}  // namespace

void EdgeHolder::stage(Stage next) noexcept {
    stage_ = next;
    stage_s_ = 0;
    raised_ = false;
}

void EdgeHolder::want(bool wanted, const Vec3& place_m, const Vec3& along,
                      double raise_m) noexcept {
    const bool other = wanted && (place_m - wanted_m_).norm() > kOtherPlaceM;
    if (wanted != wanted_ || other) {
        changed_ = true;
        tries_ = 0;
    }
    wanted_ = wanted;
    if (wanted && changed_) {
        wanted_m_ = place_m;
        along_ = along;
        raise_m_ = raise_m;
    }
}

bool EdgeHolder::ready() const noexcept {
    if (changed_) return false;
    return wanted_ ? (stage_ == Stage::kHold && raised_) || tries_ >= kHolderTries
                   : stage_ == Stage::kAway;
}

HandAction EdgeHolder::act(double time_s, double dt_s) noexcept {
    stage_s_ += dt_s;
    const Vec3 up = Vec3::UnitZ();
    switch (stage_) {
        case Stage::kAway:
            static_cast<void>(motion_.reached(motion_.home_m(), dt_s));
            if (!wanted_ || tries_ >= kHolderTries) {
                changed_ = false;
                break;
            }
            changed_ = false;
            place_m_ = wanted_m_;
            motion_.reach(place_m_ + kHolderOverM * up, up);
            stage(Stage::kOver);
            break;
        case Stage::kOver:
            static_cast<void>(motion_.jaw(kHolderOpenRad, 1.5, dt_s));
            if (motion_.reached(place_m_ + kHolderOverM * up, dt_s)) stage(Stage::kDown);
            break;
        case Stage::kDown:
            if (motion_.glide(place_m_ - kHolderIntoM * up, kHolderDownM_s, dt_s))
                stage(Stage::kClose);
            break;
        case Stage::kClose:
            if (!motion_.jaw(kHolderHeldRad, kHolderJawRad_s, dt_s) || stage_s_ < 0.4) break;
            if (!holds_) ++tries_;
            stage(holds_ ? Stage::kHold : Stage::kLetGo);
            break;
        case Stage::kHold:
            // Down again before it opens, but not so far that the jaws press on the skin beside.
            if (motion_.glide(place_m_ + (changed_ ? kHolderLowM : raise_m_) * up, kHolderUpM_s,
                              dt_s)) {
                raised_ = true;
                if (changed_) stage(Stage::kLetGo);
            }
            break;
        case Stage::kLetGo:
            // Thick tissue needs wider jaws to come free.
            if (motion_.jaw(stage_s_ > kHolderSlowS ? kHolderOpenRad : kHolderLooseRad,
                            kHolderJawRad_s, dt_s) &&
                !holds_)
                stage(Stage::kUp);
            break;
        case Stage::kUp:
            if (!motion_.glide(place_m_ + kHolderOverM * up, 3 * kHolderUpM_s, dt_s)) break;
            motion_.reach(motion_.home_m());
            stage(Stage::kAway);
            break;
    }
    HandAction action = motion_.action(time_s);
    action.opening = along_;
    return action;
}

}  // namespace placode::haptics
