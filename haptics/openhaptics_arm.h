// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One arm of the Touch family: opening it, what the library says about it, and one look at its
// hand.

#include <string>

#include "haptics/arm_hands.h"
#include "haptics/openhaptics_library.h"

namespace placode::haptics::hd {

inline constexpr int kPoll = 100;  ///< Ticks between looks at calibration and motors.

/// An arm as the driver knows it.
struct Arm {
    std::string name;
    bool right = true;
    DeviceHandle handle = kNoHandle;
    DeviceInfo info;
    // servo thread
    ArmSample sample;
    ArmForce force;
    bool calibrated = false, forces_on = false, fault = false, lost = false;
    int still_ticks = 0;  // joints at zero: not calibrated, whatever the library says
};

/// Empties the library's error stack.
void drain(const Library& hd) noexcept;

/// Opens the arm `arm.name` and describes it in `arm.info`; without a name it tries those that
/// different versions of the driver accept. Throws DeviceError with the library's own words.
void open_arm(const Library& hd, Arm& arm);

/// Reads handle, joints and buttons into `arm.sample`, with `slow` also calibration and motors, and
/// enables the forces once the arm is calibrated. Servo thread; the frame of the arm is open and it
/// is current.
void read_arm(const Library& hd, Arm& arm, bool slow) noexcept;

}  // namespace placode::haptics::hd
