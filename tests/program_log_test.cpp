// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The log of the programs: what a line may hold, that it stays small, several writers.
#include "ui/diagnostics/program_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace placode::ui {
namespace THIS_TEST {
namespace fs = std::filesystem;
using testing::ContainsRegex;

class ProgramLogTest : public testing::Test {
 protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "placode-log-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        root = name;
        folder = root / "log";
    }
    void TearDown() override { fs::remove_all(root); }
    [[nodiscard]] std::vector<std::string> lines() const {
        std::vector<std::string> all;
        std::istringstream text(read_log(folder));
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    }
    fs::path root, folder;
};

TEST_F(ProgramLogTest, ALineSaysWhenWhoAndWhat) {
    EXPECT_EQ(read_log(folder), "");
    const ProgramLog log(folder, "placode-sim");
    log.note("attempt_began",
             {LogField::id("task", "suture_slit"), {"threads", 2}, {"at", "exam"}});
    ASSERT_EQ(lines().size(), 1U);
    EXPECT_THAT(lines()[0], ContainsRegex("^20[0-9-]+T[0-9:]+Z placode-sim [0-9]+ attempt_began "
                                          "task=suture_slit threads=2 at=exam$"));
}

TEST_F(ProgramLogTest, WhatIsNoIdLosesWhatANameNeeds) {
    EXPECT_EQ(LogField::id("task", "Anna Kowalska").text(), "task=nnaowalska");
    EXPECT_EQ(LogField::id("task", "a\nb=\x1b[31m/ \"").text(), "task=ab31m");
    EXPECT_EQ(LogField::id("task", std::string(1000, 'x')).text().size(), 5 + 64U);
}

TEST_F(ProgramLogTest, OnlyItsOwnerReadsIt) {
    const ProgramLog log(folder, "placode");
    log.note("started");
    struct stat about {};
    ASSERT_EQ(::stat(folder.c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0700U);
    ASSERT_EQ(::stat(log_file(folder).c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0600U);
}

TEST_F(ProgramLogTest, ItStaysSmallAndTheNewestStays) {
    const ProgramLog log(folder, "placode");
    const std::string id(60, 'x');
    for (int i = 0; i < 20000; ++i) log.note("tried", {LogField::id("a", id), {"number", i}});
    int64_t bytes = 0, files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_LE(entry.file_size(), ProgramLog::kMostBytes) << entry.path();
        bytes += static_cast<int64_t>(entry.file_size());
        ++files;
    }
    EXPECT_EQ(files, 1 + ProgramLog::kOlder);
    const std::vector<std::string> all = lines();
    for (size_t i = 0; i < all.size(); ++i) {
        const size_t number = 20000 - all.size() + i;
        ASSERT_THAT(all[i], testing::EndsWith("number=" + std::to_string(number))) << i;
    }
    EXPECT_GT(bytes, 3 * ProgramLog::kMostBytes);
}

TEST_F(ProgramLogTest, ProcessesAndThreadsLoseNoLine) {
    constexpr int kProcesses = 4, kThreads = 3, kLines = 200;
    std::vector<pid_t> children;
    for (int p = 0; p < kProcesses; ++p) {
        const pid_t child = ::fork();
        if (child == 0) {
            const ProgramLog log(folder, "placode");
            std::vector<std::thread> threads;
            for (int t = 0; t < kThreads; ++t)
                threads.emplace_back([&log, p, t] {
                    for (int i = 0; i < kLines; ++i)
                        log.note("line", {{"p", p}, {"t", t}, {"i", i}});
                });
            for (std::thread& each : threads) each.join();
            ::_exit(0);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) ::waitpid(child, nullptr, 0);
    // 2,400 lines of some 60 bytes: they fit into one file.
    EXPECT_EQ(lines().size(), static_cast<size_t>(kProcesses * kThreads * kLines));
    for (const std::string& line : lines())
        ASSERT_THAT(line, ContainsRegex("Z placode [0-9]+ line p=[0-9] t=[0-9] i=[0-9]+$"));
}

TEST_F(ProgramLogTest, APlaceThatCannotBeWrittenStopsNothing) {
    std::ofstream(root / "file") << "no folder";
    const ProgramLog log(root / "file" / "log", "placode");
    log.note("started");
    EXPECT_EQ(read_log(root / "file" / "log"), "");
    // Nor does it follow a link that somebody laid there.
    fs::create_directories(folder);
    fs::create_symlink(root / "victim", log_file(folder));
    ProgramLog(folder, "placode").note("started");
    EXPECT_FALSE(fs::exists(root / "victim"));
}

TEST_F(ProgramLogTest, LiesInTheUsersDataAndWithoutAHomeNowhere) {
    const auto value = [](const char* name) {
        const char* set = std::getenv(name);
        return std::string(set != nullptr ? set : "");
    };
    const std::string log = value("PLACODE_LOG"), data = value("XDG_DATA_HOME"),
                      home = value("HOME");
    ::setenv("PLACODE_LOG", "/some/log", 1);
    EXPECT_EQ(diagnostics_folder(), "/some/log");
    ::unsetenv("PLACODE_LOG");
    ::setenv("XDG_DATA_HOME", "/some/where", 1);
    EXPECT_EQ(diagnostics_folder(), "/some/where/placode/log");
    ::setenv("XDG_DATA_HOME", "relative", 1);
    ::setenv("HOME", "/home/ada", 1);
    EXPECT_EQ(diagnostics_folder(), "/home/ada/.local/share/placode/log");
    ::unsetenv("HOME");
    EXPECT_EQ(diagnostics_folder(), "");
    const fs::path started = fs::current_path();
    fs::current_path(root);
    ProgramLog(diagnostics_folder(), "placode").note("started");
    EXPECT_EQ(read_log(diagnostics_folder()), "");
    EXPECT_TRUE(fs::is_empty(root)) << "not where the program was started";
    fs::current_path(started);
    for (const auto& [name, before] :
         {std::pair("PLACODE_LOG", log), std::pair("XDG_DATA_HOME", data), std::pair("HOME", home)})
        before.empty() ? ::unsetenv(name) : ::setenv(name, before.c_str(), 1);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
