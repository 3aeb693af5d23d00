// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/status_line.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

namespace placode::ui {
namespace THIS_TEST {

using std::chrono::steady_clock;

double seconds_since(steady_clock::time_point begin) {
    return std::chrono::duration<double>(steady_clock::now() - begin).count();
}

/// A short pipe, and the lines of an attempt that go into it.
class Pipe {
 public:
    explicit Pipe(int bytes) {
        EXPECT_EQ(::pipe(ends_.data()), 0);
        EXPECT_GT(::fcntl(ends_[1], F_SETPIPE_SZ, bytes), 0);
        line_ = std::make_unique<StatusLine>(true, ends_[1]);
    }
    ~Pipe() {
        for (const int end : ends_) ::close(end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    StatusLine& line() { return *line_; }
    [[nodiscard]] bool blocks() const { return (::fcntl(ends_[1], F_GETFL) & O_NONBLOCK) == 0; }
    /// What lies in it; waits until there is something.
    std::string taken() {
        std::string text(1 << 20, '\0');
        const ssize_t got = ::read(ends_[0], text.data(), text.size());
        text.resize(static_cast<size_t>(std::max<ssize_t>(got, 0)));
        return text;
    }

 private:
    std::array<int, 2> ends_{-1, -1};
    std::unique_ptr<StatusLine> line_;
};

curriculum::AttemptStatus at(double time_s) {
    curriculum::AttemptStatus status;
    status.time_s = time_s;
    return status;
}

TEST(StatusLine, AReaderThatHangsHoldsUpNobodyAndGetsWholeLines) {
    Pipe pipe(16384);
    const auto begin = steady_clock::now();
    for (int i = 0; i < 200; ++i) pipe.line().print(at(i), true);
    EXPECT_LT(seconds_since(begin), 2);
    EXPECT_TRUE(pipe.blocks()) << "what others share is left as it was";
    const auto end_begins = steady_clock::now();
    pipe.line().end(at(200), "finished", "a.placode");
    EXPECT_GT(seconds_since(end_begins), 0.8 * StatusLine::kPatience.count() * 1e-3);
    EXPECT_LT(seconds_since(end_begins), 3 * StatusLine::kPatience.count() * 1e-3);
    std::istringstream lines(pipe.taken());
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        EXPECT_EQ(nlohmann::json::parse(line).at("t_s"), count) << "one after the other";
    EXPECT_GT(count, 3);
    EXPECT_LT(count, 200);
    // Whoever wakes up gets what is now.
    pipe.line().print(at(300), true);
    EXPECT_EQ(nlohmann::json::parse(pipe.taken()).at("t_s"), 300);
}

TEST(StatusLine, TheLastLineWaitsForAReaderThatIsLate) {
    Pipe pipe(16384);
    for (int i = 0; i < 200; ++i) pipe.line().print(at(i), true);
    std::string text;
    std::thread late([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        while (text.find("\"end\"") == std::string::npos) text += pipe.taken();
    });
    pipe.line().end(at(200), "finished", "a.placode");
    late.join();
    const size_t last = text.rfind('\n', text.size() - 2) + 1;
    EXPECT_EQ(nlohmann::json::parse(text.substr(last)).at("end"), "finished");
}

// A message of the system may be long: the next line does not begin in the middle of it.
TEST(StatusLine, ALineThatFillsThePipeIsReadToItsEnd) {
    Pipe pipe(4096);
    curriculum::AttemptStatus status = at(1);
    status.warning = std::string(5000, 'w');
    pipe.line().print(status, true);
    std::string text = pipe.taken();
    EXPECT_EQ(text.find('\n'), std::string::npos);
    pipe.line().print(at(2), true);
    text += pipe.taken();
    std::istringstream lines(text);
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_EQ(nlohmann::json::parse(first).at("warning"), status.warning);
    EXPECT_EQ(nlohmann::json::parse(second).at("t_s"), 2);
}

}  // namespace THIS_TEST
}  // namespace placode::ui
