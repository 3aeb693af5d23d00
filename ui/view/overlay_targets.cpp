// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rings around the places of a practice step, and how far the tip is from them: first beside, then
// above.

#include <algorithm>

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {

/// What is to be held for a pedal; where there are keys and buttons, the very one.
std::string_view pedal_words(haptics::HintDevice device, bool cut) {
    switch (device) {
        case haptics::HintDevice::kMouse:
            return cut ? "now hold the left button" : "now hold the right button";
        case haptics::HintDevice::kKeyboard:
            return cut ? "now hold X" : "now hold C";
        default:
            return cut ? "now the yellow pedal" : "now the blue pedal";
    }
}

}  // namespace

/// What is to be touched or grasped is the task itself and no aid: an exam shows where, and not how
/// far away it is or whether the tip is above it.
void Overlay::exam_targets() {
    if (!practising()) return;
    const PracticeGoal& goal = state_->practice.goal;
    const bool places = targets_of(goal.step.kind) > 0 && !finds_targets(goal.step.kind);
    if (goal.index < goal.count && places) targets();
}

void Overlay::targets() {
    const PracticeGoal& goal = state_->practice.goal;
    const bool both = goal.step.kind == PracticeKind::kTraction;
    // The needle's point has to come there, not the driver's tip.
    const bool wash = is_wash_step(goal.step.kind),
               freed = goal.step.kind == PracticeKind::kUndermine;
    const bool needle =
        goal.step.kind == PracticeKind::kNeedleIn || goal.step.kind == PracticeKind::kNeedleOut;
    const bool show = goal.step.kind == PracticeKind::kNeedleShow,
               lay = goal.step.kind == PracticeKind::kNeedleLay;
    if (needle && goal.bites > 1 && goal.targets == 2 && snapshot_->slit == 0) suture_line();
    for (int t = 0; t < goal.targets; ++t) {
        const Vec3 mm = 1000 * goal.target_m[static_cast<size_t>(t)];
        Vec2 px, side;
        if (!place_of(mm, px)) continue;
        const int tool = both ? tool_of(t == 0 ? Hand::kRight : Hand::kLeft) : goal_tool();
        const Vec3 away =
            tool < 0 ? Vec3(Vec3::Zero())
                     : Vec3(1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p - mm);
        const bool above = !state_->exam && !needle && !show && !lay && !wash && !freed &&
                           tool >= 0 && away.head<2>().norm() <= 1000 * goal.step.tolerance_m;
        double radius = 0.7 * unit_;
        if (place_of(mm + 1000 * goal.step.tolerance_m * camera_->right, side))
            radius = std::max(radius, (side - px).norm());
        paint_->ring(px.x(), px.y(), radius + 1.5, (radius - 2.5) / (radius + 1.5),
                     kInk.faded(0.6F));
        paint_->ring(px.x(), px.y(), radius, (radius - 2) / radius, above ? kGood : kText);
        paint_->ring(px.x(), px.y(), 2.5, 0, above ? kGood : kText);
        if (goal.progress > 0)
            paint_->ring(px.x(), px.y(), radius, 1 - std::min(1.0, goal.progress),
                         kAccent.faded(0.5F));
        labels_.push_back({px.x() - radius, px.y() - radius, 2 * radius, 2 * radius});
        if (needle)
            label(px + Vec2(0, radius + 1.5 * unit_), say(t == 0 ? "needle in" : "needle out"),
                  kText);
        else if (show || lay)
            label(px + Vec2(0, radius + 1.5 * unit_),
                  say(show ? "hold the point here" : "lay the needle here"), kText);
        else if (wash)
            label(px + Vec2(0, radius + 1.5 * unit_),
                  phrase(goal.step.kind == PracticeKind::kWash ? "washed off: %1" : "dry: %1",
                         amount_text()),
                  kText);
        else if (freed)
            label(px + Vec2(0, radius + 1.5 * unit_), phrase("freed: %1", amount_text()), kText);
        else if (tool >= 0 && !state_->exam)
            target_text(tool, px, radius, away, above);
    }
}

/// The line that the bites of a row go across, drawn past the present one to both sides.
void Overlay::suture_line() {
    constexpr double kHalfMm = 3;
    const PracticeGoal& goal = state_->practice.goal;
    const Vec3 in = 1000 * goal.target_m[0], out = 1000 * goal.target_m[1];
    const Vec3 along = Vec3::UnitZ().cross(out - in);
    if (along.norm() < 1e-6) return;
    const Vec3 middle = 0.5 * (in + out), half = kHalfMm * along.normalized();
    Vec2 from, to;
    if (!place_of(middle - half, from) || !place_of(middle + half, to)) return;
    shapes::stroke(*paint_, from, to, 3.5, kInk.faded(0.6F));
    shapes::stroke(*paint_, from, to, 1.5, kText);
}

/// What is missing at a ring, as one short phrase below it.
void Overlay::target_text(int tool, const Vec2& px, double radius, const Vec3& away_mm,
                          bool above) {
    const PracticeStep& step = state_->practice.goal.step;
    const ToolSnapshot& seen = snapshot_->tools[static_cast<size_t>(tool)];
    const TipFoot& foot = tips_->feet[static_cast<size_t>(tool)];
    const Vec2 place = px + Vec2(0, radius + 1.5 * unit_);
    if (seen.buried_m > 0) return;  // that comes first
    Vec2 below;
    if (foot.found && foot.height_mm > 0.5 && place_of(foot.foot_mm, below)) {
        // The spot right below the tip: it has to come into the ring.
        paint_->ring(below.x(), below.y(), 0.42 * unit_, 0.55, above ? kGood : kAccent);
        const Vec2 offset = px - below;
        // Seen aslant it lies far from the tip: nobody knows what it is without a word.
        if (!above && offset.norm() > radius + 3.5 * unit_)
            label(below - Vec2(0, 1.3 * unit_), say("below the tip"), kAccent);
        if (!above && offset.norm() > radius + 1.2 * unit_) {
            const Vec2 unit = offset.normalized();
            shapes::arrow(*paint_, below + 0.6 * unit_ * unit, px - (radius + 4) * unit,
                          0.4 * unit_, 0.11 * unit_, kAccent.faded(0.75F));
        }
    }
    if (!above) {
        label(place, phrase("%1 mm away", number(away_mm.head<2>().norm(), 1)), kText);
        return;
    }
    const bool touches = seen.in_contact != 0;
    const double gap = gap_mm(tool);
    if (contact_lost(step, seen.pedals, touches, gap)) {
        label(place, say("no contact: a little deeper"), kWarn);
        return;
    }
    if (!touches && gap > 0.15) {
        // The gauge beside the tip says how far.
        const bool gauge = state_->depth_aid && gap < kGaugeMm;
        label(place,
              gauge ? say("straight down")
                    : phrase("%1 mm above", number(std::min(gap, away_mm.z()), 1)),
              kGood);
        return;
    }
    const bool cut = step.kind == PracticeKind::kCut, coag = step.kind == PracticeKind::kCoag;
    const uint8_t wanted = cut ? kPedalCut : coag ? kPedalCoag : uint8_t{0};
    if (wanted != 0 && seen.pedals != wanted)
        label(place, with_keys(say(pedal_words(state_->practice.device, cut))),
              cut ? kYellow : kBlue);
    else if (step.kind == PracticeKind::kGrasp || step.kind == PracticeKind::kPatchTake)
        label(place, say("now close the jaws"), kGood);
    else if (const std::string amount = amount_text(); !amount.empty())
        label(place, amount, kText);
}

}  // namespace placode::view
