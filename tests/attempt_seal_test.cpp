// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What this centre states about an attempt: checked by the program and, without any of its code, by
// examples/check_seal.py.

#include "db/attempt_seal.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "db/attempt_counting.h"
#include "db/station.h"
#include "sim/core/hidden_letters.h"
#include "tests/store_cases.h"

using namespace placode;
using namespace placode::test;
using testing::HasSubstr;
using testing::Not;

namespace THIS_TEST {

constexpr const char* kNow = "2026-11-25T19:00:00Z";

class AttemptSeal : public testing::Test {
 protected:
    void SetUp() override {
        ::setenv("PLACODE_STATION_KEY", folder.file("station.key").c_str(), 1);
        store = db::open_store("sqlite:" + folder.file("store.db"));
        const int64_t person = store->accounts().create(trainee("anna"));
        db::AttemptResult result = make_result();
        result.recording_file = folder.file("attempt.placode");
        write_recording(result.recording_file);
        attempt = store->attempts().save(person, result);
        store->attempts().extract_recording(attempt, recording);
        seal = db::attempt_seal(*store, attempt, recording, kNow);
    }
    /// Exit status of the foreign checker.
    int check(const std::string& page, const std::string& more = {}) {
        const std::string file = folder.file("seal.txt");
        std::ofstream(file, std::ios::binary) << page;
        const std::string command = "/usr/bin/python3 '" PLACODE_SOURCE_DIR
                                    "/examples/check_seal.py' '" +
                                    file + "' " + more + " >/dev/null 2>&1";
        return std::system(command.c_str()) >> 8;
    }
    /// What it says.
    std::string shown(const std::string& page) {
        const std::string file = folder.file("page.txt"), said = folder.file("said.txt");
        std::ofstream(file, std::ios::binary) << page;
        const std::string command = "PYTHONIOENCODING=utf-8 /usr/bin/python3 '" PLACODE_SOURCE_DIR
                                    "/examples/check_seal.py' '" +
                                    file + "' > '" + said + "' 2>&1";
        EXPECT_EQ(std::system(command.c_str()) >> 8, 3);
        std::ifstream in(said, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    TemporaryFolder folder;
    std::unique_ptr<db::Store> store;
    int64_t attempt = 0;
    std::string recording = folder.file("extracted.placode"), seal;
};

TEST_F(AttemptSeal, SaysWhatTheStoreHolds) {
    const db::AttemptRecord record = store->attempts().detail(attempt).record;
    EXPECT_THAT(seal, HasSubstr("\nperson: " + record.user_name + "\n"));
    EXPECT_THAT(seal, HasSubstr("\ntask: " + record.task_id));
    EXPECT_THAT(seal, HasSubstr(std::string("\ncounts: ") + (db::counts(record) ? "yes" : "no")));
    EXPECT_THAT(seal, HasSubstr("\nstated: " + std::string(kNow) + "\n"));
    EXPECT_THAT(seal, HasSubstr("\nrecording: signed\n"));
    EXPECT_TRUE(db::seal_is_right(seal));
}

TEST_F(AttemptSeal, AForeignProgramFindsItRight) {
    EXPECT_EQ(check(seal), 3) << "nobody said whose key it is";
    EXPECT_EQ(check(seal, "'" + recording + "'"), 3);
    const std::string key = db::Station().public_key();
    EXPECT_EQ(check(seal, "'" + recording + "' --station " + key), 0);
    EXPECT_EQ(check(seal, "--station " + std::string(64, 'a')), 1);
}

TEST_F(AttemptSeal, EveryChangedCharacterBreaksIt) {
    // Both checkers see the same bytes: ours every place of the page, the slow foreign one some.
    for (size_t i = 0; i + 1 < seal.size(); ++i) {
        std::string changed = seal;
        changed[i] = changed[i] == '7' ? '8' : '7';
        EXPECT_FALSE(db::seal_is_right(changed)) << "character " << i;
        if (i % 97 == 0) {
            EXPECT_EQ(check(changed), 1) << "character " << i;
        }
    }
    EXPECT_FALSE(db::seal_is_right({}));
    EXPECT_FALSE(db::seal_is_right("signature: 00\n"));
    EXPECT_FALSE(db::seal_is_right(seal + seal));
}

TEST_F(AttemptSeal, AnotherRecordingIsSeen) {
    const std::string other = folder.file("other.placode");
    write_recording(other, 3);
    EXPECT_EQ(check(seal, "'" + other + "'"), 1);
    RawConnection pen("QSQLITE", recording);
    ASSERT_TRUE(pen.run("UPDATE meta SET value = replace(value, 'a', 'b') WHERE key = 'header'"));
    EXPECT_EQ(check(seal, "'" + recording + "'"), 1);
}

TEST_F(AttemptSeal, AnotherComputerSealsInItsOwnName) {
    const std::string first = db::Station().public_key();
    ::setenv("PLACODE_STATION_KEY", folder.file("other.key").c_str(), 1);
    const std::string theirs = db::attempt_seal(*store, attempt, recording, kNow);
    EXPECT_TRUE(db::seal_is_right(theirs));
    EXPECT_THAT(theirs, HasSubstr("\nrecorded by station: " + first + "\n"));
    EXPECT_THAT(theirs, Not(HasSubstr("\nstated by station: " + first + "\n")));
    EXPECT_EQ(check(theirs, "--station " + first), 1);
    // The key is right, and the trail does not know it: said, and no success.
    EXPECT_THAT(seal, HasSubstr("\nstation registered: yes\n"));
    EXPECT_THAT(theirs, HasSubstr("\nstation registered: no, it is the computer that has the file "
                                  "of the store\n"));
    EXPECT_EQ(check(theirs, "--station " + db::Station().public_key()), 3);
}

TEST_F(AttemptSeal, WhoseKeyItIsStaysOpenUntilSomebodyNamesIt) {
    const std::string said = folder.file("said.txt");
    const auto open_lines = [&](const std::string& more, int status) {
        std::ofstream(folder.file("page.txt"), std::ios::binary) << seal;
        const std::string command = "/usr/bin/python3 '" PLACODE_SOURCE_DIR
                                    "/examples/check_seal.py' '" +
                                    folder.file("page.txt") + "' " + more + " > '" + said + "'";
        EXPECT_EQ(std::system(command.c_str()) >> 8, status);
        std::ifstream in(said);
        const std::string text(std::istreambuf_iterator<char>(in), {});
        return text.find("OPEN   whose station that is") != std::string::npos;
    };
    EXPECT_TRUE(open_lines("", 3));
    EXPECT_FALSE(open_lines("--station " + db::Station().public_key(), 0));
}

TEST_F(AttemptSeal, ANameIsNoStatement) {
    const int64_t eve = store->accounts().create(trainee("eve"));
    // Such a name is refused; an earlier version took it.
    const std::string name =
        "'Eve' || char(10) || 'points of 100: 100.00' || char(8232) || 'counts: yes' || char(27) "
        "|| "
        "'[2K' || char(8238)";
    ASSERT_TRUE(RawConnection("QSQLITE", folder.file("store.db"))
                    .run("UPDATE persons SET display_name = " + name + ", login = " + name +
                         " WHERE account_id = " + std::to_string(eve)));
    db::AttemptResult result = make_result();
    result.header.seed = 99;
    result.end.final_hash = 99;
    result.recording_file = folder.file("eve.placode");
    write_recording(result.recording_file, 4);
    const int64_t id = store->attempts().save(eve, result);
    store->attempts().extract_recording(id, recording);
    const std::string page = db::attempt_seal(*store, id, recording, kNow);
    constexpr const char* kMark = "\xEF\xBF\xBD";  // U+FFFD
    EXPECT_THAT(page, HasSubstr(std::string("\nperson: Eve") + kMark + "points of 100: 100.00" +
                                kMark + "counts: yes" + kMark + "[2K" + kMark + "\n"));
    // No reader finds a line in it that the centre did not write: some part text at U+2028.
    EXPECT_FALSE(sim::has_hidden_letters(page, "\n"));
    EXPECT_TRUE(db::seal_is_right(page));
    EXPECT_THAT(shown(page), HasSubstr("Eve"));
}

TEST_F(AttemptSeal, HiddenLettersOfAnEarlierPageDoNotReachTheTerminal) {
    // An earlier version left them on the page, and whoever has a key can sign such a page.
    std::string page = seal.substr(0, seal.find("signature: "));
    const std::string person = "\nperson: ";
    page.insert(page.find(person) + person.size(), "Eve\xE2\x80\xA8\x1b[2K\xE2\x80\xAE");
    page += "signature: " + db::Station().sign(page) + "\n";
    EXPECT_TRUE(db::seal_is_right(page));
    const std::string said = shown(page);
    EXPECT_THAT(said, HasSubstr("Eve"));
    for (const char* hidden : {"\x1b", "\xE2\x80\xA8", "\xE2\x80\xAE"})
        EXPECT_THAT(said, Not(HasSubstr(hidden)));
}

}  // namespace THIS_TEST
