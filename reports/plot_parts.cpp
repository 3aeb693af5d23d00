// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/plot_parts.h"

#include <QFontMetricsF>
#include <cmath>

#include "reports/words.h"

namespace placode::reports {
namespace {

QFont font_of(double px, bool bold) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(static_cast<int>(std::lround(px)));
    font.setBold(bold);
    // Switches ligatures off: with them a search in the PDF finds nothing.
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    return font;
}

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
    const double raw = (high - low) / std::max(1, count);
    const double power = std::pow(10, std::floor(std::log10(raw)));
    double step = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        step = factor * power;
        if (step >= raw) break;
    }
    std::vector<double> ticks;
    double tick = std::ceil(low / step - 1e-9) * step;
    while (tick <= high + 1e-9 * step) {
        ticks.push_back(std::abs(tick) < 1e-9 * step ? 0 : tick);
        tick += step;
    }
    return ticks;
}

QString points_text(double points) {
    return with_spoken_sign(number(points, std::lround(points * 10) % 10 == 0 ? 0 : 1));
}

QString tick_text(double tick) { return with_spoken_sign(QString::number(tick, 'g', 4)); }

void draw_text(QPainter& painter, const QRectF& where, int alignment, const QString& text, QRgb ink,
               double px, bool bold) {
    const QFont font = font_of(px, bold);
    painter.setFont(font);
    painter.setPen(QColor::fromRgba(ink));
    painter.drawText(where, alignment | Qt::TextSingleLine,
                     QFontMetricsF(font).elidedText(text, Qt::ElideRight, where.width() + 1));
}

double text_width(const QString& text, double px) {
    return QFontMetricsF(font_of(px, false)).horizontalAdvance(text);
}

void draw_wrapped(QPainter& painter, const QRectF& where, int alignment, const QString& text,
                  QRgb ink, double px) {
    painter.setFont(font_of(px, false));
    painter.setPen(QColor::fromRgba(ink));
    painter.drawText(where, alignment | Qt::TextWordWrap, text);
}

}  // namespace placode::reports
