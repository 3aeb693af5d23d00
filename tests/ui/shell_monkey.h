// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A monkey at the shell: random keys and clicks on whatever window, dialog or menu is open, while
// attempts run and end. It writes down every press of a button, so that it knows which attempt a
// person has ended by answering its question, and what one event has done.

#include <QApplication>
#include <QEventLoop>
#include <QPointer>
#include <QThread>
#include <QWindow>
#include <random>
#include <set>

#include "shell_harness.h"

namespace placode::ui {

class Monkey : public QObject {
 public:
    Monkey(ShellHarness& shell, uint32_t seed, int events)
        : shell_(shell), random_(seed), left_(events) {
        qApp->installEventFilter(this);
        for (QWidget* widget : QApplication::allWidgets()) listen(widget);
        connect(&launcher(), &AttemptLauncher::started, this, [this] { ++begun; });
        connect(&shell.context(), &AppContext::problemReported, this,
                [this](const Problem& problem) { problems << problem.said(); });
        connect(&launcher(), &AttemptLauncher::ended, this,
                [this](const AttemptEnding& ending) { onEnded(ending); });
    }

    /// Returns when all events are done and whatever was open has been left by keyboard.
    void run() {
        next();
        loop_.exec();
    }

    QStringList findings;  ///< What must not be.
    QStringList problems;  ///< What people were told; explains a finding.
    int begun = 0, confirmed = 0, by_themselves = 0, questions = 0, left_by_keys = 0, deleted = 0;
    std::set<PageId> pages;        ///< Seen.
    std::set<QString> recordings;  ///< Of attempts that have ended.

    [[nodiscard]] QString summary() const {
        return QString(
                   "%1 attempts, %2 ended by a confirmed wish, %3 by themselves; %4 events in "
                   "dialogs and menus; %5 kinds of pages, left by keyboard %6 times")
            .arg(QString::number(begun), QString::number(confirmed), QString::number(by_themselves),
                 QString::number(questions), QString::number(pages.size()),
                 QString::number(left_by_keys));
    }

    bool eventFilter(QObject* object, QEvent* event) override {
        if (event->type() == QEvent::Polish) listen(qobject_cast<QWidget*>(object));
        return false;
    }

 private:
    static constexpr int kBetweenLeaving = 400;  ///< Events from one walk by keyboard to the next.
    static constexpr int kMostTabs = 400, kMostEscapes = 20;

    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(std::max(1, n))); }
    AttemptLauncher& launcher() { return shell_.context().launcher(); }

    void find(const QString& what) {
        if (findings.size() > 20) return;
        findings << QString("%1, %2 events before the end, page %3; before: %4")
                        .arg(what)
                        .arg(left_)
                        .arg(static_cast<int>(shell_.window().current()))
                        .arg(last_.join(" | "));
    }
    void note(const QString& what) {
        last_ << what;
        if (last_.size() > 12) last_.removeFirst();
    }

    /// Released comes before the button's own action, clicked behind it with all that it opened.
    void listen(QWidget* widget) {
        auto* button = qobject_cast<QAbstractButton*>(widget);
        if (button == nullptr || !heard_.insert(button).second) return;
        connect(button, &QObject::destroyed, this, [this, button] { heard_.erase(button); });
        connect(button, &QAbstractButton::released, this, [this, button] {
            const QString name = button->objectName();
            if (name == "stop_and_score" || name == "abort")
                asked_about_ = launcher().order().recording_file;
        });
        connect(button, &QAbstractButton::clicked, this,
                [this, button] { onClicked(button->objectName()); });
    }

    void onClicked(const QString& name) {
        note("CLICKED " + name);
        if (++clicks_ > 1) find("one event presses a second button, " + name);
        if (name == "stop_and_score" || name == "abort") asked_about_.clear();
        if (name != "confirm_yes") return;
        if (shell_.window().current() == PageId::kRecovery) ++deleted;
        closing_ = true;
        if (!asked_about_.isEmpty()) wanted_.insert(asked_about_);
    }

    /// The stand-in says whether it came to an end by itself.
    void onEnded(const AttemptEnding& ending) {
        if (!ending.message.contains("without a recording"))
            recordings.insert(ending.order.recording_file);
        note("ENDED " + ending.message);
        if (ending.message.contains("by itself")) {
            ++by_themselves;
        } else if (wanted_.count(ending.order.recording_file) != 0) {
            ++confirmed;
        } else {
            find("an attempt ended without a confirmed wish: " + ending.message);
        }
    }

    /// A timer does not fire again while its slot runs a dialog's loop: each is good for one event.
    void next() {
        QTimer::singleShot(1, this, [this] { act(); });
    }

    /// One event; within another one only in the loop of a dialog or menu which that has opened.
    void act() {
        if (over_) return;
        next();
        const int level = QThread::currentThread()->loopLevel();
        if (level <= level_) return;
        const int outer_level = std::exchange(level_, level);
        const int outer_clicks = std::exchange(clicks_, 0);
        one_event(outer_level == 0);
        clicks_ = outer_clicks;
        level_ = outer_level;
    }

    void one_event(bool nothing_open) {
        pages.insert(shell_.window().current());
        QWidget* target = QApplication::activePopupWidget();
        if (target == nullptr) target = QApplication::activeModalWidget();
        if (leaving_) return leave(target, nothing_open);
        if (--left_ <= 0 || left_ % kBetweenLeaving == 0) {
            leaving_ = true;
            escapes_ = 0;
            return;
        }
        if (nothing_open) asked_about_.clear();
        if (target != nullptr) {
            ++questions;
        } else {
            target = &shell_.window();
            if (nothing_open && at_the_window()) return;
        }
        below(3) == 0 ? click(target) : press(target);
    }

    /// What people do with the window as a whole. True: that was the event.
    bool at_the_window() {
        if (shell_.window().findChild<QWidget*>("try_again") != nullptr) {
            find("a page cannot be shown: " + shell_.window().banner().text());
            shell_.context().signOut();
            return true;
        }
        if (!shell_.context().signedIn() && below(20) == 0) {
            const char* const kPeople[] = {"demo.trainee", "demo.trainee", "demo.educator",
                                           "demo.coordinator"};
            note("SIGN IN");
            const db::SignIn found =
                shell_.context().store().accounts().sign_in(kPeople[below(4)], "placode-demo");
            shell_.context().signIn(*found.user);
            return true;
        }
        if (!launcher().running() && below(20) == 0) {
            begin_attempt();
            return true;
        }
        if (launcher().running() && shell_.context().signedIn() && below(15) == 0) {
            shell_.window().open({PageId::kRunning, 0, {}, {}});
            return true;
        }
        if (below(300) == 0) {
            close_window();
            return true;
        }
        return false;
    }

    void begin_attempt() {
        AttemptOrder order;
        order.user_id = shell_.idOf("demo.trainee");
        order.user_name = "Demo";
        order.task = order.title = "touch_targets";
        order.device = "mouse";
        order.seed = static_cast<uint64_t>(begun) + 1;
        note("BEGIN");
        launcher().start(order, shell_.context().recordingsFolder());
    }

    /// The cross of the window: while an attempt runs it asks.
    void close_window() {
        note("CLOSE");
        closing_ = false;
        if (shell_.window().close() && launcher().running() && !closing_)
            find("the window closed over an attempt without a question");
        shell_.window().show();
    }

    /// By keyboard only: out of menus and dialogs with Escape, off the page with Tab and Space.
    void leave(QWidget* open, bool nothing_open) {
        if (open != nullptr) {
            if (++escapes_ > kMostEscapes) {
                find("Escape does not leave " + open->windowTitle() + " " + open->objectName());
                open->close();
            }
            return tap(open, Qt::Key_Escape);
        }
        if (!nothing_open) return;
        leaving_ = false;
        if (shell_.context().signedIn()) walk_away();
        over_ = left_ <= 0;
        if (over_) loop_.quit();
    }

    void walk_away() {
        QWidget* window = &shell_.window();
        const auto* rail = window->findChild<QWidget*>("rail");
        // A participant is here: leaving needs the password.
        if (rail == nullptr || !rail->isVisible()) return shell_.context().signOut();
        for (int i = 0; i < kMostTabs; ++i) {
            tap(window, Qt::Key_Tab);
            auto* button = qobject_cast<QToolButton*>(window->focusWidget());
            if (button == nullptr || !button->objectName().startsWith("rail_") ||
                button->isChecked())
                continue;
            ++left_by_keys;
            note("WALK " + button->objectName());
            const Page* before = shell_.window().page();
            tap(window, Qt::Key_Space);
            if (shell_.window().page() == before && clicks_ == 0)
                find("Space on " + button->objectName() + " does not leave the page");
            return;
        }
        find("Tab does not come to the rail");
    }

    /// To the window, as a keyboard does it: what a press closes is gone before it is let go.
    /// QTest::keyPress lets timers run behind each key, while what it asked for is not done yet.
    static void tap(QWidget* target, Qt::Key key, Qt::KeyboardModifier modifier = Qt::NoModifier) {
        const QPointer<QWindow> window = target->window()->windowHandle();
        const QString text = key < Qt::Key_Escape ? QString(QChar(key)).toLower() : QString();
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease})
            if (window) qt_handleKeyEvent(window, type, key, modifier, text, false, 1);
    }

    void press(QWidget* target) {
        constexpr Qt::Key kKeys[] = {
            Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape,   Qt::Key_Tab,    Qt::Key_Tab,
            Qt::Key_Tab,    Qt::Key_Space, Qt::Key_Space,    Qt::Key_Up,     Qt::Key_Down,
            Qt::Key_Left,   Qt::Key_Right, Qt::Key_PageDown, Qt::Key_Delete, Qt::Key_F1,
            Qt::Key_F5,     Qt::Key_A,     Qt::Key_K,        Qt::Key_1,      Qt::Key_Backtab};
        const Qt::Key key = kKeys[below(static_cast<int>(std::size(kKeys)))];
        constexpr Qt::KeyboardModifier kModifiers[] = {Qt::ShiftModifier, Qt::ControlModifier,
                                                       Qt::AltModifier};
        const int held = below(8);
        const Qt::KeyboardModifier modifier = held < 3 ? kModifiers[held] : Qt::NoModifier;
        const QWidget* focus = target->focusWidget();
        note(QString("key %1 %2 on %3, %4")
                 .arg(QKeySequence(key).toString())
                 .arg(modifier, 0, 16)
                 .arg(focus != nullptr ? focus->objectName() : target->objectName())
                 .arg(target->metaObject()->className()));
        tap(target, key, modifier);
    }

    void click(QWidget* target) {
        const QPoint at(below(target->width()), below(target->height()));
        QWidget* child = target->childAt(at);
        // Half of the clicks aim at a button, as a person's do.
        if (below(2) == 0) {
            const auto buttons = target->findChildren<QAbstractButton*>();
            if (!buttons.isEmpty()) child = buttons[below(static_cast<int>(buttons.size()))];
        }
        if (child == nullptr || !child->isVisible() || !child->isEnabled() ||
            child->window() != target->window())
            return;
        if (child->objectName() == "switch_user" && below(10) > 0) return;  // Stays a while.
        note("click " + child->objectName());
        const QPointer<QWidget> pressed = child;
        QTest::mousePress(child, Qt::LeftButton);
        if (pressed) QTest::mouseRelease(pressed, Qt::LeftButton);
    }

    ShellHarness& shell_;
    std::mt19937 random_;
    QEventLoop loop_;
    int left_ = 0, level_ = 0, clicks_ = 0, escapes_ = 0;
    bool over_ = false, leaving_ = false, closing_ = false;
    QString asked_about_;       ///< The attempt whose end is being asked for.
    std::set<QString> wanted_;  ///< Attempts that a person has said may end.
    std::set<const QAbstractButton*> heard_;
    QStringList last_;
};

}  // namespace placode::ui
