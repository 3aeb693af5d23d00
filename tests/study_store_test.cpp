// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Studies in the store, on both engines: published text, consent, what was answered and changed,
// withdrawal.

#include <gmock/gmock.h>

#include "curriculum/study.h"
#include "db/store.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using db::WithdrawalMode;
using testing::HasSubstr;

namespace {

World* const world = World::install();

std::string study_text(int version, const std::string& title = "t") {
    return R"({"id":"pilot","version":)" + std::to_string(version) + R"(,"title":{"en":")" + title +
           R"("},"consent":{"version":1,"information":[{"en":"i"}],"statements":[{"id":"a",)"
           R"("text":{"en":"yes"}}]},"arms":{"names":[{"en":"x"},{"en":"y"}],"block_size":4},)"
           R"("steps":[{"id":"consent","kind":"consent"},)"
           R"({"id":"run","kind":"procedure","task":"diathermy_ring"}]})";
}

db::DefinitionRecord study(int version, const std::string& reason = "",
                           const std::string& title = "t") {
    db::DefinitionRecord record;
    record.kind = "study";
    record.id = "pilot";
    record.version = version;
    record.json = study_text(version, title);
    record.reason = reason;
    return record;
}

class StudyStore : public EngineTest {
 protected:
    void ready() override { store = open(); }
    [[nodiscard]] db::StepRecord step(const std::string& code, const std::string& name) const {
        db::StepRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.step = name;
        return record;
    }
    [[nodiscard]] db::AnswerRecord answer(const std::string& code) const {
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        record.answers = {{"sus01", "4"}};
        record.language = "pl";
        record.changes = {{"sus01", "", "2", "2026-01-01T00:00:00Z"},
                          {"sus01", "2", "4", "2026-01-01T00:00:02Z"}};
        return record;
    }

    std::unique_ptr<db::Store> store;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, StudyStore, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(StudyStore, APublishedTextIsNeverChanged) {
    store->publish(study(1));
    EXPECT_NO_THROW(store->publish(study(1))) << "the same text again is no change";
    const auto conflict = failure_of([&] { store->publish(study(1, "", "other")); });
    EXPECT_EQ(conflict.kind(), StoreError::Kind::kConflict);
    EXPECT_THAT(conflict.what(), HasSubstr("next version"));
    EXPECT_EQ(failure_of([&] { store->publish(study(2)); }).kind(), StoreError::Kind::kRefused)
        << "an amendment without a reason";
    store->publish(study(2, "the committee asked for it", "other"));
    EXPECT_EQ(failure_of([&] { store->publish(study(1, "x", "old")); }).kind(),
              StoreError::Kind::kConflict);
    ASSERT_EQ(store->definitions("study").size(), 2u);
    EXPECT_EQ(store->definition("study", "pilot")->version, 2);
    EXPECT_EQ(store->definition("study", "pilot")->reason, "the committee asked for it");
    EXPECT_EQ(store->definition("study", "pilot", 1)->json, study_text(1));
    EXPECT_FALSE(raw().run("UPDATE definitions SET content = 'x'")) << "past the store neither";
    EXPECT_FALSE(raw().run("DELETE FROM definitions"));
    auto broken = study(3, "x");
    broken.json = "{}";
    EXPECT_THROW(store->publish(broken), curriculum::DefinitionError);
    broken.json = study_text(4);
    EXPECT_THROW(store->publish(broken), curriculum::DefinitionError) << "says 4, is 3";
}

TEST_P(StudyStore, NothingIsRecordedBeforeConsent) {
    store->publish(study(1));
    const std::string code = store->new_participant("pilot", true);
    EXPECT_THAT(failure_of([&] { store->save_answers(answer(code)); }).what(),
                HasSubstr("has not consented"));
    EXPECT_THAT(failure_of([&] { store->record_step(step(code, "run")); }).what(),
                HasSubstr("has not consented"));
    auto consent = step(code, "consent");
    consent.detail = "consent version 1, en";
    store->record_step(consent);
    auto run = step(code, "run");
    run.attempt_id = 12;
    run.state = db::StepState::kStarted;
    store->record_step(run);
    store->save_answers(answer(code));
    const auto steps = store->steps("pilot");
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].detail, "consent version 1, en");
    EXPECT_EQ(steps[1].attempt_id, 12);
    EXPECT_EQ(steps[1].state, db::StepState::kStarted);
    const auto answers = store->answers("pilot");
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].language, "pl");
    ASSERT_EQ(answers[0].changes.size(), 2u);
    EXPECT_EQ(answers[0].changes[1].old_answer, "2");
    EXPECT_EQ(answers[0].changes[1].new_answer, "4");
    EXPECT_TRUE(store->participants("pilot").at(0).demonstration);
    EXPECT_EQ(store->participants("pilot").at(0).protocol_version, 1);
}

TEST_P(StudyStore, ArmsAreBalancedAndTheSeedStaysInTheStore) {
    store->publish(study(1));
    for (int i = 0; i < 12; ++i) store->new_participant("pilot");
    int ones = 0;
    const auto participants = store->participants("pilot");
    for (size_t i = 0; i < participants.size(); ++i) {
        ASSERT_GE(participants[i].arm, 0);
        ones += participants[i].arm;
        if (i % 4 == 3) {
            EXPECT_EQ(2 * ones, static_cast<int>(i) + 1);
        }
    }
    const std::string seed = raw().value("SELECT seed FROM study_allocations");
    ASSERT_FALSE(seed.empty());
    for (const auto& entry : store->audit_trail(100))
        EXPECT_THAT(entry.detail, testing::Not(HasSubstr(seed)));
}

TEST_P(StudyStore, WithdrawalStopsKeepsOrErasesAndTheTombstoneStays) {
    store->publish(study(1));
    std::vector<std::string> codes;
    for (int i = 0; i < 3; ++i) {
        codes.push_back(store->new_participant("pilot"));
        store->record_step(step(codes.back(), "consent"));
        store->save_answers(answer(codes.back()));
    }
    store->create_user({"anna", "Anna", "correct horse battery", 1, false});
    db::AttemptResult attempt;
    attempt.header.task_id = "diathermy_ring";
    attempt.header.started_utc = "2026-01-02T03:04:05.000Z";
    attempt.metrics.values = {{"path_length_mm", 1}};
    auto run = step(codes[2], "run");
    run.attempt_id = store->save_attempt(store->user_by_login("anna")->id, attempt);
    store->record_step(run);

    EXPECT_EQ(
        failure_of([&] { store->withdraw("pilot", codes[0], WithdrawalMode::kKeep, ""); }).kind(),
        StoreError::Kind::kRefused);
    store->withdraw("pilot", codes[0], WithdrawalMode::kKeep, "no time");
    store->withdraw("pilot", codes[1], WithdrawalMode::kStop, "not given");
    store->withdraw("pilot", codes[2], WithdrawalMode::kErase, "asked for it");
    const auto participants = store->participants("pilot");
    ASSERT_EQ(participants.size(), 3u) << "the tombstones stay";
    EXPECT_TRUE(participants[0].usable());
    EXPECT_FALSE(participants[1].usable());
    EXPECT_EQ(participants[2].withdrawal, WithdrawalMode::kErase);
    EXPECT_EQ(participants[2].withdrawal_reason, "asked for it");
    EXPECT_EQ(store->answers("pilot").size(), 2u);
    EXPECT_EQ(store->steps("pilot").size(), 2u);
    EXPECT_TRUE(store->attempts(0).empty()) << "the attempt of the study is erased as well";
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM answer_changes"), "4");
    EXPECT_THAT(failure_of([&] { store->save_answers(answer(codes[0])); }).what(),
                HasSubstr("has withdrawn"));
    // Less use may follow, never more.
    EXPECT_EQ(
        failure_of([&] { store->withdraw("pilot", codes[1], WithdrawalMode::kKeep, "x"); }).kind(),
        StoreError::Kind::kConflict);
    store->withdraw("pilot", codes[1], WithdrawalMode::kErase, "asked for it later");
    EXPECT_EQ(store->answers("pilot").size(), 1u);
    EXPECT_TRUE(store->check().empty());
    EXPECT_EQ(store->audit_trail(1).at(0).action, "study.withdraw");
    EXPECT_EQ(store->new_participant("pilot").substr(0, 4), "P004") << "a code is never used twice";
}

TEST_P(StudyStore, AStudyWithoutAProtocolWorksAsBefore) {
    const std::string code = store->new_participant("thin");
    auto record = answer(code);
    record.study_id = "thin";
    EXPECT_NO_THROW(store->save_answers(record));
    EXPECT_EQ(store->participants("thin").at(0).arm, -1);
    EXPECT_EQ(store->study_ids(), std::vector<std::string>{"thin"});
    EXPECT_EQ(store->definition("study", "thin"), std::nullopt);
}
