// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store and its backup for tests that kill what works on them, or let its calls fail.

#include <gmock/gmock.h>

#include "tests/bars.h"
#include "tests/store_fixture.h"
#include "tests/traced_child.h"
#include "tests/whole_store.h"

namespace placode::test {

inline constexpr int kOld = 6, kNew = 5;  ///< Accounts of the store and of its backup.
inline constexpr int kExitOffset = 10;    ///< Behind it a StoreError's kind as exit status.

/// A store of six accounts beside its backup, which has five, and work on them in a child.
class DurableFile : public testing::Test {
 protected:
    void SetUp() override {
        options.cheap_passwords = true;
        const std::string url = "sqlite:" + original("placode.db");
        const auto add = [&](db::Store& store, int i) {
            store.accounts().create(
                {"user" + std::to_string(i), "User", "correct horse battery", 8, false});
        };
        for (int i = 0; i < kNew; ++i) add(*db::open_store(url, options), i);
        db::open_store(url, options)->backup(original("copy.db"));
        add(*db::open_store(url, options), kNew);
    }

    /// Store and backup as they were, in a folder of their own.
    void begin_again() {
        folder = std::make_unique<TemporaryFolder>();
        for (const char* name : {"placode.db", "copy.db", "placode.db.known", "placode.db.seen"})
            if (fs::exists(original(name))) fs::copy_file(original(name), folder->file(name));
        path = folder->file("placode.db");
    }
    [[nodiscard]] std::string original(const std::string& name) const {
        return originals.file(name);
    }
    [[nodiscard]] std::string url() const { return "sqlite:" + path; }

    /// Exit status 0, or the kind of the error.
    static int outcome(const std::function<void()>& work) {
        try {
            work();
            return 0;
        } catch (const db::StoreError& error) {
            return kExitOffset + static_cast<int>(error.kind());
        } catch (...) {
            return 1;
        }
    }
    [[nodiscard]] TracedRun run(const TracedOptions& traced, const std::function<void()>& work) {
        begin_again();
        return TracedChild(traced).run([&] { return outcome(work); });
    }
    /// Kills `work` before each of its steps in turn; `look` judges what is left. Of the writes
    /// into files the suite takes a sample, a long run all.
    void kill_everywhere(const char* name, const std::function<void()>& work,
                         const std::function<void(bool killed)>& look, TracedOptions traced = {}) {
        traced.every_nth_write = times(traced.every_nth_write, 1);
        const TracedRun whole = run(traced, work);
        ASSERT_EQ(whole.exit_status, 0);
        look(false);
        ASSERT_GT(whole.steps, 10);
        Bar bar(name);
        for (int step = 0; step < whole.steps; ++step) {
            traced.kill_at = step;
            const TracedRun cut = run(traced, work);
            ASSERT_TRUE(cut.killed) << step;
            SCOPED_TRACE("killed before: " + cut.log.back());
            look(true);
            bar.tried(!HasFailure());
            if (HasFailure()) return;
        }
        RecordProperty("steps", whole.steps);
    }
    [[nodiscard]] int accounts_of(const std::string& file) const {
        return accounts_of_whole(file, options);
    }
    [[nodiscard]] std::vector<std::string> names_with(const std::string& part) const {
        return files_with(folder->path(), part);
    }
    static void scramble(const std::string& file) {
        std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
        bytes.seekp(8192);
        bytes << std::string(40000, 'x');
    }

    TemporaryFolder originals;
    std::unique_ptr<TemporaryFolder> folder;
    std::string path;
    db::StoreOptions options;
};

}  // namespace placode::test
