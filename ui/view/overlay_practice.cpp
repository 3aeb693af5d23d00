// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The list of a practice task's steps: beside the picture where there is room, else the present one
// at its foot.

#include <algorithm>
#include <numeric>

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

bool Overlay::practising() const {
    const PracticeOverlay& practice = state_->practice;
    return !practice.steps.empty() && practice.goal.count > 0;
}

// Drawn: not every font has one.
void Overlay::tick(double x, double y) {
    const double u = 0.62 * unit_, width = 0.17 * unit_;
    const Vec2 a(x, y), b(x + 0.38 * u, y + 0.38 * u), c(x + 1.1 * u, y - 0.62 * u);
    shapes::stroke(*paint_, a, b, width, kGood);
    shapes::stroke(*paint_, b, c, width, kGood);
}

/// How much of the present step is done, in its unit; empty where only done counts.
std::string Overlay::amount_text() const {
    const StepAmount amount = step_amount(state_->practice.goal);
    if (amount.whole <= 0) return {};
    const PracticeKind kind = state_->practice.goal.step.kind;
    if (kind == PracticeKind::kTrace || kind == PracticeKind::kPatchLay || is_wash_step(kind) ||
        kind == PracticeKind::kUndermine)
        return number(amount.done, amount.digits) + amount.unit;
    return number(amount.done, amount.digits) + " " + say("of") + " " +
           number(amount.whole, amount.digits) + amount.unit;
}

bool Overlay::wrong_hand() const {
    const PracticeOverlay& practice = state_->practice;
    if (!practising() || practice.in_hand < 0 || practice.goal.step.hand == Hand::kCamera)
        return false;
    // The exercise with both hands is done with one after the other.
    if (practice.goal.step.kind == PracticeKind::kTraction) return false;
    const int wanted = goal_tool();
    return wanted >= 0 && wanted != practice.in_hand;
}

/// In an exam the steps are said, without hints: they are what is asked for.
double Overlay::exam_steps(double y, double room) {
    if (room > 9 * unit_) return practice_steps(y + 1.9 * unit_, room);
    practice_line();
    return y;
}

std::string Overlay::hint_text() const {
    const PracticeOverlay& practice = state_->practice;
    const auto now = static_cast<size_t>(practice.goal.index);
    if (now >= practice.steps.size() || state_->exam) return {};
    const PracticeOverlay::Step& step = practice.steps[now];
    // A step for the other hand says it itself.
    if (!wrong_hand() || step.changes_hand) return step.hint;
    const auto wanted = static_cast<size_t>(goal_tool());
    return with_keys(phrase("Tab: back to the %1", say(tool_word(snapshot_->tools[wanted].kind))));
}

/// Height of a step in the list; how to do it and how much is done stand below the present one.
double Overlay::step_height(int step, double room) {
    const PracticeOverlay& practice = state_->practice;
    const double row = paint_->line_height(TextSize::kSmall);
    const auto lines = [&](const std::string& text) {
        return static_cast<double>(paint_->wrapped(text, TextSize::kSmall, room).size());
    };
    const double h = lines(practice.steps[static_cast<size_t>(step)].text) * row + 0.2 * unit_;
    return step == practice.goal.index ? h + lines(hint_text()) * row + 0.9 * unit_ : h;
}

/// First step that is listed, and the one behind the last, above the bars of force: the present
/// one, then what comes next, then what is done.
std::pair<int, int> Overlay::listed_steps(double y, double room) {
    const int count = static_cast<int>(state_->practice.steps.size());
    const int now = std::min(state_->practice.goal.index, count - 1);
    const double row = paint_->line_height(TextSize::kSmall) + 0.2 * unit_;
    std::vector<double> heights;
    heights.reserve(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) heights.push_back(step_height(i, room));
    double height = std::accumulate(heights.begin(), heights.end(), 0.0);
    int first = 0, last = count;
    const auto is_too_high = [&] {
        return y - 0.75 * unit_ + height + (first > 0 ? row : 0) + (last < count ? row : 0) >
               bars_top_;
    };
    while (is_too_high() && first < now) height -= heights[static_cast<size_t>(first++)];
    while (is_too_high() && last > now + 1) height -= heights[static_cast<size_t>(--last)];
    return {first, last};
}

/// How to do the present step, and how much of it is done. Returns where the next line stands.
double Overlay::present_step(double y, double room) {
    const double indent = 1.3 * unit_, row = paint_->line_height(TextSize::kSmall);
    for (const std::string& line : paint_->wrapped(hint_text(), TextSize::kSmall, room - indent)) {
        paint_->text(margin_ + indent, y, line, TextSize::kSmall, kAccent);
        y += row;
    }
    const std::string amount = amount_text();
    const double text = paint_->text_width(amount, TextSize::kSmall);
    const double w = room - indent - (text > 0 ? text + 0.6 * unit_ : 0);
    paint_->box(margin_ + indent, y - 0.6 * unit_, w, 0.25 * unit_, kLine);
    paint_->box(margin_ + indent, y - 0.6 * unit_,
                w * std::clamp(state_->practice.goal.progress, 0.0, 1.0), 0.25 * unit_, kAccent);
    paint_->text(margin_ + room, y - 0.2 * unit_, amount, TextSize::kSmall, kText, Align::kRight);
    return y + 0.9 * unit_;
}

// The list of steps, each ticked off when it is done. What finds no room is counted.
double Overlay::practice_steps(double y, double room) {
    const PracticeOverlay& practice = state_->practice;
    const int now = practice.goal.index, count = static_cast<int>(practice.steps.size());
    const double indent = 1.3 * unit_, row = paint_->line_height(TextSize::kSmall);
    const auto write = [&](const std::string& line, const Colour& colour) {
        paint_->text(margin_ + indent, y, line, TextSize::kSmall, colour);
        y += row;
    };
    const auto [first, last] = listed_steps(y, room - indent);
    if (first > 0) {
        tick(margin_ + 0.1 * unit_, y - 0.35 * unit_);
        write(phrase("%1 done", std::to_string(first)), kMuted);
        y += 0.2 * unit_;
    }
    for (int i = first; i < last; ++i) {
        if (i < now) tick(margin_ + 0.1 * unit_, y - 0.35 * unit_);
        if (i == now) paint_->box(margin_, y - 0.75 * unit_, 0.25 * unit_, unit_, kAccent);
        for (const std::string& line : paint_->wrapped(practice.steps[static_cast<size_t>(i)].text,
                                                       TextSize::kSmall, room - indent))
            write(line, i == now ? kText : kMuted);
        if (i == now) y = present_step(y, room);
        y += 0.2 * unit_;
    }
    if (last < count) write(phrase("%1 more", std::to_string(count - last)), kMuted);
    return y;
}

// No room beside the picture: the present step alone, at the foot.
void Overlay::practice_line() {
    const PracticeOverlay& practice = state_->practice;
    const int now = practice.goal.index;
    if (now >= static_cast<int>(practice.steps.size())) return;
    const PracticeOverlay::Step& step = practice.steps[static_cast<size_t>(now)];
    const std::string amount = amount_text();
    const std::string text = std::to_string(now + 1) + "/" + std::to_string(practice.steps.size()) +
                             "  " + step.text + (amount.empty() ? "" : "   " + amount);
    const double most = width_ - 2 * margin_ - 1.6 * unit_;
    std::vector<std::string> lines = paint_->wrapped(text, TextSize::kSmall, most);
    const size_t first = lines.size();
    for (std::string& line : paint_->wrapped(hint_text(), TextSize::kSmall, most))
        lines.push_back(std::move(line));
    double widest = 0;
    for (const std::string& line : lines)
        widest = std::max(widest, paint_->text_width(line, TextSize::kSmall));
    const double row = paint_->line_height(TextSize::kSmall), w = widest + 1.6 * unit_;
    const double h = static_cast<double>(lines.size()) * row + 0.8 * unit_;
    const double x = 0.5 * (width_ - w), y = height_ - h - 3.2 * unit_;
    paint_->box(x, y, w, h, kRaised.faded(0.85F));
    for (size_t i = 0; i < lines.size(); ++i)
        paint_->text(0.5 * width_, y + 1.2 * unit_ + static_cast<double>(i) * row, lines[i],
                     TextSize::kSmall, i < first ? kText : kAccent, Align::kCentre);
    paint_->box(x, y + h - 0.2 * unit_, w * std::clamp(practice.goal.progress, 0.0, 1.0),
                0.2 * unit_, kAccent);
    foot_top_ = y;
}

}  // namespace placode::view
