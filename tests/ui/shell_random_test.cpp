// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A monkey at the shell while an attempt runs: random keys and clicks on whatever window, dialog or
// menu is open. The attempt's process ends only by a confirmed wish, and the shell never gets
// stuck. $PLACODE_RANDOM_EVENTS sets how many (4,000; 100,000 takes some minutes).

#include <QApplication>
#include <QEventLoop>
#include <QFile>
#include <QPointer>
#include <QWindow>
#include <random>

#include "shell_harness.h"

namespace placode::ui {

namespace {

// In place of the simulator: runs until it is told to end.
const char* const kStandIn =
    "#!/bin/sh\n"
    "trap 'exit 0' TERM USR1\n"
    "echo '{\"t_s\": 1.5, \"phase\": \"inspect\", \"physics_hz\": 1000}'\n"
    "while :; do sleep 0.05; done\n";

/// One event at a time, also while a dialog runs its own loop.
class Monkey : public QObject {
    Q_OBJECT
 public:
    Monkey(ShellHarness& shell, int events) : shell_(shell), left_(events) {}
    void run() {
        next();
        loop_.exec();
    }
    int confirmed = 0, ended_without = 0, dialogs = 0;

 private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

    /// A timer does not fire again while its slot runs a dialog's loop: each is good for one event.
    void next() {
        QTimer::singleShot(1, this, [this] { act(); });
    }

    /// One event; within another one only in a dialog or menu which that has opened.
    void act() {
        if (over_) return;
        next();
        QWidget* open = QApplication::activePopupWidget();
        if (open == nullptr) open = QApplication::activeModalWidget();
        if (busy_ && open == open_) return;
        const bool busy = std::exchange(busy_, true);
        QWidget* before = std::exchange(open_, open);
        one_event();
        busy_ = busy;
        open_ = before;
    }

    void one_event() {
        watch();
        if (--left_ <= 0) {
            over_ = true;
            // Whatever is open can be left.
            for (int i = 0; i < 10 && QApplication::activeModalWidget() != nullptr; ++i)
                QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape);
            loop_.quit();
            return;
        }
        QWidget* target = QApplication::activePopupWidget();
        if (target == nullptr) target = QApplication::activeModalWidget();
        if (target == nullptr) target = &shell_.window();
        if (QApplication::activeModalWidget() != nullptr) ++dialogs;
        below(3) == 0 ? click(target) : press(target);
    }

    /// An end is right after a press on "confirm_yes" only; then another attempt begins.
    void watch() {
        if (shell_.context().launcher().running()) return;
        if (std::exchange(started_, false) && !std::exchange(affirmed_, false)) ++ended_without;
        if (QApplication::activeModalWidget() != nullptr) return;
        affirmed_ = false;
        AttemptOrder order;
        order.user_id = shell_.idOf("demo.trainee");
        order.user_name = "Demo";
        order.task = order.title = "diathermy_ring_small";
        order.device = "mouse";
        shell_.context().launcher().start(order, shell_.context().recordingsFolder());
        started_ = true;
        if (shell_.context().signedIn()) shell_.window().open({PageId::kRunning, 0, {}, {}});
    }

    void affirm(const QWidget* pressed) {
        for (const QWidget* w = pressed; w != nullptr; w = w->parentWidget()) {
            if (w->objectName() != "confirm_yes") continue;
            affirmed_ = true;
            ++confirmed;
            return;
        }
    }

    void press(QWidget* target) {
        constexpr Qt::Key kKeys[] = {Qt::Key_Return, Qt::Key_Escape, Qt::Key_Tab,  Qt::Key_Backtab,
                                     Qt::Key_Space,  Qt::Key_Up,     Qt::Key_Down, Qt::Key_Left,
                                     Qt::Key_Right,  Qt::Key_Home,   Qt::Key_End,  Qt::Key_PageUp,
                                     Qt::Key_Delete, Qt::Key_F1,     Qt::Key_F5,   Qt::Key_A,
                                     Qt::Key_K,      Qt::Key_1,      Qt::Key_W,    Qt::Key_Enter};
        const Qt::Key key = kKeys[below(static_cast<int>(std::size(kKeys)))];
        const Qt::KeyboardModifier modifiers[] = {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier,
                                                  Qt::ControlModifier, Qt::AltModifier};
        QWidget* focus = target->focusWidget() != nullptr ? target->focusWidget() : target;
        if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space) affirm(focus);
        // To the window, as a keyboard does it: what a press closes is gone before it is let go.
        const QPointer<QWindow> window = target->window()->windowHandle();
        const Qt::KeyboardModifier modifier = modifiers[below(5)];
        if (window) QTest::keyPress(window, key, modifier);
        if (window) QTest::keyRelease(window, key, modifier);
    }

    void click(QWidget* target) {
        const QPoint at(below(std::max(1, target->width())), below(std::max(1, target->height())));
        QWidget* child = target->childAt(at);
        // Half of the clicks aim at a button, as a person's do.
        if (below(2) == 0) {
            const auto buttons = target->findChildren<QAbstractButton*>();
            if (!buttons.isEmpty()) child = buttons[below(static_cast<int>(buttons.size()))];
        }
        if (child == nullptr || !child->isVisible() || !child->isEnabled()) return;
        affirm(child);
        const QPointer<QWidget> pressed = child;
        QTest::mousePress(child, Qt::LeftButton);
        if (pressed) QTest::mouseRelease(pressed, Qt::LeftButton);
    }

    ShellHarness& shell_;
    std::mt19937 random_{20261124};
    QEventLoop loop_;
    int left_ = 0;
    bool affirmed_ = false, started_ = false, over_ = false, busy_ = false;
    QWidget* open_ = nullptr;  // compared only
};

}  // namespace

class ShellRandomTest : public QObject {
    Q_OBJECT
 private Q_SLOTS:
    void anAttemptEndsByAConfirmedWishOnly();
};

void ShellRandomTest::anAttemptEndsByAConfirmedWishOnly() {
    ShellHarness shell;
    QFile stand_in(shell.path("stand-in.sh"));
    QVERIFY(stand_in.open(QIODevice::WriteOnly));
    stand_in.write(kStandIn);
    stand_in.close();
    QVERIFY(stand_in.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    shell.simulator = stand_in.fileName();
    shell.start();
    QVERIFY(shell.setUpWithDemonstration());
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.arrives(PageId::kToday));
    Monkey monkey(shell, std::max(200, qEnvironmentVariableIntValue("PLACODE_RANDOM_EVENTS") > 0
                                           ? qEnvironmentVariableIntValue("PLACODE_RANDOM_EVENTS")
                                           : 4000));
    monkey.run();
    QCOMPARE(monkey.ended_without, 0);
    // It found the questions, or it would prove nothing.
    QVERIFY2(monkey.dialogs > 5, qPrintable(QString::number(monkey.dialogs)));
    QVERIFY(QApplication::activeModalWidget() == nullptr);
    shell.context().launcher().abort();
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().launcher().running(); }, 10000));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication app(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    placode::ui::ShellRandomTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_random_test.moc"
