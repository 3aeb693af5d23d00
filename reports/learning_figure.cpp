// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Learning curves with a CUSUM chart below, and the flow of participants.

#include <QLocale>
#include <algorithm>

#include "reports/csv_table.h"
#include "reports/figure.h"
#include "reports/plot_parts.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

struct Panel {
    QRectF plot;
    LinearScale x, y;
};

void draw_axes(QPainter& painter, const Panel& panel, const QString& name, bool with_x,
               const ChartStyle& style) {
    for (const double tick : round_ticks(panel.y.low, panel.y.high, 5)) {
        const double y = panel.y.at(tick);
        painter.setPen(QPen(colour(style.line), 0.8));
        painter.drawLine(QPointF(panel.plot.left(), y), QPointF(panel.plot.right(), y));
        draw_text(painter, QRectF(panel.plot.left() - 46, y - 8, 40, 16),
                  Qt::AlignRight | Qt::AlignVCenter, tick_text(tick), style.muted, 11);
    }
    draw_text(painter, QRectF(panel.plot.left() - 46, panel.plot.top() - 18, 400, 16),
              Qt::AlignLeft, name, style.muted, 11);
    if (!with_x) return;
    // Every number while there is room for it.
    const int last = static_cast<int>(panel.x.high);
    const int room = std::max(1, static_cast<int>(panel.plot.width() / 26));
    const int step = std::max(1, (last + room - 1) / room);
    for (int trial = step; trial <= last; trial += step)
        draw_text(painter, QRectF(panel.x.at(trial) - 20, panel.plot.bottom() + 3, 40, 14),
                  Qt::AlignCenter, QString::number(trial), style.muted, 11);
    draw_text(painter, QRectF(panel.plot.left(), panel.plot.bottom() + 18, panel.plot.width(), 14),
              Qt::AlignCenter, figure_word("attempt"), style.muted, 11);
}

void draw_line(QPainter& painter, const Panel& panel, const std::vector<double>& values, int first,
               const QPen& pen, double dot) {
    QPolygonF line;
    for (size_t i = 0; i < values.size(); ++i)
        line << QPointF(panel.x.at(first + static_cast<double>(i)), panel.y.at(values[i]));
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setBrush(pen.color());
    for (const QPointF& point : line) painter.drawEllipse(point, dot, dot);
}

constexpr double kNamePx = 180;  ///< Beside a panel, for names of limits: in Polish they are long.

void draw_limit(QPainter& painter, const Panel& panel, double value, const QString& name,
                const ChartStyle& style) {
    painter.setPen(QPen(colour(style.warn), 1.2, Qt::DashLine));
    painter.drawLine(QPointF(panel.plot.left(), panel.y.at(value)),
                     QPointF(panel.plot.right(), panel.y.at(value)));
    draw_text(painter, QRectF(panel.plot.right() + 6, panel.y.at(value) - 8, kNamePx, 16),
              Qt::AlignVCenter, name, style.text, 11);
}

std::vector<double> means_of(const std::vector<LearningLine>& lines) {
    std::vector<double> means;
    for (size_t trial = 0;; ++trial) {
        double sum = 0;
        int n = 0;
        for (const LearningLine& line : lines)
            if (trial < line.points.size()) sum += line.points[trial], ++n;
        if (n == 0) return means;
        means.push_back(sum / n);
    }
}

void draw_learning(QPainter& painter, const QRectF& where, const std::vector<LearningLine>& lines,
                   std::optional<double> pass_points, const assessment::CusumLimits& limits,
                   const ChartStyle& style) {
    size_t longest = 1;
    for (const LearningLine& line : lines) longest = std::max(longest, line.points.size());
    Panel scores, sums;
    const double left = where.left() + 52, right = where.right() - kNamePx - 8;
    scores.plot = QRectF(left, where.top() + 22, right - left, where.height() * 0.5 - 30);
    sums.plot = QRectF(left, where.top() + where.height() * 0.5 + 22, right - left,
                       where.height() * 0.5 - 62);
    // From 0, because the CUSUM begins there, before the first attempt.
    scores.x = sums.x = {-0.2, static_cast<double>(longest) + 0.3, left, right};
    scores.y = {0, 100, scores.plot.bottom(), scores.plot.top()};
    double low = limits.h0_lower, high = limits.h1_upper;
    std::vector<std::vector<double>> paths;
    for (const LearningLine& line : lines) {
        paths.push_back(assessment::cusum(line.failed, limits).path);
        paths.back().insert(paths.back().begin(), 0);
        for (const double value : paths.back())
            low = std::min(low, value), high = std::max(high, value);
    }
    sums.y = {low - 0.5, high + 0.5, sums.plot.bottom(), sums.plot.top()};
    draw_axes(painter, scores, figure_word("score [points of 100]"), false, style);
    if (pass_points)
        draw_limit(painter, scores, *pass_points,
                   figure_word("pass mark of the task: %1").arg(points_text(*pass_points)), style);
    for (const LearningLine& line : lines)
        draw_line(painter, scores, line.points, 1, QPen(colour(style.muted), 0.8), 1.6);
    draw_line(painter, scores, means_of(lines), 1, QPen(colour(style.accent), 2.4), 3.4);
    if (lines.size() > 1) {
        draw_text(painter, QRectF(right + 6, scores.plot.bottom() - 34, kNamePx, 16), Qt::AlignLeft,
                  figure_word("thick: mean of all"), style.accent, 11);
        draw_text(painter, QRectF(right + 6, scores.plot.bottom() - 18, kNamePx, 16), Qt::AlignLeft,
                  figure_word("thin: each person"), style.muted, 11);
    }
    draw_axes(painter, sums, figure_word("CUSUM of attempts not passed"), true, style);
    draw_limit(painter, sums, limits.h1_upper,
               figure_word("h1 %1 unacceptable").arg(with_spoken_sign(number(limits.h1_upper, 2))),
               style);
    draw_limit(painter, sums, limits.h0_lower,
               figure_word("h0 %1 acceptable").arg(with_spoken_sign(number(limits.h0_lower, 2))),
               style);
    for (const auto& path : paths)
        draw_line(painter, sums, path, 0, QPen(colour(style.muted), 0.9), 1.6);
}

struct Box {
    QString text;
    bool aside = false;
};

void draw_flow(QPainter& painter, const QRectF& where, const std::vector<Box>& boxes,
               const ChartStyle& style) {
    constexpr double kBox = 34, kStep = 50;
    double y = where.top() + 2;
    const double middle = where.left() + 170;
    for (size_t i = 0; i < boxes.size(); ++i) {
        const QRectF frame = boxes[i].aside ? QRectF(middle + 170, y, 320, kBox)
                                            : QRectF(middle - 150, y, 300, kBox);
        painter.setPen(QPen(colour(style.muted), 1));
        if (boxes[i].aside) {
            painter.drawLine(QPointF(middle, y + kBox / 2), QPointF(frame.left(), y + kBox / 2));
        } else if (i > 0) {
            const double above = y - (boxes[i - 1].aside ? 2 * kStep : kStep) + kBox;
            painter.drawLine(QPointF(middle, above), QPointF(middle, y - 5));
            painter.setBrush(colour(style.muted));
            painter.drawPolygon(QPolygonF(
                {QPointF(middle, y), QPointF(middle - 4, y - 7), QPointF(middle + 4, y - 7)}));
        }
        painter.setBrush(colour(style.surface));
        painter.drawRect(frame);
        draw_text(painter, frame.adjusted(6, 0, -6, 0), Qt::AlignCenter, boxes[i].text, style.text,
                  12);
        y += kStep;
    }
}

}  // namespace

Figure learning_figure(const std::string& id, const std::string& title,
                       const std::vector<LearningLine>& lines, std::optional<double> pass_points,
                       const assessment::CusumLimits& limits, const ChartStyle& style) {
    Figure figure;
    figure.id = id;
    figure.title = title;
    figure.caption =
        "Scores over attempts and, below, the CUSUM of attempts that were not passed (Bolsin & "
        "Colson 2000) with its limits; p0 " +
        number(limits.p0, 2).toStdString() + ", p1 " + number(limits.p1, 2).toStdString() +
        ", alpha " + number(limits.alpha, 2).toStdString() + ", beta " +
        number(limits.beta, 2).toStdString() + ".";
    figure.height = 430;
    figure.csv = csv_line({"participant", "attempt", "points", "passed", "cusum"});
    for (const LearningLine& line : lines) {
        const auto path = assessment::cusum(line.failed, limits).path;
        for (size_t i = 0; i < line.points.size(); ++i)
            figure.csv +=
                csv_line({line.label, std::to_string(i + 1), shortest_text(line.points[i]),
                          line.failed[i] ? "0" : "1", shortest_text(path[i])});
    }
    figure.draw = [lines, pass_points, limits, style](QPainter& painter, const QRectF& where) {
        draw_learning(painter, where, lines, pass_points, limits, style);
    };
    return figure;
}

Figure flow_figure(const std::string& id, const std::string& title, const FlowNumbers& numbers,
                   const ChartStyle& style, const FlowWords& words) {
    std::vector<Box> boxes;
    const auto add = [&](const std::string& text, int n, bool aside) {
        boxes.push_back(
            {QString::fromStdString(text) + " (n = " + QString::number(n) + ")", aside});
    };
    Figure figure;
    figure.csv = csv_line({"stage", "n"});
    const auto both = [&](const std::string& text, int n, bool aside) {
        add(text, n, aside);
        figure.csv += csv_line({harmless(text), std::to_string(n)});
    };
    both(words.enrolled, numbers.enrolled, false);
    const int left = numbers.stopped + numbers.erased;
    if (left > 0) both(words.left, left, true);
    if (numbers.kept > 0) both(words.kept, numbers.kept, true);
    if (numbers.consented >= 0) both(words.consented, numbers.consented, false);
    for (const auto& [step, n] : numbers.reached) both(step, n, false);
    both(words.analysed, numbers.analysed, false);
    figure.id = id;
    figure.title = title;
    figure.caption = "Flow of participants.";
    figure.height = 50 * static_cast<double>(boxes.size()) + 4;
    figure.draw = [boxes, style](QPainter& painter, const QRectF& where) {
        draw_flow(painter, where, boxes, style);
    };
    return figure;
}

}  // namespace placode::reports
