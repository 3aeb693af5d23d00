// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The commands that verify the solver and what hangs on it.

#include "ui/cli/cli.h"

namespace placode::cli {

void add_solve_command(CLI::App& app, Context& context);
/// `bench accuracy`.
void add_accuracy_command(CLI::App& bench, Context& context);
/// `bench closed-forms`.
void add_closed_forms_command(CLI::App& bench, Context& context);
/// `bench environment`.
void add_environment_command(CLI::App& bench, Context& context);
/// `bench haptics`.
void add_haptics_bench_command(CLI::App& bench, Context& context);

}  // namespace placode::cli
