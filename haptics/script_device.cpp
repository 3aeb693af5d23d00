// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators as a device: they hold the handles outside the ports like a human, and see
// what a person sees on the screen. In step with the simulation, seeded, deterministic. Which
// operator it is follows from the instruments: a needle makes the ring, a grasper lifts, grasper
// and scissors resect, all three do the whole dissection.
#include <algorithm>
#include <cmath>

#include "haptics/lift_operator.h"
#include "haptics/operator_model.h"
#include "haptics/practice_operator.h"
#include "haptics/resection_operator.h"
#include "haptics/trocar.h"

namespace placode::haptics {

namespace {

constexpr double kRollRadS = 4;  // fingers turn the handle no faster

/// The ring operator as one of several.
class RingOperator final : public ScriptedOperator {
 public:
    RingOperator(OperatorLevel level, uint64_t seed, size_t tool, const Vec3& home_m)
        : model_(operator_profile(level), seed, home_m), tool_(tool) {}
    void see(const Perception& seen) override {
        model_.see(seen, tool_ < seen.tools.size() ? seen.tools[tool_] : sim::ToolFeedback{});
    }
    [[nodiscard]] bool act(double dt_s, std::span<HandAction> hands) noexcept override {
        const OperatorAction action = model_.act(dt_s);
        hands[tool_].tip_m = action.tip_m;
        hands[tool_].pedals = action.pedals;
        hands[tool_].engaged = true;
        return action.finish;
    }

 private:
    OperatorModel model_;
    size_t tool_;
};

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
        ResectionTools tools;
        int first = -1;  // the needle if there is one, else the first that is no scope
        for (int i = static_cast<int>(count_) - 1; i >= 0; --i) {
            const sim::ToolKind kind = config.tools[static_cast<size_t>(i)].kind;
            if (kind == sim::ToolKind::kNeedle) tools.needle = i;
            if (kind == sim::ToolKind::kScissors) tools.scissors = i;
            if (kind == sim::ToolKind::kGrasper) tools.grasper = i;
            if (kind != sim::ToolKind::kScope) first = i;
        }
        if (tools.needle >= 0) first = tools.needle;
        if (first < 0) first = 0;
        const auto home = [&](int i) { return homes[static_cast<size_t>(i)]; };
        if (config.practice) {
            operator_ = std::make_unique<PracticeOperator>(level, config.seed, config.tools, homes);
        } else if (tools.scissors >= 0 && tools.grasper >= 0) {
            operator_ =
                std::make_unique<ResectionOperator>(level, config.seed, tools, config.tools, homes);
        } else if (tools.grasper >= 0 && tools.needle < 0) {
            operator_ = std::make_unique<LiftOperator>(
                level, config.seed, static_cast<size_t>(tools.grasper), home(tools.grasper));
        } else {
            operator_ = std::make_unique<RingOperator>(level, config.seed,
                                                       static_cast<size_t>(first), home(first));
        }
        // An instrument that shares its port with another waits outside.
        for (size_t i = 0; i < count_; ++i) {
            bool shares = false;
            for (size_t k = 0; k < count_; ++k) {
                shares = shares || (k != i && config.tools[k].hand == config.tools[i].hand);
            }
            shares_port_.push_back(shares);
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
        if (hands_[i].opening.norm() < 1e-6) return rolls_[i];
        DeviceState straight;
        straight.position_m = position_m;
        const sim::Pose pose = trocars_[i].tip_pose(straight);
        const Vec3 wanted = hands_[i].opening.normalized();
        const double x = wanted.dot(pose.q * Vec3::UnitX()), y = wanted.dot(pose.q * Vec3::UnitY());
        double turn = std::atan2(-x, y) - rolls_[i];
        constexpr double half = 3.14159265358979323846;
        while (turn > half / 2) turn -= half;
        while (turn < -half / 2) turn += half;
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
