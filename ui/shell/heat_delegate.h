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
        QStyledItemDelegate::paint(painter, option, index);
    }
};

}  // namespace placode::ui
