// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/participant_key.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "db/participant.h"
#include "tests/store_fixture.h"

using namespace placode;
using namespace placode::test;
using db::ParticipantKey;
using db::StoreError;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

void write_text(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
}

constexpr const char* kPhrase = "four quiet grey needles";

class Key : public testing::Test {
 protected:
    TemporaryFolder folder;
    const std::string path = folder.file("keys/pilot.placode-key");
    const std::string code = db::participant_code(1);
};

TEST_F(Key, HidesNamesAndGivesThemBackForThePassphrase) {
    {
        auto key = ParticipantKey::create(path, "pilot", kPhrase, true);
        key.put({db::participant_code(2), "Zofia Test", "", "", ""});
        key.put({code, "Żaneta Próba", "ward 3", "left-handed", ""});
        EXPECT_EQ(key.entries().at(0).code, code) << "by code";
        key.put({code, "Żaneta Próba-Nowa", "ward 4", "", ""});
        EXPECT_EQ(key.entries().size(), 2u) << "the same code again replaces";
    }
    const std::string bytes = read_text(path);
    for (const char* secret : {"Próba", "aneta", "ward", "Zofia", "P001"})
        EXPECT_THAT(bytes, Not(HasSubstr(secret)));
    EXPECT_EQ(std::filesystem::status(path).permissions() & std::filesystem::perms::mask,
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    auto key = ParticipantKey::open(path, kPhrase);
    EXPECT_EQ(key.study_id(), "pilot");
    ASSERT_EQ(key.entries().size(), 2u);
    EXPECT_EQ(key.entries()[0].name, "Żaneta Próba-Nowa");
    EXPECT_EQ(key.entries()[0].contact, "ward 4");
    key.change_passphrase("another long passphrase");
    EXPECT_THROW((void)ParticipantKey::open(path, kPhrase), StoreError);
    EXPECT_EQ(ParticipantKey::open(path, "another long passphrase").entries().size(), 2u);
    key.remove(code);
    EXPECT_THROW(key.remove(code), StoreError);
    EXPECT_EQ(ParticipantKey::open(path, "another long passphrase").entries().size(), 1u);
}

TEST_F(Key, TheSameContentNeverLooksTheSame) {
    auto key = ParticipantKey::create(path, "pilot", kPhrase, true);
    key.put({code, "Anna Test", "", "", "2026-01-01T00:00:00Z"});
    const std::string first = read_text(path);
    key.put(key.entries().front());
    EXPECT_NE(read_text(path), first) << "salt and nonce are new with every save";
}

TEST_F(Key, KeepsTheSecretHalfOfTheSealUnderThePassphrase) {
    const std::string open =
        ParticipantKey::create(path, "pilot", kPhrase, true).consent_keys().public_key;
    const std::string box = db::encrypted("M1 2 L3 4", open);
    const auto key = ParticipantKey::open(path, kPhrase);
    EXPECT_EQ(db::decrypted(box, key.consent_keys()), "M1 2 L3 4");
    EXPECT_THAT(read_text(path), Not(HasSubstr(key.consent_keys().secret_key)));
}

TEST_F(Key, RefusesWrongPassphrasesChangedFilesAndWhatIsNone) {
    EXPECT_EQ(failure_of([&] { ParticipantKey::create(path, "pilot", "short", true); }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(failure_of([&] { ParticipantKey::open(path, kPhrase); }).kind(),
              StoreError::Kind::kNotFound);
    auto key = ParticipantKey::create(path, "pilot", kPhrase, true);
    EXPECT_EQ(failure_of([&] { ParticipantKey::create(path, "pilot", kPhrase, true); }).kind(),
              StoreError::Kind::kConflict)
        << "a key is never overwritten";
    EXPECT_EQ(failure_of([&] {
                  key.put({"P001-?", "x", "", "", ""});
              }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_EQ(failure_of([&] {
                  key.put({code, "", "", "", ""});
              }).kind(),
              StoreError::Kind::kRefused);
    EXPECT_THAT(failure_of([&] { ParticipantKey::open(path, "not the right one"); }).what(),
                HasSubstr("passphrase is wrong"));
    std::string bytes = read_text(path);
    const size_t at = bytes.find("\"box\": \"") + 12;
    bytes[at] = bytes[at] == 'A' ? 'B' : 'A';
    write_text(path, bytes);
    EXPECT_THAT(failure_of([&] { ParticipantKey::open(path, kPhrase); }).what(),
                HasSubstr("was changed"));
    write_text(path, "{\"format\":\"placode participant key\",\"version\":1}");
    EXPECT_EQ(failure_of([&] { ParticipantKey::open(path, kPhrase); }).kind(),
              StoreError::Kind::kDamaged);
}

TEST_F(Key, StandsApartFromTheStore) {
    EXPECT_EQ(db::default_key_path("sqlite:/data/placode.db", "pilot"),
              "/data/keys/pilot.placode-key");
    EXPECT_THAT(db::default_key_path("postgresql://u:p@h/n", "pilot"),
                testing::EndsWith("/keys/pilot.placode-key"));
}

}  // namespace THIS_TEST
