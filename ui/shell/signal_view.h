// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Live signals of one arm: where it is seen from the operator, how deep, and the force on it.

#include <QWidget>
#include <deque>

#include "ui/shell/device_tester.h"
#include "ui/shell/theme.h"

namespace placode::ui {

/// Main thread. From left to right: right and up with a trail, depth, force against its ceiling.
class SignalView : public QWidget {
    Q_OBJECT
 public:
    explicit SignalView(const Tokens& colors, QWidget* parent = nullptr);
    void show(const TriedArm& arm, double limit_n, bool floor);

 protected:
    void paintEvent(QPaintEvent* event) override;

 private:
    void paintPlane(QPainter& painter, const QRectF& box) const;
    void paintBar(QPainter& painter, const QRectF& box, double share, const QColor& color,
                  const QString& name, const QString& value, bool middle) const;

    Tokens colors_;
    TriedArm arm_;
    double limit_n_ = 0;
    bool floor_ = false;
    std::deque<QPointF> trail_;  // mm
};

}  // namespace placode::ui
