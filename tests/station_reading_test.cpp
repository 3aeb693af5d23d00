// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody sees and adds by SQL with a station's log-in: every table, for nobody and for each
// role, of the own rows, those of the group, of others and of a study. What is right is computed
// with the table of db/access.cpp.
#include <gmock/gmock.h>

#include <set>

#include "db/access.h"
#include "tests/bars.h"
#include "tests/rights_world.h"
#include "tests/station_guard_attacks.h"

using namespace placode;
using namespace placode::test;
using db::Action;
using db::Role;
using db::Scope;
using testing::IsEmpty;

namespace THIS_TEST {

constexpr auto kAdministrator = static_cast<db::Roles>(Role::kAdministrator);
constexpr auto kEducator = static_cast<db::Roles>(Role::kEducator);
constexpr auto kCoordinator = static_cast<db::Roles>(Role::kCoordinator);

Scope scope_of(Subject whose) {
    return whose == Subject::kOwn     ? Scope::kOwn
           : whose == Subject::kOther ? Scope::kOther
                                      : Scope::kGroup;
}

/// Rows of one table that belong to one person, or to nobody in particular.
struct Sight {
    const char* table;
    const char* where;  ///< {who}, {group}, {attempt}, {code}: the subject's.
    bool (*sees)(db::Roles, Subject);
    bool personal = true;  ///< Else it is asked once.
};

// Whoever checks the store has to see all of it: an administrator.
bool administers(db::Roles roles) { return db::allowed(roles, Action::kBackup, Scope::kOther); }
bool is_in(db::Roles roles, Subject) { return roles != 0; }
bool names(db::Roles roles, Subject whose) {
    return db::allowed(roles, Action::kViewPersonalData, scope_of(whose));
}
bool attempts(db::Roles roles, Subject whose) {
    if (whose == Subject::kStudy)
        return (roles & (kEducator | kCoordinator)) != 0 || administers(roles);
    return db::allowed(roles, Action::kViewAttempts, scope_of(whose)) || administers(roles);
}
bool own_or_administers(db::Roles roles, Subject whose) {
    return roles != 0 && (whose == Subject::kOwn || administers(roles));
}
bool studies(db::Roles roles, Subject) {
    return db::allowed(roles, Action::kExportStudy, Scope::kOther) || administers(roles);
}
bool steps(db::Roles roles, Subject whose) {
    return studies(roles, whose) || db::allowed(roles, Action::kViewAttempts, Scope::kOther);
}
bool only_administers(db::Roles roles, Subject) { return administers(roles); }

const std::vector<Sight>& sights() {
    static const char* const of_attempt = "attempt_id = {attempt}";
    static const char* const of_score =
        "score_id IN (SELECT id FROM attempt_scores WHERE attempt_id = {attempt})";
    static const std::vector<Sight> all{
        {"accounts", "id = {who}", is_in},
        {"persons", "account_id = {who}", names},
        {"account_pins", "account_id = {who}", own_or_administers},
        {"invitations", "true", only_administers, false},
        {"erasure_requests", "account_id = {who}", own_or_administers},
        {"training_groups", "id = {group}",
         [](db::Roles roles, Subject whose) {
             // Who acts teaches the group of "grouped".
             return names(roles, whose) || (roles != 0 && whose == Subject::kGroup);
         }},
        {"group_members", "account_id = {who}",
         [](db::Roles roles, Subject whose) {
             return whose != Subject::kStudy && names(roles, whose);  // In no group.
         }},
        {"course_assignments", "account_id = {who}", names},
        {"course_grants", "account_id = {who}", names},
        {"exam_begins", "account_id = {who}", names},
        {"certificates", "account_id = {who}", names},
        {"trusted_centres", "true", is_in, false},
        {"centre_key", "true", is_in, false},
        {"norm_packs", "true", is_in, false},
        {"definitions", "true", is_in, false},
        {"audit", "true", only_administers, false},
        {"attempts", "id = {attempt}", attempts},
        {"attempt_metrics", of_attempt, attempts},
        {"attempt_reasons", of_attempt, attempts},
        {"attempt_events", of_attempt, attempts},
        {"recordings", of_attempt, attempts},
        {"attempt_comments", of_attempt, attempts},
        {"attempt_ratings", of_attempt, attempts},
        {"attempt_rating_items",
         "rating_id IN (SELECT id FROM attempt_ratings WHERE attempt_id = {attempt})", attempts},
        {"attempt_scores", of_attempt, attempts},
        {"attempt_score_metrics", of_score, attempts},
        {"attempt_score_reasons", of_score, attempts},
        {"answers", "true", studies, false},
        {"answer_items", "true", studies, false},
        {"answer_changes", "true", studies, false},
        {"answer_corrections", "true", studies, false},
        {"second_entries", "true", studies, false},
        {"second_entry_items", "true", studies, false},
        {"study_steps", "true", steps, false},
        {"superseded_steps", "true", steps, false},
        {"participants", "true", studies, false},
        {"participant_states", "true", studies, false},
        {"participant_devices", "true", studies, false},
        {"withdrawals", "true", studies, false},
        {"consent_signatures", "true", studies, false},
        {"step_notes", "true", studies, false},
        {"record_events", "true", studies, false},
        {"study_allocations", "true", studies, false},
    };
    return all;
}

/// A row that somebody adds or changes by SQL, and what a program would have to be allowed for it.
struct Write {
    const char* sql;
    std::vector<Action> needs;  ///< On the subject. Empty: in one's own name only.
    bool of_study = false;      ///< What is asked is asked of nobody in particular.
};

const std::vector<Write>& writes() {
    static const std::vector<Write> all{
        {"INSERT INTO attempts (account_id, task_id, task_version, started_utc, saved_utc, "
         "duration_s, device, seed, build, end_reason, final_hash, dropped, demonstration, points, "
         "verdict, rubric_id, rubric_version, metric_set_version) VALUES ({who}, 'x', 1, '', '', "
         "1, '', '1', '', 0, '1', 0, 0, 100, 1, 'x', 1, 1)",
         {Action::kSaveAttempt}},
        // What is kept stays as it was: nobody adds to it.
        {"INSERT INTO attempt_metrics VALUES ({attempt}, 999, 'x', 1)", {Action::kReplay}},
        {"INSERT INTO attempt_reasons (attempt_id, position, item, reason, points, time_s, "
         "critical) VALUES ({attempt}, 999, 'x', '', 1, 1, 0)",
         {Action::kReplay}},
        {"INSERT INTO attempt_events (attempt_id, position, time_s, kind, tool, tissue, element) "
         "VALUES ({attempt}, 999, 1, 1, 1, 1, 1)",
         {Action::kReplay}},
        {"INSERT INTO attempt_scores (attempt_id, points, verdict, rubric_id, rubric_version, "
         "metric_set_version, preprocessing_version, scored_utc, scored_by) VALUES ({attempt}, "
         "100, 1, 'x', 9, 1, 1, '', 'user {me}')",
         {Action::kSetStandards}},
        {"INSERT INTO attempt_comments (attempt_id, author_id, time_s, comment, at_utc, "
         "removed_utc) VALUES ({attempt}, {me}, 1, 'x', '', '')",
         {Action::kRemark}},
        {"INSERT INTO attempt_comments (attempt_id, author_id, time_s, comment, at_utc, "
         "removed_utc) VALUES ({mine}, {who}, 1, 'x', '', '')",
         {}},
        {"UPDATE attempt_comments SET removed_utc = 'x' WHERE attempt_id = {attempt}",
         {Action::kReviewAttempts}},
        {"INSERT INTO attempt_ratings (attempt_id, rater_id, questionnaire_id, "
         "questionnaire_version, blinded, rated_utc) VALUES ({attempt}, {me}, 'x', 1, 0, '')",
         {Action::kReviewAttempts}},
        {"INSERT INTO course_assignments (course_id, course_version, account_id, starts_utc, "
         "due_utc, assigned_by, assigned_utc, ended_utc) VALUES ('x', 1, {who}, '', '', 'user "
         "{me}', '', '')",
         {Action::kAssignCourses}},
        {"INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
         "granted_by, granted_utc) VALUES ({who}, 'x', 'x', 9, '', 'user {me}', '')",
         {Action::kAssignCourses}},
        {"INSERT INTO exam_begins (account_id, course_id, course_version, stage_id, task_id, "
         "task_version, seed, proctor, device_certificate, begun_utc) VALUES ({who}, 'x', 1, 'x', "
         "'x', 1, '1', '', '', CAST(now() AS TEXT))",
         {Action::kPerformAttempt}},
        {"INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
         "issued_utc, issued_by, code) VALUES ({who}, 'x', 1, '', CAST(now() AS TEXT), 'user "
         "{me}', 'X')",
         {Action::kIssueCertificate}},
        {"UPDATE group_members SET teaches = 1 WHERE account_id = {who} AND group_id = {group}",
         {Action::kManageGroups}},
        {"INSERT INTO definitions VALUES ('questionnaire', 'x', 1, '{}', '', '', 'user {who}', '')",
         {}},
        {"INSERT INTO definitions VALUES ('standard', 'x', 1, '{}', '', '', 'user {me}', '')",
         {Action::kSetStandards}},
        {"INSERT INTO definitions VALUES ('study', 'x', 1, '{}', '', '', 'user {me}', '')",
         {Action::kRunQuestionnaire},
         true},
        {"INSERT INTO answers (study_id, participant, questionnaire_id, questionnaire_version, "
         "answered_utc, demonstration) VALUES ('pilot', '{code}', 'x', 1, '', 0)",
         {Action::kRunQuestionnaire},
         true},
        {"INSERT INTO study_steps (study_id, code, visit, step, state, attempt_id, answer_id, "
         "detail, at_utc) VALUES ('pilot', '{code}', 1, 'x', 'done', {attempt}, 0, '', '')",
         {Action::kRunQuestionnaire},
         true},
        {"UPDATE accounts SET roles = 15 WHERE id = {who}", {Action::kManageUsers}},
        {"DELETE FROM persons WHERE account_id = {who}", {Action::kManageUsers}},
        {"DELETE FROM attempt_metrics WHERE attempt_id = {attempt}", {Action::kManageUsers}},
    };
    return all;
}

class StationReading : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        const auto store = open();
        world.fill(*store, folder);
        RawConnection behind = raw();
        for (const auto& [login, mine] : world.of) {
            const std::string who = std::to_string(mine.person);
            const std::string attempt = std::to_string(mine.attempt);
            store->accounts().set_pin(mine.person, "2580");
            for (const std::string& each :
                 {"INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
                  "granted_by, granted_utc) VALUES (" +
                      who + ", 'first_steps', 'touch', 1, '', '', '')",
                  "INSERT INTO exam_begins (account_id, course_id, course_version, stage_id, "
                  "task_id, task_version, seed, proctor, device_certificate, begun_utc) VALUES (" +
                      who + ", 'x', 1, 'x', 'x', 1, '1', '', '', '')",
                  "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
                  "issued_utc, issued_by, code) VALUES (" +
                      who + ", 'first_steps', 1, '', '', '', 'C" + who + "')",
                  "INSERT INTO erasure_requests VALUES (" + who + ", '', '', '')",
                  "INSERT INTO attempt_events (attempt_id, position, time_s, kind, tool, tissue, "
                  "element) VALUES (" +
                      attempt + ", 99, 1, 1, 1, 1, 1)",
                  "WITH made AS (INSERT INTO attempt_scores (attempt_id, points, verdict, "
                  "rubric_id, rubric_version, metric_set_version, preprocessing_version, "
                  "scored_utc, scored_by) VALUES (" +
                      attempt +
                      ", 1, 1, 'x', 1, 1, 1, '', '') RETURNING id), one AS (INSERT INTO "
                      "attempt_score_metrics SELECT id, 1, 'x', 1 FROM made) INSERT INTO "
                      "attempt_score_reasons (score_id, position, item, reason, points, time_s, "
                      "critical) SELECT id, 1, 'x', '', 1, 1, 0 FROM made",
                  "WITH made AS (INSERT INTO attempt_ratings (attempt_id, rater_id, "
                  "questionnaire_id, questionnaire_version, blinded, rated_utc) VALUES (" +
                      attempt + ", " + std::to_string(world.teacher) +
                      ", 'osats', 1, 0, '') RETURNING id) INSERT INTO attempt_rating_items "
                      "SELECT id, 'x', '1' FROM made"})
                ASSERT_TRUE(behind.run(each)) << behind.problem();
        }
        const std::string key = "('pilot', '" + world.code + "', ";
        const std::string answer = std::to_string(world.answers);
        for (const std::string& each :
             {std::string("INSERT INTO invitations (code_hash, roles, note, invited_by, made_utc, "
                          "expires_utc, used_utc) VALUES ('x', 1, '', '', '', '', '')"),
              std::string("INSERT INTO trusted_centres VALUES ('x', '', '', '')"),
              std::string("INSERT INTO centre_key VALUES (1, '', '', '', '')"),
              std::string("INSERT INTO norm_packs (task_id, centre, content, signature, "
                          "public_key, in_use, added_by, added_utc) VALUES ('x', '', '', '', '', "
                          "0, '', '')"),
              "INSERT INTO answer_changes VALUES (" + answer + ", 1, 'x', '', '', '')",
              "INSERT INTO answer_corrections (answer_id, entry, item, old_answer, new_answer, "
              "reason, corrected_by, at_utc) VALUES (" +
                  answer + ", 1, 'x', '', '', '', '', '')",
              "INSERT INTO second_entries VALUES (" + answer + ", '', '')",
              "INSERT INTO second_entry_items VALUES (" + answer + ", 'x', '')",
              std::string("INSERT INTO superseded_steps SELECT MIN(id), '', '', '' FROM "
                          "study_steps"),
              "INSERT INTO participant_states VALUES " + key + "0, 0, 0) ON CONFLICT DO NOTHING",
              "INSERT INTO participant_devices VALUES " + key + "'', '', '')",
              "INSERT INTO withdrawals VALUES " + key + "'keep', '', '', '')",
              "INSERT INTO consent_signatures VALUES " + key + "'', '')",
              "INSERT INTO step_notes (study_id, code, visit, step, note, noted_by, at_utc) "
              "VALUES " +
                  key + "1, 'x', '', '', '')",
              std::string("INSERT INTO study_allocations VALUES ('pilot', '1')")})
            ASSERT_TRUE(behind.run(each)) << each << ": " << behind.problem();
    }
    [[nodiscard]] std::string filled(std::string sql, const std::string& actor,
                                     Subject whose) const {
        const Belongings& subject = world.subject(actor, whose);
        const Belongings& self = world.of.at(actor);
        for (const auto& [place, value] :
             {std::pair("{who}", std::to_string(subject.person)),
              std::pair("{group}", std::to_string(subject.group)),
              std::pair("{attempt}", std::to_string(subject.attempt)),
              std::pair("{me}", std::to_string(self.person)),
              std::pair("{mine}", std::to_string(self.attempt)), std::pair("{code}", world.code)})
            for (size_t at = sql.find(place); at != std::string::npos; at = sql.find(place))
                sql.replace(at, std::string(place).size(), value);
        return sql;
    }
    void see(RawConnection& station, db::Roles roles, const std::string& actor) const {
        Bar bar("tables by role and scope: what SQL sees");
        for (const Sight& each : sights())
            for (const Subject whose : kSubjects) {
                if (!each.personal && whose != Subject::kGroup) continue;
                const Outcome got =
                    outcome_of(station, filled(std::string("SELECT 1 FROM ") + each.table +
                                                   " WHERE " + each.where + " LIMIT 1",
                                               actor, whose));
                EXPECT_EQ(got.refusal, "") << each.table;
                bar.tried((got.rows > 0) == each.sees(roles, whose));
                EXPECT_EQ(got.rows > 0, each.sees(roles, whose))
                    << each.table << " by " << (roles == 0 ? "nobody" : actor) << ", subject "
                    << int(whose);
            }
    }
    void write(RawConnection& station, db::Roles roles, const std::string& actor) const {
        Bar bar("rows by role and scope: what SQL adds");
        for (const Write& each : writes())
            for (const Subject whose : {Subject::kOwn, Subject::kGroup, Subject::kOther}) {
                bool may = roles != 0 && (!each.needs.empty() || whose == Subject::kOwn);
                for (const Action action : each.needs)
                    may = may && db::allowed(roles, action,
                                             each.of_study ? Scope::kOther : scope_of(whose));
                const std::string sql = filled(each.sql, actor, whose);
                ASSERT_TRUE(station.run("BEGIN"));
                const Outcome got = outcome_of(station, sql);
                ASSERT_TRUE(station.run("ROLLBACK"));
                bar.tried(got.got_anything() == may);
                EXPECT_EQ(got.got_anything(), may)
                    << sql << " by " << (roles == 0 ? "nobody" : actor) << ": " << got.refusal;
            }
    }
    RightsWorld world;
};

INSTANTIATE_TEST_SUITE_P(Server, StationReading, testing::Values("Postgresql"), engine_name);

TEST_P(StationReading, SeesAndWritesWhatTheTableOfRightsSays) {
    {
        RawConnection station = World::get().server().connect_station(database);
        see(station, 0, "trainee");
        write(station, 0, "trainee");
    }
    for (const auto& [login, role] : RightsWorld::kActors) {
        RawConnection station = World::get().server().connect_station(database);
        Intruder person(station);
        ASSERT_EQ(person.enter(login, kPassword), std::to_string(world.of.at(login).person));
        see(station, static_cast<db::Roles>(role), login);
        write(station, static_cast<db::Roles>(role), login);
    }
    // A program of the centre sees all, as jobs at night have to.
    RawConnection service = World::get().server().connect_service(database);
    see(service, kAdministrator | kEducator | kCoordinator, "administrator");
}

TEST_P(StationReading, NoTableIsLeftOut) {
    std::set<std::string> left;
    RawConnection behind = raw();
    QSqlQuery query(behind.handle());
    ASSERT_TRUE(query.exec("SELECT tablename FROM pg_tables WHERE schemaname = 'public'"));
    while (query.next()) left.insert(query.value(0).toString().toStdString());
    EXPECT_GT(left.size(), 40u);
    for (const Sight& each : sights()) EXPECT_EQ(left.erase(each.table), 1u) << each.table;
    // What the tables are, and how often a log-in was tried, by a checksum of it.
    left.erase("schema_migrations");
    left.erase("sign_in_failures");
    EXPECT_THAT(left, IsEmpty());
}

// Names of people are left out, names of those who work for the centre are not.
TEST_P(StationReading, ATraineeSeesWhoTeachesAndNobodyElse) {
    RawConnection station = World::get().server().connect_station(database);
    Intruder person(station);
    ASSERT_NE(person.enter("trainee", kPassword), "0");
    EXPECT_EQ(station.value("SELECT string_agg(login, ' ' ORDER BY login) FROM persons"),
              "administrator coordinator educator spare teacher trainee");
    EXPECT_EQ(station.value("SELECT COUNT(*) FROM attempts"), "1");
    ASSERT_TRUE(station.run("SELECT placode_guard.leave(false)"));
    EXPECT_EQ(station.value("SELECT COUNT(*) FROM persons"), "0");
    EXPECT_EQ(station.value("SELECT COUNT(*) FROM accounts"), "0");
    // What was seen is not let out by a condition that the server may ask first.
    EXPECT_EQ(outcome_of(station, "SELECT 1 FROM persons WHERE CAST(login AS INT) = 0").rows, 0);
}

// The trail names nobody (StoreContext::without_names); who asks what it would replace learns no
// more than what they have said.
TEST_P(StationReading, WhoIsNamedInATextIsToldToWhomeverHasSignedInAndSaidSo) {
    RawConnection station = World::get().server().connect_station(database);
    std::string everybody;
    for (const auto& [login, mine] : world.of) everybody += "Name of " + login + ", ";
    const std::string from = " FROM placode_guard.named_in('" + everybody + "')";
    EXPECT_EQ(station.value("SELECT COUNT(*)" + from), "0") << "nobody";
    Intruder person(station);
    ASSERT_NE(person.enter("trainee", kPassword), "0");
    EXPECT_EQ(station.value("SELECT COUNT(*)" + from), std::to_string(world.of.size()));
    EXPECT_EQ(station.value("SELECT login || '/' || display_name FROM placode_guard.named_in('by "
                            "grouped')"),
              "grouped/")
        << "the log-in does not tell the name";
    EXPECT_EQ(station.value("SELECT COUNT(*) FROM placode_guard.named_in(repeat(' ', 20000) || "
                            "'grouped')"),
              "0");
    // The store asks in pieces, so that no text is too long to be without names.
    const auto store = open_at_station();
    store->sign_out();
    ASSERT_EQ(store->accounts().sign_in("educator", kPassword).outcome, db::SignInOutcome::kOk);
    const std::string number = "user " + std::to_string(world.of.at("grouped").person);
    for (const size_t length : {0U, 3990U, 30000U}) {
        store->audit().write("educator", "export.csv", "x.csv",
                             std::string(length, '.') + " of Name of GROUPED, by grouped");
        EXPECT_EQ(raw().value("SELECT ltrim(detail, '.') FROM audit ORDER BY id DESC LIMIT 1"),
                  " of " + number + ", by " + number)
            << length;
    }
}

}  // namespace THIS_TEST
