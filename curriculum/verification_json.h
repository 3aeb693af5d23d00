// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Verification scenes as JSON. Keys and defaults stand in docs/verification-scenes.md; an unknown
// key, a wrong type or a value out of range is named with its JSON pointer.

#include <string>

#include "curriculum/definitions.h"
#include "sim/verify/verification_scene.h"

namespace placode::curriculum {

/// Reads a scene file; mesh files are looked for beside it. @throws DefinitionError, also for a
/// mesh that cannot be used.
[[nodiscard]] sim::VerificationScene load_verification_scene(const std::string& file);

/// The same from text. `origin` is used in messages, `folder` is where mesh files are looked for.
[[nodiscard]] sim::VerificationScene verification_scene_from_json(const std::string& text,
                                                                  const std::string& origin,
                                                                  const std::string& folder);

/// solve() with its refusals as DefinitionError of `origin`.
[[nodiscard]] sim::SolveResult solve_verification_scene(const sim::VerificationScene& scene,
                                                        const std::string& origin,
                                                        const sim::SolveWatch& watch = {});

}  // namespace placode::curriculum
