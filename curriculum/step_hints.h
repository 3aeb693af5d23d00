// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a step of practice is done with the device at hand, in words. A task may say it better for
// one of its steps; what it leaves out stands here, so that nobody is left without a hint.

#include <string>

#include "curriculum/task.h"

namespace placode::curriculum {

/// For a device as on the command line. `changes_hand`: the step before was for the other hand.
/// Empty for devices without hands (scripts) and for steps that this device cannot do.
[[nodiscard]] LocalText step_hint(const TaskStep& step, const std::string& device,
                                  bool changes_hand);

}  // namespace placode::curriculum
