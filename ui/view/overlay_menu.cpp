// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What stands over the picture while it rests: the pause menu, a question, the wait for the first
// motion; and the ring that fills while Enter is held.

#include <algorithm>

#include "ui/view/overlay.h"
#include "ui/view/overlay_colours.h"

namespace placode::view {

using namespace sim;

void Overlay::menu() {
    const MenuOverlay& menu = state_->menu;
    menu_row_ = 2.8 * unit_;
    menu_width_ = std::min(26 * unit_, width_ - 2 * margin_);
    const double inner = menu_width_ - 2.8 * unit_, row = paint_->line_height(TextSize::kSmall);
    std::vector<std::string> lines;
    for (const std::string& line : menu.lines)
        for (const std::string& part : paint_->wrapped(line, TextSize::kSmall, inner))
            lines.push_back(part);
    const double text = lines.empty() ? 0 : row * static_cast<double>(lines.size()) + 0.8 * unit_;
    const double items = menu_row_ * static_cast<double>(menu.items.size());
    const std::vector<std::string> title = paint_->wrapped(menu.title, TextSize::kLarge, inner);
    const double title_row = paint_->line_height(TextSize::kLarge);
    const double more = title_row * std::max(0.0, static_cast<double>(title.size()) - 1);
    const double h = 4.2 * unit_ + more + text + items + 2.2 * unit_;
    const double x = 0.5 * (width_ - menu_width_), y = 0.5 * (height_ - h);
    paint_->box(x, y, menu_width_, h, kRaised);
    for (size_t i = 0; i < title.size(); ++i)
        paint_->text(x + 1.4 * unit_, y + 2.6 * unit_ + title_row * static_cast<double>(i),
                     title[i], TextSize::kLarge, kText);
    double line_y = y + 4.4 * unit_ + more;
    for (const std::string& line : lines) {
        paint_->text(x + 1.4 * unit_, line_y, line, TextSize::kSmall, kText);
        line_y += row;
    }
    menu_x_ = x;
    menu_y_ = y + 4.2 * unit_ + more + text;
    menu_count_ = static_cast<int>(menu.items.size());
    for (size_t i = 0; i < menu.items.size(); ++i) {
        const double top = menu_y_ + static_cast<double>(i) * menu_row_;
        const bool selected = static_cast<int>(i) == menu.selected;
        if (selected)
            paint_->box(x + 0.6 * unit_, top, menu_width_ - 1.2 * unit_, menu_row_ - 0.3 * unit_,
                        kAccent);
        paint_->text(x + 1.4 * unit_, top + 1.65 * unit_, menu.items[i], TextSize::kNormal,
                     selected ? kInk : kText);
    }
    paint_->text(x + 1.4 * unit_, y + h - 0.9 * unit_, say("Arrows and Enter, or the mouse"),
                 TextSize::kSmall, kMuted);
}

int Overlay::menu_item_at(double x, double y) const {
    if (!menu_shown_ || x < menu_x_ || x > menu_x_ + menu_width_ || y < menu_y_) return -1;
    const int item = static_cast<int>((y - menu_y_) / menu_row_);
    return item < menu_count_ ? item : -1;
}

void Overlay::hold_ring() {
    const double radius = 2.2 * unit_, x = 0.5 * width_, y = height_ - margin_ - 4.4 * unit_;
    const double w = 16 * unit_;
    paint_->box(x - 0.5 * w, y - radius - 0.8 * unit_, w, 2 * radius + 3.2 * unit_, kRaised);
    paint_->ring(x, y, radius, 0.82, kLine);
    constexpr int kParts = 48;
    for (int i = 0; i < static_cast<int>(kParts * std::clamp(state_->holding, 0.0, 1.0)); ++i) {
        Vec2 edge[2];
        for (int e = 0; e < 2; ++e) {
            const double angle = 2 * 3.14159265358979 * (i + e) / kParts;
            edge[e] = Vec2(std::sin(angle), -std::cos(angle));
        }
        const Vec2 centre(x, y);
        paint_->quad({centre + radius * edge[0], centre + radius * edge[1],
                      centre + 0.82 * radius * edge[1], centre + 0.82 * radius * edge[0]},
                     kAccent);
    }
    paint_->text(x, y + radius + 1.5 * unit_, say("Hold Enter to finish"), TextSize::kNormal, kText,
                 Align::kCentre);
}

void Overlay::waiting() {
    const std::string text = say("The clock starts with your first motion");
    const double w = paint_->text_width(text, TextSize::kNormal) + 2.4 * unit_, h = 2.4 * unit_;
    const double x = 0.5 * (width_ - w),
                 y = std::min(height_ - margin_ - 6.5 * unit_, foot_top_ - h - 0.4 * unit_);
    foot_top_ = y;
    paint_->box(x, y, w, h, kRaised.faded(0.9F));
    paint_->text(0.5 * width_, y + 1.55 * unit_, text, TextSize::kNormal, kText, Align::kCentre);
}

}  // namespace placode::view
