// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/table_width.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "ui/shell/theme.h"

namespace placode::ui {
namespace {

constexpr int kRowsLooked = 20;  ///< For buttons.
constexpr int kTitleLines = 3, kTitlePadding = 20;
constexpr int kCellPadding = 28;                    ///< Of the style sheet and of Qt [px].
constexpr int kTitlePx = 12, kTitleLine = 17;       ///< Letters and lines of a title [px].
constexpr int kUpright = 100, kTurnedHeight = 168;  ///< Least width across; height turned [px].

/// Largest width that every column may have so that all of them fit into `room`; at least `least`.
int widest_allowed(std::vector<int> wanted, int room, int least) {
    std::sort(wanted.begin(), wanted.end());
    int left = room;
    for (size_t i = 0; i < wanted.size(); ++i) {
        const int share = left / static_cast<int>(wanted.size() - i);
        if (wanted[i] > share) return std::max(least, share);
        left -= wanted[i];
    }
    return room;
}

class WidthKeeper : public QObject {
 public:
    explicit WidthKeeper(QTableWidget* table) : QObject(table), table_(table) {
        setObjectName("width_keeper");
        table->viewport()->installEventFilter(this);
        later_.setSingleShot(true);
        connect(&later_, &QTimer::timeout, this, [this] { learn(plain_); });
    }
    static WidthKeeper& of(QTableWidget* table) {
        QObject* known = table->findChild<QObject*>("width_keeper", Qt::FindDirectChildrenOnly);
        auto* keeper = dynamic_cast<WidthKeeper*>(known);
        return keeper != nullptr ? *keeper : *new WidthKeeper(table);
    }
    /// With what the page asks for next, or without anything special when it asks for nothing.
    void learnLater(int stretch) {
        plain_ = {.stretch = stretch};
        wanted_.clear();
        later_.start(0);
    }
    /// Takes the widths of now as those that are wanted.
    void learn(const TableFit& fit) {
        later_.stop();
        fit_ = fit;
        wanted_.clear();
        buttons_.clear();
        for (int c = 0; c < table_->columnCount(); ++c) {
            table_->setColumnHidden(c, false);
            for (int row = 0; row < table_->rowCount() && row < kRowsLooked; ++row)
                if (table_->cellWidget(row, c) != nullptr) buttons_.insert(c);
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
        if (std::ssize(wanted_) != table_->columnCount()) return;
        const int room = table_->viewport()->width();
        int needed = std::accumulate(wanted_.begin(), wanted_.end(), 0);
        std::set<int> left_out;
        for (const int c : fit_.drop) {
            if (needed <= room || c >= table_->columnCount()) break;
            needed -= wanted_[static_cast<size_t>(c)];
            left_out.insert(c);
        }
        std::vector<int> shown;
        int fixed = 0;
        for (int c = 0; c < table_->columnCount(); ++c) {
            const bool out = left_out.contains(c);
            if (table_->isColumnHidden(c) != out) table_->setColumnHidden(c, out);
            if (out || c == fit_.stretch) continue;
            if (buttons_.contains(c))
                fixed += wanted_[static_cast<size_t>(c)];
            else
                shown.push_back(wanted_[static_cast<size_t>(c)]);
        }
        const int given = room - fixed - static_cast<int>(shown.size()) * fit_.give_way_px;
        const int kept = fit_.give_way_px > 0
                             ? std::max(fit_.keep_px, std::min(fit_.least_px, given))
                             : fit_.keep_px;
        const int most = widest_allowed(shown, room - kept - fixed, fit_.least_column_px);
        for (int c = 0; c < table_->columnCount(); ++c)
            if (c != fit_.stretch && !left_out.contains(c) && !buttons_.contains(c))
                table_->setColumnWidth(c, std::min(most, wanted_[static_cast<size_t>(c)]));
    }
    QTableWidget* table_;
    TableFit fit_, plain_;
    QTimer later_;
    std::vector<int> wanted_;
    std::set<int> buttons_;  ///< Columns of buttons keep their width: half a button says nothing.
};

/// Keeps every row as high as the widest of its texts needs.
class RowWrapper : public QObject {
 public:
    RowWrapper(QTableWidget* table, int shown) : QObject(table), table_(table), shown_(shown) {
        table->setWordWrap(true);
        connect(table->horizontalHeader(), &QHeaderView::sectionResized, this,
                [this] { later_.start(0); });
        later_.setSingleShot(true);
        connect(&later_, &QTimer::timeout, this, [this] { apply(); });
        apply();
    }

 private:
    [[nodiscard]] int heightOf(int row) const {
        int most = kTouchTarget;
        for (int c = 0; c < table_->columnCount(); ++c) {
            const QTableWidgetItem* item = table_->item(row, c);
            if (item == nullptr || table_->isColumnHidden(c)) continue;
            const int room = std::max(40, table_->columnWidth(c) - kCellPadding);
            const QRect text = table_->fontMetrics().boundingRect(
                QRect(0, 0, room, 10000), Qt::AlignLeft | Qt::TextWordWrap, item->text());
            most = std::max(most, text.height() + kSpace16);
        }
        return most;
    }
    void apply() {
        int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
        for (int row = 0; row < table_->rowCount(); ++row) {
            const int needed = heightOf(row);
            if (table_->rowHeight(row) != needed) table_->setRowHeight(row, needed);
            if (row < shown_) height += needed;
        }
        table_->setMinimumHeight(height);
    }
    QTableWidget* table_;
    int shown_;
    QTimer later_;  ///< Several columns change together.
};

/// Words on lines of `width` px, the last line and words without room end in dots.
QString in_lines(const QString& title, const QFontMetrics& words, int width, int most) {
    QStringList lines;
    QString line;
    for (const QString& word : title.split(' ')) {
        const QString longer = line.isEmpty() ? word : line + ' ' + word;
        if (line.isEmpty() || lines.size() + 1 == most ||
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

/// Titles of narrow columns are turned: across, a column of 60 px shows three letters of them.
class TitleHeader : public QHeaderView {
 public:
    TitleHeader(int first, QWidget* parent)
        : QHeaderView(Qt::Horizontal, parent), first_(first), bold_(font()) {
        setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        setHighlightSections(false);
        bold_.setPixelSize(kTitlePx);
        bold_.setWeight(QFont::DemiBold);
        connect(this, &QHeaderView::sectionResized, this, [this] { arrange(); });
    }
    /// Takes the titles of now as those to show.
    void learn() {
        for (int c = first_; c < count(); ++c) {
            QTableWidgetItem* title = item(c);
            title->setToolTip(title->text());
            title->setData(Qt::AccessibleTextRole, title->text());
            title->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        learned_ = true;
        arrange();
    }

 protected:
    void paintSection(QPainter* painter, const QRect& rect, int column) const override {
        painter->save();
        QHeaderView::paintSection(painter, rect, column);
        painter->restore();
        if (!turned_ || column < first_) return;
        painter->save();
        painter->setFont(bold_);
        painter->setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter->translate(rect.left(), rect.bottom());
        painter->rotate(-90);
        const QRect room(kSpace8, 0, rect.height() - kSpace16, rect.width());
        painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                          in_lines(item(column)->toolTip(), QFontMetrics(bold_), room.width(),
                                   std::max(1, room.width() > 0 ? rect.width() / kTitleLine : 1)));
        painter->restore();
    }

 private:
    [[nodiscard]] QTableWidgetItem* item(int column) const {
        return qobject_cast<QTableWidget*>(parentWidget())->horizontalHeaderItem(column);
    }
    void arrange() {
        if (!learned_) return;
        turned_ = false;
        for (int c = first_; c < count(); ++c)
            turned_ = turned_ || (!isSectionHidden(c) && sectionSize(c) < kUpright);
        const QFontMetrics words(bold_);
        for (int c = first_; c < count(); ++c)
            item(c)->setText(turned_ ? QString()
                                     : in_lines(item(c)->toolTip(), words,
                                                sectionSize(c) - kTitlePadding, kTitleLines));
        setFixedHeight(turned_ ? kTurnedHeight : kTitleLines * words.lineSpacing() + kSpace16);
    }
    int first_;
    bool learned_ = false, turned_ = false;
    QFont bold_;
};

}  // namespace

void use_title_header(QTableWidget* table, int first) {
    auto* header = new TitleHeader(first, table);
    table->setHorizontalHeader(header);
    header->setSectionsClickable(true);
    header->show();
}

void wrap_titles(QTableWidget* table) {
    if (auto* header = dynamic_cast<TitleHeader*>(table->horizontalHeader())) header->learn();
}

void wrap_rows(QTableWidget* table, int shown) { new RowWrapper(table, shown); }

void keep_within(QTableWidget* table, const TableFit& fit) { WidthKeeper::of(table).learn(fit); }

void keep_within_later(QTableWidget* table, int stretch) {
    WidthKeeper::of(table).learnLater(stretch);
}

}  // namespace placode::ui
