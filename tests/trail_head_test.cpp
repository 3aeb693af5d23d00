// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The end of an audit trail, stated and kept elsewhere: whoever cuts the trail off or writes it
// anew later is found, even with every key of the centre.

#include "db/trail_head.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "db/signature.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

class TrailHeadTest : public EngineTest {
 protected:
    void ready() override {
        store = open();
        store->accounts().create(trainee("anna"));
    }
    [[nodiscard]] std::vector<std::string> against(const db::TrailHead& head) {
        std::vector<std::string> problems;
        store->audit().check_head(head, problems);
        return problems;
    }
    std::unique_ptr<db::Store> store;
};

INSTANTIATE_TEST_SUITE_P(Engines, TrailHeadTest, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_P(TrailHeadTest, ATrailThatOnlyGrewHoldsEveryEarlierEnd) {
    const db::TrailHead first = store->audit().head();
    EXPECT_GT(first.entry, 0);
    store->accounts().create(trainee("jan"));
    const db::TrailHead second = store->audit().head();
    EXPECT_GT(second.entry, first.entry);
    EXPECT_THAT(against(first), IsEmpty());
    EXPECT_THAT(against(second), IsEmpty());
}

TEST_P(TrailHeadTest, TheTextComesBackAndNoChangeOfItIsTaken) {
    const std::string text = db::trail_head_text(store->audit().head());
    EXPECT_EQ(db::trail_head_text(db::trail_head_of(text, "it")), text);
    for (size_t i = 0; i < text.size(); ++i) {
        std::string changed = text;
        changed[i] = changed[i] == '7' ? '8' : '7';
        EXPECT_THROW((void)db::trail_head_of(changed, "it"), db::StoreError) << i;
    }
    for (const std::string& more : {text + "more 1\n", text + text, std::string(), text.substr(9)})
        EXPECT_THROW((void)db::trail_head_of(more, "it"), db::StoreError);
}

TEST_P(TrailHeadTest, AnotherStoreAndAnUnknownComputerAreSaid) {
    db::TrailHead other = store->audit().head();
    other.store = "00";
    EXPECT_THAT(against(other).at(0), HasSubstr("another store"));
    other = store->audit().head();
    const db::KeyPair keys = db::new_key_pair();
    other.station = keys.public_key;
    other.signature = db::sign_text(db::trail_statement(other), keys.secret_key);
    EXPECT_THAT(against(other).at(0), HasSubstr("no computer of this store trusts"));
    other.station.clear();
    EXPECT_THAT(against(other).at(0), HasSubstr("not signed"));
}

class TrailHeadOfAFile : public TrailHeadTest {};
INSTANTIATE_TEST_SUITE_P(Engines, TrailHeadOfAFile, testing::Values("Sqlite"), engine_name);

/// Back to an older copy, and on from there with the same computer and key.
TEST_P(TrailHeadOfAFile, ATrailThatWasCutAndWentOnIsFoundWithEveryKey) {
    store->backup(folder.file("old.db"));
    store->accounts().create(trainee("eve"));
    const db::TrailHead kept = store->audit().head();
    store.reset();
    (void)db::restore_store(url(), folder.file("old.db"), "");
    store = open();
    store->accounts().create(trainee("other"));
    store->accounts().create(trainee("another"));
    EXPECT_THAT(store->check(), IsEmpty()) << "by itself the trail is whole";
    EXPECT_THAT(against(kept).at(0), HasSubstr("knows entry " + std::to_string(kept.entry)));
}

TEST_P(TrailHeadOfAFile, ABackupHasItsStatementAndIsRestoredOnlyWithTheRightOne) {
    const std::string copy = folder.file("copy.db"), stated = db::head_file_of(copy);
    store->backup(copy);
    ASSERT_TRUE(std::filesystem::exists(stated));
    store->accounts().create(trainee("jan"));
    store->backup(folder.file("later.db"));
    // The statement of a later backup says of this copy that it was cut off.
    std::filesystem::copy_file(db::head_file_of(folder.file("later.db")), stated,
                               std::filesystem::copy_options::overwrite_existing);
    store.reset();
    try {
        (void)db::restore_store(url(), copy, "");
        ADD_FAILURE() << "restored";
    } catch (const db::StoreError& error) {
        EXPECT_THAT(error.what(), HasSubstr("cut off or written anew"));
    }
    std::ofstream(stated) << "nothing";
    EXPECT_THROW((void)db::restore_store(url(), copy, ""), db::StoreError);
    (void)db::restore_store(url(), folder.file("later.db"), "");
    store = open();
    EXPECT_THAT(store->check(), IsEmpty());
}

}  // namespace THIS_TEST
