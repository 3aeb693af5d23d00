// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What does not fit in a window: text that is cut, parts that lie on each other, sideways
// scrolling, targets too small for a finger.

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTableWidget>
#include <QTextEdit>
#include <QToolButton>

namespace placode::ui {

/// A finger hits 40 px and more: 44 px less the frame.
constexpr int kLeastTarget = 40;

inline QString said_of(const QWidget& widget) {
    QString text = widget.objectName();
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) text += " " + label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        text += " " + button->text();
    return QString("%1 \"%2\"").arg(widget.metaObject()->className(), text.trimmed().left(60));
}

inline void check_label(const QLabel& label, QStringList& wrong) {
    if (label.text().isEmpty()) return;
    const bool wraps = label.wordWrap() && label.heightForWidth(label.width()) > 0;
    const int height = wraps ? label.heightForWidth(label.width()) : label.sizeHint().height();
    if (label.height() + 1 < height)
        wrong << said_of(label) + QString(": %1 of %2 px high").arg(label.height()).arg(height);
    if (!label.wordWrap() && label.width() + 1 < label.sizeHint().width())
        wrong << said_of(label) +
                     QString(": %1 of %2 px wide").arg(label.width()).arg(label.sizeHint().width());
}

inline void check_button(const QAbstractButton& button, QStringList& wrong) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    const bool words = !button.text().isEmpty() &&
                       (tool == nullptr || tool->toolButtonStyle() != Qt::ToolButtonIconOnly);
    if (words && button.width() + 1 < button.sizeHint().width())
        wrong
            << said_of(button) +
                   QString(": %1 of %2 px wide").arg(button.width()).arg(button.sizeHint().width());
    if (button.focusPolicy() != Qt::NoFocus && button.height() < kLeastTarget)
        wrong << said_of(button) + QString(": %1 px high").arg(button.height());
}

inline void check_combo(const QComboBox& box, QStringList& wrong) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const int room =
        box.style()
            ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
            .width();
    const int wanted = box.fontMetrics().horizontalAdvance(box.currentText());
    if (wanted > room)
        wrong << QString("%1 \"%2\": %3 of %4 px wide")
                     .arg(box.objectName(), box.currentText())
                     .arg(room)
                     .arg(wanted);
    if (box.height() < kLeastTarget)
        wrong << said_of(box) + QString(": %1 px high").arg(box.height());
}

inline void check_headers(const QTableWidget& table, QStringList& wrong) {
    for (int c = 0; c < table.columnCount(); ++c) {
        const QTableWidgetItem* head = table.horizontalHeaderItem(c);
        if (head == nullptr || table.isColumnHidden(c)) continue;
        int wanted = 0;
        for (const QString& line : head->text().split('\n'))
            wanted =
                std::max(wanted, table.horizontalHeader()->fontMetrics().horizontalAdvance(line));
        if (wanted > table.columnWidth(c))
            wrong << QString("%1: header \"%2\" has %3 of %4 px")
                         .arg(table.objectName(), head->text())
                         .arg(table.columnWidth(c))
                         .arg(wanted);
    }
}

/// Whether a layout, or one inside it, places the widget.
inline bool places(const QLayout* layout, const QWidget* widget) {
    for (int i = 0; layout != nullptr && i < layout->count(); ++i) {
        QLayoutItem* item = layout->itemAt(i);
        if (item->widget() == widget || places(item->layout(), widget)) return true;
    }
    return false;
}

/// Visible children of one parent that share more than a hairline.
inline void check_overlaps(const QWidget& parent, QStringList& wrong) {
    QList<const QWidget*> children;
    for (const QObject* each : parent.children())
        if (const auto* child = qobject_cast<const QWidget*>(each))
            // What no layout places was placed by hand, so it is meant.
            if (child->isVisible() && !child->isWindow() && places(parent.layout(), child))
                children << child;
    for (qsizetype i = 0; i < children.size(); ++i)
        for (qsizetype k = i + 1; k < children.size(); ++k) {
            const QRect both = children[i]->geometry() & children[k]->geometry();
            if (both.width() > 2 && both.height() > 2)
                wrong << said_of(*children[i]) + " lies on " + said_of(*children[k]);
        }
}

/// Everything in `window` that does not fit, in words; empty when all is well.
inline QStringList misfits(const QWidget& window) {
    QStringList wrong;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        check_overlaps(*widget, wrong);
        const bool text = qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
                          qobject_cast<const QTextEdit*>(widget) != nullptr;
        if (const auto* area = qobject_cast<const QAbstractScrollArea*>(widget); area && !text)
            if (area->horizontalScrollBar()->maximum() > 0)
                wrong << said_of(*widget) + " scrolls sideways";
        if (const auto* label = qobject_cast<const QLabel*>(widget)) check_label(*label, wrong);
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            check_button(*button, wrong);
        if (const auto* box = qobject_cast<const QComboBox*>(widget)) check_combo(*box, wrong);
        if (const auto* table = qobject_cast<const QTableWidget*>(widget))
            check_headers(*table, wrong);
    }
    return wrong;
}

}  // namespace placode::ui
