// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Result and comparison show what belongs to the task and nothing of others: after places were
// touched nobody reads of cutting, and what was left half-way has no points anywhere.

#include <QPointer>
#include <QProcess>
#include <QThread>
#include <atomic>

#include "assessment/metrics.h"
#include "db/recording_file.h"
#include "shell_harness.h"

namespace placode::ui {

class ShellScopeTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }
    void theResultOfATouchingTaskDoesNotSpeakOfCutting();
    void theResultOfARingStillDoes();
    void theResultOfASlitSaysWhereItLeaks();
    void theComparisonShowsWhatBelongsToTheTask();
    void whatWasLeftHasNoPointsInTheComparison();
    void aComparisonLeftWhileItReadsIsNoTrouble();
    void anotherOneChosenInAClosedAccountLeadsToSignIn();

 private:
    /// Some seconds of the scripted expert. Returns the number of the attempt.
    int64_t attempt(const char* task, sim::EndReason end, double points, const char* started);
    [[nodiscard]] QString names(const char* table) const;

    std::unique_ptr<ShellHarness> shell_;
    int64_t done_ = 0, better_ = 0, left_ = 0, ring_ = 0, slit_ = 0;
    int seed_ = 0;
};

int64_t ShellScopeTest::attempt(const char* task, sim::EndReason end, double points,
                                const char* started) {
    // Each of its own: the same recording a second time proves nothing.
    const QString seed = QString::number(++seed_);
    const QString file = shell_->path(QString("%1_%2.placode").arg(task, seed));
    QProcess simulator;
    simulator.start(PLACODE_BIN_DIR "/placode-sim",
                    {"--task", task, "--seed", seed, "--device", "script:expert", "--headless",
                     "--fast", "--demonstration", "--duration", "12", "--record", file});
    if (!simulator.waitForFinished(300000)) return 0;
    const sim::Recording recording = db::read_recording_file(file.toStdString());
    db::AttemptResult result;
    result.header = recording.header;
    result.header.started_utc = started;
    result.end = recording.end;
    result.end.reason = end;
    result.metrics = assessment::compute_metrics(recording);
    result.score.points = points;
    result.score.verdict =
        points >= 70 ? assessment::Verdict::kPassed : assessment::Verdict::kNotYet;
    result.score.rubric_id = task;
    result.score.reasons = {{"steps", "40 % of the places were touched.", 100, -1, false}};
    result.recording_file = file.toStdString();
    db::Store& store = shell_->owner();
    return store.attempts().save(store.accounts().find_login("demo.trainee")->id, result);
}

QString ShellScopeTest::names(const char* table) const {
    QStringList all;
    const auto* metrics = shell_->find<QTableWidget>(table);
    for (int row = 0; metrics != nullptr && row < metrics->rowCount(); ++row)
        all << metrics->item(row, 0)->text();
    return all.join('\n');
}

void ShellScopeTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    shell_->owner().act_as("ada");
    done_ = attempt("touch_targets", sim::EndReason::kFinished, 62, "2026-03-01T10:00:00Z");
    better_ = attempt("touch_targets", sim::EndReason::kFinished, 84, "2026-03-02T10:00:00Z");
    left_ = attempt("touch_targets", sim::EndReason::kInterrupted, 0, "2026-03-03T10:00:00Z");
    ring_ = attempt("diathermy_ring_small", sim::EndReason::kFinished, 75, "2026-03-04T10:00:00Z");
    slit_ = attempt("suture_slit", sim::EndReason::kFinished, 5, "2026-03-05T10:00:00Z");
    QVERIFY(done_ > 0 && better_ > 0 && left_ > 0 && ring_ > 0 && slit_ > 0);
    QVERIFY(shell_->signIn("demo.trainee", "placode-demo"));
}

void ShellScopeTest::theResultOfATouchingTaskDoesNotSpeakOfCutting() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kResult, done_, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("damage_map") != nullptr; }, 60000));
    QVERIFY(shell.find<QWidget>("incision") == nullptr);
    QVERIFY(shell.find<QWidget>("energy_map") == nullptr);
    auto* asked = shell.find<QWidget>("asked_map");
    QVERIFY(asked != nullptr);
    QVERIFY2(asked->accessibleDescription().contains("of 8"),
             qPrintable(asked->accessibleDescription()));
    const QString all = names("metrics");
    for (const char* cutting : {"Ring completeness", "Largest gap", "Energy delivered", "Snips",
                                "Length off the planned line", "Placode peak temperature"})
        QVERIFY2(!all.contains(cutting), cutting);
    QVERIFY(all.contains("Distance from targets"));
    QVERIFY(shell.click("all_measures"));
    shell.whole("97_result_touch_targets");
}

void ShellScopeTest::theResultOfARingStillDoes() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kResult, ring_, {}, {}});
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("incision") != nullptr; }, 60000));
    QVERIFY(shell.find<QWidget>("energy_map") != nullptr);
    QVERIFY(shell.find<QWidget>("asked_map") == nullptr);
    QVERIFY(shell.find<QWidget>("leak_map") == nullptr);
    QVERIFY(shell.find<QWidget>("leak_words") == nullptr);
    QVERIFY(names("metrics").contains("Ring completeness"));
    // Whose limit it is that was not passed stands with the measure.
    auto* table = shell.find<QTableWidget>("metrics");
    QString limit;
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 0)->text() == "Force above the scene's limit")
            limit = table->item(row, 0)->toolTip();
    QVERIFY2(limit.contains("The limit of this scene: 400 mN."), qPrintable(limit));
}

void ShellScopeTest::theResultOfASlitSaysWhereItLeaks() {
    ShellHarness& shell = *shell_;
    for (const auto& [language, pressure] :
         {std::pair("en", "12.5 cmH2O"), std::pair("pl", "12,5 cmH2O")}) {
        shell.context().setLanguage(language);
        shell.window().open({PageId::kResult, slit_, {}, {}});
        QVERIFY(shell.arrives(PageId::kResult));
        QVERIFY(QTest::qWaitFor([&] { return shell.find<QWidget>("leak_map") != nullptr; }, 60000));
        auto* map = shell.find<QWidget>("leak_map");
        // Who cannot see the picture gets the sentence that stands below it.
        QCOMPARE(map->accessibleDescription(), shell.text("leak_words"));
        QVERIFY2(shell.text("leak_words").contains(pressure), qPrintable(shell.text("leak_words")));
        QCOMPARE(map->accessibleName(),
                 language == std::string("en") ? QString("Where it leaks") : "Gdzie przecieka");
        shell.whole(QString("100_result_suture_slit_%1").arg(language));
        shell.window().open({PageId::kAccount, 0, {}, {}});
        QVERIFY(shell.arrives(PageId::kAccount));
    }
    shell.context().setLanguage("en");
}

void ShellScopeTest::theComparisonShowsWhatBelongsToTheTask() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kCompare, done_, {}, {{"other", QVariant::fromValue(better_)}}});
    QVERIFY(shell.arrives(PageId::kCompare));
    QVERIFY(
        QTest::qWaitFor([&] { return shell.find<QWidget>("compare_pictures") != nullptr; }, 60000));
    const QString all = names("compare_metrics");
    for (const char* cutting : {"Ring completeness", "Largest gap", "Energy", "planned"})
        QVERIFY2(!all.contains(cutting), cutting);
    QVERIFY(all.contains("Path length"));
    QVERIFY(shell.text("compare_points_0").contains("62"));
    QVERIFY(shell.text("compare_points_1").contains("84"));
    shell.whole("98_compare_touch_targets");
}

void ShellScopeTest::whatWasLeftHasNoPointsInTheComparison() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kCompare, done_, {}, {{"other", QVariant::fromValue(left_)}}});
    QVERIFY(shell.arrives(PageId::kCompare));
    QCOMPARE(shell.text("compare_points_1"), QString("–"));
    auto* offered = shell.find<QComboBox>("compare_with");
    QVERIFY2(offered->currentText().contains("does not count") &&
                 !offered->currentText().contains("point"),
             qPrintable(offered->currentText()));
    auto* head = shell.find<QWidget>("compare_head_1");
    for (const QLabel* label : head->findChildren<QLabel*>())
        QVERIFY2(!label->text().contains("100"), qPrintable(label->text()));
    auto* table = shell.find<QTableWidget>("compare_metrics");
    for (int row = 0; row < table->rowCount(); ++row)
        QCOMPARE(table->item(row, 4)->text(), QString("–"));
    shell.whole("99_compare_left");
}

// The folder that the recordings are written to went with the page.
void ShellScopeTest::aComparisonLeftWhileItReadsIsNoTrouble() {
    ShellHarness& shell = *shell_;
    QThreadPool* pool = &shell.context().workers();
    pool->waitForDone();
    const int threads = pool->maxThreadCount();
    pool->setMaxThreadCount(1);
    // Reading begins when the page has gone. No check before `go`: the thread would wait for ever.
    std::atomic<bool> go = false;
    pool->start([&go] {
        while (!go) QThread::msleep(5);
    });
    shell.window().open({PageId::kCompare, done_, {}, {{"other", QVariant::fromValue(better_)}}});
    const bool compared = shell.window().current() == PageId::kCompare && shell.context().busy();
    shell.window().open({PageId::kAccount, 0, {}, {}});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    go = true;
    const bool read = QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000);
    pool->setMaxThreadCount(threads);
    QVERIFY(compared && read);
    QVERIFY(shell.arrives(PageId::kAccount));
    QVERIFY2(!shell.window().banner().isShown(), qPrintable(shell.window().banner().text()));
}

// The last one: nobody opens the account again.
void ShellScopeTest::anotherOneChosenInAClosedAccountLeadsToSignIn() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kCompare, done_, {}, {{"other", QVariant::fromValue(better_)}}});
    QVERIFY(shell.arrives(PageId::kCompare));
    QVERIFY(
        QTest::qWaitFor([&] { return shell.find<QWidget>("compare_pictures") != nullptr; }, 60000));
    // The shell may find out by itself while we wait, and then the page is gone.
    const QPointer<QComboBox> offered = shell.find<QComboBox>("compare_with");
    const int left = offered->findData(QVariant::fromValue<qint64>(left_));
    QVERIFY(left >= 0 && left != offered->currentIndex());
    shell.owner().accounts().set_active(shell.idOf("demo.trainee"), false);
    QTest::qWait(1100);  // The store is asked once a second at most.
    if (offered != nullptr) offered->setCurrentIndex(left);
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY2(shell.text("login_note").contains("Your account was closed"),
             qPrintable(shell.text("login_note")));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication app(argc, argv);
    placode::ui::ShellScopeTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_scope_test.moc"
