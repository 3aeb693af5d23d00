// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs a program and kills it with SIGKILL: after a time, or when it has changed a folder so and so
// often, which hits the moments at which it writes.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace placode::test {

/// When a program is killed; by itself never.
struct Moment {
    double after_s = -1;  ///< After its start [s]; < 0 = not by time.
    int at_change = 0;    ///< At this change of the watched folder; 0 = not by changes.
    double then_s = 0;    ///< So much later [s].
};

/// How a run ended.
struct Shot {
    bool killed = false;
    int status = -1;  ///< -1 when a signal ended it.
    double ran_s = 0;
    int changes = 0;  ///< Of the watched folder while it ran.
};

/// A program that runs from its construction on. Its output goes to two files.
class RunningProgram {
 public:
    struct Start {
        std::vector<std::string> words;                  ///< Program and arguments.
        std::string folder;                              ///< Working folder.
        std::string out, err;                            ///< Files; not in the watched folder.
        std::string watched;                             ///< Folder whose changes count.
        std::map<std::string, std::string> environment;  ///< Beside that of the test.
    };

    explicit RunningProgram(const Start& start)
        : watch_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        ::inotify_add_watch(watch_, start.watched.c_str(),
                            IN_CREATE | IN_MODIFY | IN_MOVE | IN_DELETE);
        // All that needs memory comes before fork().
        std::vector<std::string> variables;
        for (const auto& [name, value] : start.environment) variables.push_back(name + "=" + value);
        for (char** each = environ; *each != nullptr; ++each) {
            const std::string name(*each, std::strcspn(*each, "="));
            if (!start.environment.contains(name)) variables.emplace_back(*each);
        }
        std::vector<char*> arguments = pointers(start.words), environment = pointers(variables);
        process_ = ::fork();
        if (process_ != 0) {
            handle_ = static_cast<int>(::syscall(SYS_pidfd_open, process_, 0));
            return;
        }
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // It does not outlive the test.
        const auto to = [](int stream, const std::string& path, int flags) {
            const int file = ::open(path.c_str(), flags, 0600);
            return file >= 0 && ::dup2(file, stream) >= 0;
        };
        constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
        if (!to(0, "/dev/null", O_RDONLY) || !to(1, start.out, kNew) || !to(2, start.err, kNew) ||
            ::chdir(start.folder.c_str()) != 0)
            ::_exit(126);
        ::execve(arguments[0], arguments.data(), environment.data());
        ::_exit(127);
    }
    RunningProgram(RunningProgram&& other) noexcept
        : watch_(std::exchange(other.watch_, -1)),
          process_(std::exchange(other.process_, -1)),
          handle_(std::exchange(other.handle_, -1)),
          begin_(other.begin_) {}
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;
    RunningProgram& operator=(RunningProgram&&) = delete;
    ~RunningProgram() {
        if (process_ > 0) (void)until({.after_s = 0});
        if (watch_ >= 0) ::close(watch_);
        if (handle_ >= 0) ::close(handle_);
    }

    /// Waits for its end, or kills it at `moment`. One that takes minutes hangs and fails the test.
    Shot until(Moment moment) {
        Shot shot;
        const double limit_s = moment.after_s >= 0 ? moment.after_s : kHangs_s;
        double end_s = limit_s;
        while (!ended(end_s - now_s())) {
            shot.changes += changes();
            if (moment.at_change > 0 && shot.changes >= moment.at_change) {
                moment.at_change = 0;
                end_s = std::min(limit_s, now_s() + moment.then_s);
            }
            if (now_s() < end_s) continue;
            EXPECT_LT(now_s(), kHangs_s) << "it hangs";
            ::kill(process_, SIGKILL);
            end_s = kHangs_s + limit_s;
        }
        shot.changes += changes();
        shot.ran_s = now_s();
        int status = 0;
        ::waitpid(std::exchange(process_, -1), &status, 0);
        shot.killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
        shot.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return shot;
    }

 private:
    static constexpr double kHangs_s = 120;

    static std::vector<char*> pointers(std::vector<std::string> const& words) {
        std::vector<char*> all;
        for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
        all.push_back(nullptr);
        return all;
    }
    [[nodiscard]] double now_s() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    /// Waits for the end, a change or so many seconds; true: it has ended.
    [[nodiscard]] bool ended(double at_most_s) const {
        std::array<pollfd, 2> both{pollfd{handle_, POLLIN, 0}, pollfd{watch_, POLLIN, 0}};
        const auto ns = static_cast<int64_t>(1e9 * std::max(at_most_s, 0.0));
        const timespec wait{ns / 1'000'000'000, ns % 1'000'000'000};
        ::ppoll(both.data(), both.size(), &wait, nullptr);
        return (both[0].revents & POLLIN) != 0;
    }
    [[nodiscard]] int changes() const {
        alignas(inotify_event) std::array<char, 4096> events;
        int count = 0;
        for (ssize_t got = 0; (got = ::read(watch_, events.data(), events.size())) > 0;)
            for (ssize_t at = 0; at < got; ++count)
                at += static_cast<ssize_t>(
                    sizeof(inotify_event) +
                    reinterpret_cast<const inotify_event*>(events.data() + at)->len);
        return count;
    }

    int watch_ = -1;
    pid_t process_ = -1;
    int handle_ = -1;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace placode::test
