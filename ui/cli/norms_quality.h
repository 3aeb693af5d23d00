// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// placodectl norms quality: what each metric is worth, and whether the score tells known groups
// apart.

#include <string>

#include "ui/cli/cli.h"

namespace placode::cli {

struct QualityOptions {
    std::string task, novices, intermediates, experts;  ///< Groups of the store.
    /// Folder with recordings of scripted operators: then the level is the operator's, a person is
    /// a seed, and the score is that of the present rubric.
    std::string recordings;
    std::string batch;  ///< Folder of a batch of rollouts with metrics, likewise.
    int repeats = 2;
};

void add_norms_quality_command(CLI::App& norms, Context& context);

}  // namespace placode::cli
