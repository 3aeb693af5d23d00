// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators as a device: they hold the handles outside the ports like a human, and see
// what a person sees on the screen. In step with the simulation, seeded, deterministic.
#include <algorithm>
#include <cmath>

#include "haptics/operators/open_operator.h"
#include "haptics/trocar.h"

namespace placode::haptics {

namespace {

constexpr double kRollRadS = 4;  // fingers turn the handle no faster

class ScriptDevice final : public DeviceGroup {
 public:
    ScriptDevice(const DeviceConfig& config, OperatorLevel level)
        : level_(level), count_(config.tools.size()), hands_(count_), rolls_(count_, 0.0) {
        const auto settings = default_trocars(config.tools, config.name);
        std::vector<Vec3> homes;
        for (size_t i = 0; i < count_; ++i) {
            trocars_.emplace_back(config.tools[i], settings[i]);
            homes.push_back(settings[i].home_tip_m);
            last_position_.push_back(trocars_[i].device_position(homes[i]));
        }
        operator_ = open_operator(config, level, homes);
        // An instrument that shares its port with another waits outside.
        for (size_t i = 0; i < count_; ++i) {
            shares_port_.push_back(others_in_port(config.tools, i) != 0);
        }
    }

    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        DeviceInfo device;
        device.vendor = "Placode";
        device.model = "script:" + std::string(operator_name(level_));
        device.driver = "script";
        device.dof_sensed = 5;
        return std::vector<DeviceInfo>(count_, device);
    }

    void perceive(const Perception& seen) noexcept override { operator_->see(seen); }

    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        const double dt = sequence_ > 0 ? static_cast<double>(t_ns - last_ns_) * 1e-9 : 0.0;
        last_ns_ = t_ns;
        ++sequence_;
        for (HandAction& hand : hands_) hand = {};
        const bool finish = operator_->act(dt, hands_);
        for (size_t i = 0; i < std::min(states.size(), count_); ++i) {
            DeviceState& out = states[i];
            out = {};  // The other hands, the scope's too, stay at home.
            out.sequence = sequence_;
            out.t_ns = t_ns;
            out.finish = finish;
            out.engaged = hands_[i].engaged || !shares_port_[i];
            if (!hands_[i].engaged) {
                last_position_[i] = out.position_m;
                continue;
            }
            out.position_m = trocars_[i].device_position(hands_[i].tip_m);
            if (dt > 0 && was_engaged_[i]) {
                out.velocity_m_s = (out.position_m - last_position_[i]) / dt;
            }
            out.pedals = hands_[i].pedals;
            out.jaw_rad = hands_[i].jaw_rad;
            out.roll_rad = roll(i, out.position_m, dt);
            last_position_[i] = out.position_m;
        }
        for (size_t i = 0; i < count_; ++i) was_engaged_[i] = hands_[i].engaged;
    }

    void write(std::span<const DeviceCommand>) noexcept override {}
    [[nodiscard]] bool lock_step() const noexcept override { return true; }

 private:
    /// Turns the handle until the jaws open in the wanted direction; either way round is the same.
    double roll(size_t i, const Vec3& position_m, double dt) noexcept {
        const bool across = hands_[i].across.norm() > 1e-6;
        if (!across && hands_[i].opening.norm() < 1e-6) return rolls_[i];
        DeviceState straight;
        straight.position_m = position_m;
        const sim::Pose pose = trocars_[i].tip_pose(straight);
        const double turn = across ? turn_to_lie_along(hands_[i].across, pose, rolls_[i])
                                   : turn_to_open_along(hands_[i].opening, pose, rolls_[i]);
        rolls_[i] += std::clamp(turn, -kRollRadS * dt, kRollRadS * dt);
        return rolls_[i];
    }

    OperatorLevel level_;
    size_t count_;
    std::vector<Trocar> trocars_;
    std::vector<HandAction> hands_;
    std::vector<double> rolls_;
    std::vector<Vec3> last_position_;
    std::vector<bool> shares_port_;
    std::array<bool, sim::kMaxTools> was_engaged_{};
    std::unique_ptr<ScriptedOperator> operator_;
    int64_t last_ns_ = 0;
    uint64_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_script(const DeviceConfig& config, OperatorLevel level) {
    return std::make_unique<ScriptDevice>(config, level);
}

}  // namespace placode::haptics
