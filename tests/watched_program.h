// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs a program and reads the command line of it, and of every program that it starts, in the
// moment when each begins and again when it ends: none is too quick to be seen. And looks for
// secrets in whatever a program leaves behind.

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace placode::test {

struct WatchedRun {
    int status = -1;
    std::string said;                        ///< What all of them wrote to standard out and error.
    std::vector<std::string> command_lines;  ///< /proc/PID/cmdline; words end in a zero byte.
};

inline std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

class WatchedProgram {
 public:
    std::vector<std::string> command;      ///< The program's path and its arguments.
    std::vector<std::string> environment;  ///< "NAME=value", beside what the test has.
    std::string input;                     ///< On its standard input.

    /// @param folder for the files that take its input and output.
    [[nodiscard]] WatchedRun run(const std::string& folder) {
        const std::string in = folder + "/.in", out = folder + "/.out";
        std::ofstream(in, std::ios::binary | std::ios::trunc) << input;
        const pid_t first = ::fork();
        if (first == 0) become(in, out);
        WatchedRun result;
        std::vector<pid_t> running{first};
        bool fresh = true;
        while (!running.empty()) {
            int status = 0;
            const pid_t pid = ::waitpid(-1, &status, __WALL);
            if (pid < 0) break;
            if (WIFEXITED(status) || WIFSIGNALED(status)) {
                if (pid == first) result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
                std::erase(running, pid);
                continue;
            }
            if (std::find(running.begin(), running.end(), pid) == running.end())
                running.push_back(pid);
            if (fresh) {
                ::ptrace(PTRACE_SETOPTIONS, pid, nullptr,
                         PTRACE_O_TRACEEXEC | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK |
                             PTRACE_O_TRACEEXIT | PTRACE_O_EXITKILL);
                fresh = false;
            }
            const int event = status >> 16;
            const int signal = WSTOPSIG(status);
            if (event == PTRACE_EVENT_EXEC || event == PTRACE_EVENT_EXIT || signal == SIGTRAP)
                result.command_lines.push_back(
                    bytes_of("/proc/" + std::to_string(pid) + "/cmdline"));
            const bool own = event != 0 || signal == SIGTRAP || signal == SIGSTOP;
            ::ptrace(PTRACE_CONT, pid, nullptr, own ? 0 : signal);
        }
        result.said = bytes_of(out);
        std::filesystem::remove(in);
        std::filesystem::remove(out);
        return result;
    }

 private:
    [[noreturn]] void become(const std::string& in, const std::string& out) {
        for (const std::string& each : environment) {
            const size_t sign = each.find('=');
            ::setenv(each.substr(0, sign).c_str(), each.substr(sign + 1).c_str(), 1);
        }
        const int input_file = ::open(in.c_str(), O_RDONLY);
        const int output_file = ::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
        ::dup2(input_file, 0);
        ::dup2(output_file, 1);
        ::dup2(output_file, 2);
        std::vector<char*> words;
        for (std::string& word : command) words.push_back(word.data());
        words.push_back(nullptr);
        ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        ::execv(words[0], words.data());
        ::_exit(127);
    }
};

/// A secret as it may stand somewhere: as it is, in two bytes a letter, and for digits of a key in
/// capitals and as the bytes that they mean.
inline std::vector<std::string> forms_of(const std::string& secret) {
    std::vector<std::string> forms{secret};
    std::string wide, capitals, raw;
    for (const char c : secret) {
        wide += c;
        wide += '\0';
        capitals += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    forms.push_back(wide);
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if (secret.size() % 2 != 0 || !std::all_of(secret.begin(), secret.end(), is_digit))
        return forms;
    forms.push_back(capitals);
    for (size_t i = 0; i < secret.size(); i += 2)
        raw += static_cast<char>(std::stoi(secret.substr(i, 2), nullptr, 16));
    forms.push_back(raw);
    return forms;
}

[[nodiscard]] inline bool holds(const std::string& bytes, const std::string& secret) {
    const auto forms = forms_of(secret);
    return std::any_of(forms.begin(), forms.end(), [&](const std::string& form) {
        return bytes.find(form) != std::string::npos;
    });
}

/// Files below the folder that hold the secret in one of its forms, or in their name.
[[nodiscard]] inline std::vector<std::string> files_with(const std::filesystem::path& folder,
                                                         const std::string& secret) {
    std::vector<std::string> found;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder))
        if (holds(each.path().filename().string(), secret) ||
            (each.is_regular_file() && holds(bytes_of(each.path().string()), secret)))
            found.push_back(each.path().filename().string());
    return found;
}

}  // namespace placode::test
