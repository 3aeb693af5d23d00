// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Contrasting groups: the scores of both as points under their normal curves, the cut between them.

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/attempt_figures.h"
#include "reports/plot_parts.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

double density(double x, double mean, double sd) {
    const double z = (x - mean) / sd;
    return std::exp(-0.5 * z * z) / (sd * std::sqrt(2 * std::numbers::pi));
}

}  // namespace

void draw_groups(QPainter& painter, const QRectF& where,
                 const assessment::ContrastingGroups& result, const std::vector<double>& novices,
                 const std::vector<double>& experts, const ChartStyle& style) {
    const double px = style.font_px;
    const QRectF plot = where.adjusted(22, 2 * px, -22, -6.5 * px);
    if (plot.width() < 60 || plot.height() < 40) return;
    const LinearScale x{0, 100, plot.left(), plot.right()};
    const double top = std::max(density(result.mean_novice, result.mean_novice, result.sd_novice),
                                density(result.mean_expert, result.mean_expert, result.sd_expert));
    const LinearScale y{0, 1.08 * top, plot.bottom(), plot.top()};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    const auto draw = [&](double mean, double sd, const std::vector<double>& values, unsigned ink,
                          Qt::PenStyle dash, double row, const QString& name) {
        QPainterPath path;
        for (int i = 0; i <= 200; ++i) {
            const double score = 0.5 * i;
            const QPointF p(x.at(score), y.at(density(score, mean, sd)));
            i == 0 ? path.moveTo(p) : path.lineTo(p);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour(ink), 2, dash));
        painter.drawPath(path);
        painter.setPen(QPen(colour(ink), 1.5));
        for (const double value : values)
            painter.drawEllipse(QPointF(x.at(value), plot.bottom() + row), 4, 4);
        draw_text(painter, QRectF(x.at(mean) - 90, where.top(), 180, 1.5 * px), Qt::AlignHCenter,
                  QString("%1 (n = %2)").arg(name).arg(values.size()), ink, px, true);
    };
    draw(result.mean_novice, result.sd_novice, novices, style.warn, Qt::DashLine, 1.1 * px,
         figure_word("novices"));
    draw(result.mean_expert, result.sd_expert, experts, style.accent, Qt::SolidLine, 2.3 * px,
         figure_word("experts"));
    painter.setPen(QPen(colour(style.line), 1));
    painter.drawLine(plot.bottomLeft(), plot.bottomRight());
    for (int tick = 0; tick <= 100; tick += 20)
        draw_text(painter, QRectF(x.at(tick) - 20, plot.bottom() + 3 * px, 40, 1.4 * px),
                  Qt::AlignHCenter, QString::number(tick), style.muted, px);
    draw_text(painter, QRectF(plot.left(), plot.bottom() + 4.5 * px, plot.width(), 1.5 * px),
              Qt::AlignHCenter, figure_word("score [points of 100]"), style.muted, px);
    const double cut = x.at(result.cut_score);
    painter.setPen(QPen(colour(style.text), 2));
    painter.drawLine(QPointF(cut, plot.top() - 2), QPointF(cut, plot.bottom() + 2.8 * px));
    draw_text(painter, QRectF(cut - 166, plot.top() + px, 160, 1.5 * px), Qt::AlignRight,
              figure_word("cut at %1").arg(spoken().toString(result.cut_score, 'f', 1)), style.text,
              px, true);
    painter.restore();
}

}  // namespace placode::reports
