// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/runner.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <deque>
#include <fstream>
#include <map>
#include <thread>

#include "batches/batch_error.h"
#include "batches/shard.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;

fs::path log_path(const fs::path& folder, int shard) {
    char name[32];
    std::snprintf(name, sizeof name, "%06d.log", shard);
    return folder / "logs" / name;
}

std::string last_line(const fs::path& path) {
    std::ifstream in(path);
    std::string line, last;
    while (std::getline(in, line))
        if (!line.empty()) last = line;
    return last;
}

/// Everything is made ready before fork(): between it and exec() a child may do next to nothing.
pid_t start_worker(const RunOrder& order, int shard) {
    std::vector<std::string> words = order.command;
    words.push_back(std::to_string(shard));
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string log = log_path(order.folder, shard).string();
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child != 0) return child;
    // Whoever kills the runner, with whatever signal, kills its workers.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(1);
    // Ctrl+C of the terminal goes to the runner, which tells the workers.
    ::setpgid(0, 0);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (out >= 0) {
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
    }
    if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

std::string how_it_ended(int status, const fs::path& log) {
    if (WIFSIGNALED(status)) return "was ended by signal " + std::to_string(WTERMSIG(status));
    const std::string said = last_line(log);
    return said.empty() ? "ended with status " + std::to_string(WEXITSTATUS(status)) : said;
}

class Runner {
 public:
    Runner(const Manifest& manifest, const RunOrder& order) : manifest_(manifest), order_(order) {}
    ~Runner() { stop_workers(SIGKILL); }
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;

    RunOutcome run() {
        find_work();
        while (!waiting_.empty() || !running_.empty()) {
            if (!outcome_.stopped && order_.go_on && !order_.go_on()) {
                outcome_.stopped = true;
                waiting_.clear();
                stop_workers(SIGTERM);
            }
            while (!waiting_.empty() && running_.size() < static_cast<size_t>(order_.jobs))
                start_next();
            if (order_.progress)
                order_.progress(outcome_.done_before + outcome_.done, manifest_.shards());
            if (!collect()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return outcome_;
    }

 private:
    void find_work() {
        for (int shard = 0; shard < manifest_.shards(); ++shard) {
            const Shard there = read_shard(order_.folder, manifest_, shard);
            if (there.state == ShardState::kOfAnother)
                throw BatchError(BatchError::Kind::kBadInput,
                                 there.problem + "; choose another folder for one of the two");
            if (there.state == ShardState::kDone)
                ++outcome_.done_before;
            else
                waiting_.push_back(shard);
        }
    }

    void start_next() {
        const int shard = waiting_.front();
        waiting_.pop_front();
        const pid_t worker = start_worker(order_, shard);
        if (worker < 0)
            outcome_.failed.emplace_back(shard, "no process could be started for it");
        else
            running_[worker] = shard;
    }

    /// Whether a worker has ended.
    bool collect() {
        int status = 0;
        for (const auto& [worker, shard] : running_) {
            if (::waitpid(worker, &status, WNOHANG) != worker) continue;
            if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
                ++outcome_.done;
                std::error_code ignored;
                fs::remove(log_path(order_.folder, shard), ignored);
            } else if (!outcome_.stopped) {
                outcome_.failed.emplace_back(shard,
                                             how_it_ended(status, log_path(order_.folder, shard)));
            }
            running_.erase(worker);
            return true;
        }
        return false;
    }

    void stop_workers(int signal) {
        for (const auto& [worker, shard] : running_) ::kill(worker, signal);
    }

    const Manifest& manifest_;
    const RunOrder& order_;
    std::deque<int> waiting_;
    std::map<pid_t, int> running_;
    RunOutcome outcome_;
};

}  // namespace

RunOutcome run_batch(const Manifest& manifest, const RunOrder& order) {
    return Runner(manifest, order).run();
}

}  // namespace placode::batches
