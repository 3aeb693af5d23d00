// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long an attempt at a task usually takes: one that ends much earlier ends by mistake.

#include "curriculum/task.h"

namespace placode::curriculum {

/// The rubric's target time [s], else ten seconds a step, else half of the limit.
[[nodiscard]] double usual_time_s(const Task& task);

}  // namespace placode::curriculum
