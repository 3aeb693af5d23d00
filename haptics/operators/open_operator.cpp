// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/operators/open_operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/operators/handover_operator.h"
#include "haptics/operators/irrigate_operator.h"
#include "haptics/operators/lift_operator.h"
#include "haptics/operators/operator_model.h"
#include "haptics/operators/patch_operator.h"
#include "haptics/operators/practice_operator.h"
#include "haptics/operators/resection_operator.h"
#include "haptics/operators/suture_operator.h"
#include "haptics/operators/undermine_operator.h"
#include "haptics/operators/wound_operator.h"

namespace placode::haptics {

namespace {

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

}  // namespace

std::unique_ptr<ScriptedOperator> open_operator(const DeviceConfig& config, OperatorLevel level,
                                                std::span<const Vec3> homes_m) {
    ResectionTools tools;
    int first = -1;  // the needle if there is one, else the first that is no scope
    for (int i = static_cast<int>(config.tools.size()) - 1; i >= 0; --i) {
        const sim::ToolKind kind = config.tools[static_cast<size_t>(i)].kind;
        if (kind == sim::ToolKind::kNeedle) tools.needle = i;
        if (kind == sim::ToolKind::kScissors) tools.scissors = i;
        if (kind == sim::ToolKind::kGrasper) tools.grasper = i;
        if (kind != sim::ToolKind::kScope) first = i;
    }
    if (tools.needle >= 0) first = tools.needle;
    const auto hand = static_cast<size_t>(std::max(first, 0));
    std::vector<size_t> drivers, spreading;
    for (size_t i = 0; i < config.tools.size(); ++i) {
        if (config.tools[i].kind == sim::ToolKind::kNeedleDriver) drivers.push_back(i);
        if (config.tools[i].jaws_spread) spreading.push_back(i);
    }
    if (drivers.size() == 2)
        return std::make_unique<HandoverOperator>(
            level, config.seed, std::array{drivers[0], drivers[1]}, config.tools, homes_m);
    if (!drivers.empty() && spreading.size() == 2)
        return std::make_unique<WoundOperator>(level, config.seed,
                                               WoundTools{{spreading[0], spreading[1]}, drivers[0]},
                                               config.tools, homes_m);
    if (!drivers.empty())
        return std::make_unique<SutureOperator>(level, config.seed, drivers[0],
                                                config.tools[drivers[0]], homes_m[drivers[0]]);
    for (size_t i = 0; i < config.tools.size(); ++i)
        if (config.tools[i].kind == sim::ToolKind::kIrrigator)
            return std::make_unique<IrrigateOperator>(level, config.seed, i, config.tools[i],
                                                      homes_m[i]);
    if (config.patch && tools.grasper >= 0) {
        const auto grasper = static_cast<size_t>(tools.grasper);
        return std::make_unique<PatchOperator>(level, config.seed, grasper, homes_m[grasper]);
    }
    if (spreading.size() == 2)
        return std::make_unique<UndermineOperator>(
            level, config.seed, std::array{spreading[0], spreading[1]}, config.tools, homes_m);
    if (config.practice) {
        return std::make_unique<PracticeOperator>(level, config.seed, config.tools, homes_m);
    }
    if (tools.scissors >= 0 && tools.grasper >= 0) {
        return std::make_unique<ResectionOperator>(level, config.seed, tools, config.tools,
                                                   homes_m);
    }
    if (tools.grasper >= 0 && tools.needle < 0) {
        const auto grasper = static_cast<size_t>(tools.grasper);
        return std::make_unique<LiftOperator>(level, config.seed, grasper, homes_m[grasper]);
    }
    return std::make_unique<RingOperator>(level, config.seed, hand, homes_m[hand]);
}

double turn_to_open_along(const Vec3& opening, const sim::Pose& straight,
                          double roll_rad) noexcept {
    if (opening.norm() < 1e-6) return 0;
    const Vec3 wanted = opening.normalized();
    const double x = wanted.dot(straight.q * Vec3::UnitX()),
                 y = wanted.dot(straight.q * Vec3::UnitY());
    double turn = std::atan2(-x, y) - roll_rad;
    constexpr double half = std::numbers::pi;
    while (turn > half / 2) turn -= half;
    while (turn < -half / 2) turn += half;
    return turn;
}

double turn_to_lie_along(const Vec3& across, const sim::Pose& straight, double roll_rad) noexcept {
    const double x = across.dot(straight.q * Vec3::UnitX()),
                 y = across.dot(straight.q * Vec3::UnitY());
    if (x * x + y * y < 1e-12 * across.squaredNorm()) return 0;
    return std::remainder(std::atan2(y, x) - roll_rad, 2 * std::numbers::pi);
}

}  // namespace placode::haptics
