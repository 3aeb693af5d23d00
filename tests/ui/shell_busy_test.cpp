// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Long work in the background, such as a check of the store: an attempt is saved beside it, and the
// window that is closed meanwhile says what it waits for. The threads of all other work are held
// up, so nothing depends on how long anything takes.

#include "all_threads_taken.h"
#include "shell_harness.h"

namespace placode::ui {

class ShellBusyTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void anAttemptIsSavedBesideWorkThatTakesLong();
    void closingAsksWhileSomethingIsRunning();
    void whatFailedKeepsTheWindowOpen();
    void theWindowClosesWhenTheWorkIsDone();

 private:
    /// Work that waits for a thread, and whether it was done.
    void begin(bool fails = false);

    std::unique_ptr<ShellHarness> shell_;
    bool done_ = false;
};

void ShellBusyTest::initTestCase() {
    QApplication::setQuitOnLastWindowClosed(false);
    shell_ = std::make_unique<ShellHarness>();
    shell_->hands = "script:novice";
    shell_->start();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
}

void ShellBusyTest::begin(bool fails) {
    done_ = false;
    shell_->context().background(
        &shell_->window(), "Checking the store",
        [fails](db::Store&) {
            if (fails) throw std::runtime_error("broken");
        },
        [this](bool) { done_ = true; });
}

void ShellBusyTest::anAttemptIsSavedBesideWorkThatTakesLong() {
    ShellHarness& shell = *shell_;
    const size_t before = shell.owner().attempts().list(0).size();
    shell.window().visit({PageId::kTask, 0, "touch_targets", {}});
    QVERIFY(shell.arrives(PageId::kTask));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    AttemptLauncher& launcher = shell.context().launcher();
    QVERIFY(QTest::qWaitFor([&] { return launcher.status().time_s > 0.5; }, 240000));
    // An attempt begins when nothing else is going on; what begins during it may last longer.
    AllThreadsTaken taken(shell.context().workers());
    begin();
    shell.confirmNext();
    QVERIFY(shell.click("stop_and_score"));
    QVERIFY(shell.arrives(PageId::kResult, 120));
    QCOMPARE(shell.owner().attempts().list(0).size(), before + 1);
    QVERIFY2(!done_ && shell.context().busy(), "the other work waits still");
}

void ShellBusyTest::closingAsksWhileSomethingIsRunning() {
    ShellHarness& shell = *shell_;
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    shell.window().visit({PageId::kAccount, 0, {}, {}});
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    {
        AllThreadsTaken taken(shell.context().workers());
        begin();
        shell.refuseNext();
        QVERIFY(!shell.window().close());
        QVERIFY(shell.window().isVisible());
    }
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    QCoreApplication::processEvents();
    QVERIFY2(shell.window().isVisible(), "it was told to stay");
}

void ShellBusyTest::whatFailedKeepsTheWindowOpen() {
    ShellHarness& shell = *shell_;
    {
        AllThreadsTaken taken(shell.context().workers());
        begin(true);
        shell.confirmNext();
        QVERIFY(!shell.window().close());
    }
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    QTest::qWait(50);
    QVERIFY(shell.window().isVisible());
    QVERIFY(shell.window().banner().isShown());
}

void ShellBusyTest::theWindowClosesWhenTheWorkIsDone() {
    ShellHarness& shell = *shell_;
    {
        AllThreadsTaken taken(shell.context().workers());
        begin();
        shell.confirmNext();
        QVERIFY(!shell.window().close());
        QVERIFY2(shell.window().isVisible(), "until the work is done");
        QVERIFY(!done_);
    }
    QVERIFY(QTest::qWaitFor([&] { return !shell.window().isVisible(); }, 60000));
    QVERIFY(done_);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication app(argc, argv);
    placode::ui::ShellBusyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_busy_test.moc"
