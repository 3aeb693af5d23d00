// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the figures share: a linear scale, round tick marks, text. Private to reports.

#include <QPainter>
#include <vector>

#include "reports/report.h"
#include "reports/text.h"

namespace placode::reports {

/// Value to pixel.
struct LinearScale {
    double low = 0, high = 1, from_px = 0, to_px = 1;
    [[nodiscard]] double at(double value) const {
        return from_px + (value - low) / (high - low) * (to_px - from_px);
    }
};

/// About `count` round values from low to high.
[[nodiscard]] std::vector<double> round_ticks(double low, double high, int count);

/// What stands at a tick.
[[nodiscard]] QString tick_text(double tick);

/// Points as pages write them: with the tenth where there is one, so that a mark of 74.8 is not 75.
[[nodiscard]] QString points_text(double points);

/// Text in a rectangle; what is too long is shortened with an ellipsis.
void draw_text(QPainter& painter, const QRectF& where, int alignment, const QString& text, QRgb ink,
               double px, bool bold = false);

[[nodiscard]] double text_width(const QString& text, double px);

/// As many lines as fit, broken at words.
void draw_wrapped(QPainter& painter, const QRectF& where, int alignment, const QString& text,
                  QRgb ink, double px);

}  // namespace placode::reports
