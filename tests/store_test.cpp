// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The same tests for both engines, and below what only one of them has.

#include "db/store.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "db/participant.h"
#include "db/recording_file.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

constexpr const char* kPassword = "correct horse battery";

World* const world = World::install();

db::NewUser trainee(const std::string& login) {
    return {login, "Name of " + login, kPassword, static_cast<db::Roles>(db::Role::kTrainee),
            false};
}

db::AttemptResult make_result(const std::string& task = "diathermy_ring") {
    db::AttemptResult result;
    result.header.task_id = task;
    result.header.task_version = 2;
    result.header.seed = std::numeric_limits<uint64_t>::max() - 1;
    result.header.build = "0.1.0 AVX2";
    result.header.device = "script:expert";
    result.header.started_utc = "2026-01-02T03:04:05.000Z";
    result.header.demonstration = true;
    result.end = {sim::EndReason::kTimeLimit, 1.0 / 3.0, ~uint64_t{0}, 0};
    result.metrics.values = {{"path_length_mm", 0.1},
                             {"tiny", std::numeric_limits<double>::denorm_min()},
                             {"large", std::numeric_limits<double>::max()},
                             {"third", -1.0 / 3.0},
                             {"unknown", std::numeric_limits<double>::quiet_NaN()}};
    result.score.points = 71.30000000000001;
    result.score.verdict = assessment::Verdict::kPassed;
    result.score.rubric_id = "ring";
    result.score.rubric_version = 4;
    result.score.reasons = {
        {"dwell", "Rested 3.2 s at 4 o'clock; \"zażółć\" -- ?", 12.5, 7.25, false},
        {"burn", "Placode burned", 0.1, -1, true}};
    sim::Event event;
    event.time_s = 0.1;
    event.kind = sim::EventKind::kDwell;
    event.tool = 0;
    event.tissue = sim::Tissue::kZone;
    event.value = 3.2f;
    event.value2 = -0.1f;
    event.rest_position_m = {0.001f, -0.002f, 1e-30f};
    event.element = 40000;
    sim::Event vaporised = event;
    vaporised.kind = sim::EventKind::kVaporised;
    sim::Event hash = event;
    hash.kind = sim::EventKind::kStateHash;
    result.events = {vaporised, event, hash};
    return result;
}

void write_recording(const std::string& path, int seconds = 2) {
    const auto sink = db::create_recording_file(path);
    sink->begin(make_result().header);
    for (int s = 0; s < seconds; ++s) {
        std::vector<sim::Input> inputs(1000);
        for (size_t i = 0; i < inputs.size(); ++i) {
            inputs[i].frame = s * 1000 + static_cast<int64_t>(i);
            inputs[i].tools[0].position_m[0] = std::sin(static_cast<float>(i));
        }
        sink->append(inputs, {}, {});
    }
    sink->finish({sim::EndReason::kFinished, double(seconds), 1, 0});
}

class StoreTest : public EngineTest {
 protected:
    void ready() override {
        options.now_ms = [this] { return now_ms; };
    }
    [[nodiscard]] std::unique_ptr<db::Store> open(int timeout_ms = 5000) const {
        return db::open_store(url() + "?timeout_ms=" + std::to_string(timeout_ms), options);
    }

    int64_t now_ms = 1'700'000'000'000;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, StoreTest, testing::Values("Sqlite", "Postgresql"), engine_name);

// --- review --------------------------------------------------------------------------------------

TEST_P(StoreTest, RemarksStandAtTheirTimesUntilTheyAreRemoved) {
    const auto store = open();
    const int64_t anna = store->create_user(trainee("anna"));
    const int64_t attempt = store->save_attempt(anna, make_result());
    db::CommentRecord comment;
    comment.attempt_id = attempt;
    comment.author_id = anna;
    comment.time_s = 0.5;
    comment.text = "Powoli, bez zatrzymania";
    const int64_t later = store->add_comment(comment);
    comment.time_s = 0.25;
    comment.text = "";
    store->add_comment(comment);
    auto found = store->comments(attempt);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].time_s, 0.25);
    EXPECT_EQ(found[1].text, "Powoli, bez zatrzymania");
    EXPECT_EQ(found[1].author_name, "Name of anna");
    store->set_comment_removed(later, true);
    EXPECT_EQ(store->comments(attempt).size(), 1u);
    store->set_comment_removed(later, false);
    EXPECT_EQ(store->comments(attempt).size(), 2u);
    EXPECT_THAT(store->comments(attempt + 1), IsEmpty());
}

TEST_P(StoreTest, ARemarkNeedsATimeWithinTheAttemptOrAText) {
    const auto store = open();
    const int64_t anna = store->create_user(trainee("anna"));
    db::CommentRecord comment;
    comment.attempt_id = store->save_attempt(anna, make_result());
    comment.author_id = anna;
    EXPECT_EQ(failure_of([&] { store->add_comment(comment); }).kind(), StoreError::Kind::kRefused);
    comment.time_s = 1e6;
    EXPECT_EQ(failure_of([&] { store->add_comment(comment); }).kind(), StoreError::Kind::kRefused);
    comment.attempt_id += 1;
    EXPECT_EQ(failure_of([&] { store->add_comment(comment); }).kind(), StoreError::Kind::kNotFound);
    EXPECT_EQ(failure_of([&] { store->set_comment_removed(77, true); }).kind(),
              StoreError::Kind::kNotFound);
}

TEST_P(StoreTest, ARaterRatesAnAttemptOnceAndNeverTheOwn) {
    const auto store = open();
    const int64_t anna = store->create_user(trainee("anna"));
    const int64_t eva = store->create_user(trainee("eva"));
    db::RatingRecord rating;
    rating.attempt_id = store->save_attempt(anna, make_result());
    rating.rater_id = eva;
    rating.questionnaire_id = "osats";
    rating.answers = {{"flow", "4"}, {"respect_for_tissue", "2"}};
    store->save_rating(rating);
    EXPECT_EQ(failure_of([&] { store->save_rating(rating); }).kind(), StoreError::Kind::kConflict);
    rating.rater_id = anna;
    EXPECT_EQ(failure_of([&] { store->save_rating(rating); }).kind(), StoreError::Kind::kRefused);
    const auto found = store->ratings("osats");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].answers, rating.answers);
    EXPECT_TRUE(found[0].blinded);
    EXPECT_THAT(store->ratings("other"), IsEmpty());
}

// --- accounts ----------------------------------------------------------------------------------

TEST_P(StoreTest, APersonWithTheRightPasswordSignsIn) {
    const auto store = open();
    db::NewUser user = trainee("Anna");
    user.roles = 5;
    user.demonstration = true;
    const int64_t id = store->create_user(user);
    const db::SignIn sign_in = store->sign_in(" anna ", kPassword);
    ASSERT_EQ(sign_in.outcome, db::SignInOutcome::kOk);
    ASSERT_TRUE(sign_in.user.has_value());
    EXPECT_EQ(sign_in.user->id, id);
    EXPECT_EQ(sign_in.user->login, "Anna");
    EXPECT_EQ(sign_in.user->display_name, "Name of Anna");
    EXPECT_EQ(sign_in.user->roles, 5);
    EXPECT_TRUE(sign_in.user->demonstration);
    EXPECT_TRUE(sign_in.user->active);
    EXPECT_FALSE(sign_in.user->created_utc.empty());
}

TEST_P(StoreTest, AccountsAreStillThereAfterClosing) {
    const int64_t id = open()->create_user(trainee("anna"));
    const auto store = open();
    ASSERT_EQ(store->users().size(), 1u);
    EXPECT_EQ(store->user(id)->login, "anna");
    EXPECT_EQ(store->user_by_login("ANNA")->id, id);
    EXPECT_FALSE(store->user(id + 1).has_value());
    EXPECT_FALSE(store->user_by_login("bert").has_value());
}

TEST_P(StoreTest, LoginsAreUniqueWithoutCase) {
    const auto store = open();
    store->create_user(trainee("Żaneta"));
    const auto error = failure_of([&] { store->create_user(trainee("żANETA")); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kConflict);
    EXPECT_THAT(error.what(), HasSubstr("taken"));
    EXPECT_EQ(store->users().size(), 1u);
}

TEST_P(StoreTest, WeakPasswordsAreRefused) {
    const auto store = open();
    for (const auto& [login, password] :
         std::vector<std::pair<std::string, std::string>>{{"anna", "short"},
                                                          {"anna", "ąąąąąąąąą"},  // 9 characters
                                                          {"annaannaanna", "AnnaAnnaAnna"}}) {
        db::NewUser user = trainee(login);
        user.password = password;
        EXPECT_EQ(failure_of([&] { store->create_user(user); }).kind(), StoreError::Kind::kRefused);
    }
    EXPECT_THAT(store->users(), IsEmpty());
    const int64_t id = store->create_user(trainee("anna"));
    EXPECT_EQ(failure_of([&] { store->set_password(id, "123456789"); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
}

TEST_P(StoreTest, AWrongPasswordIsNotToldFromAnUnknownLogin) {
    const auto store = open();
    store->create_user(trainee("anna"));
    EXPECT_EQ(store->sign_in("anna", "wrong password").outcome, db::SignInOutcome::kWrong);
    EXPECT_EQ(store->sign_in("nobody", "wrong password").outcome, db::SignInOutcome::kWrong);
    EXPECT_FALSE(store->sign_in("anna", "").user.has_value());
}

TEST_P(StoreTest, ThePasswordItselfIsNowhere) {
    open()->create_user(trainee("anna"));
    const std::string hash = raw().value("SELECT password_hash FROM accounts");
    EXPECT_THAT(hash, testing::StartsWith("$argon2id$"));
    EXPECT_THAT(hash, Not(HasSubstr(kPassword)));
}

TEST_P(StoreTest, NamesStandApartFromAccounts) {
    open()->create_user(trainee("anna"));
    EXPECT_EQ(raw().value("SELECT login FROM persons"), "anna");
    EXPECT_FALSE(raw().run("SELECT login FROM accounts"));
    EXPECT_FALSE(raw().run("SELECT display_name FROM attempts"));
}

TEST_P(StoreTest, AfterFiveWrongTriesEachFurtherOneWaitsLonger) {
    const auto store = open();
    store->create_user(trainee("anna"));
    for (const char* login : {"anna", "nobody"}) {
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(store->sign_in(login, "wrong password").outcome, db::SignInOutcome::kWrong);
        const db::SignIn throttled = store->sign_in(login, kPassword);
        EXPECT_EQ(throttled.outcome, db::SignInOutcome::kThrottled) << "even the right one waits";
        EXPECT_EQ(throttled.wait_s, 5);
    }
    now_ms += 5000;
    EXPECT_EQ(store->sign_in("anna", "wrong password").outcome, db::SignInOutcome::kWrong);
    EXPECT_EQ(store->sign_in("anna", kPassword).wait_s, 10);
    // The wait is stored: another program does not go around it.
    EXPECT_EQ(open()->sign_in("anna", kPassword).outcome, db::SignInOutcome::kThrottled);
    now_ms += 10000;
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(store->sign_in("anna", "wrong password").outcome, db::SignInOutcome::kWrong);
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk) << "count reset";
}

TEST_P(StoreTest, NoWaitIsLongerThanAQuarterOfAnHour) {
    const auto store = open();
    int longest = 0;
    for (int i = 0; i < 40; ++i) {
        const db::SignIn sign_in = store->sign_in("nobody", "wrong password");
        longest = std::max(longest, sign_in.wait_s);
        now_ms += int64_t{1000} * sign_in.wait_s;
    }
    EXPECT_EQ(longest, 900);
    now_ms -= 3'600'000;  // A clock that was set back.
    EXPECT_LE(store->sign_in("nobody", "wrong password").wait_s, 900);
}

TEST_P(StoreTest, ADeactivatedPersonCannotSignIn) {
    const auto store = open();
    const int64_t id = store->create_user(trainee("anna"));
    store->set_active(id, false);
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kDeactivated);
    EXPECT_EQ(store->sign_in("anna", "wrong password").outcome, db::SignInOutcome::kWrong);
    store->set_active(id, true);
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kOk);
}

TEST_P(StoreTest, TheLastAdministratorStays) {
    const auto store = open();
    db::NewUser admin = trainee("admin");
    admin.roles = static_cast<db::Roles>(db::Role::kAdministrator);
    const int64_t first = store->create_user(admin);
    EXPECT_EQ(failure_of([&] { store->set_active(first, false); }).kind(),
              StoreError::Kind::kRefused);
    admin.login = "second";
    store->create_user(admin);
    store->set_active(first, false);
    EXPECT_FALSE(store->user(first)->active);
}

TEST_P(StoreTest, ANewPasswordReplacesTheOldOneAndEndsTheWait) {
    const auto store = open();
    const int64_t id = store->create_user(trainee("anna"));
    for (int i = 0; i < 6; ++i) (void)store->sign_in("anna", "wrong password");
    store->set_password(id, "another long password");
    EXPECT_EQ(store->sign_in("anna", kPassword).outcome, db::SignInOutcome::kWrong);
    EXPECT_EQ(store->sign_in("anna", "another long password").outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(failure_of([&] { store->set_password(999, "another long password"); }).kind(),
              StoreError::Kind::kNotFound);
}

// --- attempts ----------------------------------------------------------------------------------

TEST_P(StoreTest, AnAttemptComesBackExactly) {
    const auto store = open();
    const int64_t user = store->create_user(trainee("anna"));
    const db::AttemptResult result = make_result();
    const int64_t id = store->save_attempt(user, result);
    const db::AttemptDetail detail = store->attempt(id);

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
    const int64_t anna = store->create_user(trainee("anna"));
    const int64_t bert = store->create_user(trainee("bert"));
    db::AttemptResult late = make_result();
    late.header.started_utc = "2026-05-01T00:00:00.000Z";
    const int64_t second = store->save_attempt(anna, late);
    const int64_t first = store->save_attempt(anna, make_result());
    const int64_t other = store->save_attempt(anna, make_result("release"));
    const int64_t berts = store->save_attempt(bert, make_result());
    const auto ids = [](const std::vector<db::AttemptRecord>& records) {
        std::vector<int64_t> list;
        for (const auto& record : records) list.push_back(record.id);
        return list;
    };
    EXPECT_EQ(ids(store->attempts(anna)), (std::vector<int64_t>{first, other, second}));
    EXPECT_EQ(ids(store->attempts(anna, "diathermy_ring")), (std::vector<int64_t>{first, second}));
    EXPECT_EQ(ids(store->attempts(0, "diathermy_ring")),
              (std::vector<int64_t>{first, berts, second}));
    EXPECT_EQ(store->attempts(0).size(), 4u);
    EXPECT_THAT(store->attempts(bert, "release"), IsEmpty());
}

TEST_P(StoreTest, ARecordingComesBackByteForByte) {
    const auto store = open();
    const int64_t user = store->create_user(trainee("anna"));
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("a.placode");
    write_recording(result.recording_file);
    EXPECT_FALSE(store->attempt_of_recording(result.recording_file).has_value());
    const int64_t id = store->save_attempt(user, result);
    EXPECT_EQ(store->attempt_of_recording(result.recording_file), id);
    const std::string copy = folder.file("copy.placode");
    store->extract_recording(id, copy);
    EXPECT_EQ(read_text(copy), read_text(result.recording_file));
    EXPECT_EQ(db::read_recording_file(copy).inputs.size(), 2000u);
}

TEST_P(StoreTest, WhatIsNotThereIsSaidSo) {
    const auto store = open();
    const int64_t user = store->create_user(trainee("anna"));
    EXPECT_EQ(failure_of([&] { (void)store->attempt(77); }).kind(), StoreError::Kind::kNotFound);
    EXPECT_EQ(failure_of([&] { store->save_attempt(77, make_result()); }).kind(),
              StoreError::Kind::kNotFound);
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("missing.placode");
    EXPECT_EQ(failure_of([&] { store->save_attempt(user, result); }).kind(),
              StoreError::Kind::kNotFound);
    EXPECT_THAT(store->attempts(0), IsEmpty());
    const int64_t id = store->save_attempt(user, make_result());
    EXPECT_EQ(failure_of([&] { store->extract_recording(id, folder.file("x")); }).kind(),
              StoreError::Kind::kNotFound);
}

TEST_P(StoreTest, ADamagedRecordingInTheStoreIsFound) {
    const auto store = open();
    db::AttemptResult result = make_result();
    result.recording_file = folder.file("a.placode");
    write_recording(result.recording_file);
    const int64_t id = store->save_attempt(store->create_user(trainee("anna")), result);
    EXPECT_THAT(store->check(), IsEmpty());
    const std::string half = is_sqlite() ? "CAST(substr(content, 1, length(content) / 2) AS BLOB)"
                                         : "substr(content, 1, length(content) / 2)";
    ASSERT_TRUE(raw().run("UPDATE recordings SET content = " + half));
    EXPECT_EQ(failure_of([&] { store->extract_recording(id, folder.file("x")); }).kind(),
              StoreError::Kind::kDamaged);
    EXPECT_FALSE(fs::exists(folder.file("x")));
    ASSERT_EQ(store->check().size(), 1u);
    EXPECT_THAT(store->check()[0], HasSubstr("attempt " + std::to_string(id)));
}

TEST_P(StoreTest, AFailingWriteLeavesNothingOfAnAttemptBehind) {
    const auto store = open();
    const int64_t user = store->create_user(trainee("anna"));
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
    const size_t trail = store->audit_trail(1000).size();
    (void)failure_of([&] { store->save_attempt(user, result); });
    EXPECT_THAT(store->attempts(0), IsEmpty());
    for (const char* table :
         {"attempts", "attempt_metrics", "attempt_reasons", "attempt_events", "recordings"})
        EXPECT_EQ(saboteur.value(std::string("SELECT COUNT(*) FROM ") + table), "0") << table;
    EXPECT_EQ(store->audit_trail(1000).size(), trail);
    EXPECT_TRUE(fs::exists(result.recording_file));
    ASSERT_TRUE(saboteur.run(is_sqlite() ? "DROP TRIGGER sabotage"
                                         : "ALTER TABLE recordings DROP CONSTRAINT sabotage"));
    store->save_attempt(user, result);  // The same store goes on.
    EXPECT_EQ(store->attempts(0).size(), 1u);
}

// --- studies -----------------------------------------------------------------------------------

TEST_P(StoreTest, ParticipantsAreNumberedByStudyWithACheckLetter) {
    const auto store = open();
    const std::string first = store->new_participant("pilot");
    const std::string second = store->new_participant("pilot");
    EXPECT_THAT(first, testing::StartsWith("P001-"));
    EXPECT_THAT(second, testing::StartsWith("P002-"));
    EXPECT_EQ(store->new_participant("other"), first);
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
    record.participant = store->new_participant("pilot");
    record.questionnaire_id = "seed_paper";
    record.questionnaire_version = 2;
    record.answered_utc = "2026-01-02T03:04:05.000Z";
    record.answers = {{"A", "5"}, {"F", "=cmd|' /C calc'!A0\nzażółć \"x\""}};
    record.demonstration = true;
    const int64_t id = store->save_answers(record);
    db::AnswerRecord none = record;
    none.answers.clear();
    none.answered_utc.clear();
    store->save_answers(none);
    const auto found = store->answers("pilot");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].id, id);
    EXPECT_EQ(found[0].answers, record.answers);
    EXPECT_EQ(found[0].participant, record.participant);
    EXPECT_EQ(found[0].questionnaire_version, 2);
    EXPECT_TRUE(found[0].demonstration);
    EXPECT_THAT(found[1].answers, IsEmpty());
    EXPECT_FALSE(found[1].answered_utc.empty());
    EXPECT_THAT(store->answers("other"), IsEmpty());
    record.participant = "P099-X";
    EXPECT_EQ(failure_of([&] { store->save_answers(record); }).kind(), StoreError::Kind::kNotFound);
}

// --- audit -------------------------------------------------------------------------------------

TEST_P(StoreTest, EveryChangeLeavesATraceWithItsActor) {
    const auto store = open();
    store->act_as("setup");
    const int64_t id = store->create_user(trainee("anna"));
    (void)store->sign_in("anna", kPassword);
    store->save_attempt(id, make_result());
    store->audit("anna", "export", "study pilot", "3 rows");
    const auto trail = store->audit_trail(10);
    ASSERT_EQ(trail.size(), 4u);  // Newest first.
    EXPECT_EQ(trail[0].action, "export");
    EXPECT_EQ(trail[0].detail, "3 rows");
    EXPECT_EQ(trail[1].action, "attempt.save");
    EXPECT_EQ(trail[1].actor, "anna");
    EXPECT_EQ(trail[2].action, "sign_in");
    EXPECT_EQ(trail[3].actor, "setup");
    EXPECT_EQ(trail[3].object, "user " + std::to_string(id));
    EXPECT_EQ(store->audit_trail(2).size(), 2u);
}

TEST_P(StoreTest, TheAuditTrailCannotBeChanged) {
    const auto store = open();
    store->audit("anna", "export", "study", "");
    RawConnection forger = raw();
    EXPECT_FALSE(forger.run("UPDATE audit SET actor = 'bert'"));
    EXPECT_THAT(forger.problem(), HasSubstr("append-only"));
    EXPECT_FALSE(forger.run("DELETE FROM audit"));
    if (!is_sqlite()) {
        EXPECT_FALSE(forger.run("TRUNCATE audit"));
    }
    EXPECT_EQ(store->audit_trail(10).at(0).actor, "anna");
}

TEST_P(StoreTest, AForgedAuditTrailIsFound) {
    const auto store = open();
    for (int i = 0; i < 3; ++i) store->audit("anna", "export", "study " + std::to_string(i), "");
    EXPECT_THAT(store->check(), IsEmpty());
    RawConnection forger = raw();
    if (is_sqlite()) {
        ASSERT_TRUE(forger.run("DROP TRIGGER audit_is_never_changed"));
    } else {
        ASSERT_TRUE(forger.run("ALTER TABLE audit DISABLE TRIGGER ALL"));
    }
    ASSERT_TRUE(forger.run("UPDATE audit SET actor = 'bert' WHERE id = 2"));
    ASSERT_EQ(store->check().size(), 1u);
    EXPECT_THAT(store->check()[0], HasSubstr("entry 2"));
}

// --- several programs, faults ------------------------------------------------------------------

TEST_P(StoreTest, FourThreadsWriteAtOnceAndNothingIsLost) {
    const int64_t user = open()->create_user(trainee("anna"));
    std::atomic<int> failures{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            try {
                const auto store = open(60000);
                for (int i = 0; i < 25; ++i) store->save_attempt(user, make_result());
            } catch (const StoreError& error) {
                ADD_FAILURE() << error.what();
                ++failures;
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(failures, 0);
    const auto store = open();
    EXPECT_EQ(store->attempts(user).size(), 100u);
    EXPECT_THAT(store->check(), IsEmpty()) << "the audit chain has no fork";
}

TEST_P(StoreTest, SeveralProgramsMayCreateTheStoreAtOnce) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            try {
                (void)open(60000)->users();
            } catch (const StoreError& error) {
                ADD_FAILURE() << error.what();
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_THAT(open()->check(), IsEmpty());
}

TEST_P(StoreTest, ALockedStoreSaysSoAndLosesNothing) {
    const auto store = open(200);
    const int64_t user = store->create_user(trainee("anna"));
    RawConnection other = raw();
    ASSERT_TRUE(other.run(is_sqlite() ? "BEGIN EXCLUSIVE" : "BEGIN"));
    if (!is_sqlite()) {
        ASSERT_TRUE(other.run("LOCK TABLE attempts IN ACCESS EXCLUSIVE MODE"));
    }
    const auto error = failure_of([&] { store->save_attempt(user, make_result()); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kLocked);
    EXPECT_THAT(error.what(), HasSubstr("save an attempt in"));
    EXPECT_THAT(error.what(), HasSubstr("try again"));
    ASSERT_TRUE(other.run("COMMIT"));
    store->save_attempt(user, make_result());
    EXPECT_EQ(store->attempts(user).size(), 1u);
}

// --- migrations --------------------------------------------------------------------------------

TEST_P(StoreTest, AStoreOfANewerProgramIsRefused) {
    open()->create_user(trainee("anna"));
    ASSERT_TRUE(
        raw().run("INSERT INTO schema_migrations (name, checksum, applied_utc) VALUES "
                  "('9999_future.sql', 'x', 'y')"));
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kTooNew);
    EXPECT_THAT(error.what(), HasSubstr("9999_future.sql"));
    EXPECT_THAT(error.what(), HasSubstr("update Placode"));
}

TEST_P(StoreTest, AnOlderStoreIsBroughtUpToDateAndKeepsItsData) {
    const auto all = db::embedded_migrations();
    ASSERT_GE(all.size(), 4u);
    open()->create_user(trainee("anna"));
    options.migrations = all;
    options.migrations.push_back(
        {"9001_test.sql",
         "-- A comment; with a semicolon.\nCREATE TABLE later (id {ID}, size_m {REAL}, number "
         "{INT64}, bytes {BLOB}) {STRICT};\n\n-- postgresql only\nCREATE TABLE only_postgresql (id "
         "{ID});\n\n-- sqlite only\nCREATE TABLE only_sqlite (id {ID});\n"});
    const auto store = open();
    EXPECT_EQ(store->users().size(), 1u);
    EXPECT_TRUE(raw().run("INSERT INTO later (size_m, number) VALUES (0.5, 9007199254740993)"));
    EXPECT_EQ(raw().value("SELECT number FROM later"), "9007199254740993");
    EXPECT_TRUE(
        raw().run(is_sqlite() ? "SELECT * FROM only_sqlite" : "SELECT * FROM only_postgresql"));
    if (!is_sqlite()) return;
    // A copy of the file as it was before.
    std::string copy;
    for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().string().find(".before-update-") != std::string::npos)
            copy = entry.path().string();
    ASSERT_NE(copy, "");
    options.migrations.clear();
    EXPECT_EQ(db::open_store("sqlite:" + copy, options)->users().size(), 1u);
}

TEST_P(StoreTest, AMigrationThatFailsLeavesTheStoreAsItWas) {
    open()->create_user(trainee("anna"));
    const auto good = options.migrations;
    options.migrations = db::embedded_migrations();
    options.migrations.push_back(
        {"9001_test.sql", "CREATE TABLE later (id {ID});\n\nINSERT INTO nowhere VALUES (1);\n"});
    (void)failure_of([&] { (void)open(); });
    EXPECT_FALSE(raw().run("SELECT * FROM later"));
    options.migrations = good;
    EXPECT_EQ(open()->users().size(), 1u);
}

TEST_P(StoreTest, AMigrationThatWasEditedAfterwardsIsRefused) {
    open()->create_user(trainee("anna"));
    options.migrations = db::embedded_migrations();
    options.migrations[1].text += "\n-- edited\n";
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kDamaged);
    EXPECT_THAT(error.what(), HasSubstr(options.migrations[1].name));
}

// --- only PostgreSQL ---------------------------------------------------------------------------

TEST(PostgresqlStore, AWrongPasswordIsNotRepeatedInTheMessage) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    std::string url = world->server().url(world->server().new_database());
    url.replace(url.find(world->server().password()), world->server().password().size(), "secret1");
    const auto error = failure_of([&] { (void)db::open_store(url); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), Not(HasSubstr("secret1")));
    EXPECT_THAT(error.what(), HasSubstr("user and password are right"));
}

TEST(PostgresqlStore, AServerThatIsNotThereIsSaidSo) {
    const auto error =
        failure_of([] { (void)db::open_store("postgresql://a:b@127.0.0.1:1/placode"); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), HasSubstr("127.0.0.1:1/placode"));
}

TEST(PostgresqlStore, ABrokenConnectionIsOpenedAgainByTheNextCall) {
    if (world->server().missing()) GTEST_SKIP() << world->server().problem();
    const std::string database = world->server().new_database();
    const auto store = db::open_store(world->server().url(database));
    EXPECT_THAT(store->users(), IsEmpty());
    RawConnection admin = world->server().connect("postgres");
    ASSERT_TRUE(
        admin.run("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = '" +
                  database + "'"));
    EXPECT_EQ(failure_of([&] { (void)store->users(); }).kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(store->users(), IsEmpty());
}
