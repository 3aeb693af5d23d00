// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/parts.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QMessageBox>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <algorithm>

#include "ui/shell/dialog_frame.h"
#include "ui/shell/table_width.h"

namespace placode::ui {
namespace {

/// Strings of this file share one context for translators.
struct Parts {
    Q_DECLARE_TR_FUNCTIONS(Parts)
};

class NumberItem : public QTableWidgetItem {
 public:
    using QTableWidgetItem::QTableWidgetItem;
    bool operator<(const QTableWidgetItem& other) const override {
        return data(Qt::UserRole).toDouble() < other.data(Qt::UserRole).toDouble();
    }
};

class Picture : public QWidget {
 public:
    explicit Picture(std::function<void(QPainter&, const QRectF&)> draw) : draw_(std::move(draw)) {}

 protected:
    void paintEvent(QPaintEvent*) override {
        const qreal ratio = devicePixelRatioF();
        if (cache_.size() != size() * ratio) {
            cache_ = QPixmap(size() * ratio);
            cache_.setDevicePixelRatio(ratio);
            cache_.fill(Qt::transparent);
            QPainter painter(&cache_);
            painter.setRenderHint(QPainter::Antialiasing);
            draw_(painter, QRectF(rect()));
        }
        QPainter(this).drawPixmap(0, 0, cache_);
    }

 private:
    std::function<void(QPainter&, const QRectF&)> draw_;
    QPixmap cache_;
};

constexpr int kAskedRows = 50;  ///< Of a table, for their size.

/// Width of a column's longest text in the rows that are not asked for their size [px].
int longest_text(const QTableWidget& table, int column) {
    QString longest;
    for (int row = kAskedRows; row < table.rowCount(); ++row) {
        const QTableWidgetItem* item = table.item(row, column);
        if (item != nullptr && item->text().size() > longest.size()) longest = item->text();
    }
    return longest.contains('\n') ? 0 : table.fontMetrics().horizontalAdvance(longest);
}

}  // namespace

QLabel* make_label(const QString& text, const char* role) {
    auto* label = new QLabel(text);
    label->setProperty("role", role);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::NoTextInteraction);
    return label;
}

QLabel* make_hint(const char* role) {
    QLabel* hint = make_label(QString(QChar::Nbsp), role);
    QSizePolicy policy = hint->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    hint->setSizePolicy(policy);
    hint->hide();
    return hint;
}

QLabel* make_badge(const QString& text, const char* tone) {
    QLabel* label = make_label(text, "badge");
    label->setProperty("tone", tone);
    label->setWordWrap(false);
    label->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Maximum);
    return label;
}

QLabel* make_demonstration_badge() {
    QLabel* badge = make_badge(Parts::tr("DEMONSTRATION"), "warn");
    badge->setToolTip(Parts::tr("Made by a scripted operator or a demonstration account."));
    return badge;
}

QPushButton* make_button(const AppContext& context, const QString& text, const char* role,
                         const QString& icon) {
    auto* button = new QPushButton(text);
    button->setProperty("role", role);
    button->setAutoDefault(true);  // Enter presses what has the focus.
    button->setCursor(Qt::PointingHandCursor);
    if (!icon.isEmpty()) set_button_icon(context, button, icon);
    return button;
}

QPushButton* press_once(QPushButton* button) {
    button->setProperty("once", true);
    return button;
}

void set_button_icon(const AppContext& context, QPushButton* button, const QString& icon) {
    if (button->property("icon_name").toString() == icon) return;
    button->setProperty("icon_name", icon);
    const Tokens& colors = context.colors();
    const QString kind = button->property("role").toString();
    button->setIcon(line_icon(icon, kind == "primary"  ? colors.on_accent
                                    : kind == "danger" ? colors.critical
                                                       : colors.text));
    button->setIconSize(QSize(20, 20));
}

QFrame* make_card(QLayout* content) {
    auto* card = new QFrame;
    card->setProperty("role", "card");
    content->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
    card->setLayout(content);
    return card;
}

QFrame* make_rule() {
    auto* rule = new QFrame;
    rule->setProperty("role", "rule");
    return rule;
}

QVBoxLayout* make_field(const QString& name, QWidget* field) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace4);
    QLabel* label = make_label(name, "muted");
    label->setBuddy(field);
    field->setAccessibleName(name);
    layout->addWidget(label);
    layout->addWidget(field);
    return layout;
}

void keep_narrow(QComboBox* list, int letters) {
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(letters);
    list->setToolTip(list->currentText());
    QObject::connect(list, &QComboBox::currentTextChanged, list, &QWidget::setToolTip);
}

QTableWidget* make_table(const QStringList& headers, const QString& name) {
    auto* table = new QTableWidget(0, static_cast<int>(headers.size()));
    table->setHorizontalHeaderLabels(headers);
    table->setAccessibleName(name);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kTouchTarget);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setHighlightSections(false);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setTextElideMode(Qt::ElideMiddle);  // Names differ at both of their ends.
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);  // Tab leaves the table: no trap for keyboard users.
    table->setSortingEnabled(true);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    return table;
}

QTableWidgetItem* make_cell(const QString& text) { return new QTableWidgetItem(text); }

QTableWidgetItem* make_number_cell(const QString& text, double value) {
    auto* item = new NumberItem(text);
    item->setData(Qt::UserRole, value);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

void fit_columns(QTableWidget* table, int stretch) {
    QHeaderView* header = table->horizontalHeader();
    // Of a thousand rows the first ones tell how wide a column is, and the longest text of the
    // others: to ask each of them for its size takes 100 ms.
    header->setResizeContentsPrecision(kAskedRows);
    table->resizeColumnsToContents();
    for (int c = 0; c < table->columnCount(); ++c) {
        // Room for the padding of the style sheet, which the size hint of a cell leaves out.
        header->setSectionResizeMode(
            c, c == stretch ? QHeaderView::Stretch : QHeaderView::Interactive);
        if (c != stretch)
            table->setColumnWidth(
                c, std::max(table->columnWidth(c), longest_text(*table, c) + kSpace12) + kSpace12);
        const QTableWidgetItem* first = table->item(0, c);
        if (first != nullptr && (first->textAlignment() & Qt::AlignRight) != 0)
            table->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    keep_within_later(table, stretch);
}

bool confirm(QWidget* parent, const QString& title, const QString& text, const QString& verb,
             const QString& stay) {
    // The question itself stands in the box, too: not every desktop draws title bars.
    const QString words =
        QString("<p><b>%1</b></p><p>%2</p>")
            .arg(title.toHtmlEscaped(), text.toHtmlEscaped().replace('\n', "<br>"));
    // Of the window, not of the page: a question on the stack must not be deleted with its page.
    QMessageBox box(QMessageBox::NoIcon, title, words, QMessageBox::NoButton,
                    parent != nullptr ? parent->window() : nullptr);
    box.setTextFormat(Qt::RichText);
    box.setObjectName("confirm");
    frame_dialog(&box);
    QPushButton* yes = box.addButton(verb, QMessageBox::DestructiveRole);
    yes->setObjectName("confirm_yes");
    yes->setProperty("role", "danger");
    QPushButton* no =
        box.addButton(stay.isEmpty() ? Parts::tr("Cancel") : stay, QMessageBox::RejectRole);
    no->setObjectName("confirm_no");
    no->setProperty("role", "secondary");
    box.setDefaultButton(no);
    box.setEscapeButton(no);
    box.exec();
    return box.clickedButton() == yes;
}

QWidget* make_picture(std::function<void(QPainter&, const QRectF&)> draw, QSize least,
                      const QString& name, const QString& description) {
    auto* picture = new Picture(std::move(draw));
    picture->setMinimumSize(least);
    picture->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    picture->setAccessibleName(name);
    picture->setAccessibleDescription(description);
    return picture;
}

QVBoxLayout* make_column(QWidget* page, int width) {
    auto* outer = new QVBoxLayout(page);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* inside = new QWidget;
    inside->setProperty("role", "page");
    auto* centre = new QHBoxLayout(inside);
    centre->setContentsMargins(kSpace32, kSpace24, kSpace32, kSpace32);
    auto* column_widget = new QWidget;
    column_widget->setMaximumWidth(width);
    auto* column = new QVBoxLayout(column_widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace16);
    centre->addStretch(1);
    centre->addWidget(column_widget, 1000);
    centre->addStretch(1);
    scroll->setWidget(inside);
    outer->addWidget(scroll);
    return column;
}

void begin_at(QWidget* card) {
    constexpr int kLookAgainMs = 20;  // A page is built before it is shown.
    QTimer::singleShot(kLookAgainMs, card, [card] {
        if (!card->isVisible()) return begin_at(card);
        QScrollArea* scroll = nullptr;
        for (QWidget* above = card->parentWidget(); above != nullptr && scroll == nullptr;
             above = above->parentWidget())
            scroll = qobject_cast<QScrollArea*>(above);
        if (scroll == nullptr) return;
        scroll->verticalScrollBar()->setValue(card->mapTo(scroll->widget(), QPoint()).y() -
                                              kSpace16);
        for (QPushButton* button : card->findChildren<QPushButton*>()) {
            if (!button->isEnabled()) continue;
            button->setFocus(Qt::OtherFocusReason);
            return;
        }
    });
}

}  // namespace placode::ui
