// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A process that gets some threads and then no more: its stacks have no room. Also for root, whom
// no limit of processes binds.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <system_error>

namespace placode::test {

/// The sanitizers map terabytes for themselves, or want threads to be begun before a fork.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kThreadsCanRunOut = false;
#else
inline constexpr bool kThreadsCanRunOut = true;
#endif

/// Asked for far more threads than there is room for, `work` runs in a child process. "no thread"
/// where it throws what std::thread throws then; else how it ended.
template <class Work>
std::string with_few_threads(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        // Room for three stacks of the usual 8 MiB, and for those that are kept from before.
        const rlim_t most = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (28U << 20);
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_AS, &limit);
        ::alarm(60);
        int status = 1;
        try {
            work();
        } catch (const std::system_error&) {
            status = 0;
        } catch (...) {
            status = 2;
        }
        ::_exit(status);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
    return WEXITSTATUS(status) == 0   ? "no thread"
           : WEXITSTATUS(status) == 1 ? "nothing thrown"
                                      : "another exception";
}

}  // namespace placode::test
