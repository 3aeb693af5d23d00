// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/erasure.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>

#include "db/signature.h"
#include "db/trail_head.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace THIS_TEST {

constexpr const char* kLogin = "zofia.unusual";
constexpr const char* kName = "Zofia Niezwykla";

class Erasure : public testing::Test {
 protected:
    void SetUp() override {
        options.cheap_passwords = true;
        const auto store = open();
        store->accounts().create({"ada", "Ada", "correct horse battery", 8, false});
        zofia = store->accounts().create({kLogin, kName, "correct horse battery", 1, false});
    }
    [[nodiscard]] std::unique_ptr<db::Store> open() const { return db::open_store(url(), options); }
    [[nodiscard]] std::string url() const { return "sqlite:" + file("placode.db"); }
    [[nodiscard]] std::string file(const std::string& name) const { return folder.file(name); }
    void backup(const std::string& name) const { open()->backup(file(name)); }
    db::Erasure erase(bool with_attempts = false) const {
        return db::erase_person(*open(), url(), zofia, with_attempts);
    }
    /// Somebody who reads the disk: the log-in or the name, in the file or its log.
    [[nodiscard]] bool names_her(const std::string& name) const {
        for (const char* end : {"", "-wal"}) {
            std::ifstream in(file(name) + end, std::ios::binary);
            const std::string bytes(std::istreambuf_iterator<char>(in), {});
            if (bytes.find(kLogin) != std::string::npos || bytes.find(kName) != std::string::npos)
                return true;
        }
        return false;
    }

    TemporaryFolder folder;
    db::StoreOptions options;
    int64_t zofia = 0;
};

TEST_F(Erasure, GoesThroughEveryCopyThatPlacodeMade) {
    backup("one.db");
    backup("two.db");
    backup("two_b.db");
    // As restore and update keep them, beside the store.
    for (const char* kept : {"placode.db.replaced-20260101T000000000Z",
                             "placode.db.before-update-20260102T000000000Z"})
        fs::copy_file(file("two_b.db"), file(kept));
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(240);
    fs::last_write_time(file("one.db"), old);
    ASSERT_TRUE(names_her("one.db"));
    const db::Erasure done = erase();
    EXPECT_THAT(done.left, IsEmpty());
    EXPECT_EQ(done.cleaned.size(), 5U);
    for (const auto& entry : fs::directory_iterator(folder.path())) {
        const std::string name = entry.path().filename().string();
        EXPECT_FALSE(names_her(name)) << name;
    }
    for (const std::string& copy : done.cleaned) {
        const auto store = db::open_store("sqlite:" + copy, options);
        EXPECT_THAT(store->check(), IsEmpty()) << copy;
        EXPECT_TRUE(store->accounts().find_login("ada")) << copy;
    }
    EXPECT_THAT(open()->check(), IsEmpty());
    // The statement beside a backup holds, and its age stays: retention goes by it.
    std::vector<std::string> problems;
    db::open_store("sqlite:" + file("two.db"), options)
        ->audit()
        .check_head(db::read_trail_head(db::head_file_of(file("two.db"))), problems);
    EXPECT_THAT(problems, IsEmpty());
}

TEST_F(Erasure, KnowsWhatABackupOrRestoreLeftThatWasKilled) {
    backup("one.db");
    for (const char* left : {"one.db.part", "placode.db.restoring", "one.db.failed"})
        fs::copy_file(file("one.db"), file(left));
    const db::Erasure done = erase();
    EXPECT_FALSE(fs::exists(file("one.db.part")));
    EXPECT_FALSE(fs::exists(file("placode.db.restoring")));
    ASSERT_EQ(done.left.size(), 1U) << "somebody may want to see what was wrong with it";
    EXPECT_EQ(done.left[0].path, file("one.db.failed"));
    EXPECT_THAT(done.cleaned, ElementsAre(file("one.db")));
}

TEST_F(Erasure, LeavesTheAgeOfACopy) {
    backup("one.db");
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(240);
    fs::last_write_time(file("one.db"), old);
    EXPECT_EQ(erase().cleaned.size(), 1U);
    EXPECT_EQ(fs::last_write_time(file("one.db")), old);
}

TEST_F(Erasure, NamesWhatItCannotReach) {
    backup("broken.db");
    backup("foreign.db");
    backup("gone.db");
    backup("before_her.db");
    std::ofstream(file("broken.db"), std::ios::trunc) << "no store any more";
    fs::remove(file("gone.db"));
    fs::remove(file("foreign.db"));
    {
        const auto other = db::open_store("sqlite:" + file("foreign.db"), options);
        for (int i = 0; i < 3; ++i)
            other->accounts().create(
                {"other" + std::to_string(i), kName, "correct horse", 8, false});
    }
    const db::Erasure done = erase();
    EXPECT_THAT(done.cleaned, ElementsAre(file("before_her.db")));
    ASSERT_EQ(done.left.size(), 2U);
    EXPECT_EQ(done.left[0].path, file("broken.db"));
    EXPECT_EQ(done.left[1].path, file("foreign.db"));
    EXPECT_THAT(done.left[1].why, HasSubstr("is a copy of another store"));
    EXPECT_THAT(done.gone, ElementsAre(file("gone.db")));
    EXPECT_EQ(db::open_store("sqlite:" + file("foreign.db"), options)->accounts().list().size(), 3U)
        << "people of another store are nobody's business";
}

TEST_F(Erasure, FindsABackupThatWasMadeAtARelativePlace) {
    const fs::path here = fs::current_path();
    fs::current_path(folder.path());
    open()->backup("one.db");
    fs::current_path(here);
    ASSERT_TRUE(names_her("one.db"));
    const db::Erasure done = erase();
    EXPECT_THAT(done.cleaned, ElementsAre((fs::canonical(folder.path()) / "one.db").string()));
    EXPECT_THAT(done.left, IsEmpty());
    EXPECT_FALSE(names_her("one.db"));
}

TEST_F(Erasure, SaysOfAnOldRelativePlaceThatItIsUnknown) {
    open()->audit().write("ada", "store.backup", "old.db", "");
    open()->audit().write("ada", "store.backup", "old.db", "");
    const db::Erasure done = erase();
    EXPECT_THAT(done.gone, IsEmpty()) << "it may well be where it was made";
    ASSERT_EQ(done.left.size(), 1U);
    EXPECT_EQ(done.left[0].path, "old.db");
    EXPECT_THAT(done.left[0].why, HasSubstr("place is unknown"));
    EXPECT_THAT(db::erasure_certificate(done),
                HasSubstr("old.db: a backup whose place is unknown"));
}

TEST_F(Erasure, ComesAgainWithARestore) {
    backup("away.db");
    fs::rename(file("away.db"), file("on_a_stick.db"));
    fs::rename(file("away.db.head"), file("on_a_stick.db.head"));
    EXPECT_THAT(erase(true).gone, ElementsAre(file("away.db")));
    ASSERT_TRUE(names_her("on_a_stick.db"));
    db::restore_store(url(), file("on_a_stick.db"));
    EXPECT_FALSE(open()->accounts().find(zofia));
    EXPECT_FALSE(names_her("placode.db"));
    EXPECT_THAT(open()->check(), IsEmpty());
    // And of another store's backup nobody is erased.
    const std::string other = "sqlite:" + file("other.db");
    db::open_store(other, options)->accounts().create({"bob", "Bob", "correct horse", 8, false});
    db::restore_store(other, file("on_a_stick.db"));
    EXPECT_TRUE(db::open_store(other, options)->accounts().find(zofia));
}

TEST_F(Erasure, KeepsTheLastAdministratorOfACopyAndSaysSo) {
    backup("early.db");
    {
        const auto store = open();
        const auto ada = store->accounts().find_login("ada");
        ASSERT_TRUE(ada);
        store->accounts().set_roles(zofia, 8);
        store->accounts().set_roles(ada->id, 1);
    }
    backup("she_alone.db");
    {
        const auto store = open();
        store->accounts().create({"eva", "Eva", "correct horse battery", 8, false});
    }
    const db::Erasure done = erase();
    EXPECT_THAT(done.cleaned, ElementsAre(file("early.db")));
    ASSERT_EQ(done.left.size(), 1U);
    EXPECT_EQ(done.left[0].path, file("she_alone.db"));
    EXPECT_THAT(done.left[0].why, HasSubstr("its only administrator"));
}

TEST_F(Erasure, IsCertifiedWithoutTheName) {
    backup("one.db");
    const std::string text = db::erasure_certificate(erase());
    EXPECT_THAT(text, HasSubstr("account " + std::to_string(zofia)));
    EXPECT_THAT(text, HasSubstr("one.db"));
    EXPECT_THAT(text, HasSubstr("links to a learning platform (lti.json, lti.json.sent)"));
    EXPECT_THAT(text, Not(HasSubstr(kLogin)));
    EXPECT_THAT(text, Not(HasSubstr(kName)));
    const size_t station = text.find("station "), signature = text.find("signature ");
    ASSERT_NE(signature, std::string::npos);
    const std::string key = text.substr(station + 8, signature - station - 9);
    std::string signed_by = text.substr(signature + 10);
    signed_by.pop_back();
    EXPECT_TRUE(db::signature_is_right(text.substr(0, station), signed_by, key));
    EXPECT_FALSE(db::signature_is_right(text.substr(1, station), signed_by, key));
}

TEST_F(Erasure, WhoMayNotEraseTouchesNoCopy) {
    backup("one.db");
    const auto store = open();
    store->act_for(zofia);
    EXPECT_THROW(db::erase_person(*store, url(), zofia, false), db::StoreError);
    EXPECT_TRUE(names_her("one.db"));
}

}  // namespace THIS_TEST
