// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/serial_line.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace placode::haptics {

namespace {

constexpr int64_t kRetryNs = 1'000'000'000;

}  // namespace

SerialLine::SerialLine(std::string path, double settle_s)
    : path_(std::move(path)), settle_ns_(static_cast<int64_t>(settle_s * 1e9)) {}

SerialLine::~SerialLine() { close(); }

// 9600 8N1, raw, DTR on.
void SerialLine::open(int64_t t_ns) noexcept {
    retry_ns_ = t_ns + kRetryNs;
    file_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    problem_ = file_ < 0 ? errno : 0;
    if (file_ < 0) return;
    termios settings{};
    if (tcgetattr(file_, &settings) != 0) {
        problem_ = errno;
        close();
        return;
    }
    cfmakeraw(&settings);
    cfsetispeed(&settings, B9600);
    cfsetospeed(&settings, B9600);
    settings.c_cflag |= CLOCAL | CREAD;
    tcsetattr(file_, TCSANOW, &settings);
    const int ready = TIOCM_DTR;
    (void)ioctl(file_, TIOCMBIS, &ready);  // a terminal without modem lines does not mind
    tcflush(file_, TCIOFLUSH);
    ready_ns_ = t_ns + settle_ns_;
}

void SerialLine::close() noexcept {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
    size_ = taken_ = 0;
}

bool SerialLine::step(int64_t t_ns) noexcept {
    if (file_ < 0) {
        if (t_ns >= retry_ns_) open(t_ns);
        if (file_ < 0) return false;
    }
    // Lines that were handed out make room.
    std::memmove(in_.data(), in_.data() + taken_, size_ - taken_);
    size_ -= taken_;
    taken_ = 0;
    if (size_ == in_.size()) size_ = 0;  // no end of line in 4 KiB: rubbish
    for (;;) {
        const ssize_t got = ::read(file_, in_.data() + size_, in_.size() - size_);
        if (got < 0 && errno == EINTR) continue;
        if (got > 0) {
            size_ += static_cast<size_t>(got);
            break;
        }
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
        if (size_ == in_.size()) break;
        problem_ = got < 0 ? errno : EIO;  // pulled out
        close();
        retry_ns_ = t_ns + kRetryNs;
        return false;
    }
    return t_ns >= ready_ns_;
}

bool SerialLine::next_line(std::string_view& line) noexcept {
    const std::string_view rest(in_.data() + taken_, size_ - taken_);
    const size_t end = rest.find('\n');
    if (end == std::string_view::npos) return false;
    line = rest.substr(0, end);
    taken_ += end + 1;
    return true;
}

bool SerialLine::send(std::string_view text) noexcept {
    if (file_ < 0) return false;
    const ssize_t sent = ::write(file_, text.data(), text.size());
    return sent == static_cast<ssize_t>(text.size());
}

}  // namespace placode::haptics
