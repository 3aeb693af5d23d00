// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured while operating, at the rim: a bar of force for each hand, and on demand how the
// machine keeps up.

#include <algorithm>
#include <cmath>

#include "ui/view/overlay.h"
#include "ui/view/overlay_style.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {}  // namespace

const char* tool_word(ToolKind kind) {
    switch (kind) {
        case ToolKind::kScope:
            return "scope";
        case ToolKind::kNeedle:
            return "needle";
        case ToolKind::kHook:
            return "hook";
        case ToolKind::kGrasper:
            return "grasper";
        case ToolKind::kScissors:
            return "scissors";
        case ToolKind::kProbe:
            return "probe";
        case ToolKind::kNeedleDriver:
            return "needle driver";
        case ToolKind::kIrrigator:
            return "irrigator";
    }
    return "";
}

namespace {

double force_of(const ToolSnapshot& tool) {
    return std::hypot(tool.force_n[0], tool.force_n[1], tool.force_n[2]);
}

/// Window devices move one instrument at a time; the others stand where they were left.
bool has_one_hand(haptics::HintDevice device) {
    return device == haptics::HintDevice::kMouse || device == haptics::HintDevice::kKeyboard ||
           device == haptics::HintDevice::kGamepad;
}

}  // namespace

/// Which instruments have a bar: what is in the field, one for each hand. With a single hand only
/// the one that touches, or else the one it is about: an idle bar would be a riddle.
std::array<int, kMaxTools> Overlay::force_tools(int& count) const {
    std::array<int, kMaxTools> all{}, touching{};
    int here = 0, held = 0;
    for (int i = 0; i < snapshot_->tool_count; ++i) {
        const ToolSnapshot& tool = snapshot_->tools[static_cast<size_t>(i)];
        if (tool.kind == ToolKind::kScope || tool.engaged == 0) continue;
        all[static_cast<size_t>(here++)] = i;
        constexpr double kFeltN = 1e-4;
        if (tool.in_contact != 0 || tool.buried_m > 0 || force_of(tool) > kFeltN)
            touching[static_cast<size_t>(held++)] = i;
    }
    const bool both = practising() && state_->practice.goal.step.kind == PracticeKind::kTraction;
    if (!has_one_hand(state_->practice.device) || both || here <= 1) {
        count = here;
        return all;
    }
    if (held > 0) {
        count = held;
        return touching;
    }
    const int in_hand = state_->practice.in_hand;
    const int about = in_hand >= 0 && in_hand < snapshot_->tool_count ? in_hand
                      : practising()                                  ? goal_tool()
                                                                      : -1;
    if (about >= 0 && snapshot_->tools[static_cast<size_t>(about)].engaged != 0) all[0] = about;
    count = 1;
    return all;
}

void Overlay::force() {
    int count = 0, instruments = 0;
    const std::array<int, kMaxTools> tools = force_tools(count);
    for (int i = 0; i < snapshot_->tool_count; ++i)
        instruments += snapshot_->tools[static_cast<size_t>(i)].kind != ToolKind::kScope ? 1 : 0;
    double y = height_ - margin_ - 0.5 * unit_;
    for (int i = count - 1; i >= 0; --i) {
        force_bar(tools[static_cast<size_t>(i)], y, instruments > 1);
        y -= 2.4 * unit_;
    }
    bars_top_ = y + 0.9 * unit_;
}

void Overlay::force_bar(int which, double y, bool named) {
    const ToolSnapshot& tool = snapshot_->tools[static_cast<size_t>(which)];
    const double w = 7.0 * unit_, h = 0.5 * unit_;
    const double f = force_of(tool);
    const PracticeStep& step = state_->practice.goal.step;
    const bool band = practising() && (step.kind == PracticeKind::kTraction ||
                                       (step.kind == PracticeKind::kThreadDraw && step.low_n > 0));
    const double full = band ? 1.6 * step.high_n : state_->full_force_n;
    const double share = std::clamp(f / std::max(full, 1e-6), 0.0, 1.0);
    Colour colour = share > 0.85 ? kCritical : share > 0.5 ? kWarn : kGood;
    if (band) colour = f > step.high_n ? kCritical : f < step.low_n ? kMuted : kGood;
    paint_->box(margin_, y, w, h, kRaised);
    if (band) {  // where both hands have to stand
        const double from = w * step.low_n / full, to = w * step.high_n / full;
        paint_->box(margin_ + from, y - 0.15 * unit_, to - from, h + 0.3 * unit_,
                    kGood.faded(0.35F));
    }
    paint_->box(margin_, y, w * share, h, colour);
    // Pushed through the surface it has no force; a 0 would look like success.
    const bool below = tool.buried_m > 0;
    const std::string name =
        say("force") + (named ? ", " + say(tool_word(tool.kind)) : std::string());
    paint_->text(margin_, y - 0.5 * unit_,
                 name + "  " + (below ? say("stuck") : number(1000 * f, 0) + " mN"),
                 TextSize::kSmall, below ? kWarn : kMuted);
}

// Below the text at the left where there is room, else at the right, else in the middle: never
// over what is to be read.
void Overlay::performance() {
    const std::string lines[] = {
        "physics " + number(snapshot_->physics_hz, 0) + " Hz, " +
            std::to_string(snapshot_->substeps) + " substeps",
        "picture " + number(times_->mean_ms > 0 ? 1000 / times_->mean_ms : 0, 0) + " fps, p99 " +
            number(times_->p99_ms, 0) + " ms",
        "scale " + number(times_->render_scale, 2) + ", " + std::to_string(times_->samples) +
            " samples" + (times_->plain ? ", plain" : ""),
        "servo p99.9 " + number(snapshot_->servo_p999_us, 0) + " us",
        "placode " + number(snapshot_->placode_peak_c, 1) + " C, CEM43 " +
            number(snapshot_->placode_peak_cem43_min, 2) + " min",
        times_->renderer};
    const double row = 1.4 * unit_, gap = 1.6 * unit_;
    const double h = row * static_cast<double>(std::size(lines));
    double widest = 0;
    for (const std::string& line : lines)
        widest = std::max(widest, paint_->text_width(line, TextSize::kSmall));
    double x = margin_, y = text_foot_ + gap;
    if (y + h > bars_top_) {
        const double lamps = margin_ + 4.4 * unit_;
        x = state_->tuning.shown ? 0.5 * (width_ - widest) : width_ - margin_ - widest;
        y = state_->tuning.shown ? margin_ + unit_ : lamps + gap;
    }
    for (const std::string& line : lines) {
        const double w = paint_->text_width(line, TextSize::kSmall);
        paint_->box(x - 0.4 * unit_, y - 1.0 * unit_, w + 0.8 * unit_, row, kRaised.faded(0.8F));
        paint_->text(x, y, line, TextSize::kSmall, kText);
        y += row;
    }
}

}  // namespace placode::view
