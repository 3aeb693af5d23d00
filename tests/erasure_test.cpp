// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/erasure.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>

#include "db/ended_again.h"
#include "db/signature.h"
#include "db/trail_head.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

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
    /// Takes part in a study, has signed and answered.
    static std::string participant(db::Store& store) {
        const std::string code = store.studies().new_participant("pilot");
        store.records().save_consent_signature("pilot", code, "M1 2 L3 4");
        answer(store, code);
        return code;
    }
    static void answer(db::Store& store, const std::string& code) {
        db::AnswerRecord record;
        record.study_id = "pilot";
        record.participant = code;
        record.questionnaire_id = "sus";
        record.answers = {{"sus01", "4"}};
        store.studies().save_answers(record);
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

TEST_F(Erasure, ARestoreBringsBackNothingThatAParticipantWithdrew) {
    std::vector<std::string> codes;
    {
        const auto store = open();
        for (int i = 0; i < 4; ++i) codes.push_back(participant(*store));
    }
    backup("day_before.db");
    open()->studies().withdraw("pilot", codes[0], db::WithdrawalMode::kErase, "asked for it");
    open()->studies().withdraw("pilot", codes[1], db::WithdrawalMode::kStop, "moved away");
    open()->studies().erase_kept("pilot", codes[2], "2020-01-01T00:00:00Z");
    const auto check = [&] {
        const auto restored = open();
        const auto people = restored->studies().participants("pilot");
        ASSERT_THAT(people, SizeIs(4));
        EXPECT_EQ(people[0].withdrawal, db::WithdrawalMode::kErase);
        EXPECT_EQ(people[0].withdrawal_reason, "asked for it") << "it stands in no trail";
        EXPECT_EQ(people[1].withdrawal, db::WithdrawalMode::kStop);
        EXPECT_EQ(people[1].withdrawal_reason, "moved away");
        EXPECT_FALSE(people[2].withdrawal) << "the time was over";
        std::vector<std::string> answered;
        for (const auto& each : restored->studies().answers("pilot"))
            answered.push_back(each.participant);
        EXPECT_THAT(answered, ElementsAre(codes[1], codes[3]));
        for (const size_t gone : {0U, 2U})
            EXPECT_FALSE(restored->records().consent_signature("pilot", codes[gone]));
        EXPECT_THAT(db::done_again(*restored),
                    ElementsAre("pilot " + codes[0] + ": erase", "pilot " + codes[1] + ": stop",
                                "pilot " + codes[2] + ": kept until 2020-01-01T00:00:00Z"));
        EXPECT_THAT(restored->check(), IsEmpty());
    };
    db::restore_store(url(), file("day_before.db"));
    check();
    db::restore_store(url(), file("day_before.db"));
    check();
    // What was given after it, and what the backup knows of already, stays as it is.
    answer(*open(), codes[2]);
    backup("later.db");
    db::restore_store(url(), file("later.db"));
    EXPECT_THAT(open()->studies().answers("pilot"), SizeIs(3));
    EXPECT_THAT(db::done_again(*open()), IsEmpty());
}

TEST_F(Erasure, WithdrawalsOfAnEarlierVersionAreReadWithTheirReason) {
    const auto entry = [](const char* action, const char* object, const char* detail) {
        return db::AuditRecord{7, "2026-01-02T03:04:05.000Z", "carl", action, object, detail};
    };
    const auto found = db::ended_records(
        {entry("study.withdraw", "a study P001-C", "erase: moved away"),
         entry("study.withdraw", "pilot P002-X", "stop"), entry("study.withdraw", "pilot", "stop"),
         entry("study.withdraw", "pilot P003-Y", "what is this"),
         entry("study.retention", "pilot P004-Z", "kept until 2020-01-01T00:00:00Z")});
    ASSERT_THAT(found, SizeIs(3));
    EXPECT_EQ(found[0].study, "a study");
    EXPECT_EQ(found[0].code, "P001-C");
    EXPECT_EQ(found[0].mode, db::WithdrawalMode::kErase);
    EXPECT_EQ(found[1].mode, db::WithdrawalMode::kStop);
    EXPECT_FALSE(found[2].mode);
    EXPECT_EQ(found[2].until_utc, "2020-01-01T00:00:00Z");
}

TEST_F(Erasure, NamesTheCopiesThatMayHoldAParticipantsRecords) {
    backup("one.db");
    backup("gone.db");
    fs::remove(file("gone.db"));
    fs::copy_file(file("one.db"), file("placode.db.replaced-20260101T000000000Z"));
    std::vector<std::string> paths;
    for (const db::LeftCopy& each : db::copies_with_records(url())) paths.push_back(each.path);
    EXPECT_THAT(paths,
                ElementsAre(file("one.db"), file("placode.db.replaced-20260101T000000000Z")));
    EXPECT_THAT(db::copies_with_records("postgresql://a@b/c"), IsEmpty());
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
