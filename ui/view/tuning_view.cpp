// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/tuning_view.h"

#include <algorithm>
#include <tuple>

#include "ui/view/overlay_colours.h"

namespace placode::view {

using namespace sim;

/// Label, and the value between its two buttons; or one button as wide as the panel.
void TuningView::draw_row(TextPainter& paint, const TuningRow& r, const Hit& place, bool selected,
                          double unit) {
    const auto& [x, y, w, row, item] = place;
    const double pad = 1.0 * unit, button = 1.9 * unit;
    if (selected) paint.box(x + 0.3 * unit, y, 0.25 * unit, row - 0.3 * unit, kAccent);
    const double base = y + 1.25 * unit;
    if (r.button) {
        paint.box(x + pad, y, w - 2 * pad, row - 0.3 * unit,
                  selected ? kAccent.faded(0.35F) : kLine);
        paint.text(x + 0.5 * w, base, r.label, TextSize::kSmall, kText, Align::kCentre);
    } else {
        paint.text(x + pad, base, r.label, TextSize::kSmall, selected ? kText : kMuted);
        const double more = x + w - pad - button, less = more - button - 7.6 * unit;
        for (const auto& [at, sign, part] :
             {std::tuple{less, "\xE2\x88\x92", kTuningLess}, {more, "+", kTuningMore}}) {
            paint.box(at, y, button, row - 0.3 * unit, kLine);
            paint.text(at + 0.5 * button, base, sign, TextSize::kNormal, kText, Align::kCentre);
            hits_.push_back({at, y, button, row, item + part});
        }
        paint.text(0.5 * (less + button + more), base, r.value, TextSize::kSmall,
                   r.changed ? kWarn : kText, Align::kCentre);
    }
}

void TuningView::draw(TextPainter& paint, const TuningOverlay& panel, double width, double height,
                      double unit) {
    hits_.clear();
    if (!panel.shown) return;
    const double w = 21 * unit, row = 2.1 * unit, pad = 1.0 * unit;
    const std::vector<std::string> foot = paint.wrapped(panel.foot, TextSize::kSmall, w - 2 * pad);
    const double foot_h =
        static_cast<double>(foot.size()) * paint.line_height(TextSize::kSmall) + 0.8 * unit;
    const std::vector<std::string> note = paint.wrapped(panel.note, TextSize::kSmall, w - 2 * pad);
    const double note_h =
        panel.note.empty()
            ? 0
            : static_cast<double>(note.size()) * paint.line_height(TextSize::kSmall) + 0.4 * unit;
    double gaps = 0;
    for (const TuningRow& r : panel.rows) gaps += r.gap_above ? 0.6 * unit : 0;
    const double h =
        3.0 * unit + note_h + row * static_cast<double>(panel.rows.size()) + gaps + foot_h;
    const double x = width - w - 1.1 * unit;
    const double top = std::max(0.5 * unit, std::min(6.4 * unit, height - h - 0.5 * unit));
    paint.box(x, top, w, h, kRaised);
    paint.text(x + pad, top + 1.9 * unit, panel.title, TextSize::kNormal, kText);
    double y = top + 3.4 * unit;
    for (const std::string& line : panel.note.empty() ? std::vector<std::string>() : note) {
        paint.text(x + pad, y, line, TextSize::kSmall, kWarn);
        y += paint.line_height(TextSize::kSmall);
    }
    y = top + 3.0 * unit + note_h;
    for (size_t i = 0; i < panel.rows.size(); ++i) {
        const TuningRow& r = panel.rows[i];
        const int item = kTuningParts * static_cast<int>(i);
        if (r.gap_above) {
            paint.box(x + pad, y + 0.25 * unit, w - 2 * pad, 1, kLine);
            y += 0.6 * unit;
        }
        hits_.push_back({x, y, w, row, item + kTuningWhole});
        draw_row(paint, r, {x, y, w, row, item}, static_cast<int>(i) == panel.selected, unit);
        y += row;
    }
    y += 0.9 * unit;
    for (const std::string& line : foot) {
        paint.text(x + pad, y, line, TextSize::kSmall, panel.warn ? kWarn : kMuted);
        y += paint.line_height(TextSize::kSmall);
    }
}

int TuningView::item_at(double x, double y) const {
    for (auto hit = hits_.rbegin(); hit != hits_.rend(); ++hit)
        if (x >= hit->x && x < hit->x + hit->w && y >= hit->y && y < hit->y + hit->h)
            return hit->item;
    return -1;
}

}  // namespace placode::view
