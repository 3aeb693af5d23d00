// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QMenu>
#include <QProgressBar>
#include <QScreen>
#include <QToolButton>
#include <memory>

#include "ui/shell/parts.h"

namespace placode::ui {

Page::Page(AppContext& context) : context_(context) { setProperty("role", "page"); }

Page* make_page(AppContext& context, const Place& place) {
    switch (place.page) {
        case PageId::kSetup:
            return make_setup_page(context, place);
        case PageId::kLogin:
            return make_login_page(context, place);
        case PageId::kToday:
            return make_today_page(context, place);
        case PageId::kCourse:
            return make_course_page(context, place);
        case PageId::kTask:
            return make_task_page(context, place);
        case PageId::kRunning:
            return make_running_page(context, place);
        case PageId::kResult:
            return make_result_page(context, place);
        case PageId::kHistory:
            return make_history_page(context, place);
        case PageId::kAttempts:
            return make_attempts_page(context, place);
        case PageId::kStudies:
            return make_studies_page(context, place);
        case PageId::kParticipant:
            return make_participant_page(context, place);
        case PageId::kPeople:
            return make_people_page(context, place);
        case PageId::kHealth:
            return make_health_page(context, place);
        case PageId::kAudit:
            return make_audit_page(context, place);
        case PageId::kAccount:
            return make_account_page(context, place);
        case PageId::kRecovery:
            return make_recovery_page(context, place);
    }
    return make_login_page(context, place);
}

MainWindow::MainWindow(AppContext& context) : context_(context) {
    setWindowTitle("Placode");
    setWindowIcon(line_icon("placode", context.colors().accent));
    setMinimumSize(1024, 680);
    resize(1366, 768);
    buildFrame();
    connect(&context, &AppContext::appearanceChanged, this, &MainWindow::rebuild);
    connect(&context, &AppContext::userChanged, this, &MainWindow::onUserChanged);
    connect(&context, &AppContext::problemReported, this,
            [this](const Problem& problem) { banner_->showProblem(problem); });
    connect(&context, &AppContext::busyChanged, this, [this](const QString& what) {
        busy_text_->setText(what);
        busy_->setVisible(!what.isEmpty());
    });
    connect(&context.launcher(), &AttemptLauncher::ended, this, &MainWindow::onAttemptEnded);
    connect(&context.launcher(), &AttemptLauncher::started, this, &MainWindow::updateFrame);
}

void MainWindow::begin() {
    const auto again = [this] {
        banner_->hide();
        begin();
    };
    bool first = false;
    if (!context_.openStore() || !context_.guard(tr("Reading the accounts"), [&] {
            first = context_.store().users().empty();
        })) {
        showRetry(tr("Placode cannot open its store."), again);
        return;
    }
    showPlace({first ? PageId::kSetup : PageId::kLogin, 0, {}, {}});
}

void MainWindow::buildFrame() {
    auto* frame = new QWidget;
    frame->setProperty("role", "page");
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    rail_ = buildRail();
    row->addWidget(rail_);
    auto* right = new QVBoxLayout;
    right->setSpacing(0);
    bar_ = buildTopBar();
    right->addWidget(bar_);
    auto* messages = new QVBoxLayout;
    messages->setContentsMargins(kSpace32, kSpace12, kSpace32, 0);
    banner_ = new Banner(context_);
    messages->addWidget(banner_);
    busy_ = new QWidget;
    auto* busy = new QVBoxLayout(busy_);
    busy->setContentsMargins(0, kSpace4, 0, 0);
    busy->setSpacing(kSpace4);
    busy_text_ = make_label({}, "small");
    auto* bar = new QProgressBar;
    bar->setRange(0, 0);
    bar->setTextVisible(false);
    bar->setAccessibleName(tr("Work in progress"));
    busy->addWidget(busy_text_);
    busy->addWidget(bar);
    busy_->hide();
    messages->addWidget(busy_);
    right->addLayout(messages);
    content_ = new QVBoxLayout;
    content_->setContentsMargins(0, 0, 0, 0);
    right->addLayout(content_, 1);
    row->addLayout(right, 1);
    setCentralWidget(frame);
}

QWidget* MainWindow::buildRail() {
    auto* rail = new QFrame;
    rail->setProperty("role", "rail");
    rail->setFixedWidth(216);
    rail->setAccessibleName(tr("Pages"));
    auto* layout = new QVBoxLayout(rail);
    layout->setContentsMargins(kSpace12, kSpace16, kSpace12, kSpace16);
    layout->setSpacing(kSpace4);
    auto* mark = new QHBoxLayout;
    mark->setContentsMargins(kSpace12, 0, 0, kSpace16);
    auto* picture = new QLabel;
    picture->setPixmap(line_icon("placode", context_.colors().accent).pixmap(28, 28));
    mark->addWidget(picture);
    mark->addSpacing(kSpace8);
    mark->addWidget(make_label("Placode", "title"), 1);
    layout->addLayout(mark);
    rail_buttons_.clear();
    const auto add = [&](PageId page, const QString& text, const QString& icon, bool wanted) {
        if (!wanted) return;
        auto* button = new QToolButton;
        button->setProperty("role", "rail");
        button->setObjectName("rail_" + icon);
        button->setText(" " + text);
        button->setAccessibleName(text);
        button->setIcon(line_icon(icon, context_.colors().muted));
        button->setIconSize(QSize(20, 20));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumHeight(kTouchTarget);
        connect(button, &QToolButton::clicked, this, [this, page] {
            open({page, 0, {}, {}});
            updateFrame();
        });
        layout->addWidget(button);
        rail_buttons_.emplace_back(button, page);
    };
    using db::Action;
    using db::Scope;
    const bool trains = context_.signedIn() && context_.may(Action::kPerformAttempt) &&
                        (db::has_role(context_.user().roles, db::Role::kTrainee) ||
                         db::has_role(context_.user().roles, db::Role::kEducator));
    add(PageId::kToday, tr("Today"), "today", trains);
    add(PageId::kCourse, tr("Course"), "course", trains);
    add(PageId::kHistory, tr("History"), "history", trains);
    add(PageId::kAttempts, tr("Attempts"), "attempts",
        context_.may(Action::kViewAttempts, Scope::kOther));
    add(PageId::kStudies, tr("Studies"), "studies", context_.may(Action::kRunQuestionnaire));
    add(PageId::kPeople, tr("People"), "people", context_.may(Action::kManageUsers, Scope::kOther));
    add(PageId::kHealth, tr("Health"), "health", context_.may(Action::kBackup, Scope::kOther));
    add(PageId::kAudit, tr("Audit"), "audit", context_.may(Action::kViewAudit, Scope::kOther));
    layout->addStretch();
    return rail;
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
    if (context_.signedIn() && context_.user().demonstration)
        row->addWidget(make_demonstration_badge());
    row->addStretch();
    running_ = new QToolButton;
    running_->setObjectName("running_chip");
    running_->setText(tr("Attempt is running"));
    running_->setIcon(line_icon("play", context_.colors().accent));
    running_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(running_, &QToolButton::clicked, this, [this] { open({PageId::kRunning, 0, {}, {}}); });
    row->addWidget(running_);
    const bool dark = context_.theme() == ThemeKind::kDark;
    auto* language = new QToolButton;
    language->setObjectName("language");
    language->setText(context_.language() == "pl" ? "EN" : "PL");
    language->setIcon(line_icon("language", context_.colors().text));
    language->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    language->setToolTip(context_.language() == "pl" ? "English" : "Polski");
    language->setAccessibleName(language->toolTip());
    connect(language, &QToolButton::clicked, this,
            [this] { context_.setLanguage(context_.language() == "pl" ? "en" : "pl"); });
    auto* theme = new QToolButton;
    theme->setObjectName("theme");
    theme->setIcon(line_icon(dark ? "sun" : "moon", context_.colors().text));
    theme->setToolTip(dark ? tr("Light theme") : tr("Dark theme"));
    theme->setAccessibleName(theme->toolTip());
    connect(theme, &QToolButton::clicked, this,
            [this, dark] { context_.setTheme(dark ? ThemeKind::kLight : ThemeKind::kDark); });
    for (QToolButton* button : {running_, language, theme}) {
        button->setIconSize(QSize(20, 20));
        button->setFocusPolicy(Qt::StrongFocus);
    }
    row->addWidget(language);
    row->addWidget(theme);
    addUserMenu(row);
    return bar;
}

void MainWindow::addUserMenu(QHBoxLayout* bar) {
    if (!context_.signedIn()) return;
    auto* user = new QToolButton;
    user->setObjectName("user_menu");
    user->setText(qstr(context_.user().display_name));
    user->setAccessibleName(tr("Account of %1").arg(user->text()));
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
    // Switching keeps nobody's name in the field; signing out proposes the same person again.
    connect(change, &QAction::triggered, this, [this] {
        if (page_ && !page_->mayLeave()) return;
        context_.settings().remove("last_login");
        context_.signOut();
    });
    connect(out, &QAction::triggered, this, [this] {
        if (page_ && !page_->mayLeave()) return;
        context_.signOut();
    });
    user->setMenu(menu);
    bar->addWidget(user);
}

void MainWindow::rebuild() {
    Place here = place_;
    if (page_) here.state = page_->state();
    // The old frame lives on for a moment: it may hold the very button that was pressed.
    QWidget* old = takeCentralWidget();
    old->hide();
    old->deleteLater();
    const QPointer<Banner> said = banner_;
    buildFrame();
    if (said) banner_->takeOver(*said);
    if (context_.storeIsOpen()) {
        showPlace(here);
    } else {
        begin();
    }
}

void MainWindow::onUserChanged() {
    trail_.clear();
    buildFrame();
    showPlace(context_.signedIn() ? home() : Place{PageId::kLogin, 0, {}, {}});
    if (context_.signedIn()) offerLeftovers();
}

Place MainWindow::home() const {
    using db::Action;
    PageId page = PageId::kAccount;
    if (context_.may(Action::kManageUsers, db::Scope::kOther)) page = PageId::kPeople;
    if (context_.may(Action::kRunQuestionnaire)) page = PageId::kStudies;
    if (context_.may(Action::kViewAttempts, db::Scope::kOther)) page = PageId::kAttempts;
    if (db::has_role(context_.user().roles, db::Role::kTrainee)) page = PageId::kToday;
    return {page, 0, {}, {}};
}

void MainWindow::open(const Place& place) {
    if (page_ && !page_->mayLeave()) {
        updateFrame();
        return;
    }
    if (page_) trail_.push_back(place_);
    if (trail_.size() > 50) trail_.erase(trail_.begin());
    banner_->hide();
    showPlace(place);
}

void MainWindow::goBack() {
    if (trail_.empty()) return showPlace(home());
    const Place last = trail_.back();
    trail_.pop_back();
    showPlace(last);
}

void MainWindow::showPlace(const Place& place) {
    place_ = place;
    Page* made = nullptr;
    if (!context_.guard(tr("Opening the page"), [&] { made = make_page(context_, place); })) {
        showRetry(tr("This page cannot be shown."), [this, place] {
            banner_->hide();
            showPlace(place);
        });
        return;
    }
    if (shown_) shown_->deleteLater();
    if (shown_) shown_->hide();
    page_ = made;
    shown_ = made;
    content_->addWidget(made);
    // Queued: a page may ask to leave from inside one of its own handlers.
    connect(made, &Page::go, this, &MainWindow::open, Qt::QueuedConnection);
    connect(made, &Page::back, this, &MainWindow::goBack, Qt::QueuedConnection);
    connect(made, &Page::notice, this, [this](const QString& text) {
        // After the page change that often comes with it.
        QMetaObject::invokeMethod(
            this, [this, text] { banner_->showNotice(text); }, Qt::QueuedConnection);
    });
    updateFrame();
}

void MainWindow::showRetry(const QString& text, const std::function<void()>& again) {
    if (shown_) shown_->deleteLater();
    if (shown_) shown_->hide();
    auto* blank = new QWidget;
    auto* layout = new QVBoxLayout(blank);
    layout->setSpacing(kSpace16);
    layout->addStretch();
    QLabel* label = make_label(text, "title");
    label->setAlignment(Qt::AlignCenter);
    layout->addWidget(label);
    QPushButton* button = make_button(context_, tr("Try again"), "primary", "again");
    button->setObjectName("try_again");
    connect(button, &QPushButton::clicked, this, again, Qt::QueuedConnection);
    layout->addWidget(button, 0, Qt::AlignHCenter);
    layout->addStretch();
    page_ = nullptr;
    shown_ = blank;
    content_->addWidget(blank);
    updateFrame();
    button->setFocus();
}

void MainWindow::updateFrame() {
    const bool alone = page_ && page_->alone();
    rail_->setVisible(context_.signedIn() && !alone);
    if (auto* menu = bar_->findChild<QToolButton*>("user_menu")) menu->setVisible(!alone);
    running_->setVisible(context_.launcher().running() && place_.page != PageId::kRunning);
    title_->setText(page_ ? page_->title() : QString());
    for (const auto& [button, page] : rail_buttons_) {
        const bool here = page == place_.page;
        button->setChecked(here);
        const QString icon = button->objectName().mid(5);
        button->setIcon(line_icon(icon, here ? context_.colors().accent : context_.colors().muted));
    }
}

void MainWindow::onAttemptEnded(const AttemptEnding& ending) {
    updateFrame();
    const bool waiting = place_.page == PageId::kRunning;
    // Exit status 2 before the first frame: bad input, e.g. a device that is not there.
    const bool never_began =
        !ending.crashed && ending.exit_code == 2 && context_.launcher().status().time_s <= 0;
    if (never_began || !QFile::exists(ending.order.recording_file)) {
        remove_recording(ending.order.recording_file);
        context_.report({tr("The attempt could not be started."),
                         tr("Choose another device or try again."), ending.message});
        if (waiting) showPlace({PageId::kTask, 0, ending.order.task, {}});
        return;
    }
    if ((ending.crashed || ending.exit_code != 0) && !ending.asked) {
        // The person decides what becomes of it; until then the file stays.
        if (waiting) showPlace({PageId::kRecovery, 0, {}, {}});
        context_.report({tr("The simulator ended unexpectedly."),
                         tr("What was recorded is kept and can be saved as interrupted."),
                         ending.message});
        return;
    }
    saveAttempt(ending);
}

void MainWindow::saveAttempt(const AttemptEnding& ending) {
    auto saved = std::make_shared<SavedAttempt>();
    context_.background(
        this, tr("Scoring and saving the attempt"),
        [saved, order = ending.order](db::Store& store) { *saved = save_recording(store, order); },
        [this, saved, ending](bool done) {
            const bool waiting = place_.page == PageId::kRunning;
            if (!done) {
                // The banner has the reason; the recording stays and is offered again.
                if (waiting) showPlace({PageId::kRecovery, 0, {}, {}});
                return;
            }
            if (saved->outcome == Saving::kEmpty) {
                context_.report({tr("The attempt ended before anything was recorded."),
                                 tr("Try again."), ending.message});
                if (waiting) showPlace({PageId::kTask, 0, ending.order.task, {}});
                return;
            }
            const Place result{PageId::kResult, saved->attempt_id, {}, {}};
            if (!context_.signedIn() || context_.user().id != ending.order.user_id) return;
            if (waiting) return showPlace(result);
            banner_->showNotice(tr("Your attempt was saved."),
                                {tr("Open the result"), [this, result] { open(result); }});
        });
}

void MainWindow::offerLeftovers() {
    int mine = 0;
    Leftover last;
    context_.guard(tr("Looking for unfinished attempts"), [&] {
        const bool all = context_.may(db::Action::kManageUsers, db::Scope::kOther);
        for (Leftover& leftover : find_leftovers(context_.recordingsFolder())) {
            const bool own = leftover.order && leftover.order->user_id == context_.user().id;
            if (!own && !(all && !leftover.order)) continue;
            ++mine;
            last = std::move(leftover);
        }
    });
    if (mine == 0) return;
    const QString text =
        mine == 1 ? tr("An attempt of %1 was not finished or not saved (%2).")
                        .arg(format_clock(last.started_utc), format_duration(last.duration_s))
                  : tr("Attempts that were not finished or not saved: %1.").arg(mine);
    banner_->showNotice(text, {tr("Look at it"), [this] { open({PageId::kRecovery, 0, {}, {}}); }});
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool stay =
        (page_ && !page_->mayLeave()) ||
        (context_.launcher().running() &&
         !confirm(this, tr("Close Placode while an attempt is running?"),
                  tr("The attempt ends. Its recording is kept and offered at the next start."),
                  tr("Close")));
    stay ? event->ignore() : event->accept();
}

}  // namespace placode::ui
