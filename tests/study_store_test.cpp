// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Studies in the store, on both engines: published text, consent, what was answered and changed,
// withdrawal.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "curriculum/study.h"
#include "db/consent.h"
#include "db/ended_again.h"
#include "db/erasure.h"
#include "db/packing.h"
#include "db/store.h"
#include "db/study_conduct.h"
#include "db/study_records.h"
#include "db/unsaved_recordings.h"
#include "tests/recorded_attempt.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using db::WithdrawalMode;
using testing::HasSubstr;

namespace THIS_TEST {

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

/// Puts another text into a definition in place of one that it holds.
void put(db::DefinitionRecord& definition, const std::string& old, const std::string& text) {
    definition.json.replace(definition.json.find(old), old.size(), text);
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

    [[nodiscard]] static db::AttemptResult attempt(const std::string& started_utc) {
        db::AttemptResult result;
        result.header.task_id = "diathermy_ring";
        result.header.started_utc = started_utc;
        result.header.mode = "study";
        result.end.reason = sim::EndReason::kFinished;
        result.metrics.values = {{"path_length_mm", 1}};
        return result;
    }
    /// The step "run", done by an attempt that was made while carl was signed in.
    int64_t perform(const std::string& code, double duration_s = 90,
                    sim::EndReason end = sim::EndReason::kFinished,
                    std::vector<sim::Event> events = {}) {
        auto result = attempt("2026-01-02T03:04:05.000Z");
        result.end.reason = end;
        result.end.duration_s = duration_s;
        result.events = std::move(events);
        result.study = {"pilot", code};
        auto run = step(code, "run");
        run.attempt_id = save_recorded(*store, store->accounts().find_login("carl")->id, result,
                                       folder.path().string());
        db::record_attempt_step(*store, run);
        return run.attempt_id;
    }

    std::unique_ptr<db::Store> store;
};

INSTANTIATE_TEST_SUITE_P(Engines, StudyStore, testing::Values("Sqlite", "Postgresql"), engine_name);

TEST_P(StudyStore, APublishedTextIsNeverChanged) {
    store->definitions().publish(study(1));
    EXPECT_NO_THROW(store->definitions().publish(study(1))) << "the same text again is no change";
    const auto conflict = failure_of([&] { store->definitions().publish(study(1, "", "other")); });
    EXPECT_EQ(conflict.kind(), StoreError::Kind::kConflict);
    EXPECT_THAT(conflict.what(), HasSubstr("next version"));
    EXPECT_EQ(failure_of([&] { store->definitions().publish(study(2)); }).kind(),
              StoreError::Kind::kRefused)
        << "an amendment without a reason";
    store->definitions().publish(study(2, "the committee asked for it", "other"));
    EXPECT_EQ(failure_of([&] { store->definitions().publish(study(1, "x", "old")); }).kind(),
              StoreError::Kind::kConflict);
    ASSERT_EQ(store->definitions().list("study").size(), 2u);
    EXPECT_EQ(store->definitions().find("study", "pilot")->version, 2);
    EXPECT_EQ(store->definitions().find("study", "pilot")->reason, "the committee asked for it");
    EXPECT_EQ(store->definitions().find("study", "pilot", 1)->json, study_text(1));
    EXPECT_FALSE(raw().run("UPDATE definitions SET content = 'x'")) << "past the store neither";
    EXPECT_FALSE(raw().run("DELETE FROM definitions"));
    auto broken = study(3, "x");
    broken.json = "{}";
    EXPECT_THROW(store->definitions().publish(broken), curriculum::DefinitionError);
    broken.json = study_text(4);
    EXPECT_THROW(store->definitions().publish(broken), curriculum::DefinitionError)
        << "says 4, is 3";
}

TEST_P(StudyStore, NothingIsRecordedBeforeConsent) {
    store->definitions().publish(study(1));
    const std::string code = store->studies().new_participant("pilot", true);
    EXPECT_THAT(failure_of([&] { store->studies().save_answers(answer(code)); }).what(),
                HasSubstr("has not consented"));
    EXPECT_THAT(failure_of([&] { store->studies().record_step(step(code, "run")); }).what(),
                HasSubstr("has not consented"));
    auto consent = step(code, "consent");
    consent.detail = "consent version 1, en";
    store->studies().record_step(consent);
    auto run = step(code, "run");
    run.attempt_id = 12;
    run.state = db::StepState::kStarted;
    store->studies().record_step(run);
    store->studies().save_answers(answer(code));
    const auto steps = store->studies().steps("pilot");
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].detail, "consent version 1, en");
    EXPECT_EQ(steps[1].attempt_id, 12);
    EXPECT_EQ(steps[1].state, db::StepState::kStarted);
    const auto answers = store->studies().answers("pilot");
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0].language, "pl");
    ASSERT_EQ(answers[0].changes.size(), 2u);
    EXPECT_EQ(answers[0].changes[1].old_answer, "2");
    EXPECT_EQ(answers[0].changes[1].new_answer, "4");
    EXPECT_TRUE(store->studies().participants("pilot").at(0).demonstration);
    EXPECT_EQ(store->studies().participants("pilot").at(0).protocol_version, 1);
}

TEST_P(StudyStore, AConsentIsToTheTextOfTheParticipantsVersion) {
    store->definitions().publish(study(1));
    const std::string before = store->studies().new_participant("pilot");
    auto amended = study(2, "the committee asked for it");
    put(amended, R"("consent":{"version":1)", R"("consent":{"version":2)");
    put(amended, R"({"id":"a",)", R"({"id":"b","text":{"en":"that as well"}},{"id":"a",)");
    put(amended, R"({"id":"consent",)", R"({"id":"agree",)");
    store->definitions().publish(amended);
    const std::string after = store->studies().new_participant("pilot");

    db::record_consent(*store, "pilot", before, "en", {"a"});
    EXPECT_THAT(failure_of([&] { db::record_consent(*store, "pilot", after, "en", {"a"}); }).what(),
                HasSubstr("the statement \"b\" is required"));
    db::record_consent(*store, "pilot", after, "en", {"a", "b"});
    const auto given = db::given_consents(store->studies().steps("pilot"));
    ASSERT_EQ(given.size(), 2u);
    EXPECT_EQ(given.at(before).version, 1);
    EXPECT_EQ(given.at(before).text_checksum, db::checksum_hex(std::string("i\nyes\n")));
    EXPECT_EQ(given.at(after).version, 2);
    EXPECT_EQ(given.at(after).text_checksum,
              db::checksum_hex(std::string("i\nthat as well\nyes\n")));
    for (const db::Progress& each : db::study_progress(*store, "pilot"))
        EXPECT_EQ(each.next, "run") << each.participant.code;
    EXPECT_NO_THROW(store->studies().save_answers(answer(before)));
}

TEST_P(StudyStore, ArmsKeepTheirNamesAndOrderOnceSomebodyIsAllocated) {
    const auto with_arms = [](int version, const std::string& names, const std::string& size) {
        auto amended = study(version, "the committee asked for it");
        put(amended, R"([{"en":"x"},{"en":"y"}],"block_size":4)",
            "[" + names + R"(],"block_size":)" + size);
        return amended;
    };
    const auto refused = [&](const db::DefinitionRecord& amended) {
        return failure_of([&] { store->definitions().publish(amended); });
    };
    store->definitions().publish(study(1));
    store->definitions().publish(with_arms(2, R"({"en":"y"},{"en":"x"})", "4"));
    ASSERT_EQ(store->definitions().find("study", "pilot")->version, 2) << "nobody is there yet";
    (void)store->studies().new_participant("pilot");
    EXPECT_EQ(refused(study(3, "as it was")).kind(), StoreError::Kind::kRefused);
    EXPECT_THAT(refused(with_arms(3, R"({"en":"y"},{"en":"z"})", "4")).what(),
                HasSubstr("allocated to the arms of version 2; keep their names and order"));
    auto without = study(3, "no arms");
    put(without, R"("arms":{"names":[{"en":"x"},{"en":"y"}],"block_size":4},)", "");
    EXPECT_EQ(refused(without).kind(), StoreError::Kind::kRefused);
    EXPECT_NO_THROW(store->definitions().publish(
        with_arms(3, R"({"en":"y","pl":"igrek"},{"en":"x"},{"en":"z"})", "6")))
        << "one more, and a translation";
}

TEST_P(StudyStore, ArmsAreBalancedAndTheSeedStaysInTheStore) {
    store->definitions().publish(study(1));
    for (int i = 0; i < 12; ++i) store->studies().new_participant("pilot");
    int ones = 0;
    const auto participants = store->studies().participants("pilot");
    for (size_t i = 0; i < participants.size(); ++i) {
        ASSERT_GE(participants[i].arm, 0);
        ones += participants[i].arm;
        if (i % 4 == 3) {
            EXPECT_EQ(2 * ones, static_cast<int>(i) + 1);
        }
    }
    const std::string seed = raw().value("SELECT seed FROM study_allocations");
    ASSERT_FALSE(seed.empty());
    for (const auto& entry : store->audit().trail(100))
        EXPECT_THAT(entry.detail, testing::Not(HasSubstr(seed)));
}

TEST_P(StudyStore, WithdrawalStopsKeepsOrErasesAndTheTombstoneStays) {
    store->definitions().publish(study(1));
    std::vector<std::string> codes;
    for (int i = 0; i < 3; ++i) {
        codes.push_back(store->studies().new_participant("pilot"));
        store->studies().record_step(step(codes.back(), "consent"));
        store->studies().save_answers(answer(codes.back()));
    }
    store->accounts().create({"anna", "Anna", "correct horse battery", 1, false});
    db::AttemptResult attempt;
    attempt.header.task_id = "diathermy_ring";
    attempt.header.started_utc = "2026-01-02T03:04:05.000Z";
    attempt.header.mode = "study";
    attempt.metrics.values = {{"path_length_mm", 1}};
    auto run = step(codes[2], "run");
    run.attempt_id = save_recorded(*store, store->accounts().find_login("anna")->id, attempt,
                                   folder.path().string());
    store->studies().record_step(run);

    EXPECT_EQ(failure_of([&] {
                  store->studies().withdraw("pilot", codes[0], WithdrawalMode::kKeep, "");
              }).kind(),
              StoreError::Kind::kRefused);
    store->studies().withdraw("pilot", codes[0], WithdrawalMode::kKeep, "no time");
    store->studies().withdraw("pilot", codes[1], WithdrawalMode::kStop, "not given");
    store->studies().withdraw("pilot", codes[2], WithdrawalMode::kErase, "asked for it");
    const auto participants = store->studies().participants("pilot");
    ASSERT_EQ(participants.size(), 3u) << "the tombstones stay";
    EXPECT_TRUE(participants[0].usable());
    EXPECT_FALSE(participants[1].usable());
    EXPECT_EQ(participants[2].withdrawal, WithdrawalMode::kErase);
    EXPECT_EQ(participants[2].withdrawal_reason, "asked for it");
    EXPECT_EQ(store->studies().answers("pilot").size(), 2u);
    EXPECT_EQ(store->studies().steps("pilot").size(), 2u);
    EXPECT_TRUE(store->attempts().list(0).empty()) << "the attempt of the study is erased as well";
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM answer_changes"), "4");
    EXPECT_THAT(failure_of([&] { store->studies().save_answers(answer(codes[0])); }).what(),
                HasSubstr("has withdrawn"));
    // Less use may follow, never more.
    EXPECT_EQ(failure_of([&] {
                  store->studies().withdraw("pilot", codes[1], WithdrawalMode::kKeep, "x");
              }).kind(),
              StoreError::Kind::kConflict);
    store->studies().withdraw("pilot", codes[1], WithdrawalMode::kErase, "asked for it later");
    EXPECT_EQ(store->studies().answers("pilot").size(), 1u);
    EXPECT_TRUE(store->check().empty());
    EXPECT_EQ(store->audit().trail(1).at(0).action, "study.withdraw");
    EXPECT_EQ(store->studies().new_participant("pilot").substr(0, 4), "P004")
        << "a code is never used twice";
}

TEST(WithdrawalModes, HaveOneWordEach) {
    EXPECT_EQ(db::withdrawal_mode_named("keep"), WithdrawalMode::kKeep);
    EXPECT_EQ(db::withdrawal_mode_named("stop"), WithdrawalMode::kStop);
    EXPECT_EQ(db::withdrawal_mode_named("erase"), WithdrawalMode::kErase);
    for (const char* word : {"", "Keep", "keep ", "erase: moved away", "kept"})
        EXPECT_FALSE(db::withdrawal_mode_named(word)) << word;
    for (const std::string_view word : db::kWithdrawalModeNames)
        EXPECT_EQ(db::withdrawal_mode_name(db::withdrawal_mode_named(word).value()), word);
}

// What store and trail keep is read as what was asked for.
TEST_P(StudyStore, AWithdrawalIsReadInTheModeItWasWrittenIn) {
    store->definitions().publish(study(1));
    for (const auto mode : {WithdrawalMode::kKeep, WithdrawalMode::kStop, WithdrawalMode::kErase}) {
        const std::string code = store->studies().new_participant("pilot");
        store->studies().withdraw("pilot", code, mode, "not given");
        const std::string word = db::withdrawal_mode_name(mode);
        EXPECT_EQ(store->studies().participants("pilot").back().withdrawal, mode);
        EXPECT_EQ(raw().value("SELECT mode FROM withdrawals WHERE code = '" + code + "'"), word);
        const auto ended = db::ended_records(store->audit().of_action("study.withdraw"));
        EXPECT_EQ(ended.back().code, code);
        EXPECT_EQ(ended.back().mode, mode);
        EXPECT_EQ(ended.back().entry.detail, word);
        EXPECT_THAT(failure_of([&] { store->studies().withdraw("pilot", code, mode, "x"); }).what(),
                    HasSubstr("has withdrawn already (" + word + ")"));
    }
}

TEST_P(StudyStore, AnAttemptOfAStudyBelongsToTheCodeAndToNobodyElse) {
    store->definitions().publish(study(1));
    const int64_t carl =
        store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    const int64_t group = store->groups().create("Everybody");
    store->groups().set_role(group, carl, db::GroupRole::kMember);
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    const int64_t own = store->attempts().save(carl, attempt("2026-01-02T03:04:05.000Z"));
    auto of_study = attempt("2026-01-02T04:04:05.000Z");
    of_study.study = {"pilot", code};
    const std::string recordings = folder.path().string();
    const int64_t theirs = save_recorded(*store, carl, of_study, recordings);
    // One that came in past the shell: the step that names it makes it the participant's.
    const int64_t named =
        save_recorded(*store, carl, attempt("2026-01-02T05:04:05.000Z"), recordings);
    auto run = step(code, "run");
    run.attempt_id = named;
    store->studies().record_step(run);
    EXPECT_EQ(store->attempts().detail(named).record.replay, db::ReplayState::kWaiting)
        << "as every attempt of a study";

    const std::string other_code = store->studies().new_participant("pilot");
    store->studies().record_step(step(other_code, "consent"));
    auto taken = step(other_code, "run");
    taken.attempt_id = theirs;
    EXPECT_EQ(failure_of([&] { store->studies().record_step(taken); }).kind(),
              StoreError::Kind::kRefused)
        << "it is somebody else's";

    const auto mine = store->attempts().list(carl);
    ASSERT_EQ(mine.size(), 1u);
    EXPECT_EQ(mine[0].id, own);
    EXPECT_EQ(store->attempts().list(0).size(), 3u) << "nothing is lost from the store";
    for (const int64_t id : {theirs, named}) {
        const auto record = store->attempts().detail(id).record;
        EXPECT_EQ(record.user_id, 0);
        EXPECT_EQ(record.user_name, code);
        EXPECT_EQ(record.study, (db::StudyContext{"pilot", code}));
    }
    db::AttemptFilter filter;
    EXPECT_EQ(store->attempts().page(filter).total, 1);
    filter.studies = true;
    EXPECT_EQ(store->attempts().page(filter).total, 3);
    filter.user_id = carl;
    EXPECT_EQ(store->attempts().page(filter).total, 1);
    for (const int64_t whom : {int64_t{0}, group}) {
        const auto standings = store->attempts().standings(whom);
        ASSERT_EQ(standings.size(), 1u);
        EXPECT_EQ(standings[0].attempts, 1);
        EXPECT_EQ(store->attempts().points(whom).size(), 1u);
    }
    EXPECT_EQ(store->attempts().recent_means("diathermy_ring", 3).at(0).attempts, 1);
    EXPECT_EQ(store->norms().measured_attempts(0, "diathermy_ring").size(), 1u);
    EXPECT_EQ(store->norms().measured_attempts(carl, "diathermy_ring").size(), 1u);
    EXPECT_EQ(store->attempts().tasks(), std::vector<std::string>{"diathermy_ring"});
    auto other = attempt("2026-01-02T06:04:05.000Z");
    other.header.task_id = "only_in_the_study";
    other.study = {"pilot", code};
    store->attempts().save(carl, other);
    EXPECT_EQ(store->attempts().tasks().size(), 1u);

    // Who was signed in may go; what participants did stays. Who withdraws takes all along.
    store->accounts().create({"ada", "Ada", "correct horse battery", 8, false});
    store->accounts().erase(carl, true);
    EXPECT_EQ(store->attempts().list(0).size(), 3u);
    store->studies().withdraw("pilot", code, WithdrawalMode::kErase, "asked for it");
    EXPECT_TRUE(store->attempts().list(0).empty());
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyStore, AnAttemptWithoutARecordingDoesNoStep) {
    store->definitions().publish(study(1));
    const int64_t carl =
        store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    auto of_study = attempt("2026-01-02T03:04:05.000Z");
    of_study.study = {"pilot", code};
    // Said at once, and when a step makes an attempt the participant's.
    const int64_t said = store->attempts().save(carl, of_study);
    const int64_t made = store->attempts().save(carl, attempt("2026-01-02T04:04:05.000Z"));
    EXPECT_EQ(store->attempts().detail(made).record.void_reason, "") << "practice";
    for (const int64_t id : {said, made}) {
        auto run = step(code, "run");
        run.attempt_id = id;
        db::record_attempt_step(*store, run);
        EXPECT_EQ(store->attempts().detail(id).record.void_reason,
                  "Practice, not verified: nothing was recorded");
        const auto kept = store->studies().steps("pilot").back();
        EXPECT_EQ(kept.state, db::StepState::kStarted);
        EXPECT_EQ(kept.detail, "void: Practice, not verified: nothing was recorded");
    }
    EXPECT_THAT(store->attempts().waiting_for_replay(), testing::IsEmpty());
}

TEST_P(StudyStore, AProcedureIsDoneAgainForAReasonAndBothAreKept) {
    store->definitions().publish(study(1));
    store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    store->act_as("carl");
    db::StudyRecords& records = store->records();
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    const auto refused = [&](const std::string& name, const std::string& reason) {
        return failure_of([&] { records.repeat_step("pilot", code, 1, name, reason); }).kind();
    };
    EXPECT_EQ(refused("run", "x"), StoreError::Kind::kRefused) << "nothing was done yet";
    const int64_t first = perform(code);
    EXPECT_TRUE(db::study_progress(*store, "pilot").at(0).next.empty());
    EXPECT_EQ(refused("run", ""), StoreError::Kind::kRefused) << "no reason";
    EXPECT_EQ(refused("consent", "x"), StoreError::Kind::kRefused) << "a consent has no attempt";
    EXPECT_EQ(failure_of([&] { records.repeat_step("pilot", "P999-X", 1, "run", "x"); }).kind(),
              StoreError::Kind::kNotFound);
    records.repeat_step("pilot", code, 1, "run", "the pedal was unplugged");
    EXPECT_EQ(store->audit().trail(1).at(0).action, "study.repeat");
    EXPECT_EQ(store->audit().trail(1).at(0).detail,
              "run, visit 1, instead of attempt " + std::to_string(first));
    EXPECT_EQ(refused("run", "twice"), StoreError::Kind::kRefused) << "nothing counts any more";
    auto progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_EQ(progress.next, "run");
    EXPECT_EQ(progress.done, 1);
    const int64_t second = perform(code);
    progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_TRUE(progress.next.empty());
    const auto steps = store->studies().steps("pilot");
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_EQ(steps[1].attempt_id, first);
    EXPECT_TRUE(steps[1].superseded());
    EXPECT_EQ(steps[1].superseded_reason, "the pedal was unplugged");
    EXPECT_EQ(steps[1].superseded_by, "carl");
    EXPECT_EQ(steps[2].attempt_id, second);
    EXPECT_FALSE(steps[2].superseded());

    records.lock("pilot", code);
    EXPECT_EQ(refused("run", "x"), StoreError::Kind::kRefused) << "a locked record is closed";
    records.unlock("pilot", code, "to erase it");
    store->studies().withdraw("pilot", code, WithdrawalMode::kErase, "asked for it");
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM superseded_steps"), "0");
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyStore, NotesAreKeptWithWhoWroteThemAndBelongToTheSignedRecord) {
    store->definitions().publish(study(1));
    store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    store->act_as("carl");
    db::StudyRecords& records = store->records();
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    EXPECT_EQ(failure_of([&] { records.note_step("pilot", code, 1, "run", ""); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(failure_of([&] { records.note_step("pilot", "P999-X", 1, "run", "x"); }).kind(),
              StoreError::Kind::kNotFound);
    records.note_step("pilot", code, 1, "run", "coughed");
    ASSERT_EQ(records.step_notes("pilot").size(), 1u);
    EXPECT_EQ(records.step_notes("pilot")[0].note, "coughed");
    EXPECT_EQ(records.step_notes("pilot")[0].noted_by, "carl");
    EXPECT_EQ(store->audit().trail(1).at(0).action, "study.note");
    records.lock("pilot", code);
    EXPECT_EQ(failure_of([&] { records.note_step("pilot", code, 1, "run", "x"); }).kind(),
              StoreError::Kind::kRefused);
    records.sign("pilot", code, "carl", "correct horse battery", "reviewed");
    EXPECT_TRUE(records.states("pilot").at(code).signature_fits);
    ASSERT_TRUE(raw().run("UPDATE step_notes SET note = 'something else'"));
    EXPECT_FALSE(records.states("pilot").at(code).signature_fits);
}

/// The trail is kept longer than a participant's data, and nobody can redact it.
TEST_P(StudyStore, WhatWasSaidOfAParticipantGoesWithTheErasure) {
    store->definitions().publish(study(1));
    store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    store->act_as("carl");
    db::StudyRecords& records = store->records();
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    perform(code);
    records.note_step("pilot", code, 1, "run", "coughed");
    EXPECT_EQ(store->audit().trail(1).at(0).detail,
              "run: note " + std::to_string(records.step_notes("pilot").at(0).id));
    records.repeat_step("pilot", code, 1, "run", "squinted 12");
    records.lock("pilot", code);
    records.sign("pilot", code, "carl", "correct horse battery", "reviewed 56");
    records.unlock("pilot", code, "mistyped 34");
    EXPECT_EQ(records.events("pilot").back().remark, "mistyped 34");
    EXPECT_THAT(store->audit().trail(1).at(0).detail,
                HasSubstr("event " + std::to_string(records.events("pilot").back().id) + ";"));
    store->studies().withdraw("pilot", code, WithdrawalMode::kStop, "fainted 78");
    store->studies().withdraw("pilot", code, WithdrawalMode::kErase, "not given");
    for (const db::AuditRecord& entry : store->audit().trail(1000))
        for (const char* said :
             {"coughed", "squinted 12", "reviewed 56", "mistyped 34", "fainted 78"})
            EXPECT_THAT(entry.object + " " + entry.detail, testing::Not(HasSubstr(said)));
    ASSERT_EQ(records.events("pilot").size(), 3u) << "what happened to the record stays";
    for (const db::RecordEvent& event : records.events("pilot")) EXPECT_EQ(event.remark, "");
    EXPECT_EQ(raw().value("SELECT COUNT(*) FROM withdrawals WHERE reason = 'not given'"), "1");
    EXPECT_TRUE(store->check().empty());
}

TEST_P(StudyStore, AnAttemptThatIsTooShortOrVoidDoesNotDoTheStep) {
    auto definition = study(1);
    definition.json.replace(definition.json.find(R"("task":"diathermy_ring")"), 0,
                            R"("min_s":30,)");
    store->definitions().publish(definition);
    store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    perform(code, 12);
    auto progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_EQ(progress.next, "run");
    EXPECT_EQ(progress.open_because, "ended after 12 s, before the least duration of 30 s");
    perform(code, 40, sim::EndReason::kInterrupted);
    EXPECT_EQ(db::study_progress(*store, "pilot").at(0).open_because, "interrupted");
    sim::Event slow;
    slow.kind = sim::EventKind::kMachineSpeed;
    slow.value = 1;
    slow.value2 = 12;
    perform(code, 40, sim::EndReason::kFinished, {slow});
    EXPECT_THAT(db::study_progress(*store, "pilot").at(0).open_because,
                HasSubstr("void: The computer was too slow: 12 pictures a second"));
    perform(code, 12, sim::EndReason::kFinished, {slow});
    EXPECT_THAT(db::study_progress(*store, "pilot").at(0).open_because,
                testing::StartsWith("ended after 12 s, before the least duration of 30 s; void: "))
        << "who ended too early is told so, whatever the computer did";
    const int64_t good = perform(code, 40);
    progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_TRUE(progress.next.empty());
    // Again for the same attempt: a crash between saving and removing.
    auto again = step(code, "run");
    again.attempt_id = good;
    db::record_attempt_step(*store, again);
    EXPECT_EQ(store->studies().steps("pilot").size(), 6u);

    // What was typed for another one is not taken for done.
    const std::string other = store->studies().new_participant("pilot");
    store->studies().record_step(step(other, "consent"));
    auto theirs = step(other, "run"), later = again, elsewhere = step(code, "briefing");
    theirs.attempt_id = elsewhere.attempt_id = good;
    later.visit = 2;
    for (const db::StepRecord& each : {theirs, later, elsewhere}) {
        const auto conflict = failure_of([&] { db::record_attempt_step(*store, each); });
        EXPECT_EQ(conflict.kind(), StoreError::Kind::kConflict);
        EXPECT_THAT(conflict.what(), HasSubstr("does the step \"run\" of visit 1 of " + code));
    }
    EXPECT_EQ(store->studies().steps("pilot").size(), 7u);
}

TEST_P(StudyStore, AStepTakesOverOnlyWhatItsCoordinatorRecordedForAStudy) {
    store->definitions().publish(study(1));
    // Sees every attempt, as an educator does.
    const int64_t carl =
        store->accounts().create({"carl", "Carl", "correct horse battery", 2 | 4, false});
    const int64_t anna =
        store->accounts().create({"anna", "Anna", "correct horse battery", 1, false});
    const std::string code = store->studies().new_participant("pilot");
    store->studies().record_step(step(code, "consent"));
    const auto saved = [&](int64_t whose, const std::string& mode,
                           const std::string& task = "diathermy_ring") {
        auto result = attempt("2026-01-02T03:04:05.000Z");
        result.header.mode = mode;
        result.header.task_id = task;
        return save_recorded(*store, whose, result, folder.path().string());
    };
    const auto own = is_sqlite() ? open() : open_at_station();  // There the server asks as well.
    ASSERT_EQ(own->accounts().sign_in("carl", "correct horse battery").outcome,
              db::SignInOutcome::kOk);
    const auto named = [&](int64_t id) {
        auto run = step(code, "run");
        run.attempt_id = id;
        return run;
    };
    const auto refused = [&](int64_t id) {
        return std::string(failure_of([&] { own->studies().record_step(named(id)); }).what());
    };
    const auto not_for_it = HasSubstr("was not recorded for a study under your account");
    const int64_t annas = saved(anna, "study");
    EXPECT_THAT(refused(annas), not_for_it);
    EXPECT_THAT(refused(saved(carl, "practice")), not_for_it);
    const int64_t exam = saved(carl, "study");
    ASSERT_TRUE(
        raw().run("UPDATE attempts SET exam_course = 'c' WHERE id = " + std::to_string(exam)));
    EXPECT_THAT(refused(exam), not_for_it);
    EXPECT_THAT(refused(saved(carl, "study", "grasp_and_lift")),
                HasSubstr("is of the task \"grasp_and_lift\"; this step asks for "
                          "\"diathermy_ring\""));
    const int64_t good = saved(carl, "study");
    own->studies().record_step(named(good));
    EXPECT_EQ(store->attempts().detail(good).record.user_name, code);

    // A row says what an earlier version took over: it is nobody's but its owner's.
    ASSERT_TRUE(raw().run("UPDATE study_steps SET attempt_id = " + std::to_string(annas) +
                          " WHERE step = 'run'"));
    own->studies().withdraw("pilot", code, WithdrawalMode::kErase, "asked for it");
    EXPECT_EQ(store->attempts().detail(annas).record.user_id, anna);
    EXPECT_THROW((void)store->attempts().detail(good), StoreError);
}

TEST_P(StudyStore, NothingMoreIsSavedOfWhoHasWithdrawn) {
    store->definitions().publish(study(1));
    const int64_t carl =
        store->accounts().create({"carl", "Carl", "correct horse battery", 4, false});
    const std::string code = store->studies().new_participant("pilot");
    auto of_study = attempt("2026-01-02T03:04:05.000Z");
    of_study.study = {"pilot", code};
    const auto refused = [&] {
        return std::string(
            failure_of([&] { (void)store->attempts().save(carl, of_study); }).what());
    };
    EXPECT_THAT(refused(), HasSubstr("has not consented"));
    store->studies().record_step(step(code, "consent"));
    store->studies().withdraw("pilot", code, WithdrawalMode::kStop, "not given");
    EXPECT_THAT(refused(), HasSubstr("has withdrawn"));
    EXPECT_TRUE(store->attempts().list(0).empty());
}

TEST_P(StudyStore, WhatACrashLeftOfWhoHasWithdrawnIsNamedOrRemoved) {
    const std::string place = folder.file("recordings");
    std::filesystem::create_directory(place);
    const auto leave = [&](const std::string& name, const std::string& code) {
        auto result = attempt("2026-01-02T03:04:05.000Z");
        record_to(place + "/" + name + ".placode", result);
        std::ofstream(place + "/" + name + ".placode.order.json")
            << R"({"user_id": 1, "study": "pilot", "participant": ")" << code << "\"}";
    };
    leave("a", "P001-X");
    leave("b", "P002-X");
    const std::vector<std::string> theirs{place + "/a.placode"};
    EXPECT_EQ(db::unsaved_recordings(place, {"pilot", "P001-X"}, db::Unsaved::kName), theirs);
    EXPECT_TRUE(std::filesystem::exists(theirs[0]));
    EXPECT_EQ(db::unsaved_recordings(place, {"pilot", "P001-X"}, db::Unsaved::kRemove), theirs);
    EXPECT_FALSE(std::filesystem::exists(theirs[0]));
    EXPECT_FALSE(std::filesystem::exists(theirs[0] + ".order.json"));
    EXPECT_TRUE(std::filesystem::exists(place + "/b.placode"));
    EXPECT_EQ(db::recordings_beside("sqlite:" + folder.file("placode.db")), place);
    EXPECT_EQ(db::recordings_beside("postgresql://a@b/c"), "") << "each computer has its own";
}

TEST_P(StudyStore, ASkippedStepIsOverAndNotDone) {
    store->definitions().publish(study(1));
    const std::string code = store->studies().new_participant("pilot");
    auto skipped = step(code, "consent");
    skipped.state = db::StepState::kSkipped;
    store->studies().record_step(skipped);
    const auto progress = db::study_progress(*store, "pilot").at(0);
    EXPECT_EQ(progress.done, 0);
    EXPECT_EQ(progress.skipped, std::vector<std::string>{"1/consent"});
    EXPECT_NE(progress.next, "consent") << "it is not asked for again";
}

TEST_P(StudyStore, TheDeviceIsTheCoordinatorsChoice) {
    store->definitions().publish(study(1));
    const std::string code = store->studies().new_participant("pilot");
    EXPECT_EQ(store->studies().participants("pilot").at(0).device, "");
    store->studies().set_participant_device("pilot", code, "mouse");
    store->studies().set_participant_device("pilot", code, "mouse");
    EXPECT_EQ(store->studies().participants("pilot").at(0).device, "mouse");
    EXPECT_EQ(store->audit().trail(2).at(1).action, "study.participant") << "no change, no entry";
    store->studies().set_participant_device("pilot", code, "gamepad");
    EXPECT_EQ(store->studies().participants("pilot").at(0).device, "gamepad");
    EXPECT_EQ(store->audit().trail(1).at(0).detail, "gamepad, before: mouse");
    EXPECT_EQ(failure_of([&] {
                  store->studies().set_participant_device("pilot", "P999-X", "mouse");
              }).kind(),
              StoreError::Kind::kNotFound);
}

TEST_P(StudyStore, AStudyWithoutAProtocolWorksAsBefore) {
    const std::string code = store->studies().new_participant("thin");
    auto record = answer(code);
    record.study_id = "thin";
    EXPECT_NO_THROW(store->studies().save_answers(record));
    EXPECT_EQ(store->studies().participants("thin").at(0).arm, -1);
    EXPECT_EQ(store->studies().ids(), std::vector<std::string>{"thin"});
    EXPECT_EQ(store->definitions().find("study", "thin"), std::nullopt);
}

}  // namespace THIS_TEST
