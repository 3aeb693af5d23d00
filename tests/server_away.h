// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Takes a test's PostgreSQL away and brings it back, on the same port with the same data.

#include <fcntl.h>
#include <sys/stat.h>

#include <sstream>

#include "tests/store_fixture.h"

namespace placode::test {

/// The server outlives it. Who reaps the first process is the server's own object.
class ServerAway {
 public:
    explicit ServerAway(const PostgresqlServer& server) : server_(server) {
        RawConnection owner = server.connect("postgres");
        data_ = owner.value("SHOW data_directory");
    }
    ~ServerAway() {
        if (again_ <= 0) return;
        ::kill(again_, SIGQUIT);
        ::waitpid(again_, nullptr, 0);
    }
    ServerAway(const ServerAway&) = delete;
    ServerAway& operator=(const ServerAway&) = delete;

    /// As by a power cut of the server: connections break in the middle. False: it stays.
    [[nodiscard]] bool stop() {
        pid_t running = 0;
        std::ifstream(data_ + "/postmaster.pid") >> running;
        if (running <= 0) return false;
        command_ = command_of(running);
        ::kill(running, SIGQUIT);
        const bool gone = waits_for([&] { return !fs::exists(data_ + "/postmaster.pid"); });
        if (again_ > 0) ::waitpid(again_, nullptr, 0);
        again_ = -1;
        return gone;
    }
    /// False: it does not answer.
    [[nodiscard]] bool start() {
        std::vector<char*> arguments;
        for (std::string& word : command_) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        struct stat owner {};
        if (::stat(data_.c_str(), &owner) != 0) return false;
        again_ = ::fork();
        if (again_ == 0) {
            const int out = ::open("/dev/null", O_RDWR);
            for (const int each : {0, 1, 2}) ::dup2(out, each);
            if (::geteuid() == 0 && (::setgid(owner.st_gid) != 0 || ::setuid(owner.st_uid) != 0))
                ::_exit(126);
            if (::chdir("/") != 0) ::_exit(126);
            ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
            ::execv(arguments[0], arguments.data());
            ::_exit(127);
        }
        return waits_for([&] { return server_.connect("postgres").is_open(); });
    }

 private:
    static std::vector<std::string> command_of(pid_t process) {
        std::istringstream all(read_text("/proc/" + std::to_string(process) + "/cmdline"));
        std::vector<std::string> words;
        for (std::string word; std::getline(all, word, '\0');) words.push_back(word);
        return words;
    }
    template <class Condition>
    static bool waits_for(Condition&& condition) {
        for (int i = 0; i < 600; ++i) {
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        return false;
    }

    const PostgresqlServer& server_;
    std::string data_;
    std::vector<std::string> command_;
    pid_t again_ = -1;
};

}  // namespace placode::test
