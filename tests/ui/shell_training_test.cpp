// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// From the invitation to the certificate, through the real windows: an administrator invites, a
// trainee registers, is told the controls, practises and sits an exam with a scripted operator as
// hands; an educator builds and assigns the course, reviews, remarks and compares.

#include <QCheckBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <csignal>

#include "db/course_conduct.h"
#include "shell_harness.h"

namespace placode::ui {

namespace {
constexpr int kAttemptSeconds =
    240;  ///< Waits for a simulated attempt; 10 s where nothing else runs.
constexpr const char* kFirstTask = "familiarisation";
constexpr const char* kTask = "grasp_and_lift";

/// Past the store, which has no such change: an account is of demonstration from the beginning.
bool becomes_demonstration(const QString& file, int64_t account) {
    bool done = false;
    {
        QSqlDatabase raw = QSqlDatabase::addDatabase("QSQLITE", "demonstration");
        raw.setDatabaseName(file);
        done = raw.open() &&
               QSqlQuery(raw).exec(
                   QString("UPDATE accounts SET demonstration = 1 WHERE id = %1").arg(account));
    }
    QSqlDatabase::removeDatabase("demonstration");
    return done;
}
}  // namespace

class ShellTrainingTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void administratorInvitesAndTakesInAList();
    void traineeRegistersWithTheCode();
    void educatorBuildsAndAssignsTheCourse();
    void traineeIsToldTheControlsAndPractises();
    void examNeedsItsProctor();
    void anExamThatIsLeftUsesUpItsAttempt();
    void theNextExamHasAnotherCase();
    void masteredCourseGivesTheCertificate();
    void educatorReviewsAndRemarks();
    void educatorGrantsMoreAttempts();
    void attemptsAreSeenSideBySide();
    void pinBringsBackToThePageThatWasLocked();
    void ownDataAreSavedAndErasureIsAskedAndDone();
    void theCertificateWaitsForWhoLeftThePage();

 private:
    [[nodiscard]] bool runAttempt() {
        return shell_->click("start_attempt") && shell_->arrives(PageId::kRunning) &&
               shell_->arrives(PageId::kResult, kAttemptSeconds);
    }

    /// The exam's page, with device and proctor filled in.
    [[nodiscard]] bool openExam();

    std::unique_ptr<ShellHarness> shell_;
    QString code_;
};

void ShellTrainingTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    shell_->hands = "script:expert";
    shell_->start();
    QVERIFY(shell_->setUpWithDemonstration());
}

void ShellTrainingTest::administratorInvitesAndTakesInAList() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(shell.click("rail_people"));
    QVERIFY(shell.arrives(PageId::kPeople));
    QVERIFY(shell.click("open_admissions"));
    QVERIFY(shell.arrives(PageId::kAdmissions));
    QVERIFY(shell.type("invite_note", "Nina Nowak"));
    QVERIFY(shell.click("invite"));
    code_ = shell.find<QLineEdit>("invitation_code")->text();
    QVERIFY(code_.size() >= 8);
    QCOMPARE(shell.find<QTableWidget>("invitations_table")->rowCount(), 1);
    shell.open_this = shell.path("people.csv");
    QFile list(shell.open_this);
    QVERIFY(list.open(QIODevice::WriteOnly));
    list.write(
        "login,name,roles,password\nolga,Olga Zet,trainee,long enough here\n"
        "piotr,Piotr Be,trainee;educator,\nolga,Twice,,\n");
    list.close();
    QVERIFY(shell.click("import_people"));
    QVERIFY(shell.bannerSays("people.csv:4"));
    QVERIFY(!shell.owner().accounts().find_login("olga").has_value());  // All or none.
    QVERIFY(list.open(QIODevice::WriteOnly | QIODevice::Truncate));
    list.write(
        "login,name,roles,password\nolga,Olga Zet,trainee,long enough here\n"
        "piotr,Piotr Be,trainee;educator,\n");
    list.close();
    // A page that is opened while something is worked on waits: it may be a list.
    shell.context().background(
        &shell.window(), "Working", [](db::Store&) {}, [](bool) {});
    shell.window().open({PageId::kAdmissions, 0, {}, {}});
    auto* load = shell.find<QPushButton>("import_people");
    QVERIFY(!load->isEnabled());
    QVERIFY(QTest::qWaitFor([&] { return load->isEnabled(); }, 10000));
    // The window goes on while the passwords are hashed, and nobody presses twice.
    shell.save_as = shell.path("passwords.csv");
    load->click();
    QVERIFY(shell.context().busy() && !load->isEnabled());
    QVERIFY(shell.bannerSays("Added people: 2"));
    QVERIFY(load->isEnabled());
    QVERIFY(db::has_role(shell.owner().accounts().find_login("piotr")->roles, db::Role::kEducator));
    QFile passwords(shell.save_as);
    QVERIFY(passwords.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(passwords.readAll()).split('\n');
    QVERIFY(lines[1].startsWith("piotr,"));
    QVERIFY(shell.fitsInBothSizes("70_admissions"));
    QVERIFY(shell.signIn("piotr", lines[1].mid(6).trimmed()));
}

void ShellTrainingTest::traineeRegistersWithTheCode() {
    ShellHarness& shell = *shell_;
    shell.context().signOut();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.click("open_join"));
    QVERIFY(shell.arrives(PageId::kJoin));
    QVERIFY(shell.type("join_code", "wrong-code"));
    QVERIFY(shell.type("join_name", "Nina Nowak"));
    QVERIFY(shell.type("join_login", "nina"));
    QVERIFY(shell.type("join_password", "quiet river 7"));
    QVERIFY(shell.type("join_again", "quiet river 7"));
    QVERIFY(shell.click("join"));
    QVERIFY(shell.bannerSays("refused"));
    QVERIFY(shell.fitsInBothSizes("71_join"));
    QVERIFY(shell.type("join_code", code_));
    QVERIFY(shell.type("join_password", "quiet river 7"));
    QVERIFY(shell.type("join_again", "quiet river 7"));
    QVERIFY(shell.click("join"));
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.bannerSays("Your account is made"));
    // A script operates for her, and passes exams of nobody else.
    QVERIFY(becomes_demonstration(shell.path("placode.db"), shell.idOf("nina")));
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    QVERIFY(shell.arrives(PageId::kToday));
    QVERIFY(shell.find<QPushButton>("open_next") != nullptr);
    shell.whole("72_first_day");
}

void ShellTrainingTest::educatorBuildsAndAssignsTheCourse() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    QVERIFY(shell.click("rail_courses"));
    QVERIFY(shell.arrives(PageId::kCourses));
    QVERIFY(shell.click("new_course"));
    QVERIFY(shell.arrives(PageId::kCourseEditor));
    QVERIFY(shell.type("title_en", "Lift and exam"));
    QVERIFY(shell.type("course_id", "lift_exam"));
    // First the instruments are taught, then a skill is practised, then shown in an exam.
    for (const char* id : {kFirstTask, kTask, kTask}) {
        QVERIFY(shell.click("add_stage"));
        auto* task = shell.find<QComboBox>("stage_task");
        task->setCurrentIndex(task->findData(QString(id)));
        shell.find<QSpinBox>("stage_consecutive")->setValue(1);
    }
    QVERIFY(shell.type("stage_id", "lift_as_exam"));
    auto* mode = shell.find<QComboBox>("stage_mode");
    mode->setCurrentIndex(mode->findData(static_cast<int>(curriculum::StageMode::kExam)));
    QVERIFY(shell.type("stage_seeds", "11, 12"));
    shell.find<QSpinBox>("stage_limit")->setValue(4);
    shell.confirmNext();
    QVERIFY(shell.click("publish_course"));
    QVERIFY(shell.arrives(PageId::kCourses));
    shell.find<QComboBox>("assign_target")->setCurrentText("Nina Nowak (nina)");
    QVERIFY(shell.click("assign_course"));
    QVERIFY(shell.bannerSays("Assigned to Nina Nowak"));
}

void ShellTrainingTest::traineeIsToldTheControlsAndPractises() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    QVERIFY(shell.click("rail_today"));
    QVERIFY(shell.arrives(PageId::kToday));
    QVERIFY(shell.click("open_next"));
    QVERIFY(shell.arrives(PageId::kTask));
    auto* device = shell.find<QComboBox>("device");
    QVERIFY(QTest::qWaitFor([&] { return device->findData("mouse") >= 0; }, 30000));
    device->setCurrentIndex(device->findData("mouse"));
    QVERIFY(shell.text("controls").split('\n').size() > 5);
    QVERIFY(shell.find<QWidget>("exam_card") == nullptr);
    shell.whole("73_controls");
    // The task that teaches the controls asks for each of them; all were done.
    QVERIFY(runAttempt());
    const auto taught = shell.owner().attempts().list(shell.idOf("nina"));
    QCOMPARE(taught.size(), size_t{1});
    QCOMPARE(taught[0].task_id, std::string(kFirstTask));
    QCOMPARE(shell.owner().attempts().detail(taught[0].id).metrics.find("steps_done_percent"),
             std::optional<double>(100));
    QVERIFY(shell.click("rail_today"));
    QVERIFY(shell.arrives(PageId::kToday));
    QVERIFY(shell.click("open_next"));
    QVERIFY(shell.arrives(PageId::kTask));
    device = shell.find<QComboBox>("device");
    QVERIFY(QTest::qWaitFor([&] { return device->findData("mouse") >= 0; }, 30000));
    device->setCurrentIndex(device->findData("mouse"));
    QVERIFY(runAttempt());
    QVERIFY(shell.text("result_points").contains("points"));
    const auto attempts = shell.owner().attempts().list(shell.idOf("nina"));
    QCOMPARE(attempts.size(), size_t{2});
    QCOMPARE(attempts[1].task_id, std::string(kTask));
    QVERIFY(attempts[1].exam.course_id.empty());
    QVERIFY(attempts[1].points >= 70);
    const QString standing = shell.text("course_standing");
    QVERIFY2(standing.startsWith("Mastered in the course: "), qPrintable(standing));
}

void ShellTrainingTest::examNeedsItsProctor() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_course"));
    QVERIFY(shell.arrives(PageId::kCourse));
    shell.whole("74_course");
    QVERIFY(shell.click("open_exam_lift_as_exam"));
    QVERIFY(shell.arrives(PageId::kTask));
    QVERIFY(shell.text("exam_rules").contains("proctor"));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.bannerSays("when a proctor has typed"));
    QVERIFY2(shell.focusIsIn("proctor_login"), "the next key belongs where something is missing");
    QVERIFY(shell.type("proctor_login", "nina"));
    QVERIFY(shell.type("proctor_password", "quiet river 7"));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.bannerSays("Nobody can be their own proctor"));
    QVERIFY(shell.type("proctor_login", "olga"));
    QVERIFY(shell.type("proctor_password", "long enough here"));
    QTest::keyClick(shell.find<QLineEdit>("proctor_password"), Qt::Key_Return);
    QVERIFY(shell.bannerSays("cannot be the proctor"));
    QVERIFY2(!shell.window().banner().text().contains("their own proctor"),
             "that is not wrong any more");
    QVERIFY(shell.fitsInBothSizes("75_exam"));
    QVERIFY(shell.type("proctor_login", "demo.educator"));
    QVERIFY(shell.type("proctor_password", "placode-demo"));
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(shell.find<QLabel>("live_ring")->isHidden());  // Time only.
    shell.shot("76_exam_running");
    QVERIFY(shell.find<QLabel>("running_words")->text().contains("uses up this attempt"));
}

void ShellTrainingTest::anExamThatIsLeftUsesUpItsAttempt() {
    ShellHarness& shell = *shell_;
    const auto begun = [&] {
        return QTest::qWaitFor([&] { return shell.context().launcher().status().time_s > 1; },
                               30000);
    };
    const auto attempts = [&] { return shell.owner().attempts().list(shell.idOf("nina")); };
    QVERIFY(begun());
    // Nobody is asked whether it is kept: the case was seen.
    ::kill(static_cast<pid_t>(shell.context().launcher().processId()), SIGKILL);
    QVERIFY(shell.arrives(PageId::kResult, kAttemptSeconds));
    QVERIFY2(
        shell.text("void_for_cause")
            .contains("It uses up one of the 4 attempts at this exam; left: 3. The next attempt "
                      "at this exam has another case."),
        qPrintable(shell.text("void_for_cause")));
    QVERIFY2(shell.text("result_verdict").startsWith("No score: left after"),
             qPrintable(shell.text("result_verdict")));
    QCOMPARE(attempts().size(), size_t{3});
    QCOMPARE(attempts()[2].end, sim::EndReason::kInterrupted);
    QCOMPARE(attempts()[2].exam.stage_id, std::string("lift_as_exam"));
    QCOMPARE(attempts()[2].seed, uint64_t{11});
    shell.shot("76_exam_left");
    // The shell itself goes away in mid-exam: what is left over is saved before the next one.
    QVERIFY(openExam());
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kRunning));
    QVERIFY(begun());
    shell.start();
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    QVERIFY(openExam());
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.bannerSays("Save it first"));
    shell.window().open({PageId::kRecovery, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kRecovery));
    QVERIFY(shell.find<QPushButton>("recover_delete_0")->isHidden());
    shell.shot("76_exam_left_over");
    QVERIFY(shell.click("recover_save_0"));
    QVERIFY(shell.arrives(PageId::kResult, kAttemptSeconds));
    QCOMPARE(attempts().size(), size_t{4});
    QCOMPARE(attempts()[3].seed, uint64_t{12});
}

void ShellTrainingTest::theNextExamHasAnotherCase() {
    ShellHarness& shell = *shell_;
    QVERIFY(openExam());
    QVERIFY(shell.click("start_attempt"));
    QVERIFY(shell.arrives(PageId::kResult, kAttemptSeconds));
    const auto attempts = shell.owner().attempts().list(shell.idOf("nina"));
    QCOMPARE(attempts.size(), size_t{5});
    QCOMPARE(attempts[4].exam.course_id, std::string("lift_exam"));
    QCOMPARE(attempts[4].exam.stage_id, std::string("lift_as_exam"));
    QCOMPARE(attempts[4].exam.proctor, std::string("Demonstration educator"));
    QCOMPARE(attempts[4].seed, uint64_t{11});  // There are two cases.
    QCOMPARE(shell.context().user().login, std::string("nina"));
    // It counts once it was simulated again; until then the page says so, and has no score.
    QVERIFY(shell.replaysEnd());
    QCOMPARE(shell.owner().attempts().detail(attempts[4].id).record.replay,
             db::ReplayState::kIdentical);
    QVERIFY(QTest::qWaitFor([&] { return !shell.text("exam_standing").isEmpty(); }, 10000));
    // That it was finished uses up an attempt as well; the course is mastered with it.
    const QString standing = shell.text("exam_standing");
    QVERIFY2(standing.contains("It uses up one of the 4 attempts at this exam; left: 1."),
             qPrintable(standing));
    QVERIFY2(standing.contains("The exam is passed") && standing.contains("certificate"),
             qPrintable(standing));
    shell.whole("76_exam_finished");
}

bool ShellTrainingTest::openExam() {
    ShellHarness& shell = *shell_;
    if (!shell.click("rail_course") || !shell.arrives(PageId::kCourse) ||
        !shell.click("open_exam_lift_as_exam") || !shell.arrives(PageId::kTask))
        return false;
    auto* device = shell.find<QComboBox>("device");
    if (!QTest::qWaitFor([&] { return device->findData("mouse") >= 0; }, 30000)) return false;
    device->setCurrentIndex(device->findData("mouse"));
    return shell.type("proctor_login", "demo.educator") &&
           shell.type("proctor_password", "placode-demo");
}

void ShellTrainingTest::masteredCourseGivesTheCertificate() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_course"));
    QVERIFY(shell.arrives(PageId::kCourse));
    QVERIFY(shell.text("certificate_code").contains("ready"));
    shell.save_as = shell.path("certificate.pdf");
    QVERIFY(shell.click("certificate"));
    QVERIFY(shell.bannerSays("Certificate written"));
    QFile file(shell.save_as);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(5) == "%PDF-");
    const auto issued = shell.owner().courses().certificates(shell.idOf("nina"));
    QCOMPARE(issued.size(), size_t{1});
    QCOMPARE(issued[0].course_id, std::string("lift_exam"));
    QVERIFY(shell.text("certificate_code").contains(QString::fromStdString(issued[0].code)));
    QVERIFY(shell.fitsInBothSizes("77_certificate"));
}

void ShellTrainingTest::educatorReviewsAndRemarks() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    QVERIFY(shell.click("rail_attempts"));
    QVERIFY(shell.arrives(PageId::kAttempts));
    QCOMPARE(shell.text("attempts_count"), QString("Shown: 1 to 5 of 5"));
    auto* table = shell.find<QTableWidget>("attempts_table");
    QCOMPARE(table->rowCount(), 5);
    // Newest first: three attempts at the exam, two of practice before them.
    QStringList kinds;
    for (int row = 0; row < 5; ++row) kinds << table->item(row, 3)->text();
    QCOMPARE(kinds, (QStringList{"Exam", "Exam", "Exam", "Practice", "Practice"}));
    shell.shot("77_attempts_with_exams");  // In both themes: each makes the page anew.
    table = shell.find<QTableWidget>("attempts_table");
    table->setCurrentCell(0, 0);
    Q_EMIT table->cellActivated(0, 0);
    QVERIFY(shell.arrives(PageId::kResult));
    QVERIFY(shell.type("comment_text", "Open the jaws before you turn."));
    const auto attempts = shell.owner().attempts().list(shell.idOf("nina"));
    // A check that ends meanwhile shows the page anew, and whoever writes writes on.
    const QPointer<Page> before = shell.window().page();
    Q_EMIT shell.context().replays().checked(attempts[4].id);
    QVERIFY(shell.window().page() != before);
    QCOMPARE(shell.find<QLineEdit>("comment_text")->text(),
             QString("Open the jaws before you turn."));
    QVERIFY(QTest::qWaitFor([&] { return shell.focusIsIn("comment_text"); }, 2000));
    QVERIFY(shell.click("comment_add"));
    const auto remarks = shell.owner().reviews().comments(attempts[4].id);
    QCOMPARE(remarks.size(), size_t{1});
    QCOMPARE(remarks[0].text, std::string("Open the jaws before you turn."));
}

void ShellTrainingTest::educatorGrantsMoreAttempts() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_courses"));
    QVERIFY(shell.arrives(PageId::kCourses));
    auto* table = shell.find<QTableWidget>("courses_table");
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 1)->text() == "lift_exam") table->selectRow(row);
    QTest::qWait(50);  // The card of the course before goes.
    // Only the exam has a limit.
    QCOMPARE(shell.find<QComboBox>("grant_stage")->count(), 1);
    auto* person = shell.find<QComboBox>("grant_person");
    person->setCurrentText("nobody of this name");
    QVERIFY(shell.click("grant"));
    QVERIFY(shell.bannerSays("There is nobody called"));
    person->setCurrentIndex(person->findText("Nina Nowak (nina)"));
    const QString before = shell.text("grant_standing");
    QVERIFY2(before.startsWith("Attempts made: ") && before.contains("left: "), qPrintable(before));
    QVERIFY(shell.click("grant"));
    QVERIFY(shell.bannerSays("A grant needs a reason"));
    shell.find<QSpinBox>("grant_attempts")->setValue(2);
    QVERIFY(shell.type("grant_reason", "Device repaired"));
    QVERIFY(shell.click("grant"));
    QVERIFY(shell.bannerSays("More attempts for Nina Nowak (nina): 2."));
    const auto grants = shell.owner().courses().grants(shell.idOf("nina"));
    QCOMPARE(grants.size(), size_t{1});
    QCOMPARE(grants[0].attempts, 2);
    QCOMPARE(grants[0].stage_id, std::string("lift_as_exam"));
    QCOMPARE(grants[0].reason, std::string("Device repaired"));
    const QString after = shell.text("grant_standing");
    QVERIFY2(after.contains("2 granted on") && after.contains("(Device repaired)"),
             qPrintable(after));
    QVERIFY(shell.fitsInBothSizes("78_grants"));
    // Back to the result that was reviewed.
    QVERIFY(shell.click("rail_attempts"));
    QVERIFY(shell.arrives(PageId::kAttempts));
    Q_EMIT shell.find<QTableWidget>("attempts_table")->cellActivated(0, 0);
    QVERIFY(shell.arrives(PageId::kResult));
}

void ShellTrainingTest::attemptsAreSeenSideBySide() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("compare"));
    QVERIFY(shell.arrives(PageId::kCompare));
    QVERIFY(
        QTest::qWaitFor([&] { return shell.find<QWidget>("compare_pictures") != nullptr; }, 30000));
    QVERIFY(shell.find<QTableWidget>("compare_metrics")->rowCount() > 10);
    QVERIFY(shell.text("compare_points_0").contains("points"));
    QVERIFY(shell.fitsInBothSizes("78_compare"));
    QVERIFY(
        QTest::qWaitFor([&] { return shell.find<QWidget>("compare_pictures") != nullptr; }, 30000));
    shell.find<QComboBox>("compare_speed")->setCurrentIndex(6);
    QVERIFY(shell.click("compare_play"));
    QVERIFY(QTest::qWaitFor(
        [&] {
            return shell.text("compare_clock_0") != "0:00" &&
                   shell.text("compare_clock_1") != "0:00";
        },
        90000));
    QVERIFY(shell.click("compare_play"));  // Both pause.
    QVERIFY(QTest::qWaitFor(
        [&] { return shell.find<QPushButton>("compare_play")->text() == "Go on"; }, 30000));
    QVERIFY(shell.click("compare_close"));
    QVERIFY(QTest::qWaitFor([&] { return !shell.find<QPushButton>("compare_close")->isEnabled(); },
                            30000));
}

void ShellTrainingTest::pinBringsBackToThePageThatWasLocked() {
    ShellHarness& shell = *shell_;
    shell.lock_after_s = 2;
    shell.start();
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    shell.window().open({PageId::kAccount, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAccount));
    // Whoever finds the screen unlocked sets no PIN.
    QVERIFY(shell.type("new_pin", "7391"));
    QVERIFY(shell.click("set_pin"));
    QVERIFY(shell.find<QLabel>("pin_message")->isVisible());
    QVERIFY(shell.type("pin_password", "not the one"));
    QVERIFY(shell.click("set_pin"));
    QCOMPARE(shell.find<QLabel>("pin_message")->text(), QString("The present password is wrong."));
    QVERIFY(!shell.owner().accounts().has_pin(shell.idOf("nina")));
    QVERIFY(shell.type("pin_password", "quiet river 7"));
    QVERIFY(shell.type("new_pin", "1234"));
    QVERIFY(shell.click("set_pin"));
    QVERIFY(shell.bannerSays("refused"));  // Too easy.
    QVERIFY(shell.type("new_pin", "7391"));
    QVERIFY(shell.click("set_pin"));
    QVERIFY(shell.owner().accounts().has_pin(shell.idOf("nina")));
    QVERIFY(shell.arrives(PageId::kLogin, 20));  // Locked by itself.
    QVERIFY(!shell.context().signedIn());
    QVERIFY(shell.text("login_note").contains("Locked"));
    QVERIFY(!shell.find<QLabel>("pin_hint")->isHidden());
    shell.shot("79_locked");
    QVERIFY(shell.type("password", "0000"));
    QVERIFY(shell.click("sign_in"));
    QVERIFY(shell.text("login_message").contains("PIN is wrong"));
    QVERIFY(shell.type("password", "7391"));
    QVERIFY(shell.click("sign_in"));
    QVERIFY(shell.context().signedIn());
    QVERIFY(shell.arrives(PageId::kAccount));
    // After a restart nobody knows the password: the PIN alone is not enough.
    shell.lock_after_s = 0;
    shell.start();
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.type("login", "nina"));
    QVERIFY(shell.find<QLabel>("pin_hint")->isHidden());
    QVERIFY(shell.type("password", "7391"));
    QVERIFY(shell.click("sign_in"));
    QVERIFY(!shell.context().signedIn());
}

void ShellTrainingTest::ownDataAreSavedAndErasureIsAskedAndDone() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("nina", "quiet river 7"));
    const int64_t nina = shell.idOf("nina");
    shell.window().open({PageId::kAccount, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAccount));
    QVERIFY(shell.fitsInBothSizes("79_account"));
    shell.save_as = shell.path("mine");
    QVERIFY(shell.click("save_my_data"));
    QVERIFY(shell.bannerSays("Your data is in", 30));
    QFile file(shell.exported() + "/my_data.json");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("Nina Nowak") && text.contains("lift_exam") &&
            text.contains("Open the jaws"));
    shell.confirmNext();
    QVERIFY(shell.click("ask_erasure"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("erasure_state").contains("You asked"); }));
    // One touch and the next person signs in.
    QVERIFY(shell.click("switch_user"));
    QVERIFY(shell.arrives(PageId::kLogin));
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(shell.click("rail_people"));
    QVERIFY(shell.arrives(PageId::kPeople));
    QVERIFY(shell.find<QPushButton>("open_admissions")->text().contains("1 waiting"));
    QVERIFY(shell.click("open_admissions"));
    QVERIFY(shell.arrives(PageId::kAdmissions));
    shell.confirmNext();
    QVERIFY(shell.click("erase_0"));
    QVERIFY(shell.bannerSays("was erased"));
    QVERIFY(!shell.owner().accounts().find_login("nina").has_value());
    QCOMPARE(shell.owner().attempts().list(nina).size(), size_t{5});  // Nameless.
    QVERIFY(shell.fitsInBothSizes("79_erased"));
}

void ShellTrainingTest::theCertificateWaitsForWhoLeftThePage() {
    ShellHarness& shell = *shell_;
    const int64_t olga = shell.idOf("olga");
    shell.owner().accounts().request_erasure(olga, "moves away");
    // Beside the store, and nobody can look into it.
    QFile copy(shell.path("placode.db.before-update-20260102T000000000Z"));
    QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write("no store any more") > 0);
    copy.close();
    shell.window().open({PageId::kAdmissions, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAdmissions));
    // On another page as soon as the work has begun.
    QObject leaves;
    QObject::connect(&shell.context(), &AppContext::busyChanged, &leaves, [&](const QString& what) {
        if (!what.isEmpty() && shell.window().current() == PageId::kAdmissions)
            shell.window().open({PageId::kAccount, 0, {}, {}});
    });
    shell.confirmNext();
    QVERIFY(shell.click(shell.find<QPushButton>("erase_0") != nullptr ? "erase_0" : "erase_1"));
    QVERIFY(shell.arrives(PageId::kAccount));
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 30000));
    QVERIFY(!shell.owner().accounts().find_login("olga").has_value());
    QVERIFY(shell.bannerSays("Olga Zet was erased; the certificate can be saved."));
    QVERIFY(shell.bannerSays("Copies that may still hold the person: 1."));
    QVERIFY(shell.click("banner_offer"));
    QVERIFY(shell.arrives(PageId::kAdmissions));
    const auto* left = shell.find<QLabel>("erasure_left");
    QVERIFY(left->isVisibleTo(&shell.window()) && left->text().contains("before-update"));
    shell.save_as = shell.path("olga.txt");
    QVERIFY(shell.find<QPushButton>("erasure_certificate")->isVisibleTo(&shell.window()));
    QVERIFY(shell.click("erasure_certificate"));
    QVERIFY(shell.bannerSays("Certificate written"));
    QFile certificate(shell.save_as);
    QVERIFY(certificate.open(QIODevice::ReadOnly));
    const QByteArray text = certificate.readAll();
    QVERIFY(text.contains("account " + QByteArray::number(static_cast<qlonglong>(olga)) + " "));
    QVERIFY(text.contains("before-update"));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellTrainingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_training_test.moc"
