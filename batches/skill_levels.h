// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Attempts by level of skill, out of recordings or rollouts of scripted operators: the level is the
// operator's, a person is a seed.

#include <filesystem>
#include <string>

#include "db/norm_bands.h"

namespace placode::batches {

struct SkillLevels {
    db::LevelAttempts novices, intermediates, experts;
    int not_attempted = 0;  ///< Attempts in which nothing was tried: in no level.
};

/// Recordings (*.placode) of a folder that scripted operators made of this task; others are passed
/// over. Metrics are computed, and the score is that of the present rubric.
/// @throws StoreError for what cannot be read, std::filesystem::filesystem_error for the folder,
///         DefinitionError for the task.
[[nodiscard]] SkillLevels levels_of_recordings(const std::string& task,
                                               const std::filesystem::path& folder);
/// Rollouts of a batch, likewise, as they were scored there. Throws as scores_of_rollouts().
[[nodiscard]] SkillLevels levels_of_rollouts(const std::string& task,
                                             const std::filesystem::path& folder);

}  // namespace placode::batches
