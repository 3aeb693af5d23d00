// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a stage begins with is kept whole or not at all, and whatever is damaged is not there.

#include "db/stage_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "curriculum/attempt_runner.h"
#include "tests/scratch_root.h"

namespace placode::db {
namespace THIS_TEST {

namespace fs = std::filesystem;
using curriculum::StageStart;

const std::string kTask = "{\"id\":\"a\"}";

class StageCacheTest : public ::testing::Test {
 protected:
    void SetUp() override {
        std::string name = (test::scratch_root() / "placode-stages-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = fs::path(name) / "placode" / "stages";
    }
    void TearDown() override { fs::remove_all(folder.parent_path().parent_path()); }

    fs::path folder;
};

StageStart made(int stage, size_t bytes = 100'000) {
    StageStart start;
    start.stage = stage;
    start.hash = ~uint64_t{0} - static_cast<uint64_t>(stage);
    start.given.resize(3000);
    for (size_t i = 0; i < start.given.size(); ++i) {
        start.given[i].frame = static_cast<int64_t>(i);
        start.given[i].tool_count = 2;
        start.given[i].tools[1].position_m[2] = 1e-6F * static_cast<float>(i);
    }
    // Bytes that no packing makes small.
    uint64_t random = 88172645463325252ULL + static_cast<uint64_t>(stage);
    start.state.resize(bytes);
    for (uint8_t& byte : start.state) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        byte = static_cast<uint8_t>(random);
    }
    return start;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

TEST_F(StageCacheTest, GivesBackWhatItKeepsToTheSameTaskCaseAndStage) {
    const StageCache cache(folder);
    EXPECT_EQ(cache.find(kTask, 1, 2), nullptr) << "there is not even a folder";
    const StageStart start = made(2);
    ASSERT_TRUE(cache.keep(kTask, 1, start));
    const auto found = cache.find(kTask, 1, 2);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->stage, 2);
    EXPECT_EQ(found->hash, start.hash);
    EXPECT_EQ(found->state, start.state);
    ASSERT_EQ(found->given.size(), start.given.size());
    EXPECT_EQ(std::memcmp(found->given.data(), start.given.data(),
                          start.given.size() * sizeof(sim::Input)),
              0);
    EXPECT_EQ(cache.find(kTask, 2, 2), nullptr) << "another case";
    EXPECT_EQ(cache.find(kTask, 1, 1), nullptr) << "another stage";
    EXPECT_EQ(cache.find(kTask + " ", 1, 2), nullptr) << "another text of the task or its scene";
    sim::RecordingHeader header;
    header.task_json = kTask;
    header.seed = 1;
    EXPECT_EQ(cache.find(header), nullptr) << "an attempt from the beginning";
    header.stage = 2;
    EXPECT_NE(cache.find(header), nullptr);
    struct stat of_folder {};
    ASSERT_EQ(::stat(folder.c_str(), &of_folder), 0);
    EXPECT_EQ(of_folder.st_mode & 0777, 0700U) << "nobody else reads or writes there";
}

TEST_F(StageCacheTest, WhatIsDamagedIsAsIfItWereNotThere) {
    const StageCache cache(folder);
    ASSERT_TRUE(cache.keep(kTask, 1, made(1)));
    const fs::path file = cache.file_of(kTask, 1, 1);
    const std::string whole = text_of(file);
    ASSERT_GT(whole.size(), 100'000U);
    for (size_t at = 0; at < whole.size(); at += at < 300 ? 1 : 4999) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 4);
        write_text(file, flipped);
        EXPECT_EQ(cache.find(kTask, 1, 1), nullptr) << at;
        write_text(file, whole.substr(0, at));
        EXPECT_EQ(cache.find(kTask, 1, 1), nullptr) << at;
    }
    write_text(file, whole + "x");
    EXPECT_EQ(cache.find(kTask, 1, 1), nullptr);
    // A file under the name of another key.
    write_text(file, whole);
    fs::copy_file(file, cache.file_of(kTask, 1, 2));
    EXPECT_EQ(cache.find(kTask, 1, 2), nullptr);
    EXPECT_NE(cache.find(kTask, 1, 1), nullptr);
    // Kept anew it is whole again.
    write_text(file, "nonsense");
    ASSERT_TRUE(cache.keep(kTask, 1, made(1)));
    EXPECT_NE(cache.find(kTask, 1, 1), nullptr);
}

TEST_F(StageCacheTest, TheOldestGoWhereTheFolderWouldGrowTooLarge) {
    const StageCache cache(folder, 350'000);
    for (int stage = 1; stage <= 5; ++stage) {
        ASSERT_TRUE(cache.keep(kTask, 1, made(stage)));
        const fs::path file = cache.file_of(kTask, 1, stage);
        fs::last_write_time(file,
                            fs::file_time_type::clock::now() - std::chrono::hours(10 - stage));
    }
    EXPECT_EQ(cache.find(kTask, 1, 1), nullptr);
    EXPECT_EQ(cache.find(kTask, 1, 2), nullptr);
    EXPECT_NE(cache.find(kTask, 1, 4), nullptr);
    EXPECT_NE(cache.find(kTask, 1, 5), nullptr);
    uint64_t sum = 0;
    for (const auto& entry : fs::directory_iterator(folder)) sum += entry.file_size();
    EXPECT_LE(sum, 350'000U);
    EXPECT_FALSE(cache.keep(kTask, 1, made(6, 400'000))) << "more than the folder may take";
    EXPECT_NE(cache.find(kTask, 1, 5), nullptr) << "nothing went for it";
}

TEST_F(StageCacheTest, WithoutAFolderNothingIsKeptAndNothingFails) {
    EXPECT_FALSE(StageCache(fs::path()).keep(kTask, 1, made(1)));
    EXPECT_EQ(StageCache(fs::path()).find(kTask, 1, 1), nullptr);
    fs::create_directories(folder.parent_path());
    write_text(folder, "a file in its place");
    EXPECT_FALSE(StageCache(folder).keep(kTask, 1, made(1)));
    EXPECT_EQ(StageCache(folder).find(kTask, 1, 1), nullptr);
}

/// A variable as it was, for the tests behind this one.
class Restored {
 public:
    explicit Restored(const char* name) : name_(name) {
        if (const char* value = std::getenv(name)) value_ = value;
    }
    ~Restored() {
        if (value_)
            ::setenv(name_, value_->c_str(), 1);
        else
            ::unsetenv(name_);
    }
    Restored(const Restored&) = delete;
    Restored& operator=(const Restored&) = delete;

 private:
    const char* name_;
    std::optional<std::string> value_;
};

TEST_F(StageCacheTest, LiesWhereTheDesktopKeepsCaches) {
    const Restored home("HOME"), cache("XDG_CACHE_HOME");
    ::setenv("XDG_CACHE_HOME", "/some/where", 1);
    EXPECT_EQ(StageCache::folder_of_this_user(), "/some/where/placode/stages");
    ::setenv("XDG_CACHE_HOME", "relative", 1);
    ::setenv("HOME", "/home/ada", 1);
    EXPECT_EQ(StageCache::folder_of_this_user(), "/home/ada/.cache/placode/stages");
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("HOME");
    EXPECT_EQ(StageCache::folder_of_this_user(), "");
}

}  // namespace THIS_TEST
}  // namespace placode::db
