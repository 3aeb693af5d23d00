// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Attempts by level of skill, out of the store, of recordings or of a batch.

#include "db/norm_bands.h"
#include "ui/cli/norms_quality.h"

namespace placode::cli {

struct Levels {
    db::LevelAttempts novices, intermediates, experts;
    int not_attempted = 0;
};

/// Groups of the store.
[[nodiscard]] Levels levels_of_store(const Context& context, const QualityOptions& options);
/// Recordings of scripted operators: the level is the operator's, a person is a seed, and the score
/// is that of the present rubric.
[[nodiscard]] Levels levels_of_recordings(const QualityOptions& options);
/// Rollouts of scripted operators in a batch, likewise.
[[nodiscard]] Levels levels_of_batch(const QualityOptions& options);

}  // namespace placode::cli
