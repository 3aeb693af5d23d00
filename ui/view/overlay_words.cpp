// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is written around the picture: clock, phase, title and goal at the left, keys at the foot, a
// banner, a short-lived note.
#include <algorithm>
#include <cmath>

#include "ui/view/overlay.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {

const char* phase_text(Phase phase) {
    switch (phase) {
        case Phase::kInspect:
            return "Inspect";
        case Phase::kIncise:
            return "Incise";
        case Phase::kRelease:
            return "Release";
        case Phase::kResect:
            return "Resect";
        case Phase::kCheck:
            return "Check";
    }
    return "";
}

}  // namespace

void Overlay::read_outs() {
    double y = margin_ + 1.6 * unit_;
    paint_->text(margin_, y, clock_text(snapshot_->time_s), TextSize::kLarge, kText);
    if (state_->time_limit_s > 0 && (state_->remaining || !state_->exam)) {
        const double x =
            margin_ + paint_->text_width(clock_text(snapshot_->time_s), TextSize::kLarge);
        // Rounded up: what is left is gone when it says 0:00.
        const double left = std::ceil(std::max(0.0, state_->time_limit_s - snapshot_->time_s));
        const std::string text = state_->remaining
                                     ? phrase("%1 left", clock_text(left))
                                     : say("of") + " " + clock_text(state_->time_limit_s);
        paint_->text(x + 0.5 * unit_, y, text, TextSize::kSmall, kMuted);
    }
    // The goal needs a wide window: it must not run into the picture.
    const double room = 0.5 * width_ - circle_.radius - 2 * margin_;
    if (!state_->exam)
        y = task_words(y, room);
    else if (practising())
        y = exam_steps(y, room);
    // Whether the attempt counts, and what the computer says, is no aid.
    text_foot_ = banner(y, room);
    notice(room);
}

double Overlay::task_words(double y, double room) {
    y += 1.9 * unit_;
    // The phases are those of the operation; exercises have steps.
    const bool operates =
        state_->practice.steps.empty() && (energised_tools() || snapshot_->resected_fraction >= 0);
    const char* phase = operates ? phase_text(snapshot_->phase) : "Practice";
    if (!state_->heading.empty()) {
        paint_->text(margin_, y, say(state_->heading), TextSize::kNormal, kAccent);
        if (operates) y += paint_->line_height(TextSize::kNormal);
    }
    if (state_->heading.empty() || operates)
        paint_->text(margin_, y, say(phase), TextSize::kNormal, kAccent);
    if (room > 9 * unit_) {
        y += 2.4 * unit_;
        for (const std::string& line : paint_->wrapped(state_->title, TextSize::kNormal, room)) {
            paint_->text(margin_, y, line, TextSize::kNormal, kText);
            y += paint_->line_height(TextSize::kNormal);
        }
        y += 0.3 * unit_;
        if (practising()) {
            y = practice_steps(y, room);
        } else {
            for (const std::string& line : paint_->wrapped(state_->goal, TextSize::kSmall, room)) {
                paint_->text(margin_, y, line, TextSize::kSmall, kMuted);
                y += paint_->line_height(TextSize::kSmall);
            }
        }
        keys();
    }
    if (practising() && room <= 9 * unit_) practice_line();
    return y;
}

/// Of the corner below the circle, clear of the note in the middle: one where there is room.
std::vector<std::string> Overlay::key_lines() const {
    return paint_->wrapped(say(state_->keys), TextSize::kSmall, 0.5 * width_ - 9 * unit_);
}

void Overlay::keys() {
    const std::vector<std::string> lines = key_lines();
    double y = height_ - margin_;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        paint_->text(width_ - margin_, y, *line, TextSize::kSmall, kMuted.faded(0.7F),
                     Align::kRight);
        y -= paint_->line_height(TextSize::kSmall);
    }
}

double Overlay::banner(double y, double room) {
    if (state_->banner.empty()) return y;
    const std::string text = say(state_->banner);
    const double w = paint_->text_width(text, TextSize::kSmall) + 1.2 * unit_;
    const double x = room > 9 * unit_ ? margin_ : 0.5 * (width_ - w);
    const double top = room > 9 * unit_ ? y + 0.6 * unit_ : height_ - margin_ - 1.0 * unit_;
    paint_->box(x, top, w, 1.5 * unit_, kRaised);
    paint_->text(x + 0.6 * unit_, top + 1.05 * unit_, text, TextSize::kSmall, kWarn);
    return room > 9 * unit_ ? top + 1.5 * unit_ : y;
}

void Overlay::notice(double room) {
    if (state_->notice.empty()) return;
    // Above the banner where that one stands in the middle.
    const bool crowded = !state_->banner.empty() && room <= 9 * unit_;
    double foot = height_ - (crowded ? margin_ + 1.5 * unit_ : 1.6 * margin_);
    // And above the step where that one does.
    if (practising() && room <= 9 * unit_) foot = std::min(foot, foot_top_ - unit_);
    // In the middle, and no wider than what the keys in the corner leave.
    double keys = 0;
    for (const std::string& line : key_lines())
        keys = std::max(keys, paint_->text_width(line, TextSize::kSmall));
    const double most = std::max(width_ - 2 * (keys + margin_ + unit_), 14 * unit_);
    const std::vector<std::string> lines =
        paint_->wrapped(say(state_->notice), TextSize::kNormal, most - 1.6 * unit_);
    double w = 0;
    for (const std::string& line : lines)
        w = std::max(w, paint_->text_width(line, TextSize::kNormal) + 1.6 * unit_);
    const double row = paint_->line_height(TextSize::kNormal);
    const double above = row * static_cast<double>(lines.size() - 1);
    paint_->box(0.5 * (width_ - w), foot - above - 1.35 * unit_, w, above + 2.0 * unit_,
                kRaised.faded(0.85F));
    double y = foot - above;
    for (const std::string& line : lines) {
        paint_->text(0.5 * width_, y, line, TextSize::kNormal, kText, Align::kCentre);
        y += row;
    }
}

}  // namespace placode::view
