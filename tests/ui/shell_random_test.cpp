// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of random keys and clicks at the shell while attempts run: an attempt's process ends by
// itself or by a confirmed wish, no event is taken twice, every page and dialog can be left by
// keyboard, and every attempt is in the store afterwards.
//   $PLACODE_RANDOM_EVENTS   how many (2,500; 20,000 take some minutes)
//   $PLACODE_RANDOM_SEED     which (1); a failure names it

#include <QProcess>

#include "shell_monkey.h"

namespace placode::ui {

namespace {

// In place of the simulator: runs until it is told to end, one of four for a second only, and
// leaves a recording behind; one of four finds no device. Says on its error output how it ended.
const char* const kStandIn = R"(#!/bin/sh
record=
seed=0
while [ $# -gt 0 ]; do
    [ "$1" = --record ] && record=$2
    [ "$1" = --seed ] && seed=$2
    shift
done
[ -n "$record" ] || exit 0
if [ $((seed % 4)) = 2 ]; then
    echo 'device "mouse": ended by itself, without a recording' >&2
    exit 2
fi
# Behind the end of the file, where SQLite does not look: the same recording is not saved twice.
leave() { cp "@RECORDING@" "$record" && printf %s "$record" >> "$record"; }
trap 'leave; echo asked >&2; exit 0' TERM USR1
echo '{"t_s": 1.5, "phase": "inspect", "physics_hz": 1000}'
turns=$((seed % 4 == 1 ? 20 : 1000000))
while [ $turns -gt 0 ]; do
    sleep 0.05
    turns=$((turns - 1))
done
trap '' TERM USR1
leave
echo by itself >&2
)";

int number_of(const char* variable, int otherwise) {
    const int given = qEnvironmentVariableIntValue(variable);
    return given > 0 ? given : otherwise;
}

}  // namespace

class ShellRandomTest : public QObject {
    Q_OBJECT
 private Q_SLOTS:
    void anAttemptEndsByItselfOrByAConfirmedWish();
    void anAnswerIsForTheAttemptItWasAskedAbout();
    void anotherPersonAtTheEndIsLedHome();
    void nobodyEndsAnAttemptWithoutSigningIn();
    void whatIsNotThereYetDoesNoHarm();

 private:
    /// The stand-in of a shell that is set up, with the trainee signed in.
    void prepare(ShellHarness& shell);
    static void order(ShellHarness& shell, uint64_t seed = 0);
};

void ShellRandomTest::prepare(ShellHarness& shell) {
    const QString recording = shell.path("made.placode");
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", "touch_targets", "--device", "script:expert", "--duration", "4",
                     "--headless", "--fast", "--record", recording});
    QVERIFY(simulator.waitForFinished(120000));
    QVERIFY2(QFile::exists(recording), simulator.readAllStandardError().constData());
    QFile stand_in(shell.path("stand-in.sh"));
    QVERIFY(stand_in.open(QIODevice::WriteOnly));
    stand_in.write(QByteArray(kStandIn).replace("@RECORDING@", recording.toUtf8()));
    stand_in.close();
    QVERIFY(stand_in.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    shell.simulator = stand_in.fileName();
    shell.start();
    QVERIFY(shell.setUpWithDemonstration());
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.arrives(PageId::kToday));
}

void ShellRandomTest::order(ShellHarness& shell, uint64_t seed) {
    AttemptOrder order;
    order.user_id = shell.idOf("demo.trainee");
    order.user_name = "Demo";
    order.task = order.title = "touch_targets";
    order.device = "mouse";
    order.seed = seed;
    shell.context().launcher().start(order, shell.context().recordingsFolder());
}

void ShellRandomTest::anAttemptEndsByItselfOrByAConfirmedWish() {
    ShellHarness shell;
    prepare(shell);
    if (QTest::currentTestFailed()) return;
    const int seed = number_of("PLACODE_RANDOM_SEED", 1);
    // Of everybody: the monkey begins attempts as an educator, too.
    const auto saved = [&] { return shell.owner().attempts().list(0).size(); };
    const size_t before = saved();
    Monkey monkey(shell, static_cast<uint32_t>(seed), number_of("PLACODE_RANDOM_EVENTS", 2500));
    monkey.run();
    qInfo().noquote() << "seed" << seed << ":" << monkey.summary();
    QVERIFY2(monkey.findings.isEmpty(),
             qPrintable(QString("seed %1:\n%2").arg(seed).arg(monkey.findings.join("\n"))));
    // It found the questions and the pages, or it would prove nothing.
    QVERIFY(monkey.confirmed > 0 && monkey.by_themselves > 0 && monkey.left_by_keys > 0);
    QVERIFY(monkey.questions > 5 && monkey.pages.size() > 5);
    // The last attempt ends; nothing of any is lost.
    if (shell.context().launcher().running()) shell.context().launcher().abort();
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().launcher().running(); }, 10000));
    const auto left = [&] {
        return find_leftovers(shell.context().recordingsFolder(), Depth::kLength).size();
    };
    const size_t ended = monkey.recordings.size();
    const auto kept = [&] {
        return saved() - before + left() + static_cast<size_t>(monkey.deleted);
    };
    QVERIFY2(QTest::qWaitFor([&] { return kept() >= ended; }, 20000),
             qPrintable(QString("seed %1: %2 ended, %3 kept; people were told:\n%4")
                            .arg(seed)
                            .arg(ended)
                            .arg(kept())
                            .arg(monkey.problems.join("\n"))));
}

// The question of one attempt stands, it ends by itself and another begins.
void ShellRandomTest::anAnswerIsForTheAttemptItWasAskedAbout() {
    ShellHarness shell;
    prepare(shell);
    if (QTest::currentTestFailed()) return;
    AttemptLauncher& launcher = shell.context().launcher();
    for (const char* button : {"stop_and_score", "abort"}) {
        order(shell);
        shell.window().open({PageId::kRunning, 0, {}, {}});
        QVERIFY(shell.arrives(PageId::kRunning));
        QVERIFY(QTest::qWaitFor([&] { return launcher.status().time_s > 0; }, 5000));
        QString second;
        bool answered = false;
        QTimer::singleShot(50, &shell.window(), [&] {
            launcher.finish();  // As by its goal.
            QVERIFY(QTest::qWaitFor([&] { return !launcher.running(); }, 5000));
            order(shell);
            second = launcher.order().recording_file;
            QWidget* open = QApplication::activeModalWidget();
            auto* yes = open != nullptr ? open->findChild<QPushButton*>("confirm_yes") : nullptr;
            if (yes != nullptr) QTest::mouseClick(yes, Qt::LeftButton);
            answered = true;
        });
        QVERIFY(shell.click(button));
        QVERIFY(QTest::qWaitFor([&] { return answered; }, 10000));
        QVERIFY(QApplication::activeModalWidget() == nullptr);
        QVERIFY(QTest::qWaitFor([&] { return launcher.status().time_s > 0; }, 5000));
        QTest::qWait(300);  // Time enough to end; the last moment proves that it did not.
        QVERIFY2(launcher.running() && launcher.order().recording_file == second, button);
        launcher.abort();
        QVERIFY(QTest::qWaitFor([&] { return !launcher.running(); }, 5000));
    }
}

// The trainee has gone, the coordinator looks at the attempt when it ends or cannot begin. He may
// not open its task: he was left before "This page cannot be shown", or on the page of the end.
void ShellRandomTest::anotherPersonAtTheEndIsLedHome() {
    constexpr uint64_t kForASecond = 1, kNoDevice = 2;  // To the stand-in.
    ShellHarness shell;
    prepare(shell);
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
    for (const uint64_t seed : {kNoDevice, kForASecond}) {
        order(shell, seed);
        shell.window().open({PageId::kRunning, 0, {}, {}});
        QCOMPARE(shell.window().current(), PageId::kRunning);
        QVERIFY2(shell.arrives(PageId::kStudies), qPrintable(shell.window().banner().text()));
        QVERIFY(shell.window().findChild<QWidget*>("try_again") == nullptr);
    }
    QCOMPARE(shell.owner().attempts().list(shell.idOf("demo.trainee")).size(), size_t{1});
}

// The log-in page showed the way to the running attempt, with its two buttons, to anybody.
void ShellRandomTest::nobodyEndsAnAttemptWithoutSigningIn() {
    ShellHarness shell;
    prepare(shell);
    if (QTest::currentTestFailed()) return;
    order(shell);
    // A frame that was left lives on for a moment.
    const auto way_there = [&] {
        const auto chips = shell.window().findChildren<QToolButton*>("running_chip");
        return std::any_of(chips.begin(), chips.end(),
                           [](auto* chip) { return chip->isVisible(); });
    };
    QVERIFY(QTest::qWaitFor(way_there, 5000));
    shell.context().signOut();
    QVERIFY(shell.arrives(PageId::kLogin));
    QTest::qWait(50);
    QVERIFY(!way_there());
    shell.window().open({PageId::kRunning, 0, {}, {}});
    QVERIFY(shell.find<QAbstractButton>("abort") == nullptr);
    shell.window().open({PageId::kLogin, 0, {}, {}});
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    QVERIFY(QTest::qWaitFor(way_there, 5000));
    shell.context().launcher().abort();
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().launcher().running(); }, 5000));
}

// An unreadable definition that is exported ended the shell; without a study, a sheet from paper
// led to a page that cannot be shown.
void ShellRandomTest::whatIsNotThereYetDoesNoHarm() {
    ShellHarness shell;
    QVERIFY(shell.setUpWithDemonstration());
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
    for (const char* text : {"k1", "{\"id\": 5}"}) {
        shell.save_as = shell.path("out.json");
        QFile::remove(shell.save_as);
        shell.window().open(
            {PageId::kProtocols, 0, {}, {{"kind", "study"}, {"text", text}, {"unsaved", true}}});
        QVERIFY(shell.arrives(PageId::kProtocols));
        QVERIFY(shell.click("definition_export"));
        QVERIFY2(QFile::exists(shell.save_as), text);
    }
    (void)shell.owner().studies().new_participant("sus");
    shell.window().open({PageId::kStudyData, 0, {}, {{"study", "sus"}}});
    QVERIFY(shell.arrives(PageId::kStudyData));
    for (const char* name : {"enter_first", "enter_second"}) {
        const auto* button = shell.find<QAbstractButton>(name);
        QVERIFY(button != nullptr && !button->isEnabled());
    }
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    // Long runs outlast QtTest's five minutes for one function.
    if (qEnvironmentVariableIsEmpty("QTEST_FUNCTION_TIMEOUT"))
        qputenv("QTEST_FUNCTION_TIMEOUT", "3600000");
    QApplication app(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    placode::ui::ShellRandomTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_random_test.moc"
