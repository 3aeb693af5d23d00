// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QApplication>
#include <QScreen>
#include <QShortcut>
#include <QToolButton>
#include <utility>

#include "ui/shell/dialog_frame.h"
#include "ui/shell/handover.h"
#include "ui/shell/help_window.h"
#include "ui/shell/parts.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

bool is_same(const Place& a, const Place& b) {
    return a.page == b.page && a.number == b.number && a.text == b.text;
}

}  // namespace

MainWindow::MainWindow(AppContext& context) : context_(context) {
    setWindowTitle("Placode");
    setWindowIcon(line_icon("placode", context.colors().accent));
    setMinimumSize(940, 520);  // 1920 x 1080 at 200 %.
    resize(1366, 768);
    announce_banners_as_alerts();
    notices_ = new Notices(context, this);
    buildFrame();
    notices_->setStrip([this] { return barStrip(); });
    connect(&context, &AppContext::appearanceChanged, this, &MainWindow::rebuild);
    connect(&context, &AppContext::sessionEnds, this, &MainWindow::keepPlace);
    connect(&context, &AppContext::userChanged, this, &MainWindow::onUserChanged);
    connect(&context, &AppContext::problemReported, this, [this](const Problem& problem) {
        closes_when_done_ = false;
        notices_->showProblem(problem);
    });
    connect(&context, &AppContext::busyChanged, notices_, &Notices::showBusy);
    connect(&context, &AppContext::erasureEnded, this, &MainWindow::onErasureEnded);
    connect(&context.launcher(), &AttemptLauncher::ended, this, &MainWindow::onAttemptEnded);
    connect(&context.replays(), &ReplayQueue::checked, this, &MainWindow::onReplayed);
    watchWaiting();
    auto* find = new QShortcut(QKeySequence("Ctrl+K"), this);
    connect(find, &QShortcut::activated, this, &MainWindow::openSearch);
    connect(new QShortcut(QKeySequence("Alt+Left"), this), &QShortcut::activated, this, [this] {
        // The page of an attempt is gone with the attempt.
        while (!trail_.empty() && trail_.back().page == PageId::kRunning &&
               !context_.launcher().running())
            trail_.pop_back();
        // Who has not signed in, and a participant, has nothing behind him.
        if (!context_.signedIn() || handedOver() || trail_.empty()) return;
        if (!page_ || page_->mayLeave()) goBack();
    });
    connect(new QShortcut(QKeySequence("F1"), this), &QShortcut::activated, this, [this] {
        if (!handedOver()) open_help(context_, this, manual_chapter(place_.page));
    });
    connect(&context.launcher(), &AttemptLauncher::started, this, &MainWindow::updateFrame);
    // Whoever operates touches another window than this one: from the end on he has the whole time.
    for (const auto change : {&AttemptLauncher::statusChanged, &AttemptLauncher::started})
        connect(&context.launcher(), change, this, &MainWindow::touched);
    connect(&context.launcher(), &AttemptLauncher::ended, this, &MainWindow::touched);
    attempt_ended_.setSingleShot(true);
    attempt_ended_.setInterval(5000);
    connect(&context.launcher(), &AttemptLauncher::ended, &attempt_ended_,
            qOverload<>(&QTimer::start));
    connect(qApp, &QApplication::applicationStateChanged, this, &MainWindow::onCameBack);
    idle_.setSingleShot(true);
    connect(&idle_, &QTimer::timeout, this, &MainWindow::lock);
    qApp->installEventFilter(this);
}

void MainWindow::begin() {
    if (context_.restoring()) return showMissingStore();
    if (context_.updating()) return showUpdating();
    const auto again = [this] {
        notices_->closeAll();
        begin();
    };
    bool first = false;
    if (!context_.openStore() || !context_.guard(tr("Reading the accounts"), [&] {
            first = !context_.store().accounts().any();
        })) {
        if (context_.storeIsMissing()) return showMissingStore();
        if (context_.storeIsOlder()) return updateStore();
        showRetry(tr("Placode cannot open its store."), again);
        if (context_.storeWasChosen()) offerOwnStore(again);
        return;
    }
    showPlace({first ? PageId::kSetup : PageId::kLogin, 0, {}, {}});
}

void MainWindow::rebuild() {
    setLocale(QLocale());  // Dates and numbers of what is built next speak the new language.
    const Kept here = whatIsShown();
    // The old frame lives on for a moment: it may hold the very button that was pressed.
    QWidget* old = takeCentralWidget();
    old->hide();
    old->deleteLater();
    buildFrame();
    notices_->restyle();
    if (context_.storeIsOpen()) {
        showAgain(here);
    } else {
        begin();
    }
}

MainWindow::Kept MainWindow::whatIsShown() const {
    Kept shown{place_, {}};
    if (page_) {
        shown.place.state = page_->state();
        shown.typed = typed_texts(*page_);
        // What waits for its fields has not been typed again.
        for (auto each = late_.begin(); each != late_.end(); ++each)
            if (!shown.typed.contains(each.key())) shown.typed.insert(each.key(), each.value());
    }
    return shown;
}

void MainWindow::typeAgain(const QVariantMap& typed) {
    type_again(*page_, typed);
    late_ = without_field(*page_, typed);
}

void MainWindow::showAgain(const Kept& kept) {
    showPlace(kept.place);
    if (page_) typeAgain(kept.typed);
}

Place MainWindow::home() const {
    using db::Action;
    if (!context_.signedIn()) return {PageId::kLogin, 0, {}, {}};
    // Who knows a password can sign in as its owner.
    if (context_.user().password_given) return {PageId::kAccount, 0, {}, {}};
    PageId page = PageId::kAccount;
    if (context_.may(Action::kManageUsers, db::Scope::kOther)) page = PageId::kPeople;
    if (context_.may(Action::kRunQuestionnaire)) page = PageId::kStudies;
    if (context_.may(Action::kViewAttempts, db::Scope::kOther)) page = PageId::kAttempts;
    if (db::has_role(context_.user().roles, db::Role::kTrainee)) page = PageId::kToday;
    return {page, 0, {}, {}};
}

QString MainWindow::draftOf(const Place& place) {
    return QString("%1/%2/%3").arg(static_cast<int>(place.page)).arg(place.number).arg(place.text);
}

// A page that opens itself anew has done what was typed for.
void MainWindow::keepTyped(const Place& next) {
    if (page_ && page_->keepsTyped() && draftOf(next) != draftOf(place_))
        drafts_[draftOf(place_)] = whatIsShown().typed;
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
    keepTyped(place);
    // "Back to the result" is a step back: from there nobody wants to go on to the replay again.
    if (!trail_.empty() && is_same(trail_.back(), place)) {
        trail_.pop_back();
    } else if (page_) {
        trail_.push_back(place_);
        // Whoever comes back to the list finds it as it was chosen. Other pages hold work that may
        // just have been given up.
        if (place_.page == PageId::kAttempts) trail_.back().state = page_->state();
    }
    if (trail_.size() > 50) trail_.erase(trail_.begin());
    if (taken_back) trail_.clear();  // Nobody goes back into somebody else's run by accident.
    notices_->closeAll();
    showPlace(place);
    if (taken_back) offerLeftovers();
}

void MainWindow::visit(const Place& place) {
    notices_->closeAll();
    showPlace(place);
}

void MainWindow::goBack() {
    const Place last = trail_.empty() ? home() : trail_.back();
    if (handedOver() && !is_participants(context_, last) && !mayTakeBack()) return;
    keepTyped(last);
    if (!trail_.empty()) trail_.pop_back();
    notices_->closeAll();
    showPlace(last);
}

void MainWindow::showPlace(const Place& place) {
    place_ = place;
    Page* made = nullptr;
    if (!context_.guard(tr("Opening the page"), [&] { made = make_page(context_, place); })) {
        showRetry(tr("This page cannot be shown."), [this, place] {
            notices_->closeAll();
            showPlace(place);
        });
        return;
    }
    showPage(made);
}

void MainWindow::showPage(Page* made) {
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
    const QPointer<Page> from = made;
    connect(
        made, &Page::go, this,
        [this, from](const Place& to) { leavePage(from, [this, to] { open(to); }); },
        Qt::QueuedConnection);
    connect(
        made, &Page::back, this, [this, from] { leavePage(from, [this] { goBack(); }); },
        Qt::QueuedConnection);
    connect(made, &Page::notice, this, [this](const QString& text) { announce(text); });
    connect(made, &Page::written, this, &MainWindow::announce);
    late_.clear();
    connect(made, &Page::fieldsCame, this, [this, from] {
        if (from && page_ == from) type_again(*from, std::exchange(late_, {}));
    });
    if (auto draft = drafts_.extract(draftOf(place_)); !draft.empty()) typeAgain(draft.mapped());
    rememberPlace();
    updateFrame();
}

// What a page began may end while its next question stands: whoever then goes elsewhere at that
// question stays there.
void MainWindow::leavePage(const QPointer<Page>& from, const std::function<void()>& leave) {
    if (!question_stands()) return leave();
    when_no_question(this, [this, from, leave] {
        if (from && page_ == from) leave();
    });
}

// Twice queued: after the page change that often comes with it, before it or behind it.
void MainWindow::announce(const QString& text, const QString& written) {
    const auto show = [this, text, written] {
        written.isEmpty() ? notices_->showNotice(text) : notices_->showWritten(text, written);
    };
    const auto queue = [this, show] {
        QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
    };
    QMetaObject::invokeMethod(this, queue, Qt::QueuedConnection);
}

void MainWindow::onErasureEnded(const QString& name, bool done) {
    const db::Erasure* last = context_.lastErasure();
    const bool told = place_.page == PageId::kAdmissions;  // by the page itself
    if (!done || told || last == nullptr || handedOver() ||
        !context_.may(db::Action::kManageUsers, db::Scope::kOther))
        return;
    QString text = tr("%1 was erased; the certificate can be saved.").arg(name);
    if (!last->left.empty())
        text += ' ' + tr("Copies that may still hold the person: %1.").arg(last->left.size());
    notices_->showNotice(text, {tr("Look at it"), [this] {
                                    open({PageId::kAdmissions, 0, {}, {}});
                                }});
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

void MainWindow::offerOwnStore(const std::function<void()>& again) {
    QPushButton* own = make_button(context_, tr("Use this computer's own store"), "quiet");
    own->setObjectName("use_own_store");
    const auto use = [this, again] {
        context_.useOwnStore();
        again();
    };
    connect(own, &QPushButton::clicked, this, use, Qt::QueuedConnection);
    auto* layout = static_cast<QVBoxLayout*>(shown_->layout());
    layout->insertWidget(layout->count() - 1, own, 0, Qt::AlignHCenter);
}

void MainWindow::updateFrame() {
    const bool alone = handedOver();
    rail_->setVisible(context_.signedIn() && !alone);
    for (const char* name : {"user_menu", "search", "switch_user"})
        if (auto* button = bar_->findChild<QToolButton*>(name))
            button->setVisible(context_.signedIn() && !alone);
    // A participant reads what the protocol says and nothing about scores.
    if (auto* help = bar_->findChild<QToolButton*>("help")) help->setVisible(!alone);
    if (alone) close_help(this);
    // Whoever has not signed in may neither look at an attempt nor end it.
    running_->setVisible(context_.signedIn() && context_.launcher().running() &&
                         place_.page != PageId::kRunning);
    showWaitingCount();
    title_->setText(page_ ? page_->title() : QString());
    narrowRail();  // The title may leave less room beside it.
    placeNotices();
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
    placeNotices();
}

void MainWindow::placeNotices() {
    // The rail has its new width before its layout has been told.
    const int rail = rail_ == nullptr || rail_->isHidden() ? 0 : rail_->maximumWidth();
    const int bar = bar_ == nullptr ? 0 : bar_->maximumHeight();
    notices_->setArea(QRect(rail, bar, width() - rail, height() - bar));
}

/// Between the title of the page and the first button of the bar, in the window.
QRect MainWindow::barStrip() const {
    if (bar_ == nullptr || title_ == nullptr) return {};
    bar_->layout()->activate();
    int right = bar_->width();
    for (const auto* button : bar_->findChildren<QToolButton*>())
        if (!button->isHidden()) right = std::min(right, button->x());
    int left = title_->x() + title_->sizeHint().width();
    if (const auto* badge = bar_->findChild<QLabel*>("bar_demonstration"))
        left = std::max(left, badge->geometry().right());
    const QRect free(left + kSpace16, 2, right - left - 2 * kSpace16, bar_->height() - 4);
    return {bar_->mapTo(this, free.topLeft()), free.size()};
}

}  // namespace placode::ui
