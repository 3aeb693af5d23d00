// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Lock, signature, correction, double entry and the signature under a consent, on both engines.

// g++ 12 sees an overlap in std::string operations that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include "db/study_records.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "curriculum/questionnaire.h"
#include "db/consent_encryption.h"
#include "db/study_conduct.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using Kind = StoreError::Kind;
using testing::HasSubstr;

namespace THIS_TEST {

World* const world = World::install();
constexpr const char* kPassword = "correct horse battery";

class StudyRecordsTest : public EngineTest {
 protected:
    void ready() override {
        store = open();
        store->accounts().create({"karol", "Karol Koordynator", kPassword,
                                  static_cast<db::Roles>(db::Role::kCoordinator), false});
        store->act_as("karol");
        code = store->studies().new_participant("pilot");
        const auto sus = curriculum::load_questionnaire("sus");
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        for (const auto& item : sus.items) record.answers[item.id] = "4";
        first_item = sus.items.front().id;
        answer_id = db::submit_answers(*store, sus, record);
    }
    [[nodiscard]] std::string given() {
        return store->studies().answers("pilot").at(0).answers[first_item];
    }

    std::unique_ptr<db::Store> store;
    std::string code, first_item;
    int64_t answer_id = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, StudyRecordsTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(StudyRecordsTest, ALockedRecordTakesNothingMore) {
    db::StudyRecords& records = store->records();
    records.lock("pilot", code);
    EXPECT_TRUE(records.states("pilot").at(code).locked);
    EXPECT_EQ(failure_of([&] { records.lock("pilot", code); }).kind(), Kind::kConflict);
    EXPECT_EQ(failure_of([&] { records.lock("pilot", "P999-X"); }).kind(), Kind::kNotFound);
    db::AnswerRecord more = store->studies().answers("pilot").at(0);
    EXPECT_THAT(failure_of([&] { store->studies().save_answers(more); }).what(),
                HasSubstr("is locked"));
    db::StepRecord step;
    step.study_id = "pilot";
    step.participant = code;
    step.step = "run";
    EXPECT_THAT(failure_of([&] { store->studies().record_step(step); }).what(),
                HasSubstr("is locked"));
    EXPECT_THAT(failure_of([&] {
                    records.correct_answers(answer_id, 1, {{first_item, "2"}}, "a slip");
                }).what(),
                HasSubstr("is locked"));
    EXPECT_EQ(failure_of([&] { records.unlock("pilot", code, ""); }).kind(), Kind::kRefused);
    records.unlock("pilot", code, "an answer was overlooked");
    EXPECT_NO_THROW(store->studies().record_step(step));
    EXPECT_EQ(records.events("pilot").size(), 2u);
    EXPECT_EQ(records.events("pilot").at(1).remark, "an answer was overlooked");
}

TEST_P(StudyRecordsTest, ASignatureNeedsThePasswordAgainAndIsBoundToTheRecord) {
    db::StudyRecords& records = store->records();
    const auto sign = [&](const char* password, const char* meaning) {
        records.sign("pilot", code, "karol", password, meaning);
    };
    EXPECT_THAT(failure_of([&] { sign(kPassword, "reviewed"); }).what(), HasSubstr("lock"));
    records.lock("pilot", code);
    EXPECT_THAT(failure_of([&] { sign("wrong", "reviewed"); }).what(), HasSubstr("is wrong"));
    EXPECT_THAT(failure_of([&] { sign(kPassword, ""); }).what(), HasSubstr("meaning"));
    EXPECT_FALSE(records.states("pilot").at(code).signature);
    sign(kPassword, "reviewed and complete");
    const auto state = records.states("pilot").at(code);
    ASSERT_TRUE(state.signature);
    EXPECT_EQ(state.signature->name, "Karol Koordynator");
    EXPECT_EQ(state.signature->remark, "reviewed and complete");
    EXPECT_FALSE(state.signature->at_utc.empty());
    EXPECT_TRUE(state.signature_fits);
    EXPECT_EQ(failure_of([&] { sign(kPassword, "again"); }).kind(), Kind::kConflict);
    // Past the program: the signature tells.
    ASSERT_TRUE(
        raw().run("UPDATE answer_items SET answer = '1' WHERE item = '" + first_item + "'"));
    EXPECT_FALSE(records.states("pilot").at(code).signature_fits);
    records.unlock("pilot", code, "to be corrected");
    EXPECT_FALSE(records.states("pilot").at(code).signature) << "unlocking cancels it";
    EXPECT_EQ(store->audit().trail(1).at(0).action, "study.record.unlocked");
}

TEST_P(StudyRecordsTest, ACorrectionKeepsTheOldAnswerAndItsReason) {
    db::StudyRecords& records = store->records();
    EXPECT_EQ(failure_of([&] {
                  records.correct_answers(answer_id, 1, {{first_item, "2"}}, "");
              }).kind(),
              Kind::kRefused);
    EXPECT_THAT(failure_of([&] {
                    records.correct_answers(answer_id, 1, {{first_item, "9"}}, "a slip");
                }).what(),
                HasSubstr("above 5"));
    EXPECT_EQ(failure_of([&] {
                  records.correct_answers(answer_id + 100, 1, {{first_item, "2"}}, "x");
              }).kind(),
              Kind::kNotFound);
    EXPECT_EQ(given(), "4") << "what is refused changes nothing";
    records.correct_answers(answer_id, 1, {{first_item, "2"}}, "read wrongly from paper");
    EXPECT_EQ(given(), "2");
    const auto list = records.corrections("pilot");
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].old_answer, "4");
    EXPECT_EQ(list[0].new_answer, "2");
    EXPECT_EQ(list[0].reason, "read wrongly from paper");
    EXPECT_EQ(list[0].corrected_by, "karol");
    // The reason goes with the participant's data, which the trail outlives.
    EXPECT_EQ(store->audit().trail(1).at(0).detail,
              "sus: " + first_item + "; correction " + std::to_string(list[0].id));
}

TEST_P(StudyRecordsTest, TwoEntriesAreComparedAndTheDifferenceIsDecided) {
    db::StudyRecords& records = store->records();
    db::SecondEntry second{answer_id, store->studies().answers("pilot").at(0).answers, {}, {}};
    second.answers[first_item] = "3";
    auto broken = second;
    broken.answers[first_item] = "77";
    EXPECT_EQ(failure_of([&] { records.save_second_entry(broken); }).kind(), Kind::kRefused);
    store->act_as("ewa");
    records.save_second_entry(second);
    EXPECT_EQ(failure_of([&] { records.save_second_entry(second); }).kind(), Kind::kConflict);
    auto differences = db::entry_differences(*store, "pilot");
    ASSERT_EQ(differences.size(), 1u);
    EXPECT_EQ(differences[0].item, first_item);
    EXPECT_EQ(differences[0].first, "4");
    EXPECT_EQ(differences[0].second, "3");
    EXPECT_EQ(differences[0].entered_by, "ewa");
    db::decide_difference(*store, differences[0], 2, "looked at the paper");
    EXPECT_TRUE(db::entry_differences(*store, "pilot").empty());
    EXPECT_EQ(given(), "3");
    // And the other way round: the second entry was the slip.
    records.correct_answers(answer_id, 2, {{first_item, "5"}}, "for the test");
    differences = db::entry_differences(*store, "pilot");
    ASSERT_EQ(differences.size(), 1u);
    db::decide_difference(*store, differences[0], 1, "looked at the paper again");
    EXPECT_TRUE(db::entry_differences(*store, "pilot").empty());
    EXPECT_EQ(given(), "3");
    EXPECT_EQ(records.corrections("pilot").size(), 3u);
}

TEST_P(StudyRecordsTest, ADifferenceIsDecidedWithTheQuestionsThatItHides) {
    const auto about = curriculum::load_questionnaire("demographics");
    db::AnswerRecord sheet;
    sheet.study_id = "pilot";
    sheet.participant = code;
    sheet.questionnaire_id = about.id;
    sheet.questionnaire_version = about.version;
    sheet.answers = {{"age", "40"},
                     {"gender", "0"},
                     {"speciality", "5"},
                     {"operative_years", "3"},
                     {"speciality_other", "x"},
                     {"laparoscopic_cases", "1"},
                     {"fetoscopic_cases", "1"},
                     {"used_simulator", "0"},
                     {"interest_vr", "4"},
                     {"interest_fetoscopic", "4"}};
    curriculum::Answers typed_again = sheet.answers;
    typed_again["age"] = "41";
    typed_again["speciality"] = "3";
    typed_again.erase("speciality_other");
    // Whichever of the two rows is decided, and whoever is right.
    for (const char* row : {"speciality", "speciality_other"}) {
        for (const int right : {1, 2}) {
            const int64_t id = db::submit_answers(*store, about, sheet);
            store->records().save_second_entry({id, typed_again, {}, {}});
            auto differences = db::entry_differences(*store, "pilot");
            ASSERT_EQ(differences.size(), 3u);
            const auto chosen =
                std::ranges::find(differences, std::string(row), &db::EntryDifference::item);
            ASSERT_NE(chosen, differences.end());
            EXPECT_NO_THROW(db::decide_difference(*store, *chosen, right, "looked at the paper"))
                << row << " " << right;
            differences = db::entry_differences(*store, "pilot");
            ASSERT_EQ(differences.size(), 1u) << row << " " << right;
            EXPECT_EQ(differences[0].item, "age") << "what hangs on nothing is decided by itself";
            EXPECT_EQ(store->studies().answers("pilot").back().answers["speciality"],
                      right == 1 ? "5" : "3");
            db::decide_difference(*store, differences[0], 1, "looked at the paper");
        }
    }
    EXPECT_TRUE(db::entry_differences(*store, "pilot").empty());
}

TEST_P(StudyRecordsTest, WithAKeyOnlyItsHolderReadsTheSignatures) {
    db::StudyRecords& records = store->records();
    const std::string early = "M11 22 L33 44", late = "M55 66 L77 88";
    records.save_consent_signature("pilot", code, early);
    const db::ConsentKeys pair = db::make_consent_keys(), other = db::make_consent_keys();
    db::keep_consent_key(*store, "pilot", pair.public_key);
    db::keep_consent_key(*store, "pilot", pair.public_key);  // The same again changes nothing.
    const std::string second = store->studies().new_participant("pilot");
    records.save_consent_signature("pilot", second, late);
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM consent_signatures WHERE path LIKE 'M%'"), "0");
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM definitions WHERE kind = 'consent_seal'"), "1");
    const std::string kept = records.consent_signature("pilot", code)->path;
    EXPECT_TRUE(db::is_encrypted(kept));
    EXPECT_EQ(db::decrypted(kept, pair), early);
    EXPECT_EQ(db::decrypted(records.consent_signature("pilot", second)->path, pair), late);
    EXPECT_EQ(db::decrypted(kept, other), std::nullopt);
    std::string changed = kept;
    changed.back() = changed.back() == '0' ? '1' : '0';
    EXPECT_EQ(db::decrypted(changed, pair), std::nullopt);
    // Another key: what was encrypted stays with the first, what comes next goes to the second.
    db::keep_consent_key(*store, "pilot", other.public_key);
    EXPECT_EQ(records.consent_signature("pilot", code)->path, kept);
    const std::string third = store->studies().new_participant("pilot");
    records.save_consent_signature("pilot", third, late);
    EXPECT_EQ(db::decrypted(records.consent_signature("pilot", third)->path, other), late);
    EXPECT_EQ(failure_of([&] { db::keep_consent_key(*store, "pilot", "abc"); }).kind(),
              Kind::kDamaged);
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyRecordsTest, ErasureTakesCorrectionsEntriesAndTheSignature) {
    db::StudyRecords& records = store->records();
    records.save_consent_signature("pilot", code, "M1 2 L3 4");
    EXPECT_EQ(records.consent_signature("pilot", code)->path, "M1 2 L3 4");
    EXPECT_EQ(failure_of([&] { records.save_consent_signature("pilot", code, "M0 0"); }).kind(),
              Kind::kConflict);
    records.correct_answers(answer_id, 1, {{first_item, "2"}}, "slip");
    records.save_second_entry({answer_id, store->studies().answers("pilot").at(0).answers, {}, {}});
    records.lock("pilot", code);
    store->studies().withdraw("pilot", code, db::WithdrawalMode::kErase, "asked for it");
    EXPECT_TRUE(store->studies().answers("pilot").empty());
    EXPECT_TRUE(records.corrections("pilot").empty());
    EXPECT_TRUE(records.second_entries("pilot").empty());
    EXPECT_FALSE(records.consent_signature("pilot", code));
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM answer_corrections"), "0");
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM second_entry_items"), "0");
    EXPECT_EQ(store->studies().participants("pilot").size(), 1u) << "the tombstone stays";
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyRecordsTest, AQuestionnaireAskedTwiceAndStepsOfOneArmAreFollowed) {
    db::DefinitionRecord study;
    study.kind = "study";
    study.id = "two_arms";
    study.json =
        R"({"id":"two_arms","version":1,"title":{"en":"t"},"visits":2,"arms":{"names":[{"en":"x"},)"
        R"({"en":"y"}],"block_size":2},"steps":[{"id":"before","kind":"questionnaire",)"
        R"("questionnaire":"sus"},{"id":"only_y","kind":"briefing","text":[{"en":"b"}],"arms":[1]},)"
        R"({"id":"after","kind":"questionnaire","questionnaire":"sus"}]})";
    store->definitions().publish(study);
    store->studies().new_participant("two_arms");
    store->studies().new_participant("two_arms");
    const auto sus = curriculum::load_questionnaire("sus");
    for (const auto& each : db::study_progress(*store, "two_arms")) {
        EXPECT_EQ(each.total, each.participant.arm == 1 ? 6 : 4);
        db::AnswerRecord record = store->studies().answers("pilot").at(0);
        record.study_id = "two_arms";
        record.participant = each.participant.code;
        db::submit_answers(*store, sus, record);
        db::submit_answers(*store, sus, record);
        record.visit = 2;
        db::submit_answers(*store, sus, record);
    }
    for (const auto& each : db::study_progress(*store, "two_arms")) {
        EXPECT_EQ(each.finished, (std::vector<std::string>{"1/before", "1/after", "2/before"}));
        EXPECT_EQ(each.next, each.participant.arm == 1 ? "only_y" : "after");
    }
    study.version = 2;
    study.reason = "x";
    study.json.replace(study.json.find("[1]"), 3, "[2]");
    study.json.replace(study.json.find("\"version\":1"), 11, "\"version\":2");
    EXPECT_THROW(store->definitions().publish(study), curriculum::DefinitionError)
        << "there are two arms";
}

TEST_P(StudyRecordsTest, AnswersDoTheStepOfTheParticipantsVersionAndArm) {
    const auto publish = [&](int version, const std::string& prefix) {
        db::DefinitionRecord study;
        study.kind = "study";
        study.id = "per_arm";
        study.version = version;
        study.reason = "another name of the steps";
        study.json = R"({"id":"per_arm","version":)" + std::to_string(version) +
                     R"(,"title":{"en":"t"},"arms":{"names":[{"en":"x"},{"en":"y"}],)" +
                     R"("block_size":2},"steps":[{"id":")" + prefix +
                     R"(_x","kind":"questionnaire","questionnaire":"sus","arms":[0]},{"id":")" +
                     prefix + R"(_y","kind":"questionnaire","questionnaire":"sus","arms":[1]}]})";
        store->definitions().publish(study);
    };
    const auto sus = curriculum::load_questionnaire("sus");
    const auto answer_all = [&](const std::string& whom) {
        db::AnswerRecord record = store->studies().answers("pilot").at(0);
        record.study_id = "per_arm";
        record.participant = whom;
        db::submit_answers(*store, sus, record);
    };
    publish(1, "first");
    std::vector<std::string> codes;
    for (int i = 0; i < 4; ++i) codes.push_back(store->studies().new_participant("per_arm"));
    answer_all(codes[0]);
    answer_all(codes[1]);
    publish(2, "renamed");
    answer_all(codes[2]);
    answer_all(codes[3]);
    for (const auto& each : db::study_progress(*store, "per_arm")) {
        EXPECT_EQ(each.finished,
                  std::vector<std::string>{each.participant.arm == 0 ? "1/first_x" : "1/first_y"});
        EXPECT_EQ(each.next, "");
        EXPECT_EQ(each.done, 1);
    }
}

}  // namespace THIS_TEST
