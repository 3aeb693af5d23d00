// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The frame around the pages: top bar, and the rail's room (its pages: main_window_rail.cpp).
#include <QActionGroup>
#include <QApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <initializer_list>

#include "ui/shell/help_window.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"
#include "ui/shell/waiting_recordings.h"

namespace placode::ui {

namespace {

constexpr int kRailWidth = 216, kNarrowRail = 72;
constexpr int kScrollBar = 12;       ///< As in the style sheet.
constexpr int kLongestName = 400;    ///< Of the person in the top bar [px].
constexpr int kShortestName = 48;    ///< [px]
constexpr int kNarrowWindow = 1200;  ///< [px], of the screen's own scale.

/// Who has every role has more pages than a small screen is high.
QWidget* scrolling(QWidget* rail) {
    auto* area = new QScrollArea;
    area->setWidget(rail);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFixedWidth(kRailWidth);
    return area;
}

/// As the buttons of the top bar are.
void dress(std::initializer_list<QToolButton*> buttons) {
    for (QToolButton* button : buttons) {
        button->setIconSize(QSize(20, 20));
        button->setFocusPolicy(Qt::StrongFocus);
    }
}

/// The person's name is as long as title and buttons leave room for; whole in its tool tip.
void fit_name(QWidget* bar, int room) {
    auto* user = bar->findChild<QToolButton*>("user_menu");
    if (user == nullptr) return;
    const auto shorten = [user](int px) {
        user->setText(user->fontMetrics().elidedText(user->toolTip(), Qt::ElideRight, px));
    };
    shorten(kLongestName);
    const int over = bar->layout()->sizeHint().width() - room;
    const int now = user->fontMetrics().horizontalAdvance(user->text());
    if (over > 0) shorten(std::max(kShortestName, now - over));
}

/// Opens the chapter on the page that is shown.
QToolButton* make_help_button(AppContext& context, QWidget* window,
                              const std::function<PageId()>& page) {
    auto* help = new QToolButton;
    help->setObjectName("help");
    help->setText(MainWindow::tr("Help"));
    help->setIcon(line_icon("help", context.colors().text));
    help->setIconSize(QSize(20, 20));
    help->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    help->setAccessibleName(help->text());
    help->setToolTip(MainWindow::tr("The chapter of the manual on this page (F1)"));
    help->setFocusPolicy(Qt::StrongFocus);
    QObject::connect(help, &QToolButton::clicked, window, [&context, window, page] {
        open_help(context, window, manual_chapter(page()));
    });
    return help;
}

}  // namespace

void MainWindow::buildFrame() {
    auto* frame = new QWidget;
    frame->setProperty("role", "page");
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    rail_ = scrolling(buildRail());
    row->addWidget(rail_);
    auto* right = new QVBoxLayout;
    right->setSpacing(0);
    bar_ = buildTopBar();
    right->addWidget(bar_);
    content_ = new QVBoxLayout;
    content_->setContentsMargins(0, 0, 0, 0);
    right->addLayout(content_, 1);
    row->addLayout(right, 1);
    setCentralWidget(frame);
    narrowRail();
    placeNotices();
}

void MainWindow::narrowRail() {
    if (rail_ == nullptr) return;
    const bool narrow = width() < kNarrowWindow;
    const int rail_width = narrow ? kNarrowRail : kRailWidth;
    auto* inside = rail_->findChild<QFrame*>("rail");
    const bool scrolls = inside != nullptr && inside->sizeHint().height() > height();
    if (inside != nullptr) inside->setFixedWidth(rail_width);
    rail_->setFixedWidth(rail_width + (scrolls ? kScrollBar : 0));
    for (const char* name : {"search", "help", "switch_user"})
        if (auto* button = bar_->findChild<QToolButton*>(name))
            button->setToolButtonStyle(narrow ? Qt::ToolButtonIconOnly
                                              : Qt::ToolButtonTextBesideIcon);
    if (auto* name = rail_->findChild<QLabel*>("rail_mark")) name->setVisible(!narrow);
    for (QLabel* heading : rail_->findChildren<QLabel*>("rail_heading"))
        heading->setText(narrow ? QString(QChar::Nbsp) : heading->accessibleName());
    for (const auto& [button, page] : rail_buttons_) {
        button->setToolButtonStyle(narrow ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
        button->setToolTip(narrow ? button->accessibleName() : QString());
    }
    fit_name(bar_, width() - (rail_->isHidden() ? 0 : rail_->maximumWidth()));
}

QWidget* MainWindow::buildTopBar() {
    auto* bar = new QFrame;
    bar->setProperty("role", "bar");
    bar->setFixedHeight(60);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(kSpace32, kSpace8, kSpace16, kSpace8);
    row->setSpacing(kSpace8);
    title_ = make_label({}, "heading");
    title_->setWordWrap(false);
    row->addWidget(title_);
    if (context_.signedIn() && context_.user().demonstration) {
        QLabel* badge = make_demonstration_badge();
        badge->setObjectName("bar_demonstration");
        row->addWidget(badge);
    }
    row->addStretch();
    addChips(row);
    auto* search = new QToolButton;
    search->setObjectName("search");
    search->setText(tr("Search"));
    search->setIcon(line_icon("search", context_.colors().text));
    search->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    search->setAccessibleName(search->text());
    search->setToolTip(tr("Search pages, tasks, people, attempts and the manual (Ctrl+K)"));
    connect(search, &QToolButton::clicked, this, &MainWindow::openSearch);
    search->setVisible(context_.signedIn());
    row->addWidget(search);
    dress({search});
    row->addWidget(make_help_button(context_, this, [this] { return place_.page; }));
    addAppearance(row);
    addUserMenu(row);
    addSwitch(row);
    return bar;
}

/// What goes on beside the page: an attempt, and recordings that wait for the server.
void MainWindow::addChips(QHBoxLayout* bar) {
    running_ = new QToolButton;
    running_->setObjectName("running_chip");
    running_->setText(tr("Attempt is running"));
    running_->setIcon(line_icon("play", context_.colors().accent));
    running_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(running_, &QToolButton::clicked, this, [this] { open({PageId::kRunning, 0, {}, {}}); });
    bar->addWidget(running_);
    waiting_ = new QToolButton;
    waiting_->setObjectName("waiting_chip");
    waiting_->setIcon(line_icon("pause", context_.colors().accent));
    waiting_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    waiting_->setToolTip(
        tr("Your attempts that are kept on this computer until the server is back. Shows them, "
           "and tries again now."));
    connect(waiting_, &QToolButton::clicked, this, [this] {
        open({PageId::kRecovery, 0, {}, {}});
        context_.waiting().tryNow();
    });
    bar->addWidget(waiting_);
    dress({running_, waiting_});
}

void MainWindow::addAppearance(QHBoxLayout* bar) {
    const bool dark = context_.theme() == ThemeKind::kDark;
    auto* language = new QToolButton;
    language->setObjectName("language");
    language->setText(context_.language() == "pl" ? "EN" : "PL");
    language->setIcon(line_icon("language", context_.colors().text));
    language->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    language->setToolTip(context_.language() == "pl" ? "English" : "Polski");
    language->setAccessibleName(language->toolTip());
    connect(language, &QToolButton::clicked, this, [this] {
        if (page_ && !page_->mayTranslate()) return;
        context_.setLanguage(context_.language() == "pl" ? "en" : "pl");
    });
    auto* theme = new QToolButton;
    theme->setObjectName("theme");
    theme->setIcon(line_icon(dark ? "sun" : "moon", context_.colors().text));
    theme->setToolTip(dark ? tr("Light theme") : tr("Dark theme"));
    theme->setAccessibleName(theme->toolTip());
    connect(theme, &QToolButton::clicked, this,
            [this, dark] { context_.setTheme(dark ? ThemeKind::kLight : ThemeKind::kDark); });
    dress({language, theme});
    bar->addWidget(language);
    bar->addWidget(theme);
}

/// One touch at a shared station: the next person signs in.
void MainWindow::addSwitch(QHBoxLayout* bar) {
    if (!context_.signedIn()) return;
    auto* change = new QToolButton;
    change->setObjectName("switch_user");
    change->setIcon(line_icon("switch", context_.colors().text));
    change->setIconSize(QSize(20, 20));
    change->setText(tr("Switch user"));
    change->setToolTip(tr("Signs you out, so that the next person can sign in"));
    change->setAccessibleName(tr("Switch user"));
    change->setFocusPolicy(Qt::StrongFocus);
    connect(change, &QToolButton::clicked, this, &MainWindow::switchUser);
    bar->addWidget(change);
}

void MainWindow::addUserMenu(QHBoxLayout* bar) {
    if (!context_.signedIn()) return;
    auto* user = new QToolButton;
    user->setObjectName("user_menu");
    const QString name = qstr(context_.user().display_name);
    user->setToolTip(name);  // Of which fit_name() shows what there is room for.
    user->setAccessibleName(tr("Account of %1").arg(name));
    user->setIcon(line_icon("account", context_.colors().text));
    user->setIconSize(QSize(20, 20));
    user->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    user->setFocusPolicy(Qt::StrongFocus);
    user->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(user);
    const Tokens& colors = context_.colors();
    QAction* account = menu->addAction(line_icon("account", colors.text), tr("My account"));
    QAction* recovery =
        menu->addAction(line_icon("history", colors.text), tr("Unfinished attempts"));
    menu->addSeparator();
    QAction* change = menu->addAction(line_icon("switch", colors.text), tr("Switch user"));
    QAction* out = menu->addAction(line_icon("signout", colors.text), tr("Sign out"));
    out->setShortcut(QKeySequence("Ctrl+Shift+Q"));
    account->setObjectName("action_account");
    recovery->setObjectName("action_recovery");
    change->setObjectName("action_switch");
    out->setObjectName("action_sign_out");
    connect(account, &QAction::triggered, this, [this] { open({PageId::kAccount, 0, {}, {}}); });
    connect(recovery, &QAction::triggered, this, [this] { open({PageId::kRecovery, 0, {}, {}}); });
    connect(change, &QAction::triggered, this, &MainWindow::switchUser);
    connect(out, &QAction::triggered, this, [this] {
        if (maySignOut()) context_.signOut();
    });
    user->setMenu(menu);
    bar->addWidget(user);
}

}  // namespace placode::ui
