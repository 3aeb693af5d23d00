// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A recording file is signed by the computer that made it; whoever changes it, or makes it
// elsewhere, has an attempt that counts for nothing.

#include "db/recording_seal.h"

#include <gmock/gmock.h>

#include "db/attempt_counting.h"
#include "db/signature.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using db::RecordingSignature;
using testing::HasSubstr;

namespace THIS_TEST {

class RecordingSeal : public testing::Test {
 protected:
    void SetUp() override {
        use("station.key");
        write_recording(path);
    }
    void use(const std::string& key) {
        ::setenv("PLACODE_STATION_KEY", folder.file(key).c_str(), 1);
    }
    void edit(const std::string& sql) {
        RawConnection pen("QSQLITE", path);
        ASSERT_TRUE(pen.run(sql)) << sql << ": " << pen.problem();
    }
    [[nodiscard]] RecordingSignature signature() const {
        return db::recording_seal(path).signature;
    }

    TemporaryFolder folder;
    std::string path = folder.file("one.placode");
};

class SignedAttempts : public EngineTest {
 protected:
    void ready() override {
        store = open();
        person = store->accounts().create(trainee("anna"));
    }
    /// Why the attempt of a person with this recording does not count; "" = it does.
    std::string saved(const std::string& file) {
        db::AttemptResult result = make_result();
        result.header.demonstration = false;
        result.header.seed = ++seed;
        result.end.final_hash = seed;
        result.recording_file = file;
        return store->attempts().detail(store->attempts().save(person, result)).record.void_reason;
    }
    std::string recorded(const std::string& name, const std::string& key) {
        ::setenv("PLACODE_STATION_KEY", folder.file(key).c_str(), 1);
        const std::string file = folder.file(name);
        write_recording(file, 2 + static_cast<int>(++seed));
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        return file;
    }

    std::unique_ptr<db::Store> store;
    int64_t person = 0;
    uint64_t seed = 0;
};

INSTANTIATE_TEST_SUITE_P(Engines, SignedAttempts, testing::Values("Sqlite", "Postgresql"),
                         engine_name);

TEST_F(RecordingSeal, TheComputerThatRecordsSigns) {
    const db::RecordingSeal seal = db::recording_seal(path);
    EXPECT_EQ(seal.signature, RecordingSignature::kRight);
    EXPECT_TRUE(db::is_public_key(seal.station));
    const std::string second = folder.file("two.placode");
    write_recording(second);
    EXPECT_EQ(db::recording_seal(second).station, seal.station) << "the key is kept";
}

TEST_F(RecordingSeal, EveryEditBreaksIt) {
    const std::string whole = folder.file("whole.placode");
    fs::copy_file(path, whole);
    for (const char* sql :
         {"UPDATE meta SET value = replace(value, 'script:expert', 'mouse') WHERE key = 'header'",
          "UPDATE meta SET value = replace(value, '2', '3') WHERE key = 'end'",
          "UPDATE meta SET value = value || ' ' WHERE key = 'writer'",
          "INSERT INTO meta (key, value, checksum) VALUES ('haptics', '{}', '')",
          "UPDATE chunks SET checksum = replace(checksum, 'a', 'b')",
          "UPDATE chunks SET count = count - 1", "UPDATE chunks SET first = first + 1",
          "DELETE FROM chunks WHERE id = (SELECT MAX(id) FROM chunks)",
          "INSERT INTO chunks (kind, first, count, checksum, content) SELECT kind, first, count, "
          "checksum, content FROM chunks LIMIT 1",
          "UPDATE meta SET value = replace(replace(value, '0', '1'), '2', '1') WHERE key = "
          "'station'",
          "UPDATE meta SET value = '' WHERE key = 'station'"}) {
        fs::copy_file(whole, path, fs::copy_options::overwrite_existing);
        ASSERT_EQ(signature(), RecordingSignature::kRight);
        edit(sql);
        EXPECT_EQ(signature(), RecordingSignature::kWrong) << sql;
    }
    fs::copy_file(whole, path, fs::copy_options::overwrite_existing);
    edit("DELETE FROM meta WHERE key = 'station'");
    EXPECT_EQ(signature(), RecordingSignature::kNone);
}

TEST_F(RecordingSeal, ACertificateIsSignedWithItAndRepairsNothing) {
    db::add_haptic_certificate(path, R"({"grade":"sound"})");
    EXPECT_EQ(signature(), RecordingSignature::kRight);
    const std::string forged = folder.file("forged.placode");
    write_recording(forged);
    path = forged;
    edit("UPDATE meta SET value = replace(value, 'script:expert', 'mouse') WHERE key = 'header'");
    db::add_haptic_certificate(path, R"({"grade":"sound"})");
    EXPECT_EQ(signature(), RecordingSignature::kWrong);
}

TEST_F(RecordingSeal, AnotherComputersRecordingIsNotSignedAgainHere) {
    const std::string station = db::recording_seal(path).station;
    use("other.key");
    db::add_haptic_certificate(path, R"({"grade":"sound"})");
    EXPECT_EQ(signature(), RecordingSignature::kWrong);
    EXPECT_EQ(db::recording_seal(path).station, station);
}

TEST_F(RecordingSeal, WithoutAPlaceForAKeyThereIsNoSignatureAndNoFailure) {
    ::setenv("PLACODE_STATION_KEY", "/proc/no/such/place.key", 1);
    const std::string second = folder.file("two.placode");
    EXPECT_NO_THROW(write_recording(second));
    EXPECT_EQ(db::recording_seal(second).signature, RecordingSignature::kNone);
}

TEST_F(RecordingSeal, ADamagedKeyIsNamedAndNotReplaced) {
    std::ofstream(folder.file("broken.key")) << "abc def\n";
    use("broken.key");
    const std::string second = folder.file("two.placode");
    EXPECT_THAT(failure_of([&] { write_recording(second); }).what(), HasSubstr("broken.key"));
    EXPECT_EQ(read_text(folder.file("broken.key")), "abc def\n");
}

TEST_P(SignedAttempts, OnlyWhatAComputerOfTheStoreRecordedCounts) {
    EXPECT_EQ(saved(recorded("own.placode", "station.key")), "");
    const std::string foreign = recorded("foreign.placode", "other.key");
    const std::string mark = db::fingerprint(db::recording_seal(foreign).station);
    EXPECT_EQ(saved(foreign), "Practice, not verified: the recording is signed by " + mark +
                                  ", not by a computer of this store");
    store->audit().trust_station(db::recording_seal(foreign).station);
    EXPECT_EQ(saved(recorded("later.placode", "other.key")), "");
    const std::string changed = recorded("changed.placode", "station.key");
    ASSERT_TRUE(RawConnection("QSQLITE", changed).run("DELETE FROM meta WHERE key = 'station'"));
    EXPECT_THAT(saved(changed), HasSubstr("signed by nobody"));
}

}  // namespace THIS_TEST
