// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/signature_pad.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "ui/shell/theme.h"

namespace placode::ui {
namespace {

/// Shorter is a touch by mistake, not a name.
constexpr double kLeastLength = 40;

}  // namespace

SignaturePad::SignaturePad(const QColor& ink, const QColor& rule) : ink_(ink), rule_(rule) {
    setMinimumSize(280, 120);
    setMaximumHeight(120);
    setCursor(Qt::CrossCursor);
}

QString SignaturePad::path() const {
    QString text;
    double length = 0;
    for (const auto& stroke : strokes_) {
        for (size_t i = 0; i < stroke.size(); ++i) {
            if (i > 0) length += QLineF(stroke[i - 1], stroke[i]).length();
            text += QString("%1%2 %3 ")
                        .arg(i == 0 ? 'M' : 'L')
                        .arg(QString::number(stroke[i].x(), 'f', 0),
                             QString::number(stroke[i].y(), 'f', 0));
        }
    }
    return length < kLeastLength ? QString() : text.trimmed();
}

void SignaturePad::draw(const QString& path) {
    strokes_.clear();
    const QStringList parts = path.split(' ', Qt::SkipEmptyParts);
    for (qsizetype i = 0; i + 1 < parts.size(); i += 2) {
        if (parts[i].startsWith('M') || strokes_.empty()) strokes_.emplace_back();
        strokes_.back().emplace_back(parts[i].mid(1).toDouble(), parts[i + 1].toDouble());
    }
    update();
    if (changed) changed();
}

void SignaturePad::clear() {
    strokes_.clear();
    update();
    if (changed) changed();
}

void SignaturePad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(rule_, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
    painter.drawLine(QPointF(kSpace16, height() - 28), QPointF(width() - kSpace16, height() - 28));
    painter.setPen(QPen(ink_, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const auto& stroke : strokes_)
        painter.drawPolyline(stroke.data(), static_cast<int>(stroke.size()));
}

void SignaturePad::mousePressEvent(QMouseEvent* event) {
    strokes_.push_back({event->position()});
    update();
}

void SignaturePad::mouseMoveEvent(QMouseEvent* event) {
    if (strokes_.empty()) return;
    const QPointF at(std::clamp(event->position().x(), 0.0, width() - 1.0),
                     std::clamp(event->position().y(), 0.0, height() - 1.0));
    strokes_.back().push_back(at);
    update();
}

void SignaturePad::mouseReleaseEvent(QMouseEvent*) {
    if (changed) changed();
}

QPixmap signature_picture(const QString& path, const QColor& ink) {
    QPainterPath lines;
    const QStringList parts = path.split(' ');
    for (int i = 0; i + 1 < parts.size(); i += 2) {
        const QPointF at(parts[i].mid(1).toDouble(), parts[i + 1].toDouble());
        if (parts[i].startsWith('M'))
            lines.moveTo(at);
        else
            lines.lineTo(at);
    }
    constexpr int kMargin = 6;
    const QRect bounds =
        lines.boundingRect().toAlignedRect().adjusted(-kMargin, -kMargin, kMargin, kMargin) &
        QRect(-kMargin, -kMargin, 4096, 4096);
    QPixmap picture(bounds.size());
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(-bounds.topLeft());
    painter.setPen(QPen(ink, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(lines);
    return picture;
}

}  // namespace placode::ui
