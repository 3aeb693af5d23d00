// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Diverging stacked bars of Likert items, with the middle of the scale in the middle.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "reports/csv_table.h"
#include "reports/figure.h"
#include "reports/palette.h"
#include "reports/plot_parts.h"

namespace placode::reports {
namespace {

bool is_dark(const QColor& colour) { return qGray(colour.rgb()) < 140; }

/// Share of the answers left of the middle of the scale; half of the middle value counts.
double share_left(const LikertBar& bar, double n) {
    const size_t width = bar.counts.size();
    double left = 0;
    for (size_t i = 0; i < width; ++i) {
        const double weight = 2 * i + 1 < width ? 1 : 2 * i + 1 == width ? 0.5 : 0;
        left += weight * bar.counts[i];
    }
    return n > 0 ? left / n : 0;
}

struct Layout {
    QRectF plot;
    LinearScale x;
    double row = 34;
};

void draw_bar(QPainter& painter, const LikertBar& bar, const Layout& layout, double y,
              const ChartStyle& style) {
    const double n = std::accumulate(bar.counts.begin(), bar.counts.end(), 0.0);
    double at = -100 * share_left(bar, n);
    for (size_t i = 0; i < bar.counts.size() && n > 0; ++i) {
        if (bar.counts[i] == 0) continue;
        const double share = 100 * bar.counts[i] / n;
        const QRectF cell(QPointF(layout.x.at(at), y + 5),
                          QPointF(layout.x.at(at + share), y + layout.row - 5));
        const QColor fill = scale_colour(i, bar.counts.size());
        painter.setPen(QPen(QColor::fromRgba(style.surface), 1));
        painter.setBrush(fill);
        painter.drawRect(cell);
        if (cell.width() > 14)
            draw_text(painter, cell, Qt::AlignCenter, QString::number(bar.counts[i]),
                      is_dark(fill) ? 0xffffffff : style.text, 11);
        at += share;
    }
}

void draw_key(QPainter& painter, const LikertBar& bar, const QRectF& where,
              const ChartStyle& style) {
    const size_t width = bar.counts.size();
    const double box = 14, gap = 30;
    double x = where.center().x() - 0.5 * static_cast<double>(width) * gap;
    draw_text(painter, QRectF(where.left(), where.top(), x - where.left() - 8, 16),
              Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(bar.low), style.muted, 11);
    for (size_t i = 0; i < width; ++i, x += gap) {
        painter.setPen(QPen(QColor::fromRgba(style.muted), 0.5));
        painter.setBrush(scale_colour(i, width));
        painter.drawRect(QRectF(x, where.top() + 1, box, box));
        draw_text(painter, QRectF(x + box + 2, where.top(), gap - box, 16),
                  Qt::AlignLeft | Qt::AlignVCenter,
                  QString::number(bar.scale_min + static_cast<int>(i)), style.text, 11);
    }
    draw_text(painter, QRectF(x + 4, where.top(), where.right() - x, 16),
              Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(bar.high), style.muted, 11);
}

void draw_axis(QPainter& painter, const Layout& layout, const ChartStyle& style) {
    for (const double tick : {-100.0, -50.0, 0.0, 50.0, 100.0}) {
        const double x = layout.x.at(tick);
        painter.setPen(
            QPen(QColor::fromRgba(tick == 0 ? style.muted : style.line), tick == 0 ? 1.2 : 0.8));
        painter.drawLine(QPointF(x, layout.plot.top()), QPointF(x, layout.plot.bottom()));
        draw_text(painter, QRectF(x - 30, layout.plot.bottom() + 2, 60, 14), Qt::AlignCenter,
                  QString::number(std::abs(tick)), style.muted, 11);
    }
    draw_text(painter,
              QRectF(layout.plot.left(), layout.plot.bottom() + 16, layout.plot.width(), 14),
              Qt::AlignCenter, QStringLiteral("share of the answers [%], middle of the scale at 0"),
              style.muted, 11);
}

std::string data_of(const std::vector<LikertBar>& bars) {
    std::string text = csv_line({"item", "question", "value", "count", "n", "missing"});
    for (const LikertBar& bar : bars) {
        const int n = std::accumulate(bar.counts.begin(), bar.counts.end(), 0);
        for (size_t i = 0; i < bar.counts.size(); ++i)
            text += csv_line({harmless(bar.id), harmless(bar.label),
                              std::to_string(bar.scale_min + static_cast<int>(i)),
                              std::to_string(bar.counts[i]), std::to_string(n),
                              std::to_string(bar.missing)});
    }
    return text;
}

void draw_figure(QPainter& painter, const QRectF& where, const std::vector<LikertBar>& bars,
                 const ChartStyle& style) {
    constexpr double kLabel = 250, kRight = 118, kKey = 26, kFoot = 34;
    Layout layout;
    layout.plot = where.adjusted(kLabel, kKey, -kRight, -kFoot);
    layout.row = layout.plot.height() / static_cast<double>(bars.size());
    layout.x = {-100, 100, layout.plot.left(), layout.plot.right()};
    draw_key(painter, bars.front(), QRectF(where.left(), where.top(), where.width(), 18), style);
    draw_axis(painter, layout, style);
    draw_text(painter, QRectF(layout.plot.right() + 8, where.top() + 4, kRight - 8, 14),
              Qt::AlignLeft, QStringLiteral("n   mean (SD)"), style.muted, 11);
    for (size_t i = 0; i < bars.size(); ++i) {
        const LikertBar& bar = bars[i];
        const double y = layout.plot.top() + static_cast<double>(i) * layout.row;
        const QString name = bar.id.size() <= 2 ? QString::fromStdString(bar.id + "  " + bar.label)
                                                : QString::fromStdString(bar.label);
        draw_wrapped(painter, QRectF(where.left(), y, kLabel - 12, layout.row),
                     Qt::AlignVCenter | Qt::AlignLeft, name, style.text, 11);
        draw_bar(painter, bar, layout, y, style);
        const int n = std::accumulate(bar.counts.begin(), bar.counts.end(), 0);
        QString right = QString::number(n).leftJustified(3);
        if (bar.mean) right += " " + number(*bar.mean, 2);
        if (bar.sd) right += " (" + number(*bar.sd, 2) + ")";
        draw_text(painter, QRectF(layout.plot.right() + 8, y, kRight - 8, layout.row),
                  Qt::AlignVCenter | Qt::AlignLeft, right, style.text, 11);
    }
}

}  // namespace

Figure likert_figure(const std::string& id, const std::string& title,
                     const std::vector<LikertBar>& bars, const ChartStyle& style) {
    assert(!bars.empty());
    Figure figure;
    figure.id = id;
    figure.title = title;
    figure.caption =
        "Diverging stacked bars: share of each answer, the middle of the scale at 0; counts inside "
        "the bars, at the right number of answers and mean (sample SD).";
    figure.height = 62 + 36 * static_cast<double>(bars.size());
    figure.csv = data_of(bars);
    figure.draw = [bars, style](QPainter& painter, const QRectF& where) {
        draw_figure(painter, where, bars, style);
    };
    return figure;
}

}  // namespace placode::reports
