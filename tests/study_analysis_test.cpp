// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The analyses on numbers whose answers are known: closed forms, and Shrout & Fleiss' own table.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/study_analysis.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "reports/csv_table.h"
#include "reports/export.h"
#include "tests/store_fixture.h"

using namespace placode;
using testing::HasSubstr;

namespace THIS_TEST {

/// `people` participants with `trials` attempts each; points(person, trial) says the score.
/// @param tasks in turn, one a trial.
template <class Points>
reports::StudyReport study_with(int people, int trials, Points points,
                                const std::vector<std::string>& tasks = {"ring"}) {
    reports::StudyReport report;
    std::vector<std::string> owners;
    for (int person = 0; person < people; ++person) {
        const std::string code = "P" + std::to_string(person);
        for (int trial = 0; trial < trials; ++trial) {
            db::AttemptDetail attempt;
            attempt.record.id = 100 * person + trial + 1;
            attempt.record.task_id = tasks[static_cast<size_t>(trial) % tasks.size()];
            attempt.record.started_utc = "2026-01-01T00:00:0" + std::to_string(trial) + "Z";
            attempt.record.device = person % 2 == 0 ? "script:novice" : "script:expert";
            attempt.record.points = points(person, trial);
            attempt.record.verdict = attempt.record.points >= 70 ? assessment::Verdict::kPassed
                                                                 : assessment::Verdict::kNotYet;
            report.data.attempts.push_back(attempt);
            owners.push_back(code);
        }
    }
    report.data.forms.push_back(reports::attempts_form(report.data.attempts, owners));
    return report;
}

const std::vector<reports::AnalysisCell>& row(const reports::Analysis& analysis,
                                              const std::string& name) {
    for (const auto& each : analysis.rows)
        if (each.front().text.rfind(name, 0) == 0) return each;
    throw std::runtime_error("no row " + name);
}

size_t column(const reports::Analysis& analysis, const std::string& name) {
    const auto found = std::find(analysis.head.begin(), analysis.head.end(), name);
    EXPECT_NE(found, analysis.head.end()) << name;
    return static_cast<size_t>(found - analysis.head.begin());
}

TEST(StudyAnalysis, LevelsOfExperienceAreComparedByMeansOfPeople) {
    // Experts 80..83, novices 40..43: no overlap, means 40 apart, SD sqrt(5/3) in both.
    const auto report = study_with(8, 2, [](int person, int trial) {
        return (person % 2 == 1 ? 80.0 : 40.0) + person / 2 + (trial == 0 ? -5 : 5);
    });
    const auto groupings = reports::possible_groupings(report.data);
    ASSERT_EQ(groupings.size(), 1u);
    EXPECT_EQ(groupings[0].id, "attempts.device");
    const auto analysis = reports::construct_validity(report, {});
    ASSERT_EQ(analysis.problem, "");
    const auto& points = row(analysis, "Score");
    EXPECT_NEAR(*points[column(analysis, "script:novice")].value, 41.5, 1e-12);
    EXPECT_NEAR(*points[column(analysis, "script:expert")].value, 81.5, 1e-12);
    // Levels are sorted by name: g is of novices against experts. J(6) = 0.869, exact by gamma.
    const double j6 = std::tgamma(3.0) / (std::sqrt(3.0) * std::tgamma(2.5));
    EXPECT_NEAR(*points[column(analysis, "g")].value, -40.0 / std::sqrt(5.0 / 3.0) * j6, 1e-9);
    // No overlap of four and four: 2 of C(8, 4) = 70 permutations are as far.
    EXPECT_NEAR(*points[column(analysis, "p")].value, 2.0 / 70.0, 1e-12);
    EXPECT_GE(*points[column(analysis, "p (Holm)")].value, 2.0 / 70.0);
    EXPECT_EQ(analysis.figures.size(), 2u);
}

/// The lines of a figure's CSV that begin with `name`.
std::vector<std::vector<std::string>> figure_lines(const reports::Analysis& analysis,
                                                   const std::string& id, const std::string& name) {
    std::vector<std::vector<std::string>> lines;
    for (const reports::Figure& figure : analysis.figures)
        if (figure.id == id)
            for (const auto& line : reports::parse_csv(figure.csv))
                if (line.front().rfind(name, 0) == 0) lines.push_back(line);
    return lines;
}

TEST(StudyAnalysis, AnEffectBeyondTheAxisKeepsItsNumberInTheCsvOfItsFigure) {
    // Novices 10, 11, 12 and experts 90, 91, 92: g -63.83, and the axis ends at -6.
    const auto report = study_with(
        6, 1, [](int person, int) { return (person % 2 == 1 ? 90.0 : 10.0) + person / 2; });
    const auto analysis = reports::construct_validity(report, "attempts.device");
    ASSERT_EQ(analysis.problem, "");
    const auto& points = row(analysis, "Score");
    const double g = *points[column(analysis, "g")].value;
    EXPECT_NEAR(g, -63.8307648642, 1e-9);
    const auto lines = figure_lines(analysis, "construct_validity", "Score");
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(curriculum::answer_number(lines[0].at(1)), g);
    EXPECT_NEAR(curriculum::answer_number(lines[0].at(2)).value(), -106.5547493632, 1e-6);
    EXPECT_NEAR(curriculum::answer_number(lines[0].at(3)).value(), -22.1891386637, 1e-6);
    EXPECT_THAT(analysis.figures.front().caption, HasSubstr("beyond the axis"));
}

TEST(StudyAnalysis, APOfTheNormalApproximationIsNotCalledExact) {
    const auto score = [](int person, int) { return (person % 2 == 1 ? 60.0 : 40.0) + person; };
    const auto few = reports::construct_validity(study_with(60, 1, score), {});
    EXPECT_THAT(few.method, HasSubstr("the exact Mann-Whitney test"));
    const auto many = reports::construct_validity(study_with(62, 1, score), {});
    ASSERT_EQ(many.problem, "");
    EXPECT_THAT(many.method, testing::Not(HasSubstr("exact")));
    EXPECT_THAT(many.method, HasSubstr("normal approximation"));
}

/// First attempt to be left out, then 10 k + 1 and 10 k + 2, the last of every other person half a
/// point more.
double retest_points(int person, int trial) {
    return trial == 0 ? 0.0 : 10.0 * person + trial + (trial == 2 && person % 2 == 1 ? 0.5 : 0);
}

/// ICC(2,1) of n x 2 by the analysis of variance, written out.
double icc21(const std::vector<std::array<double, 2>>& pairs) {
    const auto n = static_cast<double>(pairs.size());
    double grand = 0, first = 0, second = 0, rows = 0, total = 0;
    for (const auto& [a, b] : pairs) first += a / n, second += b / n;
    grand = (first + second) / 2;
    for (const auto& [a, b] : pairs) {
        rows += 2 * std::pow((a + b) / 2 - grand, 2);
        total += std::pow(a - grand, 2) + std::pow(b - grand, 2);
    }
    const double columns = n * (std::pow(first - grand, 2) + std::pow(second - grand, 2));
    const double msr = rows / (n - 1), msc = columns, mse = (total - rows - columns) / (n - 1);
    return (msr - mse) / (msr + mse + 2 * (msc - mse) / n);
}

TEST(StudyAnalysis, TestRetestOfTheLastTwoAttemptsIsShroutAndFleiss) {
    const auto analysis = reports::test_retest(study_with(6, 3, retest_points));
    ASSERT_EQ(analysis.problem, "");
    std::vector<std::array<double, 2>> pairs;
    for (int k = 0; k < 6; ++k) pairs.push_back({retest_points(k, 1), retest_points(k, 2)});
    const auto& points = row(analysis, "Score");
    EXPECT_EQ(points[column(analysis, "n")].text, "6");
    EXPECT_NEAR(*points[column(analysis, "ICC(2,1)")].value, icc21(pairs), 1e-12);
    const double sem = *points[column(analysis, "SEM")].value;
    EXPECT_GT(sem, 0);
    EXPECT_NEAR(*points[column(analysis, "MDC95")].value, 1.96 * std::sqrt(2.0) * sem, 1e-12);
    EXPECT_NE(reports::test_retest(study_with(2, 3, retest_points)).problem, "");
    // Everybody the same, or exactly one point more: there is nothing to tell apart, no crash.
    EXPECT_NE(reports::test_retest(study_with(5, 2, [](int, int) { return 3.0; })).problem, "");
    EXPECT_NO_THROW((void)reports::test_retest(
        study_with(5, 2, [](int person, int trial) { return 1.0 * person + trial; })));
}

const std::vector<std::string> kTwoTasks{"a", "b"};

TEST(StudyAnalysis, AnAttemptAtAnotherTaskIsNoRetest) {
    const auto once = reports::test_retest(study_with(6, 2, retest_points, kTwoTasks));
    EXPECT_THAT(once.problem, HasSubstr("at the same task"));
    // a at trials 0 and 2, b at 1 and 3.
    const auto score = [](int person, int trial) {
        return (trial % 2 == 0 ? 0.0 : 50.0) + 3.0 * person + (trial > 1 && person > 2 ? 0.5 : 0.0);
    };
    const auto twice = reports::test_retest(study_with(6, 4, score, kTwoTasks));
    ASSERT_EQ(twice.problem, "");
    const size_t first = column(twice, "first");
    EXPECT_NEAR(*row(twice, "a: Score")[first].value, 7.5, 1e-12);
    EXPECT_NEAR(*row(twice, "b: Score")[first].value, 57.5, 1e-12);
}

TEST(StudyAnalysis, CurvesAndLevelsAreOfOneTask) {
    const auto score = [](int person, int trial) {
        return (trial % 2 == 0 ? 0.0 : 40.0) + (person % 2 == 0 ? 0.0 : 20.0) + person;
    };
    const auto report = study_with(8, 4, score, kTwoTasks);
    const auto curves = reports::learning_curves(report);
    EXPECT_EQ(curves.rows.size(), 16u);
    EXPECT_EQ(row(curves, "a: P3")[column(curves, "attempts")].text, "2");
    EXPECT_NEAR(*row(curves, "b: P3")[column(curves, "last")].value, 63, 1e-12);
    ASSERT_EQ(curves.figures.size(), 2u);
    EXPECT_EQ(curves.figures[0].id, "learning_curves_a");
    const auto levels = reports::construct_validity(report, "attempts.device");
    ASSERT_EQ(levels.problem, "");
    const size_t novices = column(levels, "script:novice");
    EXPECT_NEAR(*row(levels, "a: Score")[novices].value, 3, 1e-12);
    EXPECT_NEAR(*row(levels, "b: Score")[novices].value, 43, 1e-12);
    // Where the tasks are the levels, they are compared.
    const auto tasks = reports::construct_validity(report, "attempts.task_id");
    ASSERT_EQ(tasks.problem, "");
    EXPECT_NEAR(*row(tasks, "Score")[column(tasks, "b")].value, 53.5, 1e-12);
}

TEST(StudyAnalysis, AttemptsOfSeveralVersionsAreSaidToBe) {
    auto report = study_with(8, 3, retest_points);
    const auto cautions = [&] {
        return std::vector<std::string>{reports::construct_validity(report, {}).caution,
                                        reports::test_retest(report).caution,
                                        reports::learning_curves(report).caution};
    };
    EXPECT_THAT(cautions(), testing::Each(std::string()));
    reports::Row& one = report.data.forms[0].rows[3];
    one.values["rubric_version"] = "7";
    EXPECT_THAT(cautions(), testing::Each(HasSubstr("the attempts at ring are of 1 version of the "
                                                    "task and 2 versions of its rubric")));
    one.values["task_version"] = "2";
    EXPECT_THAT(cautions(), testing::Each(HasSubstr("2 versions of the task and 2 versions")));
    one.counts = false;
    EXPECT_THAT(cautions(), testing::Each(std::string())) << "it is in no analysis";
}

TEST(StudyAnalysis, LearningCurveFindsTheCurveItWasMadeFrom) {
    const auto report = study_with(
        3, 9, [](int person, int trial) { return 90.0 - 60.0 * std::exp(-trial / 2.0) - person; });
    const auto analysis = reports::learning_curves(report);
    ASSERT_EQ(analysis.rows.size(), 3u);
    for (int person = 0; person < 3; ++person) {
        const auto& line = row(analysis, "P" + std::to_string(person));
        EXPECT_NEAR(*line[column(analysis, "plateau a")].value, 90.0 - person, 0.01);
        EXPECT_NEAR(*line[column(analysis, "tau")].value, 2.0, 0.01);
        EXPECT_EQ(line[column(analysis, "attempts")].text, "9");
    }
    EXPECT_FALSE(analysis.figures.empty());
}

TEST(StudyAnalysis, WithoutACurveTheTableSaysWhy) {
    const auto said = [](int trials, auto points) {
        const auto analysis = reports::learning_curves(study_with(1, trials, points));
        const auto& line = row(analysis, "P0");
        EXPECT_FALSE(line[column(analysis, "plateau a")].value);
        return line[column(analysis, "plateau reached")].text;
    };
    EXPECT_EQ(said(6, [](int, int) { return 80.0; }), "all scores are equal");
    EXPECT_EQ(said(4, [](int, int) { return 80.0; }), "too few attempts");
    // A curve goes through four points, but the method says five.
    const auto rising = [](int, int trial) { return 90.0 - 60.0 * std::exp(-trial / 2.0); };
    EXPECT_EQ(said(4, rising), "too few attempts");
    const auto five = reports::learning_curves(study_with(1, 5, rising));
    EXPECT_NEAR(*row(five, "P0")[column(five, "plateau a")].value, 90, 0.01);
    EXPECT_THAT(five.method, HasSubstr("from 5 attempts on"));
}

TEST(StudyAnalysis, RatersOfShroutAndFleissAgreeAsPublished) {
    // Shrout & Fleiss 1979, table 2: six targets, four judges; ICC(2,1) .29, (3,1) .71, (2,k) .62.
    const int table[6][4] = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                             {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
    curriculum::Questionnaire form = curriculum::load_questionnaire_text(
        R"({"id":"r","version":1,"title":{"en":"R"},"items":[{"id":"q","kind":"likert",)"
        R"("text":{"en":"quality"},"scale_min":1,"scale_max":10,"anchor_low":{"en":"l"},)"
        R"("anchor_high":{"en":"h"}}]})",
        "test");
    const auto report = study_with(6, 1, [](int, int) { return 50.0; });
    std::vector<db::RatingRecord> ratings;
    for (int target = 0; target < 6; ++target) {
        for (int judge = 0; judge < 4; ++judge) {
            db::RatingRecord rating;
            rating.attempt_id = 100 * target + 1;
            rating.rater_id = judge + 1;
            rating.answers = {{"q", std::to_string(table[target][judge])}};
            ratings.push_back(rating);
        }
    }
    // One that a fifth rater began, and one of another study's attempt: both left out.
    ratings.push_back(ratings.front());
    ratings.back().rater_id = 5;
    ratings.push_back(ratings.front());
    ratings.back().attempt_id = 999999;
    const auto analysis = reports::rater_agreement(report, ratings, form);
    ASSERT_EQ(analysis.problem, "");
    const auto& line = row(analysis, "quality");
    EXPECT_EQ(line[column(analysis, "raters")].text, "4");
    EXPECT_NEAR(*line[column(analysis, "ICC(2,1)")].value, 0.289764, 1e-6);
    EXPECT_NEAR(*line[column(analysis, "ICC(3,1)")].value, 0.714841, 1e-6);
    EXPECT_NEAR(*line[column(analysis, "ICC(2,k)")].value, 0.620051, 1e-6);
    EXPECT_THAT(analysis.method, HasSubstr("25 ratings"));
    EXPECT_NE(reports::rater_agreement(report, {}, form).problem, "");
}

TEST(StudyAnalysis, RatersWhoShareAttemptsAreFoundAmongOthersWhoJudgedMore) {
    const curriculum::Questionnaire form = curriculum::load_questionnaire_text(
        R"({"id":"r","version":1,"title":{"en":"R"},"items":[{"id":"q","kind":"likert",)"
        R"("text":{"en":"quality"},"scale_min":1,"scale_max":10,"anchor_low":{"en":"l"},)"
        R"("anchor_high":{"en":"h"}}]})",
        "test");
    const auto report = study_with(20, 1, [](int, int) { return 50.0; });
    std::vector<db::RatingRecord> ratings;
    const auto judge = [&](int64_t rater, int from, int to) {
        for (int target = from; target <= to; ++target) {
            db::RatingRecord rating;
            rating.attempt_id = 100 * target + 1;
            rating.rater_id = rater;
            rating.answers = {{"q", std::to_string(1 + (target + (rater == 3 ? 1 : 0)) % 9)}};
            ratings.push_back(rating);
        }
    };
    // The second judged more than the third, and none of what the first judged.
    judge(1, 1, 10);
    judge(2, 11, 19);
    judge(3, 1, 8);
    const auto analysis = reports::rater_agreement(report, ratings, form);
    ASSERT_EQ(analysis.problem, "");
    const auto& line = row(analysis, "quality");
    EXPECT_EQ(line[column(analysis, "raters")].text, "2");
    EXPECT_EQ(line[column(analysis, "attempts")].text, "8");
}

TEST(StudyAnalysis, TheTableIsWrittenWithWholeNumbers) {
    const auto report = study_with(6, 3, retest_points);
    const auto rows = reports::parse_csv(reports::analysis_csv(reports::test_retest(report)));
    ASSERT_GE(rows.size(), 2u);
    EXPECT_EQ(rows[0].size(), rows[1].size());
    const auto analysis = reports::test_retest(report);
    EXPECT_EQ(std::stod(rows[1][4]), *analysis.rows.at(0).at(4).value);
    EXPECT_EQ(reports::construct_validity(reports::StudyReport{}, {}).rows.size(), 0u);
    EXPECT_NE(reports::construct_validity(reports::StudyReport{}, {}).problem, "");
}

}  // namespace THIS_TEST
