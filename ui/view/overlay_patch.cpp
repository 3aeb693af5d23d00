// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A patch that is laid: the line around the placode that it has to reach, and where its middle
// belongs.

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

/// Dashes where the patch does not reach yet, a green line where it does.
void Overlay::patch_margin() {
    const PracticeGoal& goal = state_->practice.goal;
    const size_t points = goal.margin_m.size();
    const auto place = [&](size_t i, Vec2& px) {
        const auto& p = goal.margin_m[i % points];
        return place_of(1000 * Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]),
                                    static_cast<double>(p[2])),
                        px);
    };
    for (size_t i = 0; i < points; ++i) {
        const bool done = goal.traced[i] != 0;
        if (!done && i % 2 != 0) continue;  // dashes
        Vec2 from, to;
        if (!place(i, from) || !place(i + 1, to)) continue;
        shapes::stroke(*paint_, from, to, 4.0, kInk.faded(0.6F));
        shapes::stroke(*paint_, from, to, 2.0, done ? kGood : kText);
    }
}

/// Its middle and the place for it, with the way that is left; then what is still to do there.
void Overlay::patch_goal() {
    constexpr double kThereMm = 0.8;
    const PracticeGoal& goal = state_->practice.goal;
    const Vec3 wanted_mm = 1000 * goal.target_m[0], middle_mm = 1000 * goal.target_m[1];
    const double away_mm = (wanted_mm - middle_mm).head<2>().norm();
    Vec2 wanted, middle;
    if (!place_of(wanted_mm, wanted)) return;
    const bool far = away_mm > kThereMm;
    const double u = unit_;
    paint_->ring(wanted.x(), wanted.y(), 0.9 * u + 1.5, 0.75, kInk.faded(0.6F));
    paint_->ring(wanted.x(), wanted.y(), 0.9 * u, 0.78, far ? kText : kGood);
    labels_.push_back({wanted.x() - 0.9 * u, wanted.y() - 0.9 * u, 1.8 * u, 1.8 * u});
    if (place_of(middle_mm, middle)) {
        paint_->ring(middle.x(), middle.y(), 0.42 * u, 0.55, far ? kAccent : kGood);
        const Vec2 offset = wanted - middle;
        if (far && offset.norm() > 2.4 * u) {
            const Vec2 unit = offset.normalized();
            shapes::arrow(*paint_, middle + 0.6 * u * unit, wanted - 1.1 * u * unit, 0.4 * u,
                          0.11 * u, kAccent.faded(0.75F));
        }
    }
    const Vec2 below = wanted + Vec2(0, 2.4 * u);
    if (goal.step.kind == PracticeKind::kPatchSpread)
        label(below, say("smooth out the folds"), kText);
    else if (far)
        label(below, phrase("%1 mm away", number(away_mm, 1)), kText);
    else
        label(below, say("as far as the line, all round"), kText);
}

}  // namespace placode::view
