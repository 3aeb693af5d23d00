// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// packaging/shared-station on a server of its own: users of this computer come in by who they are,
// and nobody opens the store's files.

#include <gmock/gmock.h>
#include <grp.h>
#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

namespace THIS_TEST {

struct Ended {
    int code = 0;
    std::string said;
};

Ended run(const std::string& command) {
    Ended ended;
    std::FILE* pipe = ::popen(("( " + command + " ) 2>&1").c_str(), "r");
    if (pipe == nullptr) return {127, "popen"};
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        ended.said += static_cast<char>(c);
    const int status = ::pclose(pipe);
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ended;
}

class SharedStation : public testing::Test {
 protected:
    static constexpr const char* kServer = "/usr/lib/postgresql/15/bin/";

    void SetUp() override {
        if (!fs::exists(std::string(kServer) + "initdb"))
            GTEST_SKIP() << "PostgreSQL 15 is not installed";
        if (::geteuid() != 0) GTEST_SKIP() << "only root can act as other users of the computer";
        for (const char* user : {"postgres", "nobody", "daemon", "games"})
            if (::getpwnam(user) == nullptr) GTEST_SKIP() << "there is no user " << user;
        std::string name = (fs::temp_directory_path() / "placode-shared-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
        // As /var/run/postgresql: everybody comes up to the socket.
        fs::permissions(folder_, fs::perms(0755));
        const passwd* server = ::getpwnam("postgres");
        ASSERT_EQ(::chown(folder_.c_str(), server->pw_uid, server->pw_gid), 0);
        const std::string data = folder_ + "/data";
        const Ended made = run(as("postgres") + kServer + "initdb -D " + data +
                               " -A peer -E UTF8 --no-locale --no-sync");
        ASSERT_EQ(made.code, 0) << made.said;
        const Ended started = run(
            as("postgres") + kServer + "pg_ctl -w -D " + data + " -l " + folder_ +
            "/log -o \"-p 5432 -c listen_addresses='' -c fsync=off -c unix_socket_directories=" +
            folder_ + "\" start > /dev/null");
        ASSERT_EQ(started.code, 0) << started.said;
    }
    void TearDown() override {
        if (folder_.empty()) return;
        (void)run(as("postgres") + kServer + "pg_ctl -D " + folder_ + "/data -m immediate stop");
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    static std::string as(const std::string& user) { return "cd / && runuser -u " + user + " -- "; }
    [[nodiscard]] Ended set_up(const std::string& people,
                               const std::string& environment = "") const {
        return run(environment + " " + PLACODE_SOURCE_DIR +
                   "/packaging/shared-station --owner games --socket " + folder_ +
                   " --placodectl " + PLACODE_BIN_DIR + "/placodectl " + people);
    }
    [[nodiscard]] Ended sql(const std::string& user, const std::string& text,
                            const std::string& more = "") const {
        return run(as(user) + "psql -XAtq -h " + folder_ + " " + more + " -d placode -c \"" + text +
                   "\"");
    }
    /// As if the administrator had made it in Placode.
    void make_the_first_account() const {
        ASSERT_EQ(sql("games",
                      "INSERT INTO accounts (password_hash, roles, active, demonstration, "
                      "created_utc) VALUES ('', 8, 1, 0, '')")
                      .code,
                  0);
    }
    [[nodiscard]] std::string hba() const {
        std::ifstream in(folder_ + "/data/pg_hba.conf");
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::string folder_;
};

TEST_F(SharedStation, PeopleComeInByWhoTheyAreAndOpenNoFile) {
    ASSERT_EQ(set_up("").code, 0);
    make_the_first_account();
    const Ended first = set_up("nobody");
    ASSERT_EQ(first.code, 0) << first.said;
    EXPECT_THAT(first.said, Not(HasSubstr("no account yet")));
    EXPECT_THAT(first.said, HasSubstr("postgresql:///placode?host=" + folder_));
    const std::string lines = hba();
    EXPECT_EQ(lines.find("local \"placode\" all peer"), lines.find('\n') + 1)
        << "the first that fits";
    EXPECT_EQ(sql("nobody", "SELECT current_user").said, "nobody\n");
    EXPECT_NE(sql("daemon", "SELECT 1").code, 0) << "who was not named";
    // The same again, and with somebody more.
    const Ended again = set_up("nobody daemon");
    ASSERT_EQ(again.code, 0) << again.said;
    EXPECT_EQ(hba(), lines);
    EXPECT_EQ(sql("daemon", "SELECT current_user").said, "daemon\n");
    // The kernel's word counts, not the name that somebody gives.
    for (const char* other : {"games", "postgres", "daemon"})
        EXPECT_THAT(sql("nobody", "SELECT 1", std::string("-U ") + other).said,
                    HasSubstr("Peer authentication failed"))
            << other;
    for (const char* attack :
         {"UPDATE accounts SET roles = 15", "DELETE FROM audit",
          "SELECT password_hash FROM accounts",
          "INSERT INTO accounts (password_hash, roles, active, demonstration, created_utc) VALUES "
          "('', 15, 1, 0, '')",
          "SET ROLE games", "SET ROLE daemon", "ALTER TABLE accounts DISABLE ROW LEVEL SECURITY",
          "COPY accounts TO '/tmp/accounts'"}) {
        const Ended tried = sql("nobody", attack);
        EXPECT_NE(tried.code, 0) << attack;
        EXPECT_THAT(tried.said, AnyOf(HasSubstr("permission denied"), HasSubstr("must be owner"),
                                      HasSubstr("must be superuser"), HasSubstr("you may not")));
    }
    EXPECT_EQ(sql("nobody", "SELECT COUNT(*) FROM attempts").said, "0\n");
    // Files: neither list nor read, wherever they lie.
    const std::string data = sql("postgres", "SHOW data_directory").said;
    EXPECT_THAT(data, HasSubstr(folder_));
    EXPECT_NE(run(as("nobody") + "ls " + folder_ + "/data").code, 0);
    EXPECT_NE(run(as("nobody") + "cat " + folder_ + "/data/PG_VERSION").code, 0);
    EXPECT_EQ(run(as("postgres") + "cat " + folder_ + "/data/PG_VERSION").said, "15\n")
        << "or this proves nothing";
}

// Whoever comes first to an empty store makes its administrator, and signs what all trust goes back
// to: not a trainee who is quicker.
TEST_F(SharedStation, UntilThereIsAnAccountOnePersonComesIn) {
    const Ended nobody_named = set_up("nobody daemon");
    ASSERT_EQ(nobody_named.code, 0) << nobody_named.said;
    EXPECT_THAT(nobody_named.said, HasSubstr("--administrator LOGIN"));
    for (const char* user : {"nobody", "daemon"}) EXPECT_NE(sql(user, "SELECT 1").code, 0) << user;
    const Ended first = set_up("--administrator nobody daemon");
    ASSERT_EQ(first.code, 0) << first.said;
    EXPECT_THAT(first.said, HasSubstr("only nobody comes in"));
    EXPECT_EQ(sql("nobody", "SELECT current_user").said, "nobody\n");
    EXPECT_NE(sql("daemon", "SELECT 1").code, 0);
    // In the group already: for another store of this server, or by an earlier version.
    ASSERT_EQ(sql("postgres", "CREATE ROLE daemon LOGIN IN ROLE placode_station").code, 0);
    EXPECT_THAT(sql("daemon", "SELECT 1").said, HasSubstr("pg_hba.conf rejects"));
    const Ended entry = sql("nobody",
                            "SELECT placode_guard.add_entry('', 'nobody', 'store.seal', '', '', "
                            "'', '', 'key', 'signature')");
    EXPECT_NE(entry.code, 0);
    EXPECT_THAT(entry.said, HasSubstr("you may not"));
    EXPECT_EQ(sql("games", "SELECT COUNT(*) FROM audit").said, "0\n");
    make_the_first_account();
    const Ended then = set_up("daemon");
    ASSERT_EQ(then.code, 0) << then.said;
    for (const char* user : {"nobody", "daemon"})
        EXPECT_EQ(sql(user, "SELECT current_user").said, std::string(user) + "\n");
}

TEST_F(SharedStation, ACopyComesBackInTheOrderOfTheManual) {
    ASSERT_EQ(set_up("nobody").code, 0);
    make_the_first_account();
    const std::string socket = " -h " + folder_ + " ", dump = folder_ + "/copy.dump";
    for (const std::string& step :
         {"pg_dump" + socket + "-Fc -f " + dump + " placode",
          "psql -XAtq" + socket +
              "-d postgres -c 'ALTER DATABASE placode RENAME TO placode_before'",
          "createdb" + socket + "--owner games placode",
          "pg_restore" + socket + "--exit-on-error --dbname placode " + dump}) {
        const Ended done = run(as("postgres") + step);
        ASSERT_EQ(done.code, 0) << step << ": " << done.said;
    }
    const Ended again = set_up("nobody");
    ASSERT_EQ(again.code, 0) << again.said;
    EXPECT_EQ(sql("games", "SELECT COUNT(*) FROM accounts").said, "1\n");
    EXPECT_EQ(sql("nobody", "SELECT COUNT(*) FROM attempts").said, "0\n");
    EXPECT_NE(sql("nobody", "DELETE FROM audit").code, 0);
}

TEST_F(SharedStation, MakesTheOwnerAlsoWhereAGroupHasThatName) {
    // The package brings the group placode and no user. Debian has a group like that: users.
    if (::getgrnam("users") == nullptr || ::getpwnam("users") != nullptr)
        GTEST_SKIP() << "users is not a group alone";
    // No account is added here: the stand-in says what it was asked for, and fails.
    const std::string stand_in = folder_ + "/useradd";
    std::ofstream(stand_in) << "#!/bin/sh\necho \"useradd $*\"\nexit 9\n";
    fs::permissions(stand_in, fs::perms(0755));
    const std::string environment = "PATH=" + folder_ + ":\"$PATH\"";
    const Ended with_group = set_up("--owner users", environment);
    EXPECT_EQ(with_group.code, 9);
    EXPECT_THAT(with_group.said, HasSubstr("useradd --system --gid users --no-create-home"));
    const Ended without = set_up("--owner placode-nosuch", environment);
    EXPECT_EQ(without.code, 9);
    EXPECT_THAT(without.said, HasSubstr("useradd --system --user-group --no-create-home"));
}

TEST_F(SharedStation, RefusesWhatItCannotKeep) {
    for (const auto& [people, reason] :
         {std::pair{"games", "owns the tables"},
          {"postgres", "owns the tables"},
          {"nosuchuser", "no user nosuchuser"},
          {"--administrator nosuchuser", "no user nosuchuser"},
          {"--administrator games", "owns the tables"},
          {"'a; DROP'", "expected small letters"},
          {"anna.k", "who trains needs such a login"},
          {"--socket /nonexistent nobody", "start it: systemctl start postgresql"},
          {"--databse x", "unknown option --databse"}}) {
        const Ended refused = set_up(people);
        EXPECT_EQ(refused.code, 2) << people;
        EXPECT_THAT(refused.said, HasSubstr(reason));
    }
    EXPECT_THAT(hba(), Not(HasSubstr("placode"))) << "nothing was changed";
}

}  // namespace THIS_TEST
