// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// placodectl norms key ...

#include "ui/cli/cli.h"

namespace placode::cli {

void add_norms_key_commands(CLI::App& norms, Context& context);

}  // namespace placode::cli
