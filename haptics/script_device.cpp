// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted operators as a device: they hold the handle outside the port like a human, and see what
// a person sees on the screen. In step with the simulation, seeded, deterministic.
#include <algorithm>

#include "haptics/operator_model.h"
#include "haptics/trocar.h"

namespace placode::haptics {

namespace {

class ScriptDevice final : public DeviceGroup {
 public:
    ScriptDevice(const DeviceConfig& config, OperatorLevel level)
        : level_(level), count_(config.tools.size()) {
        // The needle if there is one, else the first instrument that is no scope.
        for (size_t i = count_; i-- > 0;)
            if (config.tools[i].kind != sim::ToolKind::kScope) hand_ = i;
        for (size_t i = count_; i-- > 0;)
            if (config.tools[i].kind == sim::ToolKind::kNeedle) hand_ = i;
        const auto trocars = default_trocars(config.tools, config.name);
        trocar_ = std::make_unique<Trocar>(config.tools[hand_], trocars[hand_]);
        model_ = std::make_unique<OperatorModel>(operator_profile(level), config.seed,
                                                 trocars[hand_].home_tip_m);
    }

    [[nodiscard]] std::vector<DeviceInfo> info() const override {
        DeviceInfo device;
        device.vendor = "Placode";
        device.model = "script:" + std::string(operator_name(level_));
        device.driver = "script";
        device.dof_sensed = 4;
        return std::vector<DeviceInfo>(count_, device);
    }

    void perceive(const Perception& seen) noexcept override {
        model_->see(seen, hand_ < seen.tools.size() ? seen.tools[hand_] : sim::ToolFeedback{});
    }

    void read(int64_t t_ns, std::span<DeviceState> states) noexcept override {
        const double dt = sequence_ > 0 ? static_cast<double>(t_ns - last_ns_) * 1e-9 : 0.0;
        last_ns_ = t_ns;
        ++sequence_;
        const OperatorAction action = model_->act(dt);
        const Vec3 position = trocar_->device_position(action.tip_m);
        for (size_t i = 0; i < std::min(states.size(), count_); ++i) {
            DeviceState& out = states[i];
            out = {};  // The other hands, the scope's too, stay at home.
            out.sequence = sequence_;
            out.t_ns = t_ns;
            out.finish = action.finish;
            if (i != hand_) continue;
            out.position_m = position;
            if (dt > 0) out.velocity_m_s = (position - last_position_) / dt;
            out.pedals = action.pedals;
        }
        last_position_ = position;
    }

    void write(std::span<const DeviceCommand>) noexcept override {}
    [[nodiscard]] bool lock_step() const noexcept override { return true; }

 private:
    OperatorLevel level_;
    size_t count_, hand_ = 0;
    std::unique_ptr<Trocar> trocar_;
    std::unique_ptr<OperatorModel> model_;
    int64_t last_ns_ = 0;
    uint64_t sequence_ = 0;
    Vec3 last_position_ = Vec3::Zero();
};

}  // namespace

std::unique_ptr<DeviceGroup> open_script(const DeviceConfig& config, OperatorLevel level) {
    return std::make_unique<ScriptDevice>(config, level);
}

}  // namespace placode::haptics
