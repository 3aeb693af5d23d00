// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for Force Dimension's DHD library with two arms; `fakedhd_` functions are the test's.
// Our own code after the public header of the SDK.
#include <algorithm>
#include <cstring>

namespace {

struct Arm {
    bool open = false, force_on = false, unplugged = false;
    double position[3]{}, gripper = 0, force[3]{}, max_force = 0;
    double frame[3][3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    unsigned buttons = 0;
    int status[17]{1, 1, 1, 0}, result = 0, gravity = 0, watchdog = 0;
};
Arm g_arms[2];
int g_count = 2;
int g_breaches = 0;

Arm* arm_of(char id) {
    const bool good = id >= 0 && id < 2 && g_arms[static_cast<int>(id)].open;
    if (!good) ++g_breaches;  // also for the default id that C does not have
    return good ? &g_arms[static_cast<int>(id)] : nullptr;
}

}  // namespace

extern "C" {

int dhdGetDeviceCount() { return g_count; }
int dhdOpenID(char id) {
    if (id < 0 || id >= 2 || g_arms[static_cast<int>(id)].open) return -1;
    g_arms[static_cast<int>(id)].open = true;
    return id;
}
int dhdClose(char id) {
    if (Arm* arm = arm_of(id)) arm->open = false;
    return 0;
}
int dhdStop(char id) {
    if (Arm* arm = arm_of(id)) std::fill_n(arm->force, 3, 0.0);
    return 0;
}
const char* dhdGetSystemName(char) { return "sigma.7"; }
int dhdGetSerialNumber(unsigned short* serial, char id) {
    *serial = static_cast<unsigned short>(100 + id);
    return 0;
}
bool dhdIsLeftHanded(char id) { return id == 1; }
bool dhdHasWrist(char) { return true; }
bool dhdHasGripper(char) { return true; }
int dhdEnableForce(unsigned char on, char id) {
    if (Arm* arm = arm_of(id)) arm->force_on = on != 0;
    return 0;
}
int dhdSetGravityCompensation(int on, char id) {
    if (Arm* arm = arm_of(id)) arm->gravity = on;
    return 0;
}
int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double frame[3][3],
                                      char id) {
    Arm* arm = arm_of(id);
    if (arm == nullptr || arm->unplugged) return -1;
    *x = arm->position[0];
    *y = arm->position[1];
    *z = arm->position[2];
    std::memcpy(frame, arm->frame, sizeof arm->frame);
    return arm->result;
}
int dhdGetGripperAngleRad(double* angle, char id) {
    const Arm* arm = arm_of(id);
    if (arm != nullptr) *angle = arm->gripper;
    return arm != nullptr ? 0 : -1;
}
unsigned dhdGetButtonMask(char id) {
    const Arm* arm = arm_of(id);
    return arm != nullptr ? arm->buttons : 0;
}
int dhdSetForceAndTorqueAndGripperForce(double x, double y, double z, double, double, double,
                                        double, char id) {
    Arm* arm = arm_of(id);
    if (arm == nullptr || arm->unplugged) return -1;
    const double wanted[3] = {x, y, z};
    for (int i = 0; i < 3; ++i) arm->force[i] = arm->force_on ? wanted[i] : 0;
    return 2;  // a saturated motor is no error
}
int dhdSetMaxForce(double newtons, char id) {
    if (Arm* arm = arm_of(id)) arm->max_force = newtons;
    return 0;
}
int dhdSetWatchdog(unsigned char ticks, char id) {
    if (Arm* arm = arm_of(id)) arm->watchdog = ticks;
    return 0;
}
int dhdGetStatus(int* status, char id) {
    const Arm* arm = arm_of(id);
    if (arm == nullptr) return -1;
    std::copy_n(arm->status, 17, status);
    return 0;
}
const char* dhdErrorGetLastStr() { return "device is in use"; }

void fakedhd_reset(int count) {
    for (Arm& arm : g_arms) arm = Arm{};
    g_count = count;
    g_breaches = 0;
}
void fakedhd_place(int id, double x, double y, double z) {
    double* p = g_arms[id].position;
    p[0] = x, p[1] = y, p[2] = z;
}
void fakedhd_grip(int id, double rad, unsigned buttons) {
    g_arms[id].gripper = rad;
    g_arms[id].buttons = buttons;
}
void fakedhd_status(int id, int word, int value) { g_arms[id].status[word] = value; }
void fakedhd_result(int id, int result) { g_arms[id].result = result; }
void fakedhd_unplug(int id, int out) { g_arms[id].unplugged = out != 0; }
void fakedhd_occupy(int id) { g_arms[id].open = true; }
void fakedhd_force(int id, double* newtons) { std::copy_n(g_arms[id].force, 3, newtons); }
double fakedhd_max_force(int id) { return g_arms[id].max_force; }
int fakedhd_watchdog(int id) { return g_arms[id].watchdog; }
/// As the firmware does without a force for the time of its watchdog.
void fakedhd_watchdog_acts(int id) {
    g_arms[id].force_on = false;
    std::fill_n(g_arms[id].force, 3, 0.0);
}
int fakedhd_open(int id) { return g_arms[id].open ? 1 : 0; }
int fakedhd_breaches() { return g_breaches; }

}  // extern "C"
