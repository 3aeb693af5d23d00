// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Which of repeated answers are the first ones.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "reports/study_numbers.h"
#include "tests/export_fixture.h"

using namespace placode;
using namespace placode::test;

namespace THIS_TEST {

World* const world = World::install();

class RepeatedAnswers : public Export {
 protected:
    std::string person() const { return store->studies().new_participant("s2", true); }
    void save(const std::string& code, int visit, const std::string& value) const {
        db::AnswerRecord record;
        record.study_id = "s2";
        record.participant = code;
        record.questionnaire_id = "kinds";
        record.answered_utc = "2026-11-21T10:15:00Z";
        record.visit = visit;
        record.answers = {{"by", "0"}, {"B", value}, {"used", "0"}};
        record.demonstration = true;
        store->studies().save_answers(record);
    }
};

TEST_F(RepeatedAnswers, TheFirstAreThoseOfTheFirstVisitWhateverWasEnteredFirst) {
    const std::string in_order = person(), from_paper = person();
    save(in_order, 1, "2");
    save(in_order, 2, "6");
    // The second visit was entered at once, the first one later from its sheet.
    save(from_paper, 2, "6");
    save(from_paper, 1, "2");
    save(from_paper, 1, "5");  // Within a visit the order of saving counts.
    const reports::Dataset data = reports::study_dataset(*store, "s2");
    const reports::StudyNumbers numbers = reports::study_numbers(data, {});
    const reports::ItemNumbers* found = nullptr;
    for (const auto& form : numbers.forms)
        for (const auto& item : form.items)
            if (item.field->id == "B") found = &item;
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->summary.n, 2);
    EXPECT_EQ(found->summary.mean, 2.0);
    EXPECT_EQ(found->summary.sd, 0.0);
    std::map<std::string, std::vector<std::string>> rows;
    for (const reports::Row& row : data.form("kinds")->rows) {
        auto& own = rows[row.participant];
        own.push_back(row.values.at("visit") + ":" + row.values.at("B"));
        EXPECT_EQ(row.instance, static_cast<int>(own.size()));
    }
    EXPECT_EQ(rows[in_order], (std::vector<std::string>{"1:2", "2:6"}));
    EXPECT_EQ(rows[from_paper], (std::vector<std::string>{"1:2", "1:5", "2:6"}));
    for (const char* format : {"csv", "spss", "redcap", "fhir", "odm", "xapi"})  // and read back
        EXPECT_NO_THROW(reports::export_dataset({data, {}}, format, out(format))) << format;
}

}  // namespace THIS_TEST
