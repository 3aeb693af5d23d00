// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/help_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QShortcut>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/shell/manual_view.h"
#include "ui/shell/parts.h"
#include "ui/shell/search_box.h"

namespace placode::ui {
namespace {

constexpr int kListWidth = 260, kNarrowList = 200, kNarrowWindow = 800;
constexpr int kListMargin = 44;  ///< Left and right of a row's words, with the scroll bar [px].
constexpr int kRowMargin = 12;   ///< Above and below them, together [px].
constexpr int kRow = 36;         ///< Least height [px].
constexpr size_t kHits = 40;
constexpr int kTarget = Qt::UserRole;
const char* const kFirstPage = "index.md";

QString file_of(const QString& page) { return page.section('#', 0, 0); }
QString anchor_of(const QString& page) { return page.section('#', 1); }

}  // namespace

HelpWindow::HelpWindow(AppContext& context, QWidget* main_window)
    : QWidget(main_window, Qt::Window), context_(context) {
    setObjectName("help_window");
    setProperty("role", "page");
    setAttribute(Qt::WA_StyledBackground);
    setMinimumSize(640, 400);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    build();
    // At the right edge of the main window, so that what it explains stays in sight.
    const QRect room = main_window->screen()->availableGeometry();
    const QRect behind = main_window->frameGeometry();
    const QSize size =
        QSize(std::max(640, behind.width() * 3 / 5), behind.height() - 40).boundedTo(room.size());
    resize(size);
    move(std::max(room.left(),
                  std::min(behind.right() - size.width() + 1, room.right() - size.width() + 1)),
         std::max(room.top(), behind.top() + 20));
    connect(&context, &AppContext::appearanceChanged, this, [this] {
        const QString typed = typed_->text();
        build();
        typed_->setText(typed);
        turnTo(here_);
    });
    const auto key = [this](const QKeySequence& keys, auto&& act) {
        connect(new QShortcut(keys, this), &QShortcut::activated, this, act);
    };
    key(QKeySequence("Alt+Left"), [this] { step(before_, after_); });
    key(QKeySequence("Alt+Right"), [this] { step(after_, before_); });
    key(QKeySequence("Ctrl+F"), [this] {
        typed_->setFocus();
        typed_->selectAll();
    });
    key(QKeySequence("F1"), [this] { open(kFirstPage); });
}

void HelpWindow::build() {
    delete content_;
    manual_ = load_manual(context_.language());
    setWindowTitle(tr("Help"));  // The name of the program follows.
    setWindowIcon(line_icon("help", context_.colors().accent));
    content_ = new QWidget;
    auto* all = new QVBoxLayout(content_);
    all->setContentsMargins(kSpace12, kSpace12, kSpace12, kSpace12);
    all->setSpacing(kSpace12);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace12);
    auto* left = new QVBoxLayout;
    left->setSpacing(kSpace8);
    typed_ = new QLineEdit;
    typed_->setObjectName("help_search");
    typed_->setPlaceholderText(tr("Search the manual"));
    typed_->setAccessibleName(tr("Search the manual"));
    typed_->setClearButtonEnabled(true);
    left->addWidget(typed_);
    list_ = new QListWidget;
    list_->setObjectName("help_list");
    list_->setAccessibleName(tr("Contents of the manual"));
    list_->setWordWrap(true);
    list_->setTextElideMode(Qt::ElideNone);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    left->addWidget(list_, 1);
    row->addLayout(left);
    view_ = new ManualView;
    row->addWidget(view_, 1);
    all->addWidget(buildBar());
    all->addLayout(row, 1);
    layout()->addWidget(content_);
    connect(typed_, &QLineEdit::textChanged, this, [this] { fillList(); });
    connect(typed_, &QLineEdit::returnPressed, this, [this] { openRow(); });
    connect(list_, &QListWidget::itemClicked, this, [this] { openRow(); });
    connect(list_, &QListWidget::itemActivated, this, [this] { openRow(); });
    connect(view_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
    setListWidth();
}

void HelpWindow::setListWidth() {
    const int wanted = width() < kNarrowWindow ? kNarrowList : kListWidth;
    if (list_->maximumWidth() == wanted) return;
    typed_->setFixedWidth(wanted);
    list_->setFixedWidth(wanted);
    fillList();  // Rows are as high as their words are long.
}

void HelpWindow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    setListWidth();
}

QWidget* HelpWindow::buildBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace8);
    const auto add = [&](const QString& text, const QString& icon, const char* name,
                         const QString& keys, auto&& act) {
        QPushButton* button = make_button(context_, text, "quiet", icon);
        button->setObjectName(name);
        button->setToolTip(keys);
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    back_ = add(tr("Back"), "back", "help_back", tr("Alt and left arrow"),
                [this] { step(before_, after_); });
    forward_ = add(tr("Forward"), "next", "help_forward", tr("Alt and right arrow"),
                   [this] { step(after_, before_); });
    add(tr("Contents"), "course", "help_contents", "F1", [this] { open(kFirstPage); });
    row->addStretch();
    add(tr("Close"), "close", "help_close", tr("Escape"), [this] { close(); });
    return bar;
}

void HelpWindow::open(const QString& page) {
    if (!here_.isEmpty() && page != here_) {
        before_.push_back(here_);
        after_.clear();
    }
    turnTo(page);
}

void HelpWindow::turnTo(const QString& page) {
    here_ = page;
    view_->showFile(manual_.folder + file_of(page), anchor_of(page), context_.colors());
    markRow();
    updateButtons();
}

void HelpWindow::step(std::vector<QString>& from, std::vector<QString>& to) {
    if (from.empty()) return;
    to.push_back(here_);
    const QString page = from.back();
    from.pop_back();
    turnTo(page);
}

void HelpWindow::updateButtons() {
    back_->setEnabled(!before_.empty());
    forward_->setEnabled(!after_.empty());
}

void HelpWindow::addRow(const QString& text, const QString& target) {
    auto* item = new QListWidgetItem(text, list_);
    item->setData(kTarget, target);
    const QRect words = list_->fontMetrics().boundingRect(
        QRect(0, 0, list_->maximumWidth() - kListMargin, 1000), Qt::TextWordWrap, text);
    item->setSizeHint(QSize(0, std::max(kRow, words.height() + kRowMargin)));
    if (!target.isEmpty()) return;
    QFont bold = list_->font();
    bold.setBold(true);
    item->setFont(bold);
    item->setFlags(Qt::NoItemFlags);
    item->setForeground(context_.colors().muted);
}

/// The contents, or what was found.
void HelpWindow::fillList() {
    list_->clear();
    const QString typed = typed_->text().trimmed();
    if (typed.isEmpty()) {
        QString part;
        for (const ManualPage& page : manual_.pages) {
            if (page.part != part) addRow(part = page.part, {});
            addRow(page.title, page.file);
        }
        markRow();
        return;
    }
    for (const ManualHit& hit : find_in_manual(manual_, typed, kHits)) {
        const bool title = hit.section->anchor.isEmpty();
        addRow(title ? hit.page->title : hit.section->heading + "\n" + hit.page->title,
               title ? hit.page->file : hit.page->file + "#" + hit.section->anchor);
    }
    if (list_->count() == 0) addRow(tr("Nothing found. Try fewer letters."), {});
    list_->setCurrentRow(0);
}

void HelpWindow::openRow() {
    const QListWidgetItem* item = list_->currentItem();
    if (item != nullptr && !item->data(kTarget).toString().isEmpty())
        open(item->data(kTarget).toString());
}

void HelpWindow::markRow() {
    if (!typed_->text().trimmed().isEmpty()) return;
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->data(kTarget).toString() == file_of(here_))
            return list_->setCurrentRow(i);
    list_->setCurrentRow(-1);
}

void HelpWindow::follow(const QUrl& link) {
    if (!link.scheme().isEmpty()) return;  // The manual needs no network.
    const QString file = link.path().isEmpty() ? file_of(here_) : link.path();
    open(link.fragment().isEmpty() ? file : file + "#" + link.fragment());
}

void HelpWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        close();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void open_help(AppContext& context, QWidget* main_window, const QString& page) {
    auto* help = main_window->findChild<HelpWindow*>("help_window", Qt::FindDirectChildrenOnly);
    if (help == nullptr) help = new HelpWindow(context, main_window);
    help->open(page);
    help->show();
    help->raise();
    help->activateWindow();
}

void close_help(QWidget* main_window) {
    if (auto* help = main_window->findChild<HelpWindow*>("help_window", Qt::FindDirectChildrenOnly))
        help->close();
}

}  // namespace placode::ui
