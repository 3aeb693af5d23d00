// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of the vendor's libHD.so that the driver of Touch arms uses: its numbers, its functions,
// found at run time. Declared in our own words after the OpenHaptics reference guide 3.4; no vendor
// file is needed to build.

#include <string>

#include "haptics/station.h"

namespace placode::haptics::hd {

using DeviceHandle = unsigned;  ///< HHD
/// HDErrorInfo, returned by value.
struct ErrorInfo {
    unsigned code;
    int internal;
    DeviceHandle device;
};
static_assert(sizeof(ErrorInfo) == 12);

inline constexpr DeviceHandle kNoHandle = 0xFFFFFFFFu;
inline constexpr unsigned kButtons = 0x2000, kInkwell = 0x2002, kPosition = 0x2050,
                          kTransform = 0x2052, kJointAngles = 0x2100, kGimbalAngles = 0x2150,
                          kModel = 0x2501, kVendor = 0x2503, kSerial = 0x2504, kMaxForce = 0x2603,
                          kContinuousForce = 0x2604, kMotorTemperature = 0x2605, kForce = 0x2700,
                          kForceOutput = 0x4000, kForceRamping = 0x4002;
inline constexpr unsigned kCalibrationOk = 0x5000, kCalibrationNeedsUpdate = 0x5001;
inline constexpr unsigned kSuccess = 0, kInputType = 0x103, kDeviceFault = 0x300,
                          kAlreadyInitiated = 0x301, kComm = 0x302, kTimer = 0x304,
                          kInvalidPriority = 0x500, kSchedulerFull = 0x501, kInvalidLicense = 0x600;
inline constexpr unsigned kCallbackDone = 0, kCallbackContinue = 1;
inline constexpr unsigned short kMaxPriority = 65535;
inline constexpr unsigned long kRateHz = 1000;

/// The functions that are used.
struct Library {
    DeviceHandle (*init_device)(const char*);
    void (*disable_device)(DeviceHandle);
    void (*make_current)(DeviceHandle);
    void (*begin_frame)(DeviceHandle);
    void (*end_frame)(DeviceHandle);
    ErrorInfo (*get_error)();
    const char* (*error_string)(unsigned);
    void (*enable)(unsigned);
    void (*disable)(unsigned);
    void (*get_booleanv)(unsigned, unsigned char*);
    void (*get_integerv)(unsigned, int*);
    void (*get_doublev)(unsigned, double*);
    void (*set_doublev)(unsigned, const double*);
    const char* (*get_string)(unsigned);
    unsigned (*check_calibration)();
    unsigned (*calibration_style)();
    void (*update_calibration)(unsigned);
    void (*start_scheduler)();
    void (*stop_scheduler)();
    void (*set_rate)(unsigned long);
    unsigned long (*schedule)(unsigned (*)(void*), void*, unsigned short);
    void (*unschedule)(unsigned long);
};

/// Loads the library that PLACODE_LIBHD or the station file names, or the system's. It stays
/// loaded: threads of the vendor's may outlive a session. Throws DeviceError with the loader's own
/// words.
[[nodiscard]] Library load_library(const Station& station);

/// True for errors after which the arm has to be opened again.
[[nodiscard]] bool ends_session(unsigned code) noexcept;

/// "0x302 (communication error)": words of the reference guide; an unknown code stands alone.
[[nodiscard]] std::string error_words(unsigned code);

}  // namespace placode::haptics::hd
