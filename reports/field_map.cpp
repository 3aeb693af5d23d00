// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Damage on the anatomy at rest: twelve clock sectors by three regions, the number of entries in
// each, and a sign at every place. Or the energy that went into the tissue, in J/mm2.

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reports/attempt_figures.h"
#include "reports/plot_parts.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using assessment::LedgerEntry;
using assessment::Region;
using sim::Vec2;
using sim::Vec3;

constexpr double kTurn = 2 * std::numbers::pi;

/// World to picture: cranial (+x) up, the patient's left (+y) left.
struct Map {
    double scale = 1;
    QPointF centre;
    [[nodiscard]] QPointF operator()(double x_m, double y_m) const {
        return {centre.x() - y_m * scale, centre.y() - x_m * scale};
    }
};

double reach_of(const sim::FieldGeometry& geometry) {
    double reach = 0.006;
    for (const auto* line : {&geometry.skin_edge, &geometry.placode_edge})
        for (const Vec3& p : *line) reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
    return reach;
}

/// Distance of a closed line from the centre in a direction, 0 = the line does not go there.
/// `angle` runs as the clock does: 0 at 12 o'clock.
double radius_at(const std::vector<Vec3>& line, double angle) {
    const Vec2 ray(std::cos(angle), -std::sin(angle));
    double best = 0;
    for (size_t i = 0; i < line.size(); ++i) {
        const Vec2 a = line[i].head<2>(), b = line[(i + 1) % line.size()].head<2>();
        const double ca = ray.x() * a.y() - ray.y() * a.x(), cb = ray.x() * b.y() - ray.y() * b.x();
        if ((ca > 0) == (cb > 0)) continue;
        const Vec2 hit = a + (b - a) * (ca / (ca - cb));
        if (hit.dot(ray) > 0) best = std::max(best, hit.norm());
    }
    return best;
}

QPolygonF closed(const std::vector<Vec3>& line, const Map& map) {
    QPolygonF polygon;
    for (const Vec3& p : line) polygon << map(p.x(), p.y());
    if (!polygon.isEmpty()) polygon << polygon.front();
    return polygon;
}

/// One cell between two regions' edges and two half hours.
struct Cell {
    QPainterPath path;
    QPointF middle;
};

Cell cell_of(const sim::FieldGeometry& geometry, const Map& map, int hour, Region region,
             double outer) {
    const double from = kTurn * (hour - 0.5) / 12, to = kTurn * (hour + 0.5) / 12;
    const auto edge = [&](double angle, bool inner_edge) {
        const int index = static_cast<int>(region) + (inner_edge ? 0 : 1);
        if (index == 0) return 0.0;
        if (index == 1) return radius_at(geometry.placode_edge, angle);
        if (index == 2) return radius_at(geometry.skin_edge, angle);
        return outer;
    };
    constexpr int kSteps = 8;
    QPolygonF polygon;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = from + (to - from) * i / kSteps, r = edge(angle, false);
        polygon << map(r * std::cos(angle), -r * std::sin(angle));
    }
    for (int i = kSteps; i >= 0; --i) {
        const double angle = from + (to - from) * i / kSteps, r = edge(angle, true);
        polygon << map(r * std::cos(angle), -r * std::sin(angle));
    }
    Cell cell;
    cell.path.addPolygon(polygon);
    cell.path.closeSubpath();
    const double angle = kTurn * hour / 12;
    const double inside = edge(angle, true), outside = edge(angle, false);
    const double r = region == Region::kPlacode ? 0.68 * outside : 0.5 * (inside + outside);
    cell.middle = map(r * std::cos(angle), -r * std::sin(angle));
    return cell;
}

void draw_sectors(QPainter& painter, const sim::FieldGeometry& geometry, const Map& map,
                  const std::vector<LedgerEntry>& entries, double outer, const ChartStyle& style) {
    const auto counts = damage_by_sector(entries);
    int most = 1;
    for (const auto& sector : counts)
        for (const int count : sector) most = std::max(most, count);
    for (int hour = 0; hour < 12; ++hour) {
        for (int r = 0; r < assessment::kRegions; ++r) {
            const int count = counts[static_cast<size_t>(hour)][static_cast<size_t>(r)];
            const Cell cell = cell_of(geometry, map, hour, static_cast<Region>(r), outer);
            QColor fill = colour(style.critical);
            fill.setAlphaF(count == 0 ? 0.0F
                                      : static_cast<float>(0.18 + 0.62 * count / double(most)));
            QColor edge = colour(style.muted);
            edge.setAlphaF(0.35F);
            painter.setPen(QPen(edge, 0.8));
            painter.setBrush(fill);
            painter.drawPath(cell.path);
            if (count > 0)
                draw_text(painter, QRectF(cell.middle.x() - 18, cell.middle.y() - 10, 36, 20),
                          Qt::AlignCenter, QString::number(count), style.text, 1.1 * style.font_px,
                          true);
        }
    }
}

/// Energy by cells of half a millimetre around the tip where it was delivered.
void draw_energy(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                 const Map& map, double outer, const ChartStyle& style) {
    constexpr double kCellM = 0.0005;
    const int middle = static_cast<int>(std::ceil(outer / kCellM)), side = 2 * middle + 1;
    const auto n = static_cast<size_t>(side);
    std::vector<double> joule(n * n, 0);
    const auto tools = std::min<size_t>(recording.header.tools.size(), sim::kMaxTools);
    for (const sim::Sample& sample : recording.samples) {
        for (size_t t = 0; t < tools; ++t) {
            const sim::ToolSample& tool = sample.tools[t];
            if (!(tool.power_w > 0)) continue;
            const auto i = std::lround(tool.tip_m[0] / kCellM) + middle;
            const auto j = std::lround(tool.tip_m[1] / kCellM) + middle;
            if (i < 0 || j < 0 || i >= side || j >= side) continue;
            joule[static_cast<size_t>(i) * n + static_cast<size_t>(j)] +=
                tool.power_w * recording.header.sample_s;
        }
    }
    const double most = *std::max_element(joule.begin(), joule.end());
    painter.setPen(Qt::NoPen);
    for (size_t i = 0; most > 0 && i < n; ++i) {
        for (size_t j = 0; j < n; ++j) {
            if (!(joule[i * n + j] > 0)) continue;
            QColor fill = colour(style.warn);
            fill.setAlphaF(static_cast<float>(0.15 + 0.85 * joule[i * n + j] / most));
            const double x = (static_cast<int>(i) - middle) * kCellM,
                         y = (static_cast<int>(j) - middle) * kCellM;
            const double px = kCellM * map.scale;
            painter.fillRect(QRectF(map(x, y) - QPointF(px / 2, px / 2), QSizeF(px, px)), fill);
        }
    }
    if (!(most > 0)) {  // "0 to 0.0 J/mm2" is no scale.
        draw_text(painter,
                  QRectF(where.left(), where.bottom() - 1.6 * style.font_px, where.width(), 20),
                  Qt::AlignRight | Qt::AlignVCenter, figure_word("No energy reached tissue."),
                  style.muted, 0.92 * style.font_px);
        return;
    }
    const double area_mm2 = kCellM * kCellM * 1e6;
    // The scale: what the darkest cell means.
    const QRectF bar(where.right() - 118, where.bottom() - 1.1 * style.font_px, 60, 8);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    QColor low = colour(style.warn), high = low;
    low.setAlphaF(0.15F);
    gradient.setColorAt(0, low);
    gradient.setColorAt(1, high);
    painter.fillRect(bar, gradient);
    draw_text(painter, QRectF(bar.right() + 4, bar.top() - 6, 54, 20),
              Qt::AlignLeft | Qt::AlignVCenter,
              QStringLiteral("%1 J/mm²")
                  .arg(spoken().toString(most / area_mm2, 'f', most / area_mm2 < 10 ? 1 : 0)),
              style.muted, 0.92 * style.font_px);
    draw_text(painter, QRectF(bar.left() - 16, bar.top() - 6, 12, 20),
              Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"), style.muted,
              0.92 * style.font_px);
}

void draw_edges(QPainter& painter, const sim::FieldGeometry& geometry, const Map& map,
                const ChartStyle& style) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour(style.muted), 1.4));
    painter.drawPolyline(closed(geometry.skin_edge, map));
    painter.setPen(QPen(colour(style.critical), 1.4));
    painter.drawPolyline(closed(geometry.placode_edge, map));
    if (!style.plan) return;
    painter.setPen(QPen(colour(style.text), 1.2, Qt::DashLine));
    painter.drawPolyline(closed(geometry.planned_contour, map));
}

/// A cross where harm is critical, a ring elsewhere.
void draw_signs(QPainter& painter, const std::vector<LedgerEntry>& entries, const Map& map,
                const ChartStyle& style) {
    for (const LedgerEntry& entry : entries) {
        if (!entry.has_place) continue;
        const QPointF p = map(entry.at_m.x(), entry.at_m.y());
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour(style.text), 1.6));
        if (entry.critical) {
            painter.drawLine(p + QPointF(-4, -4), p + QPointF(4, 4));
            painter.drawLine(p + QPointF(-4, 4), p + QPointF(4, -4));
        } else {
            painter.drawEllipse(p, 3.2, 3.2);
        }
    }
}

void draw_clock(QPainter& painter, const Map& map, double outer, const ChartStyle& style) {
    for (int hour = 1; hour <= 12; ++hour) {
        const double angle = kTurn * hour / 12, r = outer + 1.15 * style.font_px / map.scale;
        const QPointF p = map(r * std::cos(angle), -r * std::sin(angle));
        draw_text(painter, QRectF(p.x() - 14, p.y() - 10, 28, 20), Qt::AlignCenter,
                  QString::number(hour), style.muted, style.font_px, hour % 3 == 0);
    }
}

void draw_key(QPainter& painter, const QRectF& where, const Map& map, FieldLayer layer,
              const ChartStyle& style) {
    const double bar = 0.005 * map.scale, line = 1.35 * style.font_px;
    const QPointF left(where.left() + 8, where.bottom() - 8);
    painter.setPen(QPen(colour(style.text), 1.5));
    painter.drawLine(left, left + QPointF(bar, 0));
    draw_text(painter, QRectF(left.x(), left.y() - line - 2, 60, line), Qt::AlignLeft,
              QStringLiteral("5 mm"), style.muted, style.font_px);
    draw_text(painter, QRectF(where.left() + 8, where.top() + 2, where.width() - 16, line),
              Qt::AlignLeft, figure_word("12 = cranial"), style.muted, style.font_px);
    if (layer == FieldLayer::kEnergy) {
        draw_text(painter, QRectF(where.left() + 8, where.top() + 2, where.width() - 16, line),
                  Qt::AlignRight, figure_word("energy into tissue"), style.muted, style.font_px);
        return;
    }
    draw_text(painter, QRectF(where.left(), where.bottom() - 2 * line, where.width() - 8, line),
              Qt::AlignRight, QStringLiteral("\u2715 ") + figure_word("critical"), style.muted,
              style.font_px);
    draw_text(painter, QRectF(where.left(), where.bottom() - line, where.width() - 8, line),
              Qt::AlignRight, QStringLiteral("\u25cb ") + figure_word("other harm"), style.muted,
              style.font_px);
    draw_text(painter, QRectF(where.left() + 8, where.top() + 2, where.width() - 16, line),
              Qt::AlignRight, figure_word("number of entries"), style.muted, style.font_px);
}

}  // namespace

std::array<std::array<int, assessment::kRegions>, 12> damage_by_sector(
    const std::vector<LedgerEntry>& entries) {
    std::array<std::array<int, assessment::kRegions>, 12> counts{};
    for (const LedgerEntry& entry : entries)
        if (entry.has_place)
            ++counts[static_cast<size_t>(entry.hour % 12)][static_cast<size_t>(entry.region)];
    return counts;
}

void draw_field_map(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                    const std::vector<LedgerEntry>& entries, FieldLayer layer,
                    const ChartStyle& style) {
    const sim::FieldGeometry& geometry = recording.header.geometry;
    if (where.width() < 60 || where.height() < 60) return;
    const double outer = 1.22 * reach_of(geometry);
    const double line = 1.35 * style.font_px;
    Map map;
    map.centre = where.center();
    map.scale =
        0.5 * (std::min(where.width(), where.height() - line) - 3.4 * style.font_px) / outer;
    painter.save();
    painter.setClipRect(where);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    if (layer == FieldLayer::kDamage)
        draw_sectors(painter, geometry, map, entries, outer, style);
    else
        draw_energy(painter, where, recording, map, outer, style);
    draw_edges(painter, geometry, map, style);
    if (layer == FieldLayer::kDamage) draw_signs(painter, entries, map, style);
    draw_clock(painter, map, outer, style);
    draw_key(painter, where, map, layer, style);
    painter.restore();
}

}  // namespace placode::reports
