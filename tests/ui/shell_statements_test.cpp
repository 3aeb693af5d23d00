// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a page asks while somebody waits for it does not grow with the rows: on a server elsewhere
// each statement takes 50 ms, and the windows stand still meanwhile. Counted, never timed.

#include "curriculum/questionnaire.h"
#include "db/statement_count.h"
#include "shell_harness.h"
#include "ui/shell/training.h"

namespace placode::ui {

/// The session is asked for once a second, however many rows there are.
constexpr int64_t kOfTheSession = 8;

class ShellStatementsTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void newRemarksAreOneQuestion();
    void olderRatedAttemptsAreOneQuestion();
    void studiesAreOneQuestionAndAStudyIsReadBesideItsPage();
    void proceduresOfAParticipantAreOneQuestion();

 private:
    int64_t add(const char* started_utc);
    void rate(int64_t attempt);
    /// Statements of this thread until the page stands there; -1: it did not come.
    int64_t costOf(const Place& place);

    std::unique_ptr<ShellHarness> shell_;
    int64_t trainee_ = 0, educator_ = 0;
};

void ShellStatementsTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
    db::NewUser nina;
    nina.login = "nina";
    nina.display_name = "Nina Nowak";
    nina.password = "quiet river 7";
    trainee_ = shell_->owner().accounts().create(nina);
    educator_ = shell_->idOf("demo.educator");
}

int64_t ShellStatementsTest::add(const char* started_utc) {
    db::AttemptResult result;
    result.header.task_id = "touch_targets";
    result.header.device = "mouse";
    result.header.started_utc = started_utc;
    result.end = {sim::EndReason::kFinished, 20, 7, 0};
    result.score.rubric_id = "touch_targets";
    result.score.verdict = assessment::Verdict::kPassed;
    return shell_->owner().attempts().save(trainee_, result);
}

void ShellStatementsTest::rate(int64_t attempt) {
    db::RatingRecord rating;
    rating.attempt_id = attempt;
    rating.rater_id = educator_;
    const auto form = curriculum::load_questionnaire("osats");
    rating.questionnaire_id = form.id;
    rating.questionnaire_version = form.version;
    for (const auto& item : form.items) rating.answers[item.id] = "4";
    shell_->owner().reviews().save_rating(rating);
}

int64_t ShellStatementsTest::costOf(const Place& place) {
    shell_->window().open({PageId::kAccount, 0, {}, {}});
    if (!shell_->arrives(PageId::kAccount)) return -1;
    const int64_t before = db::statements_sent();
    shell_->window().open(place);
    const int64_t sent = db::statements_sent() - before;
    return shell_->arrives(place.page) ? sent : -1;
}

void ShellStatementsTest::newRemarksAreOneQuestion() {
    for (int i = 0; i < 30; ++i) {
        const int64_t id = add("2026-03-01T10:00:00Z");
        shell_->owner().reviews().add_comment({0, id, educator_, "", -1, "Calm and even.", ""});
    }
    QVERIFY(shell_->signIn("nina", "quiet river 7"));
    const auto own = shell_->owner().attempts().list(trainee_);
    QCOMPARE(own.size(), size_t{30});
    const std::vector<db::AttemptRecord> two(own.end() - 2, own.end());
    int64_t before = db::statements_sent();
    const NewRemarks few = new_remarks(shell_->context(), two);
    const int64_t of_two = db::statements_sent() - before;
    before = db::statements_sent();
    const NewRemarks all = new_remarks(shell_->context(), own);
    const int64_t of_all = db::statements_sent() - before;
    QVERIFY2(of_all <= of_two + kOfTheSession, qPrintable(QString::number(of_all)));
    QCOMPARE(few.count, 2);
    QCOMPARE(all.count, 30);
    QCOMPARE(all.attempt_id, few.attempt_id);
}

void ShellStatementsTest::olderRatedAttemptsAreOneQuestion() {
    std::vector<int64_t> old;
    for (int i = 0; i < 30; ++i) old.push_back(add("2025-01-01T10:00:00Z"));
    for (int i = 0; i < 500; ++i) add("2026-04-01T10:00:00Z");
    for (size_t i = 0; i < 2; ++i) rate(old[i]);
    QVERIFY(shell_->signIn("demo.educator", "placode-demo"));
    const int64_t of_two = costOf({PageId::kRatings, 0, {}, {}});
    QVERIFY(of_two > 0);
    QCOMPARE(shell_->find<QTableWidget>("rated")->rowCount(), 2);
    for (size_t i = 2; i < old.size(); ++i) rate(old[i]);
    const int64_t of_all = costOf({PageId::kRatings, 0, {}, {}});
    QVERIFY2(of_all > 0 && of_all <= of_two + kOfTheSession, qPrintable(QString::number(of_all)));
    QCOMPARE(shell_->find<QTableWidget>("rated")->rowCount(), 30);
}

void ShellStatementsTest::studiesAreOneQuestionAndAStudyIsReadBesideItsPage() {
    // The first by name is the one that is shown.
    const auto enrol = [this](int i) {
        (void)shell_->owner().studies().new_participant(
            QString("study_%1").arg(100 + i).toStdString());
    };
    for (int i = 0; i < 2; ++i) enrol(i);
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    const int64_t of_two = costOf({PageId::kStudyResults, 0, {}, {}});
    QVERIFY(of_two > 0);
    QVERIFY(shell_->context().busy());
    QVERIFY(!shell_->find<QPushButton>("save_results")->isEnabled());
    QCOMPARE(shell_->text("results_outcome"), QString("Reading the study …"));
    QVERIFY(QTest::qWaitFor([this] { return !shell_->context().busy(); }, 60000));
    QVERIFY(shell_->find<QLabel>("results_outcome") == nullptr);
    QVERIFY(shell_->find<QPushButton>("save_results")->isEnabled());
    QVERIFY(shell_->find<QPushButton>("view_figures") != nullptr);
    for (int i = 2; i < 30; ++i) enrol(i);
    const int64_t of_all = costOf({PageId::kStudyResults, 0, {}, {}});
    QVERIFY2(of_all > 0 && of_all <= of_two + kOfTheSession, qPrintable(QString::number(of_all)));
    QVERIFY(shell_->find<QComboBox>("study_chooser")->count() >= 30);
}

void ShellStatementsTest::proceduresOfAParticipantAreOneQuestion() {
    const std::string study = "procedures", code = shell_->owner().studies().new_participant(study);
    int done = 0;
    const auto perform = [&](int n) {
        for (; done < n; ++done) {
            db::AttemptResult result;
            result.header.task_id = "touch_targets";
            result.header.device = "mouse";
            result.header.started_utc = "2026-03-01T10:00:00Z";
            result.end = {sim::EndReason::kFinished, 20, 7, 0};
            result.score.rubric_id = "touch_targets";
            result.study = {study, code};
            db::StepRecord step;
            step.study_id = study;
            step.participant = code;
            step.step = "run " + std::to_string(done);
            step.attempt_id = shell_->owner().attempts().save(educator_, result);
            shell_->owner().studies().record_step(step);
        }
    };
    const Place place{PageId::kStudyData, 0, {}, {{"study", QString::fromStdString(study)}}};
    perform(2);
    QVERIFY(shell_->signIn("demo.coordinator", "placode-demo"));
    const int64_t of_two = costOf(place);
    QVERIFY(of_two > 0);
    QCOMPARE(shell_->find<QTableWidget>("procedures_table")->rowCount(), 2);
    perform(30);
    const int64_t of_all = costOf(place);
    QVERIFY2(of_all > 0 && of_all <= of_two + kOfTheSession, qPrintable(QString::number(of_all)));
    QCOMPARE(shell_->find<QTableWidget>("procedures_table")->rowCount(), 30);
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication app(argc, argv);
    placode::ui::ShellStatementsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_statements_test.moc"
