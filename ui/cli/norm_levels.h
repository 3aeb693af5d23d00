// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Attempts by level of skill, from where the command says.

#include "batches/skill_levels.h"
#include "ui/cli/norms_quality.h"

namespace placode::cli {

/// Groups of the store, recordings of scripted operators, or rollouts of a batch. Throws InputError
/// for what cannot be read.
[[nodiscard]] batches::SkillLevels norm_levels(const Context& context,
                                               const QualityOptions& options);

}  // namespace placode::cli
