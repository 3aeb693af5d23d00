// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A task in a changed scene: another mesh, fewer substeps, other tissue. For studies of parameters.

#include <string>

#include "curriculum/task.h"

namespace placode::curriculum {

/// `changes_json` is merged (RFC 7396) into the task's resolved scene, e.g.
/// {"edge_ring_m": 0.001, "solver": {"substeps": 2}}. Throws DefinitionError naming the key.
[[nodiscard]] Task with_scene_changes(const Task& task, const std::string& changes_json);

}  // namespace placode::curriculum
