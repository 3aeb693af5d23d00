// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/table_width.h"

#include <QEvent>
#include <algorithm>
#include <vector>

namespace placode::ui {
namespace {

constexpr int kLeastColumn = 64, kLeastStretch = 110;

/// Largest width that every column may have so that all of them fit into `room`.
int widest_allowed(std::vector<int> wanted, int room) {
    std::sort(wanted.begin(), wanted.end());
    int left = room;
    for (size_t i = 0; i < wanted.size(); ++i) {
        const int share = left / static_cast<int>(wanted.size() - i);
        if (wanted[i] > share) return std::max(kLeastColumn, share);
        left -= wanted[i];
    }
    return room;
}

class WidthKeeper : public QObject {
 public:
    WidthKeeper(QTableWidget* table, int stretch)
        : QObject(table), table_(table), stretch_(stretch) {
        setObjectName("width_keeper");
        table->viewport()->installEventFilter(this);
    }
    /// Takes the widths of now as those that are wanted.
    void learn() {
        wanted_.clear();
        for (int c = 0; c < table_->columnCount(); ++c)
            if (c != stretch_) wanted_.push_back(table_->columnWidth(c));
        for (int row = 0; row < table_->rowCount(); ++row)
            for (int c = 0; c < table_->columnCount(); ++c) {
                QTableWidgetItem* item = table_->item(row, c);
                if (item != nullptr && item->toolTip().isEmpty()) item->setToolTip(item->text());
            }
        apply();
    }

 private:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Resize) apply();
        return QObject::eventFilter(watched, event);
    }
    void apply() {
        const int most = widest_allowed(wanted_, table_->viewport()->width() - kLeastStretch);
        size_t next = 0;
        for (int c = 0; c < table_->columnCount(); ++c)
            if (c != stretch_) table_->setColumnWidth(c, std::min(most, wanted_[next++]));
    }
    QTableWidget* table_;
    int stretch_;
    std::vector<int> wanted_;
};

}  // namespace

void keep_within(QTableWidget* table, int stretch) {
    QObject* known = table->findChild<QObject*>("width_keeper", Qt::FindDirectChildrenOnly);
    auto* keeper = dynamic_cast<WidthKeeper*>(known);
    if (keeper == nullptr) keeper = new WidthKeeper(table, stretch);
    keeper->learn();
}

}  // namespace placode::ui
