// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/openhaptics_library.h"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "haptics/device.h"

namespace placode::haptics::hd {

namespace {

constexpr const char* kHowToInstall =
    "Install the vendor's OpenHaptics and Touch device driver (3D Systems, \"OpenHaptics for "
    "Linux\"), and the old ncurses that it needs (libncurses5, libtinfo5); or name the file by "
    "openhaptics.library in the station file or by PLACODE_LIBHD.";

template <class Function>
void load(void* library, const char* name, Function& function) {
    void* symbol = dlsym(library, name);
    if (symbol == nullptr)
        throw DeviceError(std::string("openhaptics: the library has no ") + name +
                          ": it is not the libHD of OpenHaptics 3.4. " + kHowToInstall);
    function = reinterpret_cast<Function>(symbol);
}

void* open_library(const Station& station) {
    std::vector<std::string> names;
    if (const char* named = std::getenv("PLACODE_LIBHD")) names.emplace_back(named);
    if (const std::string named = station.text("openhaptics.library"); !named.empty())
        names.push_back(named);
    if (names.empty()) names = {"libHD.so.3.4", "libHD.so"};
    std::string problems;
    for (const std::string& name : names) {
        if (void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
        const char* why = dlerror();  // as it stands: it names the missing file
        problems += (problems.empty() ? "" : "; ") + std::string(why != nullptr ? why : name);
    }
    throw DeviceError("openhaptics: " + problems + ". " + kHowToInstall);
}

constexpr std::pair<unsigned, const char*> kErrors[] = {
    {0x100, "invalid enumerator"},
    {0x101, "invalid value"},
    {0x102, "invalid operation"},
    {0x103, "invalid input type"},
    {0x104, "bad handle"},
    {0x200, "warm motors"},
    {0x201, "force too large"},
    {0x202, "force rises too fast"},
    {0x203, "velocity too large"},
    {0x204, "force error"},
    {0x300, "device fault"},
    {0x301, "device already initiated"},
    {0x302, "communication error"},
    {0x303, "communication is set up wrongly"},
    {0x304, "timer error"},
    {0x400, "illegal begin of a frame"},
    {0x401, "illegal end of a frame"},
    {0x402, "frame error"},
    {0x500, "invalid priority"},
    {0x501, "scheduler is full"},
    {0x600, "invalid licence"},
};

}  // namespace

Library load_library(const Station& station) {
    void* library = open_library(station);
    Library hd{};
    load(library, "hdInitDevice", hd.init_device);
    load(library, "hdDisableDevice", hd.disable_device);
    load(library, "hdMakeCurrentDevice", hd.make_current);
    load(library, "hdBeginFrame", hd.begin_frame);
    load(library, "hdEndFrame", hd.end_frame);
    load(library, "hdGetError", hd.get_error);
    load(library, "hdGetErrorString", hd.error_string);
    load(library, "hdEnable", hd.enable);
    load(library, "hdDisable", hd.disable);
    load(library, "hdGetBooleanv", hd.get_booleanv);
    load(library, "hdGetIntegerv", hd.get_integerv);
    load(library, "hdGetDoublev", hd.get_doublev);
    load(library, "hdSetDoublev", hd.set_doublev);
    load(library, "hdGetString", hd.get_string);
    load(library, "hdCheckCalibration", hd.check_calibration);
    load(library, "hdCheckCalibrationStyle", hd.calibration_style);
    load(library, "hdUpdateCalibration", hd.update_calibration);
    load(library, "hdStartScheduler", hd.start_scheduler);
    load(library, "hdStopScheduler", hd.stop_scheduler);
    load(library, "hdSetSchedulerRate", hd.set_rate);
    load(library, "hdScheduleAsynchronous", hd.schedule);
    load(library, "hdUnschedule", hd.unschedule);
    return hd;
}

bool ends_session(unsigned code) noexcept {
    return code == kDeviceFault || (code >= kComm && code <= kTimer) || code == kInvalidPriority ||
           code == kSchedulerFull || code == kInvalidLicense;
}

std::string error_words(unsigned code) {
    char number[16];
    std::snprintf(number, sizeof number, "0x%03x", code);
    for (const auto& [known, words] : kErrors)
        if (known == code) return std::string(number) + " (" + words + ")";
    return number;
}

}  // namespace placode::haptics::hd
