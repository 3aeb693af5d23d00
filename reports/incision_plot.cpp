// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The field from above, as the scope sees it upright: cranial is up, the patient's left is left.
// With the incision, or with what an exercise asked for. (x cranial -> up, y left -> left.)

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "assessment/practice.h"
#include "curriculum/task.h"
#include "reports/attempt_figures.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using sim::Vec3;

/// World [m] to picture.
struct SheetMap {
    double scale = 1;
    QPointF centre;
    [[nodiscard]] QPointF operator()(double x_m, double y_m) const {
        return {centre.x() - y_m * scale, centre.y() - x_m * scale};
    }
    [[nodiscard]] QPointF operator()(const Vec3& p) const { return (*this)(p.x(), p.y()); }
};

QPolygonF polygon(const std::vector<Vec3>& line, const SheetMap& map) {
    QPolygonF points;
    for (const Vec3& p : line) points << map(p);
    if (!points.isEmpty()) points << points.front();
    return points;
}

SheetMap fitted(const sim::FieldGeometry& geometry, const QRectF& where) {
    double reach = 0.010;
    for (const Vec3& p : geometry.skin_edge)
        reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
    SheetMap map;
    map.centre = where.center();
    map.scale = 0.5 * std::min(where.width(), where.height()) / (1.15 * reach);
    return map;
}

void draw_anatomy(QPainter& painter, const sim::FieldGeometry& geometry, const SheetMap& map,
                  const ChartStyle& style) {
    QColor skin = colour(style.muted), placode = colour(style.critical);
    skin.setAlphaF(0.12F);
    placode.setAlphaF(0.18F);
    painter.setPen(QPen(colour(style.muted), 1));
    painter.setBrush(skin);
    painter.drawPolygon(polygon(geometry.skin_edge, map));
    painter.setPen(QPen(colour(style.critical), 1));
    painter.setBrush(placode);
    painter.drawPolygon(polygon(geometry.placode_edge, map));
    painter.setBrush(Qt::NoBrush);
    if (!style.plan) return;
    painter.setPen(QPen(colour(style.text), 1.2, Qt::DashLine));
    painter.drawPolyline(polygon(geometry.planned_contour, map));
}

void draw_cut(QPainter& painter, const sim::Recording& recording, const SheetMap& map,
              const ChartStyle& style) {
    QColor ink = colour(style.accent);
    ink.setAlphaF(0.55F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    for (const sim::Event& event : recording.events) {
        if (event.kind != sim::EventKind::kVaporised) continue;
        const double side = std::cbrt(std::max(0.0F, event.value)) * map.scale;
        painter.drawEllipse(map(event.rest_position_m[0], event.rest_position_m[1]), 0.7 * side,
                            0.7 * side);
    }
}

void draw_path(QPainter& painter, const sim::Recording& recording, const SheetMap& map,
               const ChartStyle& style) {
    int needle = -1;
    for (size_t i = 0; i < recording.header.tools.size(); ++i) {
        if (recording.header.tools[i].kind != sim::ToolKind::kScope)
            needle = needle < 0 ? static_cast<int>(i) : needle;
    }
    if (needle < 0 || recording.samples.empty()) return;
    QPainterPath path;
    for (size_t i = 0; i < recording.samples.size(); i += 2) {
        const auto& tip = recording.samples[i].tools[needle].tip_m;
        const QPointF p = map(tip[0], tip[1]);
        i == 0 ? path.moveTo(p) : path.lineTo(p);
    }
    QColor ink = colour(style.muted);
    ink.setAlphaF(0.7F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, 0.8));
    if (!path.isEmpty()) painter.drawPath(path);
}

/// Harm to the placode and torn tissue: a cross each, never by colour alone.
void draw_harm(QPainter& painter, const sim::Recording& recording, const SheetMap& map,
               const ChartStyle& style) {
    painter.setPen(QPen(colour(style.critical), 2));
    for (const sim::Event& event : recording.events) {
        // Tears inside the kerf are part of cutting; a tear of skin or placode is harm.
        const bool torn_harm =
            event.kind == sim::EventKind::kTorn &&
            (event.tissue == sim::Tissue::kSkin || event.tissue == sim::Tissue::kPlacode);
        const bool harm = torn_harm || event.kind == sim::EventKind::kPlacodeContact ||
                          event.kind == sim::EventKind::kPlacodeEnergised ||
                          event.kind == sim::EventKind::kPlacodeOverheated ||
                          event.kind == sim::EventKind::kPlacodeBurned;
        if (!harm) continue;
        const QPointF p = map(event.rest_position_m[0], event.rest_position_m[1]);
        painter.drawLine(p + QPointF(-4, -4), p + QPointF(4, 4));
        painter.drawLine(p + QPointF(-4, 4), p + QPointF(4, -4));
    }
}

/// A sign with its word, in its colour.
struct LegendRow {
    QString word;
    unsigned ink;
};

void draw_legend(QPainter& painter, const QRectF& where, const SheetMap& map,
                 const std::vector<LegendRow>& rows, const ChartStyle& style) {
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(style.font_px));
    painter.setFont(font);
    painter.setPen(colour(style.muted));
    painter.drawText(where.adjusted(4, 2, -4, -2), Qt::AlignHCenter | Qt::AlignTop,
                     figure_word("cranial (12 o'clock)"));
    const double bar = 0.005 * map.scale;
    const QPointF left(where.left() + 8, where.bottom() - 8);
    painter.setPen(QPen(colour(style.text), 1.5));
    painter.drawLine(left, left + QPointF(bar, 0));
    painter.drawText(QPointF(left.x(), left.y() - 4), QStringLiteral("5 mm"));
    double y = where.bottom() - 6 - (static_cast<double>(rows.size()) - 1) * style.font_px * 1.3;
    for (const LegendRow& row : rows) {
        painter.setPen(colour(row.ink));
        painter.drawText(
            QRectF(where.left(), y - style.font_px, where.width() - 6, style.font_px * 1.4),
            Qt::AlignRight, row.word);
        y += style.font_px * 1.3;
    }
}

QString signed_word(QChar sign, const char* word) {
    return QString(sign) + QLatin1Char(' ') + figure_word(word);
}

constexpr QChar kDisc(0x25cf), kRing(0x25cb), kCross(0x2715);

void draw_followed(QPainter& painter, const sim::FieldGeometry& geometry, const AskedPlaces& asked,
                   const SheetMap& map, const ChartStyle& style) {
    if (geometry.planned_contour.size() < 3) return;
    const assessment::ClosedContour line(geometry.planned_contour);
    painter.setPen(QPen(colour(style.good), 4, Qt::SolidLine, Qt::FlatCap));
    for (size_t bin = 0; bin < asked.followed.size(); ++bin) {
        if (asked.followed[bin] == 0) continue;
        const auto at = [&](double share) {
            const sim::Vec2 p = line.at(line.length() * share / sim::kTraceBins);
            return map(p.x(), p.y());
        };
        painter.drawLine(at(static_cast<double>(bin)), at(static_cast<double>(bin) + 1));
    }
}

/// A disc where it was done, an empty ring where not, the number of the step inside.
void draw_places(QPainter& painter, const AskedPlaces& asked, const SheetMap& map,
                 const ChartStyle& style) {
    const double half = 0.75 * style.font_px;
    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(style.font_px));
    font.setBold(true);
    painter.setFont(font);
    for (const AskedPlaces::Place& place : asked.places) {
        const QPointF p = map(place.at_m.x(), place.at_m.y());
        painter.setPen(QPen(colour(place.done ? style.good : style.text), 1.6));
        painter.setBrush(colour(place.done ? style.good : style.surface));
        painter.drawEllipse(p, half, half);
        painter.setPen(colour(place.done ? style.surface : style.text));
        painter.drawText(QRectF(p.x() - half, p.y() - half, 2 * half, 2 * half), Qt::AlignCenter,
                         QString::number(place.step + 1));
    }
    painter.setPen(QPen(colour(style.warn), 1.8));
    for (const sim::Vec2& at : asked.missed) {
        const QPointF p = map(at.x(), at.y());
        painter.drawLine(p + QPointF(-3, -3), p + QPointF(3, 3));
        painter.drawLine(p + QPointF(-3, 3), p + QPointF(3, -3));
    }
}

}  // namespace

void draw_incision(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                   const ChartStyle& style) {
    const SheetMap map = fitted(recording.header.geometry, where);
    painter.save();
    painter.setClipRect(where);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    draw_anatomy(painter, recording.header.geometry, map, style);
    draw_path(painter, recording, map, style);
    draw_cut(painter, recording, map, style);
    draw_harm(painter, recording, map, style);
    draw_legend(painter, where, map,
                {{QStringLiteral("- - ") + figure_word("planned"), style.text},
                 {signed_word(kDisc, "cut"), style.accent},
                 {signed_word(kCross, "harm"), style.critical}},
                style);
    painter.restore();
}

int AskedPlaces::done() const noexcept {
    return static_cast<int>(
        std::count_if(places.begin(), places.end(), [](const Place& each) { return each.done; }));
}

AskedPlaces asked_places(const sim::Recording& recording) {
    AskedPlaces asked;
    std::vector<curriculum::TaskStep> steps;
    try {
        steps = curriculum::steps_for(
            curriculum::load_task_text(recording.header.task_json, recording.header.task_id),
            recording.header.device);
    } catch (const curriculum::DefinitionError&) {
        return asked;
    }
    for (size_t i = 0; i < steps.size(); ++i) {
        const sim::PracticeStep& goal = steps[i].goal;
        asked.line = asked.line || goal.kind == sim::PracticeKind::kTrace;
        const int places = sim::finds_targets(goal.kind) ? 0 : sim::targets_of(goal.kind);
        for (int k = 0; k < places; ++k)
            asked.places.push_back(
                {assessment::practice_target(goal, recording.header.geometry, k == 1),
                 static_cast<int>(i), false});
    }
    asked.followed.assign(asked.line ? sim::kTraceBins : 0, 0);
    for (const sim::Event& event : recording.events) {
        const auto number = static_cast<int>(std::lround(std::max(0.0F, event.value)));
        if (event.kind == sim::EventKind::kStepDone)
            for (AskedPlaces::Place& place : asked.places)
                place.done = place.done || place.step == number;
        if (event.kind == sim::EventKind::kTargetMissed)
            asked.missed.emplace_back(event.rest_position_m[0], event.rest_position_m[1]);
        if (event.kind == sim::EventKind::kTraced &&
            static_cast<size_t>(number) < asked.followed.size() &&
            event.value2 <= assessment::kTracedWithinM)
            asked.followed[static_cast<size_t>(number)] = 1;
    }
    return asked;
}

void draw_asked(QPainter& painter, const QRectF& where, const sim::FieldGeometry& geometry,
                const AskedPlaces& asked, const ChartStyle& style) {
    SheetMap map = fitted(geometry, where);
    // A place beside the skin's edge is shown whole, sign and all, below the words at the top.
    const double room = 0.5 * std::min(where.width(), where.height()) - 2.6 * style.font_px;
    for (const AskedPlaces::Place& place : asked.places)
        map.scale = std::min(
            map.scale, room / std::max({1e-3, std::abs(place.at_m.x()), std::abs(place.at_m.y())}));
    painter.save();
    painter.setClipRect(where);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    draw_anatomy(painter, geometry, map, style);
    draw_followed(painter, geometry, asked, map, style);
    draw_places(painter, asked, map, style);
    std::vector<LegendRow> rows;
    if (asked.line)
        rows.push_back({QStringLiteral("\u2501 ") + figure_word("followed"), style.good});
    if (!asked.places.empty()) {
        rows.push_back({signed_word(kDisc, "done"), style.good});
        rows.push_back({signed_word(kRing, "not done"), style.text});
        rows.push_back({signed_word(kCross, "beside it"), style.warn});
    }
    draw_legend(painter, where, map, rows, style);
    painter.restore();
}

}  // namespace placode::reports
