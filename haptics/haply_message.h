// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the Inverse service says: arms and grips in its JSON, with the spellings of its versions.
// Unknown keys are passed over; a part that is missing is a doubt, not a zero. Servo thread:
// nothing allocates or throws.

#include <array>
#include <cstdint>
#include <string_view>

#include "haptics/device.h"
#include "haptics/json_scan.h"

namespace placode::haptics {

/// Name of an arm or a grip, cut after 31 characters.
class HaplyId {
 public:
    void set(std::string_view name) noexcept;
    [[nodiscard]] std::string_view view() const noexcept { return text_.data(); }

 private:
    std::array<char, 32> text_{};
};

/// An arm or a grip as the service describes it.
struct HaplyFound {
    HaplyId id;
    Vec3 position = Vec3::Zero();  ///< Axes of the device [m].
    Quat orientation = Quat::Identity();
    uint32_t buttons = 0;
    bool left = false, handed = false, calibrated = false, ready = false;
    int64_t seen_ns = 0;
};

/// All that was ever heard of, in the order of the service.
struct HaplyParts {
    static constexpr size_t kMost = 4;
    std::array<HaplyFound, kMost> arms, grips;
    size_t arm_count = 0, grip_count = 0;

    /// Takes over what a message says at `t_ns`.
    void read(std::string_view message, int64_t t_ns) noexcept;
};

}  // namespace placode::haptics
