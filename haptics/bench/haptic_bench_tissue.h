// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A block of tissue below one tool, for the bench of the haptic port: the solver that an attempt
// runs, on a small mesh.

#include <memory>

#include "sim/step/step.h"

namespace placode::haptics {

class HapticBenchTissue {
 public:
    /// Block of 8 x 8 x 3 mm with its top at z = 0, its bottom held, frames of `frame_s`.
    HapticBenchTissue(const sim::ToolSpec& tool, double youngs_modulus_pa, double frame_s);
    ~HapticBenchTissue();
    HapticBenchTissue(HapticBenchTissue&&) noexcept;
    HapticBenchTissue& operator=(HapticBenchTissue&&) noexcept;
    /// One frame with the hand's input.
    void frame(const sim::ToolInput& input, sim::ToolFeedback& feedback);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace placode::haptics
