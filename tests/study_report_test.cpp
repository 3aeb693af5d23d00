// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The seed paper's table out of the reconstructed answers, through the store and onto paper; and
// every figure as a file with its data.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/study_report.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <QXmlStreamReader>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "db/standards.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "reports/csv_table.h"
#include "reports/export.h"
#include "reports/study_analysis.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using placode::test::read_text;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace THIS_TEST {

QApplication& application() {
    static int argc = 1;
    static char name[] = "study_report_test";
    static char* argv[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Never destroyed: the database drivers that Qt loaded go after it at exit, and would crash.
    static auto* app = new QApplication(argc, argv);
    return *app;
}

class StudyReportTest : public testing::Test {
 protected:
    void SetUp() override {
        application();
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        db::DefinitionRecord definition;
        definition.kind = "study";
        definition.id = kStudy;
        definition.version = curriculum::load_study(kStudy).version;
        definition.json = curriculum::load_study(kStudy).json;
        store->definitions().publish(definition);
    }
    /// 14 participants with the paper's reconstructed answers to the items A to F.
    void answer_as_the_paper() {
        const auto rows = reports::parse_csv(
            read_text(PLACODE_SOURCE_DIR "/tests/data/statistics/seed_face_validity_long.csv"));
        std::map<std::string, curriculum::Answers> people;
        for (size_t r = 1; r < rows.size(); ++r)
            people[rows[r].at(1)][rows[r].at(0)] = rows[r].at(2);
        ASSERT_EQ(people.size(), 14u);
        const auto face = curriculum::load_questionnaire("face_validity");
        const auto about = curriculum::load_questionnaire("demographics");
        int n = 0;
        for (auto& [slot, answers] : people) {
            for (const char* other :
                 {"useful_sb_repair", "useful_laparoscopic", "recommend", "useful_in_curricula"})
                answers[other] = "4";
            codes.push_back(store->studies().new_participant(kStudy, true));
            db::record_consent(*store, kStudy, codes.back(), "en", {"read", "voluntary", "data"});
            db::AnswerRecord record;
            record.study_id = kStudy;
            record.participant = codes.back();
            record.demonstration = true;
            record.questionnaire_id = face.id;
            record.answers = answers;
            db::submit_answers(*store, face, record);
            record.questionnaire_id = about.id;
            record.answers = {{"age", std::to_string(30 + n)},
                              {"gender", n < 4 ? "1" : "0"},
                              {"speciality", n < 8 ? "0" : "1"},
                              {"operative_years", "5"},
                              {"laparoscopic_cases", "1"},
                              {"fetoscopic_cases", "0"},
                              {"used_simulator", n % 2 == 0 ? "1" : "0"},
                              {"interest_vr", "4"},
                              {"interest_fetoscopic", "3"}};
            if (n % 2 == 0) record.answers["simulators"] = "0;1";
            db::submit_answers(*store, about, record);
            ++n;
        }
    }
    void add_attempts() {
        const int64_t user =
            store->accounts().create({"station", "Station", "correct horse", 1, true});
        for (size_t p = 0; p < 5; ++p) {
            for (int trial = 1; trial <= 3; ++trial) {
                db::AttemptResult result;
                result.header.task_id = "diathermy_ring";
                result.header.started_utc = "2026-11-21T10:0" + std::to_string(trial) + ":00.000Z";
                result.header.mode = "study";
                result.header.demonstration = true;
                result.end.duration_s = 90;
                result.score.points = 40 + 15 * trial + static_cast<double>(p);
                result.score.verdict =
                    trial == 3 ? assessment::Verdict::kPassed : assessment::Verdict::kNotYet;
                db::StepRecord step;
                step.study_id = kStudy;
                step.participant = codes[p];
                step.step = "procedure_" + std::to_string(trial);
                // They become the participant's with the step, and are then simulated again.
                step.attempt_id = test::save_recorded(*store, user, result, folder.path().string());
                store->studies().record_step(step);
                test::replay_as_identical(*store, step.attempt_id);
            }
        }
    }
    [[nodiscard]] reports::StudyReport report() const {
        return reports::read_study_report(*store, kStudy);
    }

    static constexpr const char* kStudy = "face_content_validity";
    test::TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    std::vector<std::string> codes;
};

const reports::ItemNumbers& item(const reports::StudyNumbers& numbers, const std::string& id) {
    for (const auto& form : numbers.forms)
        for (const auto& each : form.items)
            if (each.field->id == id) return each;
    throw std::runtime_error("no item " + id);
}

double percent(const assessment::Interval& interval, bool high) {
    return 100 * (high ? interval.high : interval.low);
}

TEST_F(StudyReportTest, ThePapersTableComesOutOfItsAnswers) {
    answer_as_the_paper();
    const auto made = report();
    const auto numbers = reports::study_numbers(made.data, made.instruments);
    // Printed means and SD. Half a unit of the second place; C is printed truncated (3.786
    // -> 3.78).
    struct Printed {
        const char* id;
        double mean, sd;
    };
    for (const Printed& printed : {Printed{"A", 3.93, 0.73},
                                   {"B", 4.14, 0.66},
                                   {"C", 3.78, 0.8},
                                   {"D", 4.64, 0.5},
                                   {"E", 4.21, 0.7},
                                   {"F", 4.07, 0.47}}) {
        const auto& found = item(numbers, printed.id);
        EXPECT_EQ(found.summary.n, 14);
        EXPECT_NEAR(*found.summary.mean, printed.mean, printed.id[0] == 'C' ? 0.01 : 0.005);
        EXPECT_NEAR(*found.summary.sd, printed.sd, 0.005);
    }
    // Closed forms with t(0.975; 13) = 2.160369 and z = 1.959964; in R t.test(x)$conf.int and
    // prop.test(13, 14, correct = FALSE)$conf.int.
    const auto& overall = item(numbers, "F");
    EXPECT_NEAR(overall.mean_ci95->low, 3.797385, 1e-5);
    EXPECT_NEAR(overall.mean_ci95->high, 4.345472, 1e-5);
    EXPECT_EQ(overall.summary.top2, 13);
    EXPECT_NEAR(percent(overall.top2_ci95, false), 68.53, 0.01);
    EXPECT_NEAR(percent(overall.top2_ci95, true), 98.73, 0.01);
}

TEST_F(StudyReportTest, GroupsAreComparedAndWhatASmallSampleCannotCarryIsSaid) {
    answer_as_the_paper();
    store->studies().withdraw(kStudy, codes[13], db::WithdrawalMode::kStop, "not given");
    const auto made = report();
    const auto numbers = reports::study_numbers(made.data, made.instruments);
    ASSERT_TRUE(numbers.comparison);
    EXPECT_EQ(numbers.comparison->by->id, "used_simulator");
    EXPECT_EQ(numbers.comparison->n1, 7);
    EXPECT_EQ(numbers.comparison->n2, 6);
    EXPECT_NEAR(numbers.comparison->least_p, 2.0 / 1716, 1e-9) << "13 choose 6 is 1716";
    for (const auto& row : numbers.comparison->rows) {
        EXPECT_GE(row.p_holm, row.p);
        EXPECT_GE(row.p, numbers.comparison->least_p - 1e-12);
        EXPECT_LE(std::abs(row.delta.delta), 1);
    }
    EXPECT_EQ(item(numbers, "A").summary.n, 13) << "who withdrew the data is in no table";
    std::string all;
    for (const std::string& each : numbers.cautions) all += each + "\n";
    EXPECT_THAT(
        all, testing::AllOf(HasSubstr("n = 13"), HasSubstr("simulated"), HasSubstr("exploratory"),
                            HasSubstr("omega"), HasSubstr("1 participant(s) withdrew"),
                            HasSubstr("recommend: all answers are equal")));
}

TEST(StudyNumbers, AnItemThatWasNotAskedIsNotMissing) {
    reports::Field field;
    field.id = "how";
    field.kind = reports::FieldKind::kCode;
    field.ordinal = true;
    for (int value = 1; value <= 5; ++value) field.codes.push_back({value, ""});
    reports::Form form;
    form.id = form.name = "branching";
    form.fields.push_back(field);
    for (const char* code : {"P001", "P002", "P003"}) {
        reports::Row row;
        row.participant = code;
        form.rows.push_back(row);
    }
    form.rows[0].values["how"] = "4";
    form.rows[1].not_asked.insert("how");
    reports::Dataset data;
    data.forms.push_back(form);
    const auto numbers = reports::study_numbers(data, {});
    EXPECT_EQ(item(numbers, "how").summary.n, 1);
    EXPECT_EQ(item(numbers, "how").summary.missing, 1) << "P003 was asked, P002 was not";
}

/// "form,field,statistic" to value.
std::map<std::string, double> table_of(const std::string& path) {
    std::map<std::string, double> table;
    const auto rows = reports::parse_csv(read_text(path));
    for (size_t r = 1; r < rows.size(); ++r)
        table[rows[r].at(0) + "," + rows[r].at(1) + "," + rows[r].at(2)] =
            curriculum::answer_number(rows[r].at(3)).value();
    return table;
}

TEST_F(StudyReportTest, EveryNumberIsReproducedByAnotherProgramFromTheCsv) {
    answer_as_the_paper();
    const auto made = report();
    const std::string figures = folder.file("figures"), csv = folder.file("csv");
    reports::write_study_figures(made, figures);
    reports::export_dataset({made.data, {}}, "csv", csv);
    const auto found = table_of(figures + "/numbers.csv");
    EXPECT_GT(found.size(), 200u);
    const std::string script = PLACODE_SOURCE_DIR "/scripts/study_report.R";
    // What R 4.2.2 found in the CSV of this very test, for machines without R. 1e-6 is the
    // tolerance of the script.
    const std::string kept = PLACODE_SOURCE_DIR "/tests/data/statistics/study_numbers_expected.csv";
    const auto same_as = [&](const std::string& path) {
        const auto other = table_of(path);
        ASSERT_EQ(other.size(), found.size());
        for (const auto& [key, value] : other) {
            ASSERT_TRUE(found.contains(key)) << key;
            EXPECT_NEAR(found.at(key), value, 1e-6 * std::max(1.0, std::abs(value))) << key;
        }
    };
    same_as(kept);
    const QString rscript = QStandardPaths::findExecutable("Rscript");
    if (rscript.isEmpty()) return;
    QProcess r;
    r.setProcessChannelMode(QProcess::MergedChannels);
    const QString from_r = QString::fromStdString(folder.file("r.csv"));
    r.start(rscript, {QString::fromStdString(script), QString::fromStdString(csv), kStudy,
                      QString::fromStdString(figures + "/numbers.csv"), from_r});
    ASSERT_TRUE(r.waitForFinished(120000));
    EXPECT_EQ(r.exitCode(), 0) << r.readAll().toStdString();
    if (qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS"))
        QFile::copy(from_r, qEnvironmentVariable("PLACODE_SCREENSHOTS") + "/study_numbers_r.csv");
    same_as(from_r.toStdString());
    // And it can fail: a number that is off by 0.001 is found.
    std::string wrong = read_text(figures + "/numbers.csv");
    const size_t at = wrong.find("face_validity,A,mean,3.92");
    ASSERT_NE(at, std::string::npos);
    wrong.replace(at, 25, "face_validity,A,mean,3.93");
    QFile file(QString::fromStdString(folder.file("wrong.csv")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(wrong));
    file.close();
    r.start(rscript, {PLACODE_SOURCE_DIR "/scripts/study_report.R", QString::fromStdString(csv),
                      kStudy, file.fileName()});
    ASSERT_TRUE(r.waitForFinished(120000));
    EXPECT_EQ(r.exitCode(), 1);
    EXPECT_THAT(r.readAll().toStdString(), HasSubstr("face_validity|A|mean"));
}

TEST_F(StudyReportTest, ThePdfHoldsMethodsFlowTablesAndVersions) {
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    answer_as_the_paper();
    add_attempts();
    const QString path = QString::fromStdString(folder.file("study.pdf"));
    std::vector<std::string> told;
    reports::write_study_pdf(
        report(), path.toStdString(),
        {{}, [&](const reports::ExportPart& part) { told.push_back(part.name); }});
    EXPECT_GE(told.size(), 3u) << "progress is told";
    if (qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS"))
        QFile::copy(path, qEnvironmentVariable("PLACODE_SCREENSHOTS") + "/study.pdf");
    QProcess process;
    process.start(pdftotext, {"-layout", path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput());
    for (const char* expected : {"DEMONSTRATION",
                                 "3.93 (0.73)",
                                 "4.14 (0.66)",
                                 "3.79 (0.80)",
                                 "4.64 (0.50)",
                                 "4.21 (0.70)",
                                 "4.07 (0.47)",
                                 "Wilson",
                                 "Student",
                                 "Feldt",
                                 "DeLong",
                                 "type 7",
                                 "enrolled (n = 14)",
                                 "consented (n = 14)",
                                 "analysed (n = 14)",
                                 "at most 120 s",
                                 "SHA-256",
                                 "Korzeniowski",
                                 "CUSUM",
                                 "h1 3.71",
                                 "What this sample can carry",
                                 "very unrealistic",
                                 "page 2"}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(expected))) << expected << "\nnot in\n"
                                                                << text.toStdString();
    }
}

TEST_F(StudyReportTest, DeviationsAreCountedAndListedAndNoAnalysisUsesWhatDoesNotCount) {
    answer_as_the_paper();
    add_attempts();
    const auto rows_that_count = [&] {
        const auto made = report();
        const reports::Form* attempts = made.data.form("attempts");
        return std::count_if(attempts->rows.begin(), attempts->rows.end(),
                             [](const reports::Row& row) { return row.counts; });
    };
    const auto before = rows_that_count();
    const auto learnt = reports::learning_curves(report(), {}).rows;
    store->records().repeat_step(kStudy, codes[0], 1, "procedure_3", "the pedal was unplugged");
    store->records().note_step(kStudy, codes[1], 1, "procedure_1", "coughed");
    EXPECT_EQ(rows_that_count(), before - 1);
    EXPECT_NE(reports::learning_curves(report(), {}).rows.at(0).at(1).text, learnt.at(0).at(1).text)
        << "one attempt less";
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    const QString path = QString::fromStdString(folder.file("study.pdf"));
    reports::write_study_pdf(report(), path.toStdString());
    if (qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS"))
        QFile::copy(path, qEnvironmentVariable("PLACODE_SCREENSHOTS") + "/study_deviations.pdf");
    QProcess process;
    process.start(pdftotext, {"-layout", path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput()).simplified();
    for (const char* expected :
         {"Deviations from the protocol", "Done again", "the pedal was unplugged", "coughed"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(expected))) << expected << "\nnot in\n"
                                                                << text.toStdString();
}

/// A study whose amendment makes a warm-up of the procedure, and asks after it, not before.
db::DefinitionRecord amended_study(int version) {
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = "amended";
    study.version = version;
    study.reason = "the committee asked for it";
    const std::string steps =
        version == 1
            ? R"({"id":"consent","kind":"consent"},{"id":"run","kind":"procedure",)"
              R"("title":{"en":"First look"},"task":"diathermy_ring"},{"id":"before",)"
              R"("kind":"questionnaire","title":{"en":"Asked before"},"questionnaire":"sus"})"
            : R"({"id":"agreement","kind":"consent"},{"id":"run","kind":"familiarisation",)"
              R"("title":{"en":"Warming up"},"task":"diathermy_ring","max_s":60},{"id":"after",)"
              R"("kind":"questionnaire","title":{"en":"Asked after"},"questionnaire":"sus"})";
    study.json = R"({"id":"amended","version":)" + std::to_string(version) +
                 R"(,"title":{"en":"t"},"consent":{"version":1,"information":[{"en":"i"}],)"
                 R"("statements":[{"id":"a","text":{"en":"yes"}}]},"steps":[)" +
                 steps + "]}";
    return study;
}

/// Somebody who is enrolled, consents, does "run" and answers.
std::string taken_part(db::Store& store) {
    const std::string code = store.studies().new_participant("amended", true);
    db::record_consent(store, "amended", code, "en", {"a"});
    db::StepRecord run;
    run.study_id = "amended";
    run.participant = code;
    run.step = "run";
    store.studies().record_step(run);
    const auto sus = curriculum::load_questionnaire("sus");
    db::AnswerRecord record;
    record.study_id = "amended";
    record.participant = code;
    record.demonstration = true;
    record.questionnaire_id = sus.id;
    for (const auto& each : sus.items) record.answers[each.id] = "3";
    db::submit_answers(store, sus, record);
    return code;
}

TEST_F(StudyReportTest, EverybodysStepsAreThoseOfTheirVersion) {
    store->definitions().publish(amended_study(1));
    const std::string first = taken_part(*store);
    using Reached = std::vector<std::pair<std::string, int>>;
    const auto flow = [&] {
        return reports::flow_numbers(reports::read_study_report(*store, "amended"));
    };
    const Reached once{{"First look", 1}, {"Asked before", 1}};
    EXPECT_EQ(flow().reached, once);
    store->definitions().publish(amended_study(2));
    EXPECT_EQ(flow().reached, once) << "nobody is enrolled under the amendment yet";
    EXPECT_EQ(flow().consented, 1);
    const std::string second = taken_part(*store);
    EXPECT_EQ(flow().reached, (Reached{{"First look", 1}, {"Asked before", 1}, {"Asked after", 1}}))
        << "a warm-up is no procedure";
    EXPECT_EQ(flow().consented, 2) << "each by the step of their version";
    for (const std::string& code : {first, second})
        store->records().note_step("amended", code, 1, "run", "coughed");

    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    const QString path = QString::fromStdString(folder.file("amended.pdf"));
    reports::write_study_pdf(reports::read_study_report(*store, "amended"), path.toStdString());
    QProcess process;
    process.start(pdftotext, {"-layout", path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput()).simplified();
    for (const std::string& expected :
         {std::string("protocol version 1 (n = 1) went through: consent, First look"),
          std::string("protocol version 2 (n = 1) went through: agreement, Warming up"),
          first + " First look", second + " Warming up"})
        EXPECT_TRUE(text.contains(QString::fromStdString(expected))) << expected << "\nnot in\n"
                                                                     << text.toStdString();
}

TEST_F(StudyReportTest, AnAttemptThatDoesNotCountIsNotSaidToBeAnalysed) {
    const std::string code = store->studies().new_participant(kStudy, true);
    db::record_consent(*store, kStudy, code, "en", {"read", "voluntary", "data"});
    const int64_t user = store->accounts().create({"station", "Station", "correct horse", 1, true});
    db::AttemptResult result;
    result.header.task_id = "diathermy_ring";
    result.header.started_utc = "2026-11-21T10:00:00.000Z";
    result.header.demonstration = true;
    result.end.duration_s = 2;
    result.end.reason = sim::EndReason::kInterrupted;
    db::StepRecord step;
    step.study_id = kStudy;
    step.participant = code;
    step.step = "procedure_1";
    step.attempt_id = store->attempts().save(user, result);
    db::record_attempt_step(*store, step);
    EXPECT_EQ(reports::learning_curves(report(), {}).problem,
              "There are attempts, but none of them counts.");
    const QString pdftotext = QStandardPaths::findExecutable("pdftotext");
    if (pdftotext.isEmpty()) GTEST_SKIP() << "pdftotext (package poppler-utils) is not installed";
    const QString path = QString::fromStdString(folder.file("study.pdf"));
    reports::write_study_pdf(report(), path.toStdString());
    QProcess process;
    process.start(pdftotext, {"-layout", path, "-"});
    ASSERT_TRUE(process.waitForFinished());
    const QString text = QString::fromUtf8(process.readAllStandardOutput()).simplified();
    for (const char* expected :
         {"answers or attempts analysed (n = 0)", "1 attempt (1 of them does not count)"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(expected))) << expected << "\nnot in\n"
                                                                << text.toStdString();
}

TEST_F(StudyReportTest, ThePassMarkIsTheOneThatJudgedTheAttempts) {
    const std::string task = "diathermy_ring";
    const curriculum::Task asked = curriculum::load_task(task);
    const std::string code = store->studies().new_participant(kStudy, true);
    db::record_consent(*store, kStudy, code, "en", {"read", "voluntary", "data"});
    const int64_t user = store->accounts().create({"station", "Station", "correct horse", 1, true});
    const auto perform = [&](const std::string& step_id, const std::string& started_utc) {
        db::AttemptResult result;
        result.header.task_id = task;
        result.header.task_version = asked.version;
        result.header.started_utc = started_utc;
        result.header.mode = "study";
        result.header.demonstration = true;
        result.end.duration_s = 90;
        result.score.points = 75;
        result.score.verdict = assessment::Verdict::kPassed;
        db::StepRecord step;
        step.study_id = kStudy;
        step.participant = code;
        step.step = step_id;
        step.attempt_id = test::save_recorded(*store, user, result, folder.path().string());
        store->studies().record_step(step);
        test::replay_as_identical(*store, step.attempt_id);
    };
    EXPECT_FALSE(report().pass_mark(task)) << "nobody was judged yet";
    perform("procedure_1", "2020-01-01T10:00:00.000Z");
    EXPECT_EQ(report().pass_mark(task), asked.rubric.pass_points);
    curriculum::PassStandard standard;
    standard.task_id = task;
    standard.pass_points = 81;
    standard.novice = {8, 40, 10, 0.05, 0.1};
    standard.expert = {8, 90, 5, 0.04, 0.1};
    db::set_standard(*store, standard, "");
    EXPECT_EQ(report().pass_mark(task), asked.rubric.pass_points) << "it was judged before";
    perform("procedure_2", "2099-01-01T10:00:00.000Z");
    EXPECT_FALSE(report().pass_mark(task)) << "two marks: neither is drawn as the mark";
}

TEST_F(StudyReportTest, FiguresComeAllOfThemOrNone) {
    answer_as_the_paper();
    const reports::StudyReport made = report();
    const std::string place = folder.file("figures");
    const auto refused = [&] {
        try {
            reports::write_study_figures(made, place);
        } catch (const reports::ReportError& error) {
            return std::string(error.what());
        }
        return std::string("written");
    };
    // A disk that takes no more: no file of this process may be larger.
    const auto before_signal = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{500, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string said = refused();
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, before_signal);
    EXPECT_THAT(said, testing::StartsWith("write " + place + "/flow."));
    EXPECT_THAT(said, HasSubstr("free space"));
    EXPECT_FALSE(fs::exists(place)) << "it was made for nothing";
    // What is in the way of the last file shows before the first is there.
    fs::create_directories(place + "/numbers.csv");
    std::ofstream(place + "/flow.svg") << "of last year";
    EXPECT_THAT(refused(), testing::StartsWith("export to " + place + "/numbers.csv: "));
    EXPECT_EQ(read_text(place + "/flow.svg"), "of last year");
    EXPECT_EQ(std::distance(fs::directory_iterator(place), {}), 2);
    fs::remove(place + "/numbers.csv");
    EXPECT_EQ(refused(), "written");
    EXPECT_THAT(read_text(place + "/flow.svg"), HasSubstr("<svg"));
    for (const auto& entry : fs::directory_iterator(place))
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry << " is left";
}

TEST_F(StudyReportTest, WhatIsStoppedLeavesWhatWasThere) {
    answer_as_the_paper();
    const reports::StudyReport made = report();
    const std::string pdf = folder.file("study.pdf"), place = folder.file("figures");
    std::ofstream(pdf) << "of last year";
    int asked = 0;
    const reports::ExportPace third{[&] { return ++asked == 3; }, {}};
    EXPECT_THROW(reports::write_study_pdf(made, pdf, third), reports::ExportStopped);
    EXPECT_EQ(read_text(pdf), "of last year");
    asked = 0;
    EXPECT_THROW(reports::write_study_figures(made, place, third), reports::ExportStopped);
    EXPECT_EQ(asked, 3);
    EXPECT_FALSE(fs::exists(place));
}

TEST_F(StudyReportTest, EveryFigureIsSvgPngAndDataAndSaysDemonstration) {
    answer_as_the_paper();
    add_attempts();
    const std::string place = qEnvironmentVariableIsSet("PLACODE_SCREENSHOTS")
                                  ? qEnvironmentVariable("PLACODE_SCREENSHOTS").toStdString()
                                  : folder.file("figures");
    const mode_t before = ::umask(022);
    const auto paths = reports::write_study_figures(report(), place);
    ::umask(before);
    std::set<std::string> stems;
    for (const std::string& path : paths) {
        ASSERT_TRUE(fs::exists(path)) << path;
        EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600)) << path;
        stems.insert(fs::path(path).stem().string());
        if (path.ends_with(".svg")) {
            QXmlStreamReader xml(QByteArray::fromStdString(read_text(path)));
            while (!xml.atEnd()) xml.readNext();
            EXPECT_FALSE(xml.hasError()) << path << ": " << xml.errorString().toStdString();
            EXPECT_THAT(read_text(path), HasSubstr("DEMONSTRATION")) << path;
        } else if (path.ends_with(".png")) {
            const QImage image(QString::fromStdString(path));
            EXPECT_GE(image.width(), 2000) << path;
        } else {
            EXPECT_GE(reports::parse_csv(read_text(path)).size(), 2u) << path;
        }
    }
    for (const char* needed :
         {"flow", "likert_face_validity_1", "scales_face_validity", "strip_demographics_age",
          "forest_face_validity", "learning_attempts"})
        EXPECT_TRUE(stems.contains(needed)) << needed;
    const auto rows = reports::parse_csv(read_text(place + "/likert_face_validity_1.csv"));
    int sum = 0;
    for (size_t r = 1; r < rows.size(); ++r)
        if (rows[r][0] == "A") sum += std::stoi(rows[r][2]) * std::stoi(rows[r][3]);
    EXPECT_EQ(sum, 55) << "14 answers with mean 3.93";
}

TEST(LikertFigure, OrderShowsInGrey) {
    application();
    // One bar a value: the whole bar has the colour of that value.
    const reports::ChartStyle style;
    std::vector<int> grey;
    for (int value = 0; value < 5; ++value) {
        std::vector<int> counts(5, 0);
        counts[static_cast<size_t>(value)] = 10;
        const auto figure = reports::likert_figure(
            "x", "x", {{"A", "x", 1, counts, "low", "high", 0, {}, {}}}, style);
        QImage image(static_cast<int>(figure.width), static_cast<int>(figure.height),
                     QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        figure.draw(painter, QRectF(0, 0, figure.width, figure.height));
        painter.end();
        std::map<QRgb, int> count;
        for (int y = 26; y < image.height() - 34; ++y)
            for (int x = 250; x < image.width() - 118; ++x) ++count[image.pixel(x, y)];
        count.erase(qRgb(255, 255, 255));
        const auto most = std::max_element(count.begin(), count.end(),
                                           [](auto& a, auto& b) { return a.second < b.second; });
        grey.push_back(qGray(most->first));
    }
    EXPECT_LT(grey[0] + 25, grey[1]) << "darker towards the low end";
    EXPECT_LT(grey[4] + 25, grey[3]) << "darker towards the high end";
    EXPECT_GT(std::abs(grey[2] - grey[1]), 15) << "the middle stands out";
    EXPECT_GT(std::abs(grey[2] - grey[3]), 15);
}

TEST(ForestFigure, WhatLiesBeyondTheAxisIsAnArrowAtItsEnd) {
    application();
    const reports::ChartStyle style;
    // Columns of pixels in the accent's colour, of one row on an axis from -6 to 6.
    const auto columns = [&](double estimate, double low, double high) {
        const auto figure = reports::forest_figure(
            "x", "x", "g", {{"A", estimate, low, high, "", false}}, -6, 6, style);
        QImage image(static_cast<int>(figure.width), static_cast<int>(figure.height),
                     QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        figure.draw(painter, QRectF(0, 0, figure.width, figure.height));
        painter.end();
        std::map<int, int> found;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixel(x, y) == (style.accent | 0xff000000)) ++found[x];
        return found;
    };
    constexpr int kLeft = 230, kRight = 680 - 190;  // Of the axis.
    const auto whole = columns(64, 22, 107);
    ASSERT_FALSE(whole.empty());
    EXPECT_GT(whole.begin()->first, kRight - 12) << "nothing but the arrow";
    EXPECT_LE(whole.rbegin()->first, kRight + 1);
    EXPECT_GT(whole.begin()->second, whole.rbegin()->second) << "it points to the right";
    const auto cut = columns(-2, -9, 1);
    ASSERT_FALSE(cut.empty());
    EXPECT_NEAR(cut.begin()->first, kLeft, 2) << "it goes on beyond the end";
    EXPECT_LT(cut.rbegin()->first, kLeft + 160) << "the upper end is where it was";
}

}  // namespace THIS_TEST
