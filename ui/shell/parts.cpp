// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/parts.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLocale>
#include <QMessageBox>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <cmath>

#include "db/attempt_counting.h"
#include "reports/text.h"
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

QDateTime parse_utc(const QString& utc) {
    QDateTime when = QDateTime::fromString(utc, Qt::ISODate);
    when.setTimeSpec(Qt::UTC);
    return when.toLocalTime();
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
    // Of a thousand rows the first ones tell how wide a column is; all of them take 100 ms.
    header->setResizeContentsPrecision(50);
    table->resizeColumnsToContents();
    for (int c = 0; c < table->columnCount(); ++c) {
        // Room for the padding of the style sheet, which the size hint of a cell leaves out.
        header->setSectionResizeMode(
            c, c == stretch ? QHeaderView::Stretch : QHeaderView::Interactive);
        if (c != stretch) table->setColumnWidth(c, table->columnWidth(c) + kSpace12);
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
    QMessageBox box(QMessageBox::NoIcon, title, words, QMessageBox::NoButton, parent);
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

/// To the tenth that is shown.
static bool is_whole(double points) { return std::lround(points * 10) % 10 == 0; }

QString format_number(double value, int decimals) {
    // What rounds to nothing has no sign: "-0.0" reads like a loss.
    const double half = 0.5 * std::pow(10.0, -decimals);
    return QLocale().toString(std::abs(value) < half ? 0.0 : value, 'f', decimals);
}

QString format_value(double value) {
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size >= 1e5) return QLocale().toString(value, 'g', 3);
    return format_number(value, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

QString format_duration(double seconds) {
    // One style on the screen and on paper.
    return reports::duration_words(seconds);
}

QString format_when(const std::string& utc) {
    const QDateTime when = parse_utc(qstr(utc));
    return when.isValid() ? QLocale().toString(when, "d MMM yyyy, HH:mm") : qstr(utc);
}

QString format_clock(const QString& utc) {
    const QDateTime when = parse_utc(utc);
    if (!when.isValid()) return utc;
    const bool today = when.date() == QDate::currentDate();
    return QLocale().toString(when, today ? "HH:mm" : "d MMM HH:mm");
}

QString format_points(double points) { return format_number(points, is_whole(points) ? 0 : 1); }

QString points_words(double points) {
    return is_whole(points) ? Parts::tr("%n point(s)", nullptr, whole_points(points))
                            : Parts::tr("%1 points", "with a tenth").arg(format_points(points));
}

int whole_points(double points) { return QString::number(points, 'f', 0).toInt(); }

QString verdict_word(const db::AttemptRecord& attempt) {
    // One word for all of them; why it is so stands beside it.
    if (!db::counts(attempt)) return Parts::tr("Does not count");
    switch (attempt.verdict) {
        case assessment::Verdict::kPassed:
            return Parts::tr("Passed");
        case assessment::Verdict::kFailed:
            return Parts::tr("Failed: critical error");
        default:
            return Parts::tr("Not yet");
    }
}

const char* verdict_tone(const db::AttemptRecord& attempt) {
    if (!db::counts(attempt)) return "";
    switch (attempt.verdict) {
        case assessment::Verdict::kPassed:
            return "good";
        case assessment::Verdict::kFailed:
            return "critical";
        case assessment::Verdict::kNotAttempted:
            return "";
        default:
            return "warn";
    }
}

QString end_word(sim::EndReason reason) {
    switch (reason) {
        case sim::EndReason::kFinished:
            return Parts::tr("finished");
        case sim::EndReason::kTimeLimit:
            return Parts::tr("time limit");
        case sim::EndReason::kClosed:
            return Parts::tr("stopped");
        default:
            return Parts::tr("interrupted");
    }
}

QString role_names(db::Roles roles) {
    QStringList names;
    if (db::has_role(roles, db::Role::kTrainee)) names << Parts::tr("Trainee");
    if (db::has_role(roles, db::Role::kEducator)) names << Parts::tr("Educator");
    if (db::has_role(roles, db::Role::kCoordinator)) names << Parts::tr("Coordinator");
    if (db::has_role(roles, db::Role::kAdministrator)) names << Parts::tr("Administrator");
    return names.join(", ");
}

QString device_name(const std::string& device) {
    if (device == "mouse") return Parts::tr("Mouse");
    if (device == "keyboard") return Parts::tr("Keyboard");
    if (device == "gamepad") return Parts::tr("Gamepad");
    // Names of products stay as they are.
    if (device == "spacemouse") return "SpaceMouse";
    if (device == "openhaptics") return "Touch (OpenHaptics)";
    if (device == "haply") return "Haply Inverse3";
    if (device == "avatar") return "Haptic Avatar";
    if (device == "forcedimension") return "Force Dimension";
    if (device == "script:expert") return Parts::tr("Scripted expert");
    if (device == "script:intermediate") return Parts::tr("Scripted intermediate");
    if (device == "script:novice") return Parts::tr("Scripted novice");
    return qstr(device);
}

}  // namespace placode::ui
