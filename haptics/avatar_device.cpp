// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Follou Haptic Avatar: port devices with an instrument in them, and a box for handles and pedals,
// each on a serial line. A line holds commands, the answer their integers in the same order;
// numbers are multiplied by 10,000. The next line is sent when the last was answered. Written after
// the maker's public plug-in for SOFA; signs and zero of the depth are settings, because no device
// was at hand to confirm them.
#include <cmath>
#include <cstring>

#include "haptics/arm_hands.h"
#include "haptics/avatar_line.h"
#include "haptics/rcm_device_map.h"
#include "haptics/real_time.h"

namespace placode::haptics {

namespace {

using avatar::kMaxAnswers, avatar::kScale, avatar::Line, avatar::read_answer, avatar::Talker;

constexpr int64_t kAvatarOpenNs = 1'000'000'000;
constexpr int kAngles = 2, kStatus = 5, kForceAndTorques = 6, kInserted = 28, kCalibration = 38,
              kForceEnable = 43;           // of a port device
constexpr int kOpenings = 2, kPedals = 4;  // of the box
constexpr int kAmplifiersHot = 0x10 | 0x20 | 0x80;
constexpr double kMaxForceN = 8;  // not confirmed; the settings' limit is lower

struct HapticBenchDevice : Talker {
    using Talker::Talker;
    RcmPose pose;
    bool calibrated = false, inserted = false, hot = false, enabled = false;
    RcmForce force;
};

class AvatarDevice final : public ArmHands {
 public:
    AvatarDevice(const DeviceConfig& config, std::vector<sim::Hand> hands,
                 const std::vector<std::string>& paths)
        : ArmHands(config, hands),
          hands_(hands),
          depth_zero_m_(config.station.number("avatar.depth_zero_m")) {
        read_signs(config.station.text("avatar.signs"));
        const double settle = config.station.number("avatar.settle_s");
        for (const std::string& path : paths)
            ports_.push_back(std::make_unique<HapticBenchDevice>(path, settle));
        if (const std::string box = config.station.text("avatar.ibox"); !box.empty())
            box_ = std::make_unique<Talker>(box, settle);
        const auto trocars = default_trocars(config.tools, "avatar");
        for (size_t i = 0; i < config.tools.size(); ++i)
            maps_.emplace_back(config.tools[i], trocars[i]);
        wait_for_devices(settle);
    }

    void stop() noexcept override {
        for (auto& port : ports_) {
            Line line;
            line.add(kForceAndTorques).add(0).add(0).add(0).add(0).add(kForceEnable).add(0);
            port->serial.send(line.text());
            port->serial.close();
        }
    }

 protected:
    void sense(int64_t t_ns, std::span<ArmSample> samples) noexcept override {
        now_ns_ = t_ns;
        hear_box(t_ns);
        for (size_t a = 0; a < samples.size(); ++a) {
            HapticBenchDevice& port = *ports_[a];
            hear_port(port, t_ns);
            ArmSample& sample = samples[a];
            if (!port.alive(t_ns)) continue;  // lost
            sample.status = port.calibrated ? DeviceStatus::kReady : DeviceStatus::kNotCalibrated;
            sample.absolute = true;
            sample.held = port.inserted;
            const int tool = tool_of(a);
            if (tool >= 0) sample.position_m = maps_[static_cast<size_t>(tool)].handle_m(port.pose);
            sample.roll_rad = port.pose.roll_rad;
            sample.motor_heat = port.hot ? 1.0f : 0.0f;
            if (box_ && box_->alive(t_ns)) {
                sample.jaw = openings_[hands_[a] == sim::Hand::kLeft ? 1 : 0];
                sample.pedals = pedals_;
            }
        }
    }

    void drive(std::span<const ArmForce> forces) noexcept override {
        for (size_t a = 0; a < forces.size(); ++a) {
            HapticBenchDevice& port = *ports_[a];
            const int tool = tool_of(a);
            port.force = {};
            if (tool >= 0 && port.enabled && now_ns_ <= forces[a].valid_until_ns)
                port.force = maps_[static_cast<size_t>(tool)].force(port.pose, forces[a].force_n);
            ask_port(port);
        }
        if (box_ && !box_->waiting && box_->serial.problem() == 0) {
            Line line;
            line.add(kOpenings).add(kPedals);
            box_->say(now_ns_, line.text(), 8);
        }
    }

    [[nodiscard]] std::vector<DeviceInfo> arm_info() const override {
        std::vector<DeviceInfo> infos;
        for (size_t a = 0; a < hands_.size(); ++a) {
            DeviceInfo info;
            info.vendor = "Follou";
            info.model = "Haptic Avatar";
            info.serial = ports_[a]->serial.path();
            info.driver = "serial";
            info.dof_sensed = 4;
            info.dof_force = 3;
            info.gripper = box_ != nullptr;
            info.left_hand = hands_[a] == sim::Hand::kLeft;
            info.max_force_n = kMaxForceN;
            infos.push_back(info);
        }
        return infos;
    }

 private:
    void read_signs(const std::string& text) {
        std::array<int, kMaxAnswers> values{};
        bool good = read_answer(text, 4, values);
        for (size_t i = 0; i < 4; ++i) {
            good = good && std::abs(values[i]) == 1;
            signs_[i] = values[i];
        }
        if (!good)
            throw DeviceError("avatar.signs: found \"" + text +
                              "\", expected four numbers, each 1 or -1");
    }

    void wait_for_devices(double settle_s) {
        const int64_t until = monotonic_ns() + static_cast<int64_t>(settle_s * 1e9) + kAvatarOpenNs;
        std::array<ArmSample, kMaxArms> samples;
        std::array<ArmForce, kMaxArms> none;
        const HapticBenchDevice* missing = nullptr;
        do {
            sense(monotonic_ns(), {samples.data(), ports_.size()});
            drive({none.data(), ports_.size()});
            missing = nullptr;
            for (const auto& port : ports_)
                if (!port->alive(monotonic_ns())) missing = port.get();
            if (missing != nullptr && missing->serial.problem() != 0) break;
            sleep_until(monotonic_ns() + 1'000'000);
        } while (missing != nullptr && monotonic_ns() < until);
        if (missing == nullptr) return;
        const int problem = missing->serial.problem();
        throw DeviceError(
            "avatar: " + missing->serial.path() + ": " +
            (problem != 0 ? std::strerror(problem) : "no Haptic Avatar answers there") +
            ". Plug it in and switch it on; add the user to the group dialout; name the port by "
            "avatar.right or avatar.left in the station file.");
    }

    void hear_port(HapticBenchDevice& port, int64_t t_ns) noexcept {
        std::array<int, kMaxAnswers> v{};
        if (!port.hear(t_ns, v)) return;
        // rotation, pitch, depth, yaw: radians and millimetres, times 10,000
        port.pose.roll_rad = signs_[0] * v[0] / kScale;
        port.pose.pitch_rad = signs_[1] * v[1] / kScale;
        port.pose.depth_m = signs_[2] * v[2] / kScale * 1e-3 - depth_zero_m_;
        port.pose.yaw_rad = signs_[3] * v[3] / kScale;
        if (!port.asked_more) return;
        port.hot = (v[4] & kAmplifiersHot) != 0;
        port.inserted = v[5] != 0;
        port.calibrated = v[6] != 0 && v[7] != 0;  // yaw and pitch; depth needs none
        if (!port.calibrated) port.enabled = false;
    }

    void ask_port(HapticBenchDevice& port) noexcept {
        if (port.waiting || port.serial.problem() != 0) return;
        Line line;
        line.add(kAngles);
        port.asked_more = port.lines % 10 == 0;
        size_t answers = 4;
        if (port.asked_more) {
            line.add(kStatus).add(kInserted).add(kCalibration);
            answers += 1 + 1 + 3;
        }
        if (port.calibrated && !port.enabled) {
            line.add(kForceEnable).add(1);
            port.enabled = true;
        }
        line.add(kForceAndTorques)
            .add(0)
            .add_scaled(signs_[1] * port.force.pitch_nm)
            .add_scaled(signs_[2] * port.force.depth_n)
            .add_scaled(signs_[3] * port.force.yaw_nm);
        port.say(now_ns_, line.text(), answers);
    }

    void hear_box(int64_t t_ns) noexcept {
        std::array<int, kMaxAnswers> v{};
        if (box_ && box_->hear(t_ns, v)) {
            for (size_t i = 0; i < openings_.size(); ++i) openings_[i] = v[i] / kScale;
            pedals_ = static_cast<uint8_t>((v[6] != 0 ? sim::kPedalCut : 0) |
                                           (v[7] != 0 ? sim::kPedalCoag : 0));
        }
    }

    std::vector<sim::Hand> hands_;
    double depth_zero_m_;
    std::array<int, 4> signs_{1, 1, 1, 1};
    std::vector<std::unique_ptr<HapticBenchDevice>> ports_;
    std::unique_ptr<Talker> box_;
    std::vector<RcmMap> maps_;
    std::array<double, 6> openings_{};
    uint8_t pedals_ = 0;
    int64_t now_ns_ = 0;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_avatar(const DeviceConfig& config) {
    const std::string right = config.station.text("avatar.right");
    const std::string left = config.station.text("avatar.left");
    if (right.empty() && left.empty())
        throw DeviceError("avatar: neither avatar.right nor avatar.left names a serial port");
    if (right == left) throw DeviceError("avatar: avatar.right and avatar.left are both " + right);
    std::vector<sim::Hand> hands;
    std::vector<std::string> paths;
    if (!right.empty()) {
        hands.push_back(sim::Hand::kRight);
        paths.push_back(right);
    }
    if (!left.empty()) {
        hands.push_back(sim::Hand::kLeft);
        paths.push_back(left);
    }
    return std::make_unique<AvatarDevice>(config, hands, paths);
}

}  // namespace placode::haptics
