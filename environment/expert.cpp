// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "environment/expert.h"

#include <algorithm>
#include <cmath>

#include "haptics/catalogue/open_device.h"
#include "haptics/operators/operator_profile.h"

namespace placode::environment {

Expert::Expert(const Environment& environment, const std::string& level, uint64_t seed) {
    if (!haptics::operator_level(level))
        throw EnvironmentError(
            EnvironmentError::Kind::kBadArgument,
            "no operator \"" + level + "\"; expected expert, intermediate or novice");
    const curriculum::Task& task = environment.task();
    haptics::DeviceConfig config;
    config.name = "script:" + level;
    config.seed = seed;
    config.tools = task.scene.tools;
    config.frame_s = task.scene.solver.frame_s;
    config.practice = !task.steps.empty();
    config.patch = curriculum::lays_patch(task);
    device_ = haptics::open_device(config);
    for (const auto& settings : haptics::default_trocars(config.tools, config.name))
        trocars_.emplace_back(config.tools[trocars_.size()], settings);
    states_.resize(config.tools.size());
}

Expert::~Expert() = default;

bool Expert::act(Environment& environment, int frames, std::span<double> actions) {
    if (actions.size() != states_.size() * kActionSize)
        throw EnvironmentError(EnvironmentError::Kind::kBadArgument,
                               "room for " + std::to_string(actions.size()) +
                                   " numbers; an action has " +
                                   std::to_string(states_.size() * kActionSize));
    // What a hand wants at the end of each frame; the last one is where it goes.
    const double frame_s = environment.task().scene.solver.frame_s;
    device_->perceive(environment.look());
    bool done = false;
    for (int f = 0; f < std::max(1, frames); ++f) {
        device_->read(now_ns_, states_);
        now_ns_ += std::llround(frame_s * 1e9);
        for (size_t i = 0; i < states_.size(); ++i) done = done || states_[i].finish;
    }
    for (size_t i = 0; i < states_.size(); ++i) {
        const haptics::DeviceState& state = states_[i];
        const sim::Pose tip = trocars_[i].tip_pose(state);
        double* action = &actions[i * kActionSize];
        for (int k = 0; k < 3; ++k) action[k] = tip.p[k];
        action[3] = state.roll_rad;
        action[4] = state.jaw_rad;
        action[5] = (state.pedals & sim::kPedalCut) != 0 ? 1 : 0;
        action[6] = (state.pedals & sim::kPedalCoag) != 0 ? 1 : 0;
        action[7] = state.engaged ? 1 : 0;
    }
    return done;
}

}  // namespace placode::environment
