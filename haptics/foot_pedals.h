// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Foot pedals that appear as a keyboard, read from their own event device so that they work
// whatever window has the focus, and so that nobody types with their feet.

#include <cstdint>
#include <string>

#include "haptics/station.h"

namespace placode::haptics {

/// Servo thread after construction; `poll` never blocks, allocates or throws.
class FootPedals {
 public:
    FootPedals() = default;
    /// Opens the device of the station, if it names one; throws DeviceError when it is not there.
    explicit FootPedals(const Station& station);
    ~FootPedals();
    FootPedals(const FootPedals&) = delete;
    FootPedals& operator=(const FootPedals&) = delete;

    /// What is pressed now: sim::kPedalCut | sim::kPedalCoag. Nothing after the device has gone;
    /// it is looked for again once a second.
    [[nodiscard]] uint8_t poll(int64_t t_ns) noexcept;
    [[nodiscard]] bool connected() const noexcept { return file_ >= 0; }

 private:
    bool open() noexcept;
    void close() noexcept;

    std::string path_;
    int cut_key_ = 0, coag_key_ = 0;
    int file_ = -1;
    uint8_t pressed_ = 0;
    int64_t retry_ns_ = 0;
};

}  // namespace placode::haptics
