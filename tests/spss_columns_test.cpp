// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// SPSS's missing codes beside every answer that a questionnaire allows.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "tests/export_fixture.h"

using namespace placode;
using namespace placode::test;

namespace THIS_TEST {

World* const world = World::install();

/// Every kind of item whose answers may lie where others have their missing codes.
std::string edges() {
    std::string choices;
    for (int i = 0; i < 98; ++i)
        choices += (i == 0 ? R"({"en":"c)" : R"(,{"en":"c)") + std::to_string(i) + R"("})";
    return R"({"id":"edges","version":1,"title":{"en":"Edges"},"licence":"test","items":[
   {"id":"day","kind":"date","text":{"en":"Day"},"not_applicable":true,"required":false},
   {"id":"depth","kind":"number","text":{"en":"Depth"},"number_min":-20000,"number_max":0,
    "not_applicable":true,"required":false},
   {"id":"least","kind":"number","text":{"en":"Least"},"number_min":-1000000000,"number_max":0,
    "not_applicable":true,"required":false},
   {"id":"one","kind":"choice","text":{"en":"One of many"},"not_applicable":true,"required":false,
    "choices":[)" +
           choices + R"(]},
   {"id":"how","kind":"likert","text":{"en":"How?"},"scale_min":90,"scale_max":99,
    "not_applicable":true,"required":false}]})";
}

class SpssColumns : public Export {
 protected:
    void SetUp() override {
        Export::SetUp();
        db::DefinitionRecord definition;
        definition.kind = "questionnaire";
        definition.id = "edges";
        definition.json = edges();
        store->definitions().publish(definition);
    }
    void answer(const curriculum::Answers& answers) const {
        db::AnswerRecord record;
        record.study_id = "s1";
        record.participant = store->studies().new_participant("s1", true);
        record.questionnaire_id = "edges";
        record.answered_utc = "2026-11-21T10:15:00Z";
        record.answers = answers;
        record.demonstration = true;
        store->studies().save_answers(record);
    }
    void write_all() const {
        for (const char* format : {"spss", "redcap", "bundle"})
            EXPECT_NO_THROW(reports::export_dataset(source(), format, out(format))) << format;
    }
};

TEST_F(SpssColumns, WhatDoesNotApplyIsToldFromEveryDateAndNumber) {
    answer({{"day", "NA"}, {"depth", "NA"}, {"least", "NA"}, {"one", "NA"}, {"how", "NA"}});
    // 0 s and 86 400 s of SPSS, and days before its first one.
    answer({{"day", "1582-10-14"}, {"depth", "-9999"}, {"least", "-999999999"}});
    answer({{"day", "1582-10-15"}, {"depth", "-9997"}, {"least", "-1000000000"}});
    answer({{"day", "0001-01-01"}, {"depth", "0"}, {"least", "-9998"}});
    answer({});
    write_all();
}

TEST_F(SpssColumns, AMissingCodeIsNoAnswerOfALongList) {
    for (const char* code : {"95", "96", "97"}) answer({{"one", code}, {"how", code}});
    for (const char* code : {"98", "99", "NA"}) answer({{"how", code}});
    write_all();
    const auto data = source().data;
    ASSERT_NE(data.form("edges"), nullptr);
    EXPECT_EQ(data.form("edges")->field("one")->not_applicable_code(), 999);
    EXPECT_EQ(data.form("kinds")->field("by")->not_applicable_code(), 99);
}

TEST_F(SpssColumns, RedcapChecksNoDateThatNeedNotApply) {
    answer({{"day", "NA"}});
    write("redcap");
    const Rows dictionary = reports::parse_csv(read_text(out("s1_redcap_dictionary.csv")));
    std::map<std::string, std::string> checked;
    for (size_t r = 1; r < dictionary.size(); ++r)
        checked[dictionary[r].at(0)] =
            at(dictionary, r, "Text Validation Type OR Show Slider Number");
    EXPECT_EQ(checked.at("edges_day"), "") << "it may hold NA";
    EXPECT_EQ(checked.at("edges_depth"), "");
    EXPECT_EQ(checked.at("kinds_day"), "date_ymd");
    EXPECT_EQ(checked.at("kinds_age"), "number");
}

}  // namespace THIS_TEST
