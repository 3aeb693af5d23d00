// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/pedal_watch.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "haptics/station.h"

namespace placode::haptics {

std::vector<std::string> pedal_devices(const std::string& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with("-event-kbd")) found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

PedalWatch::PedalWatch(std::string path) : path_(std::move(path)) {
    file_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0)
        throw DeviceError("foot pedals: " + path_ + ": " + std::strerror(errno) +
                          ". Plug them in, or give the right to read: add the user to the group "
                          "input and log in again");
    // Nobody types with their feet meanwhile; a stand-in without this call works all the same.
    (void)ioctl(file_, EVIOCGRAB, 1);
}

PedalWatch::~PedalWatch() {
    if (file_ >= 0) ::close(file_);
}

bool PedalWatch::poll() noexcept {
    input_event events[16];
    while (file_ >= 0) {
        const ssize_t got = ::read(file_, events, sizeof events);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return true;
        if (got <= 0) {
            ::close(file_);
            file_ = -1;
            break;
        }
        for (size_t i = 0; i < static_cast<size_t>(got) / sizeof(input_event); ++i) {
            if (events[i].type != EV_KEY) continue;
            if (events[i].value == 0) {
                if (events[i].code == last_key_) pressed_ = false;
            } else {
                last_key_ = events[i].code;
                pressed_ = true;
            }
        }
    }
    pressed_ = false;
    return false;
}

}  // namespace placode::haptics
