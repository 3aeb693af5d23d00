// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode-sim while whoever started it does not read what it says: a shell that waits for a server.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

#include "db/recording_file.h"
#include "tests/programs_fixture.h"

using namespace placode;
using namespace placode::test;

namespace THIS_TEST {

test::World* const world = test::World::install();

// It stood in a write to the pipe, and with it picture, keys, clock and every way to end it.
TEST_F(Programs, AnAttemptGoesOnAndEndsWhileNobodyReadsItsStatus) {
    std::array<int, 2> ends{-1, -1};
    ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    ASSERT_GT(::fcntl(ends[1], F_SETPIPE_SZ, 4096), 0);
    const std::string command = "cd '" + folder + "' && HOME='" + folder +
                                "' exec '" PLACODE_BIN_DIR
                                "/placode-sim' --task diathermy_ring_small --headless --device "
                                "script:expert --status --record a.placode 2> err";
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    // Ten lines of half a kilobyte a second: full before the first of these seconds is over.
    const auto wait = [] { std::this_thread::sleep_for(std::chrono::milliseconds(100)); };
    for (int i = 0; i < 600 && !fs::exists(file("a.placode")); ++i) wait();
    for (int i = 0; i < 40; ++i) wait();
    ASSERT_EQ(::kill(child, SIGTERM), 0);
    int status = 0;
    pid_t ended = 0;
    for (int i = 0; i < 300 && ended == 0; ++i, wait()) ended = ::waitpid(child, &status, WNOHANG);
    if (ended == 0) {
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
    }
    ::close(ends[0]);
    ASSERT_EQ(ended, child) << "it hangs";
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << read_text(file("err"));
    const sim::Recording recording = db::read_recording_file(file("a.placode"));
    EXPECT_EQ(recording.end.reason, sim::EndReason::kInterrupted);
    EXPECT_GT(recording.end.duration_s, 1);
    EXPECT_FALSE(db::haptic_certificate(file("a.placode")).empty()) << "it lacks its end";
}

}  // namespace THIS_TEST
