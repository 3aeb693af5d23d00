// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Restore, update and backup are killed at every step that changes a file: there is always a whole
// store, the old or the new one. What a copy is worth is seen before it counts.

#include "db/durable_file.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>

#include "db/private_file.h"
#include "tests/durable_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();

size_t place_of(const std::vector<std::string>& log, const std::string& words) {
    for (size_t i = 0; i < log.size(); ++i)
        if (log[i].find(words) != std::string::npos) return i;
    return log.size();
}

TEST_F(DurableFile, ARestoreKilledAnywhereLeavesTheOldOrTheNewStore) {
    for (const bool without_exchange : {false, true}) {
        TracedOptions traced;
        traced.without_exchange = without_exchange;
        kill_everywhere(
            "killed: restore", [&] { db::restore_store(url(), folder->file("copy.db")); },
            [&](bool killed) {
                ASSERT_TRUE(fs::exists(path));
                const int found = accounts_of(path);
                EXPECT_THAT(found, AnyOf(kOld, kNew));
                if (!killed) {
                    EXPECT_EQ(found, kNew);
                    const auto aside = names_with(".replaced-");
                    ASSERT_EQ(aside.size(), 1u);
                    EXPECT_EQ(accounts_of(aside[0]), kOld);
                } else if (found == kNew) {
                    EXPECT_FALSE(names_with(".replaced-").empty())
                        << "the old one is there under its other name";
                }
                // Whatever the killed one left is in nobody's way.
                if (without_exchange) return;
                db::restore_store(url(), folder->file("copy.db"));
                EXPECT_EQ(accounts_of(path), kNew);
            },
            traced);
    }
}

TEST_F(DurableFile, ARestoreIsOnTheDiskBeforeItCounts) {
    const TracedRun whole = run({}, [&] { db::restore_store(url(), folder->file("copy.db")); });
    ASSERT_EQ(whole.exit_status, 0);
    const size_t exchanged = place_of(whole.log, "exchange ");
    const size_t named = place_of(whole.log, "rename " + path + ".restoring ");
    ASSERT_LT(exchanged, whole.log.size()) << testing::PrintToString(whole.log);
    ASSERT_LT(named, exchanged);
    EXPECT_EQ(whole.log[named - 1], "fsync " + path + ".restoring");
    EXPECT_EQ(whole.log[exchanged + 1], "fsync " + folder->path().string());
}

// "disk I/O error" alone says neither which disk nor what to do.
TEST_F(DurableFile, ADiskWithoutRoomIsSaidWithItsFolder) {
    begin_again();
    const auto store = db::open_store(url());
    rlimit before{}, none{1, RLIM_INFINITY};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    none.rlim_max = before.rlim_max;
    ::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
    const StoreError error = failure_of([&] { store->groups().create("Ours"); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), HasSubstr("(folder " + folder->path().string() + ")"));
    EXPECT_THAT(error.what(), AnyOf(HasSubstr("make room and try again"), HasSubstr("check it")));
}

/// What is written while the disk takes no more than `room` bytes in a file.
bool kept_with(rlim_t room, const std::string& path, const std::string& text) {
    rlimit before{}, none{room, RLIM_INFINITY};
    EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    none.rlim_max = before.rlim_max;
    ::signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
    db::PrivateFile file(path);
    const bool kept =
        file.open(QIODevice::WriteOnly) && file.write(text.c_str()) > 0 && file.commit();
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_TRUE(kept || !file.errorString().isEmpty());
    return kept;
}

// Short ones leave a buffer only at the end, long ones go in one call, which takes a part of them.
TEST_F(DurableFile, AFileThatTheDiskDoesNotTakeWholeIsNotPutInPlaceOfTheOld) {
    begin_again();
    const std::string path = folder->file("key.txt");
    ASSERT_TRUE(kept_with(RLIM_INFINITY, path, "as it was"));
    for (const size_t size : {size_t{100}, size_t{16384}, size_t{100000}})
        for (const rlim_t room : {rlim_t{0}, rlim_t{50}}) {
            EXPECT_FALSE(kept_with(room, path, std::string(size, 'x'))) << size << " " << room;
            EXPECT_EQ(read_text(path), "as it was") << size << " " << room;
        }
}

// Renamed over /dev/full by an administrator, a report takes it away from every program.
TEST_F(DurableFile, AFileTakesThePlaceOfNoDeviceAndNoPipe) {
    begin_again();
    const std::string path = folder->file("pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const auto entries = [&] {
        return std::distance(fs::directory_iterator(folder->path()), fs::directory_iterator());
    };
    const auto before = entries();
    db::WholeFile file(QString::fromStdString(path));
    EXPECT_FALSE(file.open(QIODevice::WriteOnly));
    EXPECT_THAT(file.errorString().toStdString(), HasSubstr("no file but a device"));
    EXPECT_FALSE(db::PrivateFile(path).open(QIODevice::WriteOnly));
    EXPECT_TRUE(fs::is_fifo(path));
    EXPECT_EQ(entries(), before) << "nothing beside it";
}

// A copy that fills the store's own disk takes the store with it.
TEST_F(DurableFile, ACopyWithoutRoomIsRefusedBeforeAnythingIsWritten) {
    begin_again();
    auto full = options;
    full.room_bytes = int64_t{64} << 20;  // Less than the store and the reserve.
    {
        const auto store = db::open_store(url(), full);
        const size_t entries = store->audit().of_action("store.backup").size();
        const StoreError error =
            failure_of([&] { store->backup(folder->file("no room.backup.db")); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kRefused);
        EXPECT_THAT(error.what(), HasSubstr("only 67 MB are free there, and the copy needs 6"));
        EXPECT_EQ(store->audit().of_action("store.backup").size(), entries) << "no copy was begun";
    }
    for (const auto& entry : fs::directory_iterator(folder->path()))
        EXPECT_THAT(entry.path().filename().string(), testing::Not(HasSubstr("no room")));
    // Nor is a store updated that could not be copied before.
    full.migrations = db::embedded_migrations();
    full.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    EXPECT_THAT(failure_of([&] { (void)db::open_store(url(), full); }).what(),
                HasSubstr("MB are free there"));
    EXPECT_TRUE(names_with(".before-update-").empty());
    full.room_bytes = int64_t{128} << 20;
    (void)db::open_store(url(), full);
    EXPECT_EQ(names_with(".before-update-").size(), 1u);
    db::open_store(url(), full)->backup(folder->file("room.backup.db"));
    EXPECT_TRUE(fs::exists(folder->file("room.backup.db")));
}

// A name is in the folder above it: a power cut must not take new folders and the mark away.
TEST_F(DurableFile, NewFoldersAndTheMarkAreOnTheDisk) {
    const auto deep = [this] { return folder->file("new/below/placode.db"); };
    const TracedRun whole = run({}, [&] {
        const auto store = db::open_store("sqlite:" + deep());
        store->accounts().create({"ada", "Ada", "correct horse battery", 8, false});
    });
    ASSERT_EQ(whole.exit_status, 0);
    for (const std::string& name : {folder->path().string(), folder->file("new"), deep() + ".known",
                                    folder->file("new/below")})
        EXPECT_GT(std::count(whole.log.begin(), whole.log.end(), "fsync " + name), 0)
            << name << testing::PrintToString(whole.log);
}

TEST_F(DurableFile, ARestoreWhereNoStoreIsKilledAnywhereIsNoFirstStart) {
    kill_everywhere(
        "killed: restore where no store is",
        [&] {
            fs::remove(path);
            db::restore_store(url(), folder->file("copy.db"));
        },
        [&](bool killed) {
            try {
                EXPECT_THAT(accounts_of(path), AnyOf(kOld, kNew));
            } catch (const StoreError& error) {
                EXPECT_TRUE(killed);
                EXPECT_EQ(error.kind(), StoreError::Kind::kMissing) << error.what();
            }
        });
}

TEST_F(DurableFile, AnUpdateKilledAnywhereLeavesAStoreThatOpens) {
    auto newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    kill_everywhere(
        "killed: update", [&] { (void)db::open_store(url(), newer); },
        [&](bool) {
            {
                const auto store = db::open_store(url(), newer);
                EXPECT_EQ(store->accounts().list().size(), size_t{kOld});
                EXPECT_THAT(store->check(), IsEmpty());
            }
            // Whatever is called a copy is a whole one; a part and its journal are not.
            for (const std::string& copy : names_with(".before-update-")) {
                if (copy.find(".part") != std::string::npos) continue;
                EXPECT_EQ(accounts_of(copy), kOld);
            }
        });
}

TEST_F(DurableFile, ABackupKilledAnywhereIsWholeOrNotThere) {
    TracedOptions traced;
    traced.every_nth_write = 40;
    kill_everywhere(
        "killed: backup", [&] { db::open_store(url(), options)->backup(folder->file("new.db")); },
        [&](bool killed) {
            EXPECT_EQ(accounts_of(path), kOld);
            const bool known =
                !db::open_store(url(), options)->audit().of_action("store.backup").empty();
            for (const char* name : {"new.db", "new.db.part"})
                EXPECT_TRUE(known || !fs::exists(folder->file(name)))
                    << name << " may hold whoever is erased later";
            if (!fs::exists(folder->file("new.db")) && killed)
                db::open_store(url(), options)->backup(folder->file("new.db"));
            EXPECT_EQ(accounts_of(folder->file("new.db")), kOld);
        },
        traced);
}

TEST_F(DurableFile, ABackupThatCannotBeReadAgainDoesNotCount) {
    TracedOptions traced;
    traced.before = [&](const std::string& step) {
        // The disk keeps something else than what was written.
        if (step == "fsync " + folder->file("new.db.part")) scramble(folder->file("new.db.part"));
    };
    const TracedRun ended =
        run(traced, [&] { db::open_store(url(), options)->backup(folder->file("new.db")); });
    EXPECT_EQ(ended.exit_status, kExitOffset + static_cast<int>(StoreError::Kind::kDamaged));
    EXPECT_FALSE(fs::exists(folder->file("new.db")));
    EXPECT_TRUE(fs::exists(folder->file("new.db.failed")));
}

TEST_F(DurableFile, AStoreWhoseCopyCannotBeReadAgainIsNotUpdated) {
    auto newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    TracedOptions traced;
    traced.before = [&](const std::string& step) {
        if (step.rfind("fsync ", 0) == 0 && step.ends_with(".part")) scramble(step.substr(6));
    };
    const TracedRun ended = run(traced, [&] { (void)db::open_store(url(), newer); });
    EXPECT_EQ(ended.exit_status, kExitOffset + static_cast<int>(StoreError::Kind::kDamaged));
    EXPECT_EQ(accounts_of(path), kOld) << "the program of before still opens it";
}

TEST_F(DurableFile, ABackupOfATamperedStoreSaysSo) {
    begin_again();
    {
        RawConnection raw("QSQLITE", path);
        ASSERT_TRUE(raw.run("DROP TRIGGER audit_is_never_changed"));
        ASSERT_TRUE(raw.run("UPDATE audit SET actor = 'nobody' WHERE id = 1")) << raw.problem();
    }
    const auto error =
        failure_of([&] { db::open_store(url(), options)->backup(folder->file("new.db")); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kDamaged) << error.what();
    EXPECT_THAT(error.what(), HasSubstr("new.db.failed"));
    EXPECT_FALSE(fs::exists(folder->file("new.db")));
}

TEST_F(DurableFile, ABackupOnAFullDiskLeavesNothingAndSaysSo) {
    const TracedRun ended = run({}, [&] {
        const auto store = db::open_store(url(), options);
        const rlimit small{65536, 65536};
        ::setrlimit(RLIMIT_FSIZE, &small);
        ::signal(SIGXFSZ, SIG_IGN);
        store->backup(folder->file("new.db"));
    });
    EXPECT_EQ(ended.exit_status, kExitOffset + static_cast<int>(StoreError::Kind::kUnavailable));
    EXPECT_FALSE(fs::exists(folder->file("new.db")));
    EXPECT_EQ(accounts_of(path), kOld);
}

}  // namespace THIS_TEST
