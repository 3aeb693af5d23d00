// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scripts with which other programs run the shards of a batch.

#include <filesystem>
#include <string>
#include <vector>

#include "batches/manifest.h"

namespace placode::batches {

/// Slurm's array names the shards that `missing` names, where it can name them all.
/// @param runner "slurm" (a job array, for sbatch) or "parallel" (GNU parallel).
/// @param program placodectl, as the nodes find it. @param jobs at the same time; 0 = as many as
/// the runner likes.
[[nodiscard]] std::string runner_script(const std::string& runner, const Manifest& manifest,
                                        const std::filesystem::path& folder,
                                        const std::string& program, int jobs,
                                        const std::vector<int>& missing);

}  // namespace placode::batches
