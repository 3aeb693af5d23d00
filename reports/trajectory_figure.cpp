// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The ways of the instruments' tips from three sides, at one scale for each picture. Instruments
// differ by dash as well as by colour; a thick line is energy in tissue.

#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "reports/attempt_figures.h"
#include "reports/plot_parts.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using sim::Vec3;

/// Across and up in the picture, as the watcher from `side` sees them [m].
std::array<double, 2> seen(Side side, double x, double y, double z) {
    switch (side) {
        case Side::kAbove:
            return {-y, x};
        case Side::kFromSide:
            return {-x, z};
        case Side::kFromFeet:
            return {-y, z};
    }
    return {};
}

struct Extent {
    double low[2]{1e9, 1e9}, high[2]{-1e9, -1e9};
    void add(const std::array<double, 2>& p) {
        for (size_t i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    }
};

struct Sight {
    Side side;
    double scale, middle[2];
    QPointF centre;
    [[nodiscard]] QPointF operator()(double x, double y, double z) const {
        const auto p = seen(side, x, y, z);
        return {centre.x() + (p[0] - middle[0]) * scale, centre.y() - (p[1] - middle[1]) * scale};
    }
};

/// Tips near the field only: on the way through the port an instrument is far away.
constexpr double kNearM = 0.022;

bool near_field(const sim::ToolSample& tool) {
    return std::abs(tool.tip_m[0]) < kNearM && std::abs(tool.tip_m[1]) < kNearM &&
           std::abs(tool.tip_m[2]) < kNearM && std::isfinite(tool.tip_m[0]);
}

Sight sight_of(const QRectF& where, const sim::Recording& recording, Side side) {
    Extent extent;
    for (const auto* line :
         {&recording.header.geometry.skin_edge, &recording.header.geometry.planned_contour})
        for (const Vec3& p : *line) extent.add(seen(side, p.x(), p.y(), p.z()));
    const auto tools = std::min<size_t>(recording.header.tools.size(), sim::kMaxTools);
    for (const sim::Sample& sample : recording.samples)
        for (size_t t = 0; t < tools; ++t)
            if (recording.header.tools[t].kind != sim::ToolKind::kScope &&
                near_field(sample.tools[t]))
                extent.add(seen(side, sample.tools[t].tip_m[0], sample.tools[t].tip_m[1],
                                sample.tools[t].tip_m[2]));
    Sight sight{side, 1, {0, 0}, where.center()};
    double across = 0.01, up = 0.01;
    if (extent.high[0] > extent.low[0]) {
        across = std::max(0.004, extent.high[0] - extent.low[0]);
        up = std::max(0.004, extent.high[1] - extent.low[1]);
        sight.middle[0] = 0.5 * (extent.low[0] + extent.high[0]);
        sight.middle[1] = 0.5 * (extent.low[1] + extent.high[1]);
    }
    sight.scale = 0.92 * std::min(where.width() / across, where.height() / up);
    return sight;
}

void draw_lines(QPainter& painter, const sim::FieldGeometry& geometry, const Sight& sight,
                const ChartStyle& style) {
    const auto draw = [&](const std::vector<Vec3>& line, unsigned ink, Qt::PenStyle dash) {
        QPolygonF points;
        for (const Vec3& p : line) points << sight(p.x(), p.y(), p.z());
        if (!points.isEmpty()) points << points.front();
        painter.setPen(QPen(colour(ink), 1.2, dash));
        painter.drawPolyline(points);
    };
    painter.setBrush(Qt::NoBrush);
    draw(geometry.skin_edge, style.muted, Qt::SolidLine);
    draw(geometry.placode_edge, style.critical, Qt::SolidLine);
    if (style.plan) draw(geometry.planned_contour, style.text, Qt::DashLine);
}

void draw_path(QPainter& painter, const sim::Recording& recording, size_t tool, const Sight& sight,
               const QColor& ink, Qt::PenStyle dash) {
    QPainterPath path, hot;
    bool down = false, hot_down = false;
    for (size_t i = 0; i < recording.samples.size(); i += 2) {
        const sim::ToolSample& sample = recording.samples[i].tools[tool];
        if (!near_field(sample)) {
            down = hot_down = false;
            continue;
        }
        const QPointF p = sight(sample.tip_m[0], sample.tip_m[1], sample.tip_m[2]);
        down ? path.lineTo(p) : path.moveTo(p);
        down = true;
        if (sample.power_w > 0) {
            hot_down ? hot.lineTo(p) : hot.moveTo(p);
            hot_down = true;
        } else {
            hot_down = false;
        }
    }
    painter.setBrush(Qt::NoBrush);
    QColor thin = ink;
    thin.setAlphaF(0.75F);
    painter.setPen(QPen(thin, 1, dash));
    if (!path.isEmpty()) painter.drawPath(path);
    QPen thick(ink, 2.8);
    thick.setCapStyle(Qt::RoundCap);
    thick.setJoinStyle(Qt::RoundJoin);
    painter.setPen(thick);
    // Of a tool without energy: an empty path becomes one that is closed before it begins in a PDF.
    if (!hot.isEmpty()) painter.drawPath(hot);
}

/// Which way is which: words at the left and right, top and bottom.
std::array<const char*, 4> directions(Side side) {
    switch (side) {
        case Side::kAbove:
            return {"left", "right", "cranial", "caudal"};
        case Side::kFromSide:
            return {"cranial", "caudal", "outward", "inward"};
        case Side::kFromFeet:
            return {"left", "right", "outward", "inward"};
    }
    return {};
}

void draw_frame(QPainter& painter, const QRectF& where, const QRectF& plot, Side side,
                const Sight& sight, const ChartStyle& style) {
    const double px = style.font_px, line = 1.35 * px;
    const char* names[]{"From above", "From the left side", "From the feet"};
    draw_text(painter, QRectF(where.left(), where.top(), where.width(), line), Qt::AlignHCenter,
              figure_word(names[static_cast<size_t>(side)]), style.text, px, true);
    const auto words = directions(side);
    const QRectF foot(where.left(), plot.bottom() + 2, where.width(), line);
    draw_text(painter, foot, Qt::AlignLeft, QStringLiteral("\u2190 ") + figure_word(words[0]),
              style.muted, px);
    draw_text(painter, foot, Qt::AlignRight, figure_word(words[1]) + QStringLiteral(" \u2192"),
              style.muted, px);
    draw_text(painter, QRectF(where.left(), where.top() + line, where.width(), line),
              Qt::AlignHCenter, QStringLiteral("\u2191 ") + figure_word(words[2]), style.muted, px);
    const double bar = 0.005 * sight.scale;
    const QPointF left(where.center().x() - bar / 2, plot.bottom() + line - 3);
    painter.setPen(QPen(colour(style.text), 1.5));
    painter.drawLine(left, left + QPointF(bar, 0));
    draw_text(painter, QRectF(where.center().x() - 40, plot.bottom() + line, 80, line),
              Qt::AlignHCenter, QStringLiteral("5 mm"), style.muted, px);
}

constexpr std::array kDashes{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};

std::array<unsigned, 4> inks(const ChartStyle& style) {
    return {style.accent, style.warn, style.good, style.text};
}

/// The key: a piece of each line with its name, in as many rows as the names need.
struct Key {
    struct Entry {
        size_t tool = 0, look = 0;
        QString name;
        double left = 0, width = 0;
        int row = 0;
    };
    static constexpr double kLine = 20, kGap = 4, kBetween = 8;
    std::vector<Entry> entries;
    int rows = 0;

    Key(const sim::Recording& recording, double width, const ChartStyle& style) {
        double x = 0;
        for (size_t t = 0; t < recording.header.tools.size() && t < sim::kMaxTools; ++t) {
            const sim::ToolKind kind = recording.header.tools[t].kind;
            if (kind == sim::ToolKind::kScope) continue;
            Entry entry{t, entries.size() % kDashes.size(), tool_words(kind), 0, 0, 0};
            entry.width = kLine + kGap + text_width(entry.name, style.font_px) + 1;
            if (x > 0 && x + entry.width > width) {
                x = 0;
                ++rows;
            }
            entry.left = x;
            entry.row = rows;
            x += entry.width + kBetween;
            entries.push_back(entry);
        }
        rows += entries.empty() ? 0 : 1;
    }

    void draw(QPainter& painter, const QRectF& where, const ChartStyle& style) const {
        const double line = 1.35 * style.font_px;
        for (const Entry& entry : entries) {
            const double x = where.left() + entry.left,
                         y = where.bottom() - 0.55 * style.font_px - (rows - 1 - entry.row) * line;
            painter.setPen(QPen(colour(inks(style)[entry.look]), 2, kDashes[entry.look]));
            painter.drawLine(QPointF(x, y), QPointF(x + kLine, y));
            draw_text(painter,
                      QRectF(x + kLine + kGap, y - 0.7 * line, entry.width - kLine, 1.4 * line),
                      Qt::AlignLeft | Qt::AlignVCenter, entry.name, style.muted, style.font_px);
        }
    }
};

}  // namespace

void draw_trajectory(QPainter& painter, const QRectF& where, const sim::Recording& recording,
                     Side side, const ChartStyle& style) {
    const double line = 1.35 * style.font_px;
    const Key key(recording, where.width(), style);
    const QRectF plot = where.adjusted(6, 2.2 * line, -6, -(2.3 + key.rows) * line);
    if (plot.width() < 30 || plot.height() < 30) return;
    const Sight sight = sight_of(plot, recording, side);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    painter.save();
    painter.setClipRect(plot.adjusted(-4, -4, 4, 4));
    draw_lines(painter, recording.header.geometry, sight, style);
    for (const Key::Entry& entry : key.entries) {
        draw_path(painter, recording, entry.tool, sight, colour(inks(style)[entry.look]),
                  kDashes[entry.look]);
    }
    painter.restore();
    draw_frame(painter, where, plot, side, sight, style);
    key.draw(painter, where, style);
    painter.restore();
}

}  // namespace placode::reports
