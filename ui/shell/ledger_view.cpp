// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/ledger_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "reports/words.h"
#include "ui/shell/theme.h"

namespace placode::ui {

LedgerView::LedgerView(const AppContext& context, reports::LedgerPicture picture)
    : picture_(std::move(picture)),
      style_(chart_style(context.theme())),
      focus_(context.colors().accent) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(480, static_cast<int>(reports::ledger_height(style_)) + 8);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Damage over time"));
    setAccessibleDescription(tr("%n entry(s). Arrow keys go from one to the next.", nullptr,
                                static_cast<int>(picture_.entries.size())));
    setToolTip(tr("Click an entry, or use the arrow keys"));
}

QString LedgerView::words(int entry) const {
    if (entry < 0 || entry >= static_cast<int>(picture_.entries.size())) return {};
    const assessment::LedgerEntry& one = picture_.entries[static_cast<size_t>(entry)];
    QString text = reports::minute_second(one.from_s) + "  " + reports::ledger_words(one);
    const QString place = reports::place_words(one);
    if (!place.isEmpty()) text += " · " + place;
    if (one.critical) text += " · " + tr("critical");
    return text;
}

void LedgerView::select(int entry) {
    const int last = static_cast<int>(picture_.entries.size()) - 1;
    const int now = last < 0 ? -1 : std::clamp(entry, 0, last);
    if (now == picture_.selected) return;
    picture_.selected = now;
    if (now >= 0) setAccessibleDescription(words(now));
    update();
    if (selected) selected(now);
}

void LedgerView::setCursor_s(double time_s) {
    if (picture_.cursor_s == time_s) return;
    picture_.cursor_s = time_s;
    update();
}

void LedgerView::setMarks(std::vector<reports::TimeMark> marks) {
    picture_.marks = std::move(marks);
    update();
}

void LedgerView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    reports::draw_ledger(painter, area(), picture_, style_);
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(focus_, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
}

int LedgerView::entryAt(const QPointF& point) const {
    const std::vector<QRectF> boxes = reports::ledger_boxes(area(), picture_, style_);
    int best = -1;
    double nearest = 1e9;
    for (size_t i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].contains(point)) continue;
        const double away = std::abs(boxes[i].center().x() - point.x());
        if (away < nearest) {
            nearest = away;
            best = static_cast<int>(i);
        }
    }
    return best;
}

void LedgerView::mousePressEvent(QMouseEvent* event) {
    const int entry = entryAt(event->position());
    if (entry >= 0) {
        select(entry);
    } else if (chosen) {
        chosen(reports::ledger_time_at(area(), picture_, style_, event->position().x()), -1);
    }
}

void LedgerView::mouseDoubleClickEvent(QMouseEvent* event) {
    const int entry = entryAt(event->position());
    if (entry >= 0 && chosen) chosen(picture_.entries[static_cast<size_t>(entry)].from_s, entry);
}

void LedgerView::keyPressEvent(QKeyEvent* event) {
    const int now = picture_.selected;
    switch (event->key()) {
        case Qt::Key_Left:
            return select(now - 1);
        case Qt::Key_Right:
            return select(now + 1);
        case Qt::Key_Home:
            return select(0);
        case Qt::Key_End:
            return select(static_cast<int>(picture_.entries.size()) - 1);
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            if (now >= 0 && chosen) chosen(picture_.entries[static_cast<size_t>(now)].from_s, now);
            return;
        default:
            QWidget::keyPressEvent(event);
    }
}

void LedgerView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    if (picture_.selected < 0) select(0);
    update();
}

void LedgerView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

}  // namespace placode::ui
