// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs a program and asks it to end as Ctrl+C does, as soon as it listens.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/programs_fixture.h"

namespace placode::test {

/// Whether the process catches the signal by now; before that the signal would kill it.
inline bool catches(pid_t process, int signal) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    std::string line;
    while (std::getline(status, line))
        if (line.starts_with("SigCgt:"))
            return ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1U) != 0;
    return false;
}

/// `placodectl WORDS` in the folder, sent the signal in the moment when it begins to catch it. What
/// it says on standard error; its status is -1 when the signal killed it.
inline Outcome stopped(const std::string& folder, std::vector<std::string> words, int signal) {
    words.insert(words.begin(), PLACODE_BIN_DIR "/placodectl");
    const std::string err = folder + "/err";
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("HOME", folder.c_str(), 1);
        const int nothing = ::open("/dev/null", O_RDWR);
        const int said = ::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
        ::dup2(nothing, 0);
        ::dup2(nothing, 1);
        ::dup2(said, 2);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        if (::chdir(folder.c_str()) == 0) ::execv(arguments[0], arguments.data());
        ::_exit(126);
    }
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    bool sent = false;
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (!sent && catches(child, signal)) sent = ::kill(child, signal) == 0;
        if (std::chrono::steady_clock::now() > limit) ::kill(child, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(sent) << "it ended before it could be asked to";
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", read_text(err)};
}

}  // namespace placode::test
