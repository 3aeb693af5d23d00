// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's protocol through the real windows: a coordinator publishes the study, a participant
// is led from consent to the last question, with an interruption in the middle.

#include <QApplication>
#include <QCheckBox>
#include <QFileInfo>
#include <QListWidget>
#include <QMessageBox>
#include <QMouseEvent>
#include <QRadioButton>
#include <QSlider>

#include "all_threads_taken.h"
#include "curriculum/questionnaire.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "export_columns.h"
#include "shell_harness.h"
#include "short_study.h"

namespace placode::ui {

namespace {
/// A busy machine takes long to build and settle a field.
constexpr int kPatienceMs = 240000;
constexpr const char* kStudy = "face_content_validity";
constexpr const char* kTask = "diathermy_ring_small";
}  // namespace

class ShellStudyTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void studyIsPublishedOnce();
    void consentNeedsEveryStatement();
    void questionsBriefingAndPractice();
    void anAttemptThatEndsTooEarlyIsToBeDoneAgain();
    void interruptionCostsNothing();
    void proceduresAreStepsOfTheParticipant();
    void lastQuestionnaireEndsTheRun();
    void whatAParticipantDidIsNobodyElses();
    void aProcedureCountsWhereTheExportsCountIt();
    void aProcedureIsDoneAgainForAReason();
    void coordinatorSeesWhereEveryoneStands();
    void reportAndExportComeOut();
    void whatIsCancelledWritesNothing();
    void whatLeavesIsInTheTrailWhereverItsOwnerGoes();

 private:
    /// Answers whatever the questionnaire on the screen asks for, and submits.
    void answerAll(const std::string& questionnaire);
    /// The main button of the step has the focus, and Enter presses it.
    void enterGoesOn(const QString& name);
    /// Every text of a table is to be read as it stands there.
    [[nodiscard]] static bool nothingIsCut(const QTableWidget* table);
    /// Starts the attempt of the step that is shown and ends it after that time [s].
    void noKeyBegins(const QString& name);
    /// The form of consent half filled: another theme, another language, back to the study.
    void consentIsNotLostWithoutAQuestion();
    /// Draws on the field for the signature.
    void sign();
    [[nodiscard]] QString tickedStatements();
    void perform(double time_s = 0.5);
    /// Presses it and is on another page before the work has ended; false when it does not end.
    [[nodiscard]] bool pressAndLeave(const QString& name);
    /// Opens the shell anew and lets the coordinator go on with the only participant.
    void resume();
    /// An attempt in a shell opened anew, whose simulator ends before any instrument is at the
    /// tissue.
    void performNothing();
    /// Clicks as soon as the button is there: a step that was recorded leads on a moment later.
    [[nodiscard]] bool press(const QString& name) {
        return QTest::qWaitFor(
                   [&] {
                       auto* button = shell_->find<QAbstractButton>(name);
                       return button != nullptr && button->isEnabled();
                   },
                   10000) &&
               shell_->click(name);
    }
    [[nodiscard]] db::Progress progress() {
        const auto all = db::study_progress(shell_->owner(), kStudy);
        return all.empty() ? db::Progress{} : all.front();
    }

    std::unique_ptr<ShellHarness> shell_;
    bool running_shown_ = false;
    QString code_;
};

void ShellStudyTest::initTestCase() {
    QVERIFY2(QFileInfo(PLACODE_BIN_DIR "/placode-sim").isExecutable(),
             "build placode-sim first: this test starts the real simulator");
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    QVERIFY(shell_->arrives(PageId::kStudies));
}

void ShellStudyTest::studyIsPublishedOnce() {
    ShellHarness& shell = *shell_;
    shell.shot("60_study_unpublished");
    QVERIFY(shell.click("check_consent"));
    QVERIFY(shell.arrives(PageId::kProtocols));
    QCOMPARE(shell.find<QListWidget>("elements")->currentItem()->text(),
             QString("Information and consent"));
    shell.window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(shell.find<QPushButton>("enrol") == nullptr);
    // The shipped consent text calls itself a draft: one click must not make it final.
    QString asked;
    QTimer::singleShot(100, &shell.window(), [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked = box->text();
            shell.keep(box->grab(), "60_draft_question");
            QTest::mouseClick(box->findChild<QPushButton*>("confirm_no"), Qt::LeftButton);
        }
    });
    QVERIFY(shell.click("publish_study"));
    QVERIFY2(asked.contains("DRAFT: your institution"), qPrintable(asked));
    QVERIFY(!db::published_study(shell.owner(), kStudy).has_value());
    shell.confirmNext();
    QVERIFY(shell.click("publish_study"));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QPushButton>("enrol") != nullptr; }, 10000));
    QVERIFY(db::published_study(shell.owner(), kStudy).has_value());
    QVERIFY(shell.find<QPushButton>("publish_study") == nullptr);
    QCOMPARE(db::published_study(shell.owner(), kStudy)->step("procedure_1")->min_s, 60.0);
    // Long enough that a busy machine ends the early attempt before it. On the small field: every
    // attempt is computed twice.
    publish_short_study(shell.owner(), kStudy, {{"procedure_1", 20}}, kTask);
    shell.window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellStudyTest::consentNeedsEveryStatement() {
    ShellHarness& shell = *shell_;
    // The coordinator chooses the device, before the screen is handed over.
    QVERIFY(shell.choose("study_device", "script:novice"));
    shell.confirmNext();
    QVERIFY(press("enrol"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
    code_ = QString::fromStdString(progress().participant.code);
    QVERIFY(!code_.isEmpty());
    // A participant is at the screen: no rail.
    QVERIFY(!shell.find<QToolButton>("rail_studies")->isVisible());
    auto* agree = shell.find<QPushButton>("consent_given");
    QVERIFY(agree != nullptr && !agree->isEnabled());
    const QString missing = shell.text("consent_missing");
    QVERIFY2(missing.contains("statements to agree to: ") && missing.contains("signature"),
             qPrintable(missing));
    // Room for two lines and no more, else half a screen of nothing hides the way out.
    auto* words = shell.find<QLabel>("consent_missing");
    QTRY_VERIFY2(words->height() <= 3 * words->fontMetrics().height(),
                 qPrintable(QString::number(words->height())));
    QVERIFY2(shell.text("consent_language").contains("clears the ticks"), "said before it is done");
    shell.shot("61_consent");
    consentIsNotLostWithoutAQuestion();
    if (QTest::currentTestFailed()) return;
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kStudyRun));
    shell.whole("62_consent_polish");
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kStudyRun));
    const auto protocol = curriculum::load_study(kStudy);
    for (const auto& statement : protocol.consent.statements) {
        QVERIFY(!shell.find<QPushButton>("consent_given")->isEnabled());
        auto* box = shell.find<QCheckBox>("consent_" + QString::fromStdString(statement.id));
        QVERIFY(box != nullptr);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);  // by keyboard alone
    }
    auto* given = shell.find<QPushButton>("consent_given");
    QVERIFY2(!given->isEnabled(), "the signature is missing");
    QVERIFY(!shell.text("consent_missing").contains("statements"));
    QVERIFY(shell.text("consent_missing").contains("the signature"));
    shell.keep(shell.window().grab(), "62_consent_missing");
    auto* paper = shell.find<QCheckBox>("signed_on_paper");
    paper->setFocus();
    QTest::qWait(100);  // the page scrolls to it
    const int place = given->mapToGlobal(QPoint(0, 0)).y();
    QTest::keyClick(paper, Qt::Key_Space);
    QVERIFY(given->isEnabled());
    QTest::qWait(100);
    QVERIFY2(given->mapToGlobal(QPoint(0, 0)).y() == place, "not while somebody reaches for it");
    given->setFocus();
    QTest::keyClick(given, Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return progress().next == "demographics"; }, 10000));
}

void ShellStudyTest::sign() {
    auto* pad = shell_->find<QWidget>("signature");
    QVERIFY(pad != nullptr);
    QTest::mousePress(pad, Qt::LeftButton, {}, QPoint(20, 70));
    for (int i = 1; i <= 8; ++i) {
        const QPointF at(20 + 18 * i, 70 - (i % 3) * 20);
        QMouseEvent move(QEvent::MouseMove, at, pad->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         {});
        QApplication::sendEvent(pad, &move);
    }
    QTest::mouseRelease(pad, Qt::LeftButton, {}, QPoint(164, 50));
}

/// Ids of the boxes that are ticked, in their order.
QString ShellStudyTest::tickedStatements() {
    QStringList ticked;
    for (const auto& statement : curriculum::load_study(kStudy).consent.statements) {
        const auto* box =
            shell_->find<QCheckBox>("consent_" + QString::fromStdString(statement.id));
        if (box != nullptr && box->isChecked()) ticked << QString::fromStdString(statement.id);
    }
    return ticked.join(' ');
}

void ShellStudyTest::consentIsNotLostWithoutAQuestion() {
    ShellHarness& shell = *shell_;
    const auto statements = curriculum::load_study(kStudy).consent.statements;
    QVERIFY(statements.size() > 1);
    for (size_t i = 1; i < statements.size(); ++i)
        QVERIFY(shell.click("consent_" + QString::fromStdString(statements[i].id)));
    sign();
    if (QTest::currentTestFailed()) return;
    const QString ticked = tickedStatements();
    QVERIFY(!ticked.isEmpty());
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        shell.context().setTheme(theme);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(shell.arrives(PageId::kStudyRun));
        QCOMPARE(tickedStatements(), ticked);
        QVERIFY2(!shell.text("consent_missing").contains("signature"), "it is there still");
    }
    // Whoever says no to the question keeps language and form.
    shell.refuseNext();
    QVERIFY(shell.click("language"));
    QCOMPARE(shell.context().language(), QString("en"));
    QCOMPARE(tickedStatements(), ticked);
    shell.refuseNext();
    QVERIFY(shell.click("interrupt_run"));
    QTest::qWait(100);
    QCOMPARE(shell.window().current(), PageId::kStudyRun);
    QCOMPARE(tickedStatements(), ticked);
    // Consent is given in the language that it was read in.
    shell.confirmNext();
    QVERIFY(shell.click("language"));
    QCOMPARE(shell.context().language(), QString("pl"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
    QCOMPARE(tickedStatements(), QString());
    QVERIFY(shell.click("language"));  // Nothing is ticked: no question.
    QCOMPARE(shell.context().language(), QString("en"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
}

void ShellStudyTest::answerAll(const std::string& questionnaire) {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.arrives(PageId::kParticipant));
    // A page that has just been made is not on the screen yet.
    const QWidget* page = shell.window().page();
    const auto asked = curriculum::load_questionnaire(questionnaire);
    for (const auto& item : asked.items) {
        const QString name = "answer_" + QString::fromStdString(item.id);
        using curriculum::ItemKind;
        if (item.kind == ItemKind::kLikert) {
            auto* radio = shell.find<QRadioButton>(name + QString("_%1").arg(item.scale_max - 1));
            if (radio != nullptr && radio->isVisibleTo(page)) radio->click();
        } else if (item.kind == ItemKind::kChoice) {
            auto* box = shell.find<QComboBox>(name);
            if (box != nullptr && box->isVisibleTo(page)) box->setCurrentIndex(1);
        } else if (item.kind == ItemKind::kMultiple) {
            auto* box = shell.find<QCheckBox>(name + "_0");
            if (box != nullptr && box->isVisibleTo(page)) box->click();
        } else if (item.kind == ItemKind::kNumber) {
            auto* line = shell.find<QLineEdit>(name);
            if (line != nullptr && line->isVisibleTo(page))
                QVERIFY(shell.type(name, QString::number(item.number_min + 30)));
        }
    }
    QVERIFY(shell.click("review"));
    QVERIFY2(shell.find<QPushButton>("submit_answers") != nullptr,
             qPrintable(shell.text("participant_message")));
    // By keys, as at a station without a mouse: the next page goes on from there.
    enterGoesOn("submit_answers");
    if (QTest::currentTestFailed()) return;
    QVERIFY(shell.arrives(PageId::kStudyRun));
}

void ShellStudyTest::questionsBriefingAndPractice() {
    ShellHarness& shell = *shell_;
    QVERIFY(press("step_questionnaire"));
    answerAll("demographics");
    if (QTest::currentTestFailed()) return;
    QCOMPARE(progress().next, std::string("briefing"));
    shell.shot("63_briefing");
    enterGoesOn("step_done");
    if (QTest::currentTestFailed()) return;
    QVERIFY(QTest::qWaitFor([&] { return progress().next == "familiarisation"; }, 5000));
    QVERIFY(QTest::qWaitFor([&] { return !shell.text("run_device").isEmpty(); }, 5000));
    QVERIFY2(shell.text("run_device").contains("Novice", Qt::CaseInsensitive),
             qPrintable(shell.text("run_device")));
    QVERIFY2(!shell.text("run_goal").isEmpty(), "what is to be done");
    shell.shot("64_familiarisation");
    perform();
    if (QTest::currentTestFailed()) return;
    QCOMPARE(progress().next, std::string("procedure_1"));
}

void ShellStudyTest::enterGoesOn(const QString& name) {
    ShellHarness& shell = *shell_;
    QVERIFY(QTest::qWaitFor([&] {
        QWidget* button = shell.find<QPushButton>(name);
        return button != nullptr && shell.window().focusWidget() == button;
    }));
    QTest::keyClick(shell.window().focusWidget(), Qt::Key_Return);
}

bool ShellStudyTest::nothingIsCut(const QTableWidget* table) {
    if (table->horizontalScrollBar()->maximum() > 0) return false;
    for (int row = 0; row < table->rowCount(); ++row)
        for (int c = 0; c < table->columnCount(); ++c) {
            if (table->isColumnHidden(c)) continue;
            // 9 px on both sides are the style sheet's, the rest Qt's own.
            const QRect words =
                table->fontMetrics().boundingRect(QRect(0, 0, table->columnWidth(c) - 24, 10000),
                                                  Qt::TextWordWrap, table->item(row, c)->text());
            if (words.height() > table->rowHeight(row) || words.width() > table->columnWidth(c)) {
                qWarning("%s", qPrintable(table->item(row, c)->text()));
                return false;
            }
        }
    return true;
}

/// The Enter that ended the attempt before may still be held, or pressed once more.
void ShellStudyTest::noKeyBegins(const QString& name) {
    ShellHarness& shell = *shell_;
    QTest::qWait(50);
    QWidget* button = shell.find<QPushButton>(name);
    QVERIFY(button != nullptr);
    QWidget* focus = shell.window().focusWidget();
    QVERIFY(focus != button);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
        if (focus != nullptr) QTest::keyClick(focus, key);
        QTest::keyClick(&shell.window(), key);
    }
    QTest::qWait(50);
    QVERIFY(!shell.context().launcher().running());
    QCOMPARE(shell.window().current(), PageId::kStudyRun);
}

void ShellStudyTest::perform(double time_s) {
    ShellHarness& shell = *shell_;
    QVERIFY2(shell.find<QComboBox>("device") == nullptr, "a participant chooses no device");
    noKeyBegins("start_attempt");
    QVERIFY(press("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(!shell.find<QToolButton>("rail_studies")->isVisible());
    QVERIFY(QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > time_s; },
                            kPatienceMs));
    // Time only; nothing that says how well it goes.
    const QWidget* page = shell.window().page();
    QVERIFY(shell.find<QLabel>("live_time")->isVisibleTo(page));
    for (const char* hidden : {"live_phase", "live_pictures", "live_ring"})
        QVERIFY2(!shell.find<QLabel>(hidden)->isVisibleTo(page), hidden);
    if (!running_shown_) {
        running_shown_ = true;
        shell.keep(shell.window().grab(), "64_study_running");
    }
    // One press does not end it.
    shell.refuseNext();
    QVERIFY(shell.click("stop_and_score"));
    QVERIFY(shell.context().launcher().running());
    shell.confirmNext();
    QVERIFY(shell.click("stop_and_score"));
    // Led on, without a score.
    QVERIFY(shell.arrives(PageId::kStudyRun, 60));
}

void ShellStudyTest::anAttemptThatEndsTooEarlyIsToBeDoneAgain() {
    ShellHarness& shell = *shell_;
    perform(0.5);
    if (QTest::currentTestFailed()) return;
    QCOMPARE(progress().next, std::string("procedure_1"));
    QVERIFY2(progress().open_because.starts_with("ended after"), progress().open_because.c_str());
    QVERIFY2(shell.text("open_because").contains("does not count"),
             qPrintable(shell.text("open_because")));
    shell.shot("64_to_be_done_again");
    const auto steps = shell.owner().studies().steps(kStudy);
    QVERIFY(steps.back().state == db::StepState::kStarted);
    QVERIFY(steps.back().attempt_id > 0);
}

void ShellStudyTest::resume() {
    ShellHarness& shell = *shell_;
    shell.start();
    QVERIFY(shell.signIn("demo.coordinator", "placode-demo"));
    shell.window().open({PageId::kStudies, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QCOMPARE(shell.find<QTableWidget>("progress_table")->rowCount(), 1);
    QVERIFY(press("continue_participant"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
}

void ShellStudyTest::performNothing() {
    // However late a busy machine would press the button: no instrument is there that early.
    shell_->more_arguments = QStringList{"--duration", "0.5"};
    resume();
    if (QTest::currentTestFailed()) return;
    const std::string before = progress().next;
    QVERIFY(press("start_attempt"));
    QVERIFY(QTest::qWaitFor([&] { return progress().next != before; }, kPatienceMs));
    QVERIFY(shell_->arrives(PageId::kStudyRun, 60));
    shell_->more_arguments.clear();
    resume();
}

void ShellStudyTest::interruptionCostsNothing() {
    resume();  // The station was switched off in the middle of the run.
    if (QTest::currentTestFailed()) return;
    QCOMPARE(progress().next, std::string("procedure_1"));
    shell_->shot("65_resumed");
}

void ShellStudyTest::proceduresAreStepsOfTheParticipant() {
    for (const double time_s : {20.5, 0.5}) {
        perform(time_s);
        if (QTest::currentTestFailed()) return;
    }
    performNothing();
    if (QTest::currentTestFailed()) return;
    QCOMPARE(progress().next, std::string("face_validity"));
    int procedures = 0;
    db::Store& store = shell_->owner();
    for (const auto& step : store.studies().steps(kStudy)) {
        if (step.attempt_id == 0) continue;
        if (step.state == db::StepState::kStarted) continue;  // It ended too early.
        ++procedures;
        QCOMPARE(step.state, db::StepState::kDone);
        QCOMPARE(QString::fromStdString(step.participant), code_);
        QCOMPARE(store.attempts().detail(step.attempt_id).record.task_id, std::string(kTask));
    }
    QCOMPARE(procedures, 4);  // familiarisation and three procedures
}

void ShellStudyTest::lastQuestionnaireEndsTheRun() {
    ShellHarness& shell = *shell_;
    QVERIFY(press("step_questionnaire"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    shell.shot("66_face_validity");
    answerAll("face_validity");
    if (QTest::currentTestFailed()) return;
    QVERIFY(progress().next.empty());
    QCOMPARE(progress().done, progress().total);
    QVERIFY(shell.find<QPushButton>("run_finished") != nullptr);
    shell.shot("67_run_finished");
    shell.takeBackNext();
    QVERIFY(press("run_finished"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellStudyTest::whatAParticipantDidIsNobodyElses() {
    db::Store& store = shell_->owner();
    const int64_t coordinator = shell_->idOf("demo.coordinator");
    QVERIFY(store.attempts().list(coordinator).empty());
    for (const auto& standing : store.attempts().standings(0))
        QVERIFY(standing.user_id != coordinator);
    int seen = 0;
    for (const auto& attempt : store.attempts().list(0)) {
        if (attempt.study.study != kStudy) continue;
        ++seen;
        QCOMPARE(attempt.user_id, int64_t{0});
        QCOMPARE(QString::fromStdString(attempt.user_name), code_);
    }
    QCOMPARE(seen, 5);
}

void ShellStudyTest::aProcedureCountsWhereTheExportsCountIt() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.replaysEnd());
    int64_t done = 0;
    for (const db::StepRecord& step : shell.owner().studies().steps(kStudy))
        if (step.step == "procedure_1" && step.state == db::StepState::kDone)
            done = step.attempt_id;
    QVERIFY(done != 0);
    const auto said = [&](db::ReplayState state) {
        shell.owner().attempts().set_replay(done, state);
        shell.window().open({PageId::kStudies, 0, {}, {{"study", kStudy}}});
        if (!shell.arrives(PageId::kStudies)) return QString();
        shell.window().open({PageId::kStudyData, 0, code_, {{"study", kStudy}}});
        if (!shell.arrives(PageId::kStudyData)) return QString();
        const auto* table = shell.find<QTableWidget>("procedures_table");
        return table == nullptr ? QString() : table->item(2, 4)->text();
    };
    QCOMPARE(said(db::ReplayState::kDiffers), QString("does not count: practice, not verified"));
    QCOMPARE(said(db::ReplayState::kWaiting),
             QString("does not count yet: it is still to be simulated again"));
    QCOMPARE(said(db::ReplayState::kIdentical), QString("counts"));
}

void ShellStudyTest::aProcedureIsDoneAgainForAReason() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kStudyData, 0, code_, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyData));
    auto* table = shell.find<QTableWidget>("procedures_table");
    QVERIFY(table != nullptr);
    QCOMPARE(table->rowCount(), 5);
    QVERIFY(table->item(1, 4)->text().startsWith("does not count"));
    auto* deviations = shell.find<QTableWidget>("deviations_table");
    QVERIFY(deviations != nullptr);
    // Kept, and said.
    QVERIFY(table->item(4, 4)->text().contains("nothing was done"));
    shell.window().resize(1280, 800);
    QTest::qWait(80);
    QVERIFY2(nothingIsCut(table) && nothingIsCut(deviations), "at 1280 x 800");
    shell.shot("67_procedures_whole_words");  // In both themes: each makes the page anew.
    shell.window().resize(1366, 768);
    table = shell.find<QTableWidget>("procedures_table");
    deviations = shell.find<QTableWidget>("deviations_table");
    QStringList kinds;
    for (int row = 0; row < deviations->rowCount(); ++row)
        kinds << deviations->item(row, 1)->text();
    QVERIFY(kinds.contains("Nothing was done"));
    QCOMPARE(table->item(2, 4)->text(), QString("counts"));
    QCOMPARE(deviations->item(0, 1)->text(), QString("Ended too early"));
    table->selectRow(2);
    QVERIFY(press("repeat_step"));
    QVERIFY(shell.bannerSays("needs a reason"));
    QVERIFY(shell.type("step_note", "coughed twice"));
    QVERIFY(press("add_note"));
    QVERIFY(
        QTest::qWaitFor([&] { return !shell.owner().records().step_notes(kStudy).empty(); }, 5000));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* now = shell.find<QTableWidget>("deviations_table");
            return now != nullptr && now->rowCount() == kinds.size() + 1;
        },
        5000));
    shell.find<QTableWidget>("procedures_table")->selectRow(2);
    QVERIFY(shell.type("repeat_reason", "the pedal was unplugged"));
    shell.confirmNext();
    QVERIFY(press("repeat_step"));
    QVERIFY(QTest::qWaitFor([&] { return progress().next == "procedure_1"; }, 5000));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* now = shell.find<QTableWidget>("procedures_table");
            return now != nullptr && now->item(2, 4)->text().contains("the pedal was unplugged");
        },
        5000));
    shell.context().setLanguage("pl");  // Its words are longer.
    QVERIFY(shell.fitsInBothSizes("68_study_procedures_pl"));
    shell.context().setLanguage("en");
    shell.window().resize(1366, 768);
    shell.whole("68_study_procedures");
    QVERIFY(shell.fits());
    // The participant does it once more, and it counts instead.
    shell.window().open({PageId::kStudies, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(press("continue_participant"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
    perform(20.5);
    if (QTest::currentTestFailed()) return;
    QVERIFY(progress().next.empty());
    shell.takeBackNext();
    QVERIFY(press("run_finished"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

void ShellStudyTest::coordinatorSeesWhereEveryoneStands() {
    ShellHarness& shell = *shell_;
    // Whoever only lists people keeps the screen; "Continue" hands it over then.
    shell.refuseNext();
    QVERIFY(press("enrol"));
    QVERIFY(shell.bannerSays("is enrolled"));
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(QTest::qWaitFor([&] {
        auto* now = shell.find<QTableWidget>("progress_table");
        return now != nullptr && now->rowCount() == 2 && now->currentRow() == 1;
    }));
    QVERIFY(shell.find<QToolButton>("rail_studies")->isVisible());
    QVERIFY(press("continue_participant"));
    QVERIFY(shell.arrives(PageId::kStudyRun));
    shell.takeBackNext();
    QVERIFY(press("interrupt_run"));
    QVERIFY(shell.arrives(PageId::kStudies));
    auto* table = shell.find<QTableWidget>("progress_table");
    QCOMPARE(table->rowCount(), 2);
    QCOMPARE(table->item(0, 2)->text(), QString("finished"));
    QCOMPARE(table->item(1, 1)->text(), QString("0 of 8"));
    shell.window().resize(1280, 800);
    QTest::qWait(80);
    QVERIFY2(nothingIsCut(table), "at 1280 x 800");
    shell.window().resize(1366, 768);
    QVERIFY(shell.text("flow").contains("Information and consent: 1"));
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell.fits());
    }
    shell.window().resize(1366, 768);
    shell.whole("68_study_overview");
    // The second one withdraws; the code stays.
    table = shell.find<QTableWidget>("progress_table");
    table->selectRow(1);
    QVERIFY(shell.type("withdraw_reason", "not given"));
    shell.confirmNext();
    QVERIFY(press("withdraw"));
    QVERIFY(QTest::qWaitFor(
        [&] {
            auto* now = shell.find<QTableWidget>("progress_table");
            return now != nullptr && now->item(1, 4)->text().contains("Withdrew.");
        },
        10000));
}

void ShellStudyTest::reportAndExportComeOut() {
    ShellHarness& shell = *shell_;
    shell.save_as = shell.path("exported");
    QVERIFY(press("study_export"));
    QVERIFY(shell.bannerSays("read back and compared", 60));
    // In a folder of its own, which the message names and opens.
    QVERIFY(QDir(shell.save_as).entryList(QDir::Files).isEmpty());
    const QString exported = shell.exported();
    QVERIFY2(QDir(exported).dirName().startsWith(QString("placode_%1_20").arg(kStudy)),
             qPrintable(exported));
    QVERIFY(!QDir(exported).entryList({"*.csv"}, QDir::Files).isEmpty());
    QVERIFY(shell.window().banner().text().contains(exported));
    QVERIFY(shell.click("banner_offer"));
    QCOMPARE(shell.shown, exported);
    // Both attempts leave, and the one that counts no more says so; so do the deviations.
    const Rows attempts = table_of(exported + "/" + kStudy + "_attempts.csv");
    int again = 0;
    for (size_t r = 1; r < attempts.size(); ++r) {
        if (cell(attempts, r, "step") != "procedure_1") continue;
        if (cell(attempts, r, "superseded") != "1") continue;
        ++again;
        QCOMPARE(cell(attempts, r, "superseded_reason"), std::string("the pedal was unplugged"));
        QCOMPARE(cell(attempts, r, "counts"), std::string("0"));
    }
    QCOMPARE(again, 1);
    const Rows deviations = table_of(exported + "/" + kStudy + "_deviations.csv");
    QVERIFY(deviations.size() >= 4);  // head, ended too early, done again, note
    shell.save_as = shell.path("study.pdf");
    QVERIFY(press("study_report"));
    QVERIFY(shell.bannerSays("study.pdf", 60));
    QVERIFY(QFileInfo(shell.save_as).size() > 5000);
}

void ShellStudyTest::whatIsCancelledWritesNothing() {
    ShellHarness& shell = *shell_;
    const auto shows = [&](const QString& name) {
        const auto* button = shell.find<QPushButton>(name);
        return button != nullptr && button->isVisible();
    };
    const auto cancels = [&](const QString& name) {
        shell.save_as = shell.path("cancelled");
        {
            // As if it took as long as of a large study.
            AllThreadsTaken taken(shell.context().workers());
            if (!shell.click(name) || shows(name) || !shell.click("cancel_export")) return false;
            if (shell.find<QPushButton>("cancel_export")->isEnabled()) return false;
        }
        return QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000) &&
               shell.bannerSays("nothing was written") && shows(name) && !shows("cancel_export") &&
               !QFileInfo::exists(shell.save_as);
    };
    QVERIFY(cancels("study_export"));
    QVERIFY(cancels("study_report"));
    const Place studies{PageId::kStudies, 0, {}, {{"study", kStudy}}};
    shell.window().open({PageId::kStudyResults, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyResults));
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    QVERIFY(cancels("save_results"));
    shell.window().open(studies);
    QVERIFY(shell.arrives(PageId::kStudies));
}

bool ShellStudyTest::pressAndLeave(const QString& name) {
    ShellHarness& shell = *shell_;
    auto* button = shell.find<QAbstractButton>(name);
    if (button == nullptr || !button->isEnabled()) return false;
    button->click();
    if (!shell.context().busy()) return false;
    shell.window().open({PageId::kAccount, 0, {}, {}});
    // The page is gone before the end of the work can be heard.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000);
}

void ShellStudyTest::whatLeavesIsInTheTrailWhereverItsOwnerGoes() {
    ShellHarness& shell = *shell_;
    db::NewUser eva;
    eva.login = "eva";
    eva.display_name = "Eva Es";
    eva.password = "quiet river 8";
    eva.roles = static_cast<db::Roles>(static_cast<int>(db::Role::kCoordinator) |
                                       static_cast<int>(db::Role::kEducator));
    shell.owner().accounts().create(eva);
    QVERIFY(shell.signIn("eva", "quiet river 8"));
    const auto trail = [&](const char* action) { return shell.owner().audit().of_action(action); };
    const Place studies{PageId::kStudies, 0, {}, {{"study", kStudy}}};
    shell.window().open(studies);
    QVERIFY(shell.arrives(PageId::kStudies));
    shell.save_as = shell.path("with_names");
    QVERIFY(shell.type("identifying_reason", "the ethics board asks"));
    const size_t exports = trail("export.csv").size();
    QVERIFY(pressAndLeave("study_export"));
    QVERIFY(!QDir(shell.exported()).entryList({"*.csv"}, QDir::Files).isEmpty());
    QCOMPARE(trail("export.csv").size(), exports + 1);
    const db::AuditRecord entry = trail("export.csv").back();
    QVERIFY2(
        entry.detail.find("; WITH IDENTIFYING FIELDS: the ethics board asks") != std::string::npos,
        entry.detail.c_str());
    QCOMPARE(entry.object, std::string("study ") + kStudy);
    // The entry is there before the first file: also of an export that comes to nothing.
    shell.window().open(studies);
    QVERIFY(shell.arrives(PageId::kStudies));
    shell.save_as = shell.path("study.pdf");  // no folder
    QVERIFY(pressAndLeave("study_export"));
    QCOMPARE(trail("export.csv").size(), exports + 2);
    const size_t written = trail("report.study").size();
    shell.window().open(studies);
    QVERIFY(shell.arrives(PageId::kStudies));
    shell.save_as = shell.path("left.pdf");
    QVERIFY(pressAndLeave("study_report"));
    QVERIFY(QFileInfo(shell.save_as).size() > 5000);
    QCOMPARE(trail("report.study").size(), written + 1);
    shell.window().open({PageId::kStudyResults, 0, {}, {{"study", kStudy}}});
    QVERIFY(shell.arrives(PageId::kStudyResults));
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 60000));
    shell.save_as = shell.path("figures");
    QVERIFY(pressAndLeave("save_results"));
    QCOMPARE(trail("report.figures").size(), size_t{1});
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellStudyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_study_test.moc"
