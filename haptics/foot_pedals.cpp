// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/foot_pedals.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim/core/tool.h"

namespace placode::haptics {

namespace {

constexpr int64_t kRetryNs = 1'000'000'000;

}  // namespace

FootPedals::FootPedals(const Station& station)
    : path_(station.text("pedals.device")),
      cut_key_(static_cast<int>(station.number("pedals.cut_key"))),
      coag_key_(static_cast<int>(station.number("pedals.coag_key"))) {
    if (path_.empty()) return;
    if (!open())
        throw DeviceError("foot pedals: " + path_ + ": " + std::strerror(errno) +
                          ". Plug them in, or give the right to read: add the user to the group "
                          "input; or empty pedals.device in " +
                          Station::path_of_this_computer() + " to go on without.");
}

FootPedals::~FootPedals() { close(); }

bool FootPedals::open() noexcept {
    file_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0) return false;
    // Its keys are ours alone; a stand-in without this call works all the same.
    (void)ioctl(file_, EVIOCGRAB, 1);
    pressed_ = 0;
    return true;
}

void FootPedals::close() noexcept {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
    pressed_ = 0;
}

uint8_t FootPedals::poll(int64_t t_ns) noexcept {
    if (path_.empty()) return 0;
    if (file_ < 0) {
        if (t_ns < retry_ns_ || !open()) {
            if (t_ns >= retry_ns_) retry_ns_ = t_ns + kRetryNs;
            return 0;
        }
    }
    input_event events[16];
    for (;;) {
        const ssize_t got = ::read(file_, events, sizeof events);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
        if (got <= 0) {
            close();  // unplugged: let go
            retry_ns_ = t_ns + kRetryNs;
            return 0;
        }
        for (size_t i = 0; i < static_cast<size_t>(got) / sizeof(input_event); ++i) {
            if (events[i].type == EV_SYN && events[i].code == SYN_DROPPED) pressed_ = 0;
            if (events[i].type != EV_KEY) continue;
            uint8_t pedal = 0;
            if (events[i].code == cut_key_) pedal = sim::kPedalCut;
            if (events[i].code == coag_key_) pedal = sim::kPedalCoag;
            // 1 pressed, 2 repeated, 0 released.
            if (events[i].value != 0)
                pressed_ = static_cast<uint8_t>(pressed_ | pedal);
            else
                pressed_ = static_cast<uint8_t>(pressed_ & ~pedal);
        }
    }
    return pressed_;
}

}  // namespace placode::haptics
