// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How far a tip is from the tissue, beside the tip, and what of an instrument lies below the
// surface, where the tissue hides it.

#include <algorithm>
#include <cmath>

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {

constexpr double kTouchMm = 0.05;  // nearer than this it is as good as there

/// Radius of the drawn instrument behind its tip [mm].
double radius_mm(const ToolSpec& spec, double behind_mm) {
    const double tip = 1000 * std::max(spec.tip_radius_m, 0.0003),
                 shaft = 1000 * std::max(spec.shaft_radius_m, spec.tip_radius_m);
    const double past = behind_mm - 1000 * spec.tip_length_m;
    return std::clamp(tip + past / 1.5, tip, shaft);
}

}  // namespace

/// Distance of a tip from the tissue [mm]. Near it is the simulation's; beyond its search, what
/// lies right below.
double Overlay::gap_mm(int tool) const {
    constexpr float kNotFound = 0.5F;
    const auto t = static_cast<size_t>(tool);
    const float gap = snapshot_->tools[t].tip_gap_m;
    if (gap < kNotFound) return 1000 * static_cast<double>(gap);
    const TipFoot& foot = tips_->feet[t];
    return foot.found ? std::max(3.0, foot.height_mm) : 1e3;
}

/// A place beside a tip where its own shaft does not pass [px].
Vec2 Overlay::beside(int tool, const Vec2& tip_px) const {
    const Pose& pose = snapshot_->tools[static_cast<size_t>(tool)].pose;
    Vec2 back;
    const bool seen = place_of(1000 * pose.p - 4 * (pose.q * Vec3::UnitZ()), back);
    const double side = seen && back.x() > tip_px.x() ? -1 : 1;
    return tip_px + Vec2(3.4 * side * unit_, 0);
}

void Overlay::label(const Vec2& at, const std::string& text, const Colour& colour, Align align) {
    if (text.empty()) return;
    const double w = paint_->text_width(text, TextSize::kSmall) + 0.8 * unit_, h = 1.35 * unit_;
    double x = at.x() - (align == Align::kCentre ? 0.5 * w : align == Align::kRight ? w : 0);
    x = std::clamp(x, margin_, std::max(margin_, width_ - margin_ - w));
    const double wanted = std::clamp(at.y() - 0.95 * unit_, margin_, height_ - margin_ - h);
    const double y = free_row(labels_, {x, wanted, w, h}, margin_, height_ - margin_, 0.15 * unit_);
    labels_.push_back({x, y, w, h});
    paint_->box(x, y, w, h, kRaised.faded(0.80F));
    paint_->text(x + 0.4 * unit_, y + 0.98 * unit_, text, TextSize::kSmall, colour);
}

void Overlay::depth() {
    const PracticeGoal& goal = state_->practice.goal;
    const bool scaled = practising() && (goal.step.kind == PracticeKind::kDepth ||
                                         goal.step.kind == PracticeKind::kWithdraw);
    const int shown = scaled ? goal_tool() : -1;  // has a scale already
    for (int i = 0; i < snapshot_->tool_count; ++i) {
        const ToolSnapshot& tool = snapshot_->tools[static_cast<size_t>(i)];
        if (tool.kind == ToolKind::kScope || tool.engaged == 0) continue;
        if (tool.buried_m > 0) {
            if (state_->depth_aid || !state_->exam) buried(i);
            continue;
        }
        const double gap = gap_mm(i);
        if (!state_->depth_aid || i == shown) continue;
        if (gap < kGaugeMm)
            depth_gauge(i, gap);
        else if (tips_->feet[static_cast<size_t>(i)].found)
            height(i, gap);
    }
}

/// High above the field a number is enough: how far down there still is to go.
void Overlay::height(int tool, double gap) {
    Vec2 tip;
    if (!place_of(1000 * snapshot_->tools[static_cast<size_t>(tool)].pose.p, tip)) return;
    const double side = beside(tool, tip).x() < tip.x() ? -1 : 1;
    label(tip + Vec2(2.2 * side, 1.2) * unit_, phrase("%1 mm above", number(gap, 0)), kMuted,
          side < 0 ? Align::kRight : Align::kLeft);
}

/// Where the gauge stands: beside the tip, away from its shaft, and over no ring and no label.
Vec2 Overlay::gauge_foot(int tool, const Vec2& tip_px) {
    const double u = unit_, w = 1.2 * u, h = 0.8 * u * kGaugeMm + 2.0 * u;
    const Vec2 first = beside(tool, tip_px) + Vec2(0, 1.2 * u);
    const double side = first.x() < tip_px.x() ? -1 : 1;
    std::vector<LabelBox> places;
    for (const double path : {0.0, 2.2 * side, 4.4 * side, 6.6 * side, -6.8 * side, -9.0 * side})
        places.push_back({first.x() + path * u - 0.5 * w, first.y() - h + 2.0 * u, w, h});
    const LabelBox place = first_free(labels_, places);
    labels_.push_back(place);
    return {place.x + 0.5 * w, first.y()};
}

// Five millimetres of height beside the tip; the tissue is its foot.
void Overlay::depth_gauge(int tool, double gap) {
    const ToolSnapshot& seen = snapshot_->tools[static_cast<size_t>(tool)];
    Vec2 tip;
    if (!place_of(1000 * seen.pose.p, tip)) return;
    const double u = unit_, mm = 0.8 * u, w = 0.5 * u;
    const Vec2 foot = gauge_foot(tool, tip);
    const bool touches = seen.in_contact != 0 || gap < kTouchMm;
    const double height = std::clamp(gap, 0.0, kGaugeMm) * mm;
    const double x = foot.x() - 0.5 * w;
    paint_->box(x - 1, foot.y() - kGaugeMm * mm - 1, w + 2, kGaugeMm * mm + 2, kInk.faded(0.55F));
    for (int i = 1; i < static_cast<int>(kGaugeMm); ++i)
        paint_->box(x, foot.y() - i * mm - 0.5, 0.4 * w, 1, kText.faded(0.5F));
    paint_->box(x, foot.y() - height, w, height, kText.faded(0.30F));
    const Colour mark = touches ? kAccent : kText;
    paint_->box(x - 0.25 * u, foot.y() - height - 0.09 * u, w + 0.5 * u, 0.18 * u, mark);
    paint_->box(x - 0.35 * u, foot.y(), w + 0.7 * u, 0.2 * u,
                touches ? kAccent : kCritical.faded(0.7F));
    label(foot + Vec2(0, 1.45 * u),
          touches ? say("touches") : number(std::max(0.0, gap), 1) + " mm",
          touches ? kAccent : kText);
}

// The part that the tissue hides, as an outline, and how deep it is.
void Overlay::buried(int tool) {
    constexpr int kStations = 10;
    const auto t = static_cast<size_t>(tool);
    const ToolSnapshot& seen = snapshot_->tools[t];
    if (tips_->tools == nullptr || t >= tips_->tools->size()) return;
    const ToolSpec& spec = (*tips_->tools)[t];
    const Vec3 shaft = seen.pose.q * Vec3::UnitZ(), tip_mm = 1000 * seen.pose.p;
    const double length = 1000 * static_cast<double>(seen.buried_length_m) + 0.6;
    std::vector<Vec2> left, right;
    for (int i = 0; i <= kStations; ++i) {
        const double behind = length * i / kStations;
        const double radius = i == 0 ? 0.05 : radius_mm(spec, behind);
        const Vec3 at = tip_mm - behind * shaft;
        Vec2 px, next, aside;
        if (!place_of(at, px) || !place_of(at + 0.2 * shaft, next) ||
            !place_of(at + camera_->right, aside))
            continue;
        const Vec2 offset = (next - px).norm() > 1e-6 ? Vec2((next - px).normalized()) : Vec2(0, 1);
        const Vec2 across = radius * (aside - px).norm() * Vec2(-offset.y(), offset.x());
        left.push_back(px - across);
        right.push_back(px + across);
    }
    if (left.size() < 2) return;
    for (size_t i = 0; i + 1 < left.size(); ++i) {
        paint_->quad({left[i], right[i], right[i + 1], left[i + 1]}, kWarn.faded(0.28F));
        shapes::stroke(*paint_, left[i], left[i + 1], 1.6, kWarn);
        shapes::stroke(*paint_, right[i], right[i + 1], 1.6, kWarn);
    }
    shapes::stroke(*paint_, left[0], right[0], 1.6, kWarn);
    const Vec2 tip = 0.5 * (left[0] + right[0]), back = 0.5 * (left.back() + right.back());
    const Vec2 out = (back - tip).norm() > 1 ? Vec2((back - tip).normalized()) : Vec2(0, -1);
    // Out along the shaft, above it, where the label is not.
    const double up = out.x() > 0 ? -1 : 1;
    const Vec2 aside = 2.4 * unit_ * up * Vec2(-out.y(), out.x());
    shapes::arrow(*paint_, tip + aside, tip + aside + 4.0 * unit_ * out, 0.8 * unit_, 0.28 * unit_,
                  kWarn);
    label(tip + Vec2(0, 2.6 * unit_),
          phrase("%1 mm inside tissue", number(1000 * static_cast<double>(seen.buried_m), 1)),
          kWarn);
}

}  // namespace placode::view
