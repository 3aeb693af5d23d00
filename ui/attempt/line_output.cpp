// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/attempt/line_output.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>

namespace placode::ui {

LineOutput::LineOutput(int stream) {
    struct stat kind {};
    if (::fstat(stream, &kind) != 0 || !S_ISFIFO(kind.st_mode)) return;
    // Opened anew: O_NONBLOCK of a descriptor that was inherited holds for every program that
    // shares it, and beyond the end of this one.
    const std::string path = "/proc/self/fd/" + std::to_string(stream);
    pipe_ = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    // Where that is not allowed: `send` asks for room before it writes.
    if (pipe_ < 0) pipe_ = ::fcntl(stream, F_DUPFD_CLOEXEC, 0);
}

LineOutput::~LineOutput() {
    if (pipe_ >= 0) ::close(pipe_);
}

/// As much as the pipe takes. Up to PIPE_BUF bytes go as a whole or not at all; of a longer line
/// the rest comes before the next one.
void LineOutput::send(const std::string& line, std::chrono::milliseconds patience) {
    if (pipe_ < 0) {
        std::fputs(line.c_str(), stdout);
        std::fflush(stdout);
        return;
    }
    using std::chrono::steady_clock;
    rest_ += line;
    const auto until = steady_clock::now() + patience;
    while (!rest_.empty()) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(until - steady_clock::now());
        const int wait_ms = std::max(0, static_cast<int>(left.count()));
        pollfd room{pipe_, POLLOUT, 0};
        const int ready = ::poll(&room, 1, wait_ms);
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) break;
        const ssize_t sent = ::write(pipe_, rest_.data(), std::min<size_t>(rest_.size(), PIPE_BUF));
        if (sent > 0) {
            rest_.erase(0, static_cast<size_t>(sent));
        } else if (errno != EAGAIN && errno != EINTR) {
            rest_.clear();  // nobody reads any more
        } else if (wait_ms == 0) {
            break;
        }
    }
    // Nothing of it has gone out: it is dropped.
    if (rest_.size() >= line.size()) rest_.resize(rest_.size() - line.size());
}

}  // namespace placode::ui
