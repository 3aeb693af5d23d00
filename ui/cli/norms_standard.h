// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// placodectl norms standard: the pass mark that parts two groups.

#include "ui/cli/cli.h"

namespace placode::cli {

void add_norms_standard_command(CLI::App& norms, Context& context);

}  // namespace placode::cli
