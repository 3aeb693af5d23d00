// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The disk fails, is full or loses power at every call in turn while a store is made, updated,
// written, backed up and restored and while an attempt is recorded. Then either an error says so or
// what was acknowledged is there, the store is sound, and the same command can be given again.

#include <gmock/gmock.h>
#include <sys/mman.h>

#include "curriculum/attempt_recorder.h"
#include "db/recording_seal.h"
#include "tests/bars.h"
#include "tests/fault_vfs.h"
#include "tests/store_cases.h"
#include "tests/whole_store.h"

using namespace placode;
using namespace placode::test;
using db::StoreError;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;

// Instead of the C library's, for the product, Qt and SQLite.
extern "C" int fsync(int number) { return FaultVfs::install().on_sync(number); }
extern "C" int fdatasync(int number) { return FaultVfs::install().on_sync(number); }

namespace THIS_TEST {

constexpr int kOld = 6, kNew = 5;  // accounts of the store and of its backup
constexpr int kBlocks = 3, kFrames = 250;
constexpr const char *kWhole = "attempt.placode", *kInterrupted = "cut.placode";
constexpr int kErrorStatus = 1, kOtherErrorStatus = 2;

/// What a child that was forked says to the test, also when it loses power.
struct Told {
    int64_t calls, kept_frames;
    StoreError::Kind kind;
    char words[600];
};

/// A command, and what is asked when it has ended, well or not.
struct Command {
    std::function<void()> act;
    /// Whether what `act` writes is there. Everything else that has to be true is expected in it.
    std::function<bool()> is_there;
    /// The same command, when it was there and when it was not.
    std::function<void(bool was_there)> again;
    /// Parts of names that no file may have when it has ended by itself.
    std::vector<std::string> leaves_no = {};
    /// The same for a file that is there only when it has done its work.
    std::string makes = {};
};

class DiskFaults : public testing::Test {
 protected:
    void SetUp() override {
        options.cheap_passwords = true;
        ::setenv("PLACODE_STATION_KEY", originals.file("station.key").c_str(), 1);
        told = static_cast<Told*>(::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE,
                                         MAP_SHARED | MAP_ANONYMOUS, -1, 0));
        ASSERT_NE(told, MAP_FAILED);
        (void)FaultVfs::install();
        const std::string whole = "sqlite:" + originals.file("placode.db");
        for (int i = 0; i < kNew; ++i) add(whole, i);
        db::open_store(whole, options)->backup(originals.file("copy.db"));
        add(whole, kNew);
        write_recording(originals.file(kWhole));
        write_interrupted_recording();
    }
    void TearDown() override { ::munmap(told, sizeof(Told)); }

    /// One whose journal still lies beside it: power went in its last step.
    void write_interrupted_recording() {
        const auto write = [this](int64_t at) {
            const pid_t child = ::fork();
            if (child == 0) {
                FaultVfs::install().arm(Fault::kPowerCut, at, originals.path());
                fs::remove(originals.file(kInterrupted));
                write_recording(originals.file(kInterrupted));
                told->calls = FaultVfs::install().calls();
                ::_exit(0);
            }
            ::waitpid(child, nullptr, 0);
        };
        write(kNever);
        write(told->calls - 1);
        ASSERT_TRUE(fs::exists(originals.file(std::string(kInterrupted) + "-journal")));
    }

    void add(const std::string& store, int i) const {
        db::open_store(store, options)->accounts().create(trainee("user" + std::to_string(i)));
    }
    /// Store, backup and recording as they were, in a folder of their own.
    void begin_again() {
        folder = std::make_unique<TemporaryFolder>();
        attic = std::make_unique<TemporaryFolder>();
        for (const auto& entry : fs::directory_iterator(originals.path()))
            fs::copy_file(entry.path(), folder->path() / entry.path().filename());
        path = folder->file("placode.db");
        url = "sqlite:" + path;
    }

    /// The command in a child that is given the fault. @return its exit status
    int run(const Command& command, Fault fault, int64_t at) {
        begin_again();
        *told = {};
        const pid_t child = ::fork();
        if (child == 0) {
            FaultVfs::install().arm(fault, at, attic->path());
            const int status = outcome(command.act);
            told->calls = FaultVfs::install().calls();
            ::_exit(status);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    int outcome(const std::function<void()>& act) const {
        const auto say = [this](const char* words) {
            std::strncpy(told->words, words, sizeof told->words - 1);
        };
        try {
            act();
            return 0;
        } catch (const StoreError& error) {
            told->kind = error.kind();
            say(error.what());
            return kErrorStatus;
        } catch (const std::exception& error) {
            say(error.what());
            return kOtherErrorStatus;
        }
    }

    /// Gives the command the fault at one call after the other; the suite takes a sample of them.
    void fail_everywhere(const char* name, const Command& command, Fault fault, int sample) {
        ASSERT_EQ(run(command, fault, kNever), 0) << told->words;
        ASSERT_TRUE(command.is_there());
        const int64_t calls = told->calls;
        ASSERT_GT(calls, 3);
        Bar bar(name);
        const int64_t rounds = std::min<int64_t>(times(sample, 1'000'000), calls);
        for (int64_t round = 0; round < rounds; ++round) {
            const int64_t at = round * calls / rounds;
            const int status = run(command, fault, at);
            SCOPED_TRACE(std::string(name) + ", call " + std::to_string(at) + " of " +
                         std::to_string(calls) + ", said: " + told->words);
            look(command, fault, status);
            bar.tried(!HasFailure());
            if (HasFailure()) return;
        }
    }
    void look(const Command& command, Fault fault, int status) {
        const bool cut = fault == Fault::kPowerCut || fault == Fault::kPowerCutHalf;
        EXPECT_THAT(status, AnyOf(0, kErrorStatus, cut ? kPowerCutStatus : 0)) << told->words;
        if (status == kErrorStatus) {
            EXPECT_FALSE(cut) << "nothing but the power has failed";
            EXPECT_THAT(told->kind,
                        AnyOf(StoreError::Kind::kUnavailable, StoreError::Kind::kDamaged));
            EXPECT_THAT(told->words, HasSubstr(folder->path().string()));
        }
        if (!cut && told->kind != StoreError::Kind::kDamaged) {
            for (const std::string& part : command.leaves_no)
                EXPECT_THAT(names_with(part), IsEmpty());
        }
        if (status == kErrorStatus && told->kind == StoreError::Kind::kUnavailable &&
            !command.makes.empty()) {
            EXPECT_FALSE(fs::exists(folder->file(command.makes))) << "it was said that it failed";
        }
        if (HasFailure()) return;
        try {
            const bool there = command.is_there();
            EXPECT_TRUE(there || status != 0) << "it was acknowledged and is not there";
            if (HasFailure()) return;
            command.again(there);
            EXPECT_TRUE(command.is_there());
        } catch (const std::exception& error) {
            ADD_FAILURE() << "afterwards: " << error.what();
        }
    }
    void every_fault(const std::string& name, const Command& command, int sample) {
        for (const auto& [fault, word] : {std::pair{Fault::kError, "EIO"},
                                          {Fault::kReadError, "EIO when it is read"},
                                          {Fault::kFull, "full"},
                                          {Fault::kPowerCut, "power cut"},
                                          {Fault::kPowerCutHalf, "power cut in any order"}}) {
            fail_everywhere((name + ": " + word).c_str(), command, fault, sample);
            if (HasFailure()) return;
        }
    }

    Command saving(const std::string& recording);
    [[nodiscard]] int accounts_of(const std::string& file) const {
        return accounts_of_whole(file, options);
    }
    [[nodiscard]] std::vector<std::string> names_with(const std::string& part) const {
        return files_with(folder->path(), part);
    }

    TemporaryFolder originals;
    std::unique_ptr<TemporaryFolder> folder, attic;
    std::string path, url;
    db::StoreOptions options;
    Told* told = nullptr;
};

TEST_F(DiskFaults, AStoreIsMade) {
    Command make;
    make.act = [&] {
        const auto store = db::open_store("sqlite:" + folder->file("fresh/new.db"), options);
        store->accounts().create(trainee("first"));
    };
    make.is_there = [&] {
        const std::string fresh = folder->file("fresh/new.db");
        return fs::exists(fresh) && fs::file_size(fresh) > 0 && accounts_of(fresh) == 1;
    };
    make.again = [&](bool was_there) {
        if (!was_there) make.act();
    };
    every_fault("make a store", make, 12);
}

TEST_F(DiskFaults, AnAccountIsAdded) {
    Command create;
    create.act = [&] { add(url, kOld); };
    create.is_there = [&] {
        const int found = accounts_of(path);
        EXPECT_THAT(found, AnyOf(kOld, kOld + 1));
        return found == kOld + 1;
    };
    create.again = [&](bool was_there) {
        if (!was_there) return create.act();
        EXPECT_EQ(failure_of(create.act).kind(), StoreError::Kind::kConflict);
    };
    every_fault("add an account", create, 12);
}

TEST_F(DiskFaults, AStoreThatIsOpenGoesOnAfterAFault) {
    Command create;
    create.act = [&] {
        const auto store = db::open_store(url, options);
        const auto person = trainee("user" + std::to_string(kOld));
        try {
            store->accounts().create(person);
        } catch (const StoreError&) {
            const int64_t calls = FaultVfs::install().calls();
            FaultVfs::install()
                .disarm();  // The disk is well again, and the shell was never closed.
            told->calls = calls;
            store->accounts().create(person);
            if (!store->check().empty()) throw std::runtime_error(store->check().front());
        }
    };
    create.is_there = [&] { return accounts_of(path) == kOld + 1; };
    create.again = [&](bool was_there) {
        if (!was_there) add(url, kOld);  // It could not even be opened.
    };
    every_fault("an open store goes on", create, 8);
}

TEST_F(DiskFaults, AListIsWholeOrNotThere) {
    for (int i = 0; i < 40; ++i)
        db::open_store("sqlite:" + originals.file("placode.db"), options)
            ->audit()
            .write("unknown", "test.write", std::string(1000, 'x'), "");
    size_t entries = 0;
    Command list;
    list.act = [&] {
        const size_t found = db::open_store(url, options)->audit().trail(1000).size();
        if (entries != 0 && found != entries)
            throw std::runtime_error("only " + std::to_string(found) + " entries");
    };
    list.is_there = [&] {
        entries = db::open_store(url, options)->audit().trail(1000).size();
        return entries > 40;
    };
    list.again = [&](bool) { list.act(); };
    fail_everywhere("list the trail: EIO when it is read", list, Fault::kReadError, 40);
}

/// Saving an attempt with one of the recordings.
Command DiskFaults::saving(const std::string& recording) {
    auto result = std::make_shared<db::AttemptResult>(make_result());
    result->header.demonstration = false;  // It counts, so its signature is looked at.
    if (recording == kInterrupted) result->end.reason = sim::EndReason::kInterrupted;
    Command save;
    save.act = [this, result, recording] {
        result->recording_file = folder->file(recording);
        (void)db::open_store(url, options)->attempts().save(1, *result);
    };
    save.is_there = [this, recording] {
        EXPECT_EQ(accounts_of(path), kOld);
        const auto store = db::open_store(url, options);
        const auto found = store->attempts().list(1, "");
        EXPECT_LE(found.size(), 1u);
        for (const auto& attempt : found) {
            EXPECT_EQ(attempt.void_reason, "");
            EXPECT_EQ(attempt.haptic_grade, "") << "it has no certificate, sound or not";
        }
        // By its bytes, after what was half written into it was rolled back.
        EXPECT_EQ(store->attempts().find_recording(folder->file(recording)).has_value(),
                  found.size() == 1);
        return found.size() == 1;
    };
    save.again = [save](bool was_there) {
        if (!was_there) save.act();
    };
    return save;
}

TEST_F(DiskFaults, AnAttemptIsSaved) { every_fault("save an attempt", saving(kWhole), 12); }

TEST_F(DiskFaults, AnInterruptedAttemptIsSaved) {
    every_fault("save an interrupted attempt", saving(kInterrupted), 12);
}

TEST_F(DiskFaults, AnOlderStoreIsBroughtUpToDate) {
    auto newer = options;
    newer.migrations = db::embedded_migrations();
    newer.migrations.push_back({"9001_test.sql", "CREATE TABLE later (id {ID}) {STRICT};\n"});
    Command update;
    update.act = [&] { (void)db::open_store(url, newer); };
    update.is_there = [&] {
        for (const std::string& copy : names_with(".before-update-")) {
            if (copy.find(".part") != std::string::npos) continue;
            if (copy.find(".failed") != std::string::npos) continue;
            EXPECT_EQ(accounts_of(copy), kOld);
        }
        const bool there = !RawConnection("QSQLITE", path)
                                .value("SELECT name FROM sqlite_schema WHERE name = 'later'")
                                .empty();
        if (!there) {
            EXPECT_EQ(accounts_of(path), kOld) << "the program of before still opens it";
        }
        return there;
    };
    update.again = [&](bool) {
        const auto store = db::open_store(url, newer);
        EXPECT_THAT(store->check(), IsEmpty());
        EXPECT_EQ(store->accounts().list().size(), size_t{kOld});
    };
    update.leaves_no = {".part"};
    every_fault("update a store", update, 12);
}

TEST_F(DiskFaults, ABackupIsMade) {
    Command backup;
    backup.act = [&] { db::open_store(url, options)->backup(folder->file("new.db")); };
    backup.is_there = [&] {
        EXPECT_EQ(accounts_of(path), kOld);
        if (!fs::exists(folder->file("new.db"))) return false;
        EXPECT_EQ(accounts_of(folder->file("new.db")), kOld);
        return true;
    };
    backup.again = [&](bool was_there) {
        if (!was_there) return backup.act();
        EXPECT_EQ(failure_of(backup.act).kind(), StoreError::Kind::kConflict);
    };
    backup.leaves_no = {".part"};
    backup.makes = "new.db";
    every_fault("backup", backup, 12);
}

TEST_F(DiskFaults, ABackupIsRestored) {
    Command restore;
    restore.act = [&] { db::restore_store(url, folder->file("copy.db")); };
    restore.is_there = [&] {
        const int found = accounts_of(path);
        EXPECT_THAT(found, AnyOf(kOld, kNew));
        if (found != kNew) return false;
        // Written into the copy before it takes the place of the store, as an erasure is.
        EXPECT_EQ(db::open_store(url, options)->audit().trail(1).at(0).action, "store.restore");
        const auto aside = names_with(".replaced-");
        EXPECT_FALSE(aside.empty()) << "the old one is there under its other name";
        return true;
    };
    restore.again = [&](bool) { restore.act(); };
    restore.leaves_no = {".restoring"};
    every_fault("restore", restore, 12);
}

TEST_F(DiskFaults, AnAttemptIsRecorded) {
    Command record;
    const auto name = [&] { return folder->file("new.placode"); };
    record.act = [&] {
        curriculum::AttemptRecorder recorder(db::create_recording_file(name()),
                                             make_result().header);
        recorder.start();
        for (int block = 0; block < kBlocks; ++block) {
            for (int i = 0; i < kFrames; ++i) {
                sim::Input input;
                input.frame = block * kFrames + i;
                EXPECT_TRUE(recorder.put(input));
            }
            while (recorder.kept() < (block + 1) * kFrames)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if (recorder.problem().empty()) told->kept_frames = recorder.kept();
        }
        recorder.finish({sim::EndReason::kFinished, 0.75, 1, 0});
        if (!recorder.problem().empty())
            throw StoreError(StoreError::Kind::kUnavailable, recorder.problem());
    };
    record.is_there = [&] {
        if (!fs::exists(name())) {
            EXPECT_EQ(told->kept_frames, 0);
            return false;
        }
        try {
            const auto found = db::recover_recording_file(name());
            EXPECT_EQ(found.damage, "");
            EXPECT_GE(static_cast<int64_t>(found.recording.inputs.size()), told->kept_frames);
            const bool whole = found.recording.end.reason == sim::EndReason::kFinished;
            EXPECT_TRUE(!whole ||
                        db::recording_seal(name()).signature == db::RecordingSignature::kRight);
            return whole;
        } catch (const StoreError& error) {
            EXPECT_EQ(told->kept_frames, 0) << error.what();
            EXPECT_STREQ(told->words, "") << "one that never began leaves no file";
            EXPECT_THAT(error.what(), HasSubstr("never began"));
            return false;
        }
    };
    record.again = [&](bool was_there) {
        if (was_there) return;
        fs::remove(name());  // What is left is saved as interrupted, and removed.
        record.act();
    };
    every_fault("record", record, 12);
}

}  // namespace THIS_TEST
