// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/cli/cli.h"

namespace placode::cli {

void add_dataset_command(CLI::App& app, Context& context);

}  // namespace placode::cli
