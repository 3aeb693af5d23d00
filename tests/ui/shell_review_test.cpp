// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Review through the real windows: a novice's attempt by the real simulator, its result page, the
// replay steered from the shell, remarks that trainee and educator share.

#include <QApplication>
#include <QFileInfo>
#include <QScrollBar>
#include <QTableWidget>

#include "reports/words.h"
#include "shell_harness.h"
#include "ui/shell/ledger_view.h"
#include "ui/shell/parts.h"
#include "ui/shell/replay_place.h"

namespace placode::ui {

namespace {
/// For what a busy machine with two cores does slowly.
constexpr int kPatienceMs = 240000;
}  // namespace

class ShellReviewTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void resultPageSaysWhatWhenAndWhere();
    void resultPageFitsSmallAndLargeScreens();
    void reasonsAreToldInPolish();
    void secondAttemptIsComparedWithTheOwnBand();
    void timeLineIsUsedByKeyboardAlone();
    void replayObeysCameraSpeedPauseAndJump();
    void educatorRemarksAndTheTraineeReadsIt();
    void remarkIsRemovedAndPutBack();

 private:
    /// A scripted attempt on the small field, stopped after `seconds` of simulated time.
    void attempt(const QString& device, double seconds);
    [[nodiscard]] bool picturesAreThere() {
        return QTest::qWaitFor([this] { return shell_->find<QWidget>("way_2") != nullptr; }, 30000);
    }
    [[nodiscard]] LedgerView* ledger() {
        return dynamic_cast<LedgerView*>(shell_->find<QWidget>("ledger"));
    }
    /// The replay's clock in seconds.
    [[nodiscard]] double clock() const {
        const QStringList parts = shell_->text("replay_clock").section(" / ", 0, 0).split(':');
        return parts.size() == 2 ? 60 * parts[0].toDouble() + parts[1].toDouble() : -1;
    }
    [[nodiscard]] std::vector<db::AttemptRecord> attempts() {
        return shell_->owner().attempts().list(0);
    }
    /// Notes what the simulator is called with, and calls it.
    void noteArguments();
    /// Where the window of the last replay was told to stand.
    [[nodiscard]] QRect placeOfReplay() const;

    std::unique_ptr<ShellHarness> shell_;
};

void ShellReviewTest::initTestCase() {
    QVERIFY2(QFileInfo(PLACODE_BIN_DIR "/placode-sim").isExecutable(),
             "build placode-sim first: this test starts the real simulator");
    shell_ = std::make_unique<ShellHarness>();
    noteArguments();
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
    attempt("script:novice", 14);
}

void ShellReviewTest::noteArguments() {
    QFile before(shell_->path("simulator.sh"));
    QVERIFY(before.open(QIODevice::WriteOnly));
    before.write(QString("#!/bin/sh\necho \"$@\" >> '%1'\nexec '%2' \"$@\"\n")
                     .arg(shell_->path("arguments.txt"), shell_->simulator)
                     .toUtf8());
    before.close();
    QVERIFY(before.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    shell_->simulator = before.fileName();
    shell_->start();
}

QRect ShellReviewTest::placeOfReplay() const {
    QFile file(shell_->path("arguments.txt"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QStringList calls = QString::fromUtf8(file.readAll()).trimmed().split('\n');
    const QStringList words = calls.last().split(' ');
    const auto pair = [&](const char* name, char between) {
        const qsizetype at = words.indexOf(name);
        return at < 0 ? QStringList{} : words.value(at + 1).split(between);
    };
    const QStringList at = pair("--position", ','), size = pair("--size", 'x');
    if (at.size() != 2 || size.size() != 2) return {};
    return {at[0].toInt(), at[1].toInt(), size[0].toInt(), size[1].toInt()};
}

void ShellReviewTest::attempt(const QString& device, double seconds) {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kTask, 0, "diathermy_ring_small", {}});
    QVERIFY(shell.arrives(PageId::kTask));
    auto* devices = shell.find<QComboBox>("device");
    devices->setCurrentIndex(devices->findData(device));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > seconds; },
                            kPatienceMs));
    shell.confirmNext();
    QVERIFY(shell.click("stop_and_score"));
    QVERIFY(shell.arrives(PageId::kResult, 60));
    QVERIFY(picturesAreThere());
}

void ShellReviewTest::resultPageSaysWhatWhenAndWhere() {
    ShellHarness& shell = *shell_;
    const auto detail = shell.owner().attempts().detail(attempts().back().id);
    QVERIFY(!detail.score.reasons.empty());
    QVERIFY(shell.text("reason_0").size() > 10);
    for (const char* picture : {"damage_map", "energy_map", "incision", "way_0", "way_1", "way_2"})
        QVERIFY2(shell.find<QWidget>(picture) != nullptr, picture);
    // The time line shows what the ledger of the store holds.
    QVERIFY(ledger() != nullptr);
    const auto& entries = ledger()->picture().entries;
    const auto stored = assessment::damage_ledger(detail.events, {});
    QVERIFY(entries.size() >= stored.size());
    for (const auto& each : stored) {
        bool there = false;
        for (const auto& shown : entries)
            there =
                there || (shown.kind == each.kind && std::abs(shown.from_s - each.from_s) < 0.6);
        QVERIFY2(there, qPrintable(reports::ledger_words(each)));
    }
    shell.shot("40_result");
    QVERIFY(picturesAreThere());
    // The other reasons unfold in place: neither the page nor the focus goes elsewhere.
    QVERIFY(detail.score.reasons.size() > 3);
    auto* scroll = shell.window().page()->findChild<QScrollArea*>();
    shell.find<QPushButton>("more_reasons")->setFocus();
    QCoreApplication::processEvents();
    const int place = scroll->verticalScrollBar()->value();
    QVERIFY(shell.click("more_reasons"));
    QVERIFY(shell.find<QLabel>("reason_3")->isVisibleTo(shell.window().page()));
    QCOMPARE(scroll->verticalScrollBar()->value(), place);
    QVERIFY(!shell.focusIsIn("comment_text"));
    shell.keep(shell.window().grab(), "40_result_reasons");
    shell.scrollTo("ledger");
    shell.shot("41_result_ledger");
    QVERIFY(picturesAreThere());
}

void ShellReviewTest::resultPageFitsSmallAndLargeScreens() {
    ShellHarness& shell = *shell_;
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY2(shell.fits(), qPrintable(QString("%1 wide").arg(size.width())));
        shell.whole(QString("42_result_%1").arg(size.width()));
        QVERIFY(picturesAreThere());
    }
    shell.window().resize(1366, 768);
}

void ShellReviewTest::reasonsAreToldInPolish() {
    ShellHarness& shell = *shell_;
    const auto reasons = shell.owner().attempts().detail(attempts().back().id).score.reasons;
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(picturesAreThere());
    for (const auto& reason : reasons) {
        const QString words = reports::reason_words(reason);
        QVERIFY2(words != QString::fromStdString(reason.text), reason.text.c_str());
        QVERIFY2(!words.contains('{') && !words.contains("the "), qPrintable(words));
    }
    QVERIFY(reports::phase_words(sim::Phase::kIncise) != "Incise");
    shell.whole("43_result_polish");
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kResult));
}

void ShellReviewTest::secondAttemptIsComparedWithTheOwnBand() {
    ShellHarness& shell = *shell_;
    attempt("script:expert", 5);
    if (QTest::currentTestFailed()) return;
    auto* table = shell.find<QTableWidget>("metrics");
    int strips = 0;
    for (int row = 0; row < table->rowCount(); ++row)
        QVERIFY2(!table->item(row, 2)->text().isEmpty(), qPrintable(table->item(row, 0)->text()));
    for (int row = 0; row < table->rowCount(); ++row)
        strips += table->cellWidget(row, 5) != nullptr ? 1 : 0;
    QVERIFY(strips > 5);
    bool before = false;
    for (const QLabel* label : shell.find<QWidget>("themes")->findChildren<QLabel*>())
        before = before || label->text().contains("before");
    QVERIFY(before);
    shell.whole("44_result_band");
}

void ShellReviewTest::timeLineIsUsedByKeyboardAlone() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kResult, attempts().front().id, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(picturesAreThere());
    if (ledger()->picture().entries.empty()) QSKIP("this novice did no harm");
    ledger()->setFocus();
    QTest::keyClick(ledger(), Qt::Key_End);
    QCOMPARE(ledger()->selection(), static_cast<int>(ledger()->picture().entries.size()) - 1);
    QTest::keyClick(ledger(), Qt::Key_Home);
    QCOMPARE(ledger()->selection(), 0);
    QCOMPARE(shell.text("ledger_words"), ledger()->words(0));
    QTest::keyClick(ledger(), Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kWatch));
    QVERIFY(shell.click("back_to_result"));
    QVERIFY(shell.arrives(PageId::kResult));
}

void ShellReviewTest::replayObeysCameraSpeedPauseAndJump() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("watch"));
    QVERIFY(shell.arrives(PageId::kWatch));
    // One click is enough: it starts by itself as soon as the recording is there.
    QVERIFY(QTest::qWaitFor([&] { return ledger() != nullptr; }, 30000));
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("replay_play")->text() == "Pause"; }, kPatienceMs));
    QCOMPARE(shell.find<QPushButton>("replay_play")->property("icon_name").toString(),
             QString("pause"));
    // Its window stands clear of what it is steered by, where the screen has room for both.
    const QWidget* steer = shell.find<QPushButton>("replay_play")->parentWidget();
    const QRect wanted = replay_place(*steer, ledger());
    // The simulator is called by a script that notes its arguments first: it takes its time.
    QVERIFY2(QTest::qWaitFor([&] { return placeOfReplay().isValid(); }, 20000),
             "the replay was told no place");
    QCOMPARE(placeOfReplay(), wanted);
    for (const char* name : {"replay_play", "replay_back", "replay_on", "replay_close"}) {
        const auto* button = shell.find<QPushButton>(name);
        const QRect there(button->mapToGlobal(QPoint(0, 0)), button->size());
        QVERIFY2(!there.intersects(placeOfReplay()), name);
    }
    shell.shot("45_watch_begins");
    QVERIFY(QTest::qWaitFor([&] { return ledger() != nullptr; }, 30000));
    auto* speed = shell.find<QComboBox>("replay_speed");
    speed->setCurrentIndex(speed->findData(8.0));
    Q_EMIT speed->activated(speed->currentIndex());
    QVERIFY(QTest::qWaitFor([&] { return clock() >= 2; }, kPatienceMs));
    auto* camera = shell.find<QComboBox>("replay_camera");
    camera->setCurrentIndex(camera->findData("above"));
    Q_EMIT camera->activated(camera->currentIndex());
    QVERIFY(shell.click("replay_play"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("replay_said") == "Paused"; }, 10000));
    QCOMPARE(camera->currentData().toString(), QString("above"));
    const double held = clock();
    QTest::qWait(300);  // time in which a replay that does not hold would go on
    QCOMPARE(clock(), held);
    // Back to the beginning: simulated again from there.
    ledger()->chosen(1.0, -1);
    QVERIFY(QTest::qWaitFor([&] { return clock() < held && clock() >= 1; }, kPatienceMs));
    shell.keep(shell.window().grab(), "46_watch_paused");
    QVERIFY(shell.fits());
    QVERIFY(shell.click("replay_close"));
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("replay_play")->text() == "Watch"; }, 10000));
    QVERIFY(!shell.window().banner().isVisible());
    // Closed, it begins again with one more click.
    QVERIFY(shell.click("replay_play"));
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("replay_play")->text() == "Pause"; }, kPatienceMs));
    QVERIFY(shell.click("replay_close"));
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("replay_play")->text() == "Watch"; }, 10000));
}

void ShellReviewTest::educatorRemarksAndTheTraineeReadsIt() {
    ShellHarness& shell = *shell_;
    const int64_t id = attempts().front().id;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    shell.window().open({PageId::kWatch, id, {}, {{"from_s", 4.0}}});
    QVERIFY(shell.arrives(PageId::kWatch));
    // Opened at a moment, it starts by itself. Looked for on this page: the one before may still be
    // on its way out.
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.window().page()->findChild<QLineEdit*>("comment_text") != nullptr; },
        30000));
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("replay_play")->text() == "Pause"; }, kPatienceMs));
    QVERIFY(QTest::qWaitFor([&] { return clock() >= 4; }, kPatienceMs));
    QVERIFY(shell.click("replay_play"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("replay_said") == "Paused"; }, 20000));
    QVERIFY(shell.type("comment_text", "Keep the tip moving here."));
    const int interval = QApplication::doubleClickInterval();
    // A second press, a double click and a held Enter write nothing more; a busy machine is slow.
    QApplication::setDoubleClickInterval(10000);
    for (int i = 0; i < 2; ++i)
        QTest::keyClick(shell.find<QLineEdit>("comment_text"), Qt::Key_Return);
    QVERIFY(shell.click("comment_add"));
    QApplication::setDoubleClickInterval(0);
    for (const char* name : {"comment_text", "comment_add"}) {
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, "\r", true);
        QCoreApplication::sendEvent(shell.find<QWidget>(name), &held);
    }
    QApplication::setDoubleClickInterval(interval);
    const auto comments = shell.owner().reviews().comments(id);
    QCOMPARE(comments.size(), size_t{1});
    QVERIFY2(std::abs(comments[0].time_s - clock()) < 1.1, "remarked at the moment shown");
    QCOMPARE(ledger()->picture().marks.size(), size_t{1});
    shell.keep(shell.window().grab(), "47_watch_remark");
    // The field comes with the recording, after the page: what was typed waits for it.
    QVERIFY(shell.type("comment_text", "Half a remark"));
    shell.context().setTheme(ThemeKind::kDark);
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.window().page()->findChild<QLineEdit*>("comment_text") != nullptr; },
        30000));
    QCOMPARE(shell.find<QLineEdit>("comment_text")->text(), QString("Half a remark"));
    shell.context().setTheme(ThemeKind::kLight);
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    shell.window().open({PageId::kResult, id, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(picturesAreThere());
    QCOMPARE(shell.text("comment_1"), QString("Keep the tip moving here."));
    QVERIFY(shell.find<QPushButton>("comment_remove_1") == nullptr);
    QCOMPARE(ledger()->picture().marks.size(), size_t{1});
    shell.scrollTo("comments");
    shell.shot("48_result_remark");
}

void ShellReviewTest::remarkIsRemovedAndPutBack() {
    ShellHarness& shell = *shell_;
    const int64_t id = attempts().front().id;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    shell.window().open({PageId::kResult, id, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(shell.click("comment_remove_1"));
    QVERIFY(shell.owner().reviews().comments(id).empty());
    QVERIFY(shell.click("undo_remove"));
    QCOMPARE(shell.owner().reviews().comments(id).size(), size_t{1});
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellReviewTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_review_test.moc"
