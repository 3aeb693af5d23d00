// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "haptics/control_words.h"
#include "sim/cutting/diathermy.h"
#include "ui/view/overlay_style.h"
#include "ui/view/strings.h"

namespace placode::view {

using namespace sim;

using namespace style;

std::string clock_text(double seconds) {
    const auto total = static_cast<long>(std::floor(std::max(0.0, seconds)));
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld", total / 60, total % 60);
    return text;
}

std::string Overlay::say(std::string_view english) const {
    return translated(english, state_->language);
}

std::string Overlay::with_keys(std::string_view text) const {
    return haptics::in_layout(text, state_->layout, state_->practice.device, state_->language);
}

std::string Overlay::phrase(std::string_view english, const std::string& first,
                            const std::string& second) const {
    std::string text = say(english);
    for (const auto& [mark, value] : {std::pair{"%1", first}, {"%2", second}}) {
        const size_t at = text.find(mark);
        if (at != std::string::npos) text.replace(at, 2, value);
    }
    return text;
}

void Overlay::draw(TextPainter& painter, const Snapshot& snapshot, const OverlayState& state,
                   const Circle& circle, const Camera& camera, const TipScene& tips,
                   const FrameTimes& times, int width, int height) {
    paint_ = &painter;
    snapshot_ = &snapshot;
    state_ = &state;
    camera_ = &camera;
    tips_ = &tips;
    times_ = &times;
    circle_ = circle;
    width_ = width;
    height_ = height;
    unit_ = std::clamp(std::min(height / 46.0, width / 60.0), 10.0, 26.0);
    margin_ = std::round(1.1 * unit_);
    // Width beside the circle at its middle; in the corners there is more.
    column_ = std::max(7.5 * unit_, 0.5 * width - circle.radius - 2 * margin_);
    painter.begin(width, height, unit_);
    menu_shown_ = state.menu.shown;
    labels_.clear();
    // The hint is drawn last, over everything: what has to be read beside it keeps clear of where
    // it was in the picture before.
    if (hint_box_.w > 0) labels_.push_back(hint_box_);
    hint_box_ = {};
    bars_top_ = height - margin_;
    if (!state.exam) {
        energy();
        force();
        ring();
        goals();
    } else {
        exam_targets();
    }
    if (!state.menu.shown) depth();
    foot_top_ = height_;
    read_outs();
    warning();
    if (state.show_performance) performance();
    if (state.show_help && !state.menu.shown) help();
    tuning_.hide();
    if (!state.menu.shown) tuning_.draw(painter, state.tuning, width_, height_, unit_);
    if (state.waiting && !state.menu.shown && !state.show_help) waiting();
    hint();
    if (state.holding > 0) hold_ring();
    if (state.menu.shown) menu();
    painter.draw();
}

void Overlay::energy() {
    if (!energised_tools()) return;
    bool cut = false, coag = false, live = false;
    for (int i = 0; i < snapshot_->tool_count; ++i) {
        const ToolSnapshot& tool = snapshot_->tools[static_cast<size_t>(i)];
        const bool both = (tool.pedals & (kPedalCut | kPedalCoag)) == (kPedalCut | kPedalCoag);
        cut = cut || (!both && (tool.pedals & kPedalCut) != 0);
        coag = coag || (!both && (tool.pedals & kPedalCoag) != 0);
        live = live || tool.energised != 0;
    }
    const double w = 6.0 * unit_, h = 2.0 * unit_;
    const auto lamp = [&](double y, bool on, const Colour& colour, const char* name, double power) {
        const double x = width_ - margin_ - w;
        paint_->box(x, y, w, h, on ? colour : kRaised);
        paint_->box(x, y, 0.3 * unit_, h, colour.faded(on ? 1.0F : 0.55F));
        paint_->text(x + 0.8 * unit_, y + 1.36 * unit_, say(name), TextSize::kSmall,
                     on ? kInk : kMuted);
        paint_->text(x + w - 0.5 * unit_, y + 1.36 * unit_, number(power, 0) + " W",
                     TextSize::kSmall, on ? kInk : kMuted, Align::kRight);
    };
    lamp(margin_, cut && live, kYellow, "CUT", state_->cut_power_w);
    lamp(margin_ + h + 0.4 * unit_, coag && live, kBlue, "COAG", state_->coag_power_w);
}

void Overlay::ring() {
    const PracticeGoal& goal = state_->practice.goal;
    if (practising()) {
        // Where small steps are practised, nobody cuts a ring.
        if (goal.step.kind != PracticeKind::kTrace) return;
        gauge(std::min(1.0, goal.progress), "ring", goal.traced);
        return;
    }
    if (!state_->practice.steps.empty()) return;  // before its first step is known
    const bool after_ring = snapshot_->phase == Phase::kResect || snapshot_->phase == Phase::kCheck;
    if (snapshot_->resected_fraction >= 0 && (after_ring || !energised_tools())) {
        gauge(static_cast<double>(std::min(1.0F, snapshot_->resected_fraction)), "out",
              snapshot_->resect_cut);
    } else if (energised_tools()) {
        gauge(static_cast<double>(snapshot_->cut_fraction), "ring", snapshot_->contour_cut);
    }
}

void Overlay::gauge(double share, const char* name, std::span<const uint8_t> done) {
    const double radius = 2.3 * unit_, x = width_ - margin_ - radius;
    const double room = 0.5 * width_ - circle_.radius - 2 * margin_;
    const double y = height_ - margin_ - radius - (room > 9 * unit_ ? 2.0 * unit_ : 0.0);
    paint_->ring(x, y, radius, 0.80, kLine);
    for (size_t i = 0; i < done.size(); ++i) {
        if (done[i] == 0) continue;
        // Drawn as the lesion lies in the picture: cranial (+x) up, left (+y) to the left.
        Vec2 direction[2];
        for (size_t e = 0; e < 2; ++e) {
            const double angle = 2 * 3.14159265358979 * static_cast<double>(i + e) /
                                 static_cast<double>(done.size());
            direction[e] = Vec2(-std::sin(angle), -std::cos(angle));
        }
        const Vec2 centre(x, y);
        paint_->quad({centre + radius * direction[0], centre + radius * direction[1],
                      centre + 0.80 * radius * direction[1], centre + 0.80 * radius * direction[0]},
                     kAccent);
    }
    paint_->text(x, y + 0.25 * unit_, number(std::floor(100.0 * share + 1e-4), 0) + " %",
                 TextSize::kNormal, kText, Align::kCentre);
    paint_->text(x, y + 1.25 * unit_, say(name), TextSize::kSmall, kMuted, Align::kCentre);
}

bool Overlay::energised_tools() const {
    const auto end = snapshot_->tools.begin() + snapshot_->tool_count;
    return std::any_of(snapshot_->tools.begin(), end,
                       [](const ToolSnapshot& tool) { return conducts(tool.kind); });
}

bool Overlay::place_of(const Vec3& mm, Vec2& px) const {
    const auto p = place_in_picture(*camera_, mm);
    if (!p || p->norm() > 1) return false;
    px = Vec2(circle_.x + circle_.radius * p->x(), circle_.y - circle_.radius * p->y());
    return true;
}

// One short phrase at the rim, on the side of the instrument; calm, gone after a few seconds.
void Overlay::warning() {
    const std::string_view message(snapshot_->message.data(),
                                   strnlen(snapshot_->message.data(), snapshot_->message.size()));
    constexpr double kHoldS = 2.0, kFadeS = 1.0;
    const double age = snapshot_->message_age_s;
    if (message.empty() || !state_->warnings || age > kHoldS + kFadeS) return;
    const auto alpha = static_cast<float>(std::clamp((kHoldS + kFadeS - age) / kFadeS, 0.0, 1.0));
    Vec2 direction(0, 1);
    for (int i = 0; i < snapshot_->tool_count; ++i) {
        const ToolSnapshot& tool = snapshot_->tools[static_cast<size_t>(i)];
        if (tool.kind == ToolKind::kScope) continue;
        const Vec3 d = 1000 * tool.pose.p - camera_->position_mm;
        const Vec2 seen(d.dot(camera_->right), -d.dot(camera_->up));
        if (seen.norm() > 1e-3) direction = seen.normalized();
        break;
    }
    const std::string text = say(message);
    const double w = paint_->text_width(text, TextSize::kNormal) + 1.6 * unit_, h = 2.0 * unit_;
    double x = circle_.x + 0.80 * circle_.radius * direction.x() - 0.5 * w;
    double y = circle_.y + 0.80 * circle_.radius * direction.y() - 0.5 * h;
    x = std::clamp(x, margin_, width_ - margin_ - w);
    y = std::clamp(y, margin_, height_ - margin_ - h);
    y = free_row(labels_, {x, y, w, h}, margin_, height_ - margin_, 0.15 * unit_);
    paint_->box(x, y, w, h, kRaised.faded(alpha));
    paint_->box(x, y, 0.25 * unit_, h, kWarn.faded(alpha));
    paint_->text(x + 0.9 * unit_, y + 1.35 * unit_, text, TextSize::kNormal, kText.faded(alpha));
}

void Overlay::help() {
    double keys = 0, texts = 0;
    for (const auto& [key, text] : state_->help) {
        keys = std::max(keys, paint_->text_width(with_keys(say(key)), TextSize::kSmall));
        texts = std::max(texts, paint_->text_width(say(text), TextSize::kSmall));
    }
    const double row = paint_->line_height(TextSize::kSmall) + 0.25 * unit_;
    const double w = keys + texts + 4.0 * unit_;
    const double foot = state_->help_waits ? 1.6 * unit_ : 0;
    const double h = row * static_cast<double>(state_->help.size()) + 3.6 * unit_ + foot;
    const double x = 0.5 * (width_ - w), y = 0.5 * (height_ - h);
    paint_->box(x, y, w, h, kRaised.faded(0.92F));
    paint_->text(x + 1.2 * unit_, y + 1.9 * unit_, say("Controls"), TextSize::kNormal, kText);
    double line = y + 1.9 * unit_ + 1.7 * unit_;
    for (const auto& [key, text] : state_->help) {
        paint_->text(x + 1.2 * unit_, line, with_keys(say(key)), TextSize::kSmall, kAccent);
        paint_->text(x + 2.4 * unit_ + keys, line, say(text), TextSize::kSmall, kText);
        line += row;
    }
    if (state_->help_waits)
        paint_->text(0.5 * width_, line + 0.9 * unit_,
                     say("The clock stands still. Space, Enter or a click goes on."),
                     TextSize::kSmall, kText, Align::kCentre);
}

}  // namespace placode::view
