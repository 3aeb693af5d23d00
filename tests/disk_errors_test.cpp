// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every system call that changes a file fails in turn, also those that do not come from SQLite:
// exchanging two files, copying one, the mark beside a store, the station's key, the trail's end.
// disk_faults_test does the same, and more, below SQLite.

#include "tests/durable_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AnyOf;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();

class DiskErrors : public DurableFile {
 protected:
    /// `look` judges what is left, and gives the command again.
    void fail_everywhere(const char* name, const std::function<void()>& work,
                         const std::function<void(bool done)>& look) {
        TracedOptions traced;
        traced.every_nth_write = times(8, 1);
        const TracedRun whole = run(traced, work);
        ASSERT_EQ(whole.exit_status, 0);
        Bar bar(name);
        const int rounds = std::min(times(16, 1'000'000), whole.steps);
        for (int round = 0; round < rounds; ++round)
            for (const int problem : {EIO, ENOSPC}) {
                traced.fail_at = round * whole.steps / rounds;
                traced.fail_with = problem;
                const TracedRun cut = run(traced, work);
                SCOPED_TRACE(std::strerror(problem) + (": " + whole.log[traced.fail_at]) +
                             ", ended with " + std::to_string(cut.exit_status));
                EXPECT_THAT(cut.exit_status, AnyOf(0, status_of(StoreError::Kind::kUnavailable),
                                                   status_of(StoreError::Kind::kDamaged)));
                if (!HasFailure()) judge(look, cut.exit_status == 0);
                bar.tried(!HasFailure());
                if (HasFailure()) return;
            }
    }
    static int status_of(StoreError::Kind kind) { return kExitOffset + static_cast<int>(kind); }
    static void judge(const std::function<void(bool)>& look, bool done) {
        try {
            look(done);
        } catch (const std::exception& error) {
            ADD_FAILURE() << "afterwards: " << error.what();
        }
    }
};

TEST_F(DiskErrors, OfAStoreThatIsMade) {
    const auto fresh = [&] { return folder->file("a/new.db"); };
    const auto make = [&] {
        ::setenv("PLACODE_STATION_KEY", folder->file("a/station.key").c_str(), 1);
        const auto store = db::open_store("sqlite:" + fresh(), options);
        store->accounts().create({"first", "First", "correct horse battery", 8, false});
    };
    fail_everywhere("make a store: EIO and ENOSPC of any call", make, [&](bool done) {
        if (done) {
            EXPECT_EQ(accounts_of(fresh()), 1);
        } else if (!fs::exists(fresh()) || fs::file_size(fresh()) == 0 ||
                   accounts_of(fresh()) == 0) {
            make();
        }
        EXPECT_EQ(accounts_of(fresh()), 1);
    });
}

TEST_F(DiskErrors, OfABackup) {
    const auto backup = [&] { db::open_store(url(), options)->backup(folder->file("new.db")); };
    fail_everywhere("backup: EIO and ENOSPC of any call", backup, [&](bool done) {
        EXPECT_EQ(accounts_of(path), kOld);
        EXPECT_EQ(fs::exists(folder->file("new.db")), done);
        EXPECT_THAT(names_with(".part"), IsEmpty());
        if (!done) backup();
        EXPECT_EQ(accounts_of(folder->file("new.db")), kOld);
    });
}

TEST_F(DiskErrors, OfARestore) {
    const auto restore = [&] { db::restore_store(url(), folder->file("copy.db")); };
    fail_everywhere("restore: EIO and ENOSPC of any call", restore, [&](bool done) {
        const int found = accounts_of(path);
        EXPECT_THAT(found, AnyOf(kNew, done ? kNew : kOld));
        EXPECT_THAT(names_with(".restoring"), IsEmpty());
        if (found == kNew) {
            EXPECT_FALSE(names_with(".replaced-").empty());
            EXPECT_EQ(db::open_store(url(), options)->audit().trail(1).at(0).action,
                      "store.restore");
        }
        restore();
        EXPECT_EQ(accounts_of(path), kNew);
    });
}

TEST_F(DiskErrors, OfAnUpdate) {
    auto newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    const auto update = [&] { (void)db::open_store(url(), newer); };
    fail_everywhere("update a store: EIO and ENOSPC of any call", update, [&](bool) {
        EXPECT_THAT(names_with(".part"), IsEmpty());
        for (const std::string& copy : names_with(".before-update-"))
            EXPECT_EQ(accounts_of(copy), kOld);
        const auto store = db::open_store(url(), newer);
        EXPECT_EQ(store->accounts().list().size(), size_t{kOld});
        EXPECT_THAT(store->check(), IsEmpty());
    });
}

}  // namespace THIS_TEST
