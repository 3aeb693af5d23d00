// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store_url.h"

#include <gmock/gmock.h>

#include "db/store.h"

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

TEST(StoreUrl, WhatCannotBeReadSaysWhatIsExpected) {
    for (const char* wrong :
         {"", "placode.db", "mysql://h/n", "sqlite:", "postgresql://a:b@h", "postgresql:///n",
          "sqlite:x?timeout_ms=soon", "sqlite:x?timeout_ms=-1", "sqlite:x?colour=red"}) {
        try {
            (void)parse_store_url(wrong);
            ADD_FAILURE() << wrong;
        } catch (const StoreError& error) {
            EXPECT_THAT(error.what(), HasSubstr("expected sqlite:PATH")) << wrong;
        }
    }
}
