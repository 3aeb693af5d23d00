// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper about a cohort and about one trainee, read back by its text.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/cohort_report.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QProcess>
#include <QStandardPaths>

#include "curriculum/task.h"
#include "db/standards.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

constexpr const char* kTask = "diathermy_ring";
constexpr const char* kNow = "2099-02-01T00:00:00Z";

class CohortReportTest : public testing::Test {
 protected:
    void SetUp() override {
        static int argc = 1;
        static char name[] = "cohort_report_test";
        static char* argv[] = {name, nullptr};
        qputenv("QT_QPA_PLATFORM", "offscreen");
        // Never destroyed: the database drivers that Qt loaded go after it at exit.
        static auto* app = new QApplication(argc, argv);
        (void)app;
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        anna = store->accounts().create({"anna", "Anna", "correct horse", 1, false});
    }
    void perform(const std::string& started_utc) {
        db::AttemptResult result;
        result.header.task_id = kTask;
        result.header.task_version = task.version;
        result.header.started_utc = started_utc;
        result.end.duration_s = 90;
        result.score.points = 75;
        result.score.verdict = assessment::Verdict::kNotYet;
        test::save_recorded(*store, anna, result, folder.path().string());
    }
    void set_mark(double points) {
        curriculum::PassStandard standard;
        standard.task_id = kTask;
        standard.pass_points = points;
        standard.novice = {8, 40, 10, 0.05, 0.1};
        standard.expert = {8, 90, 5, 0.04, 0.1};
        db::set_standard(*store, standard, "");
    }
    [[nodiscard]] reports::CohortReport cohort() {
        return reports::read_cohort_report(*store, 0, kNow);
    }
    [[nodiscard]] reports::TraineeReport trainee() {
        return reports::read_trainee_report(*store, *store->accounts().find(anna), kNow);
    }
    /// The words of both documents.
    [[nodiscard]] std::vector<std::string> texts(const QString& pdftotext) {
        reports::write_cohort_pdf(cohort(), folder.file("cohort.pdf"));
        reports::write_trainee_pdf(trainee(), folder.file("trainee.pdf"));
        std::vector<std::string> found;
        for (const char* file : {"cohort.pdf", "trainee.pdf"}) {
            QProcess process;
            process.start(pdftotext, {"-layout", QString::fromStdString(folder.file(file)), "-"});
            EXPECT_TRUE(process.waitForFinished());
            found.push_back(
                QString::fromUtf8(process.readAllStandardOutput()).simplified().toStdString());
            EXPECT_THAT(found.back(), HasSubstr("Learning curves, diathermy_ring")) << file;
        }
        return found;
    }

    test::TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    curriculum::Task task = curriculum::load_task(kTask);
    int64_t anna = 0;
};

TEST_F(CohortReportTest, ThePassMarkIsTheOneThatJudgedTheAttempts) {
    EXPECT_FALSE(cohort().pass_marks.of(kTask)) << "nobody was judged yet";
    set_mark(82.3);
    perform("2099-01-01T10:00:00.000Z");
    EXPECT_EQ(cohort().pass_marks.of(kTask), 82.3);
    EXPECT_EQ(trainee().pass_marks.of(kTask), 82.3);
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    for (const std::string& text : texts(pdftotext))
        EXPECT_THAT(text, HasSubstr("pass mark of the task: 82.3"));
}

TEST_F(CohortReportTest, UnderTwoMarksNoneIsDrawn) {
    for (const char* day : {"01", "02", "03"})
        perform("2020-01-" + std::string(day) + "T10:00:00.000Z");
    EXPECT_EQ(cohort().pass_marks.of(kTask), task.rubric.pass_points) << "the rubric's own";
    set_mark(82.3);
    EXPECT_EQ(cohort().pass_marks.of(kTask), task.rubric.pass_points) << "they were judged before";
    perform("2099-01-01T10:00:00.000Z");
    EXPECT_FALSE(cohort().pass_marks.of(kTask));
    EXPECT_FALSE(trainee().pass_marks.of(kTask));
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    for (const std::string& text : texts(pdftotext))
        EXPECT_THAT(text, Not(HasSubstr("pass mark of the task")));
}

TEST_F(CohortReportTest, AStandardWithTheSameMarkIsNoOtherMark) {
    set_mark(task.rubric.pass_points);
    perform("2020-01-01T10:00:00.000Z");
    perform("2099-01-01T10:00:00.000Z");
    EXPECT_EQ(cohort().pass_marks.of(kTask), task.rubric.pass_points);
}

}  // namespace THIS_TEST
