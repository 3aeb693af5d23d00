// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stand-in for a device of the Haptic Avatar on a pseudo-terminal: a thread that answers lines of
// commands by their integers, in order, and remembers the forces it was sent.

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace placode::test {

class AvatarPort {
 public:
    std::mutex mutex;
    /// Answers by command number; what is not here answers nothing.
    std::map<int, std::vector<int>> answers;
    std::map<int, size_t> arguments;  ///< How many numbers follow a command.
    std::array<int, 4> force{};       ///< As last sent: rotation, pitch, depth, yaw.
    bool silent = false, garbage = false;
    std::atomic<int> lines{0}, enabled{-1};
    std::atomic<int> every_ms{0}, once_ms{0};  ///< Before an answer; before the next one only.
    std::atomic<bool> swallow{false};          ///< The next answer.

    explicit AvatarPort(bool box = false) {
        if (box) {
            answers = {{2, {0, 0, 0, 0, 0, 0}}, {4, {0, 0}}};
        } else {
            answers = {{2, {0, 0, 0, 0}}, {5, {0}}, {28, {1}}, {38, {1, 1, 1}}};
            arguments = {{6, 4}, {43, 1}};
        }
        master_ = posix_openpt(O_RDWR | O_NOCTTY);
        (void)!grantpt(master_);
        (void)!unlockpt(master_);
        path_ = ptsname(master_);
        // Kept open so that a client that comes and goes does not hang the line up.
        slave_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY);
        thread_ = std::thread([this] { run(); });
    }
    ~AvatarPort() { pull_out(); }
    void pull_out() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
        if (slave_ >= 0) ::close(slave_);
        if (master_ >= 0) ::close(master_);
        slave_ = master_ = -1;
    }
    [[nodiscard]] const std::string& path() const { return path_; }
    template <class F>
    void change(F&& f) {
        const std::lock_guard lock(mutex);
        f(*this);
    }
    [[nodiscard]] std::array<int, 4> forces() {
        const std::lock_guard lock(mutex);
        return force;
    }

 private:
    void take(const std::string& line) {
        const std::lock_guard lock(mutex);
        std::istringstream words(line);
        std::string out;
        for (int command = 0; words >> command;) {
            std::vector<int> values;
            for (size_t i = 0; i < (arguments.count(command) ? arguments[command] : 0); ++i) {
                int value = 0;
                words >> value;
                values.push_back(value);
            }
            if (command == 6 && values.size() == 4) std::copy_n(values.begin(), 4, force.begin());
            if (command == 43) enabled = values[0];
            if (answers.count(command))
                for (const int value : answers[command]) out += std::to_string(value) + " ";
        }
        ++lines;
        if (silent || swallow.exchange(false)) return;
        if (garbage) out = "? " + out;
        out += '\n';
        (void)!::write(master_, out.data(), out.size());
    }

    void run() {
        std::string seen;
        while (!stop_) {
            pollfd waiting{master_, POLLIN, 0};
            if (::poll(&waiting, 1, 5) <= 0) continue;
            char buffer[512];
            const ssize_t got = ::read(master_, buffer, sizeof buffer);
            if (got <= 0) continue;
            seen.append(buffer, static_cast<size_t>(got));
            for (size_t end; (end = seen.find('\n')) != std::string::npos; seen.erase(0, end + 1)) {
                std::this_thread::sleep_for(
                    std::chrono::milliseconds(every_ms + once_ms.exchange(0)));
                take(seen.substr(0, end));
            }
        }
    }

    int master_ = -1, slave_ = -1;
    std::string path_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

}  // namespace placode::test
