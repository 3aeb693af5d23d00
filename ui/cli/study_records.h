// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// placodectl study ...: care of the data and analyses, beside study_commands.cpp.

#include "ui/cli/cli.h"

namespace placode::cli {

/// lock, sign, unlock, correct, second-entry, differences, decide
void add_study_record_commands(CLI::App& study, Context& context);
/// repeat, note, deviations
void add_study_repeat_commands(CLI::App& study, Context& context);
/// key-make, key-list, key-set, key-passphrase
void add_study_key_commands(CLI::App& study, Context& context);
/// retention
void add_study_retention_command(CLI::App& study, Context& context);
/// construct, retest, learning, raters
void add_study_analysis_commands(CLI::App& study, Context& context);

}  // namespace placode::cli
