// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The programs as people and scripts meet them: exit status, accounts, rights and stores, and that
// bad input changes nothing.

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <filesystem>

#include "tests/programs_fixture.h"
#include "tests/stopped_program.h"

using namespace placode;
using namespace placode::test;
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

test::World* const world = test::World::install();

TEST_F(Programs, UsageErrorsHaveStatusTwoAndHelpHasNone) {
    EXPECT_EQ(ctl("").status, 2);
    EXPECT_EQ(ctl("fly").status, 2);
    EXPECT_EQ(ctl("backup").status, 2);
    EXPECT_EQ(ctl("--help").status, 0);
    EXPECT_THAT(ctl("--help").out, AllOf(HasSubstr("user"), HasSubstr("restore")));
    EXPECT_FALSE(fs::exists(store)) << "asking for help made a store";
}

TEST_F(Programs, AccountsAreMadeListedAndDeactivated) {
    add_user("admin", "administrator");
    add_user("anna", "trainee");
    const Outcome list = ctl("user list --json");
    EXPECT_EQ(list.status, 0) << list.err;
    EXPECT_THAT(list.out, AllOf(HasSubstr("\"login\": \"anna\""), HasSubstr("administrator")));
    EXPECT_EQ(ctl("user deactivate anna").status, 0);
    EXPECT_THAT(ctl("user list").out, HasSubstr("deactivated"));
    const Outcome last = ctl("user deactivate admin");
    EXPECT_EQ(last.status, 1);
    EXPECT_THAT(last.err, HasSubstr("last active administrator"));
    EXPECT_THAT(ctl("audit").out, HasSubstr("local administrator ("));
}

// Other tests of programs hash with less (stand_in/quick_hash.cpp).
TEST_F(Programs, PasswordsAreHashedAtFullCost) {
    const Outcome added =
        ctl("user add anna --role trainee", "LD_PRELOAD= PLACODE_NEW_PASSWORD='long enough 1'");
    ASSERT_EQ(added.status, 0) << added.err;
    const std::string at_full_cost = "$argon2id$v=19$m=65536,t=2,p=1$";
    const auto hash = [this] {
        return RawConnection("QSQLITE", store).value("SELECT password_hash FROM accounts");
    };
    EXPECT_THAT(hash(), testing::StartsWith(at_full_cost));
    // One of a time when less was thought to be enough is made anew when its owner signs in.
    ASSERT_EQ(ctl("user password anna", "PLACODE_NEW_PASSWORD='long enough 2'").status, 0);
    EXPECT_EQ(ctl("--as anna attempts", "LD_PRELOAD= PLACODE_PASSWORD='long enough 2'").status, 0);
    EXPECT_THAT(hash(), testing::StartsWith(at_full_cost));
}

TEST_F(Programs, BadAccountsAreRefusedAndNothingIsMade) {
    add_user("anna", "trainee");
    const auto add = [&](const std::string& arguments, const std::string& password) {
        return ctl("user add " + arguments, "PLACODE_NEW_PASSWORD='" + password + "'");
    };
    EXPECT_EQ(add("ANNA", "long enough 1").status, 1);
    EXPECT_EQ(add("bert", "short").status, 1);
    EXPECT_THAT(add("bert", "short").err, HasSubstr("at least 10"));
    const Outcome role = add("bert --role surgeon", "long enough 1");
    EXPECT_EQ(role.status, 2);
    EXPECT_THAT(role.err, AllOf(HasSubstr("surgeon"), HasSubstr("educator")));
    EXPECT_EQ(ctl("user add bert").status, 2) << "no password, no terminal";
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("bert")));
    EXPECT_EQ(ctl("user password bert", "PLACODE_NEW_PASSWORD='long enough 2'").status, 2);
}

TEST_F(Programs, AWrongPasswordIsRefusedAndAfterSixTriesHasToWait) {
    add_user("anna", "trainee");
    const Outcome wrong = ctl("--as anna attempts", "PLACODE_PASSWORD=wrong");
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("sign in as anna"), HasSubstr("password is wrong")));
    EXPECT_EQ(ctl("--as anna attempts", kRight).status, 0);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(ctl("--as anna attempts", "PLACODE_PASSWORD=wrong").status, 1);
    const Outcome waits = ctl("--as anna attempts", kRight);
    EXPECT_EQ(waits.status, 1);
    EXPECT_THAT(waits.err, HasSubstr("try again in"));
}

TEST_F(Programs, RightsAreThoseOfTheRole) {
    add_user("anna", "trainee");
    add_user("bert", "trainee");
    add_user("eve", "educator");
    EXPECT_EQ(ctl("--as anna attempts --user bert", kRight).status, 1);
    EXPECT_EQ(ctl("--as eve attempts --user bert", kRight).status, 0);
    for (const char* command : {"user list", "check", "backup copy.db", "audit"}) {
        const Outcome refused = ctl(std::string("--as eve ") + command, kRight);
        EXPECT_EQ(refused.status, 1) << command;
        EXPECT_THAT(refused.err, HasSubstr("an administrator can")) << command;
    }
    EXPECT_FALSE(fs::exists(file("copy.db")));
    EXPECT_THAT(ctl("--as eve export csv --study pilot", kRight).err, HasSubstr("coordinator"));
    EXPECT_EQ(ctl("--as anna user password anna",
                  std::string(kRight) + " PLACODE_NEW_PASSWORD='another one 2'")
                  .status,
              0)
        << "everybody may change the own password";
    EXPECT_EQ(ctl("--as anna user password bert",
                  "PLACODE_PASSWORD='another one 2' PLACODE_NEW_PASSWORD='another one 3'")
                  .status,
              1);
}

TEST_F(Programs, AStoreThatIsNotThereIsNotMadeByLooking) {
    const Outcome missing = ctl("check");
    EXPECT_EQ(missing.status, 2);
    EXPECT_THAT(missing.err, AllOf(HasSubstr(store), HasSubstr("no such store")));
    EXPECT_FALSE(fs::exists(store));
    EXPECT_EQ(run("placodectl", "--store mysql://x/y check").status, 2);
}

TEST_F(Programs, ALockedStoreIsNamedAndUnchanged) {
    add_user("anna", "trainee");
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open(store.c_str(), &other), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
    const Outcome locked = ctl("user deactivate anna");
    EXPECT_EQ(locked.status, 1);
    EXPECT_THAT(locked.err, AllOf(HasSubstr("sqlite:" + store), HasSubstr("another program")));
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    EXPECT_THAT(ctl("user list").out, Not(HasSubstr("deactivated")));
}

TEST_F(Programs, ACheckThatIsAskedToStopSaysNothingOfTheStore) {
    add_user("anna", "trainee");
    sqlite3* opened = nullptr;
    ASSERT_EQ(sqlite3_open(store.c_str(), &opened), SQLITE_OK);
    // A trail of seconds; none of these entries fits.
    EXPECT_EQ(sqlite3_exec(opened,
                           "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i "
                           "< 600000) INSERT INTO audit (at_utc, actor, action, object, detail, "
                           "chain) SELECT '', '', '', '', '', '' FROM n",
                           nullptr, nullptr, nullptr),
              SQLITE_OK);
    sqlite3_close(opened);
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome ended = stopped(folder, {"--store", "sqlite:" + store, "check"}, signal);
        EXPECT_EQ(ended.status, 1) << signal;
        EXPECT_THAT(ended.err, HasSubstr("check: stopped; whether the store is sound is not known"))
            << signal;
    }
}

TEST_F(Programs, ADamagedStoreIsLeftAsItIsAndABackupTakesItsPlace) {
    add_user("anna", "trainee");
    const std::string copy = file("copy.db");
    ASSERT_EQ(ctl("backup " + copy).status, 0);
    EXPECT_EQ(ctl("backup " + copy).status, 2) << "a backup is never overwritten";
    EXPECT_EQ(ctl("check").status, 0);
    write_text(store, "scrambled eggs");
    const Outcome damaged = ctl("check");
    EXPECT_EQ(damaged.status, 1);
    EXPECT_THAT(damaged.err, AllOf(HasSubstr("not a database"), HasSubstr("placodectl restore")));
    EXPECT_EQ(read_text(store), "scrambled eggs");
    EXPECT_EQ(ctl("restore " + file("nothing.db")).status, 2);
    write_text(file("empty.db"), "");
    const Outcome hostile = ctl("restore " + file("empty.db"));
    EXPECT_EQ(hostile.status, 2) << "the file is bad input, the store did not fail";
    EXPECT_THAT(hostile.err, AllOf(HasSubstr(file("empty.db")), HasSubstr("not a backup"),
                                   HasSubstr("`placodectl backup`")));
    write_text(file("hostile.db"), R"({"settings": {"store": "sqlite:elsewhere"}})");
    EXPECT_EQ(ctl("restore " + file("hostile.db")).status, 2);
    write_text(copy + ".head", "Placode: end of an audit trail, format 1\nentry 1e9\n");
    const Outcome head = ctl("restore " + copy);
    EXPECT_EQ(head.status, 2);
    EXPECT_THAT(head.err, AllOf(HasSubstr(copy + ".head"), HasSubstr("1e9")));
    EXPECT_EQ(ctl("check --head " + copy + ".head").status, 1) << "the store is scrambled";
    fs::remove(copy + ".head");
    EXPECT_EQ(read_text(store), "scrambled eggs");
    // Where somebody only wants to know whether it could be done, nothing is done.
    const Outcome rehearsed = ctl("--json restore --rehearse " + copy);
    EXPECT_EQ(rehearsed.status, 0) << rehearsed.err;
    EXPECT_THAT(rehearsed.out,
                AllOf(HasSubstr("\"restorable\": true"), HasSubstr("\"people\": 1")));
    EXPECT_EQ(ctl("restore --rehearse " + file("empty.db")).status, 2);
    EXPECT_EQ(read_text(store), "scrambled eggs");
    const Outcome restored = ctl("restore " + copy);
    EXPECT_EQ(restored.status, 0) << restored.err;
    EXPECT_THAT(restored.out, AllOf(HasSubstr("the old store is kept as"),
                                    HasSubstr("Whoever was erased since this backup is back")));
    EXPECT_THAT(ctl("user list").out, HasSubstr("anna"));
}

TEST_F(Programs, ErrorsAreOneJsonDocumentToo) {
    const Outcome outcome = ctl("--json check");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out, AllOf(testing::StartsWith("{"), HasSubstr("\"error\""),
                                   HasSubstr("\"exit_status\": 2")));
}

/// Scripts beside programs that are none: one records as placode-sim does, never over a file.
TEST_F(Programs, AScriptThatWasBrokenOffGoesOn) {
    for (const char* part : {"scripts", "build/release/bin", "data/tasks", "levels", "set"})
        fs::create_directories(file(part));
    for (const char* script : {"known_groups.sh", "replay_set.sh"})
        fs::copy(PLACODE_SOURCE_DIR "/scripts/" + std::string(script), file("scripts"));
    write_text(file("data/tasks/short.json"), "{}");
    write_text(file("build/release/bin/placode-sim"),
               "#!/bin/sh\nwhile [ $# -gt 1 ]; do\n"
               "if [ \"$1\" = --record ]; then [ ! -e \"$2\" ] || exit 2; echo new > \"$2\"; fi\n"
               "shift\ndone\n");
    write_text(file("build/release/bin/placodectl"), "#!/bin/sh\n");
    for (const char* program : {"placode-sim", "placodectl"})
        fs::permissions(file("build/release/bin/" + std::string(program)), fs::perms::owner_all);
    // What was left where power went.
    for (const char* left : {"levels/short-expert-1.placode.part", "set/short.part.placode"}) {
        write_text(file(left), "half");
        write_text(file(std::string(left) + "-journal"), "half");
    }
    const Outcome levels = shell("sh scripts/known_groups.sh short levels 1 1");
    EXPECT_EQ(levels.status, 0) << levels.err;
    for (const char* level : {"expert", "intermediate", "novice"})
        EXPECT_EQ(read_text(file("levels/short-" + std::string(level) + "-1.placode")), "new\n");
    const Outcome recorded = shell("bash scripts/replay_set.sh record set");
    EXPECT_EQ(recorded.status, 0) << recorded.out << recorded.err;
    EXPECT_EQ(read_text(file("set/short.placode")), "new\n");
    // Nothing half is left, and what was whole is not made again.
    for (const char* folder_of : {"levels", "set"})
        for (const auto& one : fs::directory_iterator(file(folder_of)))
            EXPECT_THAT(one.path().string(), Not(HasSubstr(".part")));
    write_text(file("levels/short-expert-1.placode"), "kept\n");
    EXPECT_EQ(shell("sh scripts/known_groups.sh short levels 1 1").status, 0);
    EXPECT_EQ(read_text(file("levels/short-expert-1.placode")), "kept\n");
}

}  // namespace THIS_TEST
