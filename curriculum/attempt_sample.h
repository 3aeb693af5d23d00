// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the ledger keeps of an attempt every 10 ms, of the tissue's side. Private to curriculum.

#include <span>

#include "sim/step/recording.h"
#include "sim/step/step.h"

namespace placode::curriculum {

/// True when the tip of tool `tool` lies inside the scope's picture; true without a scope.
[[nodiscard]] bool tip_in_view(const sim::Scene& scene, const sim::State& state,
                               size_t tool) noexcept;

/// The state after a frame with these inputs. Left to the caller: cut_fraction and step_flags,
/// which are of the whole time since the last sample.
[[nodiscard]] sim::Sample sample_of(const sim::Scene& scene, const sim::State& state,
                                    std::span<const sim::ToolInput> inputs) noexcept;

}  // namespace placode::curriculum
