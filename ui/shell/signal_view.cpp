// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/signal_view.h"

#include <QLocale>
#include <QPainter>
#include <cmath>

#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

constexpr double kReachMm = 80;
constexpr size_t kTrail = 60;
constexpr qreal kBarWidth = 76, kTextHeight = 20;

double size_of(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

}  // namespace

SignalView::SignalView(const Tokens& colors, QWidget* parent) : QWidget(parent), colors_(colors) {
    setMinimumSize(320, 190);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SignalView::show(const TriedArm& arm, double limit_n, bool floor) {
    arm_ = arm;
    limit_n_ = limit_n;
    floor_ = floor;
    trail_.emplace_back(arm.position_mm[0], arm.position_mm[1]);
    if (trail_.size() > kTrail) trail_.pop_front();
    setAccessibleDescription(
        tr("right %1 mm, up %2 mm, towards you %3 mm, force %4 N")
            .arg(format_number(arm.position_mm[0], 1), format_number(arm.position_mm[1], 1),
                 format_number(arm.position_mm[2], 1), format_number(size_of(arm.force_n), 2)));
    update();
}

void SignalView::paintPlane(QPainter& painter, const QRectF& box) const {
    const auto at = [&](const QPointF& mm) {
        return QPointF(box.center().x() + mm.x() / kReachMm * box.width() / 2,
                       box.center().y() - mm.y() / kReachMm * box.height() / 2);
    };
    painter.setPen(QPen(colors_.line, 1));
    painter.setBrush(colors_.surface);
    painter.drawRoundedRect(box, 8, 8);
    painter.setClipRect(box);
    painter.drawLine(at({-kReachMm, 0}), at({kReachMm, 0}));
    painter.drawLine(at({0, -kReachMm}), at({0, kReachMm}));
    if (floor_) {
        const double y = arm_.position_mm[1] - arm_.height_mm;
        painter.setPen(QPen(colors_.accent, 2));
        painter.drawLine(at({-kReachMm, y}), at({kReachMm, y}));
    }
    painter.setPen(QPen(colors_.muted, 1.5));
    for (size_t i = 1; i < trail_.size(); ++i) painter.drawLine(at(trail_[i - 1]), at(trail_[i]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(arm_.status == "ready" ? colors_.accent : colors_.critical);
    if (!trail_.empty()) painter.drawEllipse(at(trail_.back()), 6, 6);
    painter.setClipping(false);
}

void SignalView::paintBar(QPainter& painter, const QRectF& box, double share, const QColor& color,
                          const QString& name, const QString& value, bool middle) const {
    const QRectF bar(box.center().x() - 10, box.top() + kTextHeight, 20,
                     box.height() - 2 * kTextHeight);
    painter.setPen(QPen(colors_.line, 1));
    painter.setBrush(colors_.surface);
    painter.drawRoundedRect(bar, 6, 6);
    share = std::clamp(std::isfinite(share) ? share : 0.0, -1.0, 1.0);
    const qreal zero = middle ? bar.center().y() : bar.bottom();
    const qreal reach = middle ? bar.height() / 2 : bar.height();
    QRectF fill(bar.left() + 3, zero, bar.width() - 6, -reach * share);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRect(fill.normalized());
    painter.setPen(colors_.muted);
    painter.drawText(QRectF(box.left(), box.top(), box.width(), kTextHeight - 2), Qt::AlignCenter,
                     name);
    painter.setPen(colors_.text);
    painter.drawText(QRectF(box.left(), box.bottom() - kTextHeight + 2, box.width(), kTextHeight),
                     Qt::AlignCenter, value);
}

void SignalView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF all = QRectF(rect()).adjusted(1, 1, -1, -1);
    paintPlane(painter,
               QRectF(all.left(), all.top(), all.width() - 2 * kBarWidth - 12, all.height()));
    const QRectF depth(all.right() - 2 * kBarWidth, all.top(), kBarWidth, all.height());
    paintBar(painter, depth, arm_.position_mm[2] / kReachMm, colors_.muted, tr("to you"),
             tr("%1 mm").arg(format_number(arm_.position_mm[2], 0)), true);
    const double force = size_of(arm_.force_n);
    const QRectF right(all.right() - kBarWidth, all.top(), kBarWidth, all.height());
    paintBar(painter, right, limit_n_ > 0 ? force / limit_n_ : 0,
             force > 0.98 * limit_n_ ? colors_.warn : colors_.accent, tr("force"),
             arm_.force_device ? tr("%1 N").arg(format_number(force, 2)) : QString("–"), false);
}

}  // namespace placode::ui
