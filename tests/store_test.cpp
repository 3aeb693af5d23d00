// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks, ratings, attempts, recordings, answers: the same tests for both engines.

#include "db/store.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "db/participant.h"
#include "tests/store_cases.h"

namespace THIS_TEST {

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// --- review --------------------------------------------------------------------------------------

TEST_P(StoreTest, RemarksStandAtTheirTimesUntilTheyAreRemoved) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    const int64_t attempt = store->attempts().save(anna, make_result());
    db::CommentRecord comment;
    comment.attempt_id = attempt;
    comment.author_id = anna;
    comment.time_s = 0.5;
    comment.text = "Powoli, bez zatrzymania";
    const int64_t later = store->reviews().add_comment(comment);
    comment.time_s = 0.25;
    comment.text = "";
    store->reviews().add_comment(comment);
    auto found = store->reviews().comments(attempt);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].time_s, 0.25);
    EXPECT_EQ(found[1].text, "Powoli, bez zatrzymania");
    EXPECT_EQ(found[1].author_name, "Name of anna");
    store->reviews().set_comment_removed(later, true);
    EXPECT_EQ(store->reviews().comments(attempt).size(), 1u);
    store->reviews().set_comment_removed(later, false);
    EXPECT_EQ(store->reviews().comments(attempt).size(), 2u);
    EXPECT_THAT(store->reviews().comments(attempt + 1), IsEmpty());
}

TEST_P(StoreTest, ARemarkNeedsATimeWithinTheAttemptOrAText) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    db::CommentRecord comment;
    comment.attempt_id = store->attempts().save(anna, make_result());
    comment.author_id = anna;
    EXPECT_EQ(failure_of([&] { store->reviews().add_comment(comment); }).kind(),
              StoreError::Kind::kRefused);
    comment.time_s = 1e6;
    EXPECT_EQ(failure_of([&] { store->reviews().add_comment(comment); }).kind(),
              StoreError::Kind::kRefused);
    comment.attempt_id += 1;
    EXPECT_EQ(failure_of([&] { store->reviews().add_comment(comment); }).kind(),
              StoreError::Kind::kNotFound);
    EXPECT_EQ(failure_of([&] { store->reviews().set_comment_removed(77, true); }).kind(),
              StoreError::Kind::kNotFound);
}

TEST_P(StoreTest, ARaterRatesAnAttemptOnceAndNeverTheOwn) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    const int64_t eva = store->accounts().create(trainee("eva"));
    db::RatingRecord rating;
    rating.attempt_id = store->attempts().save(anna, make_result());
    rating.rater_id = eva;
    rating.questionnaire_id = "osats";
    rating.answers = {{"flow", "4"}, {"respect_for_tissue", "2"}};
    store->reviews().save_rating(rating);
    EXPECT_EQ(failure_of([&] { store->reviews().save_rating(rating); }).kind(),
              StoreError::Kind::kConflict);
    rating.rater_id = anna;
    EXPECT_EQ(failure_of([&] { store->reviews().save_rating(rating); }).kind(),
              StoreError::Kind::kRefused);
    const auto found = store->reviews().ratings("osats");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].answers, rating.answers);
    EXPECT_TRUE(found[0].blinded);
    EXPECT_THAT(store->reviews().ratings("other"), IsEmpty());
}

// --- attempts ----------------------------------------------------------------------------------

TEST_P(StoreTest, AnAttemptComesBackExactly) {
    const auto store = open();
    const int64_t user = store->accounts().create(trainee("anna"));
    const db::AttemptResult result = make_result();
    const int64_t id = store->attempts().save(user, result);
    const db::AttemptDetail detail = store->attempts().detail(id);

    EXPECT_EQ(detail.record.user_id, user);
    EXPECT_EQ(detail.record.user_name, "Name of anna");
    EXPECT_EQ(detail.record.task_id, "diathermy_ring");
    EXPECT_EQ(detail.record.task_version, 2);
    EXPECT_EQ(detail.record.started_utc, "2026-01-02T03:04:05.000Z");
    EXPECT_EQ(detail.record.duration_s, 1.0 / 3.0);
    EXPECT_EQ(detail.record.seed, std::numeric_limits<uint64_t>::max() - 1);
    EXPECT_EQ(detail.record.end, sim::EndReason::kTimeLimit);
    EXPECT_TRUE(detail.record.demonstration);
    EXPECT_EQ(detail.record.points, 71.30000000000001);
    EXPECT_EQ(detail.record.verdict, assessment::Verdict::kPassed);
    EXPECT_EQ(detail.record.rubric_version, 4);

    ASSERT_EQ(detail.metrics.values.size(), result.metrics.values.size());
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(detail.metrics.values[i].id, result.metrics.values[i].id);
        EXPECT_EQ(detail.metrics.values[i].value, result.metrics.values[i].value);
    }
    EXPECT_TRUE(std::isnan(detail.metrics.values[4].value));

    ASSERT_EQ(detail.score.reasons.size(), 2u);
    EXPECT_EQ(detail.score.reasons[0].text, result.score.reasons[0].text);
    EXPECT_EQ(detail.score.reasons[0].points, 12.5);
    EXPECT_EQ(detail.score.reasons[0].time_s, 7.25);
    EXPECT_FALSE(detail.score.reasons[0].critical);
    EXPECT_TRUE(detail.score.reasons[1].critical);
    for (size_t i = 0; i < 2; ++i)
        EXPECT_EQ(detail.score.reasons[i].meaning, result.score.reasons[i].meaning) << i;

    ASSERT_EQ(detail.events.size(), 1u) << "vaporised elements and hashes stay in the recording";
    const sim::Event& event = detail.events[0];
    EXPECT_EQ(event.kind, sim::EventKind::kDwell);
    EXPECT_EQ(event.time_s, 0.1);
    EXPECT_EQ(event.value, 3.2f);
    EXPECT_EQ(event.value2, -0.1f);
    EXPECT_EQ(event.rest_position_m, result.events[1].rest_position_m);
    EXPECT_EQ(event.element, 40000);
    EXPECT_EQ(event.tissue, sim::Tissue::kZone);
}

TEST_P(StoreTest, AttemptsAreListedByPersonAndTaskOldestFirst) {
    const auto store = open();
    const int64_t anna = store->accounts().create(trainee("anna"));
    const int64_t bert = store->accounts().create(trainee("bert"));
    db::AttemptResult late = make_result();
    late.header.started_utc = "2026-05-01T00:00:00.000Z";
    const int64_t second = store->attempts().save(anna, late);
    const int64_t first = store->attempts().save(anna, make_result());
    const int64_t other = store->attempts().save(anna, make_result("release"));
    const int64_t berts = store->attempts().save(bert, make_result());
    const auto ids = [](const std::vector<db::AttemptRecord>& records) {
        std::vector<int64_t> list;
        for (const auto& record : records) list.push_back(record.id);
        return list;
    };
    EXPECT_EQ(ids(store->attempts().list(anna)), (std::vector<int64_t>{first, other, second}));
    EXPECT_EQ(ids(store->attempts().list(anna, "diathermy_ring")),
              (std::vector<int64_t>{first, second}));
    EXPECT_EQ(ids(store->attempts().list(0, "diathermy_ring")),
              (std::vector<int64_t>{first, berts, second}));
    EXPECT_EQ(store->attempts().list(0).size(), 4u);
    EXPECT_THAT(store->attempts().list(bert, "release"), IsEmpty());
}

TEST_P(StoreTest, ARecordingComesBackByteForByte) {
    const auto store = open();
    const int64_t user = store->accounts().create(trainee("anna"));
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("a.placode");
    write_recording(result.recording_file);
    EXPECT_FALSE(store->attempts().find_recording(result.recording_file).has_value());
    const int64_t id = store->attempts().save(user, result);
    EXPECT_EQ(store->attempts().find_recording(result.recording_file), id);
    const std::string copy = folder.file("copy.placode");
    store->attempts().extract_recording(id, copy);
    EXPECT_EQ(read_text(copy), read_text(result.recording_file));
    EXPECT_EQ(db::read_recording_file(copy).inputs.size(), 2000u);
}

TEST_P(StoreTest, WhatIsNotThereIsSaidSo) {
    const auto store = open();
    const int64_t user = store->accounts().create(trainee("anna"));
    EXPECT_EQ(failure_of([&] { (void)store->attempts().detail(77); }).kind(),
              StoreError::Kind::kNotFound);
    EXPECT_EQ(failure_of([&] { store->attempts().save(77, make_result()); }).kind(),
              StoreError::Kind::kNotFound);
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("missing.placode");
    EXPECT_EQ(failure_of([&] { store->attempts().save(user, result); }).kind(),
              StoreError::Kind::kNotFound);
    EXPECT_THAT(store->attempts().list(0), IsEmpty());
    const int64_t id = store->attempts().save(user, make_result());
    EXPECT_EQ(failure_of([&] { store->attempts().extract_recording(id, folder.file("x")); }).kind(),
              StoreError::Kind::kNotFound);
}

TEST_P(StoreTest, ADamagedRecordingInTheStoreIsFound) {
    const auto store = open();
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("a.placode");
    write_recording(result.recording_file);
    const int64_t id = store->attempts().save(store->accounts().create(trainee("anna")), result);
    EXPECT_THAT(store->check(), IsEmpty());
    const std::string half = is_sqlite() ? "CAST(substr(content, 1, length(content) / 2) AS BLOB)"
                                         : "substr(content, 1, length(content) / 2)";
    ASSERT_TRUE(raw().run("UPDATE recordings SET content = " + half));
    EXPECT_EQ(failure_of([&] { store->attempts().extract_recording(id, folder.file("x")); }).kind(),
              StoreError::Kind::kDamaged);
    EXPECT_FALSE(fs::exists(folder.file("x")));
    ASSERT_EQ(store->check().size(), 1u);
    EXPECT_THAT(store->check()[0], HasSubstr("attempt " + std::to_string(id)));
}

TEST_P(StoreTest, AFailingWriteLeavesNothingOfAnAttemptBehind) {
    const auto store = open();
    const int64_t user = store->accounts().create(trainee("anna"));
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("a.placode");
    write_recording(result.recording_file);
    // The recording is written near the end: make just that fail.
    RawConnection saboteur = raw();
    ASSERT_TRUE(saboteur.run(is_sqlite()
                                 ? "CREATE TRIGGER sabotage BEFORE INSERT ON recordings BEGIN "
                                   "SELECT RAISE(ABORT, 'disk broke'); END"
                                 : "ALTER TABLE recordings ADD CONSTRAINT sabotage CHECK (false)"))
        << saboteur.problem();
    const size_t trail = store->audit().trail(1000).size();
    (void)failure_of([&] { store->attempts().save(user, result); });
    EXPECT_THAT(store->attempts().list(0), IsEmpty());
    for (const char* table :
         {"attempts", "attempt_metrics", "attempt_reasons", "attempt_events", "recordings"})
        EXPECT_EQ(saboteur.value(std::string("SELECT COUNT(*) FROM ") + table), "0") << table;
    EXPECT_EQ(store->audit().trail(1000).size(), trail);
    EXPECT_TRUE(fs::exists(result.recording_file));
    ASSERT_TRUE(saboteur.run(is_sqlite() ? "DROP TRIGGER sabotage"
                                         : "ALTER TABLE recordings DROP CONSTRAINT sabotage"));
    store->attempts().save(user, result);  // The same store goes on.
    EXPECT_EQ(store->attempts().list(0).size(), 1u);
}

// --- studies -----------------------------------------------------------------------------------

TEST_P(StoreTest, ParticipantsAreNumberedByStudyWithACheckLetter) {
    const auto store = open();
    const std::string first = store->studies().new_participant("pilot");
    const std::string second = store->studies().new_participant("pilot");
    EXPECT_THAT(first, testing::StartsWith("P001-"));
    EXPECT_THAT(second, testing::StartsWith("P002-"));
    EXPECT_EQ(store->studies().new_participant("other"), first);
    EXPECT_TRUE(db::valid_participant_code(second));
}

TEST(Participant, EveryWrongDigitAndEverySwapIsCaught) {
    for (int number = 1; number < 2000; ++number) {
        const std::string code = db::participant_code(number);
        ASSERT_TRUE(db::valid_participant_code(code)) << code;
        const size_t digits = code.size() - 3;
        for (size_t at = 1; at <= digits; ++at) {
            for (char digit = '0'; digit <= '9'; ++digit) {
                std::string wrong = code;
                wrong[at] = digit;
                ASSERT_EQ(db::valid_participant_code(wrong), wrong == code) << wrong;
            }
            std::string swapped = code;
            if (at < digits) std::swap(swapped[at], swapped[at + 1]);
            ASSERT_EQ(db::valid_participant_code(swapped), swapped == code) << swapped;
        }
    }
    for (const char* wrong : {"", "P", "P001", "P001-", "001-A", "Pabc-A", "P001A"})
        EXPECT_FALSE(db::valid_participant_code(wrong)) << wrong;
}

TEST_P(StoreTest, AnswersComeBackAsTheyWereGiven) {
    const auto store = open();
    db::AnswerRecord record;
    record.study_id = "pilot";
    record.participant = store->studies().new_participant("pilot");
    record.questionnaire_id = "seed_paper";
    record.questionnaire_version = 2;
    record.answered_utc = "2026-01-02T03:04:05.000Z";
    record.answers = {{"A", "5"}, {"F", "=cmd|' /C calc'!A0\nzażółć \"x\""}};
    record.demonstration = true;
    const int64_t id = store->studies().save_answers(record);
    db::AnswerRecord none = record;
    none.answers.clear();
    none.answered_utc.clear();
    store->studies().save_answers(none);
    const auto found = store->studies().answers("pilot");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].id, id);
    EXPECT_EQ(found[0].answers, record.answers);
    EXPECT_EQ(found[0].participant, record.participant);
    EXPECT_EQ(found[0].questionnaire_version, 2);
    EXPECT_TRUE(found[0].demonstration);
    EXPECT_THAT(found[1].answers, IsEmpty());
    EXPECT_FALSE(found[1].answered_utc.empty());
    EXPECT_THAT(store->studies().answers("other"), IsEmpty());
    record.participant = "P099-X";
    EXPECT_EQ(failure_of([&] { store->studies().save_answers(record); }).kind(),
              StoreError::Kind::kNotFound);
}

}  // namespace THIS_TEST
