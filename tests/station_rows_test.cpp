// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Rows that somebody adds by SQL who has signed in and may add such rows: what they must not say.

#include <gmock/gmock.h>

#include "db/course_conduct.h"
#include "tests/exam_course.h"
#include "tests/station_guard_attacks.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;

namespace THIS_TEST {

class StationRows : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        anna_ = add("anna", db::Role::kTrainee);
    }
    [[nodiscard]] int64_t add(const std::string& login, db::Role role) const {
        db::NewUser user = trainee(login);
        user.roles = static_cast<db::Roles>(role);
        return open()->accounts().create(user);
    }
    [[nodiscard]] std::unique_ptr<db::Store> station_of(const std::string& login) const {
        auto store = open_at_station();
        store->sign_out();
        EXPECT_EQ(store->accounts().sign_in(login, kPassword).outcome, db::SignInOutcome::kOk);
        return store;
    }
    /// A connection of their own, with their log-in to Placode.
    struct Pen {
        RawConnection station;
        Intruder person{station};
        Pen(const std::string& database, const std::string& login)
            : station(World::get().server().connect_station(database)) {
            EXPECT_NE(person.enter(login, kPassword), "0");
        }
        /// Why it is refused; "" where it is not. Nothing stays.
        std::string tried(const std::string& sql) {
            EXPECT_TRUE(station.run("BEGIN"));
            const Outcome got = outcome_of(station, sql);
            EXPECT_TRUE(station.run("ROLLBACK"));
            return got.refusal;
        }
    };

    /// A statement that says who does it.
    struct Row {
        const char* login;
        int64_t own, colleague;
        std::string begin, end;  ///< About the number of the account.
    };
    void expect_own_names(const std::vector<Row>& rows) const;
    /// Of the study "pilot".
    std::string new_participant_with_answers();

    int64_t anna_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Server, StationRows, testing::Values("Postgresql"), engine_name);

constexpr const char* kMayNot = "you may not do this on the server";

void StationRows::expect_own_names(const std::vector<Row>& rows) const {
    for (const Row& each : rows) {
        Pen pen(database, each.login);
        EXPECT_EQ(pen.tried(each.begin + std::to_string(each.own) + each.end), "") << each.begin;
        EXPECT_THAT(pen.tried(each.begin + std::to_string(each.colleague) + each.end),
                    HasSubstr(kMayNot))
            << each.begin;
    }
}

std::string StationRows::new_participant_with_answers() {
    db::AnswerRecord answers;
    answers.study_id = "pilot";
    answers.participant = open()->studies().new_participant("pilot");
    answers.questionnaire_id = "sus";
    answers.answers = {{"sus01", "4"}};
    open()->studies().save_answers(answers);
    return answers.participant;
}

// It would be the exam's, and nobody would simulate it again.
TEST_P(StationRows, NoPracticeEndsAnExamThatWasBegun) {
    publish_exam(*open(), "diathermy_ring", "7,8");
    assign_exam(*open(), anna_);
    const auto store = station_of("anna");
    const db::ExamOrder order = db::begin_exam(
        *store, anna_, db::prepare_exam(*store, anna_, "short", "final", "", "", db::utc_now()));
    Pen anna(database, "anna");
    const auto practice = [&](int64_t begin) {
        return anna.tried(
            "INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "
            "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, "
            "points, verdict, rubric_id, rubric_version, metric_set_version, exam_begin) VALUES (" +
            std::to_string(anna_) + ", 'diathermy_ring', 2, '" + db::utc_now() +
            "', '', 60, 'mouse', '7', '', 1, '7', 0, 0, 100, 0, 'ring', 4, 15, " +
            std::to_string(begin) + ")");
    };
    EXPECT_EQ(practice(0), "") << "or this proves nothing";
    EXPECT_THAT(practice(order.context.begin), HasSubstr(kMayNot));
}

TEST_P(StationRows, NobodySignsOrUnlocksARecordInAColleaguesName) {
    const int64_t carl = add("carl", db::Role::kCoordinator),
                  kate = add("kate", db::Role::kCoordinator);
    const std::string code = open()->studies().new_participant("pilot");
    const auto store = station_of("carl");
    store->records().lock("pilot", code);
    // Whoever signs gives the password, also where a colleague has signed in.
    store->records().sign("pilot", code, "kate", kPassword, "read");
    Pen pen(database, "carl");
    const auto row = [&](const std::string& event, int64_t by, int64_t name) {
        return "INSERT INTO record_events (study_id, code, event, remark, checksum, by_login, "
               "by_name, at_utc) VALUES ('pilot', '" +
               code + "', '" + event + "', 'x', '', 'user " + std::to_string(by) + "', 'user " +
               std::to_string(name) + "', '')";
    };
    for (const char* event : {"locked", "unlocked"}) {
        EXPECT_EQ(pen.tried(row(event, carl, carl)), "") << event;
        EXPECT_THAT(pen.tried(row(event, kate, kate)), HasSubstr(kMayNot)) << event;
        EXPECT_THAT(pen.tried(row(event, carl, kate)), HasSubstr(kMayNot)) << event;
    }
    for (const int64_t who : {carl, kate})
        EXPECT_THAT(pen.tried(row("signed", who, who)), HasSubstr(kMayNot)) << "no password";
    const std::string key = pen.person.key_of("kate", kPassword);
    const std::string proof = Intruder::proof(pen.person.channel(), key);
    ASSERT_EQ(
        pen.station.value("SELECT id FROM placode_guard.enter('kate', '" + proof + "', false)"),
        std::to_string(kate));
    EXPECT_THAT(pen.tried(row("signed", carl, carl)), HasSubstr(kMayNot)) << "another one's";
    EXPECT_TRUE(pen.station.run(row("signed", kate, kate))) << pen.station.problem();
    EXPECT_THAT(pen.tried(row("signed", kate, kate)), HasSubstr(kMayNot)) << "it was for one";
    // What stands there is only taken out.
    EXPECT_THAT(pen.tried("UPDATE record_events SET remark = 'approved'"), HasSubstr(kMayNot));
    EXPECT_THAT(pen.tried("UPDATE record_events SET by_name = 'Kate'"), HasSubstr(kMayNot));
    EXPECT_EQ(pen.tried("UPDATE record_events SET remark = '', by_name = by_login"), "");
}

TEST_P(StationRows, WhoGrantsAssignsCorrectsAndWithdrawsSaysSoInTheOwnName) {
    const int64_t carl = add("carl", db::Role::kCoordinator),
                  kate = add("kate", db::Role::kCoordinator), eva = add("eva", db::Role::kEducator),
                  ewa = add("ewa", db::Role::kEducator);
    const std::string code = open()->studies().new_participant("pilot");
    const std::string other = new_participant_with_answers();
    station_of("kate")->studies().withdraw("pilot", code, db::WithdrawalMode::kKeep, "asked");
    const std::string anna = std::to_string(anna_);
    expect_own_names(
        {Row{"eva", eva, ewa,
             "INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
             "granted_by, granted_utc) VALUES (" +
                 anna + ", 'x', 'x', 1, 'x', 'user ",
             "', '')"},
         Row{"eva", eva, ewa,
             "INSERT INTO course_assignments (course_id, course_version, account_id, starts_utc, "
             "due_utc, assigned_by, assigned_utc, ended_utc) VALUES ('x', 1, " +
                 anna + ", '', '', 'user ",
             "', '', '')"},
         Row{"carl", carl, kate,
             "INSERT INTO withdrawals (study_id, code, mode, reason, withdrawn_by, "
             "withdrawn_utc) VALUES ('pilot', '" +
                 other + "', 'erase', 'x', 'user ",
             "', '')"},
         // The row that is there is a colleague's; what it becomes is one's own.
         Row{"carl", carl, kate, "UPDATE withdrawals SET mode = 'stop', withdrawn_by = 'user ",
             "'"},
         Row{"carl", carl, kate,
             "INSERT INTO answer_corrections (answer_id, entry, item, old_answer, new_answer, "
             "reason, corrected_by, at_utc) SELECT MAX(id), 1, 'x', '', '', 'x', 'user ",
             "', '' FROM answers"}});
    EXPECT_NO_THROW(station_of("carl")->studies().withdraw("pilot", code, db::WithdrawalMode::kStop,
                                                           "asked again"));
}

TEST_P(StationRows, WhoNotesChoosesEntersSupersedesInvitesAndTrustsSaysSoInTheOwnName) {
    const int64_t carl = add("carl", db::Role::kCoordinator),
                  kate = add("kate", db::Role::kCoordinator), eva = add("eva", db::Role::kEducator),
                  ewa = add("ewa", db::Role::kEducator), ada = add("ada", db::Role::kAdministrator),
                  adam = add("adam", db::Role::kAdministrator);
    const std::string code = open()->studies().new_participant("pilot");
    const std::string other = new_participant_with_answers();
    (void)open()->attempts().save(anna_, make_result());
    station_of("kate")->studies().set_participant_device("pilot", code, "mouse");
    ASSERT_TRUE(raw().run(
        "INSERT INTO study_steps (study_id, code, visit, step, state, attempt_id, answer_id, "
        "detail, at_utc) VALUES ('pilot', '" +
        code + "', 1, 'x', 'done', 0, 0, '', '')"));
    const std::string device =
        "INSERT INTO participant_devices (study_id, code, device, chosen_by, chosen_utc) VALUES "
        "('pilot', '";
    expect_own_names(
        {{"carl", carl, kate,
          "INSERT INTO step_notes (study_id, code, visit, step, note, noted_by, at_utc) VALUES "
          "('pilot', '" +
              code + "', 1, 'x', 'x', 'user ",
          "', '')"},
         {"carl", carl, kate, device + other + "', 'mouse', 'user ", "', '')"},
         // The choice that is there is a colleague's; what it becomes is one's own.
         {"carl", carl, kate, device + code + "', 'gamepad', 'user ",
          "', '') ON CONFLICT (study_id, code) DO UPDATE SET device = excluded.device, chosen_by "
          "= excluded.chosen_by"},
         {"carl", carl, kate,
          "UPDATE participant_devices SET device = 'gamepad', chosen_by = 'user ", "'"},
         {"carl", carl, kate,
          "INSERT INTO second_entries (answer_id, entered_by, at_utc) SELECT MAX(id), 'user ",
          "', '' FROM answers"},
         {"carl", carl, kate,
          "INSERT INTO superseded_steps (step_id, reason, superseded_by, superseded_utc) SELECT "
          "MAX(id), 'x', 'user ",
          "', '' FROM study_steps"},
         {"ada", ada, adam,
          "INSERT INTO invitations (code_hash, roles, note, invited_by, made_utc, expires_utc, "
          "used_utc) VALUES ('x', 8, '', 'user ",
          "', '', '2099-01-01', '')"},
         {"eva", eva, ewa,
          "INSERT INTO trusted_centres (public_key, centre, added_by, added_utc) VALUES ('x', 'x', "
          "'user ",
          "', '')"},
         {"eva", eva, ewa,
          "INSERT INTO norm_packs (task_id, centre, content, signature, public_key, in_use, "
          "added_by, added_utc) VALUES ('x', 'x', '', 'x', 'x', 0, 'user ",
          "', '')"},
         {"eva", eva, ewa,
          "INSERT INTO attempt_scores (attempt_id, points, verdict, rubric_id, rubric_version, "
          "metric_set_version, preprocessing_version, scored_utc, scored_by) SELECT MAX(id), 100, "
          "0, 'x', 9, 1, 1, '', 'user ",
          "' FROM attempts"}});
    // Nor another device under the colleague's name, which would be left as it is.
    EXPECT_THAT(Pen(database, "carl").tried("UPDATE participant_devices SET device = 'gamepad'"),
                HasSubstr(kMayNot));
    EXPECT_NO_THROW(station_of("carl")->studies().set_participant_device("pilot", code, "gamepad"));
}

// What it certifies is looked up again where it is shown (exam_begins_test); who issued it and when
// is the server's to say.
TEST_P(StationRows, ACertificateIsIssuedNowAndByWhoeverHasSignedIn) {
    const int64_t eva = add("eva", db::Role::kEducator);
    const auto row = [&](int64_t by, const std::string& at) {
        return "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
               "issued_utc, issued_by, code) VALUES (" +
               std::to_string(anna_) + ", 'short', 1, '2020-01-01T00:00:00Z', '" + at +
               "', 'user " + std::to_string(by) + "', 'ABCD')";
    };
    Pen anna(database, "anna");
    EXPECT_EQ(anna.tried(row(anna_, db::utc_now())), "");
    EXPECT_THAT(anna.tried(row(eva, db::utc_now())), HasSubstr(kMayNot));
    for (const char* at : {"2020-01-01T00:00:00Z", "2099-01-01T00:00:00Z", "", "infinity", "now"})
        EXPECT_THAT(anna.tried(row(anna_, at)), HasSubstr(kMayNot)) << at;
    EXPECT_EQ(Pen(database, "eva").tried(row(eva, db::utc_now())), "");
}

}  // namespace THIS_TEST
