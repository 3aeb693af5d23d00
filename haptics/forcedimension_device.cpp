// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Force Dimension omega, delta, sigma and lambda through the vendor's DHD library, loaded at run
// time. Declared here in our own words after the public header of the SDK; every function takes
// the device as its last argument. The library has no servo of its own: ours is the 1 kHz loop.
#include <dlfcn.h>

#include <cmath>

#include "haptics/arm_hands.h"

namespace placode::haptics {

namespace {

// Not errors: the call came sooner than the guard allows, or a motor is at its limit.
constexpr int kTimeGuard = 1, kMotorSaturated = 2;
constexpr int kStatusWords = 17, kPower = 0, kConnected = 1, kReset = 3, kErrorWord = 9;
constexpr int kPoll = 100;                    // ticks between looks at the status
constexpr int kRetryTicks = 100;              // failed reads before the arm counts as lost for good
constexpr unsigned char kWatchdogTicks = 80;  // of 125 us: without a force for 10 ms none is held
constexpr int64_t kGapNs = 5'000'000;         // the watchdog may have acted
constexpr double kGripperOpenRad = 0.5;
constexpr double kMaxForceN = 12, kContinuousForceN = 4;  // of the weakest of them (omega)

struct Library {
    int (*device_count)();
    int (*open_id)(char);
    int (*close)(char);
    int (*stop)(char);
    const char* (*system_name)(char);
    int (*serial_number)(unsigned short*, char);
    bool (*is_left_handed)(char);
    bool (*has_wrist)(char);
    bool (*has_gripper)(char);
    int (*enable_force)(unsigned char, char);
    int (*gravity_compensation)(int, char);
    int (*get_frame)(double*, double*, double*, double[3][3], char);
    int (*gripper_angle)(double*, char);
    unsigned (*button_mask)(char);
    int (*set_force)(double, double, double, double, double, double, double, char);
    int (*set_max_force)(double, char);
    int (*get_status)(int*, char);
    const char* (*last_error)();
    int (*set_watchdog)(unsigned char, char);  // null: an older SDK
};

constexpr const char* kHowToInstall =
    "Install the shared libraries of the Force Dimension SDK, or name the file by "
    "forcedimension.library in the station file.";

template <class Function>
void load(void* library, const char* name, Function& function) {
    void* symbol = dlsym(library, name);
    if (symbol == nullptr)
        throw DeviceError(std::string("forcedimension: the library has no ") + name +
                          ": it is not the DHD of SDK 3. " + kHowToInstall);
    function = reinterpret_cast<Function>(symbol);
}

Library load_library(const Station& station) {
    std::vector<std::string> names{"libdhd.so.3", "libdrd.so.3", "libdhd.so", "libdrd.so"};
    if (const std::string named = station.text("forcedimension.library"); !named.empty())
        names = {named};
    void* library = nullptr;
    std::string problems;
    for (const std::string& name : names) {
        library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library != nullptr) break;
        const char* why = dlerror();
        problems += (problems.empty() ? "" : "; ") + std::string(why != nullptr ? why : name);
    }
    if (library == nullptr) throw DeviceError("forcedimension: " + problems + ". " + kHowToInstall);
    Library dhd{};
    load(library, "dhdGetDeviceCount", dhd.device_count);
    load(library, "dhdOpenID", dhd.open_id);
    load(library, "dhdClose", dhd.close);
    load(library, "dhdStop", dhd.stop);
    load(library, "dhdGetSystemName", dhd.system_name);
    load(library, "dhdGetSerialNumber", dhd.serial_number);
    load(library, "dhdIsLeftHanded", dhd.is_left_handed);
    load(library, "dhdHasWrist", dhd.has_wrist);
    load(library, "dhdHasGripper", dhd.has_gripper);
    load(library, "dhdEnableForce", dhd.enable_force);
    load(library, "dhdSetGravityCompensation", dhd.gravity_compensation);
    load(library, "dhdGetPositionAndOrientationFrame", dhd.get_frame);
    load(library, "dhdGetGripperAngleRad", dhd.gripper_angle);
    load(library, "dhdGetButtonMask", dhd.button_mask);
    load(library, "dhdSetForceAndTorqueAndGripperForce", dhd.set_force);
    load(library, "dhdSetMaxForce", dhd.set_max_force);
    load(library, "dhdGetStatus", dhd.get_status);
    load(library, "dhdErrorGetLastStr", dhd.last_error);
    dhd.set_watchdog =
        reinterpret_cast<int (*)(unsigned char, char)>(dlsym(library, "dhdSetWatchdog"));
    return dhd;
}

bool failed(int result) noexcept { return result < 0 || result > kMotorSaturated; }

// x towards the operator, y right, z up, in the vendor's frame.
Vec3 to_device(const Vec3& v) { return {v.y(), v.z(), v.x()}; }
Vec3 to_vendor(const Vec3& d) { return {d.z(), d.x(), d.y()}; }

struct DhdArm {
    char id = 0;
    sim::Hand hand = sim::Hand::kRight;
    DeviceInfo info;
    bool wrist = false, gripper = false, calibrated = false, lost = false, forces_on = false;
    int failures = 0;
};

/// Opens what is there, at most one arm a hand.
std::vector<DhdArm> open_arms(const Library& dhd, const Station& station) {
    const int count = dhd.device_count();
    if (count <= 0)
        throw DeviceError(
            "forcedimension: the library finds no device. Plug it in, switch it on, and give the "
            "right to use it: the SDK's udev rule for USB 1451.");
    const bool swap = station.number("forcedimension.swap_hands") > 0.5;
    std::vector<DhdArm> arms;
    std::string problem;
    for (int i = 0; i < count && arms.size() < kMaxArms; ++i) {
        DhdArm arm;
        const int id = dhd.open_id(static_cast<char>(i));
        if (id < 0) {
            const char* why = dhd.last_error();
            problem = why != nullptr ? why : "unknown error";
            continue;
        }
        arm.id = static_cast<char>(id);
        const bool left = dhd.is_left_handed(arm.id) != swap;
        arm.hand = left ? sim::Hand::kLeft : sim::Hand::kRight;
        // Two of the same side: the second takes the other hand.
        if (!arms.empty() && arms.front().hand == arm.hand)
            arm.hand = left ? sim::Hand::kRight : sim::Hand::kLeft;
        arm.wrist = dhd.has_wrist(arm.id);
        arm.gripper = dhd.has_gripper(arm.id);
        const char* name = dhd.system_name(arm.id);
        unsigned short serial = 0;
        dhd.serial_number(&serial, arm.id);
        arm.info.vendor = "Force Dimension";
        arm.info.model = name != nullptr ? name : "unknown";
        arm.info.serial = std::to_string(serial);
        arm.info.driver = "DHD";
        arm.info.dof_sensed = arm.wrist ? 6 : 3;
        arm.info.dof_force = 3;
        arm.info.gripper = arm.gripper;
        arm.info.left_hand = arm.hand == sim::Hand::kLeft;
        arm.info.max_force_n = kMaxForceN;
        arm.info.continuous_force_n = kContinuousForceN;
        arms.push_back(arm);
    }
    if (arms.empty())
        throw DeviceError("forcedimension: no device can be opened: " + problem +
                          ". Close other programs that use it.");
    return arms;
}

class ForceDimensionDevice final : public ArmHands {
 public:
    ForceDimensionDevice(const DeviceConfig& config, const Library& dhd, std::vector<DhdArm> arms)
        : ArmHands(config, hands_of(arms, config.station)), dhd_(dhd), arms_(std::move(arms)) {
        for (DhdArm& arm : arms_) {
            // A second line of defence, in the vendor's own loop.
            dhd_.set_max_force(config.station.number("limit.force_n"), arm.id);
            dhd_.gravity_compensation(1, arm.id);
            // A program that stands still sends no zero: the firmware lets go by itself.
            if (dhd_.set_watchdog != nullptr) (void)dhd_.set_watchdog(kWatchdogTicks, arm.id);
            look_at_status(arm);
        }
    }
    ~ForceDimensionDevice() override { stop(); }

    void stop() noexcept override {
        for (DhdArm& arm : arms_) {
            dhd_.set_force(0, 0, 0, 0, 0, 0, 0, arm.id);
            dhd_.enable_force(0, arm.id);
            dhd_.stop(arm.id);
            dhd_.close(arm.id);
        }
        arms_.clear();
    }

 protected:
    void sense(int64_t t_ns, std::span<ArmSample> samples) noexcept override {
        const bool gap = ticks_ > 0 && t_ns - sensed_ns_ > kGapNs;
        sensed_ns_ = t_ns;
        for (size_t a = 0; a < samples.size() && a < arms_.size(); ++a) {
            DhdArm& arm = arms_[a];
            ArmSample& sample = samples[a];
            if (gap) arm.forces_on = false;  // enabled again below
            double x = 0, y = 0, z = 0, frame[3][3]{};
            if (failed(dhd_.get_frame(&x, &y, &z, frame, arm.id))) {
                arm.failures = std::min(arm.failures + 1, kRetryTicks);
                arm.forces_on = false;  // enabled again after its return
                continue;               // lost in this tick
            }
            arm.failures = 0;
            if (ticks_ % kPoll == 0) look_at_status(arm);
            sample.status = arm.calibrated ? DeviceStatus::kReady : DeviceStatus::kNotCalibrated;
            sample.held = true;
            sample.position_m = to_device({x, y, z});
            if (arm.wrist) read_wrist(frame, sample);
            double angle = 0;
            if (arm.gripper && !failed(dhd_.gripper_angle(&angle, arm.id)))
                sample.jaw = std::abs(angle) / kGripperOpenRad;
            sample.buttons = dhd_.button_mask(arm.id);
            if (arm.calibrated && !arm.forces_on)
                arm.forces_on = !failed(dhd_.enable_force(1, arm.id));
        }
        ++ticks_;
    }

    void drive(std::span<const ArmForce> forces) noexcept override {
        for (size_t a = 0; a < forces.size() && a < arms_.size(); ++a) {
            const Vec3 f = to_vendor(arms_[a].forces_on ? forces[a].force_n : Vec3(Vec3::Zero()));
            if (arms_[a].failures < kRetryTicks)
                (void)dhd_.set_force(f.x(), f.y(), f.z(), 0, 0, 0, 0, arms_[a].id);
        }
    }

    [[nodiscard]] std::vector<DeviceInfo> arm_info() const override {
        std::vector<DeviceInfo> infos;
        for (const DhdArm& arm : arms_) infos.push_back(arm.info);
        return infos;
    }

 private:
    static std::vector<sim::Hand> hands_of(const std::vector<DhdArm>& arms,
                                           const Station& station) {
        std::vector<sim::Hand> hands;
        for (const DhdArm& arm : arms) hands.push_back(arm.hand);
        if (hands.size() == 1)
            hands[0] =
                station.text("arm.one_hand") == "left" ? sim::Hand::kLeft : sim::Hand::kRight;
        return hands;
    }

    void look_at_status(DhdArm& arm) noexcept {
        int words[kStatusWords]{};
        arm.calibrated = !failed(dhd_.get_status(words, arm.id)) && words[kPower] != 0 &&
                         words[kConnected] != 0 && words[kReset] == 0 && words[kErrorWord] == 0;
        if (!arm.calibrated) arm.forces_on = false;
    }

    static void read_wrist(const double frame[3][3], ArmSample& sample) noexcept {
        Mat3 vendor;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) vendor(i, k) = frame[i][k];
        Mat3 turn;  // vendor's axes to D, as to_device
        turn << 0, 1, 0, 0, 0, 1, 1, 0, 0;
        const Mat3 axes = turn * vendor * turn.transpose();
        if (!axes.allFinite() || std::abs(axes.determinant() - 1) > 0.01) return;
        sample.orientation = Quat(axes);
        // Turn about the handle's long axis, which points away from the operator.
        sample.roll_rad = 2 * std::atan2(sample.orientation.z(), sample.orientation.w());
    }

    Library dhd_;
    std::vector<DhdArm> arms_;
    int64_t ticks_ = 0, sensed_ns_ = 0;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_forcedimension(const DeviceConfig& config) {
    const Library dhd = load_library(config.station);
    std::vector<DhdArm> arms = open_arms(dhd, config.station);
    try {
        return std::make_unique<ForceDimensionDevice>(config, dhd, arms);
    } catch (...) {
        for (const DhdArm& arm : arms) dhd.close(arm.id);
        throw;
    }
}

}  // namespace placode::haptics
