// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Coloured cells of a table.

#include <QPainter>
#include <QStyledItemDelegate>

namespace placode::ui {

/// The style sheet draws cells without their own background: this one does it.
class HeatDelegate : public QStyledItemDelegate {
 public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const QVariant brush = index.data(Qt::BackgroundRole);
        if (brush.isValid())
            painter->fillRect(option.rect.adjusted(2, 2, -2, -2), brush.value<QBrush>());
        // In a narrow column the style's margins would leave no room for a score.
        QStyleOptionViewItem drawn = option;
        initStyleOption(&drawn, index);
        const QString text = drawn.text;
        const int width = drawn.fontMetrics.horizontalAdvance(text);
        if (!brush.isValid() || width + kMargins <= option.rect.width())
            return QStyledItemDelegate::paint(painter, option, index);
        painter->save();
        painter->setFont(drawn.font);
        painter->setPen(drawn.palette.color(QPalette::Text));
        painter->drawText(option.rect, Qt::AlignCenter, text);
        if ((option.state & QStyle::State_Selected) != 0)
            painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
        painter->restore();
    }

 private:
    static constexpr int kMargins = 32;  ///< Of a cell's text, both sides [px].
};

}  // namespace placode::ui
