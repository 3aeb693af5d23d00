// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the commands of `placodectl batch` share.

#include "batches/batch_error.h"
#include "ui/cli/cli.h"

namespace placode::cli {

void add_batch_commands(CLI::App& app, Context& context);
void add_bench_tasks_command(CLI::App& bench, Context& context);
void add_batch_forecast_command(CLI::App& batch, Context& context);
void add_batch_keep_command(CLI::App& batch, Context& context);
void add_batch_plan_command(CLI::App& batch, Context& context);
void add_batch_queue_commands(CLI::App& batch, Context& context);

/// A batch's refusal of what it was given is bad input.
template <class Work>
auto of_batch(Work&& work) {
    try {
        return work();
    } catch (const batches::BatchError& error) {
        if (error.kind() == batches::BatchError::Kind::kBadInput) throw InputError(error.what());
        throw;
    }
}

}  // namespace placode::cli
