// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts from Start to the score with the real simulator: scored, stopped, killed, recovered.
// The scripted operators run headless on the small task, as fast as the machine can.

#include <signal.h>

#include <QApplication>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

#include "db/recording_file.h"
#include "shell_harness.h"
#include "ui/shell/parts.h"

namespace placode::ui {

namespace {
/// For what a busy machine with two cores does slowly; a full ring takes it a minute or more.
constexpr int kPatienceMs = 240000;

/// The last status line of a simulator, as far as it has said one.
QJsonObject last_status(QProcess& simulator) {
    QJsonObject last;
    while (simulator.canReadLine()) {
        const QJsonObject line = QJsonDocument::fromJson(simulator.readLine()).object();
        if (line.contains("t_s")) last = line;
    }
    return last;
}

}  // namespace

class ShellAttemptTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void expertFinishesAndSeesWhy();
    void reportIsAPdf();
    void stoppedAttemptIsScoredForWhatWasDone();
    void historyHoldsBothAndOpensThem();
    void killedSimulatorIsOfferedAndStoredAsInterrupted();
    void leftoverIsOfferedAfterARestart();
    void whatRecordedNothingIsNoLeftover();
    void recordingStaysWhenTheStoreIsLocked();
    void abortedAttemptCountsAsInterrupted();
    void aStageIsRememberedAndMayBeLeftBeforeItIsReady();
    void unknownDeviceComesBackWithTheReason();
    void educatorSeesAllOfThem();
    void theTimeToTheLockBeginsWhenTheAttemptEnds();
    void theClockOfAWindowWaitsForTheFirstMotion();

 private:
    /// From the course to a running attempt.
    void startAttempt(const QString& device);
    [[nodiscard]] std::vector<db::AttemptRecord> attempts() {
        return shell_->owner().attempts().list(0);
    }
    [[nodiscard]] QStringList recordings() const {
        return QDir(shell_->context().recordingsFolder()).entryList({"*.placode"}, QDir::Files);
    }

    std::unique_ptr<ShellHarness> shell_;
    double expert_points_ = 0;
};

void ShellAttemptTest::initTestCase() {
    QVERIFY2(QFileInfo(PLACODE_BIN_DIR "/placode-sim").isExecutable(),
             "build placode-sim first: this test starts the real simulator");
    shell_ = std::make_unique<ShellHarness>();
    ShellHarness& shell = *shell_;
    QVERIFY(shell.setsUpStation());
    QVERIFY(shell.type("display_name", "Ada Admin"));
    QVERIFY(shell.type("login", "ada"));
    QVERIFY(shell.type("password", "correct horse"));
    QVERIFY(shell.type("password_again", "correct horse"));
    auto* demonstration = shell.find<QAbstractButton>("add_demonstration");
    demonstration->setChecked(true);
    QVERIFY(shell.click("create_administrator"));
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.arrives(PageId::kToday));
}

void ShellAttemptTest::startAttempt(const QString& device) {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_course"));
    QVERIFY(shell.arrives(PageId::kCourse));
    QVERIFY(shell.click("open_diathermy_ring_small"));
    QVERIFY(shell.arrives(PageId::kTask));
    auto* devices = shell.find<QComboBox>("device");
    QVERIFY(devices->findData(device) >= 0);
    devices->setCurrentIndex(devices->findData(device));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(shell.context().launcher().running());
}

void ShellAttemptTest::expertFinishesAndSeesWhy() {
    ShellHarness& shell = *shell_;
    startAttempt("script:expert");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 0.5; },
                            kPatienceMs));
    QCoreApplication::processEvents();
    QVERIFY(shell.text("live_time") != "–");
    // A key that was held in the simulator's window repeats in this one until it is let go.
    QPushButton next("Next", &shell.window());
    next.resize(80, 30);
    next.show();
    next.setFocus();
    int pressed = 0;
    connect(&next, &QPushButton::clicked, &next, [&] { ++pressed; });
    QWindow* window = shell.window().windowHandle();
    Q_EMIT qApp->applicationStateChanged(Qt::ApplicationActive);
    for (int i = 0; i < 15; ++i) {
        QTest::keyPress(window, Qt::Key_Space);
        QTest::qWait(60);
    }
    QTest::keyRelease(window, Qt::Key_Space);
    QCOMPARE(pressed, 0);
    for (int i = 1; i <= 3; ++i) {
        QTest::keyClick(window, Qt::Key_Space);
        QCOMPARE(pressed, i);  // From then on every press is meant, however fast.
    }
    next.hide();
    shell.shot("20_running");
    QVERIFY(shell.arrives(PageId::kResult, 600));
    const auto all = attempts();
    QCOMPARE(all.size(), size_t{1});
    QCOMPARE(all[0].end, sim::EndReason::kFinished);
    QVERIFY(all[0].demonstration);
    expert_points_ = all[0].points;
    QVERIFY2(QTest::qWaitFor([&] {
                 const auto* on = static_cast<QWidget*>(shell.find<QPushButton>("next"));
                 return on != nullptr && shell.window().focusWidget() == on;
             }),
             "Enter goes on, instead of opening what stands first in the rail");
    QVERIFY(shell.text("result_points").contains(format_points(expert_points_)));
    QVERIFY(shell.find<QTableWidget>("metrics")->rowCount() > 10);
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("incision") != nullptr; }, 30000));
    shell.shot("21_result_expert");
    // Saved in the store, so the file is gone.
    QVERIFY(recordings().isEmpty());
}

void ShellAttemptTest::reportIsAPdf() {
    ShellHarness& shell = *shell_;
    shell.save_as = shell.path("report.pdf");
    QVERIFY(shell.click("report_pdf"));
    QVERIFY(shell.bannerSays("report.pdf", 60));
    QFile file(shell.save_as);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-");
    QVERIFY(file.size() > 5000);
    // It names a person: the trail holds it, as of the command line's.
    const auto entries = shell.owner().audit().of_action("report.pdf");
    QCOMPARE(entries.size(), size_t{1});
    QVERIFY(entries[0].detail.ends_with("/report.pdf"));
}

void ShellAttemptTest::stoppedAttemptIsScoredForWhatWasDone() {
    ShellHarness& shell = *shell_;
    startAttempt("script:novice");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 6; },
                            kPatienceMs));
    shell.confirmNext();
    QVERIFY(shell.click("stop_and_score"));
    QVERIFY(shell.arrives(PageId::kResult, 60));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("incision") != nullptr; }, 30000));
    shell.shot("22_result_stopped");
    const auto all = attempts();
    QCOMPARE(all.size(), size_t{2});
    QCOMPARE(all[1].end, sim::EndReason::kClosed);
    // A ring that is not closed costs points, and the reason says so.
    QVERIFY2(all[1].points < expert_points_,
             qPrintable(QString("%1 < %2").arg(all[1].points).arg(expert_points_)));
    QVERIFY(!shell.owner().attempts().detail(all[1].id).score.reasons.empty());
}

void ShellAttemptTest::historyHoldsBothAndOpensThem() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_history"));
    QVERIFY(shell.arrives(PageId::kHistory));
    auto* table = shell.find<QTableWidget>("history_table");
    QCOMPARE(table->rowCount(), 2);
    QVERIFY(shell.find<QWidget>("history_chart") != nullptr);
    shell.shot("23_history");
    table = shell.find<QTableWidget>("history_table");
    table->setFocus();
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(shell.click("rail_today"));
    QVERIFY(shell.arrives(PageId::kToday));
    shell.shot("24_today");
    shell.context().setLanguage("pl");
    shell.shot("25_today_polish");
    shell.context().setLanguage("en");
}

void ShellAttemptTest::killedSimulatorIsOfferedAndStoredAsInterrupted() {
    ShellHarness& shell = *shell_;
    startAttempt("script:intermediate");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 1; },
                            kPatienceMs));
    ::kill(static_cast<pid_t>(shell.context().launcher().processId()), SIGKILL);
    QVERIFY(shell.arrives(PageId::kRecovery));
    QVERIFY(shell.bannerSays("unexpectedly"));
    shell.shot("26_recovery");
    QCOMPARE(attempts().size(), size_t{2});
    QVERIFY(shell.click("recover_save_0"));
    QVERIFY(shell.arrives(PageId::kResult, 60));
    shell.shot("27_result_interrupted");
    const auto all = attempts();
    QCOMPARE(all.size(), size_t{3});
    QCOMPARE(all[2].end, sim::EndReason::kInterrupted);
    // At most the last half second of what the simulator had reported may be missing.
    const double reported_s = shell.context().launcher().status().time_s;
    QVERIFY(reported_s > 1);
    QVERIFY2(all[2].duration_s >= reported_s - 0.5,
             qPrintable(QString("%1 of %2 s").arg(all[2].duration_s).arg(reported_s)));
    QVERIFY(recordings().isEmpty());
}

void ShellAttemptTest::leftoverIsOfferedAfterARestart() {
    ShellHarness& shell = *shell_;
    startAttempt("script:intermediate");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 1; },
                            kPatienceMs));
    shell.start();  // The shell goes away in mid-attempt.
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.bannerSays("not finished"));
    shell.shot("28_banner_leftover");
    QVERIFY(shell.click("banner_offer"));
    QVERIFY(shell.arrives(PageId::kRecovery));
    // Deleting asks first, and only then deletes.
    QCOMPARE(recordings().size(), 1);
    shell.confirmNext();
    QVERIFY(shell.click("recover_delete_0"));
    QVERIFY(QTest::qWaitFor([&] { return recordings().isEmpty(); }, 5000));
    QCOMPARE(attempts().size(), size_t{3});
}

void ShellAttemptTest::whatRecordedNothingIsNoLeftover() {
    QDir().mkpath(shell_->context().recordingsFolder());
    const QString folder = shell_->context().recordingsFolder();
    const auto write = [&](const QString& name, int frames) {
        const auto sink = db::create_recording_file((folder + "/" + name).toStdString());
        sim::RecordingHeader header;
        header.task_id = "diathermy_ring_small";
        sink->begin(header);
        if (frames > 0) sink->append(std::vector<sim::Input>(static_cast<size_t>(frames)), {}, {});
        sink->finish({sim::EndReason::kClosed, frames / 1000.0, 1, 0});
    };
    write("empty.placode", 0);
    write("short.placode", 200);
    for (const Depth depth : {Depth::kLength, Depth::kWhole}) {
        const auto found = find_leftovers(folder, depth);
        QCOMPARE(found.size(), size_t{1});
        QVERIFY(found[0].recording_file.endsWith("short.placode"));
        QCOMPARE(recordings(), QStringList{"short.placode"});
        write("empty.placode", 0);
    }
    QFile::remove(folder + "/empty.placode");
    remove_recording(folder + "/short.placode");
    QVERIFY(recordings().isEmpty());
}

void ShellAttemptTest::theTimeToTheLockBeginsWhenTheAttemptEnds() {
    ShellHarness& shell = *shell_;
    constexpr int kLockMs = 3000;
    shell.lock_after_s = kLockMs / 1000;
    shell.start();
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    startAttempt("script:novice");
    if (QTest::currentTestFailed()) return;
    // Nobody touches the shell; the attempt ends shortly before the second time is over.
    QTest::qWait(2 * kLockMs - 500);
    QVERIFY2(shell.context().signedIn(), "locked while an attempt ran");
    QVERIFY(shell.context().launcher().running());
    shell.context().launcher().abort();
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().launcher().running(); }, 10000));
    QTest::qWait(kLockMs - 1000);
    QVERIFY2(shell.context().signedIn(), "locked before the time was over");
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().signedIn(); }, 2 * kLockMs));
    shell.lock_after_s = 0;
    shell.start();
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
}

void ShellAttemptTest::recordingStaysWhenTheStoreIsLocked() {
    ShellHarness& shell = *shell_;
    startAttempt("script:intermediate");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 0.5; },
                            kPatienceMs));
    {
        QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "other program");
        other.setDatabaseName(shell.path("placode.db"));
        QVERIFY(other.open());
        QSqlQuery lock(other);
        QVERIFY(lock.exec("BEGIN IMMEDIATE"));
        shell.confirmNext();
        QVERIFY(shell.click("stop_and_score"));
        QVERIFY(shell.bannerSays("locked", 60));
        QVERIFY(shell.arrives(PageId::kRecovery));
        QCOMPARE(recordings().size(), 1);
        QVERIFY(lock.exec("ROLLBACK"));
    }
    QSqlDatabase::removeDatabase("other program");
    QVERIFY(shell.click("recover_save_0"));
    QVERIFY(shell.arrives(PageId::kResult, 60));
    const auto all = attempts();
    QCOMPARE(all.size(), size_t{4});
    QCOMPARE(all[3].end, sim::EndReason::kClosed);
    QVERIFY(recordings().isEmpty());
}

void ShellAttemptTest::abortedAttemptCountsAsInterrupted() {
    ShellHarness& shell = *shell_;
    startAttempt("script:expert");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 1; },
                            kPatienceMs));
    shell.confirmNext();
    QVERIFY(shell.click("abort"));
    QVERIFY(shell.arrives(PageId::kResult, 60));
    QCOMPARE(attempts().back().end, sim::EndReason::kInterrupted);
}

void ShellAttemptTest::aStageIsRememberedAndMayBeLeftBeforeItIsReady() {
    ShellHarness& shell = *shell_;
    const auto open = [&](const char* task) {
        shell.window().open({PageId::kTask, 0, task, {}});
        return shell.arrives(PageId::kTask);
    };
    QVERIFY(open("touch_targets"));
    QVERIFY2(shell.find<QComboBox>("stage") == nullptr, "a task without stages has no choice");
    QVERIFY(open("suture_run"));
    auto* stages = shell.find<QComboBox>("stage");
    QVERIFY(stages != nullptr);
    QCOMPARE(stages->count(), 3);
    QCOMPARE(stages->currentData().toInt(), 0);
    QCOMPARE(stages->itemText(2), QString("bite 3"));
    QVERIFY(shell.find<QLabel>("stage_note")->isHidden());
    stages->setCurrentIndex(2);
    QVERIFY(!shell.find<QLabel>("stage_note")->isHidden());
    shell.shot("20_task_stage");
    QVERIFY(shell.choose("device", "script:expert"));
    // Nobody has prepared it yet.
    const QTemporaryDir caches;
    const QByteArray cache_before = qgetenv("XDG_CACHE_HOME");
    qputenv("XDG_CACHE_HOME", caches.path().toUtf8());
    const size_t before = attempts().size();
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    AttemptLauncher& launcher = shell.context().launcher();
    // Its first line says that it obeys signals by now; the expert is at work for long.
    QVERIFY(QTest::qWaitFor([&] { return !launcher.status().phase.isEmpty(); }, kPatienceMs));
    launcher.finish();
    QVERIFY(shell.arrives(PageId::kTask, 60));
    QVERIFY(!launcher.running());
    QCOMPARE(attempts().size(), before);
    QVERIFY2(recordings().isEmpty(), "nothing was recorded");
    cache_before.isNull() ? qunsetenv("XDG_CACHE_HOME") : qputenv("XDG_CACHE_HOME", cache_before);
    QVERIFY(open("touch_targets"));
    QVERIFY(open("suture_run"));
    QCOMPARE(shell.find<QComboBox>("stage")->currentData().toInt(), 2);
    QVERIFY(open("suture_slit"));
    QCOMPARE(shell.find<QComboBox>("stage")->currentData().toInt(), 0);
}

void ShellAttemptTest::unknownDeviceComesBackWithTheReason() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_course"));
    QVERIFY(shell.arrives(PageId::kCourse));
    AttemptOrder order;
    order.user_id = shell.context().user().id;
    order.task = "diathermy_ring_small";
    order.device = "theremin";
    shell.context().launcher().start(order, shell.context().recordingsFolder());
    QVERIFY(shell.bannerSays("theremin", 60));
    QVERIFY(recordings().isEmpty());
}

void ShellAttemptTest::educatorSeesAllOfThem() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    QVERIFY(shell.click("rail_attempts"));
    QVERIFY(shell.arrives(PageId::kAttempts));
    auto* table = shell.find<QTableWidget>("attempts_table");
    QCOMPARE(table->rowCount(), 5);
    shell.shot("29_attempts");
    table = shell.find<QTableWidget>("attempts_table");
    table->setFocus();
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kResult));
    // Another person's attempt: it can be read and printed, not repeated.
    QVERIFY(shell.find<QPushButton>("report_pdf") != nullptr);
    QVERIFY(shell.find<QPushButton>("again") == nullptr);
}

// It began with the window: whoever looked at the picture first had lost the time for it.
void ShellAttemptTest::theClockOfAWindowWaitsForTheFirstMotion() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) QSKIP("no display to open a window on");
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", "touch_targets", "--device", "keyboard", "--size", "320x240",
                     "--mute", "--status"});
    QJsonObject status;
    const auto look = [&] {
        if (const QJsonObject now = last_status(simulator); !now.isEmpty()) status = now;
        return status["waiting"].toBool() || status["t_s"].toDouble() > 0 ||
               simulator.state() == QProcess::NotRunning;
    };
    QVERIFY(QTest::qWaitFor(look, kPatienceMs));
    if (simulator.state() == QProcess::NotRunning)
        QSKIP(simulator.readAllStandardError().constData());  // no OpenGL
    QTest::qWait(2000);  // time in which a clock that does not wait would go on
    (void)look();
    QCOMPARE(status["t_s"].toDouble(), 0.0);
    QVERIFY(status["waiting"].toBool());
    simulator.terminate();
    QVERIFY(simulator.waitForFinished(kPatienceMs));
    (void)look();
    QCOMPARE(status["end"].toString(), QString("interrupted"));
    QCOMPARE(status["t_s"].toDouble(), 0.0);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellAttemptTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_attempt_test.moc"
