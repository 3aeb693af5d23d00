// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/table_width.h"

#include <QEvent>
#include <QHeaderView>
#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "ui/shell/theme.h"

namespace placode::ui {
namespace {

constexpr int kLeastColumn = 52, kTitleLines = 3, kTitlePadding = 20;

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
    WidthKeeper(QTableWidget* table, TableFit fit)
        : QObject(table), table_(table), fit_(std::move(fit)) {
        setObjectName("width_keeper");
        table->viewport()->installEventFilter(this);
    }
    /// Takes the widths of now as those that are wanted.
    void learn() {
        wanted_.clear();
        for (int c = 0; c < table_->columnCount(); ++c) {
            table_->setColumnHidden(c, false);
            wanted_.push_back(c == fit_.stretch ? fit_.least_px : table_->columnWidth(c));
        }
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
        const int room = table_->viewport()->width();
        int needed = std::accumulate(wanted_.begin(), wanted_.end(), 0);
        std::set<int> left_out;
        for (const int c : fit_.drop) {
            if (needed <= room || c >= table_->columnCount()) break;
            needed -= wanted_[static_cast<size_t>(c)];
            left_out.insert(c);
        }
        std::vector<int> shown;
        for (int c = 0; c < table_->columnCount(); ++c) {
            const bool out = left_out.contains(c);
            if (table_->isColumnHidden(c) != out) table_->setColumnHidden(c, out);
            if (!out && c != fit_.stretch) shown.push_back(wanted_[static_cast<size_t>(c)]);
        }
        const int most = widest_allowed(shown, room - fit_.keep_px);
        for (int c = 0; c < table_->columnCount(); ++c)
            if (c != fit_.stretch && !left_out.contains(c))
                table_->setColumnWidth(c, std::min(most, wanted_[static_cast<size_t>(c)]));
    }
    QTableWidget* table_;
    TableFit fit_;
    std::vector<int> wanted_;
};

/// Words on lines of `width` px, the last line and words without room end in dots.
QString in_lines(const QString& title, const QFontMetrics& words, int width) {
    QStringList lines;
    QString line;
    for (const QString& word : title.split(' ')) {
        const QString longer = line.isEmpty() ? word : line + ' ' + word;
        if (line.isEmpty() || lines.size() + 1 == kTitleLines ||
            words.horizontalAdvance(longer) <= width) {
            line = longer;
        } else {
            lines << words.elidedText(line, Qt::ElideRight, width);
            line = word;
        }
    }
    lines << words.elidedText(line, Qt::ElideRight, width);
    return lines.join('\n');
}

}  // namespace

void wrap_titles(QTableWidget* table, int first) {
    QHeaderView* header = table->horizontalHeader();
    QFont bold = header->font();
    bold.setWeight(QFont::DemiBold);
    const QFontMetrics words(bold);
    const auto wrap = [table, first, words](int column, int width) {
        QTableWidgetItem* title = table->horizontalHeaderItem(column);
        if (column >= first && title != nullptr)
            title->setText(in_lines(title->toolTip(), words, width - kTitlePadding));
    };
    for (int c = first; c < table->columnCount(); ++c) {
        QTableWidgetItem* title = table->horizontalHeaderItem(c);
        title->setToolTip(title->text());
        title->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        wrap(c, table->columnWidth(c));
    }
    header->setFixedHeight(kTitleLines * words.lineSpacing() + kSpace16);
    QObject::connect(header, &QHeaderView::sectionResized, table,
                     [wrap](int column, int, int width) { wrap(column, width); });
}

void keep_within(QTableWidget* table, const TableFit& fit) {
    QObject* known = table->findChild<QObject*>("width_keeper", Qt::FindDirectChildrenOnly);
    auto* keeper = dynamic_cast<WidthKeeper*>(known);
    if (keeper == nullptr) keeper = new WidthKeeper(table, fit);
    keeper->learn();
}

}  // namespace placode::ui
