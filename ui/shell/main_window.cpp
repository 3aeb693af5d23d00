// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QProgressBar>
#include <QScreen>
#include <QShortcut>
#include <QToolButton>

#include "ui/shell/handover.h"
#include "ui/shell/parts.h"

namespace placode::ui {

MainWindow::MainWindow(AppContext& context) : context_(context) {
    setWindowTitle("Placode");
    setWindowIcon(line_icon("placode", context.colors().accent));
    setMinimumSize(940, 520);  // 1920 x 1080 at 200 %.
    resize(1366, 768);
    buildFrame();
    connect(&context, &AppContext::appearanceChanged, this, &MainWindow::rebuild);
    connect(&context, &AppContext::userChanged, this, &MainWindow::onUserChanged);
    connect(&context, &AppContext::problemReported, this, [this](const Problem& problem) {
        ++problems_;
        banner_->showProblem(problem);
    });
    connect(&context, &AppContext::busyChanged, this, [this](const QString& what) {
        busy_text_->setText(what);
        busy_->setVisible(!what.isEmpty());
    });
    connect(&context.launcher(), &AttemptLauncher::ended, this, &MainWindow::onAttemptEnded);
    auto* find = new QShortcut(QKeySequence("Ctrl+K"), this);
    connect(find, &QShortcut::activated, this, &MainWindow::openSearch);
    connect(&context.launcher(), &AttemptLauncher::started, this, &MainWindow::updateFrame);
    idle_.setSingleShot(true);
    connect(&idle_, &QTimer::timeout, this, &MainWindow::lock);
    qApp->installEventFilter(this);
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

void MainWindow::rebuild() {
    setLocale(QLocale());  // Dates and numbers of what is built next speak the new language.
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
    if (!context_.signedIn()) {
        const QString note =
            locked_user_ != 0 ? tr("Locked after a time without a touch. Come back where you were.")
                              : QString();
        return showPlace({PageId::kLogin, 0, {}, {{"note", note}}});
    }
    const bool back = context_.user().id == locked_user_;
    locked_user_ = 0;
    showPlace(back ? locked_place_ : lastPlace());
    offerLeftovers();
}

bool MainWindow::eventFilter(QObject* object, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::TouchBegin:
            if (context_.signedIn() && context_.lockAfterSeconds() > 0)
                idle_.start(context_.lockAfterSeconds() * 1000);
            break;
        default:
            break;
    }
    return QMainWindow::eventFilter(object, event);
}

void MainWindow::lock() {
    if (!context_.signedIn()) return;
    if (context_.launcher().running() || handedOver() ||
        QApplication::activeModalWidget() != nullptr) {
        idle_.start(context_.lockAfterSeconds() * 1000);
        return;
    }
    locked_place_ = place_;
    if (page_) locked_place_.state = page_->state();
    locked_user_ = context_.user().id;
    context_.settings().setValue("last_login", qstr(context_.user().login));
    context_.audit("session.lock", qstr(context_.user().login));
    context_.signOut();
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

bool MainWindow::handedOver() const {
    return context_.signedIn() && is_participants(context_, place_);
}

bool MainWindow::mayTakeBack() { return !handedOver() || take_back(context_, this); }

void MainWindow::open(const Place& place) {
    const bool taken_back = handedOver() && !is_participants(context_, place);
    if ((page_ && !page_->mayLeave()) || (taken_back && !mayTakeBack())) {
        updateFrame();
        return;
    }
    if (page_) trail_.push_back(place_);
    if (trail_.size() > 50) trail_.erase(trail_.begin());
    if (taken_back) trail_.clear();  // Nobody goes back into somebody else's run by accident.
    banner_->hide();
    showPlace(place);
    if (taken_back) offerLeftovers();
}

void MainWindow::visit(const Place& place) {
    banner_->hide();
    showPlace(place);
}

void MainWindow::goBack() {
    const Place last = trail_.empty() ? home() : trail_.back();
    if (handedOver() && !is_participants(context_, last) && !mayTakeBack()) return;
    if (!trail_.empty()) trail_.pop_back();
    banner_->hide();
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
    // Focus that was on the old page goes to the new one: left alone, it would fall on the first
    // button of the rail and look like the page that is open.
    const QWidget* focus = focusWidget();
    const bool focused = shown_ && focus != nullptr && shown_->isAncestorOf(focus);
    if (shown_) shown_->deleteLater();
    if (shown_) shown_->hide();
    page_ = made;
    shown_ = made;
    content_->addWidget(made);
    if (made->accessibleName().isEmpty()) made->setAccessibleName(made->title());
    if (focused) made->setFocus(Qt::OtherFocusReason);
    // Queued: a page may ask to leave from inside one of its own handlers.
    connect(made, &Page::go, this, &MainWindow::open, Qt::QueuedConnection);
    connect(made, &Page::back, this, &MainWindow::goBack, Qt::QueuedConnection);
    connect(made, &Page::notice, this, &MainWindow::announce);
    rememberPlace();
    updateFrame();
}

// Twice queued: after the page change that often comes with it, before it or behind it. A problem
// that has come up meanwhile is not covered.
void MainWindow::announce(const QString& text) {
    const auto show = [this, text, before = problems_] {
        if (problems_ == before) banner_->showNotice(text);
    };
    const auto queue = [this, show] {
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(this, queue, Qt::QueuedConnection);
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
    const bool alone = handedOver();
    rail_->setVisible(context_.signedIn() && !alone);
    for (const char* name : {"user_menu", "search", "switch_user"})
        if (auto* button = bar_->findChild<QToolButton*>(name))
            button->setVisible(context_.signedIn() && !alone);
    running_->setVisible(context_.launcher().running() && place_.page != PageId::kRunning);
    title_->setText(page_ ? page_->title() : QString());
    for (const auto& [button, page] : rail_buttons_) {
        const bool here = page == place_.page;
        button->setChecked(here);
        const QString icon = button->objectName().mid(5);
        button->setIcon(line_icon(icon, here ? context_.colors().accent : context_.colors().muted));
    }
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    narrowRail();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool stay =
        (page_ && !page_->mayLeave()) || !mayTakeBack() ||
        (context_.launcher().running() &&
         !confirm(this, tr("Close Placode while an attempt is running?"),
                  tr("The attempt ends. Its recording is kept and offered at the next start."),
                  tr("Close")));
    stay ? event->ignore() : event->accept();
}

}  // namespace placode::ui
