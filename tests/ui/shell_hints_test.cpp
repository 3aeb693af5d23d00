// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a new user asks the pages: why is this empty, why is this locked, who may sign in here, is
// the attempt still running, how long may it last.

#include <QProgressBar>

#include "assessment/learning_curve.h"
#include "assessment/scoring.h"
#include "curriculum/study.h"
#include "db/demonstration.h"
#include "db/recording_file.h"
#include "db/void_reason.h"
#include "shell_harness.h"
#include "tests/exam_course.h"
#include "ui/shell/study_parts.h"

namespace placode::ui {

class ShellHintsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void aLockedStageSaysWhatOpensIt();
    void whyAnAttemptDoesNotCountIsTheSameEverywhere();
    void idleAttemptsLeaveASentenceInsteadOfAnEmptyChart();
    void anAttemptThatDoesNotCountHasNoScore();
    void lossesOfMoreThanTheWholeScoreSayWhereItEnds();
    void todayNamesNewRemarksUntilTheyAreRead();
    void theHistoryOpensOnTheTaskBeforeTheEyes();
    void afterTheEndThePageSaysThatItScores();
    void switchingTheUserIsNamedAndAsksWhileAnAttemptRuns();
    void aStudySaysTheLimitThatTheWindowShows();
    void whatIsInDoubtIsNotCalledTuned();
    void whatBeganAtAStageSaysSo();
    void whatIsInDoubtIsNamedInTheProgramsLanguage();
    void whatCannotBeReplayedHereSaysSo();
    void equalScoresAreNotCalledScattered();
    void aDemonstrationSaysWhoMaySignIn();

 private:
    int64_t add(const std::string& task, assessment::Verdict verdict, sim::EndReason end,
                const std::string& void_reason = {});

    std::unique_ptr<ShellHarness> shell_;
    int64_t user_ = 0;
};

void ShellHintsTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    db::NewUser user;
    user.login = "nina";
    user.display_name = "Nina Nowak";
    user.password = "quiet river 7";
    user_ = shell_->owner().accounts().create(user);
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
}

int64_t ShellHintsTest::add(const std::string& task, assessment::Verdict verdict,
                            sim::EndReason end, const std::string& void_reason) {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.device = "mouse";
    result.header.started_utc = "2026-03-01T10:00:00Z";
    result.end.reason = end;
    result.end.duration_s = 20;
    result.metrics.values = {{"task_time_s", 20}};
    if (!void_reason.empty())
        result.score.reasons.push_back({"time", "Slower than the target time.", 3, -1, false});
    result.score.verdict = verdict;
    result.score.rubric_id = "ring_incision";
    if (verdict == assessment::Verdict::kNotAttempted)
        result.score.reasons.push_back({std::string(assessment::kNotAttemptedItem),
                                        "Nothing was done: this attempt does not count.", 100, -1,
                                        false});
    if (!void_reason.empty()) {
        sim::Event slow;
        slow.kind = sim::EventKind::kMachineSpeed;
        slow.value = 0.5F;
        result.events.push_back(slow);
    }
    return shell_->owner().attempts().save(user_, result);
}

void ShellHintsTest::aLockedStageSaysWhatOpensIt() {
    shell_->window().open({PageId::kCourse, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCourse));
    const QString locked = shell_->text("standing_touch_targets");
    QVERIFY2(locked.contains("Locked") && locked.contains("Instrument familiarisation") &&
                 locked.contains("70 points, once"),
             qPrintable(locked));
    // An open stage below a locked one says that this is no mistake.
    QVERIFY2(shell_->text("standing_diathermy_ring_small").contains("open to everybody"),
             qPrintable(shell_->text("standing_diathermy_ring_small")));
    QVERIFY(!shell_->text("standing_familiarisation").contains("open to everybody"));
    shell_->whole("34_course_reasons");
    QVERIFY(shell_->fits());
}

void ShellHintsTest::whyAnAttemptDoesNotCountIsTheSameEverywhere() {
    const QString why = "nothing was done; the computer was too slow";
    const int64_t id = add("familiarisation", assessment::Verdict::kNotAttempted,
                           sim::EndReason::kFinished, "slow");
    shell_->window().open({PageId::kResult, id, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QCOMPARE(shell_->text("result_verdict"), "Does not count: " + why);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "familiarisation"}}});
    QVERIFY(shell_->arrives(PageId::kHistory));
    auto* table = shell_->find<QTableWidget>("history_table");
    QCOMPARE(table->item(0, table->columnCount() - 1)->text(), why);
    QCOMPARE(table->item(0, 3)->text(), QString("Does not count"));
    QCOMPARE(table->item(0, 3)->toolTip(), why);
    shell_->window().open({PageId::kCourse, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCourse));
    const QString standing = shell_->text("standing_familiarisation");
    QVERIFY2(standing.contains("tried, does not count: " + why), qPrintable(standing));
    QVERIFY(!standing.contains("not tried yet"));
    shell_->shot("34_course_not_counted");
    // For the educator there are attempts, though none is in any table of the cohort.
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    shell_->window().open({PageId::kAttempts, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kAttempts));
    table = shell_->find<QTableWidget>("attempts_table");
    QCOMPARE(table->item(0, table->columnCount() - 1)->text(), why);
    shell_->window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCohort));
    QCOMPARE(shell_->text("cohort_empty"),
             QString("There are attempts, but none of them counts (nothing was done: 1)."));
    shell_->shot("34_cohort_not_counted");
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
}

void ShellHintsTest::idleAttemptsLeaveASentenceInsteadOfAnEmptyChart() {
    const int64_t idle =
        add("touch_targets", assessment::Verdict::kNotAttempted, sim::EndReason::kFinished);
    add("touch_targets", assessment::Verdict::kNotYet, sim::EndReason::kInterrupted);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "touch_targets"}}});
    QVERIFY(shell_->arrives(PageId::kHistory));
    QVERIFY(shell_->find<QWidget>("history_chart") == nullptr);
    const QString why = shell_->text("history_empty");
    QVERIFY2(why.contains("nothing was done: 1") && why.contains("broken off: 1"), qPrintable(why));
    shell_->shot("35_history_nothing_counts");
    QVERIFY(shell_->click("history_open_task"));
    QVERIFY(shell_->arrives(PageId::kTask));
    shell_->window().open({PageId::kResult, idle, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QVERIFY2(shell_->text("themes_empty").contains("Nothing was done"),
             qPrintable(shell_->text("themes_empty")));
    QCOMPARE(shell_->text("result_verdict"), QString("Does not count: nothing was done"));
    QVERIFY(shell_->find<QLabel>("result_points") == nullptr);
    QVERIFY2(shell_->find<QLabel>("reason_0") == nullptr, "nothing cost any points");
    shell_->whole("36_result_nothing_done");
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    QVERIFY(shell_->text("today_empty").contains("no attempt at this task counts yet"));
    shell_->shot("37_today_nothing_counts");
    // With one that counts the chart is back.
    add("touch_targets", assessment::Verdict::kPassed, sim::EndReason::kFinished);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "touch_targets"}}});
    QVERIFY(QTest::qWaitFor([&] { return shell_->find<QWidget>("history_chart") != nullptr; }));
}

void ShellHintsTest::anAttemptThatDoesNotCountHasNoScore() {
    // Left at once on a slow computer: that it was slow is no excuse.
    const int64_t left =
        add("trace_contour", assessment::Verdict::kNotYet, sim::EndReason::kInterrupted, "slow");
    shell_->window().open({PageId::kResult, left, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QCOMPARE(shell_->text("result_verdict"),
             QString("Does not count: left after 20 s; the computer was too slow"));
    QVERIFY(shell_->find<QLabel>("result_points") == nullptr);
    QVERIFY(!shell_->text("void_for_cause").contains("fault"));
    const int64_t slow =
        add("trace_contour", assessment::Verdict::kNotYet, sim::EndReason::kFinished, "slow");
    shell_->window().open({PageId::kResult, slow, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QCOMPARE(shell_->text("result_verdict"), QString("Does not count: the computer was too slow"));
    QVERIFY(shell_->text("void_for_cause").contains("This was not your fault."));
    QCOMPARE(shell_->text("reasons_heading"), QString("What was noticed (not scored)"));
    for (const QLabel* label : shell_->window().page()->findChildren<QLabel*>())
        QVERIFY2(!label->text().contains("−3"), qPrintable(label->text()));
    shell_->whole("36_result_too_slow");
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    QCOMPARE(shell_->text("today_last_points"), QString("–"));
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    shell_->window().open({PageId::kResult, slow, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    const QString told = shell_->text("void_for_cause");
    QVERIFY2(told.contains("The machine was the cause") && !told.contains("your"),
             qPrintable(told));
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
}

void ShellHintsTest::lossesOfMoreThanTheWholeScoreSayWhereItEnds() {
    const auto sum_said = [this](double second) {
        db::AttemptResult result;
        result.header.task_id = "touch_targets";
        result.header.device = "mouse";
        result.header.started_utc = "2026-03-01T10:00:00Z";
        result.end.duration_s = 20;
        result.score.rubric_id = "touch_targets";
        result.score.points = std::max(0.0, 10 - second);
        result.score.reasons = {{"time", "Slower than the target time.", 90, -1, false},
                                {"force", "Too much force.", second, -1, false}};
        shell_->window().open(
            {PageId::kResult, shell_->owner().attempts().save(user_, result), {}, {}});
        return shell_->arrives(PageId::kResult) ? shell_->text("reasons_sum") : QString("no page");
    };
    QCOMPARE(sum_said(9.5), QString());
    QCOMPARE(sum_said(65.7),
             QString("The losses add up to 155.7 points; a score does not go below 0."));
    // As the points of each reason: 90 and 60 are 150, not 150.0.
    QCOMPARE(sum_said(60),
             QString("The losses add up to 150 points; a score does not go below 0."));
    shell_->whole("36_result_below_zero");
}

void ShellHintsTest::todayNamesNewRemarksUntilTheyAreRead() {
    const int64_t attempt =
        add("touch_targets", assessment::Verdict::kPassed, sim::EndReason::kFinished);
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    QVERIFY(shell_->find<QPushButton>("new_remarks") == nullptr);
    db::CommentRecord remark;
    remark.attempt_id = attempt;
    for (const auto& user : shell_->owner().accounts().list())
        if (user.login == "demo.educator") remark.author_id = user.id;
    remark.text = "Calm and even.";
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    (void)shell_->owner().reviews().add_comment(remark);
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    QCOMPARE(shell_->text("new_remarks_words"), QString("1 new remark from your educator"));
    shell_->shot("37_today_new_remark");
    QVERIFY(shell_->click("new_remarks"));
    QVERIFY(shell_->arrives(PageId::kResult));
    QCOMPARE(shell_->text("comment_1"), QString("Calm and even."));
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    QVERIFY2(shell_->find<QPushButton>("new_remarks") == nullptr, "it was read");
}

void ShellHintsTest::theHistoryOpensOnTheTaskBeforeTheEyes() {
    const int64_t first =
        add("trace_contour", assessment::Verdict::kPassed, sim::EndReason::kFinished);
    add("touch_targets", assessment::Verdict::kPassed, sim::EndReason::kFinished);
    const auto shown = [this] {
        auto* box = shell_->find<QComboBox>("history_task");
        return box != nullptr ? box->currentData().toString() : QString();
    };
    shell_->window().open({PageId::kResult, first, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QVERIFY(shell_->click("rail_history"));
    QVERIFY(shell_->arrives(PageId::kHistory));
    QCOMPARE(shown(), QString("trace_contour"));
    // Of a task never tried it opens on the last one done, not on the first one ever.
    shell_->window().open({PageId::kTask, 0, "two_handed_traction", {}});
    QVERIFY(shell_->arrives(PageId::kTask));
    QVERIFY(shell_->click("rail_history"));
    QVERIFY(shell_->arrives(PageId::kHistory));
    QCOMPARE(shown(), QString("touch_targets"));
}

void ShellHintsTest::afterTheEndThePageSaysThatItScores() {
    // As after the process has ended: nothing runs, and the score is being computed.
    QVERIFY(!shell_->context().launcher().running());
    shell_->window().open({PageId::kRunning, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kRunning));
    QCOMPARE(shell_->window().page()->title(), QString("Scoring the attempt"));
    QTRY_VERIFY(shell_->find<QWidget>("scoring")->isVisible());
    QVERIFY(!shell_->find<QPushButton>("abort")->isVisible());
    QVERIFY(!shell_->find<QPushButton>("abort")->isEnabled());
    QVERIFY(!shell_->find<QPushButton>("stop_and_score")->isEnabled());
    QVERIFY(
        QTest::qWaitFor([&] { return shell_->text("scoring_words").contains("so far"); }, 6000));
    shell_->keep(shell_->window().grab(), "38_scoring");
}

void ShellHintsTest::switchingTheUserIsNamedAndAsksWhileAnAttemptRuns() {
    ShellHarness& shell = *shell_;
    auto* change = shell.find<QToolButton>("switch_user");
    QCOMPARE(change->text(), QString("Switch user"));
    QCOMPARE(change->accessibleName(), QString("Switch user"));
    QVERIFY(change->toolTip().contains("Signs you out"));
    shell.window().resize(1366, 768);
    QCOMPARE(change->toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    // A program that does nothing stands for the simulator.
    shell.simulator = shell.path("simulator");
    QFile program(shell.simulator);
    QVERIFY(program.open(QIODevice::WriteOnly));
    program.write("#!/bin/sh\nexec sleep 60\n");
    program.close();
    program.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner |
                           QFileDevice::ExeOwner);
    shell.start();
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    AttemptOrder order;
    order.task = "touch_targets";
    order.device = "mouse";
    order.user_id = user_;
    shell.context().launcher().start(order, shell.path("recordings"));
    QVERIFY(shell.context().launcher().running());
    shell.refuseNext();
    QVERIFY(shell.click("switch_user"));
    QVERIFY2(shell.context().signedIn(), "who does not want to stays");
    shell.window().open({PageId::kRunning, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kRunning));
    QCOMPARE(shell.window().page()->title(), QString("Attempt is running"));
    QVERIFY(shell.find<QPushButton>("abort")->isEnabled());
    shell.confirmNext();
    QVERIFY(shell.click("switch_user"));
    QVERIFY(!shell.context().signedIn());
    shell.context().launcher().abort();
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().launcher().running(); }, 10000));
    // Nothing runs: nothing is asked.
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    QVERIFY(shell.click("switch_user"));
    QVERIFY(!shell.context().signedIn());
}

void ShellHintsTest::aStudySaysTheLimitThatTheWindowShows() {
    const auto study = curriculum::load_study("face_content_validity");
    const auto* procedure = study.step("procedure_1");
    QVERIFY(procedure != nullptr && !procedure->time_limit_s);
    QCOMPARE(step_limit_s(*procedure), 600.0);  // The task's own, shown as "of 10:00".
    curriculum::StudyStep shorter = *procedure;
    shorter.time_limit_s = 90;
    QCOMPARE(step_limit_s(shorter), 90.0);
    shorter.task = "familiarisation";
    shorter.time_limit_s.reset();
    QCOMPARE(step_limit_s(shorter), 0.0);
}

void ShellHintsTest::aDemonstrationSaysWhoMaySignIn() {
    ShellHarness& shell = *shell_;
    // A store of real people says nothing, whatever demonstration accounts it has.
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QWidget>("demonstration_accounts") == nullptr);
    {
        const auto store = db::open_store("sqlite:" + shell.path("demo.db").toStdString());
        for (const auto& [login, role] : {std::pair{"demo-anna", db::Role::kTrainee},
                                          std::pair{"demo-admin", db::Role::kAdministrator}}) {
            db::NewUser user;
            user.login = login;
            user.display_name = std::string(login) + " Demo";
            user.password = db::kDemonstrationPassword;
            user.roles = static_cast<db::Roles>(role);
            user.demonstration = true;
            (void)store->accounts().create(user);
        }
    }
    shell.start("demo.db");
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.find<QWidget>("demonstration_accounts") != nullptr);
    QVERIFY(shell.find<QPushButton>("demonstration_demo-admin") != nullptr);
    shell.shot("39_login_demonstration");
    QVERIFY(shell.fits());
    QVERIFY(shell.click("demonstration_demo-anna"));
    QVERIFY(shell.click("sign_in"));
    QCOMPARE(shell.context().user().login, std::string("demo-anna"));
}

/// Of an exercise, at that time.
static db::AttemptResult passed_attempt(const char* started_utc) {
    db::AttemptResult result;
    result.header.task_id = "grasp_and_lift";
    result.header.device = "mouse";
    result.header.started_utc = started_utc;
    result.end.reason = sim::EndReason::kFinished;
    result.end.duration_s = 20;
    result.score.verdict = assessment::Verdict::kPassed;
    return result;
}

void ShellHintsTest::whatIsInDoubtIsNotCalledTuned() {
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    db::AttemptResult result = passed_attempt("2026-03-01T10:00:00Z");
    result.not_verified = {{db::VoidCause::kTaskDiffers, 0, 0, db::Said::as_is("it version 1")}};
    const int64_t doubted = shell_->owner().attempts().save(user_, result);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "grasp_and_lift"}}});
    QVERIFY(shell_->arrives(PageId::kHistory));
    const QString why = shell_->text("history_empty");
    QVERIFY2(why.contains("practice, not verified: 1") && !why.contains("tun"), qPrintable(why));
    shell_->window().open({PageId::kResult, doubted, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    QCOMPARE(shell_->text("result_verdict"), QString("Does not count: practice, not verified"));
    shell_->whole("36_result_not_verified");
    shell_->context().signOut();
}

void ShellHintsTest::whatBeganAtAStageSaysSo() {
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    db::AttemptResult result = passed_attempt("2026-03-01T10:00:00Z");
    result.header.task_id = "suture_run";
    result.header.stage = 1;
    result.header.given_frames = 100;
    result.score.verdict = assessment::Verdict::kNotYet;
    result.score.reasons.push_back(
        {std::string(assessment::kGivenItem), "Not scored.", 0, -1, false});
    const int64_t given = shell_->owner().attempts().save(user_, result);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "suture_run"}}});
    QVERIFY(shell_->arrives(PageId::kHistory));
    const auto* table = shell_->find<QTableWidget>("history_table");
    QCOMPARE(table->item(0, table->columnCount() - 1)->text(), QString("begun at stage 1"));
    const QString why = shell_->text("history_empty");
    QVERIFY2(why.contains("begun at a stage: 1") && !why.contains("tun"), qPrintable(why));
    const auto says = [&](const char* code, const QString& verdict, const QString& fact) {
        shell_->context().setLanguage(code);
        shell_->window().open({PageId::kResult, given, {}, {}});
        QVERIFY(shell_->arrives(PageId::kResult));
        QCOMPARE(shell_->text("result_verdict"), verdict);
        QVERIFY(shell_->find<QLabel>("result_points") == nullptr);
        QVERIFY2(shell_->find<QLabel>("reasons_heading") == nullptr, "the head says all of it");
        bool said = false;
        for (const auto* label : shell_->window().page()->findChildren<QLabel*>())
            said = said || label->text().contains(fact);
        QVERIFY2(said, qPrintable(fact));
        QVERIFY(QTest::qWaitFor([&] { return shell_->fits(); }, 5000));
    };
    says("en", "Does not count: begun at stage 1", "from bite 2");
    says("pl", QString::fromUtf8("Nie liczy się: rozpoczęta od etapu 1"),
         QString::fromUtf8("od: ścieg 2"));
    shell_->context().setLanguage("en");
    shell_->context().signOut();
}

void ShellHintsTest::whatIsInDoubtIsNamedInTheProgramsLanguage() {
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    db::AttemptResult result = passed_attempt("2026-03-02T10:00:00Z");
    result.not_verified = {
        {db::VoidCause::kUnsound, 0, 0,
         db::Said::that("sample %1 has a tip that lies nowhere").with(12)},
        {db::VoidCause::kReplayDiffers, 0, 0,
         db::Said::that("%1 at %2 s").with(db::Said::that("the field")).with("0.000")}};
    const int64_t doubted = shell_->owner().attempts().save(user_, result);
    const auto says = [&](const char* code, const char* picture, const QStringList& words) {
        shell_->context().setLanguage(code);
        shell_->window().open({PageId::kResult, doubted, {}, {}});
        QVERIFY(shell_->arrives(PageId::kResult));
        const QString why = shell_->text("void_for_cause");
        for (const QString& each : words) QVERIFY2(why.contains(each), qPrintable(why));
        shell_->whole(picture);
        QVERIFY(shell_->fits());
    };
    says("en", "36_result_in_doubt",
         {"it cannot be scored (sample 12 has a tip that lies nowhere)",
          "simulated again it differs (the field at 0.000 s)"});
    says("pl", "36_result_in_doubt_pl",
         {QString::fromUtf8("nie można go ocenić (próbka 12 ma końcówkę, która nie leży nigdzie)"),
          QString::fromUtf8(
              "ponowna symulacja dała inny wynik (pole operacyjne w chwili 0.000 s)")});
    shell_->context().setLanguage("en");
    shell_->context().signOut();
}

void ShellHintsTest::whatCannotBeReplayedHereSaysSo() {
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    db::AttemptResult result;
    result.header.task_id = "touch_targets";
    result.header.device = "mouse";
    result.header.build = "placode 0.0 of another kind";
    result.header.started_utc = "2026-03-02T10:00:00Z";
    result.end.reason = sim::EndReason::kFinished;
    result.end.duration_s = 0.001;
    result.score.verdict = assessment::Verdict::kPassed;
    shell_->owner().accounts().create(
        {"eva", "Eva", "quiet river 8", static_cast<db::Roles>(db::Role::kEducator), false});
    test::publish_exam(shell_->owner(), "touch_targets", "0");
    test::assign_exam(shell_->owner(), user_);
    result.exam = {"short", 1, "final", "Eva", ""};
    result.recording_file = shell_->path("another.placode").toStdString();
    const auto sink = db::create_recording_file(result.recording_file);
    sink->begin(result.header);
    const sim::Input input;
    sink->append({&input, 1}, {}, {});
    sink->finish(result.end);
    const int64_t id = shell_->owner().attempts().save(user_, result);
    QCOMPARE(shell_->owner().attempts().detail(id).record.replay, db::ReplayState::kWaiting);
    shell_->window().open({PageId::kResult, id, {}, {}});
    QVERIFY(shell_->arrives(PageId::kResult));
    const QString why = shell_->text("void_for_cause");
    QVERIFY2(why.contains("another version of Placode"), qPrintable(why));
    QVERIFY2(why.contains("It waits for \"placode 0.0 of another kind\"; this is \"placode "),
             qPrintable(why));
    QVERIFY(shell_->window().findChild<QWidget*>("replay_progress") == nullptr);
    shell_->whole("36_result_of_another_build");
    shell_->context().signOut();
}

void ShellHintsTest::equalScoresAreNotCalledScattered() {
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    for (size_t i = 0; i < assessment::kCurveFrom; ++i)
        add("trace_contour", assessment::Verdict::kPassed, sim::EndReason::kFinished);
    shell_->window().open({PageId::kHistory, 0, {}, {{"task", "trace_contour"}}});
    QVERIFY(shell_->arrives(PageId::kHistory));
    QCOMPARE(shell_->text("learning_words"),
             QString("All scores are equal: there is no curve to fit."));
    shell_->context().signOut();
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellHintsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_hints_test.moc"
