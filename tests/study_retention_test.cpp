// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How long a study's records are kept: what participants are told, what is due, what goes.

#include <gmock/gmock.h>

#include "curriculum/study.h"
#include "curriculum/utc_time.h"
#include "db/store.h"
#include "db/study_conduct.h"
#include "db/study_retention.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::ElementsAre;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();

std::string protocol(int version, const std::string& keep) {
    return R"({"id":"pilot","version":)" + std::to_string(version) + R"(,"title":{"en":"t"},)" +
           keep +
           R"("consent":{"version":1,"information":[{"en":"i"}],)"
           R"("statements":[{"id":"a","text":{"en":"yes"}}]},)"
           R"("steps":[{"id":"consent","kind":"consent"},)"
           R"({"id":"run","kind":"procedure","task":"diathermy_ring"}]})";
}

TEST(StudyRetention, YearsAreThoseOfTheCalendar) {
    EXPECT_EQ(db::years_later("2026-11-29T08:05:00Z", 5), "2031-11-29T08:05:00Z");
    EXPECT_EQ(db::years_later("2024-02-29T23:59:59.123Z", 1), "2025-02-28T23:59:59Z");
    EXPECT_EQ(db::years_later("2024-02-29T00:00:00Z", 4), "2028-02-29T00:00:00Z");
    EXPECT_THROW((void)db::years_later("soon", 1), std::invalid_argument);
}

TEST(StudyRetention, WhoConsentsHasReadHowLong) {
    const auto told = [](int years) {
        const auto study = curriculum::load_study_text(
            protocol(1, "\"keep_years\":" + std::to_string(years) + ","), "test");
        EXPECT_EQ(study.keep_years, years);
        return study.consent.information.back();
    };
    EXPECT_THAT(told(1).in("en"), HasSubstr("for 1 year after"));
    EXPECT_THAT(told(10).in("en"), HasSubstr("for 10 years after"));
    EXPECT_THAT(told(1).in("pl"), HasSubstr("przez 1 rok od"));
    EXPECT_THAT(told(3).in("pl"), HasSubstr("przez 3 lata od"));
    EXPECT_THAT(told(12).in("pl"), HasSubstr("przez 12 lat od"));
    EXPECT_THAT(told(22).in("pl"), HasSubstr("przez 22 lata od"));
    EXPECT_EQ(curriculum::load_study_text(protocol(1, ""), "test").consent.information.size(), 1u)
        << "a protocol that says nothing promises nothing";
    for (const char* wrong : {"0", "51", "-1", "2.5", "\"5\""}) {
        try {
            (void)curriculum::load_study_text(
                protocol(1, std::string("\"keep_years\":") + wrong + ","), "file.json");
            ADD_FAILURE() << wrong;
        } catch (const curriculum::DefinitionError& error) {
            EXPECT_THAT(error.what(), HasSubstr("/keep_years")) << wrong;
        }
    }
}

class StudyRetentionIn : public EngineTest {
 protected:
    void ready() override {
        options.now_ms = [this] { return now_ms; };
        store = open();
    }
    void publish(int version, const std::string& keep, const std::string& reason) {
        db::DefinitionRecord record;
        record.kind = "study";
        record.id = "pilot";
        record.version = version;
        record.json = protocol(version, keep);
        record.reason = reason;
        store->definitions().publish(record);
    }
    std::string enrol() {
        const std::string code = store->studies().new_participant("pilot");
        db::StepRecord step;
        step.study_id = "pilot";
        step.participant = code;
        step.step = "consent";
        store->studies().record_step(step);
        return code;
    }
    void answer(const std::string& code) {
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        record.answers = {{"sus01", "4"}};
        store->studies().save_answers(record);
    }
    /// Clock and argument alike.
    std::string years_on(int years) {
        const std::string at = db::years_later(db::utc_now(), years);
        now_ms = 1000 * *curriculum::utc_seconds(at);
        return at;
    }

    int64_t now_ms = 1000 * *curriculum::utc_seconds(db::utc_now());
    std::unique_ptr<db::Store> store;
};
INSTANTIATE_TEST_SUITE_P(Engines, StudyRetentionIn, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StudyRetentionIn, EachParticipantByTheVersionThatWasTold) {
    publish(1, "", "");
    const std::string untold = enrol();
    publish(2, "\"keep_years\":10,", "the committee asked for it");
    const std::string ten = enrol();
    publish(3, "\"keep_years\":2,", "the law has changed");
    const std::string two = enrol(), withdrawn = enrol();
    for (const std::string& code : {untold, ten, two, withdrawn}) answer(code);
    store->studies().withdraw("pilot", withdrawn, db::WithdrawalMode::kKeep, "no time");

    const auto kept = db::kept_records(*store, "pilot");
    ASSERT_EQ(kept.size(), 3u) << "who was promised nothing has no date";
    EXPECT_EQ(kept[0].keep_years, 2);
    EXPECT_EQ(kept[2].code, ten);
    EXPECT_EQ(kept[2].until_utc, db::years_later(kept[2].last_utc, 10));

    EXPECT_TRUE(db::erase_overdue(*store, "pilot", db::utc_now()).empty());
    EXPECT_EQ(store->studies().answers("pilot").size(), 4u);
    EXPECT_THAT(db::erase_overdue(*store, "pilot", years_on(3)), ElementsAre(two, withdrawn));
    EXPECT_EQ(store->studies().answers("pilot").size(), 2u);
    EXPECT_EQ(store->studies().participants("pilot").size(), 4u) << "codes stay";
    EXPECT_FALSE(store->studies().participants("pilot")[2].withdrawal) << "nobody withdrew";
    EXPECT_EQ(store->audit().trail(1).at(0).action, "study.retention");
    EXPECT_TRUE(db::erase_overdue(*store, "pilot", years_on(4)).empty()) << "once is enough";
    EXPECT_THAT(db::erase_overdue(*store, "pilot", years_on(11)), ElementsAre(ten));
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyRetentionIn, NothingGoesBeforeItsTime) {
    publish(1, "\"keep_years\":2,", "");
    const std::string code = enrol();
    const auto early = failure_of(
        [&] { store->studies().erase_kept("pilot", code, db::years_later(db::utc_now(), 2)); });
    EXPECT_EQ(early.kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(early.what(), HasSubstr("its records are kept until"));
    // Whoever claims a later day than the clock shows does not get past it either.
    EXPECT_EQ(failure_of([&] {
                  db::erase_overdue(*store, "pilot", db::years_later(db::utc_now(), 5));
              }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->studies().steps("pilot").size(), 1u);
    EXPECT_EQ(failure_of([&] {
                  store->studies().erase_kept("pilot", "P099-X", "2020-01-01T00:00:00Z");
              }).kind(),
              StoreError::Kind::kNotFound);
}

}  // namespace THIS_TEST
