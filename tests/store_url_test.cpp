// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_url.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "db/store.h"

namespace THIS_TEST {

namespace fs = std::filesystem;

using namespace placode::db;
using testing::HasSubstr;
using testing::Not;

TEST(StoreUrl, AnEmbeddedStoreIsAPath) {
    const StoreUrl url = parse_store_url("sqlite:/data/my store.db?timeout_ms=200");
    EXPECT_EQ(url.engine, Engine::kSqlite);
    EXPECT_EQ(url.path, "/data/my store.db");
    EXPECT_EQ(url.timeout_ms, 200);
    EXPECT_EQ(url.shown, "sqlite:/data/my store.db");
    EXPECT_EQ(parse_store_url("sqlite::memory:").path, ":memory:");
}

TEST(StoreUrl, AServerIsTakenApartAndItsPasswordIsNotShown) {
    const StoreUrl url = parse_store_url("postgresql://ann%40x:p%3Aw%2F1@db.example:6543/placode");
    EXPECT_EQ(url.engine, Engine::kPostgresql);
    EXPECT_EQ(url.user, "ann@x");
    EXPECT_EQ(url.password, "p:w/1");
    EXPECT_EQ(url.host, "db.example");
    EXPECT_EQ(url.port, 6543);
    EXPECT_EQ(url.name, "placode");
    EXPECT_THAT(url.shown, Not(HasSubstr("p%3Aw")));
    EXPECT_THAT(url.shown, HasSubstr("db.example:6543/placode"));
    EXPECT_EQ(parse_store_url("postgresql://a:b@h/n").port, 5432);
}

TEST(StoreUrl, AServerElsewhereProvesWhoItIs) {
    const auto mode = [](const std::string& url) { return parse_store_url(url).sslmode; };
    EXPECT_EQ(mode("postgresql://a@db.example/n"), "verify-full");
    EXPECT_EQ(mode("postgresql://a@192.168.1.7/n?timeout_ms=9"), "verify-full");
    for (const char* here : {"localhost", "127.0.0.1", "[::1]"})
        EXPECT_EQ(mode(std::string("postgresql://a@") + here + "/n"), "prefer") << here;
    EXPECT_EQ(mode("postgresql://a@localhost.example.org/n"), "verify-full");
    EXPECT_EQ(mode("postgresql:///n?host=/run/postgresql"), "prefer");
    EXPECT_EQ(mode("postgresql://a@db.example/n?sslmode=disable"), "disable") << "said on purpose";
    const StoreUrl url = parse_store_url(
        "postgresql://a@127.0.0.1/n?sslmode=verify-ca&sslrootcert=/etc/our%20ca.pem&timeout_ms=7");
    EXPECT_EQ(url.sslmode, "verify-ca");
    EXPECT_EQ(url.sslrootcert, "/etc/our ca.pem");
    EXPECT_EQ(url.timeout_ms, 7);
    EXPECT_EQ(url.shown, "postgresql://a@127.0.0.1/n");
    EXPECT_EQ(parse_store_url("postgresql:///n?host=/run/postgresql").host, "/run/postgresql");
}

TEST(StoreUrl, APasswordGivenLaterIsTheOneOfTheAddress) {
    const std::string url = with_password("postgresql://ann@h:1/n?timeout_ms=9", "p:w/@1?&");
    const StoreUrl parsed = parse_store_url(url);
    EXPECT_EQ(parsed.password, "p:w/@1?&");
    EXPECT_EQ(parsed.user, "ann");
    EXPECT_EQ(parsed.timeout_ms, 9);
    EXPECT_FALSE(needs_password(parsed));
    EXPECT_FALSE(needs_password(parse_store_url("sqlite:x")));
    EXPECT_FALSE(needs_password(parse_store_url("postgresql:///n?host=/run/postgresql")));
}

/// A password file with this line.
class PasswordFile {
 public:
    explicit PasswordFile(const std::string& line, fs::perms rights = fs::perms::owner_read) {
        std::ofstream(path_) << "# a remark: db:5432:n:ann:x\n" << line << '\n';
        fs::permissions(path_, rights);
        ::unsetenv("PGPASSWORD");
        ::setenv("PGPASSFILE", path_.c_str(), 1);
    }
    ~PasswordFile() {
        ::unsetenv("PGPASSFILE");
        fs::remove(path_);
    }
    PasswordFile(const PasswordFile&) = delete;
    PasswordFile& operator=(const PasswordFile&) = delete;

 private:
    std::string path_ = testing::TempDir() + "placode-pgpass-" + std::to_string(::getpid());
};

TEST(StoreUrl, APasswordFileCountsForTheServersThatItNames) {
    const auto asks = [](const std::string& line, const char* url) {
        const PasswordFile file(line);
        return needs_password(parse_store_url(url));
    };
    const char* url = "postgresql://ann@db:5432/n";
    for (const char* line : {"db:5432:n:ann:secret", "*:*:*:*:secret", "db:*:n:ann:se:cr\\et",
                             "other:5432:n:ann:x\ndb:5432:n:ann:secret"})
        EXPECT_FALSE(asks(line, url)) << line;
    for (const char* line :
         {"db:5432:n:bob:secret", "other:5432:n:ann:secret", "db:5433:n:ann:secret",
          "db:5432:m:ann:secret", "db:5432:n", "", "#db:5432:n:ann:secret", "d*:5432:n:ann:secret"})
        EXPECT_TRUE(asks(line, url)) << line;
    EXPECT_FALSE(asks("db:5432:a\\:b:ann:secret", "postgresql://ann@db:5432/a%3Ab"));
}

TEST(StoreUrl, APasswordFileThatOthersMayReadIsPassedBy) {
    const StoreUrl url = parse_store_url("postgresql://ann@db:5432/n");
    const PasswordFile open("db:5432:n:ann:x", fs::perms::owner_read | fs::perms::group_read);
    EXPECT_TRUE(needs_password(url));
    ::setenv("PGPASSFILE", "/nowhere/at/all", 1);
    EXPECT_TRUE(needs_password(url));
    ::setenv("PGPASSFILE", "/tmp", 1);
    EXPECT_TRUE(needs_password(url));
}

TEST(StoreUrl, WhatCannotBeReadSaysWhatIsExpected) {
    for (const char* wrong :
         {"", "placode.db", "mysql://h/n", "sqlite:", "postgresql://a:b@h", "postgresql:///n",
          "sqlite:x?timeout_ms=soon", "sqlite:x?timeout_ms=-1", "sqlite:x?colour=red",
          "sqlite:x?sslmode=disable", "postgresql://h/n?sslmode=maybe",
          "postgresql://h/n?host=other",
          "postgresql://h/n?sslrootcert=", "postgresql://h/n?host=/run"}) {
        try {
            (void)parse_store_url(wrong);
            ADD_FAILURE() << wrong;
        } catch (const StoreError& error) {
            EXPECT_THAT(error.what(), HasSubstr("expected sqlite:PATH")) << wrong;
        }
    }
}

// Without these a shell waits for minutes for a server whose cable was pulled.
TEST(StoreUrl, AServerThatWentAwayWithoutAWordIsWaitedForTenSeconds) {
    const std::string plain = connect_options(parse_store_url("postgresql://ann@db:5432/n"));
    for (const char* option : {"connect_timeout=5", ";tcp_user_timeout=10000", ";keepalives=1",
                               ";keepalives_idle=5", ";sslmode=verify-full"})
        EXPECT_THAT(plain, HasSubstr(option));
    EXPECT_THAT(plain, Not(HasSubstr("sslrootcert")));
    StoreUrl url = parse_store_url("postgresql://ann@db:5432/n");
    url.sslrootcert = "/it's/a\\b.crt";
    EXPECT_THAT(connect_options(url), HasSubstr(";sslrootcert='/it\\'s/a\\\\b.crt'"));
}

}  // namespace THIS_TEST
