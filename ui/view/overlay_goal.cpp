// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the present step of a practice task is about, drawn where it happens: rings around places,
// marks between which a tip goes to and fro, a scale along the shaft, an arc to turn through.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {

constexpr double kSwingMm = 5;          // end marks stand this far to both sides
constexpr double kAboveTissueMm = 1.5;  // and never nearer to the tissue than this
constexpr double kScopeSwingMm = 5;     // of what the scope looks at
constexpr double kBehindPointMm = 1.5;  // where the jaws take a needle that has come out

}  // namespace

/// The instrument of a hand; those that share a port take turns.
int Overlay::tool_of(Hand hand) const {
    int found = -1;
    for (int i = 0; tips_->tools != nullptr && i < snapshot_->tool_count; ++i) {
        const auto t = static_cast<size_t>(i);
        if (t >= tips_->tools->size() || (*tips_->tools)[t].hand != hand) continue;
        if (found < 0 || (snapshot_->tools[t].engaged != 0 &&
                          snapshot_->tools[static_cast<size_t>(found)].engaged == 0))
            found = i;
    }
    return found;
}

/// A step begins: what its marks are measured from.
void Overlay::anchor_watch(int tool) {
    const PracticeGoal& goal = state_->practice.goal;
    const auto t = static_cast<size_t>(tool);
    const Pose& pose = snapshot_->tools[t].pose;
    const TipFoot& foot = tips_->feet[t];
    const bool scope = goal.step.hand == Hand::kCamera;
    watch_.right_mm = camera_->right;
    watch_.shaft = pose.q * Vec3::UnitZ();
    // Of the scope it is what lies in the middle of its picture, at the height of the field.
    const double down = std::min(-0.2, camera_->forward.z());
    watch_.anchor_mm =
        scope ? Vec3(camera_->position_mm - camera_->position_mm.z() / down * camera_->forward)
              : Vec3(1000 * pose.p);
    watch_.deepest_mm =
        foot.found ? std::clamp(foot.height_mm - kAboveTissueMm, 1.0, kSwingMm) : kSwingMm;
    watch_.side = goal.step.kind == PracticeKind::kDepth ? -1 : 1;
}

void Overlay::goals() {
    if (!practising()) return;
    const PracticeGoal& goal = state_->practice.goal;
    const int tool = goal_tool();
    const auto t = static_cast<size_t>(std::max(tool, 0));
    // Before the first motion there is no instrument yet.
    watch_.look(goal, tips_->clock_s, state_->menu.shown || state_->show_help,
                tool >= 0 && snapshot_->tools[t].engaged != 0);
    if (goal.index >= goal.count || tool < 0) return;
    const Pose& pose = snapshot_->tools[t].pose;
    const bool scope = goal.step.hand == Hand::kCamera;
    if (watch_.fresh()) anchor_watch(tool);
    if (snapshot_->tools[t].buried_m > 0) return;  // that comes first
    if (goal.margin) patch_margin();
    switch (goal.step.kind) {
        case PracticeKind::kPatchLay:
        case PracticeKind::kPatchSpread:
            patch_goal();
            break;
        case PracticeKind::kMove:
            if (scope)
                scope_marks();
            else
                end_marks(tool);
            break;
        case PracticeKind::kDepth: {
            const double now = -(1000 * pose.p - watch_.anchor_mm).dot(watch_.shaft);
            if (watch_.side < 0 ? now < -0.9 * watch_.deepest_mm : now > 0.9 * kSwingMm)
                watch_.side = -watch_.side;
            shaft_scale(tool, -watch_.deepest_mm, kSwingMm, now, watch_.side);
            break;
        }
        case PracticeKind::kWithdraw:
            shaft_scale(tool, 0, 1000 * goal.step.distance_m, gap_mm(tool), 1);
            break;
        case PracticeKind::kTurn:
            turn_arc(tool);
            break;
        case PracticeKind::kRelease: {
            Vec2 px;
            if (place_of(1000 * pose.p, px))
                label(px + Vec2(0, 2.6 * unit_), say("open the jaws"), kAccent);
            break;
        }
        case PracticeKind::kNeedleTake:
            take_mark(tool);
            break;
        case PracticeKind::kNeedleThrough:
        case PracticeKind::kThreadDraw: {
            const char* what = goal.step.kind == PracticeKind::kNeedleThrough
                                   ? "draw the needle through"
                                   : "draw the thread until the edges meet";
            Vec2 px;
            if (place_of(1000 * pose.p, px)) label(px + Vec2(0, 2.6 * unit_), say(what), kAccent);
            break;
        }
        default:
            targets();
            break;
    }
}

// Where the needle is to be taken, once nobody holds it any more.
void Overlay::take_mark(int tool) {
    const NeedleSnapshot& needle = snapshot_->needle;
    const PracticeStep& step = state_->practice.goal.step;
    Vec2 px;
    if (needle.present == 0 || needle.driver == tool) {
        const char* what = step.take_share > 0 ? "turn it on, then open the jaws" : "open the jaws";
        if (place_of(1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p, px))
            label(px + Vec2(0, 2.6 * unit_), say(what), kAccent);
        return;
    }
    const double arc_mm = 1000 * static_cast<double>(needle.arc_m);
    const double radius_mm = arc_mm / std::numbers::pi;
    const double along_mm = step.take_share > 0 ? step.take_share * arc_mm : kBehindPointMm;
    const double a = along_mm / radius_mm;
    const Vec3 wire_mm =
        1000 * needle.pose.p + needle.pose.q * Vec3(radius_mm * Vec3(std::cos(a), std::sin(a), 0));
    if (!place_of(wire_mm, px)) return;
    const double r = 0.8 * unit_;
    paint_->ring(px.x(), px.y(), r + 1.5, (r - 1.5) / (r + 1.5), kInk.faded(0.6F));
    paint_->ring(px.x(), px.y(), r, (r - 2) / r, kAccent);
    labels_.push_back({px.x() - r, px.y() - r, 2 * r, 2 * r});
    label(px + Vec2(0, r + 1.5 * unit_), say("take the needle"), kAccent);
}

// Two posts beside the tip; the one to reach next is lit.
void Overlay::end_marks(int tool) {
    const Vec2 centre(circle_.x, circle_.y);
    const double u = unit_, r = circle_.radius;
    Vec2 middle = centre, aside, tip;
    double per_mm = r / 15;
    if (place_of(watch_.anchor_mm, middle) && place_of(watch_.anchor_mm + watch_.right_mm, aside))
        per_mm = (aside - middle).norm();
    const double half = std::clamp(kSwingMm * per_mm, 3 * u, 0.5 * r);
    middle.y() = std::clamp(middle.y(), centre.y() - 0.5 * r, centre.y() + 0.5 * r);
    const double dy = middle.y() - centre.y();
    const double room = std::max(0.0, 0.92 * std::sqrt(r * r - dy * dy) - half);
    middle.x() = std::clamp(middle.x(), centre.x() - room, centre.x() + room);
    const Vec3 tip_mm = 1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p;
    if (place_of(tip_mm, tip) && watch_.side * (tip.x() - middle.x()) > 0.92 * half)
        watch_.side = -watch_.side;
    shapes::stroke(*paint_, middle - Vec2(half, 0), middle + Vec2(half, 0), 1.5,
                   kText.faded(0.35F));
    for (const int side : {-1, 1}) {
        const Vec2 post = middle + Vec2(side * half, 0);
        const bool next = side == watch_.side;
        const Colour colour = next ? kAccent : kText.faded(0.6F);
        shapes::stroke(*paint_, post - Vec2(0, 1.5 * u), post + Vec2(0, 1.5 * u),
                       next ? 0.30 * u : 0.16 * u, colour);
        if (!next) continue;
        for (const double back : {1.0, 1.7})
            shapes::chevron(*paint_, post - Vec2(side * back * u, 0), Vec2(side, 0), 0.55 * u,
                            0.18 * u, kAccent);
    }
    label(middle + Vec2(0, 2.9 * u), amount_text(), kText);
}

// Places on the tissue that the scope shall look at: the cross is what it looks at now.
void Overlay::scope_marks() {
    const Vec2 centre(circle_.x, circle_.y);
    const double u = unit_;
    for (const int side : {-1, 1}) {
        Vec2 px;
        if (!place_of(watch_.anchor_mm + side * kScopeSwingMm * watch_.right_mm, px)) continue;
        const bool next = side == watch_.side;
        paint_->ring(px.x(), px.y(), 1.2 * u, 0.78, next ? kAccent : kText.faded(0.45F));
        labels_.push_back({px.x() - 1.2 * u, px.y() - 1.2 * u, 2.4 * u, 2.4 * u});
        if (next && (px - centre).norm() < 1.1 * u) watch_.side = -watch_.side;
        if (next && (px - centre).norm() > 3 * u) {
            const Vec2 offset = (px - centre).normalized();
            shapes::arrow(*paint_, centre + 1.3 * u * offset, px - 1.6 * u * offset, 0.5 * u,
                          0.14 * u, kAccent.faded(0.8F));
        }
    }
    for (const Vec2& offset : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)})
        shapes::stroke(*paint_, centre + 0.35 * u * offset, centre + 1.1 * u * offset, 0.16 * u,
                       kText);
    label(centre + Vec2(0, 2.9 * u), amount_text(), kText);
}

// Beside the tip: up is back towards the port, down is deeper.
void Overlay::shaft_scale(int tool, double low_mm, double high_mm, double now_mm, int next) {
    Vec2 tip(circle_.x, circle_.y);
    static_cast<void>(place_of(1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p, tip));
    const double u = unit_, height = 8 * u;
    const Vec2 foot = beside(tool, tip) + Vec2(0, 0.5 * height);
    const auto at = [&](double mm) {
        const double share = std::clamp((mm - low_mm) / (high_mm - low_mm), -0.06, 1.06);
        return Vec2(foot - Vec2(0, share * height));
    };
    paint_->box(foot.x() - 0.5 * u, foot.y() - height - 0.5 * u, u, height + u, kInk.faded(0.45F));
    shapes::stroke(*paint_, at(low_mm), at(high_mm), 1.5, kText.faded(0.6F));
    for (const int side : {-1, 1}) {
        const Vec2 end = at(side < 0 ? low_mm : high_mm);
        const bool lit = side == next;
        shapes::stroke(*paint_, end - Vec2(0.9 * u, 0), end + Vec2(0.9 * u, 0),
                       lit ? 0.30 * u : 0.16 * u, lit ? kAccent : kText.faded(0.6F));
        if (lit)
            for (const double back : {1.0, 1.7})
                shapes::chevron(*paint_, end + Vec2(0, side * back * u), Vec2(0, -side), 0.55 * u,
                                0.18 * u, kAccent);
    }
    const Vec2 here = at(now_mm);
    paint_->ring(here.x(), here.y(), 0.55 * u, 0, kInk.faded(0.7F));
    paint_->ring(here.x(), here.y(), 0.42 * u, 0, kText);
    label(foot + Vec2(0, 1.7 * u), amount_text(), kText);
}

void Overlay::turn_arc(int tool) {
    Vec2 tip;
    if (!place_of(1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p, tip))
        tip = Vec2(circle_.x, circle_.y);
    const PracticeGoal& goal = state_->practice.goal;
    const double u = unit_, radius = 2.8 * u;
    const double whole = std::min(goal.step.turn_rad, 5.2);
    const double share = std::clamp(goal.progress, 0.0, 1.0);
    shapes::arc(*paint_, tip, radius, 0.75 * u, 0, whole, kInk.faded(0.55F));
    shapes::arc(*paint_, tip, radius, 0.30 * u, 0, whole, kText.faded(0.55F));
    shapes::arc(*paint_, tip, radius, 0.45 * u, 0, whole * share, kAccent);
    const Vec2 end = tip + radius * Vec2(std::sin(whole), -std::cos(whole));
    shapes::chevron(*paint_, end + 0.3 * u * Vec2(std::cos(whole), std::sin(whole)),
                    Vec2(std::cos(whole), std::sin(whole)), 0.6 * u, 0.2 * u, kAccent);
    label(tip + Vec2(0, radius + 1.6 * u), amount_text(), kText);
}

}  // namespace placode::view
