// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device by itself, before anybody trains with it: live signals, a floor to press against with a
// small force first, and which arm is in which hand. The same servo and law as in an attempt; the
// world is a plane.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/arm_hands.h"
#include "haptics/hand_identity.h"
#include "haptics/servo.h"

namespace placode::haptics {

/// Largest force of the first test of a device [N].
inline constexpr double kFirstForceN = 0.5;
/// Stiffness of a test with no more than that [N/m].
inline constexpr double kFirstStiffnessNM = 100;

struct TrialSettings {
    std::string device;  ///< One with hardware: "haply", "spacemouse", ...
    Station station;
    /// Ceiling; the station's and the device's limits hold as well. Not finite: kFirstForceN.
    double force_n = kFirstForceN;
    int64_t (*clock_ns)() noexcept = nullptr;  ///< As in DeviceConfig.
    /// As in CouplingSettings. Only a stand-in without motors may be given a longer gap, on a
    /// computer whose threads are made to wait.
    double servo_gap_s = CouplingSettings{}.servo_gap_s;
};

/// One arm as it is now.
struct TrialArm {
    DeviceInfo info;
    DeviceState state;            ///< Frame D.
    Vec3 force_n = Vec3::Zero();  ///< That it was sent, in D.
    double height_m = 0;          ///< Of the hand above the floor; 0 without a floor.
};

struct TrialReport {
    std::vector<TrialArm> arms;
    bool floor = false;
    double force_n = 0, stiffness_n_m = 0;  ///< Ceiling and stiffness that the hand feels.
    HapticCertificate certificate;
    IdentityState identity;
};

/// Owner's thread, but for what it starts itself.
class DeviceTrial {
 public:
    /// Opens the device; throws DeviceError, also for one without hardware.
    explicit DeviceTrial(const TrialSettings& settings);
    ~DeviceTrial();
    DeviceTrial(const DeviceTrial&) = delete;
    DeviceTrial& operator=(const DeviceTrial&) = delete;

    /// Starts the servo and the world.
    void start();
    /// A floor 10 mm below where each arm is now, or none.
    void set_floor(bool on) noexcept;
    /// Begins to look which arm is moved or pressed; see HandIdentity.
    void identify() noexcept;
    [[nodiscard]] TrialReport report();
    void stop() noexcept;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::haptics
