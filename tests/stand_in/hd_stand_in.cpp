// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for the vendor's libHD.so: all 36 functions of OpenHaptics 3.4, two arms, one
// scheduler (ticked by the test or by a thread), a stack of errors, and a memory for every breach
// of the calling contract. Our own code; only names and numbers are the vendor's.
#include "tests/stand_in/hd_stand_in.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace {

struct ErrorInfo {
    unsigned code;
    int internal;
    unsigned device;
};

struct Arm {
    const char* name = "";
    bool plugged = true, open = false, in_frame = false, output = false, ramping = false;
    double position[3]{}, transform[16]{}, joints[3]{0.1, 0.2, 0.3}, gimbal[3]{}, heat[6]{};
    double wanted[3]{}, rendered[3]{};
    int buttons = 0, updates = 0, frames_in_tick = 0;
    unsigned char inkwell = 0;
    unsigned calibration = 0x5000;
};

struct World {
    Arm arms[2];
    std::vector<ErrorInfo> errors;
    int current = -1;
    bool started = false, has_task = false, null_works = true, by_thread = false, in_tick = false;
    unsigned (*callback)(void*) = nullptr;
    void* context = nullptr;
    unsigned long rate = 1000;
    unsigned fail_get = 0;
    std::string violation;
    World() {
        arms[0].name = "Right";
        arms[1].name = "Left";
        for (Arm& arm : arms)
            for (const int i : {0, 5, 10, 15}) arm.transform[i] = 1;
    }
};

World g_world;
std::recursive_mutex g_mutex;
std::thread g_thread;
std::atomic<bool> g_thread_on{false};

using Lock = std::lock_guard<std::recursive_mutex>;

void breach(const std::string& what) {
    if (g_world.violation.empty()) g_world.violation = what;
}
void fail(unsigned code, unsigned device) { g_world.errors.push_back({code, 0, device}); }
Arm* arm_of(unsigned handle) {
    return handle >= 1 && handle <= 2 ? &g_world.arms[handle - 1] : nullptr;
}
Arm* current(const char* who) {
    if (g_world.current < 0) {
        breach(std::string(who) + " without a current device");
        return nullptr;
    }
    Arm& arm = g_world.arms[g_world.current];
    if (!arm.open) breach(std::string(who) + " after hdDisableDevice");
    return &arm;
}
unsigned current_handle() { return static_cast<unsigned>(g_world.current + 1); }

/// State may be read inside a frame only; information at any time.
Arm* readable(const char* who, unsigned what) {
    Arm* arm = current(who);
    if (arm == nullptr) return nullptr;
    if (g_world.fail_get != 0 && what < 0x2500) {
        fail(g_world.fail_get, current_handle());
        g_world.fail_get = 0;
    }
    if (!arm->in_frame) breach(std::string(who) + " outside a frame");
    return arm;
}

bool run_callback() {
    const Lock lock(g_mutex);
    World& w = g_world;
    if (!w.started || !w.has_task) return false;
    for (Arm& arm : w.arms) arm.frames_in_tick = 0;
    w.in_tick = true;
    const unsigned code = w.callback(w.context);
    w.in_tick = false;
    for (Arm& arm : w.arms) {
        if (arm.in_frame) breach("a frame is still open at the end of the tick");
        if (arm.open && arm.frames_in_tick != 1 && code == 1)
            breach("not one frame a device and tick");
        if (!arm.plugged && arm.open) fail(0x302, static_cast<unsigned>(&arm - w.arms) + 1);
    }
    if (code == 0) w.has_task = false;
    return code != 0;
}

}  // namespace

extern "C" {

unsigned hdInitDevice(const char* name) {
    const Lock lock(g_mutex);
    World& w = g_world;
    if (w.started) breach("hdInitDevice while the scheduler runs");
    for (int i = 0; i < 2; ++i) {
        const bool named = name != nullptr ? std::strcmp(name, w.arms[i].name) == 0 ||
                                                 (i == 0 && !w.null_works &&
                                                  std::strcmp(name, "Default PHANToM") == 0)
                                           : w.null_works && i == 0;
        if (!named) continue;
        if (!w.arms[i].plugged) {
            fail(0x302, 0xFFFFFFFFu);
            return 0xFFFFFFFFu;
        }
        if (w.arms[i].open) {
            fail(0x301, static_cast<unsigned>(i + 1));
            return 0xFFFFFFFFu;
        }
        w.arms[i].open = true;
        w.arms[i].output = false;
        w.current = i;
        return static_cast<unsigned>(i + 1);
    }
    fail(0x300, 0xFFFFFFFFu);
    return 0xFFFFFFFFu;
}
void hdDisableDevice(unsigned handle) {
    const Lock lock(g_mutex);
    Arm* arm = arm_of(handle);
    if (arm == nullptr || !arm->open) return breach("hdDisableDevice of a device that is not open");
    if (g_world.started) breach("hdDisableDevice before hdStopScheduler");
    arm->open = arm->output = false;
    for (double& f : arm->rendered) f = 0;
}
void hdMakeCurrentDevice(unsigned handle) {
    const Lock lock(g_mutex);
    if (arm_of(handle) == nullptr) return fail(0x104, handle);
    g_world.current = static_cast<int>(handle) - 1;
    (void)current("hdMakeCurrentDevice");
}
unsigned hdGetCurrentDevice() { return current_handle(); }
void hdBeginFrame(unsigned handle) {
    const Lock lock(g_mutex);
    Arm* arm = arm_of(handle);
    if (arm == nullptr || !arm->open) return breach("hdBeginFrame of a device that is not open");
    if (arm->in_frame) {
        breach("hdBeginFrame twice");
        return fail(0x400, handle);
    }
    g_world.current = static_cast<int>(handle) - 1;
    arm->in_frame = true;
    ++arm->frames_in_tick;
    for (double& f : arm->wanted) f = 0;
}
void hdEndFrame(unsigned handle) {
    const Lock lock(g_mutex);
    Arm* arm = arm_of(handle);
    if (arm == nullptr || !arm->in_frame) {
        breach("hdEndFrame without hdBeginFrame");
        return fail(0x401, handle);
    }
    arm->in_frame = false;
    for (int i = 0; i < 3; ++i) arm->rendered[i] = arm->output ? arm->wanted[i] : 0;
}
ErrorInfo hdGetError() {
    const Lock lock(g_mutex);
    if (g_world.errors.empty()) return {0, 0, 0};
    const ErrorInfo last = g_world.errors.back();
    g_world.errors.pop_back();
    return last;
}
const char* hdGetErrorString(unsigned code) {
    switch (code) {
        case 0x300:
            return "Device fault";
        case 0x301:
            return "Device already initiated";
        case 0x302:
            return "Communication error";
        default:
            return "Some error";
    }
}
void hdEnable(unsigned what) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdEnable");
    if (arm == nullptr) return;
    if (what == 0x4000) {
        if (arm->calibration != 0x5000) breach("force output enabled before calibration");
        arm->output = true;
    } else if (what == 0x4002) {
        arm->ramping = true;
    } else {
        fail(0x100, current_handle());
    }
}
void hdDisable(unsigned what) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdDisable");
    if (arm != nullptr && what == 0x4000) arm->output = false;
}
unsigned char hdIsEnabled(unsigned what) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdIsEnabled");
    return arm != nullptr && what == 0x4000 && arm->output ? 1 : 0;
}
void hdGetBooleanv(unsigned what, unsigned char* value) {
    const Lock lock(g_mutex);
    Arm* arm = readable("hdGetBooleanv", what);
    if (arm == nullptr) return;
    if (what == 0x2002)
        *value = arm->inkwell;
    else
        fail(0x100, current_handle());
}
void hdGetIntegerv(unsigned what, int* value) {
    const Lock lock(g_mutex);
    Arm* arm = readable("hdGetIntegerv", what);
    if (arm == nullptr) return;
    if (what == 0x2000)
        *value = arm->buttons;
    else
        fail(0x100, current_handle());
}
void hdGetFloatv(unsigned, float*) { breach("hdGetFloatv is not used"); }
void hdGetLongv(unsigned, long*) { breach("hdGetLongv is not used"); }
void hdGetDoublev(unsigned what, double* value) {
    const Lock lock(g_mutex);
    Arm* arm = readable("hdGetDoublev", what);
    if (arm == nullptr) return;
    const auto copy = [&](const double* from, int n) { std::copy_n(from, n, value); };
    switch (what) {
        case 0x2050:
            return copy(arm->position, 3);
        case 0x2052:
            return copy(arm->transform, 16);
        case 0x2100:
            return copy(arm->joints, 3);
        case 0x2150:
            return copy(arm->gimbal, 3);
        case 0x2605:
            return copy(arm->heat, 6);
        case 0x2603:
            *value = 3.3;
            return;
        case 0x2604:
            *value = 0.88;
            return;
        default:
            return fail(0x100, current_handle());
    }
}
const char* hdGetString(unsigned what) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdGetString");
    if (arm == nullptr) return nullptr;
    const bool right = arm == &g_world.arms[0];
    if (what == 0x2501) return "Touch";
    if (what == 0x2503) return "3D Systems";
    if (what == 0x2504) return right ? "R-001" : "L-002";
    fail(0x100, current_handle());
    return nullptr;
}
void hdSetBooleanv(unsigned, const unsigned char*) { breach("hdSetBooleanv is not used"); }
void hdSetIntegerv(unsigned, const int*) { breach("hdSetIntegerv is not used"); }
void hdSetFloatv(unsigned, const float*) { breach("hdSetFloatv is not used"); }
void hdSetLongv(unsigned, const long*) { breach("hdSetLongv is not used"); }
void hdSetDoublev(unsigned what, const double* value) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdSetDoublev");
    if (arm == nullptr) return;
    if (!arm->in_frame) breach("hdSetDoublev outside a frame");
    if (what != 0x2700) return fail(0x100, current_handle());
    const bool force = value[0] != 0 || value[1] != 0 || value[2] != 0;
    if (force && !arm->output) breach("a force without force output");
    std::copy_n(value, 3, arm->wanted);
}
unsigned hdCheckCalibration() {
    const Lock lock(g_mutex);
    Arm* arm = current("hdCheckCalibration");
    return arm != nullptr ? arm->calibration : 0x5002;
}
unsigned hdCheckCalibrationStyle() { return 4; }
void hdUpdateCalibration(unsigned style) {
    const Lock lock(g_mutex);
    Arm* arm = current("hdUpdateCalibration");
    if (arm == nullptr) return;
    ++arm->updates;
    if (style != 4) fail(0x101, current_handle());
    if (arm->inkwell != 0) arm->calibration = 0x5000;  // as the inkwell style does
}
const char* hdUpdateCalibrationMessage() { return ""; }
void hdStartScheduler() {
    const Lock lock(g_mutex);
    if (!g_world.has_task) breach("hdStartScheduler before hdScheduleAsynchronous");
    g_world.started = true;
    if (!g_world.by_thread) return;
    g_thread_on = true;
    g_thread = std::thread([] {
        while (g_thread_on) {
            (void)run_callback();
            std::this_thread::sleep_for(std::chrono::microseconds(1'000'000 / g_world.rate));
        }
    });
}
void hdStopScheduler() {
    g_thread_on = false;
    if (g_thread.joinable()) g_thread.join();
    const Lock lock(g_mutex);
    if (!g_world.started) breach("hdStopScheduler without hdStartScheduler");
    g_world.started = false;
    for (Arm& arm : g_world.arms)
        for (double& f : arm.rendered) f = 0;
}
void hdSetSchedulerRate(unsigned long hz) { g_world.rate = hz; }
void hdScheduleSynchronous(unsigned (*)(void*), void*, unsigned short) {
    breach("hdScheduleSynchronous is not used");
}
unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* context, unsigned short) {
    const Lock lock(g_mutex);
    if (g_world.started) breach("hdScheduleAsynchronous after hdStartScheduler");
    g_world.callback = callback;
    g_world.context = context;
    g_world.has_task = true;
    return 77;
}
void hdUnschedule(unsigned long task) {
    const Lock lock(g_mutex);
    if (task != 77) breach("hdUnschedule of an unknown task");
    if (g_world.started) breach("hdUnschedule before hdStopScheduler");
    g_world.has_task = false;
}
unsigned char hdWaitForCompletion(unsigned long, unsigned) { return 0; }
double hdGetSchedulerTimeStamp() { return 0.0001; }
void hdScaleGimbalAngles(double, double, double) {}
void hdDeploymentLicense(const char*, const char*) {}
#ifndef HD_STAND_IN_INCOMPLETE
void hdStandInIsComplete() {}
#endif

const FakeHd* fakehd() {
    static const FakeHd controls = [] {
        FakeHd c{};
        c.reset = [] { g_world = World(); };
        c.tick = [] { (void)run_callback(); };
        c.use_thread = [](int on) { g_world.by_thread = on != 0; };
        c.place = [](int arm, double x, double y, double z) {
            const Lock lock(g_mutex);
            double* p = g_world.arms[arm].position;
            p[0] = x, p[1] = y, p[2] = z;
        };
        c.turn = [](int arm, const double* transform, double roll) {
            const Lock lock(g_mutex);
            std::copy_n(transform, 16, g_world.arms[arm].transform);
            g_world.arms[arm].gimbal[2] = roll;
        };
        c.set_buttons = [](int arm, int mask) { g_world.arms[arm].buttons = mask; };
        c.set_inkwell = [](int arm, int in) {
            g_world.arms[arm].inkwell = static_cast<unsigned char>(in);
        };
        c.set_joints = [](int arm, double x, double y, double z) {
            double* j = g_world.arms[arm].joints;
            j[0] = x, j[1] = y, j[2] = z;
        };
        c.set_heat = [](int arm, double heat) { g_world.arms[arm].heat[1] = heat; };
        c.set_calibration = [](int arm, unsigned state) { g_world.arms[arm].calibration = state; };
        c.push_error = [](unsigned code, int arm) {
            const Lock lock(g_mutex);
            fail(code, arm < 0 ? 0xFFFFFFFFu : static_cast<unsigned>(arm + 1));
        };
        c.fail_next_get = [](unsigned code) { g_world.fail_get = code; };
        c.plug = [](int arm, int in) {
            const Lock lock(g_mutex);
            g_world.arms[arm].plugged = in != 0;
        };
        c.accept_null = [](int on) { g_world.null_works = on != 0; };
        c.force = [](int arm, double* newtons) {
            const Lock lock(g_mutex);
            std::copy_n(g_world.arms[arm].rendered, 3, newtons);
        };
        c.output_enabled = [](int arm) { return g_world.arms[arm].output ? 1 : 0; };
        c.calibration_updates = [](int arm) { return g_world.arms[arm].updates; };
        c.scheduled = [] {
            const Lock lock(g_mutex);
            return g_world.has_task ? 1 : 0;
        };
        c.running = [] {
            const Lock lock(g_mutex);
            return g_world.started ? 1 : 0;
        };
        c.open = [](int arm) {
            const Lock lock(g_mutex);
            return g_world.arms[arm].open ? 1 : 0;
        };
        c.rate = [] { return g_world.rate; };
        c.violation = [] { return g_world.violation.c_str(); };
        return c;
    }();
    return &controls;
}

}  // extern "C"
