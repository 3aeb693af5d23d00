// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/openhaptics_arm.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace placode::haptics::hd {

namespace {

constexpr double kMm = 1e-3;
constexpr double kDefaultMaxForceN = 3.3, kDefaultContinuousN = 0.88, kMaxStiffnessNM = 400,
                 kMaxDampingNsM = 4;  // of the Touch; the unit of the library's own is not settled

std::string words(const Library& hd, const ErrorInfo& error) {
    const char* text = hd.error_string(error.code);
    char code[16];
    std::snprintf(code, sizeof code, "0x%03x", error.code);
    return std::string(text != nullptr ? text : "unknown error") + " (" + code + ")";
}

void describe(const Library& hd, Arm& arm) {
    hd.make_current(arm.handle);
    hd.begin_frame(arm.handle);
    const auto text = [&](unsigned what) {
        const char* found = hd.get_string(what);
        return std::string(found != nullptr ? found : "");
    };
    arm.info.vendor = text(kVendor);
    arm.info.model = text(kModel);
    arm.info.serial = text(kSerial);
    double force = 0, continuous = 0;
    hd.get_doublev(kMaxForce, &force);
    hd.get_doublev(kContinuousForce, &continuous);
    hd.end_frame(arm.handle);
    drain(hd);
    if (arm.info.vendor.empty()) arm.info.vendor = "3D Systems";
    arm.info.driver = "OpenHaptics";
    arm.info.dof_sensed = 6;
    arm.info.dof_force = 3;
    arm.info.owns_servo = true;
    arm.info.left_hand = !arm.right;
    arm.info.max_force_n = force > 0 ? force : kDefaultMaxForceN;
    arm.info.continuous_force_n = continuous > 0 ? continuous : kDefaultContinuousN;
    arm.info.max_stiffness_n_m = kMaxStiffnessNM;
    arm.info.max_damping_ns_m = kMaxDampingNsM;
}

// Calibration and motors, ten times a second. The frame of the arm is open and it is current.
void slow_look(const Library& hd, Arm& arm) noexcept {
    double heat[6]{};
    hd.get_doublev(kMotorTemperature, heat);
    double hottest = 0;
    for (const double one : heat) hottest = std::max(hottest, one);
    arm.sample.motor_heat = static_cast<float>(hottest);
    const unsigned state = hd.check_calibration();
    if (state == kCalibrationNeedsUpdate) hd.update_calibration(hd.calibration_style());
    arm.calibrated = state == kCalibrationOk;
    if (!arm.calibrated && arm.forces_on) {
        hd.disable(kForceOutput);
        arm.forces_on = false;
    }
}

}  // namespace

void drain(const Library& hd) noexcept {
    for (int i = 0; i < 64 && hd.get_error().code != kSuccess; ++i) {
    }
}

void open_arm(const Library& hd, Arm& arm) {
    std::vector<const char*> names{arm.name.c_str()};
    if (arm.name.empty()) names = {nullptr, "Default PHANToM", "Default Device", "Right Device"};
    std::string problem;
    for (const char* name : names) {
        drain(hd);
        const DeviceHandle handle = hd.init_device(name);
        const ErrorInfo error = hd.get_error();
        if (error.code == kSuccess && handle != kNoHandle) {
            arm.handle = handle;
            describe(hd, arm);
            return;
        }
        problem = words(hd, error);
        if (error.code == kAlreadyInitiated) break;  // another program or arm has it
    }
    throw DeviceError("openhaptics: the " + std::string(arm.right ? "right" : "left") + " arm \"" +
                      (arm.name.empty() ? "default device" : arm.name) +
                      "\" cannot be opened: " + problem +
                      ". Plug it in, run the vendor's setup once, and write the name it got "
                      "there into openhaptics.right or openhaptics.left of the station file.");
}

void read_arm(const Library& hd, Arm& arm, bool slow) noexcept {
    double position[3]{}, transform[16]{}, joints[3]{}, gimbal[3]{};
    int buttons = 0;
    unsigned char inkwell = 0;
    hd.get_doublev(kPosition, position);
    hd.get_doublev(kTransform, transform);
    hd.get_doublev(kJointAngles, joints);
    hd.get_doublev(kGimbalAngles, gimbal);
    hd.get_integerv(kButtons, &buttons);
    hd.get_booleanv(kInkwell, &inkwell);
    ArmSample& sample = arm.sample;
    const float heat = sample.motor_heat;
    sample = {};
    sample.motor_heat = heat;
    sample.position_m = kMm * Vec3(position[0], position[1], position[2]);
    Mat3 axes;  // column by column
    axes << transform[0], transform[4], transform[8], transform[1], transform[5], transform[9],
        transform[2], transform[6], transform[10];
    if (axes.allFinite() && std::abs(axes.determinant() - 1) < 0.01)
        sample.orientation = Quat(axes);
    sample.roll_rad = gimbal[2];
    sample.buttons = static_cast<uint32_t>(buttons);
    sample.held = inkwell == 0;
    const bool at_zero = joints[0] == 0 && joints[1] == 0 && joints[2] == 0;
    arm.still_ticks = at_zero ? std::min(arm.still_ticks + 1, kPoll) : 0;
    if (slow) slow_look(hd, arm);
    const bool calibrated = arm.calibrated && arm.still_ticks < kPoll;
    if (arm.calibrated && !arm.forces_on) {
        hd.enable(kForceOutput);
        hd.enable(kForceRamping);
        arm.forces_on = true;
    }
    sample.status = calibrated ? DeviceStatus::kReady : DeviceStatus::kNotCalibrated;
}

}  // namespace placode::haptics::hd
