// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A restore erases again whom the store that it replaces has erased since, and nobody whom a row
// names that somebody wrote into its file.
#include "db/ended_meanwhile.h"

#include <gmock/gmock.h>

#include "db/ended_again.h"
#include "db/erasure.h"
#include "db/signature.h"
#include "db/store_context.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::SizeIs;

namespace THIS_TEST {

World* const world = World::install();

class EndedMeanwhile : public testing::Test {
 protected:
    void SetUp() override {
        options.cheap_passwords = true;
        const auto store = open();
        store->accounts().create({"ada", "Ada", "correct horse battery", 8, false});
        for (const char* login : {"zofia", "bert"})
            people.push_back(
                store->accounts().create({login, login, "correct horse battery", 1, false}));
        code = store->studies().new_participant("pilot");
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        record.answers = {{"sus01", "4"}};
        store->studies().save_answers(record);
        store->backup(file("backup.db"));
    }
    [[nodiscard]] std::string file(const std::string& name) const { return folder.file(name); }
    [[nodiscard]] std::string url() const { return "sqlite:" + file("placode.db"); }
    [[nodiscard]] std::unique_ptr<db::Store> open() const { return db::open_store(url(), options); }
    /// As somebody with the file writes it. @param key with which they sign; nullptr: not at all.
    void forge(const std::string& action, const std::string& object, const std::string& detail,
               const db::KeyPair* key = nullptr) const {
        RawConnection pen("QSQLITE", file("placode.db"));
        db::TrailEntry entry{
            {0, db::utc_now(), "placode", action, object, detail}, "", key ? key->public_key : ""};
        const std::string before = pen.value("SELECT chain FROM audit ORDER BY id DESC LIMIT 1");
        const std::string chain = db::audit_chain(before, entry);
        const std::string signature =
            key ? db::sign_text(db::signed_text(chain), key->secret_key) : "";
        std::string values;
        for (const std::string& each : {entry.record.at_utc, entry.record.actor, action, object,
                                        detail, chain, entry.station, signature})
            values += (values.empty() ? "'" : ", '") + each + "'";
        ASSERT_TRUE(
            pen.run("INSERT INTO audit (at_utc, actor, action, object, detail, chain, station, "
                    "signature) VALUES (" +
                    values + ")"))
            << pen.problem();
    }
    [[nodiscard]] std::string user(size_t which) const {
        return "user " + std::to_string(people[which]);
    }

    TemporaryFolder folder;
    db::StoreOptions options;
    std::vector<int64_t> people;
    std::string code;
};

TEST_F(EndedMeanwhile, NobodyIsErasedOnTheWordOfARowThatNoComputerOfTheStoreSigned) {
    const db::KeyPair other = db::new_key_pair();
    for (const db::KeyPair* key : {static_cast<const db::KeyPair*>(nullptr), &other}) {
        forge("user.erase", user(0), "with attempts", key);
        forge("study.withdraw", "pilot " + code, "erase", key);
        forge("study.retention", "pilot " + code, "kept until 2020-01-01T00:00:00Z", key);
    }
    forge("station.trust", "station of mine", other.public_key, &other);
    forge("user.erase", user(1), "", &other);
    db::restore_store(url(), file("backup.db"));
    const auto store = open();
    for (const int64_t each : people) EXPECT_TRUE(store->accounts().find(each));
    EXPECT_THAT(store->studies().answers("pilot"), SizeIs(1));
    EXPECT_FALSE(store->studies().participants("pilot").at(0).withdrawal);
    EXPECT_THAT(db::done_again(*store), IsEmpty());
    const auto person = EndsWith(": user.erase " + user(0)),
               withdrawn = EndsWith(": study.withdraw pilot " + code),
               kept = EndsWith(": study.retention pilot " + code);
    EXPECT_THAT(db::not_believed(*store), ElementsAre(person, withdrawn, kept, person, withdrawn,
                                                      kept, EndsWith(": user.erase " + user(1))));
    EXPECT_THAT(store->check(), IsEmpty());
}

TEST_F(EndedMeanwhile, WhatTheProgramDidBesideSuchRowsIsDoneAgain) {
    forge("user.erase", user(0), "");
    open()->accounts().erase(people[1], false);
    open()->studies().withdraw("pilot", code, db::WithdrawalMode::kErase, "asked for it");
    db::restore_store(url(), file("backup.db"));
    const auto store = open();
    EXPECT_TRUE(store->accounts().find(people[0]));
    EXPECT_FALSE(store->accounts().find(people[1]));
    EXPECT_THAT(store->studies().answers("pilot"), IsEmpty());
    EXPECT_THAT(db::not_believed(*store), SizeIs(1));
}

TEST_F(EndedMeanwhile, ANumberThatIsNoneKeepsNobodyFromRestoring) {
    forge("user.erase", "user 99999999999999999999", "");
    ASSERT_NO_THROW((void)db::restore_store(url(), file("backup.db")));
    EXPECT_TRUE(open()->accounts().find(people[0]));
    // Nor does one in an entry that is believed.
    const auto entry = [](const char* object) {
        return db::AuditRecord{7, "2026-01-02T03:04:05.000Z", "carl", "user.erase", object, ""};
    };
    const auto found = db::people_of({entry("user 99999999999999999999"), entry("user -3"),
                                      entry("user 4x"), entry("user "), entry("user 5")});
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].user_id, 5);
}

/// Only its chain says of a trail from before signatures that nobody put an entry in.
TEST_F(EndedMeanwhile, AnOldTrailHasToFit) {
    const std::string old = file("old.db");
    RawConnection pen("QSQLITE", old);
    ASSERT_TRUE(
        pen.run("CREATE TABLE audit (id INTEGER PRIMARY KEY, at_utc TEXT, actor TEXT, "
                "action TEXT, object TEXT, detail TEXT, chain TEXT)"));
    std::string first, chain;
    const auto add = [&](int id, const char* action, const char* object, bool goes_on) {
        const db::TrailEntry entry{
            {id, "2020-01-01T00:00:00Z", "carl", action, object, ""}, "", ""};
        const std::string its = db::audit_chain(chain, entry);
        if (goes_on) chain = its;
        if (first.empty()) first = its;
        ASSERT_TRUE(pen.run("INSERT INTO audit VALUES (" + std::to_string(id) +
                            ", '2020-01-01T00:00:00Z', 'carl', '" + action + "', '" + object +
                            "', '', '" + its + "')"));
    };
    add(1, "user.create", "user 2", true);
    add(2, "user.erase", "user 2", true);
    add(3, "user.erase", "user 3", false);  // put in: the next one goes on from before it
    add(4, "user.erase", "user 4", true);
    add(5, "sign_in", "user 1", true);
    const auto read = [&](const std::string& store, bool without_signature) {
        const auto found = db::ended_meanwhile(old, {store, {}, without_signature});
        EXPECT_TRUE(found);
        std::string said;
        for (const db::AuditRecord& each : found->people) said += " " + each.object;
        for (const db::AuditRecord& each : found->doubted) said += " not " + each.object;
        return said;
    };
    EXPECT_EQ(read(first, true), " user 2 not user 3 not user 4");
    EXPECT_EQ(read(first, false), " not user 2 not user 3 not user 4")
        << "the backup is signed, so what came after it would be";
    EXPECT_EQ(read("of another store", true), "");
}

}  // namespace THIS_TEST
