// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The scripted operators as policies of an environment: they see what they see in placode-sim and
// answer with actions.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "environment/environment.h"
#include "haptics/device.h"

namespace placode::environment {

class Expert {
 public:
    /// @param level "expert", "intermediate" or "novice". Throws EnvironmentError.
    Expert(const Environment& environment, const std::string& level, uint64_t seed);
    ~Expert();

    /// What the operator does in the next `frames` frames, in absolute units (hands.h), whatever
    /// the environment's own units are. True = the operator is done with the task. An operator does
    /// not go back with a restored moment: make a new one.
    [[nodiscard]] bool act(Environment& environment, int frames, std::span<double> actions);

 private:
    std::unique_ptr<haptics::DeviceGroup> device_;
    std::vector<haptics::Trocar> trocars_;
    std::vector<haptics::DeviceState> states_;
    int64_t now_ns_ = 0;
};

}  // namespace placode::environment
