// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whether every method of the store does for everybody what db/access.cpp says: all methods, for
// nobody, a program and each role, on own data, those of the group, of others and of a study, on
// both engines. What is refused leaves no trace.

#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>

#include "db/course_conduct.h"
#include "tests/bars.h"
#include "tests/rights_of_studies.h"

using namespace placode;
using namespace placode::test;
using db::Scope;
using db::StoreError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace THIS_TEST {

constexpr const char* kNobody = "nobody";
constexpr const char* kProgram = "program";

// All rows and counters of the database, and the same put back: a tenth of the time that a new
// database takes. `replica` keeps the triggers that guard the trail from it.
constexpr const char* kKeepTables = R"(DO $$ DECLARE t text; BEGIN
    CREATE SCHEMA kept;
    FOR t IN SELECT tablename FROM pg_tables WHERE schemaname = 'public' LOOP
        EXECUTE format('CREATE TABLE kept.%I AS TABLE public.%I', t, t);
    END LOOP;
    CREATE TABLE kept.signed_in (token TEXT, account BIGINT, since TIMESTAMPTZ, resting BOOLEAN);
    IF to_regclass('placode_guard.sessions') IS NOT NULL THEN
        INSERT INTO kept.signed_in SELECT * FROM placode_guard.sessions;
    END IF;
    CREATE TABLE kept.counters AS
        SELECT sequencename, last_value FROM pg_sequences WHERE schemaname = 'public';
END $$)";
constexpr const char* kPutTablesBack = R"(DO $$ DECLARE t text; BEGIN
    SET LOCAL session_replication_role = replica;
    FOR t IN SELECT tablename FROM pg_tables WHERE schemaname = 'public' LOOP
        EXECUTE format('DELETE FROM public.%I', t);
        EXECUTE format('INSERT INTO public.%I OVERRIDING SYSTEM VALUE SELECT * FROM kept.%I', t, t);
    END LOOP;
    -- A new password ends sessions.
    IF to_regclass('placode_guard.sessions') IS NOT NULL THEN
        INSERT INTO placode_guard.sessions SELECT * FROM kept.signed_in ON CONFLICT DO NOTHING;
    END IF;
    PERFORM setval(format('public.%I', sequencename), coalesce(last_value, 1),
                   last_value IS NOT NULL) FROM kept.counters;
END $$)";

/// A store that is filled once and put back to that state whenever something was changed.
class RightsTest : public StoreTest {
 protected:
    void ready() override {
        StoreTest::ready();
        const auto store = open();
        world.fill(*store, folder);
        // Who acts later on further connections has signed in in this program once.
        if (is_sqlite()) return;
        for (const auto& [login, mine] : world.of)
            ASSERT_EQ(open_at_station()->accounts().sign_in(login, kPassword).outcome,
                      db::SignInOutcome::kOk);
    }
    void keep() {
        std::unique_ptr<RawConnection> behind;
        if (is_sqlite()) {
            fs::copy_file(folder.file("placode.db"), folder.file("kept.db"));
        } else {
            behind = look_behind();
            ASSERT_TRUE(behind->run(kKeepTables)) << behind->problem();
        }
        reset(behind);
    }
    /// @param behind is closed where its file is replaced. One to a server stays open: it has
    ///               looked up all tables already.
    void reset(std::unique_ptr<RawConnection>& behind) {
        RawConnection::edits() += 1;  // Its trail is shorter now than this computer remembers.
        if (is_sqlite()) {
            behind.reset();
            for (const char* part : {"", "-wal", "-shm"})
                fs::remove(folder.file("placode.db") + part);
            fs::copy_file(folder.file("kept.db"), folder.file("placode.db"));
            return;
        }
        if (!behind) behind = look_behind();
        ASSERT_TRUE(behind->run(kPutTablesBack)) << behind->problem();
    }
    [[nodiscard]] std::unique_ptr<RawConnection> look_behind() const {
        return std::unique_ptr<RawConnection>(new RawConnection(raw()));
    }

    [[nodiscard]] std::unique_ptr<db::Store> open_for(const std::string& who) const {
        // People sit at a station, and there the server asks as well.
        auto store = who == kProgram ? open() : open_at_station();
        if (who == kNobody) store->sign_out();
        if (world.of.contains(who)) store->act_for(world.of.at(who).person);
        return store;
    }
    [[nodiscard]] bool expected(const Method& method, const std::string& who, Subject whose) const;
    /// nullopt: it was not refused for want of rights.
    [[nodiscard]] static std::optional<std::string> refused(const Method& method, Call& call,
                                                            std::string& trouble);
    void run_for(const std::string& who, int& calls, Bar& bar);
    /// A server takes longer: there, what asks about nobody's data in particular is called for one
    /// subject.
    [[nodiscard]] std::vector<Subject> subjects_of(const Method& method) const {
        bool varies = is_sqlite() || method.sight;
        for (const Needed& each : method.needs)
            varies = varies || (each.about != About::kNothing && each.about != About::kNewGroup);
        return varies ? std::vector<Subject>(kSubjects.begin(), kSubjects.end())
                      : std::vector<Subject>{Subject::kGroup};
    }

    RightsWorld world;
};

INSTANTIATE_TEST_SUITE_P(Engines, RightsTest, testing::Values("Sqlite", "Postgresql"), engine_name);

Scope scope_of(About about, Subject whose) {
    switch (about) {
        case About::kNothing:
            return Scope::kOther;
        case About::kNewGroup:
            return Scope::kGroup;
        case About::kGroup:
            return whose == Subject::kOther ? Scope::kOther : Scope::kGroup;
        case About::kPerson:
        case About::kAttempt:
            break;
    }
    return whose == Subject::kOwn     ? Scope::kOwn
           : whose == Subject::kOther ? Scope::kOther
                                      : Scope::kGroup;
}

bool RightsTest::expected(const Method& method, const std::string& who, Subject whose) const {
    if (who == kProgram) return true;
    db::Roles roles = 0;
    for (const auto& [login, role] : RightsWorld::kActors)
        if (login == who) roles = static_cast<db::Roles>(role);
    bool may = true;
    for (const Needed& each : method.needs)
        may = may && db::allowed(roles, each.action, scope_of(each.about, whose));
    const auto on_others = [&](Action action) { return db::allowed(roles, action, Scope::kOther); };
    if (!method.either.empty())
        may = may && std::any_of(method.either.begin(), method.either.end(), on_others);
    if (method.sight)
        may = may &&
              (whose == Subject::kStudy
                   ? on_others(Action::kViewAttempts) || on_others(Action::kRunQuestionnaire)
                   : db::allowed(roles, Action::kViewAttempts, scope_of(About::kAttempt, whose)));
    return may;
}

std::optional<std::string> RightsTest::refused(const Method& method, Call& call,
                                               std::string& trouble) {
    try {
        method.call(call);
    } catch (const StoreError& error) {
        trouble = error.what();
        if (error.kind() == StoreError::Kind::kRefused &&
            trouble.find("you may not ") != std::string::npos)
            return trouble;
    } catch (const std::exception& error) {
        trouble = error.what();
    }
    return std::nullopt;
}

void RightsTest::run_for(const std::string& who, int& calls, Bar& bar) {
    auto store = open_for(who);
    auto behind = look_behind();
    const std::string head = "SELECT chain FROM audit ORDER BY id DESC LIMIT 1";
    const std::string before = behind->value(head);
    const std::string actor = world.of.contains(who) ? who : "educator";
    for (const Method& method : all_methods())
        for (const Subject whose : subjects_of(method)) {
            Call call{*store,
                      world,
                      world.subject(actor, whose),
                      who == kNobody ? 0 : world.of.at(actor).person,
                      folder.file("file" + std::to_string(++calls)),
                      folder.file("one.placode")};
            std::string trouble;
            const bool may = !refused(method, call, trouble);
            const bool trace = behind->value(head) != before;
            const bool right = may == expected(method, who, whose);
            EXPECT_TRUE(right) << method.name << (may ? " worked" : " was refused") << " for "
                               << who << ", subject " << int(whose) << ": " << trouble;
            bar.tried(right);
            if (who == kProgram && whose == Subject::kGroup && !method.fails) {
                EXPECT_EQ(trouble, "") << method.name << " should have worked";
            }
            EXPECT_FALSE(!may && trace) << method.name << " was refused and left a trace";
            // A sign-in, for one, changes for whom it works.
            const bool other = method.name == std::string("store.act_as") ||
                               method.name == std::string("store.act_for") ||
                               method.name == std::string("store.sign_out");
            if (!trace && !(may && other)) continue;
            store.reset();
            if (trace) reset(behind);
            store = open_for(who);
            if (!behind) behind = look_behind();
        }
    for (const std::string& problem : open()->check())
        EXPECT_THAT(problem, testing::Not(HasSubstr("seals:")));
}

TEST_P(RightsTest, EveryMethodAsksTheTableForEverybody) {
    keep();
    Bar bar(is_sqlite() ? "methods by role and scope (SQLite)"
                        : "methods by role and scope (PostgreSQL)");
    int calls = 0;
    run_for(kNobody, calls, bar);
    run_for(kProgram, calls, bar);
    for (const auto& [login, role] : RightsWorld::kActors) run_for(login, calls, bar);
    RecordProperty("calls", calls);
    int each = 0;
    for (const Method& method : all_methods()) each += static_cast<int>(subjects_of(method).size());
    EXPECT_EQ(calls, 6 * each);
}

// --- that the table holds every method ----------------------------------------------------------

/// Names of the public methods that a header declares, as "part.name".
std::set<std::string> declared(const std::string& header, const std::string& type,
                               const std::string& part) {
    std::string text = read_text(std::string(PLACODE_SOURCE_DIR) + "/db/" + header);
    text = std::regex_replace(text, std::regex("//[^\n]*"), "");
    const size_t begin = text.find("public:", text.find("class " + type + " "));
    text = text.substr(begin, text.find("private:", begin) - begin);
    std::set<std::string> names;
    // "    [[nodiscard]] std::vector<A> name(": a declaration begins with four blanks and a type.
    const std::regex form(R"(\n    (?:\[\[nodiscard\]\] )?[A-Za-z_][\w:<>,& ]*[ &]([a-z_]\w*)\()");
    for (auto at = std::sregex_iterator(text.begin(), text.end(), form);
         at != std::sregex_iterator(); ++at)
        names.insert(part + "." + (*at)[1].str());
    return names;
}

TEST(RightsOfMethods, NoPublicMethodIsMissing) {
    const std::map<std::string, std::pair<std::string, std::string>> parts{
        {"accounts", {"accounts.h", "Accounts"}},
        {"attempts", {"attempts.h", "Attempts"}},
        {"norms", {"norms.h", "Norms"}},
        {"groups", {"groups.h", "Groups"}},
        {"courses", {"courses.h", "Courses"}},
        {"reviews", {"reviews.h", "Reviews"}},
        {"definitions", {"definitions.h", "Definitions"}},
        {"studies", {"studies.h", "Studies"}},
        {"records", {"study_records.h", "StudyRecords"}},
        {"audit", {"audit.h", "Audit"}}};
    std::set<std::string> all = declared("store.h", "Store", "store"), listed;
    // The parts themselves: the store hands out those, and no others.
    for (const auto& [part, header] : parts) {
        EXPECT_EQ(all.erase("store." + part), 1u) << part;
        all.merge(declared(header.first, header.second, part));
    }
    for (const Method& method : all_methods()) listed.insert(method.name);
    EXPECT_EQ(all, listed);
    EXPECT_GT(all.size(), 90u);
}

// --- what the table does not say ---------------------------------------------------------------

TEST_P(RightsTest, RolesAreAskedAtEveryCall) {
    const auto owner = open();
    const auto store = open_for("educator");
    const int64_t id = world.of["educator"].person;
    EXPECT_THAT(store->attempts().list(0), SizeIs(world.of.size()));
    owner->accounts().set_roles(id, static_cast<db::Roles>(db::Role::kTrainee));
    EXPECT_EQ(failure_of([&] { (void)store->attempts().list(0); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_THAT(store->attempts().list(id), SizeIs(1));
    owner->accounts().set_active(id, false);
    EXPECT_EQ(failure_of([&] { (void)store->attempts().list(id); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_FALSE(store->accounts().find(id)->active) << "who is closed out may know why";
    owner->accounts().set_active(id, true);
    EXPECT_THAT(store->attempts().list(id), SizeIs(1));
}

TEST_P(RightsTest, RightsOnlyBecomeFewerUntilSomebodySignsIn) {
    const auto store = open();
    store->act_as("backup at night");
    store->act_for(world.of["trainee"].person);
    for (const auto& climb :
         {std::function<void()>([&] { store->act_as("placodectl"); }),
          std::function<void()>([&] { store->act_for(world.of["administrator"].person); })})
        EXPECT_EQ(failure_of(climb).kind(), StoreError::Kind::kRefused);
    store->sign_out();
    EXPECT_EQ(failure_of([&] { store->act_for(world.of["trainee"].person); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(failure_of([&] { (void)store->accounts().list(); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->accounts().sign_in("administrator", "wrong password").outcome,
              db::SignInOutcome::kWrong);
    EXPECT_EQ(failure_of([&] { (void)store->accounts().list(); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(store->accounts().sign_in("administrator", kPassword).outcome,
              db::SignInOutcome::kOk);
    EXPECT_THAT(store->accounts().list(), SizeIs(world.of.size()));
    EXPECT_EQ(store->audit().trail(1)[0].actor, "administrator");
}

TEST_P(RightsTest, WhoConfirmsDoesNotTakeOver) {
    const auto store = open_for("trainee");
    EXPECT_EQ(store->accounts().confirm("teacher", kPassword).outcome, db::SignInOutcome::kOk);
    EXPECT_EQ(failure_of([&] { (void)store->attempts().list(0); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(db::find_proctor(*store, "Name of teacher", world.of["trainee"].person).login,
              "teacher");
    EXPECT_THAT(failure_of([&] { (void)db::find_proctor(*store, "grouped", 0); }).what(),
                HasSubstr("no active educator"));
    const auto coordinator = open_for("coordinator");
    coordinator->records().sign(RightsWorld::kStudy, world.locked, "teacher", kPassword, "read");
    EXPECT_EQ(coordinator->records().events(RightsWorld::kStudy).back().login, "teacher");
    EXPECT_THAT(coordinator->studies().ids(), ElementsAre(RightsWorld::kStudy));
}

TEST_P(RightsTest, NobodySpeaksForSomebodyElse) {
    const auto store = open_for("educator");
    const Belongings& grouped = world.of["grouped"];
    EXPECT_EQ(
        failure_of([&] {
            store->reviews().add_comment({0, grouped.attempt, world.teacher, "", -1, "Good.", ""});
        }).kind(),
        StoreError::Kind::kRefused);
    db::RatingRecord rating;
    rating.attempt_id = grouped.attempt;
    rating.rater_id = world.teacher;
    rating.questionnaire_id = "osats";
    EXPECT_EQ(failure_of([&] { store->reviews().save_rating(rating); }).kind(),
              StoreError::Kind::kRefused);
    // Of one's own it may be taken away, whoever's attempt it is on by now.
    const auto teacher = open_for("teacher");
    teacher->reviews().set_comment_removed(world.of["stranger"].remark, true);
    teacher->reviews().set_comment_removed(grouped.remark, true);
}

TEST_P(RightsTest, TheOwnOfListsIsGiven) {
    open()->accounts().request_erasure(world.of["grouped"].person, "I leave.");
    const auto store = open_for("trainee");
    EXPECT_THAT(store->accounts().erasure_requests(), IsEmpty());
    store->accounts().request_erasure(world.of["trainee"].person, "I leave.");
    EXPECT_THAT(store->accounts().erasure_requests(), SizeIs(1));
    EXPECT_THAT(open_for("administrator")->accounts().erasure_requests(), SizeIs(2));
    const auto groups = store->groups().list();
    ASSERT_THAT(groups, SizeIs(1));
    EXPECT_EQ(groups[0].name, "Ours");
    EXPECT_THAT(groups[0].members, IsEmpty());
    EXPECT_THAT(groups[0].educators, ElementsAre(world.of["trainee"].person));
    EXPECT_THAT(open_for("educator")->groups().list(), SizeIs(3));
}

TEST_P(StoreTest, WhoComesFirstMakesAnAdministratorAndNothingElse) {
    const auto store = open();
    store->sign_out();
    EXPECT_FALSE(store->accounts().any());
    EXPECT_EQ(failure_of([&] { store->accounts().create(trainee("anna")); }).kind(),
              StoreError::Kind::kRefused);
    db::NewUser ada = trainee("ada");
    ada.roles = static_cast<db::Roles>(db::Role::kAdministrator);
    store->accounts().create(ada);
    EXPECT_TRUE(store->accounts().any());
    ada.login = "another";
    EXPECT_EQ(failure_of([&] { store->accounts().create(ada); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_TRUE(store->accounts().may_sign_in("ADA"));
    EXPECT_FALSE(store->accounts().may_sign_in("another"));
    EXPECT_THAT(store->accounts().demonstrators(), IsEmpty());
    EXPECT_EQ(store->accounts().sign_in("ada", kPassword).outcome, db::SignInOutcome::kOk);
    store->accounts().create(trainee("anna"));
    store->sign_out();
    EXPECT_EQ(failure_of([&] { store->accounts().create(trainee("bert")); }).kind(),
              StoreError::Kind::kRefused);
}

}  // namespace THIS_TEST
