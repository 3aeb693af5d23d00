// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the report says of its own numbers: how many people they are of, and which test they are.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/study_numbers.h"

#include <gmock/gmock.h>

#include "reports/study_report.h"

using namespace placode;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

reports::Form form_with(const std::string& id, const std::string& item, int codes, bool ordinal) {
    reports::Field field;
    field.id = item;
    field.label = item;
    field.kind = reports::FieldKind::kCode;
    field.ordinal = ordinal;
    for (int value = 0; value < codes; ++value) field.codes.push_back({value, "c"});
    reports::Form form;
    form.id = form.name = form.title = id;
    form.fields.push_back(field);
    return form;
}

void answer(reports::Form& form, int person, int value) {
    reports::Row row;
    row.participant = "P" + std::to_string(1000 + person);
    row.values[form.fields.front().id] = std::to_string(value);
    form.rows.push_back(row);
}

std::string all_cautions(const reports::Dataset& data) {
    std::string text;
    for (const std::string& each : reports::study_numbers(data, {}).cautions) text += each + "\n";
    return text;
}

TEST(StudyNumbersWords, ACautionGoesByWhoAnsweredNotByWhoWasEnrolled) {
    reports::Dataset data;
    data.participants.resize(40);
    data.forms.push_back(form_with("before", "how", 5, true));
    data.forms.push_back(form_with("after", "how_now", 5, true));
    for (int person = 0; person < 40; ++person) answer(data.forms[0], person, person % 5);
    for (int person = 0; person < 9; ++person) answer(data.forms[1], person, person % 5);
    answer(data.forms[1], 0, 1);  // a repeat is no other person
    data.forms[1].rows.back().instance = 2;
    EXPECT_THAT(all_cautions(data), HasSubstr("n = 9 (after): a share of 8/9"));
    EXPECT_THAT(all_cautions(data), Not(HasSubstr("before")));
    EXPECT_THAT(all_cautions(data), HasSubstr("omega"));
    data.forms.pop_back();
    data.participants.resize(5);
    EXPECT_THAT(all_cautions(data), Not(HasSubstr("n = ")));
}

/// Half of `people` answered no, and low, the others yes, and high.
reports::StudyReport two_groups(int people) {
    reports::StudyReport report;
    report.data.forms.push_back(form_with("groups", "used", 2, false));
    report.data.forms.push_back(form_with("opinions", "how", 7, true));
    for (int person = 0; person < people; ++person) {
        const int group = person % 2;
        answer(report.data.forms[0], person, group);
        answer(report.data.forms[1], person, 3 * group + person / 2 % 3);
    }
    return report;
}

std::string forest_of(const reports::StudyReport& report, const reports::StudyNumbers& numbers) {
    for (const reports::Figure& figure : reports::study_figures(report, numbers))
        if (figure.id == "forest_opinions") return figure.csv;
    return "no figure";
}

TEST(StudyNumbersWords, APOfTheNormalApproximationIsNotCalledExact) {
    const auto few = two_groups(60), many = two_groups(62);
    const auto exact = reports::study_numbers(few.data, {});
    const auto normal = reports::study_numbers(many.data, {});
    ASSERT_TRUE(exact.comparison && normal.comparison);
    EXPECT_EQ(exact.comparison->exact_rows(), 1u);
    EXPECT_EQ(normal.comparison->exact_rows(), 0u);
    EXPECT_THAT(reports::study_numbers_csv(exact), HasSubstr("opinions,how,p_exact,"));
    EXPECT_THAT(reports::study_numbers_csv(normal), HasSubstr("opinions,how,p_normal,"));
    EXPECT_THAT(reports::study_numbers_csv(normal), Not(HasSubstr("p_exact")));
}

TEST(StudyNumbersWords, ASmallPIsNotNought) {
    const auto report = two_groups(40);
    const auto forest = forest_of(report, reports::study_numbers(report.data, {}));
    EXPECT_THAT(forest, HasSubstr("p < 0.001"));
    EXPECT_THAT(forest, Not(HasSubstr("0.000")));
}

}  // namespace THIS_TEST
