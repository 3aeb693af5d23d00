// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finding out which key a foot pedal sends, so that it can be written into the station file.

#include <string>
#include <vector>

namespace placode::haptics {

/// Event devices with keys, by the names that stay the same: /dev/input/by-id/*-event-kbd.
[[nodiscard]] std::vector<std::string> pedal_devices(
    const std::string& folder = "/dev/input/by-id");

/// One event device, watched for keys. Any thread, one at a time.
class PedalWatch {
 public:
    /// Throws DeviceError when it cannot be opened, naming the way out.
    explicit PedalWatch(std::string path);
    ~PedalWatch();
    PedalWatch(const PedalWatch&) = delete;
    PedalWatch& operator=(const PedalWatch&) = delete;

    /// Takes what has come; false: it was unplugged.
    bool poll() noexcept;
    [[nodiscard]] const std::string& path() const noexcept { return path_; }
    [[nodiscard]] int last_key() const noexcept { return last_key_; }  ///< 0: none yet.
    [[nodiscard]] bool pressed() const noexcept { return pressed_; }   ///< The last key is held.

 private:
    std::string path_;
    int file_ = -1, last_key_ = 0;
    bool pressed_ = false;
};

}  // namespace placode::haptics
