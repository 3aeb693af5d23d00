// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Strips of single values with boxes, and forests of effect sizes: for groups that are too small
// for a box alone.

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/statistics.h"
#include "reports/csv_table.h"
#include "reports/figure.h"
#include "reports/plot_parts.h"
#include "reports/points_figure.h"
#include "reports/text.h"

namespace placode::reports {
namespace {

/// Vertical lines with numbers below, and the name of the axis.
void draw_axis(QPainter& painter, const QRectF& plot, const LinearScale& x, const QString& name,
               const ChartStyle& style) {
    for (const double tick : round_ticks(x.low, x.high, 6)) {
        painter.setPen(QPen(colour(style.line), 0.8));
        painter.drawLine(QPointF(x.at(tick), plot.top()), QPointF(x.at(tick), plot.bottom()));
        draw_text(painter, QRectF(x.at(tick) - 40, plot.bottom() + 2, 80, 14), Qt::AlignCenter,
                  tick_text(tick), style.muted, 11);
    }
    draw_text(painter, QRectF(plot.left(), plot.bottom() + 16, plot.width(), 14), Qt::AlignCenter,
              name, style.muted, 11);
}

/// Points that would hide each other are stacked above and below the middle.
void draw_points(QPainter& painter, const std::vector<double>& sorted, const LinearScale& x,
                 double y, const ChartStyle& style) {
    painter.setPen(QPen(colour(style.surface), 0.8));
    painter.setBrush(colour(style.accent));
    for (size_t i = 0; i < sorted.size();) {
        size_t end = i;
        while (end < sorted.size() && std::abs(x.at(sorted[end]) - x.at(sorted[i])) < 3) ++end;
        const size_t count = end - i;
        const double step = std::min(5.0, 22.0 / static_cast<double>(count));
        for (size_t k = 0; k < count; ++k) {
            const double offset = (static_cast<double>(k) - (static_cast<double>(count) - 1) / 2);
            painter.drawEllipse(QPointF(x.at(sorted[i + k]), y + step * offset), 3, 3);
        }
        i = end;
    }
}

void draw_group(QPainter& painter, const std::vector<double>& sorted, const LinearScale& x,
                double y, const ChartStyle& style) {
    if (sorted.size() >= 4) {
        const QRectF box(QPointF(x.at(assessment::quantile(sorted, 0.25)), y - 13),
                         QPointF(x.at(assessment::quantile(sorted, 0.75)), y + 13));
        painter.setPen(QPen(colour(style.muted), 1));
        painter.setBrush(QColor(0x5f, 0x66, 0x6e, 30));
        painter.drawRect(box);
        painter.drawLine(QPointF(x.at(sorted.front()), y), QPointF(box.left(), y));
        painter.drawLine(QPointF(box.right(), y), QPointF(x.at(sorted.back()), y));
        const double median = x.at(assessment::quantile(sorted, 0.5));
        painter.setPen(QPen(colour(style.text), 2));
        painter.drawLine(QPointF(median, y - 13), QPointF(median, y + 13));
    }
    draw_points(painter, sorted, x, y, style);
    if (const auto mean = assessment::mean_of(sorted)) {
        const double at = x.at(*mean);
        painter.setPen(QPen(colour(style.text), 1));
        painter.setBrush(colour(style.surface));
        painter.drawPolygon(QPolygonF(
            {QPointF(at, y - 5), QPointF(at + 5, y), QPointF(at, y + 5), QPointF(at - 5, y)}));
    }
}

/// From the least to the greatest value, with a margin.
std::pair<double, double> range_of(const std::vector<StripGroup>& groups) {
    double low = 1e300, high = -1e300;
    for (const StripGroup& group : groups)
        for (const double value : group.values)
            low = std::min(low, value), high = std::max(high, value);
    if (low > high) low = 0, high = 1;
    const double margin = low == high ? 1 : 0.05 * (high - low);
    // Where nothing is negative the axis is neither: there are no points below 0.
    return {low >= 0 ? std::max(0.0, low - margin) : low - margin, high + margin};
}

void draw_strips(QPainter& painter, const QRectF& where, const std::vector<StripGroup>& groups,
                 const QString& axis, std::pair<double, double> range, const ChartStyle& style) {
    constexpr double kLabel = 230, kRight = 60, kFoot = 34;
    const QRectF plot = where.adjusted(kLabel, 4, -kRight, -kFoot);
    const LinearScale x{range.first, range.second, plot.left(), plot.right()};
    draw_axis(painter, plot, x, axis, style);
    const double row = plot.height() / static_cast<double>(std::max<size_t>(1, groups.size()));
    for (size_t i = 0; i < groups.size(); ++i) {
        const double y = plot.top() + (static_cast<double>(i) + 0.5) * row;
        draw_wrapped(painter, QRectF(where.left(), y - row / 2, kLabel - 12, row),
                     Qt::AlignVCenter | Qt::AlignLeft, QString::fromStdString(groups[i].label),
                     style.text, 11);
        std::vector<double> sorted = groups[i].values;
        std::sort(sorted.begin(), sorted.end());
        draw_group(painter, sorted, x, y, style);
        draw_text(painter, QRectF(plot.right() + 8, y - 8, kRight - 8, 16), Qt::AlignVCenter,
                  QString("n %1").arg(sorted.size()), style.text, 11);
    }
}

/// -1 left of the axis, 1 right of it, 0 on it.
int beyond(const LinearScale& x, double value) {
    return value < x.low ? -1 : value > x.high ? 1 : 0;
}

/// The square, its interval, and an arrow at the end of the axis where one of them goes on.
void draw_estimate(QPainter& painter, const ForestRow& row, const LinearScale& x, double y,
                   const ChartStyle& style) {
    const auto at = [&](double value) { return x.at(std::clamp(value, x.low, x.high)); };
    std::vector<double> values{row.estimate};
    if (!row.no_interval) {
        values.insert(values.end(), {row.low, row.high});
        painter.setPen(QPen(colour(style.accent), 2));
        if (at(row.low) < at(row.high))
            painter.drawLine(QPointF(at(row.low), y), QPointF(at(row.high), y));
        for (const double end : {row.low, row.high})
            if (beyond(x, end) == 0)
                painter.drawLine(QPointF(at(end), y - 4), QPointF(at(end), y + 4));
    }
    painter.setBrush(colour(style.accent));
    painter.setPen(Qt::NoPen);
    for (const double value : values) {
        const int side = beyond(x, value);
        if (side != 0)
            painter.drawPolygon(
                QPolygonF({QPointF(at(value), y), QPointF(at(value) - 9 * side, y - 5),
                           QPointF(at(value) - 9 * side, y + 5)}));
    }
    if (beyond(x, row.estimate) == 0) painter.drawRect(QRectF(at(row.estimate) - 4, y - 4, 8, 8));
}

void draw_forest(QPainter& painter, const QRectF& where, const std::vector<ForestRow>& rows,
                 const QString& axis, double low, double high, const ChartStyle& style) {
    constexpr double kLabel = 230, kRight = 190, kFoot = 34;
    const QRectF plot = where.adjusted(kLabel, 4, -kRight, -kFoot);
    const LinearScale x{low, high, plot.left(), plot.right()};
    draw_axis(painter, plot, x, axis, style);
    painter.setPen(QPen(colour(style.muted), 1.2, Qt::DashLine));
    painter.drawLine(QPointF(x.at(0), plot.top()), QPointF(x.at(0), plot.bottom()));
    const double row = plot.height() / static_cast<double>(std::max<size_t>(1, rows.size()));
    for (size_t i = 0; i < rows.size(); ++i) {
        const ForestRow& each = rows[i];
        const double y = plot.top() + (static_cast<double>(i) + 0.5) * row;
        draw_wrapped(painter, QRectF(where.left(), y - row / 2, kLabel - 12, row),
                     Qt::AlignVCenter | Qt::AlignLeft, QString::fromStdString(each.label),
                     style.text, 11);
        draw_estimate(painter, each, x, y, style);
        const QString interval = each.no_interval
                                     ? QStringLiteral("no interval")
                                     : number(each.low, 2) + " to " + number(each.high, 2);
        draw_text(painter, QRectF(plot.right() + 8, y - 15, kRight - 8, 15), Qt::AlignVCenter,
                  number(each.estimate, 2) + "  (" + interval + ")", style.text, 11);
        draw_text(painter, QRectF(plot.right() + 8, y, kRight - 8, 15), Qt::AlignVCenter,
                  QString::fromStdString(each.note), style.muted, 11);
    }
}

Figure figure_of(const std::string& id, const std::string& title, const std::string& axis,
                 const std::vector<StripGroup>& groups, std::pair<double, double> range,
                 const ChartStyle& style) {
    Figure figure;
    figure.id = id;
    figure.title = title;
    figure.caption =
        "Every value is a point; box: quartiles (type 7), line: median, diamond: mean, whiskers: "
        "least and greatest value.";
    figure.height = 42 + 48 * static_cast<double>(std::max<size_t>(1, groups.size()));
    figure.csv = csv_line({"group", "value"});
    for (const StripGroup& group : groups)
        for (const double value : group.values)
            figure.csv += csv_line({harmless(group.label), shortest_text(value)});
    figure.draw = [groups, style, range, name = QString::fromStdString(axis)](QPainter& painter,
                                                                              const QRectF& where) {
        draw_strips(painter, where, groups, name, range, style);
    };
    return figure;
}

}  // namespace

Figure strip_figure(const std::string& id, const std::string& title, const std::string& axis,
                    const std::vector<StripGroup>& groups, const ChartStyle& style) {
    return figure_of(id, title, axis, groups, range_of(groups), style);
}

Figure points_figure(const std::string& id, const std::string& title, const std::string& axis,
                     const std::vector<StripGroup>& groups, const ChartStyle& style) {
    return figure_of(id, title, axis, groups, {0, 100}, style);
}

Figure forest_figure(const std::string& id, const std::string& title, const std::string& axis,
                     const std::vector<ForestRow>& rows, double low, double high,
                     const ChartStyle& style) {
    Figure figure;
    figure.id = id;
    figure.title = title;
    figure.caption = "Squares: estimates, lines: 95 % intervals, dashed: no effect.";
    const LinearScale x{low, high};
    if (std::any_of(rows.begin(), rows.end(), [&](const ForestRow& row) {
            return beyond(x, row.estimate) != 0 ||
                   (!row.no_interval && (beyond(x, row.low) != 0 || beyond(x, row.high) != 0));
        }))
        figure.caption += " Arrows: it lies beyond the axis, where the numbers say.";
    figure.height = 42 + 36 * static_cast<double>(std::max<size_t>(1, rows.size()));
    figure.csv = csv_line({"item", "estimate", "low95", "high95", "note"});
    for (const ForestRow& row : rows)
        figure.csv +=
            csv_line({harmless(row.label), shortest_text(row.estimate),
                      row.no_interval ? "" : shortest_text(row.low),
                      row.no_interval ? "" : shortest_text(row.high), harmless(row.note)});
    figure.draw = [rows, style, low, high, name = QString::fromStdString(axis)](
                      QPainter& painter, const QRectF& where) {
        draw_forest(painter, where, rows, name, low, high, style);
    };
    return figure;
}

}  // namespace placode::reports
