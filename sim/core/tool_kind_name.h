// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kinds of instruments by the names that scene files, the C interface and review tracks have for
// them.

#include "sim/core/tool.h"

namespace placode::sim {

[[nodiscard]] constexpr const char* tool_kind_name(ToolKind kind) noexcept {
    switch (kind) {
        case ToolKind::kScope:
            return "scope";
        case ToolKind::kNeedle:
            return "needle";
        case ToolKind::kHook:
            return "hook";
        case ToolKind::kGrasper:
            return "grasper";
        case ToolKind::kScissors:
            return "scissors";
        case ToolKind::kProbe:
            return "probe";
        case ToolKind::kNeedleDriver:
            return "needle_driver";
        case ToolKind::kIrrigator:
            return "irrigator";
    }
    return "";
}

}  // namespace placode::sim
