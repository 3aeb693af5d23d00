// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The shell from the first start on, through the real windows: accounts, log-in, course, task,
// questionnaire, export, administration, and what it says when something is broken.

#include <QApplication>
#include <QComboBox>
#include <QRadioButton>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QXmlStreamReader>

#include "all_threads_taken.h"
#include "assessment/metrics.h"
#include "curriculum/definitions.h"
#include "curriculum/questionnaire.h"
#include "haptics/control_help.h"
#include "haptics/control_layout.h"
#include "reports/words.h"
#include "shell_harness.h"
#include "ui/shell/participant_steps.h"
#include "ui/shell/parts.h"

namespace placode::ui {

class ShellFlowTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() { shell_ = std::make_unique<ShellHarness>(); }
    void cleanupTestCase() { shell_.reset(); }

    void firstStartAsksForAnAdministrator();
    void wrongPasswordIsToldAndLosesNothing();
    void administratorAddsPeople();
    void weakPasswordIsRefusedWithAReason();
    void traineeSeesTodayCourseAndTask();
    void traineeCannotOpenWhatIsNotHis();
    void coordinatorRunsAParticipantAndExports();
    void questionnaireKeepsAnswersWhenTheLanguageChanges();
    void submittedAnswersAreSavedOnceWhenTheLanguageChanges();
    void reviewSaysAnswersInTheWordsOfTheirLanguage();
    void meansCountWhatTheExportsCount();
    void administratorChecksBacksUpAndReadsTheAudit();
    void deactivatedPersonCannotSignIn();
    void everyControlCanBeReachedAndIsNamed();
    void lockedStoreIsABannerAndNothingIsLost();
    void brokenTaskIsNamedAndTheRestGoesOn();
    void missingSimulatorIsABanner();
    void countedNounsHaveTheirPlurals();
    void everyStringHasAPolishTranslation();

 private:
    std::unique_ptr<ShellHarness> shell_;
};

void ShellFlowTest::firstStartAsksForAnAdministrator() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.setsUpStation());
    shell.shot("01_first_start");
    QVERIFY(shell.type("display_name", "Ada Admin"));
    QVERIFY(shell.type("login", "ada"));
    QVERIFY(shell.type("password", "correct horse"));
    QVERIFY(shell.type("password_again", "correct hose"));
    QVERIFY(shell.click("create_administrator"));
    QVERIFY(shell.text("setup_message").contains("differ"));
    QCOMPARE(shell.owner().accounts().list().size(), size_t{0});
    QVERIFY(shell.type("password_again", "correct horse"));
    QVERIFY(shell.click("create_administrator"));
    QVERIFY(shell.arrives(PageId::kLogin));
    const auto users = shell.owner().accounts().list();
    QCOMPARE(users.size(), size_t{1});
    QVERIFY(db::has_role(users[0].roles, db::Role::kAdministrator));
    QVERIFY(!db::has_role(users[0].roles, db::Role::kTrainee));
}

void ShellFlowTest::wrongPasswordIsToldAndLosesNothing() {
    ShellHarness& shell = *shell_;
    QCOMPARE(shell.find<QLineEdit>("login")->text(), QString("ada"));
    QVERIFY(!shell.signIn("ada", "wrong horse!!"));
    QVERIFY(shell.text("login_message").contains("wrong"));
    QVERIFY(shell.find<QLineEdit>("password")->text().isEmpty());
    shell.shot("02_login_wrong_password");
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(shell.arrives(PageId::kPeople));
}

void ShellFlowTest::administratorAddsPeople() {
    ShellHarness& shell = *shell_;
    const std::tuple<const char*, const char*, int> people[] = {
        {"Tom Trainee", "tom", 1}, {"Eva Educator", "eva", 2}, {"Cor Coordinator", "cor", 4}};
    for (const auto& [name, login, role] : people) {
        QVERIFY(shell.type("new_name", name));
        QVERIFY(shell.type("new_login", login));
        QVERIFY(shell.type("new_password", "first password"));
        for (const int bit : {1, 2, 4, 8}) {
            auto* box = shell.find<QAbstractButton>(QString("role_%1").arg(bit));
            QVERIFY(box != nullptr);
            box->setChecked(bit == role);
        }
        QVERIFY(shell.click("add_person"));
        QVERIFY(shell.bannerSays(name));
    }
    QCOMPARE(shell.find<QTableWidget>("people_table")->rowCount(), 4);
    shell.find<QTableWidget>("people_table")->selectRow(0);
    shell.shot("03_people");
    QCOMPARE(int(shell.owner().accounts().find_login("eva")->roles), 2);
    // From here on everybody has chosen the password; shell_forms_test sees them asked for it.
    for (const auto& [name, login, role] : people)
        shell.owner().accounts().set_password(shell.idOf(login), "first password");
}

void ShellFlowTest::weakPasswordIsRefusedWithAReason() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.type("new_name", "Weak"));
    QVERIFY(shell.type("new_login", "weak"));
    QVERIFY(shell.type("new_password", "short"));
    QVERIFY(shell.click("add_person"));
    QVERIFY(shell.text("add_message").contains("too short: 5 of at least 10 characters"));
    QVERIFY(shell.find<QLabel>("add_message")->isVisible());
    QVERIFY(shell.focusIsIn("new_password"));
    shell.shot("04_weak_password");
    QVERIFY(!shell.owner().accounts().find_login("weak"));
}

void ShellFlowTest::traineeSeesTodayCourseAndTask() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("tom", "first password"));
    QVERIFY(shell.arrives(PageId::kToday));
    shell.shot("05_today_first_day");
    QVERIFY(shell.click("rail_course"));
    QVERIFY(shell.arrives(PageId::kCourse));
    shell.shot("06_course");
    // The second stage is locked: there is no way to open it.
    QVERIFY(shell.find<QPushButton>("open_diathermy_ring_small") != nullptr);
    QVERIFY(shell.find<QPushButton>("open_diathermy_ring") == nullptr);
    QVERIFY(shell.click("open_diathermy_ring_small"));
    QVERIFY(shell.arrives(PageId::kTask));
    shell.shot("07_task");
    auto* devices = shell.find<QComboBox>("device");
    QVERIFY(devices->findData("mouse") >= 0);
    QVERIFY(devices->findData("keyboard") >= 0);
    // A scripted operator's score is nobody's skill: not for a real trainee.
    QCOMPARE(devices->findData("script:expert"), -1);
    QVERIFY(shell.click("rail_history"));
    QVERIFY(shell.arrives(PageId::kHistory));
    shell.shot("08_history_empty");
}

void ShellFlowTest::traineeCannotOpenWhatIsNotHis() {
    ShellHarness& shell = *shell_;
    for (const char* button : {"rail_people", "rail_studies", "rail_attempts", "rail_audit"})
        QVERIFY2(shell.find<QToolButton>(button) == nullptr, button);
    shell.window().open({PageId::kAttempts, 0, {}, {}});
    QVERIFY(shell.bannerSays("may not"));
    QVERIFY(shell.window().page() == nullptr);
}

void ShellFlowTest::coordinatorRunsAParticipantAndExports() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("cor", "first password"));
    QVERIFY(shell.arrives(PageId::kStudies));
    QVERIFY(!shell.find<QPushButton>("export")->isEnabled());
    for (int participant = 0; participant < 3; ++participant) {
        QVERIFY(shell.click("new_participant"));
        QVERIFY(shell.arrives(PageId::kParticipant));
        if (participant == 0) shell.shot("09_questionnaire");
        QVERIFY(shell.click("review"));
        QVERIFY(shell.text("participant_message").startsWith("Questions A, B, C"));
        for (const auto& item : curriculum::load_questionnaire("face_validity").items) {
            if (item.kind != curriculum::ItemKind::kLikert) continue;
            auto* radio = shell.find<QRadioButton>(
                QString("answer_%1_%2").arg(item.id.c_str()).arg(3 + participant % 3));
            QVERIFY(radio != nullptr);
            QVERIFY(radio->width() >= 44 && radio->height() >= 44);
            radio->click();
        }
        QVERIFY(shell.click("review"));
        QVERIFY(shell.find<QPushButton>("submit_answers") != nullptr);
        QCOMPARE(shell.owner().studies().answers("face_validity").size(), size_t(participant));
        QVERIFY(shell.click("submit_answers"));
        shell.takeBackNext("first password");
        QVERIFY(shell.click("participant_done"));
        QVERIFY(shell.arrives(PageId::kStudies));
    }
    shell.shot("10_studies");
    auto* items = shell.find<QTableWidget>("item_table");
    QCOMPARE(items->item(0, 2)->text(), QString("3"));     // n
    QCOMPARE(items->item(0, 3)->text(), QString("4.00"));  // mean of 3, 4, 5
    QCOMPARE(items->item(0, 4)->text(), QString("1.00"));  // sample SD
    shell.save_as = shell.path("exported");
    QVERIFY(shell.click("export"));
    QVERIFY(shell.bannerSays("exported"));
    QFile file(shell.exported() + "/face_validity_face_validity.csv");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 4);  // header and three participants
    QVERIFY(lines[0].contains("A") && lines[0].contains("F"));
    auto* format = shell.find<QComboBox>("export_format");
    format->setCurrentIndex(format->findData("spss"));
    QVERIFY(shell.click("export"));
    QVERIFY(QFile::exists(shell.exported() + "/face_validity_face_validity.sav"));
    // What was answered is kept with every change, and the questionnaire's text beside it.
    QVERIFY(!shell.owner().studies().answers("face_validity").at(0).changes.empty());
    QVERIFY(shell.owner().definitions().find("questionnaire", "face_validity").has_value());
    for (const auto& record : shell.owner().studies().answers("face_validity"))
        QVERIFY(lines.join('\n').contains(QString::fromStdString(record.participant)));
}

void ShellFlowTest::questionnaireKeepsAnswersWhenTheLanguageChanges() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    shell.find<QRadioButton>("answer_C_2")->click();
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kParticipant));
    QVERIFY(shell.find<QRadioButton>("answer_C_2")->isChecked());
    QCOMPARE(shell.find<QPushButton>("review")->text(), QString("Przejrzyj odpowiedzi"));
    shell.shot("11_questionnaire_polish");
    // Leaving asks, because an answer would be lost.
    shell.confirmNext();
    shell.takeBackNext("first password");
    QVERIFY(shell.click("cancel_participant"));
    QVERIFY(shell.arrives(PageId::kStudies));
    shell.context().setLanguage("en");
    QCOMPARE(shell.owner().studies().answers("face_validity").size(), size_t{3});
}

// Built anew, the page began at the filled questionnaire, and Submit saved it a second time.
void ShellFlowTest::submittedAnswersAreSavedOnceWhenTheLanguageChanges() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("new_participant"));
    QVERIFY(shell.arrives(PageId::kParticipant));
    const auto asked = curriculum::load_questionnaire("face_validity");
    for (const auto& item : asked.items)
        if (item.kind == curriculum::ItemKind::kLikert)
            shell.find<QRadioButton>(QString("answer_%1_4").arg(item.id.c_str()))->click();
    QVERIFY(shell.click("review"));
    QVERIFY(shell.click("submit_answers"));
    QVERIFY(shell.find<QPushButton>("participant_done") != nullptr);
    const size_t saved = shell.owner().studies().answers("face_validity").size();
    QCOMPARE(saved, size_t{4});
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kParticipant));
    QVERIFY(shell.find<QPushButton>("review") == nullptr);
    QVERIFY(shell.find<QPushButton>("submit_answers") == nullptr);
    const auto* done = shell.find<QPushButton>("participant_done");
    QVERIFY(done != nullptr && done->isVisibleTo(shell.window().page()));
    shell.context().setTheme(ThemeKind::kDark);
    QVERIFY(shell.find<QPushButton>("participant_done") != nullptr);
    shell.context().setTheme(ThemeKind::kLight);
    shell.context().setLanguage("en");
    QCOMPARE(shell.owner().studies().answers("face_validity").size(), saved);
    shell.takeBackNext("first password");
    QVERIFY(shell.click("participant_done"));
    QVERIFY(shell.arrives(PageId::kStudies));
}

// It said "1 of 5", which may be the best and the worst, and "3.5 years" to Poles.
void ShellFlowTest::reviewSaysAnswersInTheWordsOfTheirLanguage() {
    ShellHarness& shell = *shell_;
    const auto asked = curriculum::load_questionnaire("demographics");
    const curriculum::Answers answers{
        {"age", "42"}, {"operative_years", "3.5"}, {"interest_vr", "2"}};
    const auto said = [&] {
        const std::unique_ptr<QWidget> step(
            make_review_step(shell.context(), asked, answers,
                             [](const curriculum::QuestionnaireItem&) { return QString(); }));
        QStringList words;
        for (const QLabel* label : step->findChildren<QLabel*>()) words << label->text();
        return words;
    };
    const QStringList english = said();
    for (const char* words : {"42 years", "3.5 years", "2  disagree"})
        QVERIFY2(english.contains(words), qPrintable(english.join(" | ")));
    shell.context().setLanguage("pl");
    const QStringList polish = said();
    for (const char* words : {"42 lata", "3,5 roku"})
        QVERIFY2(polish.contains(words), qPrintable(polish.join(" | ")));
    QCOMPARE(with_unit("99", "years"), QString("99 lat"));
    QCOMPARE(with_unit("99", "kg"), QString("99 kg"));
    shell.context().setLanguage("en");
    QCOMPARE(with_unit("1", "years"), QString("1 year"));
}

void ShellFlowTest::meansCountWhatTheExportsCount() {
    ShellHarness& shell = *shell_;
    auto& studies = shell.owner().studies();
    const auto before = studies.answers("face_validity");  // 3, 4, 5 and 4
    QCOMPARE(before.size(), size_t{4});
    studies.withdraw("face_validity", before[2].participant, db::WithdrawalMode::kStop,
                     "not given");
    db::AnswerRecord again = before[0];
    again.id = 0;
    again.changes.clear();
    for (auto& [item, answer] : again.answers) answer = "5";
    studies.save_answers(again);
    const auto shows = [&](const char* n, const char* mean) {
        shell.window().open({PageId::kStudies, 0, "face_validity", {}});
        QVERIFY(shell.arrives(PageId::kStudies));
        const auto* items = shell.find<QTableWidget>("item_table");
        QCOMPARE(items->item(0, 2)->text(), QString(n));
        QCOMPARE(items->item(0, 3)->text(), QString(mean));
    };
    shows("3", "3.67");
    if (QTest::currentTestFailed()) return;
    // An answer to another version stands beside the others, not among them.
    again.participant = studies.new_participant("face_validity");
    ++again.questionnaire_version;
    studies.save_answers(again);
    shows("3", "3.67");
}

void ShellFlowTest::administratorChecksBacksUpAndReadsTheAudit() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("ada", "correct horse"));
    QVERIFY(shell.click("rail_health"));
    QVERIFY(shell.arrives(PageId::kHealth));
    {
        // As if it took as long as a large store takes.
        AllThreadsTaken taken(shell.context().workers());
        QVERIFY(shell.click("check_store"));
        QVERIFY2(!shell.find<QPushButton>("check_store")->isVisible(), "one at a time");
        QVERIFY(shell.click("cancel_check"));
    }
    QVERIFY(
        QTest::qWaitFor([&] { return shell.text("check_outcome").contains("cancelled"); }, 10000));
    QVERIFY(!shell.find<QPushButton>("cancel_check")->isVisible());
    QVERIFY(shell.click("check_store"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("check_outcome").contains("Sound"); }, 10000));
    shell.save_as = shell.path("copy.db");
    QVERIFY(shell.click("backup_now"));
    QVERIFY(shell.bannerSays("copy.db"));
    const auto copy = db::open_store("sqlite:" + shell.save_as.toStdString());
    QCOMPARE(copy->accounts().list().size(), size_t{4});
    shell.shot("12_health");
    QVERIFY(shell.click("rail_audit"));
    QVERIFY(shell.arrives(PageId::kAudit));
    auto* table = shell.find<QTableWidget>("audit_table");
    QVERIFY(table->rowCount() >= 8);
    for (int row = 0; row < table->rowCount(); ++row) {
        // The code stays behind the words, for who looks for it.
        QTableWidgetItem* what = table->item(row, 2);
        QVERIFY2(what->text() != what->toolTip(), qPrintable(what->text() + " has no words"));
    }
    QVERIFY(shell.type("audit_search", "export.csv"));
    int shown = 0;
    for (int row = 0; row < table->rowCount(); ++row) shown += table->isRowHidden(row) ? 0 : 1;
    QCOMPARE(shown, 1);
    QVERIFY(shell.type("audit_search", ""));
    shell.shot("13_audit");
    shell.window().open({PageId::kAccount, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kAccount));
    shell.shot("14_account");
}

void ShellFlowTest::deactivatedPersonCannotSignIn() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_people"));
    QVERIFY(shell.arrives(PageId::kPeople));
    auto* table = shell.find<QTableWidget>("people_table");
    for (int row = 0; row < table->rowCount(); ++row) {
        if (table->item(row, 1)->text() == "eva") table->selectRow(row);
    }
    shell.confirmNext();
    QVERIFY(shell.click("toggle_active"));
    QVERIFY(!shell.owner().accounts().find_login("eva")->active);
    QVERIFY(!shell.signIn("eva", "first password"));
    QVERIFY(shell.text("login_message").contains("deactivated"));
}

void ShellFlowTest::everyControlCanBeReachedAndIsNamed() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("tom", "first password"));
    for (const PageId page : {PageId::kToday, PageId::kCourse, PageId::kTask, PageId::kHistory,
                              PageId::kAccount, PageId::kRecovery}) {
        shell.window().open({page, 0, "diathermy_ring_small", {}});
        QVERIFY(shell.arrives(page));
        for (QWidget* widget : shell.window().findChildren<QWidget*>()) {
            if (!widget->isVisibleTo(&shell.window())) continue;
            auto* button = qobject_cast<QAbstractButton*>(widget);
            auto* line = qobject_cast<QLineEdit*>(widget);
            auto* box = qobject_cast<QComboBox*>(widget);
            if (button == nullptr && line == nullptr && box == nullptr) continue;
            if (qobject_cast<QTableWidget*>(widget->parentWidget()) != nullptr) continue;
            const QString what =
                QString::fromLatin1(widget->metaObject()->className()) + " " + widget->objectName();
            const bool named =
                !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
            QVERIFY2(named, qPrintable(what + " has no name"));
            QVERIFY2((widget->focusPolicy() & Qt::TabFocus) != 0,
                     qPrintable(what + " cannot be reached by Tab"));
            QVERIFY2(widget->height() >= 40, qPrintable(what + " is too small for a finger"));
        }
    }
}

void ShellFlowTest::lockedStoreIsABannerAndNothingIsLost() {
    ShellHarness& shell = *shell_;
    shell.context().signOut();
    {
        QSqlDatabase other = QSqlDatabase::addDatabase("QSQLITE", "other program");
        other.setDatabaseName(shell.path("placode.db"));
        QVERIFY(other.open());
        QSqlQuery lock(other);
        QVERIFY(lock.exec("BEGIN IMMEDIATE"));
        QVERIFY(!shell.signIn("tom", "first password"));
        QVERIFY(shell.bannerSays("locked"));
        shell.shot("15_banner_locked");
        QVERIFY(lock.exec("ROLLBACK"));
    }
    QSqlDatabase::removeDatabase("other program");
    QVERIFY(shell.signIn("tom", "first password"));
}

void ShellFlowTest::brokenTaskIsNamedAndTheRestGoesOn() {
    ShellHarness& shell = *shell_;
    // A copy of the shipped data in which one task has a wrong unit.
    const QString data = shell.path("data");
    const QString shipped = QString::fromStdString(curriculum::data_folder().string());
    for (const char* kind : {"tasks", "scenes", "courses", "questionnaires", "schemas"}) {
        QVERIFY(QDir().mkpath(data + "/" + kind));
        for (const QString& name : QDir(shipped + "/" + kind).entryList(QDir::Files))
            QVERIFY(QFile::copy(shipped + "/" + kind + "/" + name, data + "/" + kind + "/" + name));
    }
    QFile task(data + "/tasks/diathermy_ring_small.json");
    QVERIFY(task.open(QIODevice::ReadOnly));
    QByteArray text = task.readAll();
    task.close();
    QVERIFY(text.contains("time_limit_s"));
    text.replace("time_limit_s", "time_limit_min");
    QVERIFY(task.setPermissions(QFile::ReadOwner | QFile::WriteOwner));
    QVERIFY(task.open(QIODevice::WriteOnly | QIODevice::Truncate));
    task.write(text);
    task.close();
    qputenv("PLACODE_DATA", data.toLocal8Bit());
    shell.window().open({PageId::kCourse, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kCourse));
    shell.shot("16_course_broken_task");
    QVERIFY(shell.find<QPushButton>("open_diathermy_ring_small") == nullptr);
    bool named = false;
    for (const QLabel* label : shell.window().page()->findChildren<QLabel*>())
        named = named || label->text().contains("time_limit_min");
    QVERIFY2(named, "the page must name the key that is wrong");
    shell.window().open({PageId::kTask, 0, "diathermy_ring_small", {}});
    QVERIFY(shell.bannerSays("diathermy_ring_small.json"));
    QVERIFY(shell.find<QPushButton>("try_again") != nullptr);
    qunsetenv("PLACODE_DATA");
    QVERIFY(shell.click("try_again"));
    QVERIFY(shell.arrives(PageId::kTask));
}

void ShellFlowTest::missingSimulatorIsABanner() {
    ShellHarness& shell = *shell_;
    LaunchOptions options;
    options.program = shell.path("nowhere/placode-sim");
    AttemptLauncher launcher(options);
    AttemptOrder order;
    order.task = "diathermy_ring_small";
    order.device = "mouse";
    QVERIFY(!shell.context().guard("Starting",
                                   [&] { launcher.start(order, shell.path("recordings")); }));
    QVERIFY(shell.bannerSays("nowhere/placode-sim"));
    QVERIFY(QDir(shell.path("recordings")).entryList(QDir::Files).isEmpty());
}

// English is the language of the source, and needs a file for its plurals alone: where one is
// missing, "(s)" is shown.
void ShellFlowTest::countedNounsHaveTheirPlurals() {
    const auto counted = [](const char* file) {
        QFile ts(QString(PLACODE_SOURCE_DIR "/ui/shell/translations/") + file);
        QSet<QString> found;
        if (!ts.open(QIODevice::ReadOnly)) return found;
        QXmlStreamReader xml(&ts);
        QString context;
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement()) continue;
            if (xml.name() == QLatin1String("name")) context = xml.readElementText();
            if (xml.name() != QLatin1String("source")) continue;
            const QString source = xml.readElementText();
            if (source.contains("%n")) found << context + ": " + source;
        }
        return found;
    };
    const QSet<QString> english = counted("placode_en.ts"), polish = counted("placode_pl.ts");
    QVERIFY(english.size() > 10);
    QCOMPARE(english - polish, QSet<QString>());
    QCOMPARE(polish - english, QSet<QString>());
    AppContext& context = shell_->context();
    const auto points = [](double n) { return points_words(n); };
    QCOMPARE(points(1), QString("1 point"));
    QCOMPARE(points(0), QString("0 points"));
    QCOMPARE(points(22), QString("22 points"));
    // 70 beside "not yet" would be a riddle.
    QCOMPARE(points(69.6), QString("69.6 points"));
    QCOMPARE(points(69.98), QString("70 points"));
    context.setLanguage("pl");
    QCOMPARE(points(1), QString("1 punkt"));
    QCOMPARE(points(22), QString("22 punkty"));
    QCOMPARE(points(12), QString("12 punktów"));
    QCOMPARE(points(1.5), QString("1,5 punktu"));
    QCOMPARE(points(100), QString("100 punktów"));
    QCOMPARE(reports::void_words("The computer was too slow: 1 pictures a second, 20 are needed"),
             QString("Komputer był za wolny: 1 obraz na sekundę, potrzeba 20"));
    context.setLanguage("en");
    QCOMPARE(reports::void_words("The computer was too slow: 1 pictures a second, 20 are needed"),
             QString("The computer was too slow: 1 picture a second, 20 are needed"));
}

void ShellFlowTest::everyStringHasAPolishTranslation() {
    QFile file(PLACODE_SOURCE_DIR "/ui/shell/translations/placode_pl.ts");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    int messages = 0;
    QString source;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        if (xml.name() == QLatin1String("source")) source = xml.readElementText();
        if (xml.name() != QLatin1String("translation")) continue;
        ++messages;
        const QString type = xml.attributes().value("type").toString();
        // A counted noun has three forms: 1 próba, 2 próby, 5 prób.
        QStringList forms;
        if (source.contains("%n")) {
            while (xml.readNextStartElement()) forms << xml.readElementText();
            QVERIFY2(forms.size() == 3, qPrintable(source));
        } else {
            forms << xml.readElementText();
        }
        for (const QString& translation : forms) {
            QVERIFY2(type.isEmpty() && !translation.isEmpty(), qPrintable(source + ": " + type));
            for (const char* mark : {"%1", "%2", "%3"})
                QVERIFY2(source.contains(mark) == translation.contains(mark), qPrintable(source));
        }
    }
    QVERIFY(!xml.hasError());
    QVERIFY(messages > 300);
    // What other folders say in English is in the list, too.
    AppContext& context = shell_->context();
    context.setLanguage("pl");
    for (const auto& metric : assessment::metric_definitions()) {
        const QByteArray name(metric.name.data(), static_cast<qsizetype>(metric.name.size()));
        const bool same = QCoreApplication::translate("Metric", name) == QString::fromUtf8(name);
        QVERIFY2(!same, name.constData());
        const QByteArray text(metric.definition.data(),
                              static_cast<qsizetype>(metric.definition.size()));
        QVERIFY2(QCoreApplication::translate("MetricDefinition", text) != QString::fromUtf8(text),
                 text.constData());
    }
    for (const char* device : {"mouse", "keyboard", "gamepad"}) {
        const auto help = haptics::controls(device);
        QVERIFY(!help.empty());
        for (const auto& line : help) {
            const QString action = QCoreApplication::translate("Controls", line.action.c_str());
            QVERIFY2(action != QString::fromStdString(line.action), line.action.c_str());
        }
    }
    for (const haptics::Control& control : haptics::layout_controls()) {
        const QString action = QCoreApplication::translate("Layout", control.action.data());
        QVERIFY2(action != QString::fromUtf8(control.action.data()), control.action.data());
    }
    context.setLanguage("en");
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellFlowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_flow_test.moc"
