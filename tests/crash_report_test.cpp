// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a crash leaves: run in processes of their own, which end by the signal as without it.
#include "ui/diagnostics/crash_report.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace placode::ui {
namespace THIS_TEST {
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitizerReports = true;
#else
constexpr bool kSanitizerReports = false;
#endif

class CrashReportTest : public testing::Test {
 protected:
    void SetUp() override {
        if (kSanitizerReports) GTEST_SKIP() << "the sanitizer has its own report";
        std::string name = (fs::temp_directory_path() / "placode-crash-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { fs::remove_all(folder); }

    /// Crashes in a process of its own; the signal that it ended by.
    [[nodiscard]] int crash(const std::function<void()>& how) const {
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit none{0, 0};
            ::setrlimit(RLIMIT_CORE, &none);
            ::close(STDERR_FILENO);
            report_crashes(folder, "placode-sim", "0.1.0 (abc)");
            how();
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    fs::path folder;
};

TEST_F(CrashReportTest, EverySignalEndsAsBeforeAndLeavesAReport) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        fs::remove_all(folder);
        EXPECT_EQ(crash([&] { ::raise(signal); }), signal);
        const std::vector<CrashReport> reports = crash_reports(folder);
        ASSERT_EQ(reports.size(), 1U) << signal;
        EXPECT_EQ(reports[0].program, "placode-sim");
        EXPECT_THAT(reports[0].text, HasSubstr("program: placode-sim\nversion: 0.1.0 (abc)\n"));
        EXPECT_THAT(reports[0].text, HasSubstr("signal: SIG"));
        EXPECT_THAT(reports[0].text, HasSubstr("calls, the last first:\n"));
        EXPECT_GT(std::count(reports[0].text.begin(), reports[0].text.end(), '\n'), 6);
        struct stat about {};
        ASSERT_EQ(::stat(reports[0].file.c_str(), &about), 0);
        EXPECT_EQ(about.st_mode & 0777, 0600U);
    }
}

TEST_F(CrashReportTest, ARecursionThatFillsTheStackIsReportedToo) {
    const int signal = crash([] {
        // Volatile: the optimiser may not make a loop of it.
        static void (*volatile again)(volatile char*) = nullptr;
        again = [](volatile char* before) {
            volatile char here[4096];
            here[0] = before != nullptr ? before[0] : 'x';
            again(here);
            here[1] = here[0];
        };
        again(nullptr);
    });
    EXPECT_EQ(signal, SIGSEGV);
    EXPECT_EQ(crash_reports(folder).size(), 1U);
}

TEST_F(CrashReportTest, AnExceptionIsNamedByItsTypeAndNotByWhatItSays) {
    void (*volatile fail)() = [] { throw std::runtime_error("Anna Kowalska"); };
    EXPECT_EQ(crash([&]() noexcept { fail(); }), SIGABRT);
    const std::vector<CrashReport> reports = crash_reports(folder);
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_THAT(reports[0].text, HasSubstr("runtime_error"));
    EXPECT_THAT(reports[0].text, Not(HasSubstr("Anna")));
}

TEST_F(CrashReportTest, WhatEndsWellLeavesNothing) {
    EXPECT_EQ(crash([] {}), 0);
    EXPECT_TRUE(crash_reports(folder).empty());
    EXPECT_TRUE(crash_reports(folder / "nowhere").empty());
}

TEST_F(CrashReportTest, TheNewestTenStayAndTheHomeFolderIsNotTold) {
    const char* home = std::getenv("HOME");
    const std::string before = home != nullptr ? home : "";
    ::setenv("HOME", "/home/anna.kowalska", 1);
    for (int i = 0; i < 14; ++i) {
        const fs::path file = folder / ("placode-" + std::to_string(100 + i) + ".crash");
        std::ofstream(file) << "calls:\n/home/anna.kowalska/placode/bin/placode(+0x1)[0x2]\n";
        const timespec times[2]{{1000000 + i, 0}, {1000000 + i, 0}};
        ::utimensat(AT_FDCWD, file.c_str(), times, 0);
    }
    std::ofstream(folder / "placode.log") << "no report";
    const std::vector<CrashReport> reports = crash_reports(folder);
    ::setenv("HOME", before.c_str(), 1);
    ASSERT_EQ(std::ssize(reports), kMostCrashReports);
    EXPECT_EQ(reports.front().file.filename(), "placode-113.crash");
    EXPECT_EQ(reports.back().file.filename(), "placode-104.crash");
    EXPECT_EQ(reports.front().text, "calls:\n~/placode/bin/placode(+0x1)[0x2]\n");
    EXPECT_FALSE(fs::exists(folder / "placode-103.crash"));
    EXPECT_TRUE(fs::exists(folder / "placode.log"));
}

}  // namespace THIS_TEST
}  // namespace placode::ui
