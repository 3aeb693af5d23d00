// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which course the page Today is about: what this person has to do, whoever sat there before.

#include <QApplication>

#include "db/sql_connection.h"
#include "shell_harness.h"
#include "ui/shell/result_standing.h"
#include "ui/shell/training.h"

namespace placode::ui {

namespace {
constexpr const char* kPassword = "quiet river 7";
}

class ShellTodayTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase() { shell_.reset(); }

    void anotherTraineesChoiceIsNotMine();
    void aFinishedCourseGivesWayToOneThatIsToBeDone();
    void cardsStayAsHighAsTheirWords();

 private:
    [[nodiscard]] int64_t person(const std::string& login) const;
    /// Publishes a course of one task in which any finished attempt counts, and assigns it.
    void assign(int64_t user, const std::string& id, const std::string& task,
                const std::string& due) const;
    void practise(int64_t user, const std::string& task,
                  assessment::Verdict verdict = assessment::Verdict::kPassed) const;
    [[nodiscard]] std::string today() const { return load_training(shell_->context()).course.id; }

    std::unique_ptr<ShellHarness> shell_;
};

void ShellTodayTest::initTestCase() {
    shell_ = std::make_unique<ShellHarness>();
    QVERIFY(shell_->setUpWithDemonstration());
}

int64_t ShellTodayTest::person(const std::string& login) const {
    return shell_->owner().accounts().create(
        {login, "Trainee " + login, kPassword, static_cast<db::Roles>(db::Role::kTrainee), false});
}

void ShellTodayTest::assign(int64_t user, const std::string& id, const std::string& task,
                            const std::string& due) const {
    db::DefinitionRecord course;
    course.kind = "course";
    course.id = id;
    course.version = 1;
    course.json = R"({"id":")" + id + R"(","version":1,"title":{"en":")" + id +
                  R"("},"stages":[{"task_id":")" + task +
                  R"(","mode":"familiarisation","consecutive":1}]})";
    course.reason = "test";
    if (!shell_->owner().definitions().find("course", id))
        shell_->owner().definitions().publish(course);
    db::AssignmentRecord assignment;
    assignment.course_id = id;
    assignment.course_version = 1;
    assignment.user_id = user;
    assignment.due_utc = due;
    shell_->owner().courses().assign(assignment);
}

void ShellTodayTest::practise(int64_t user, const std::string& task,
                              assessment::Verdict verdict) const {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.started_utc = db::utc_now();
    result.score.points = 80;
    result.score.verdict = verdict;
    result.end.reason = sim::EndReason::kFinished;
    result.end.duration_s = 40;
    static uint64_t hash = 10;
    result.end.final_hash = ++hash;
    (void)shell_->owner().attempts().save(user, result);
}

void ShellTodayTest::anotherTraineesChoiceIsNotMine() {
    const int64_t anna = person("anna"), jan = person("jan");
    for (const int64_t each : {anna, jan}) assign(each, "of_both", "touch_targets", "2099-01-01");
    QVERIFY(shell_->signIn("anna", kPassword));
    QCOMPARE(today(), std::string("of_both"));
    shell_->window().open({PageId::kCourse, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kCourse));
    auto* chooser = shell_->window().page()->findChild<QComboBox*>();
    QVERIFY(chooser != nullptr && chooser->findData("first_steps") >= 0);
    chooser->setCurrentIndex(chooser->findData("first_steps"));
    Q_EMIT chooser->activated(chooser->currentIndex());
    QCOMPARE(today(), std::string("first_steps"));
    QVERIFY(shell_->signIn("jan", kPassword));
    QCOMPARE(today(), std::string("of_both"));
    QVERIFY(shell_->signIn("anna", kPassword));
    QCOMPARE(today(), std::string("first_steps"));
}

// Without a chart below them they took half of what was left of the window, and stood there empty.
void ShellTodayTest::cardsStayAsHighAsTheirWords() {
    (void)person("eva");
    QVERIFY(shell_->signIn("eva", kPassword));
    shell_->window().open({PageId::kToday, 0, {}, {}});
    QVERIFY(shell_->arrives(PageId::kToday));
    const auto height = [&](int window) {
        shell_->window().resize(1600, window);
        QTest::qWait(200);
        const auto* words = shell_->find<QLabel>("today_streak");
        return words != nullptr ? words->parentWidget()->height() : -1;
    };
    const int low = height(800), high = height(1000);
    QVERIFY(low > 0);
    QCOMPARE(high, low);
}

void ShellTodayTest::aFinishedCourseGivesWayToOneThatIsToBeDone() {
    const int64_t ola = person("ola");
    assign(ola, "due_first", "trace_contour", "2099-01-01");
    assign(ola, "due_later", "grasp_and_lift", "2099-02-01");
    QVERIFY(shell_->signIn("ola", kPassword));
    QCOMPARE(today(), std::string("due_first"));
    practise(ola, "trace_contour");
    QCOMPARE(today(), std::string("due_later"));
    // The result is still about the course that it finished.
    const auto attempts = shell_->owner().attempts().list(ola);
    QVERIFY(
        course_words(shell_->context(), attempts.back()).startsWith("Mastered in the course: "));
    QCOMPARE(load_training(shell_->context()).next.kind, curriculum::NextKind::kStart);
    practise(ola, "grasp_and_lift");
    QCOMPARE(today(), std::string("due_first"));
    // A failure is not headed by what an earlier attempt has mastered.
    practise(ola, "trace_contour", assessment::Verdict::kFailed);
    const QString failed =
        course_words(shell_->context(), shell_->owner().attempts().list(ola).back());
    QVERIFY2(failed.startsWith("This attempt failed; "), qPrintable(failed));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellTodayTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_today_test.moc"
