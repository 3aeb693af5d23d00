// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The embedded store as a file: rights, damage, locks, backup and restore.

#include "db/sqlite_file.h"
#include "db/erasure.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/whole_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::HasSubstr;
using testing::IsEmpty;

namespace THIS_TEST {

World* const world = World::install();

class SqliteFile : public testing::Test {
 protected:
    void SetUp() override {
        ASSERT_NE(world, nullptr);
        options.cheap_passwords = true;
    }
    [[nodiscard]] std::unique_ptr<db::Store> open() const {
        return db::open_store(url + "?timeout_ms=200", options);
    }
    /// A store with enough in it to have many pages.
    void fill(int users = 40) const {
        const auto store = open();
        for (int i = 0; i < users; ++i)
            store->accounts().create({"user" + std::to_string(i), std::string(200, 'n'),
                                      "correct horse battery", 1, false});
    }
    /// Opening must fail, say why, and leave the bytes alone.
    void expect_refused(StoreError::Kind kind, const std::string& because) const {
        const std::string before = read_text(path);
        const auto error = failure_of([&] { (void)open(); });
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_THAT(error.what(), HasSubstr(because));
        EXPECT_THAT(error.what(), HasSubstr(path));
        EXPECT_EQ(read_text(path), before) << "the file was touched";
    }
    static void write_text(const std::string& file, const std::string& text) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
    }

    TemporaryFolder folder;
    std::string path = folder.file("placode.db");
    std::string url = "sqlite:" + path;
    db::StoreOptions options;
};

unsigned mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 0777u;
}

TEST_F(SqliteFile, IsForItsOwnerOnly) {
    const std::string deep = folder.file("a/b/placode.db");
    (void)db::open_store("sqlite:" + deep, options);
    EXPECT_EQ(mode_of(deep), 0600u);
    EXPECT_EQ(mode_of(folder.file("a/b")), 0700u);
    EXPECT_EQ(mode_of(folder.file("a")), 0700u);
}

TEST_F(SqliteFile, IsDurableStrictAndKeepsReferences) {
    fill(1);
    RawConnection raw("QSQLITE", path);
    EXPECT_EQ(raw.value("PRAGMA journal_mode"), "wal");
    EXPECT_EQ(raw.value("SELECT COUNT(*) FROM sqlite_schema WHERE type = 'table' AND sql LIKE "
                        "'CREATE TABLE%' AND name NOT LIKE 'sqlite_%' AND name <> "
                        "'schema_migrations' AND sql NOT LIKE '%STRICT'"),
              "0");
    db::Connection own(db::parse_store_url(url));
    for (const auto& [pragma, value] :
         {std::pair{"PRAGMA synchronous", 2}, std::pair{"PRAGMA foreign_keys", 1},
          std::pair{"PRAGMA busy_timeout", 5000}}) {
        db::Statement query(own, pragma);
        ASSERT_TRUE(query.run().next());
        EXPECT_EQ(query.integer(0), value) << pragma;
    }
}

TEST_F(SqliteFile, LeavesOneFileBehindWhenItIsClosed) {
    fill(3);
    EXPECT_TRUE(fs::exists(path));
    EXPECT_FALSE(fs::exists(path + "-wal"));
    EXPECT_FALSE(fs::exists(path + "-shm"));
}

TEST_F(SqliteFile, MayBeInMemory) {
    const auto store = db::open_store("sqlite::memory:", options);
    store->accounts().create({"anna", "Anna", "correct horse battery", 1, false});
    EXPECT_EQ(store->accounts().list().size(), 1u);
    EXPECT_EQ(store->url(), "sqlite::memory:");
}

TEST_F(SqliteFile, ATextFileIsNoStore) {
    write_text(path, "This is somebody's letter.\n");
    expect_refused(StoreError::Kind::kDamaged, "not a database");
    write_text(path, std::string(4096, 'x'));
    expect_refused(StoreError::Kind::kDamaged, "restore a backup");
}

TEST_F(SqliteFile, AnotherProgramsDatabaseIsNotTakenOver) {
    {
        RawConnection raw("QSQLITE", path);
        ASSERT_TRUE(raw.run("CREATE TABLE songs (title TEXT)"));
    }
    expect_refused(StoreError::Kind::kDamaged, "another program");
}

TEST_F(SqliteFile, AFileCutShortIsFoundAtOnce) {
    fill();
    const std::string whole = read_text(path);
    ASSERT_GT(whole.size(), 20000u);
    write_text(path, whole.substr(0, whole.size() / 2));
    expect_refused(StoreError::Kind::kDamaged, "cut short");
    write_text(path, whole.substr(0, 50));
    expect_refused(StoreError::Kind::kDamaged, "not a database");
}

TEST_F(SqliteFile, AStoreThatCouldNotBeMadeIsBegunAgain) {
    // As a disk without room: the tables of the first file fit, those of the next do not.
    db::StoreOptions broken = options;
    broken.migrations = db::embedded_migrations();
    broken.migrations.resize(2);
    broken.migrations[1].text = "CREATE TABLE half (id INTEGER); CREATE TABLE half (id INTEGER);";
    (void)failure_of([&] { (void)db::open_store("sqlite:" + path, broken); });
    EXPECT_THAT(files_with(folder.path(), "placode.db"), IsEmpty());
    // What a kill has left on the way was nobody's store.
    write_text(path + ".making", "SQLite format 3");
    write_text(path + ".making-journal", "half of it");
    fill(1);
    EXPECT_EQ(open()->accounts().list().size(), 1u);
    EXPECT_THAT(files_with(folder.path(), ".making"), IsEmpty());
    // A file that is there is never taken for one: it may hold what somebody wrote.
    const std::string whole = read_text(path);
    write_text(path, whole.substr(0, whole.size() / 2));
    expect_refused(StoreError::Kind::kDamaged, "cut short");
    EXPECT_EQ(read_text(path).size(), whole.size() / 2);
}

TEST_F(SqliteFile, OverwrittenPagesAreFoundByCheckOrOnOpening) {
    fill();
    std::string bytes = read_text(path);
    for (size_t at = 8192; at < 24576; ++at) bytes[at] = static_cast<char>(at * 37);
    write_text(path, bytes);
    std::string said;
    StoreError::Kind kind = StoreError::Kind::kDamaged;
    try {
        const auto problems = open()->check();
        ASSERT_FALSE(problems.empty());
        said = problems[0];
    } catch (const StoreError& error) {
        kind = error.kind();
        said = error.what();
    }
    EXPECT_EQ(kind, StoreError::Kind::kDamaged) << said;
}

TEST_F(SqliteFile, AStoreThatIsHeldExclusivelyIsLockedNotDamaged) {
    fill(1);
    RawConnection other("QSQLITE", path);
    ASSERT_TRUE(other.run("PRAGMA locking_mode = EXCLUSIVE"));
    ASSERT_TRUE(other.run("BEGIN EXCLUSIVE"));
    const auto error = failure_of([&] { (void)open(); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kLocked) << error.what();
    EXPECT_THAT(error.what(), HasSubstr("open sqlite:" + path));
    EXPECT_THAT(error.what(), HasSubstr("close it, or wait"));
}

TEST_F(SqliteFile, AFolderThatCannotBeMadeIsNamed) {
    write_text(folder.file("file"), "x");
    const auto error =
        failure_of([&] { (void)db::open_store("sqlite:" + folder.file("file/x.db")); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kUnavailable);
    EXPECT_THAT(error.what(), HasSubstr(folder.file("file")));
    EXPECT_EQ(failure_of([&] { (void)db::open_store("sqlite:" + folder.path().string()); }).kind(),
              StoreError::Kind::kUnavailable);
}

TEST_F(SqliteFile, ABackupIsAWholeStoreAndNeverOverwritesOne) {
    fill(5);
    const auto store = open();
    const std::string copy = folder.file("copy.db");
    store->backup(copy);
    EXPECT_EQ(mode_of(copy), 0600u);
    EXPECT_FALSE(fs::exists(copy + ".part"));
    const std::string bytes = read_text(copy);
    EXPECT_EQ(failure_of([&] { store->backup(copy); }).kind(), StoreError::Kind::kConflict);
    EXPECT_EQ(read_text(copy), bytes);
    EXPECT_EQ(failure_of([&] { store->backup("/nonexistent-folder/copy.db"); }).kind(),
              StoreError::Kind::kUnavailable);
    EXPECT_EQ(db::open_store("sqlite:" + copy, options)->accounts().list().size(), 5u);
    EXPECT_THAT(store->check(), IsEmpty());
}

TEST_F(SqliteFile, RestoringBringsBackTheBackupAndKeepsTheOldStoreAside) {
    fill(5);
    const std::string copy = folder.file("copy.db");
    open()->backup(copy);
    open()->accounts().create({"late", "Late", "correct horse battery", 1, false});
    const std::string aside = db::restore_store(url, copy);
    EXPECT_EQ(open()->accounts().list().size(), 5u);
    EXPECT_THAT(open()->check(), IsEmpty());
    EXPECT_EQ(open()->audit().trail(1).at(0).action, "store.restore");
    EXPECT_EQ(db::open_store("sqlite:" + aside, options)->accounts().list().size(), 6u);
    EXPECT_EQ(mode_of(path), 0600u);
}

TEST_F(SqliteFile, AKnownStoreThatIsGoneIsNoFirstStart) {
    fill(1);
    const auto refused = [&](const db::StoreOptions& with, const std::string& because) {
        const auto error = failure_of([&] { (void)db::open_store(url, with); });
        EXPECT_EQ(error.kind(), StoreError::Kind::kMissing) << error.what();
        EXPECT_THAT(error.what(), HasSubstr(because));
        EXPECT_THAT(error.what(), HasSubstr("restore a backup"));
        EXPECT_THAT(error.what(), HasSubstr("begin anew"));
    };
    const std::string copy = folder.file("copy.db");
    open()->backup(copy);
    fs::remove(path);
    refused(options, "is gone");
    EXPECT_FALSE(fs::exists(path)) << "nothing was made";
    write_text(path, "");
    refused(options, "is gone");
    // Another, empty store in its place.
    fs::remove(path);
    (void)db::open_store("sqlite:" + folder.file("other.db"), options);
    fs::rename(folder.file("other.db"), path);
    refused(options, "has none");
    db::restore_store(url, copy);
    EXPECT_EQ(open()->accounts().list().size(), 1u);
}

TEST_F(SqliteFile, WhatTheCallerRemembersCountsWithoutTheMark) {
    fill(1);
    fs::remove(path);
    fs::remove(db::mark_of_store(path));
    db::StoreOptions remembers = options;
    remembers.known = true;
    const auto error = failure_of([&] { (void)db::open_store(url, remembers); });
    EXPECT_EQ(error.kind(), StoreError::Kind::kMissing) << error.what();
    EXPECT_FALSE(fs::exists(path));
}

TEST_F(SqliteFile, ANewStoreInTheOldPlaceIsMadeOnlyOnPurpose) {
    fill(1);
    fs::remove(path);
    db::StoreOptions anew = options;
    anew.begin_anew = true;
    EXPECT_THAT(db::open_store(url, anew)->accounts().list(), IsEmpty());
    // A program that opens it before the first account is there does not stop the beginning.
    EXPECT_THAT(open()->accounts().list(), IsEmpty());
    fill(1);
    fs::remove(path);
    EXPECT_EQ(failure_of([&] { (void)open(); }).kind(), StoreError::Kind::kMissing);
}

TEST_F(SqliteFile, ADemonstrationMayGoWithoutAWord) {
    open()->accounts().create({"demo", "Demo", "correct horse battery", 1, true});
    fs::remove(path);
    EXPECT_THAT(open()->accounts().list(), IsEmpty());
}

TEST_F(SqliteFile, ADamagedStoreIsReplacedByItsBackup) {
    fill(5);
    const std::string copy = folder.file("copy.db");
    open()->backup(copy);
    write_text(path, "scrambled");
    const std::string aside = db::restore_store(url, copy);
    EXPECT_EQ(read_text(aside), "scrambled");
    EXPECT_EQ(open()->accounts().list().size(), 5u);
    // Nobody can tell who was erased in it since.
    EXPECT_EQ(open()->audit().trail(1).at(0).detail, db::kErasuresUnknown);
    (void)db::restore_store(url, copy);
    EXPECT_EQ(open()->audit().trail(1).at(0).detail, "") << "a store that can be read";
}

TEST_F(SqliteFile, RestoringRefusesABadBackupAndAStoreInUse) {
    fill(5);
    const std::string copy = folder.file("copy.db");
    open()->backup(copy);
    const std::string before = read_text(path);
    {
        RawConnection raw("QSQLITE", folder.file("songs.db"));
        ASSERT_TRUE(raw.run("CREATE TABLE songs (title TEXT)"));
    }
    write_text(folder.file("bad.db"), "not a backup");
    write_text(folder.file("empty.db"), "");
    write_text(folder.file("cut.db"), read_text(copy).substr(0, 30000));
    for (const char* bad : {"bad.db", "empty.db", "songs.db", "cut.db"})
        EXPECT_EQ(failure_of([&] { db::restore_store(url, folder.file(bad)); }).kind(),
                  StoreError::Kind::kDamaged)
            << bad;
    EXPECT_EQ(read_text(path), before);
    EXPECT_EQ(failure_of([&] { db::restore_store(url, folder.file("none.db")); }).kind(),
              StoreError::Kind::kNotFound);
    const auto in_use = open();
    EXPECT_EQ(failure_of([&] { db::restore_store(url + "?timeout_ms=100", copy); }).kind(),
              StoreError::Kind::kLocked);
    EXPECT_EQ(in_use->accounts().list().size(), 5u);
    EXPECT_FALSE(fs::exists(path + ".restoring"));
}

}  // namespace THIS_TEST
