// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Who sits before the window: touches, the lock, another user.

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QWindow>
#include <utility>

#include "ui/shell/diagnostics_dialog.h"
#include "ui/shell/main_window.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

/// Until what a dialog was asked for has come to its end.
constexpr int kAfterQuestionMs = 1000;

/// A field that a wheel would change while somebody only scrolls past it: an answer nobody gave.
bool holds_a_value(QObject* object) {
    return qobject_cast<QComboBox*>(object) != nullptr ||
           qobject_cast<QAbstractSpinBox*>(object) != nullptr ||
           (qobject_cast<QAbstractSlider*>(object) != nullptr &&
            qobject_cast<QScrollBar*>(object) == nullptr);
}

/// A button that nobody means to press twice in half a second (press_once()); others step through
/// a list.
bool acts_once(const QWidget* pressed) {
    const auto* button = qobject_cast<const QPushButton*>(pressed);
    if (button == nullptr) return false;
    const QString role = button->property("role").toString();
    return role == "primary" || role == "danger" || button->property("once").toBool();
}

/// Enter that is held presses a button, and submits a form, thirty times a second.
bool is_held_enter(const QEvent& event, const QWidget* focus) {
    if (event.type() != QEvent::KeyPress) return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.isAutoRepeat() && (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) &&
           (qobject_cast<const QPushButton*>(focus) != nullptr ||
            qobject_cast<const QLineEdit*>(focus) != nullptr);
}

}  // namespace

bool MainWindow::eventFilter(QObject* object, QEvent* event) {
    const bool press =
        event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    if (press && object->isWindowType() &&
        isSecondOfTwo(object, *static_cast<QMouseEvent*>(event))) {
        touched();
        return true;
    }
    switch (event->type()) {
        case QEvent::KeyRelease:
            if (object->isWindowType()) (void)isLeftOverKey(event);
            break;
        case QEvent::KeyPress:
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::TouchBegin:
            touched();
            // Of the window only: the same press comes again for the widget in it.
            if (event->type() == QEvent::KeyPress && object->isWindowType() && isLeftOverKey(event))
                return true;
            if (object->isWindowType() &&
                is_held_enter(*event, object == static_cast<QObject*>(windowHandle())
                                          ? focusWidget()
                                          : QApplication::focusWidget()))
                return true;
            if (closesNotice(object, event)) return true;
            if (event->type() == QEvent::Wheel && holds_a_value(object)) {
                event->ignore();  // goes to the page, which scrolls
                return true;
            }
            break;
        default:
            break;
    }
    return QMainWindow::eventFilter(object, event);
}

void MainWindow::touched() {
    if (context_.signedIn() && context_.lockAfterSeconds() > 0)
        idle_.start(context_.lockAfterSeconds() * 1000);
}

void MainWindow::onCameBack(Qt::ApplicationState state) {
    if (state == Qt::ApplicationActive &&
        (context_.launcher().running() || attempt_ended_.isActive()))
        held_key_.start();
}

bool MainWindow::isLeftOverKey(QEvent* event) {
    if (!held_key_.isValid()) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter && key->key() != Qt::Key_Space)
        return false;
    // It went down elsewhere: here it only repeats, faster than anybody presses, until it is let
    // go.
    constexpr qint64 kPauseMs = 600;
    const bool held = event->type() == QEvent::KeyPress && held_key_.elapsed() < kPauseMs;
    if (held)
        held_key_.start();
    else if (!key->isAutoRepeat())
        held_key_.invalidate();
    return held;
}

bool MainWindow::isSecondOfTwo(const QObject* window, const QMouseEvent& press) {
    const QPoint at = press.globalPosition().toPoint();
    const std::pair<const void*, const void*> on{window, page_.data()};
    if (pressed_.isValid() && pressed_.elapsed() < QApplication::doubleClickInterval() &&
        (at - pressed_at_).manhattanLength() <= QApplication::startDragDistance() &&
        (on != pressed_on_ || acts_once(window == windowHandle() ? childAt(mapFromGlobal(at))
                                                                 : QApplication::widgetAt(at))))
        return true;
    pressed_.start();
    pressed_at_ = at;
    pressed_on_ = on;
    return false;
}

// Escape belongs to an open list, menu or dialog first.
bool MainWindow::closesNotice(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress ||
        static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return false;
    if (QApplication::activePopupWidget() != nullptr ||
        QApplication::activeModalWidget() != nullptr || (search_ && search_->isVisible()))
        return false;
    const auto* widget = qobject_cast<QWidget*>(object);
    const bool here = object == static_cast<QObject*>(windowHandle()) ||
                      (widget != nullptr && widget->window() == this);
    return here && notices_->closeNewest();
}

void MainWindow::lock() {
    if (!context_.signedIn()) return;
    // Where there is no password, a lock keeps nobody out.
    bool alone = false;
    (void)context_.problemOf(
        [&] { alone = context_.store().accounts().local_profile().has_value(); });
    if (alone || context_.launcher().running() || handedOver()) {
        idle_.start(context_.lockAfterSeconds() * 1000);
        return;
    }
    // Whoever was asked has gone: the question is given up as by Escape, and with it what it was
    // asked for. Left open it would keep the session open for whoever comes next.
    if (auto* asked = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        asked->reject();
        idle_.start(kAfterQuestionMs);
        return;
    }
    keepPlace();
    context_.setStoreSetting("last_login", qstr(context_.user().login));
    // Locked in any case, also when the store cannot be written.
    context_.guard(tr("Writing the audit"), [this] {
        context_.audit("session.lock", QString("user %1").arg(context_.user().id));
    });
    context_.signOut();
}

void MainWindow::keepPlace() {
    kept_ = whatIsShown();
    kept_for_ = context_.user().id;
}

bool MainWindow::comesBack(const Kept& kept) {
    Place place = kept.place;
    // An attempt goes on without its owner, and may have ended meanwhile.
    const AttemptOrder& order = context_.launcher().order();
    if (place.page == PageId::kRunning && !context_.launcher().running() &&
        !context_.isBeingSaved(order.recording_file))
        place = isMine(order) ? placeOf(order) : home();
    Page* made = nullptr;
    bool refused = false;
    const auto problem = context_.problemOf([&] {
        try {
            made = make_page(context_, place);
        } catch (const db::StoreError& error) {
            refused = error.kind() == db::StoreError::Kind::kRefused;
            if (!refused) throw;
        }
    });
    if (refused) return false;
    if (problem) {
        showAgain({place, kept.typed});  // Says what is wrong, and offers to try again.
        return true;
    }
    place_ = place;
    showPage(made);
    typeAgain(kept.typed);
    return true;
}

void MainWindow::onUserChanged() {
    trail_.clear();
    drafts_.clear();
    notices_->closeAll();  // They were for whoever was here before.
    buildFrame();
    if (!context_.signedIn()) {
        QString note = context_.sessionNote();
        if (note.isEmpty() && kept_for_ != 0)
            note = tr("Locked after a time without a touch. Come back where you were.");
        return showPlace({PageId::kLogin, 0, {}, {{"note", note}}});
    }
    const bool back = context_.user().id == std::exchange(kept_for_, 0);
    const Kept kept = std::exchange(kept_, {});
    if (!back || !comesBack(kept)) showPlace(lastPlace());
    // Of a participant whose screen came back nothing is asked that is the coordinator's.
    if (!handedOver()) {
        offerLeftovers();
        offer_crash_report(context_, *notices_, this);
    }
    context_.verifyAttempts();  // What the last session did not come to.
}

// What is unsaved on the page asks by itself; an attempt goes on, but its owner must not lose sight
// of it.
bool MainWindow::maySignOut() {
    if ((page_ && !page_->mayLeave()) || !mayTakeBack()) return false;
    return !context_.launcher().running() ||
           confirm(this, tr("Sign out while your attempt is running?"),
                   tr("The attempt goes on in its window and is saved under your name. You do not "
                      "see its result until you sign in again."),
                   tr("Sign out"), tr("Stay"));
}

void MainWindow::switchUser() {
    if (!maySignOut()) return;
    // Switching keeps nobody's name in the field; signing out proposes the same person again.
    context_.setStoreSetting("last_login", {});
    context_.signOut();
}

}  // namespace placode::ui
