// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The audit trail names nobody: it is chained, so a name in it would outlive its person.

#include <gmock/gmock.h>

#include "db/erasure.h"
#include "tests/store_fixture.h"

using namespace placode;

namespace THIS_TEST {

namespace fs = std::filesystem;

class TrailNames : public testing::Test {
 protected:
    void SetUp() override {
        db::StoreOptions options;
        options.cheap_passwords = true;
        store = db::open_store("sqlite:" + folder.file("placode.db"), options);
        add("spare", "Spare", db::Role::kAdministrator);
        anna = add("anna", "Anna Łącka", db::Role::kTrainee);
        user = add("user", "The user", db::Role::kTrainee);
        lucja = add("l.c", "Łucja Ćma", db::Role::kTrainee);
    }
    int64_t add(const std::string& login, const std::string& name, db::Role role) const {
        return store->accounts().create(
            {login, name, "long enough 1", static_cast<db::Roles>(role), false});
    }
    [[nodiscard]] std::string kept(const std::string& text) const {
        store->audit().write("test", "export.csv", text, text);
        const db::AuditRecord entry = store->audit().trail(1).at(0);
        EXPECT_EQ(entry.object, entry.detail);
        return entry.detail;
    }

    test::TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    int64_t anna = 0, user = 0, lucja = 0;
};

TEST_F(TrailNames, WhoeverIsNamedStandsThereByNumber) {
    const std::string number = "user " + std::to_string(anna);
    EXPECT_EQ(kept("anna"), number);
    EXPECT_EQ(kept("proctor ANNA"), "proctor " + number);
    EXPECT_EQ(kept("/home/anna/report.pdf"), "/home/" + number + "/report.pdf");
    EXPECT_EQ(kept("Anna Łącka (anna), twice: anna"),
              number + " (" + number + "), twice: " + number);
    EXPECT_EQ(kept("annals of annar, hannah"), "annals of annar, hannah") << "other words";
    // What the trail itself says stays as it is, whatever log-ins there are.
    EXPECT_EQ(kept("user 12"), "user 12");
    EXPECT_EQ(kept("the user"), "user " + std::to_string(user));
    store->audit().write("local administrator (anna)", "export.csv", "study pilot", "");
    EXPECT_EQ(store->audit().trail(1).at(0).actor, "local administrator (" + number + ")");
}

TEST_F(TrailNames, InCapitalsAndWithAccentsApartItIsTheSameName) {
    const std::string number = "user " + std::to_string(anna),
                      hers = "user " + std::to_string(lucja);
    EXPECT_EQ(kept("ANNA \u0141\u0104CKA"), number);
    EXPECT_EQ(kept("anna łącka, ANNA ŁĄCKA!"), number + ", " + number + "!");
    // As some systems write the names of files.
    EXPECT_EQ(kept("/home/Anna \u0141a\u0328cka/x.pdf"), "/home/" + number + "/x.pdf");
    EXPECT_EQ(kept("ANNA \u0141A\u0328CKA: ŁUCJA C\u0301MA"), number + ": " + hers);
    EXPECT_EQ(kept("„łucja ćma” – ŁUCJA ĆMA…"), "„" + hers + "” – " + hers + "…");
    EXPECT_EQ(kept("śródmieście, ŻÓŁĆ: ŁUCJA ĆMA ßß"), "śródmieście, ŻÓŁĆ: " + hers + " ßß");
    for (const char* other : {"ŁUCJA ĆMAŃSKA", "Śłucja ćma", "łucja ćma\u0301",
                              "Łucja \u0106m\u0105", "Lucja Cma", "łucja ćma7"})
        EXPECT_EQ(kept(other), other) << "other words";
}

TEST_F(TrailNames, NothingNamesAPersonWhoWasErased) {
    (void)kept("asked for by Anna Łącka");
    store->audit().write("anna", "session.lock", "anna", "");
    const auto erasure = db::erase_person(*store, store->url(), anna, false);
    EXPECT_TRUE(erasure.entries.empty());
    for (const db::AuditRecord& entry : store->audit().trail(1000))
        for (const std::string& said : {entry.actor, entry.object, entry.detail}) {
            EXPECT_EQ(said.find("anna"), std::string::npos) << said;
            EXPECT_EQ(said.find("Łącka"), std::string::npos) << said;
        }
}

/// A place of a copy is needed, to erase there as well; what an earlier version wrote is chained.
TEST_F(TrailNames, WhatCannotBeChangedIsSaidWithTheErasure) {
    const std::string backup = folder.file("anna") + "/store.db";
    fs::create_directories(folder.file("anna"));
    store->backup(backup);
    const int64_t entry = store->audit().trail(1).at(0).id;
    const auto erasure = db::erase_person(*store, store->url(), anna, false);
    EXPECT_THAT(erasure.entries, testing::ElementsAre(entry));
    EXPECT_THAT(db::erasure_certificate(erasure),
                testing::HasSubstr("they stay: " + std::to_string(entry)));
}

TEST_F(TrailNames, ThePlaceOfACopyNamesAPersonInCapitalsToo) {
    const std::string place = folder.file("ŁUCJA ĆMA");
    fs::create_directories(place);
    store->backup(place + "/store.db");
    const int64_t entry = store->audit().trail(1).at(0).id;
    const auto erasure = db::erase_person(*store, store->url(), lucja, false);
    EXPECT_THAT(erasure.entries, testing::ElementsAre(entry));
}

TEST_F(TrailNames, RecordingsThatNobodySavedGoWithTheirPerson) {
    fs::create_directories(folder.file("recordings"));
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.file("recordings/" + name)) << text;
    };
    const std::string own = "{\"user_id\":" + std::to_string(anna);
    for (const char* name : {"own", "of_a_study", "with_proctor"})
        write(name + std::string(".placode"), "recording");
    write("own.placode.order.json", own + ",\"user_name\":\"Anna\"}");
    write("of_a_study.placode.order.json", own + ",\"study\":\"pilot\"}");
    write("with_proctor.placode.order.json", R"({"user_id":1,"proctor":"anna"})");
    const auto erasure = db::erase_person(*store, store->url(), anna, false);
    EXPECT_THAT(erasure.recordings,
                testing::ElementsAre(testing::EndsWith("recordings/own.placode")));
    EXPECT_FALSE(fs::exists(folder.file("recordings/own.placode")));
    EXPECT_FALSE(fs::exists(folder.file("recordings/own.placode.order.json")));
    EXPECT_TRUE(fs::exists(folder.file("recordings/of_a_study.placode")));
    ASSERT_EQ(erasure.left.size(), 1u) << "somebody else's attempt names the proctor";
    EXPECT_THAT(erasure.left[0].path, testing::EndsWith("with_proctor.placode.order.json"));
}

}  // namespace THIS_TEST
