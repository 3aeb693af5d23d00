// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `placodectl rescore` and `placodectl batch keep` print: each attempt's scores side by side.

#include "db/rescore.h"
#include "ui/cli/cli.h"

namespace placode::cli {

/// Rescores with `options`, shows `doing` with its progress, and prints what came of it. Ctrl+C
/// stops it where the caller waits for that (CancelOn). Returns the exit status.
/// @throws InputError for what the store calls a conflict.
int run_rescoring(const Context& context, db::Store& store, const curriculum::Task& task,
                  db::RescoreOptions options, const std::string& doing);

}  // namespace placode::cli
