// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/course_station.h"

#include <QPainter>

namespace placode::ui {

using curriculum::StageStatus;

CourseStation::CourseStation(const Tokens& colors, int number, StageStatus status, bool first,
                             bool last, bool next)
    : colors_(colors), number_(number), status_(status), first_(first), last_(last), next_(next) {
    setFixedWidth(56);
}

void CourseStation::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF centre(width() / 2.0, height() / 2.0);
    const double r = 18;
    painter.setPen(QPen(colors_.line, 3));
    if (!first_) painter.drawLine(QPointF(centre.x(), 0), centre - QPointF(0, r));
    if (!last_) painter.drawLine(centre + QPointF(0, r), QPointF(centre.x(), height()));
    const bool mastered = status_ == StageStatus::kMastered;
    const QColor edge = mastered ? colors_.good : next_ ? colors_.accent : colors_.field;
    painter.setPen(QPen(edge, 2.5));
    painter.setBrush(mastered ? colors_.good_soft : next_ ? colors_.accent_soft : colors_.raised);
    painter.drawEllipse(centre, r, r);
    const QRect box(static_cast<int>(centre.x()) - 10, static_cast<int>(centre.y()) - 10, 20, 20);
    if (mastered) {
        line_icon("check", colors_.good).paint(&painter, box);
    } else if (status_ == StageStatus::kLocked) {
        line_icon("lock", colors_.muted).paint(&painter, box);
    } else {
        QFont bold = font();
        bold.setBold(true);
        painter.setFont(bold);
        painter.setPen(next_ ? colors_.accent : colors_.text);
        painter.drawText(rect(), Qt::AlignCenter, QString::number(number_));
    }
}

}  // namespace placode::ui
