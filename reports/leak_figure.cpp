// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/leak_figure.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "reports/plot_parts.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using assessment::LeakBite;
using assessment::LeakMap;
using assessment::LeakStage;
using assessment::LeakStation;

constexpr auto kGood = static_cast<size_t>(LeakStage::kGood);
// Heights in sizes of the font: the flag of the burst, a panel's title, panels, foot.
constexpr double kFlag = 1.7, kTitle = 1.6, kLeaks = 5.5, kBites = 5, kGaps = 4.5, kFoot = 3.3,
                 kBetween = 0.7;

/// The three panels, one below the other; millimetres along all of them.
struct Layout {
    QRectF leaks, bites, gaps;
    LinearScale along;
};

Layout layout_of(const QRectF& where, const LeakMap& map, const ChartStyle& style) {
    const double em = style.font_px;
    Layout out;
    double top = where.top() + kFlag * em;
    const auto next = [&](double height) {
        const QRectF panel(where.left() + 3.6 * em, top + kTitle * em, where.width() - 5.1 * em,
                           height * em);
        top = panel.bottom() + kBetween * em;
        return panel;
    };
    out.leaks = next(kLeaks);
    out.bites = next(kBites);
    out.gaps = next(kGaps);
    out.along = {0, 1e3 * map.length_m, out.leaks.left(), out.leaks.right()};
    return out;
}

void draw_title(QPainter& painter, const QRectF& panel, const QString& words,
                const ChartStyle& style) {
    draw_text(painter,
              QRectF(panel.left(), panel.top() - kTitle * style.font_px, panel.width(),
                     kTitle * style.font_px),
              Qt::AlignLeft | Qt::AlignVCenter, words, style.muted, style.font_px);
}

/// Lines with numbers at the left; gives the scale from 0 to a little more than `most`.
LinearScale draw_height(QPainter& painter, const QRectF& panel, double most,
                        const ChartStyle& style) {
    const LinearScale y{0, 1.05 * most, panel.bottom(), panel.top()};
    for (const double tick : round_ticks(0, y.high, 2)) {
        painter.setPen(QPen(colour(style.line), 1));
        painter.drawLine(QPointF(panel.left(), y.at(tick)), QPointF(panel.right(), y.at(tick)));
        draw_text(painter,
                  QRectF(panel.left() - 3.6 * style.font_px, y.at(tick) - 0.7 * style.font_px,
                         3.2 * style.font_px, 1.4 * style.font_px),
                  Qt::AlignRight | Qt::AlignVCenter, tick_text(tick), style.muted, style.font_px);
    }
    return y;
}

/// What a station stands for, from 0 up to its value.
QRectF bar_of(const LeakStation& station, double value, const Layout& at, const LinearScale& y) {
    const double from = at.along.at(1e3 * (station.along_m - station.length_m / 2)),
                 to = at.along.at(1e3 * (station.along_m + station.length_m / 2));
    return {QPointF(from, y.at(value)), QPointF(to, y.at(0))};
}

void draw_leaks(QPainter& painter, const LeakMap& map, const Layout& at, const ChartStyle& style) {
    draw_title(painter, at.leaks, figure_word("leak at 12.5 cmH2O [ml/min]"), style);
    const auto leak = [](const LeakStation& station) {
        return assessment::kMlMinPerM3S * station.leak_m3_s[kGood];
    };
    double most = 0;
    for (const LeakStation& station : map.stations) most = std::max(most, leak(station));
    // A scale that makes a drop look like a flood says nothing.
    const LinearScale y = draw_height(painter, at.leaks, std::max(most, 0.1), style);
    QColor fill = colour(style.accent);
    fill.setAlphaF(0.75F);
    painter.setPen(QPen(colour(style.accent), 0.8));
    painter.setBrush(fill);
    for (const LeakStation& station : map.stations)
        if (leak(station) > 0) painter.drawRect(bar_of(station, leak(station), at, y));
    if (!(most > 0))
        draw_text(painter, at.leaks, Qt::AlignCenter, figure_word("nothing leaks"), style.muted,
                  1.1 * style.font_px);
}

void draw_bite(QPainter& painter, const LeakBite& bite, const Layout& at, const LinearScale& aside,
               const ChartStyle& style) {
    const auto place = [&](const sim::Vec2& p) {
        return QPointF(std::clamp(at.along.at(1e3 * p.x()), at.bites.left(), at.bites.right()),
                       aside.at(1e3 * p.y()));
    };
    const QPointF in = place(bite.entry_m), out = place(bite.exit_m);
    if (bite.entered && bite.left) {
        painter.setPen(QPen(colour(style.text), 1.2, bite.done ? Qt::SolidLine : Qt::DashLine));
        painter.drawLine(in, out);
    }
    const double radius = 0.34 * style.font_px;
    painter.setPen(QPen(colour(style.text), 1.2));
    if (bite.entered) {
        painter.setBrush(colour(style.text));
        painter.drawEllipse(in, radius, radius);
    }
    if (bite.left) {
        painter.setBrush(colour(style.surface));
        painter.drawEllipse(out, radius, radius);
    }
    const QPointF named = bite.entered ? in : out;
    draw_text(painter,
              QRectF(named.x() + 1.6 * radius, named.y() - 0.7 * style.font_px, 2 * style.font_px,
                     1.4 * style.font_px),
              Qt::AlignLeft | Qt::AlignVCenter, QString::number(bite.number), style.text,
              style.font_px, true);
}

void draw_bites(QPainter& painter, const LeakMap& map, const Layout& at, const ChartStyle& style) {
    draw_title(painter, at.bites,
               figure_word("bites: filled = in, open = out, dashed = not finished"), style);
    double reach = 1;
    for (const LeakBite& bite : map.bites) {
        if (bite.entered) reach = std::max(reach, 1e3 * std::abs(bite.entry_m.y()));
        if (bite.left) reach = std::max(reach, 1e3 * std::abs(bite.exit_m.y()));
    }
    const LinearScale aside{-1.2 * reach, 1.2 * reach, at.bites.bottom(), at.bites.top()};
    painter.setPen(QPen(colour(style.muted), 2));
    painter.drawLine(QPointF(at.along.at(0), aside.at(0)),
                     QPointF(at.along.at(at.along.high), aside.at(0)));
    if (map.bites.empty())
        draw_text(painter, at.bites.adjusted(0, 0, 0, -at.bites.height() / 2), Qt::AlignCenter,
                  figure_word("no bite"), style.muted, style.font_px);
    for (const LeakBite& bite : map.bites) draw_bite(painter, bite, at, aside, style);
}

void draw_gaps(QPainter& painter, const LeakMap& map, const Layout& at, const ChartStyle& style) {
    draw_title(painter, at.gaps,
               map.whole ? figure_word("gap [mm]: grey without pressure, line at 12.5 cmH2O")
                         : figure_word("gap [mm] without pressure"),
               style);
    double most = 0.05;  // below, contact keeps edges apart by as much
    for (const LeakStation& station : map.stations)
        most = std::max({most, 1e3 * station.gap_m, 1e3 * station.pressed_gap_m[kGood]});
    const LinearScale y = draw_height(painter, at.gaps, most, style);
    QColor fill = colour(style.muted);
    fill.setAlphaF(0.45F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    for (const LeakStation& station : map.stations)
        if (station.gap_m > 0) painter.drawRect(bar_of(station, 1e3 * station.gap_m, at, y));
    if (!map.whole) return;
    QPolygonF line;
    for (const LeakStation& station : map.stations) {
        const QRectF bar = bar_of(station, 1e3 * station.pressed_gap_m[kGood], at, y);
        line << QPointF(bar.left(), bar.top()) << QPointF(bar.right(), bar.top());
    }
    painter.setPen(QPen(colour(style.accent), 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

/// Millimetres below the last panel, and which ends these are.
void draw_along(QPainter& painter, const LeakMap& map, const Layout& at, const ChartStyle& style) {
    const double em = style.font_px, top = at.gaps.bottom() + 0.2 * em;
    for (const double tick : round_ticks(0, at.along.high, 6)) {
        const double x = at.along.at(tick);
        painter.setPen(QPen(colour(style.line), 1));
        for (const QRectF& panel : {at.leaks, at.bites, at.gaps})
            painter.drawLine(QPointF(x, panel.top()), QPointF(x, panel.bottom()));
        draw_text(painter, QRectF(x - 2.5 * em, top, 5 * em, 1.5 * em),
                  Qt::AlignHCenter | Qt::AlignTop, tick_text(tick), style.muted, em);
    }
    const QRectF foot(at.gaps.left(), top + 1.5 * em, at.gaps.width(), 1.5 * em);
    draw_text(painter, foot, Qt::AlignLeft | Qt::AlignTop,
              figure_word(map.upright ? "upper end" : "left end"), style.text, em);
    draw_text(painter, foot, Qt::AlignHCenter | Qt::AlignTop, QStringLiteral("mm"), style.muted,
              em);
    draw_text(painter, foot, Qt::AlignRight | Qt::AlignTop,
              figure_word(map.upright ? "lower end" : "right end"), style.text, em);
}

/// A line through all panels with a flag, on the side where there is room.
void draw_burst(QPainter& painter, const QRectF& where, const LeakMap& map, const Layout& at,
                const ChartStyle& style) {
    if (!map.burst) return;
    const auto burst = assessment::worst_leak(map, LeakStage::kLast);
    if (!burst) return;
    const double em = style.font_px, x = at.along.at(1e3 * burst->along_m);
    const double top = where.top() + kFlag * em;
    painter.setPen(QPen(colour(style.critical), 2, Qt::DashDotLine));
    painter.drawLine(QPointF(x, top), QPointF(x, at.gaps.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour(style.critical));
    painter.drawPolygon(
        QPolygonF({QPointF(x, top + 0.2 * em), QPointF(x - 0.5 * em, top - 0.6 * em),
                   QPointF(x + 0.5 * em, top - 0.6 * em)}));
    const double held = std::floor(10 * map.held_pa / assessment::kPaPerCmH2O) / 10;
    const QString words = figure_word("burst at %1 cmH2O").arg(spoken().toString(held, 'f', 1));
    const bool left = x > at.leaks.center().x();
    draw_text(painter,
              QRectF(left ? where.left() : x + 0.9 * em, where.top(),
                     left ? x - 0.9 * em - where.left() : where.right() - x - 0.9 * em, kFlag * em),
              (left ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, words, style.critical, em,
              true);
}

}  // namespace

double leak_height(const ChartStyle& style) {
    return style.font_px *
           (kFlag + 3 * kTitle + kLeaks + kBites + kGaps + 2 * kBetween + kFoot + 0.2);
}

void draw_leak(QPainter& painter, const QRectF& where, const LeakMap& map,
               const ChartStyle& style) {
    const Layout at = layout_of(where, map, style);
    if (at.leaks.width() < 40 || !(map.length_m > 0)) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    draw_along(painter, map, at, style);
    draw_leaks(painter, map, at, style);
    draw_gaps(painter, map, at, style);
    draw_bites(painter, map, at, style);
    draw_burst(painter, where, map, at, style);
    painter.restore();
}

}  // namespace placode::reports
