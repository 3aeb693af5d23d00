// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The damage ledger on a time line: one lane for each kind of harm, phases above, minutes below.
// Severity shows as height and as a sign, never by colour alone.

#include <algorithm>
#include <cmath>

#include "assessment/statistics.h"
#include "reports/attempt_figures.h"
#include "reports/plot_parts.h"
#include "reports/words.h"

namespace placode::reports {
namespace {

using assessment::LedgerEntry;

/// Places of the parts in `where`.
struct Frame {
    QRectF plot;  ///< Lanes only.
    double lane = 0, label = 0, phase = 0;
    LinearScale time;
};

Frame frame_of(const QRectF& where, const LedgerPicture& picture, const ChartStyle& style) {
    Frame frame;
    frame.label = 6.2 * style.font_px;
    frame.phase = 1.9 * style.font_px;
    const double flags = picture.marks.empty() ? 0 : 1.9 * style.font_px;
    frame.plot = where.adjusted(frame.label, frame.phase + flags, -1.5 * style.font_px,
                                -2.1 * style.font_px);
    frame.lane = frame.plot.height() / picture.lanes;
    frame.time = {0, std::max(1e-3, picture.duration_s), frame.plot.left(), frame.plot.right()};
    return frame;
}

QRectF box_of(const LedgerEntry& entry, const Frame& frame) {
    const double top = frame.plot.top() + frame.lane * static_cast<double>(entry.lane);
    const double height = (entry.critical ? 0.84 : 0.56) * frame.lane;
    const double from = frame.time.at(entry.from_s), to = frame.time.at(entry.to_s);
    const double width = std::max(7.0, to - from);
    return {std::min(from - 1, frame.plot.right() - width), top + (frame.lane - height) / 2, width,
            height};
}

void draw_phases(QPainter& painter, const LedgerPicture& picture, const Frame& frame,
                 const ChartStyle& style) {
    for (size_t i = 0; i < picture.phases.size(); ++i) {
        const double from = frame.time.at(picture.phases[i].from_s);
        const double to = i + 1 < picture.phases.size()
                              ? frame.time.at(picture.phases[i + 1].from_s)
                              : frame.plot.right();
        const QRectF band(from, frame.plot.top() - frame.phase + 2, std::max(0.0, to - from),
                          frame.phase - 6);
        QColor fill = colour(style.muted);
        fill.setAlphaF(i % 2 == 0 ? 0.14F : 0.26F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawRect(band);
        const double text = 0.92 * style.font_px;
        if (band.width() > 2.4 * text)
            draw_text(painter, band.adjusted(4, 0, -2, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      phase_words(picture.phases[i].phase), style.text, text);
    }
}

void draw_axis(QPainter& painter, const LedgerPicture& picture, const Frame& frame,
               const ChartStyle& style) {
    // Steps that a clock knows.
    const double room = std::max(1.0, frame.plot.width() / (4.5 * style.font_px));
    double step = 1;
    for (const double each : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0}) {
        step = each;
        if (picture.duration_s / each <= room) break;
    }
    for (int i = 0; i * step <= picture.duration_s + 1e-6; ++i) {
        const double t = i * step;
        const double x = frame.time.at(t);
        painter.setPen(QPen(colour(style.line), 1));
        painter.drawLine(QPointF(x, frame.plot.top()), QPointF(x, frame.plot.bottom() + 3));
        draw_text(painter, QRectF(x - 30, frame.plot.bottom() + 4, 60, 1.4 * style.font_px),
                  Qt::AlignHCenter | Qt::AlignTop, minute_second(t), style.muted, style.font_px);
    }
    draw_text(painter,
              QRectF(frame.plot.left() - frame.label, frame.plot.bottom() + 4, frame.label - 34,
                     1.4 * style.font_px),
              Qt::AlignLeft | Qt::AlignTop, figure_word("min:s"), style.muted, style.font_px);
}

void draw_lanes(QPainter& painter, const LedgerPicture& picture, const Frame& frame,
                const ChartStyle& style) {
    for (int lane = 0; lane <= picture.lanes; ++lane) {
        const double y = frame.plot.top() + lane * frame.lane;
        painter.setPen(QPen(colour(style.line), 1));
        painter.drawLine(QPointF(frame.plot.left() - frame.label, y),
                         QPointF(frame.plot.right(), y));
        if (lane == picture.lanes) break;
        draw_text(painter, QRectF(frame.plot.left() - frame.label, y, frame.label - 8, frame.lane),
                  Qt::AlignLeft | Qt::AlignVCenter,
                  lane_words(static_cast<assessment::HarmLane>(lane)), style.text, style.font_px);
    }
    // When the pedal was down: a thin line at the foot of the energy lane.
    QColor on = colour(style.muted);
    on.setAlphaF(0.55F);
    const double foot = frame.plot.bottom() - 5;
    for (const auto& [from, to] : picture.energy)
        painter.fillRect(QRectF(frame.time.at(from), foot,
                                std::max(1.0, frame.time.at(to) - frame.time.at(from)), 4),
                         on);
}

void draw_entry(QPainter& painter, const LedgerEntry& entry, bool selected, const Frame& frame,
                const ChartStyle& style) {
    const QRectF box = box_of(entry, frame);
    const QColor ink = colour(entry.critical ? style.critical : style.warn);
    QColor fill = ink;
    fill.setAlphaF(0.75F);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(fill);
    if (entry.from_s == entry.to_s) {
        QPolygonF diamond;
        const QPointF c = box.center();
        const double half = std::min(box.width(), box.height()) / 2 + 1;
        diamond << c + QPointF(0, -half * 1.3) << c + QPointF(half, 0) << c + QPointF(0, half * 1.3)
                << c + QPointF(-half, 0);
        painter.drawPolygon(diamond);
    } else {
        painter.drawRoundedRect(box, 2, 2);
    }
    if (entry.critical)
        draw_text(painter, QRectF(box.right() + 2, box.top(), 12, box.height()),
                  Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("!"), style.critical,
                  1.1 * style.font_px, true);
    if (!selected) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour(style.text), 2));
    painter.drawRoundedRect(box.adjusted(-4, -4, 4, 4), 4, 4);
}

void draw_marks(QPainter& painter, const QRectF& where, const LedgerPicture& picture,
                const Frame& frame, const ChartStyle& style) {
    for (const TimeMark& mark : picture.marks) {
        const double x = frame.time.at(mark.time_s);
        const double size = 1.5 * style.font_px;
        const QRectF flag(x, where.top() + 1, size, size);
        painter.setPen(QPen(colour(style.accent), 1.5));
        painter.drawLine(flag.topLeft(), QPointF(x, frame.plot.bottom()));
        painter.setBrush(colour(style.accent));
        painter.drawRect(flag);
        draw_text(painter, flag, Qt::AlignCenter, QString::fromStdString(mark.label), style.surface,
                  style.font_px, true);
    }
    if (picture.cursor_s < 0) return;
    const double x = frame.time.at(std::min(picture.cursor_s, picture.duration_s));
    painter.setPen(QPen(colour(style.text), 2));
    painter.drawLine(QPointF(x, frame.plot.top() - 4), QPointF(x, frame.plot.bottom() + 4));
}

}  // namespace

LedgerPicture ledger_picture(const sim::Recording& recording, const TaskScope& scope) {
    LedgerPicture picture;
    picture.duration_s = recording.end.duration_s;
    picture.entries = assessment::damage_ledger(recording.events, recording.header.geometry);
    if (scope.phases()) picture.phases = assessment::phase_starts(recording.events);
    if (!scope.energy) --picture.lanes;
    // An entry is never hidden, whatever the task says.
    for (const LedgerEntry& entry : picture.entries)
        picture.lanes = std::max(picture.lanes, static_cast<int>(entry.lane) + 1);
    for (const sim::Event& event : recording.events)
        if (event.kind == sim::EventKind::kEnergyOff)
            picture.energy.emplace_back(std::max(0.0, event.time_s - event.value), event.time_s);
    return picture;
}

double ledger_height(const ChartStyle& style) {
    return 4 * 2.9 * style.font_px + 6 * style.font_px;
}

void draw_ledger(QPainter& painter, const QRectF& where, const LedgerPicture& picture,
                 const ChartStyle& style) {
    const Frame frame = frame_of(where, picture, style);
    if (frame.plot.width() < 40 || frame.plot.height() < 20) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(where, colour(style.surface));
    draw_axis(painter, picture, frame, style);
    draw_lanes(painter, picture, frame, style);
    draw_phases(painter, picture, frame, style);
    for (size_t i = 0; i < picture.entries.size(); ++i)
        draw_entry(painter, picture.entries[i], static_cast<int>(i) == picture.selected, frame,
                   style);
    if (picture.entries.empty()) {
        // In the middle of a lane: the line between two lanes would strike the words out.
        const double top = frame.plot.top() + std::floor((picture.lanes - 1) / 2.0) * frame.lane;
        draw_text(painter, QRectF(frame.plot.left(), top, frame.plot.width(), frame.lane),
                  Qt::AlignCenter, figure_word("No damage was recorded."), style.muted,
                  1.1 * style.font_px);
    }
    draw_marks(painter, where, picture, frame, style);
    painter.restore();
}

std::vector<QRectF> ledger_boxes(const QRectF& where, const LedgerPicture& picture,
                                 const ChartStyle& style) {
    const Frame frame = frame_of(where, picture, style);
    std::vector<QRectF> boxes;
    for (const LedgerEntry& entry : picture.entries) {
        QRectF box = box_of(entry, frame);
        const double more = std::max(0.0, 12 - box.width()) / 2;
        boxes.push_back(box.adjusted(-more, -4, more, 4));
    }
    return boxes;
}

double ledger_time_at(const QRectF& where, const LedgerPicture& picture, const ChartStyle& style,
                      double x_px) {
    const Frame frame = frame_of(where, picture, style);
    const double share = (x_px - frame.plot.left()) / std::max(1.0, frame.plot.width());
    return std::clamp(share, 0.0, 1.0) * picture.duration_s;
}

std::optional<Band> band_of(const std::vector<double>& values) {
    if (values.empty()) return std::nullopt;
    Band band;
    band.n = static_cast<int>(values.size());
    band.mean = *assessment::mean_of(values);
    band.sd = assessment::sample_sd(values).value_or(0);
    band.low = *std::min_element(values.begin(), values.end());
    band.high = *std::max_element(values.begin(), values.end());
    return band;
}

void draw_band(QPainter& painter, const QRectF& where, const Band& band, double value,
               const ChartStyle& style) {
    double low = std::min({band.low, band.mean - band.sd, value});
    double high = std::max({band.high, band.mean + band.sd, value});
    if (!(high > low)) {
        low -= 1;
        high += 1;
    }
    const LinearScale x{low, high, where.left() + 8, where.right() - 8};
    const double y = where.center().y(), half = std::min(8.0, where.height() / 3);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = colour(style.muted);
    fill.setAlphaF(0.3F);
    painter.setPen(QPen(colour(style.muted), 1));
    painter.drawLine(QPointF(x.at(band.low), y), QPointF(x.at(band.high), y));
    painter.fillRect(QRectF(QPointF(x.at(band.mean - band.sd), y - half),
                            QPointF(x.at(band.mean + band.sd), y + half)),
                     fill);
    painter.drawLine(QPointF(x.at(band.mean), y - half), QPointF(x.at(band.mean), y + half));
    painter.setPen(QPen(colour(style.surface), 1.5));
    painter.setBrush(colour(style.accent));
    painter.drawEllipse(QPointF(x.at(value), y), 5.5, 5.5);
    painter.restore();
}

}  // namespace placode::reports
