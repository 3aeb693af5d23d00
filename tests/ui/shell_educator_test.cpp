// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What an educator does with many attempts, through the real windows: the cohort, standards from
// two groups, blinded ratings, and search. The attempts are put into the store with chosen scores.

#include <QApplication>
#include <QCheckBox>
#include <QListWidget>
#include <QMenu>
#include <QRadioButton>
#include <QSpinBox>
#include <algorithm>

#include "assessment/standard_setting.h"
#include "curriculum/questionnaire.h"
#include "curriculum/task.h"
#include "db/standards.h"
#include "shell_harness.h"
#include "ui/shell/cohort_people.h"
#include "ui/shell/parts.h"
#include "ui/shell/standard_cards.h"

namespace placode::ui {

namespace {
constexpr const char* kTask = "diathermy_ring_small";
const QStringList kNames{"Anna Stuck", "Bert Back", "Cleo Clever", "Dan Quick"};

/// An attempt is all that a task needs to stand in the list of the page of standards.
void add_attempt(db::Store& store, int64_t user, const std::string& task) {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.device = "mouse";
    result.header.started_utc = "2026-03-01T10:00:00Z";
    result.end.reason = sim::EndReason::kFinished;
    result.end.duration_s = 200;
    result.metrics.values = {{"task_time_s", 200}};
    result.score.points = 70;
    result.score.verdict = assessment::Verdict::kPassed;
    result.score.rubric_id = "ring_incision";
    (void)store.attempts().save(user, result);
}
}  // namespace

class ShellEducatorTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void aCohortOfNobodyCanBeLookedAt();
    void todayShowsTheNewestAttemptsOfTrainees();
    void cohortShowsWhoIsStuckAndWhoRegressed();
    void whoHasLeftNeedsNoHelp();
    void cohortLeadsToTheAttemptsAndIsExported();
    void aResultLeadsBackToTheListAsItWas();
    void cohortAndPersonAreReportedOnPaper();
    void standardComesFromTwoGroups();
    void aSmallPIsNotNought();
    void metricsWithoutEvidenceAreFlagged();
    void judgesEstimateAPassMark();
    void estimatesStayUntilTheyAreSet();
    void raterSeesNeitherNameNorScore();
    void agreementOfRatersIsTold();
    void searchOpensByKeyboardAlone();
    void searchKeepsToTheRights();
    void lastPageIsRemembered();
    void aTaskThatNobodyCountsInSaysSo();
    void namesAreShownWhereThereIsRoom();

 private:
    void add(const QString& name, const std::string& login, const std::vector<double>& points);
    [[nodiscard]] QWidget* dialog() const { return QApplication::activeModalWidget(); }
    /// Opens the search, types, and waits until attempts were read.
    [[nodiscard]] bool search(const QString& words);

    std::unique_ptr<ShellHarness> shell_;
    std::vector<int64_t> ids_;
};

void ShellEducatorTest::add(const QString& name, const std::string& login,
                            const std::vector<double>& points) {
    db::Store& store = shell_->owner();
    db::NewUser user;
    user.login = login;
    user.display_name = name.toStdString();
    user.password = "first password";
    const int64_t id = store.accounts().create(user);
    for (size_t i = 0; i < points.size(); ++i) {
        db::AttemptResult result;
        result.header.task_id = kTask;
        result.header.device = "mouse";
        result.header.started_utc = QString("2026-03-%1T10:00:00Z")
                                        .arg(static_cast<int>(i) + 1, 2, 10, QChar('0'))
                                        .toStdString();
        result.end.reason = sim::EndReason::kFinished;
        result.end.duration_s = 200;
        result.metrics.values = {{"task_time_s", 200}};
        result.score.points = points[i];
        result.score.verdict =
            points[i] >= 70 ? assessment::Verdict::kPassed : assessment::Verdict::kNotYet;
        result.score.rubric_id = "ring_incision";
        ids_.push_back(store.attempts().save(id, result));
    }
}

void ShellEducatorTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    add(kNames[0], "anna", {40, 41, 40, 39, 42, 41});
    add(kNames[1], "bert", {50, 75, 80, 60, 55});
    add(kNames[2], "cleo", {60, 78, 84, 90});
    add(kNames[3], "dan", {82, 88, 91});
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
}

void ShellEducatorTest::aCohortOfNobodyCanBeLookedAt() {
    ShellHarness empty;
    QVERIFY(empty.setUpWithDemonstration());
    QVERIFY(empty.signIn("demo.educator", "placode-demo"));
    QVERIFY(empty.click("rail_cohort"));
    QVERIFY(empty.arrives(PageId::kCohort));
    auto* only_help = empty.find<QAbstractButton>("only_help");
    QVERIFY(only_help != nullptr);
    QTest::mouseClick(only_help, Qt::LeftButton);  // Crashed: there is no table to filter.
    QVERIFY(!only_help->isEnabled());
}

void ShellEducatorTest::todayShowsTheNewestAttemptsOfTrainees() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_today"));
    QVERIFY(shell.arrives(PageId::kToday));
    auto* table = shell.find<QTableWidget>("today_newest");
    QVERIFY(table != nullptr);
    QCOMPARE(table->rowCount(), 5);
    // All of its rows are in sight, without a bar to scroll.
    QVERIFY(table->viewport()->rect().contains(
        table->visualItemRect(table->item(4, 0)).adjusted(2, 2, -2, -2)));
    shell.shot("29_today_educator");
    QVERIFY(shell.click("today_all_attempts"));
    QVERIFY(shell.arrives(PageId::kAttempts));
    QVERIFY(shell.click("rail_today"));
    QVERIFY(shell.arrives(PageId::kToday));
    table = shell.find<QTableWidget>("today_newest");
    Q_EMIT table->cellActivated(0, 0);
    QVERIFY(shell.arrives(PageId::kResult));
    QCOMPARE(shell.text("result_points"), QString("41 points"));  // of 6 March, the newest day
}

void ShellEducatorTest::cohortShowsWhoIsStuckAndWhoRegressed() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_cohort"));
    QVERIFY(shell.arrives(PageId::kCohort));
    auto* table = shell.find<QTableWidget>("cohort_table");
    QCOMPARE(table->rowCount(), 4);
    QVERIFY(table->item(0, 2)->toolTip().startsWith("stuck"));
    QVERIFY(table->item(1, 2)->toolTip().startsWith("regressed"));
    QVERIFY(table->item(2, 2)->toolTip().startsWith("passing"));
    // One that was broken off neither counts nor ends the row.
    QVERIFY(table->item(2, 2)->toolTip().contains("finished attempts passed in a row: 3"));
    QVERIFY(shell.find<QPushButton>("help_1") != nullptr);
    QVERIFY(shell.find<QPushButton>("help_2") == nullptr);
    for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell.fits());
        shell.whole(QString("80_cohort_%1").arg(size.width()));
    }
    shell.context().setLanguage("pl");
    QVERIFY(shell.arrives(PageId::kCohort));
    shell.whole("81_cohort_polish");
    shell.context().setLanguage("en");
    QVERIFY(shell.arrives(PageId::kCohort));
    shell.find<QCheckBox>("only_help")->click();
    table = shell.find<QTableWidget>("cohort_table");
    QVERIFY(!table->isRowHidden(0) && !table->isRowHidden(1));
    QVERIFY(table->isRowHidden(2) && table->isRowHidden(3));
}

void ShellEducatorTest::whoHasLeftNeedsNoHelp() {
    db::Store& store = shell_->owner();
    const int64_t anna = shell_->idOf("anna");
    const auto listed = [&] {
        const CohortPeople read = read_cohort_people(store);
        return std::any_of(read.people.begin(), read.people.end(),
                           [&](const CohortPerson& each) { return each.id == anna; });
    };
    QVERIFY(listed());
    store.accounts().set_active(anna, false);
    QVERIFY(!listed());
    // The page does not say that nobody's attempts count.
    for (const char* login : {"bert", "cleo", "dan"})
        store.accounts().set_active(shell_->idOf(login), false);
    shell_->window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCohort));
    QVERIFY2(shell_->text("cohort_empty").contains("the accounts are deactivated"),
             qPrintable(shell_->text("cohort_empty")));
    for (const char* login : {"anna", "bert", "cleo", "dan"})
        store.accounts().set_active(shell_->idOf(login), true);
    QVERIFY(listed());
    shell_->window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCohort));
}

void ShellEducatorTest::cohortLeadsToTheAttemptsAndIsExported() {
    ShellHarness& shell = *shell_;
    shell.save_as = shell.path("cohort.csv");
    QVERIFY(shell.click("cohort_export"));
    QVERIFY(shell.bannerSays("cohort.csv"));
    QFile file(shell.save_as);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 5);
    QVERIFY(lines[1].contains("Anna Stuck") && lines[1].contains("stuck,6,41.0,42.0,0"));
    QVERIFY(shell.click("help_0"));
    QVERIFY(shell.arrives(PageId::kAttempts));
    QCOMPARE(shell.find<QComboBox>("filter_person")->currentText(), kNames[0]);
}

// There was no way back from a result, and the list had forgotten whose attempts were asked for.
void ShellEducatorTest::aResultLeadsBackToTheListAsItWas() {
    ShellHarness& shell = *shell_;
    shell.window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kCohort) && shell.click("help_0"));
    const auto reads = [&] {
        if (!shell.arrives(PageId::kAttempts)) return false;
        Q_EMIT shell.find<QTableWidget>("attempts_table")->cellActivated(0, 0);
        return shell.arrives(PageId::kResult);
    };
    const auto is_back = [&] {
        return shell.arrives(PageId::kAttempts) &&
               shell.find<QComboBox>("filter_person")->currentText() == kNames[0];
    };
    QVERIFY(reads() && shell.click("compare") && shell.arrives(PageId::kCompare));
    QVERIFY(shell.click("back_to_result") && shell.arrives(PageId::kResult));
    QVERIFY(shell.click("back"));
    QVERIFY2(is_back(), "the list, not the comparison");
    QVERIFY(reads());
    QApplication::setActiveWindow(&shell.window());
    QTest::keyClick(&shell.window(), Qt::Key_Left, Qt::AltModifier);
    QVERIFY(is_back());
}

void ShellEducatorTest::cohortAndPersonAreReportedOnPaper() {
    ShellHarness& shell = *shell_;
    const auto is_pdf = [](const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) && file.size() > 5000 && file.read(5) == "%PDF-";
    };
    auto* of_person = shell.find<QPushButton>("trainee_report");
    QVERIFY(of_person != nullptr && of_person->isEnabled());
    shell.save_as = shell.path("anna.pdf");
    QVERIFY(shell.click("trainee_report"));
    QVERIFY(shell.bannerSays("anna.pdf", 30));
    QVERIFY(is_pdf(shell.save_as));
    shell.find<QComboBox>("filter_person")->setCurrentIndex(0);
    QVERIFY(!of_person->isEnabled() && !of_person->toolTip().isEmpty());
    // Everybody, and a group by its name.
    const int64_t group = shell.owner().groups().create("Spring");
    QVERIFY(shell.click("rail_cohort"));
    QVERIFY(shell.arrives(PageId::kCohort));
    const auto* menu = shell.find<QPushButton>("cohort_report")->menu();
    QVERIFY(menu != nullptr);
    QCOMPARE(menu->actions().size(), 2);
    QCOMPARE(menu->actions()[1]->text(), QString("Of the group Spring"));
    for (int i = 0; i < 2; ++i) {
        shell.save_as = shell.path(QString("cohort_%1.pdf").arg(i));
        menu->actions()[i]->trigger();
        QVERIFY(shell.bannerSays(QString("cohort_%1.pdf").arg(i), 30));
        QVERIFY(is_pdf(shell.save_as));
    }
    const auto trail = shell.owner().audit().trail(3);
    QCOMPARE(trail[0].action, std::string("report.cohort"));
    QCOMPARE(trail[0].object, "group " + std::to_string(group));
    // Who is on another page before it is written has left an entry all the same.
    shell.save_as = shell.path("cohort_left.pdf");
    menu->actions()[0]->trigger();
    shell.window().open({PageId::kAccount, 0, {}, {}});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(QTest::qWaitFor([&] { return !shell.context().busy(); }, 30000));
    QVERIFY(is_pdf(shell.save_as));
    const auto later = shell.owner().audit().trail(1);
    QCOMPARE(later[0].action, std::string("report.cohort"));
    QCOMPARE(later[0].object, std::string("group 0"));
}

void ShellEducatorTest::standardComesFromTwoGroups() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_standards"));
    QVERIFY(shell.arrives(PageId::kStandards));
    QVERIFY(shell.find<QLabel>("cut_score") == nullptr);
    const auto put = [&](int first, int last, const char* button) {
        auto* people = shell.find<QTableWidget>("standard_people");
        people->clearSelection();
        people->setRangeSelected({first, 0, last, people->columnCount() - 1}, true);
        return shell.click(button);
    };
    QVERIFY(put(0, 1, "mark_novices"));
    QVERIFY(put(2, 3, "mark_experts"));
    QCOMPARE(shell.find<QTableWidget>("standard_people")->item(3, 3)->text(), QString("expert"));
    // Marked by hand, one after the other: not lost by a step aside.
    shell.refuseNext();
    QVERIFY(shell.click("rail_today"));
    QCOMPARE(shell.window().current(), PageId::kStandards);
    // Each person's mean of the last three attempts.
    const std::vector<double> novices{(39 + 42 + 41) / 3.0, (80 + 60 + 55) / 3.0},
        experts{(78 + 84 + 90) / 3.0, (82 + 88 + 91) / 3.0};
    const auto expected = assessment::contrasting_groups(novices, experts);
    QCOMPARE(shell.text("cut_score"),
             QString("Pass mark: %1 points").arg(QLocale().toString(expected.cut_score, 'f', 1)));
    QVERIFY(expected.cut_score > 65 && expected.cut_score < 84);
    for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell.fits());
        shell.whole(QString("82_standards_%1").arg(size.width()));
    }
    // It becomes the task's standard, with who and why in the audit; what holds stands above.
    QVERIFY(shell.text("standard_now").contains("None was set"));
    // Nobody has simulated these attempts again.
    QVERIFY(shell.click("set_standard"));
    QVERIFY(shell.bannerSays("were never simulated again"));
    for (const auto& each : shell.owner().attempts().list(0, kTask))
        shell.owner().attempts().set_replay(each.id, db::ReplayState::kIdentical);
    QVERIFY(shell.click("set_standard"));
    QVERIFY(shell.bannerSays("The standard is set (version 1)"));
    const auto set = db::standard_at(shell.owner(), kTask);
    QVERIFY(set.has_value());
    QCOMPARE(set->standard.pass_points, expected.cut_score);
    QCOMPARE(set->standard.novice.n, 2);
    QCOMPARE(set->set_by, std::string("demo.educator"));
    QVERIFY(shell.text("standard_now").contains("version 1, set by demo.educator"));
    QCOMPARE(shell.owner().audit().trail(1)[0].action, std::string("standard.publish"));
    QVERIFY(shell.click("set_standard"));
    QVERIFY(shell.bannerSays("reason"));  // The second one says why.
    // Two people are too few for norms.
    QVERIFY(shell.type("centre_name", "Gdansk"));
    QVERIFY(shell.click("make_norms"));
    QVERIFY(shell.bannerSays("at least"));
    shell.whole("82_standard_set");
    // Groups are kept when the theme was changed for the pictures; the wrong way round says why
    // not.
    QVERIFY(shell.find<QLabel>("cut_score") != nullptr);
    QVERIFY(put(0, 1, "mark_experts"));
    QVERIFY(put(2, 3, "mark_novices"));
    QVERIFY(shell.find<QLabel>("standard_problem") != nullptr ||
            shell.find<QLabel>("cut_score") != nullptr);
    QVERIFY(put(0, 3, "mark_neither"));
    QVERIFY(shell.find<QLabel>("cut_score") == nullptr);
    // The page of the task says whose mark it names, and the one that it has taken the place of.
    shell.window().open({PageId::kTask, 0, qstr(kTask), {}});
    QVERIFY(shell.arrives(PageId::kTask));
    QVERIFY(shell.text("pass_mark_set").contains("the task's own is 70 points"));
    QVERIFY(shell.click("rail_standards"));
    QVERIFY(shell.arrives(PageId::kStandards));
}

void ShellEducatorTest::aSmallPIsNotNought() {
    // Twelve against twelve without an overlap: p is 0.00004.
    std::vector<double> novices, experts;
    for (int i = 0; i < 12; ++i) {
        novices.push_back(30 + i);
        experts.push_back(70 + i);
    }
    const std::unique_ptr<QFrame> card(
        make_contrasting_card(shell_->context(), novices, experts, {}));
    QString said;
    for (const QLabel* label : card->findChildren<QLabel*>()) said += label->text() + "\n";
    QVERIFY2(said.contains("Mann-Whitney p < " + format_number(0.001, 3)), qPrintable(said));
}

void ShellEducatorTest::metricsWithoutEvidenceAreFlagged() {
    ShellHarness& shell = *shell_;
    auto* people = shell.find<QTableWidget>("standard_people");
    for (const auto& [first, button] : {std::pair{0, "mark_novices"}, {2, "mark_experts"}}) {
        people->clearSelection();
        people->setRangeSelected({first, 0, first + 1, people->columnCount() - 1}, true);
        QVERIFY(shell.click(button));
    }
    QVERIFY(shell.click("show_quality"));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QTableWidget>("quality_table") != nullptr; },
                            20000));
    auto* table = shell.find<QTableWidget>("quality_table");
    QCOMPARE(table->rowCount(), 2);  // Points, and the one metric of these attempts.
    QStringList evidence;
    for (int row = 0; row < table->rowCount(); ++row)
        evidence << table->item(row, 0)->text() + ": " + table->item(row, 5)->text();
    // The time was the same for everybody: it tells nobody apart.
    QVERIFY2(evidence.filter("Time: ▲ no").size() == 1, qPrintable(evidence.join("; ")));
    QVERIFY(shell.text("quality_said").contains("Metrics: 2"));
    shell.keep(shell.window().grab(), "82_quality_light");
}

void ShellEducatorTest::judgesEstimateAPassMark() {
    ShellHarness& shell = *shell_;
    auto* table = shell.find<QTableWidget>("angoff_table");
    const auto items = curriculum::load_task(kTask).rubric.items;
    QCOMPARE(table->rowCount(), static_cast<int>(items.size()));
    QCOMPARE(table->columnCount(), 4);  // Line, most points, two judges.
    QVERIFY(!shell.find<QPushButton>("set_angoff")->isEnabled());
    double all = 0, kept = 0;
    for (int row = 0; row < table->rowCount(); ++row) {
        const double weight = std::min(items[static_cast<size_t>(row)].max_points, 100.0);
        all += weight;
        kept += weight * (row % 2 == 0 ? 0.8 : 0.6);
        for (int judge = 0; judge < 2; ++judge)
            table->item(row, 2 + judge)->setText(row % 2 == 0 ? "80" : "60");
    }
    QCOMPARE(shell.text("angoff_mark"),
             QString("Pass mark: %1 points").arg(QLocale().toString(100 * kept / all, 'f', 1)));
    table->item(0, 2)->setText("180");
    QVERIFY(shell.text("angoff_said").contains("180 is no number from 0 to 100"));
    QVERIFY(!shell.find<QPushButton>("set_angoff")->isEnabled());
    table->item(0, 2)->setText("80");
    shell.scrollTo("set_angoff");
    shell.keep(shell.window().grab(), "82_angoff_light");
    // A standard of the groups, which makes the cards anew, takes nothing from the judges.
    const auto standard_is = [&shell](const char* version) {
        return QTest::qWaitFor([&] { return shell.text("standard_now").contains(version); }, 5000);
    };
    QVERIFY(shell.type("standard_reason", "The same groups once more"));
    QVERIFY(shell.click("set_standard"));
    QVERIFY(standard_is("version 2"));
    QCOMPARE(shell.find<QTableWidget>("angoff_table")->item(0, 2)->text(), QString("80"));
    QVERIFY(shell.type("angoff_reason", "Judges met in November"));
    QVERIFY(shell.click("set_angoff"));
    QVERIFY(shell.bannerSays("The standard is set (version 3)"));
    const auto set = db::standard_at(shell.owner(), kTask);
    QCOMPARE(set->standard.method, std::string("angoff"));
    QCOMPARE(set->standard.angoff.judges, 2);
    QVERIFY(standard_is("version 3"));
    QCOMPARE(shell.find<QTableWidget>("angoff_table")->item(0, 2)->text(), QString());
    for (const QSize size : {QSize(1920, 1080), QSize(1024, 768)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell.fits());
        shell.whole(QString("82_standards_all_%1").arg(size.width()));
    }
}

// A table of judges is half a day's work. It was gone after a lock, in the other language or theme,
// on another page, and with one key too many in "Judges" or in the list of tasks.
void ShellEducatorTest::estimatesStayUntilTheyAreSet() {
    ShellHarness shell;
    QVERIFY(shell.setUpWithDemonstration());
    for (const char* task : {kTask, "trace_contour"})
        add_attempt(shell.owner(), shell.idOf("ada"), task);
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    shell.window().open({PageId::kStandards, 0, {}, {{"task", kTask}}});
    QVERIFY(shell.arrives(PageId::kStandards));
    const auto table = [&shell] { return shell.find<QTableWidget>("angoff_table"); };
    const auto cell = [&table](int row, int column) { return table()->item(row, column)->text(); };
    table()->item(0, 2)->setText("80");
    table()->item(1, 3)->setText("60");
    for (const char* language : {"pl", "en"}) {
        shell.context().setLanguage(language);
        QVERIFY(shell.arrives(PageId::kStandards));
        QCOMPARE(cell(0, 2), QString("80"));
        QCOMPARE(cell(1, 3), QString("60"));
    }
    // A judge too many, and one too few: a column that comes back is filled as it was.
    auto* judges = shell.find<QSpinBox>("angoff_judges");
    judges->setValue(3);
    table()->item(0, 4)->setText("70");
    judges->setValue(2);
    // With two judges only two count.
    QCOMPARE(shell.text("angoff_said"),
             QString("Estimates that are missing: %1").arg(2 * table()->rowCount() - 2));
    shell.context().setTheme(ThemeKind::kDark);
    judges = shell.find<QSpinBox>("angoff_judges");
    QCOMPARE(judges->value(), 2);
    judges->setValue(3);
    QCOMPARE(cell(0, 4), QString("70"));
    // Another page and another task ask first.
    shell.refuseNext();
    shell.window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell.window().current() == PageId::kStandards);
    QCOMPARE(cell(0, 2), QString("80"));
    auto* tasks = shell.find<QComboBox>("standard_task");
    const int chosen = tasks->currentIndex();
    const Qt::Key key = chosen == 0 ? Qt::Key_Down : Qt::Key_Up;
    shell.refuseNext();
    QTest::keyClick(tasks, key);
    QCOMPARE(tasks->currentIndex(), chosen);
    QCOMPARE(cell(1, 3), QString("60"));
    shell.confirmNext();
    QTest::keyClick(tasks, key);
    QVERIFY(tasks->currentIndex() != chosen);
    QVERIFY(QTest::qWaitFor([&] { return cell(0, 2).isEmpty(); }, 5000));
    // Nothing is filled: nothing is asked.
    shell.window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kCohort));
}

void ShellEducatorTest::raterSeesNeitherNameNorScore() {
    ShellHarness& shell = *shell_;
    const size_t waiting = ids_.size();
    for (int rated = 0; rated < 3; ++rated) {
        QVERIFY(shell.click("rail_ratings"));
        QVERIFY(shell.arrives(PageId::kRatings));
        if (rated == 0) {
            shell.shot("83_ratings");
            for (const QLabel* label : shell.window().page()->findChildren<QLabel*>())
                for (const QString& name : kNames) QVERIFY(!label->text().contains(name));
        }
        QVERIFY(shell.click("rating_rate"));
        QVERIFY(shell.arrives(PageId::kParticipant));
        for (const QLabel* label : shell.window().page()->findChildren<QLabel*>())
            for (const QString& name : kNames) QVERIFY(!label->text().contains(name));
        if (rated == 0) shell.shot("84_rating_form");
        for (const auto& item : curriculum::load_questionnaire("osats").items) {
            auto* radio = shell.find<QRadioButton>(
                QString("answer_%1_%2").arg(item.id.c_str()).arg(2 + rated));
            QVERIFY(radio != nullptr);
            radio->click();
        }
        QVERIFY(shell.click("review"));
        QVERIFY(shell.click("submit_answers"));
        QVERIFY(shell.arrives(PageId::kRatings));
    }
    const auto ratings = shell.owner().reviews().ratings("osats");
    QCOMPARE(ratings.size(), size_t{3});
    for (const auto& rating : ratings) {
        QVERIFY(rating.blinded);
        QVERIFY(rating.answers.size() >= 5);
    }
    QCOMPARE(shell.find<QTableWidget>("rated")->rowCount(), 3);
    bool left = false;
    for (const QLabel* label : shell.window().page()->findChildren<QLabel*>())
        left = left || label->text() == QString("To be rated: %1").arg(waiting - 3);
    QVERIFY(left);
}

void ShellEducatorTest::agreementOfRatersIsTold() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.text("icc").contains("Two raters"));
    db::Store& store = shell.owner();
    const int64_t ada = store.accounts().find_login("ada")->id;
    // Ada agrees but for one step at one attempt.
    int shift = 0;
    for (auto rating : store.reviews().ratings("osats")) {
        rating.rater_id = ada;
        if (shift++ == 0)
            for (auto& [item, answer] : rating.answers) answer = "3";
        (void)store.reviews().save_rating(rating);
    }
    QVERIFY(shell.click("rail_ratings"));
    QVERIFY(QTest::qWaitFor([&] { return shell.text("icc").contains("ICC(2,1)"); }, 5000));
    QVERIFY(shell.text("icc").contains("attempts 3, raters 2"));
    for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
        shell.window().resize(size);
        QTest::qWait(80);
        QVERIFY(shell.fits());
    }
    shell.whole("85_ratings_icc");
    // A third rater judges the same three, a fourth one of them: three raters carry the most.
    for (const auto& [login, most] : {std::pair{"rita", 3}, std::pair{"rolf", 1}}) {
        add(login, login, {});
        const int64_t rater = store.accounts().find_login(login)->id;
        int judged = 0;
        for (auto rating : store.reviews().ratings("osats")) {
            if (rating.rater_id != ada || judged == most) continue;
            ++judged;
            rating.rater_id = rater;
            (void)store.reviews().save_rating(rating);
        }
    }
    QVERIFY(shell.click("rail_ratings"));
    QVERIFY(
        QTest::qWaitFor([&] { return shell.text("icc").contains("attempts 3, raters 3"); }, 5000));
}

bool ShellEducatorTest::search(const QString& words) {
    ShellHarness& shell = *shell_;
    // A shortcut needs an active window; without a window manager nobody activates it.
    QApplication::setActiveWindow(&shell.window());
    QTest::keyClick(&shell.window(), Qt::Key_K, Qt::ControlModifier);
    if (!QTest::qWaitFor([&] { return dialog() != nullptr; }, 3000)) return false;
    auto* field = dialog()->findChild<QLineEdit*>("search_text");
    QTest::keyClicks(field, words);
    // Attempts come from a worker: until then the line below the list says so.
    return QTest::qWaitFor(
        [&] {
            const auto* said = dialog()->findChild<QLabel*>("search_said");
            return shell_->context().workers().activeThreadCount() == 0 &&
                   !said->text().startsWith("Reading");
        },
        10000);
}

void ShellEducatorTest::searchOpensByKeyboardAlone() {
    ShellHarness& shell = *shell_;
    shell.window().resize(1366, 768);
    QVERIFY(search("ANNA"));
    auto* list = dialog()->findChild<QListWidget*>("search_list");
    // The person and the attempts.
    QVERIFY(QTest::qWaitFor([&] { return list->count() > 1; }, 10000));
    QVERIFY(list->item(0)->text().contains("Anna Stuck"));
    shell.keep(dialog()->grab(), "86_search_light");
    QTest::keyClick(dialog()->findChild<QLineEdit*>("search_text"), Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kAttempts));
    QCOMPARE(shell.find<QComboBox>("filter_person")->currentText(), kNames[0]);
    QVERIFY(search("standards"));
    QTest::keyClick(dialog()->findChild<QLineEdit*>("search_text"), Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kStandards));
    // Arrow down chooses the next one.
    QVERIFY(search("cleo"));
    auto* field = dialog()->findChild<QLineEdit*>("search_text");
    QVERIFY(QTest::qWaitFor(
        [&] { return dialog()->findChild<QListWidget*>("search_list")->count() > 1; }, 10000));
    QTest::keyClick(field, Qt::Key_Down);
    QCOMPARE(dialog()->findChild<QListWidget*>("search_list")->currentRow(), 1);
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return dialog() == nullptr; }, 3000));
    QVERIFY(shell.window().current() == PageId::kStandards);
}

void ShellEducatorTest::searchKeepsToTheRights() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(search("anna"));
    QCOMPARE(dialog()->findChild<QListWidget*>("search_list")->count(), 0);
    QTest::keyClick(dialog()->findChild<QLineEdit*>("search_text"), Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return dialog() == nullptr; }, 3000));
    QVERIFY(search("ring"));
    QVERIFY(QTest::qWaitFor(
        [&] { return dialog()->findChild<QListWidget*>("search_list")->count() >= 2; }, 10000));
    QTest::keyClick(dialog()->findChild<QLineEdit*>("search_text"), Qt::Key_Return);
    QVERIFY(shell.arrives(PageId::kTask));
}

void ShellEducatorTest::lastPageIsRemembered() {
    ShellHarness& shell = *shell_;
    QVERIFY(shell.click("rail_history"));
    QVERIFY(shell.arrives(PageId::kHistory));
    shell.start();
    QVERIFY(shell.signIn("demo.trainee", "placode-demo"));
    QVERIFY(shell.arrives(PageId::kHistory));
    // Of each user's own.
    QVERIFY(shell.signIn("demo.educator", "placode-demo"));
    QVERIFY(shell.arrives(PageId::kStandards));
}

// An empty table over three buttons that did nothing.
void ShellEducatorTest::aTaskThatNobodyCountsInSaysSo() {
    ShellHarness& shell = *shell_;
    db::AttemptResult idle;
    idle.header.task_id = "trace_contour";
    idle.header.device = "mouse";
    idle.header.started_utc = "2026-03-02T10:00:00Z";
    idle.end.reason = sim::EndReason::kFinished;
    idle.end.duration_s = 20;
    idle.score.verdict = assessment::Verdict::kNotAttempted;
    (void)shell.owner().attempts().save(shell.owner().accounts().find_login("anna")->id, idle);
    shell.window().open({PageId::kStandards, 0, {}, {{"task", "trace_contour"}}});
    QVERIFY(shell.arrives(PageId::kStandards));
    QVERIFY(QTest::qWaitFor([&] { return shell.find<QLabel>("standard_nobody") != nullptr; }));
    QVERIFY(shell.find<QTableWidget>("standard_people") == nullptr);
    QVERIFY(shell.find<QPushButton>("mark_novices") == nullptr);
}

// "Demonstra..." stood beside sixteen columns with room, and a long name before an empty bar.
void ShellEducatorTest::namesAreShownWhereThereIsRoom() {
    ShellHarness& shell = *shell_;
    const std::vector<std::string> tasks{"familiarisation", "grasp_and_lift", "irrigate",
                                         "patch_place",     "suture_bite",    "touch_targets"};
    const int64_t anna = shell.owner().accounts().find_login("anna")->id;
    uint64_t hash = 100;
    for (const std::string& task : tasks) {
        db::AttemptResult result;
        result.header.task_id = task;
        result.header.started_utc = "2026-03-03T10:00:00Z";
        result.end.reason = sim::EndReason::kFinished;
        result.end.duration_s = 200;
        result.end.final_hash = ++hash;
        result.score.points = 50;
        result.score.verdict = assessment::Verdict::kNotYet;
        (void)shell.owner().attempts().save(anna, result);
    }
    shell.window().resize(1024, 768);
    shell.window().open({PageId::kCohort, 0, {}, {}});
    QVERIFY(shell.arrives(PageId::kCohort));
    const auto* table = shell.find<QTableWidget>("cohort_table");
    QVERIFY(table != nullptr && table->columnCount() > 6);
    QTest::qWait(100);
    QVERIFY2(table->columnWidth(0) >= 170, qPrintable(QString::number(table->columnWidth(0))));
    shell.window().resize(1366, 768);
    const QString name = "Katarzyna Brzozowska-Nowakowska of Gdansk";
    add(name, "katarzyna", {});
    QVERIFY(shell.signIn("katarzyna", "first password"));
    QTRY_COMPARE(shell.find<QToolButton>("user_menu")->text(), name);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellEducatorTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_educator_test.moc"
