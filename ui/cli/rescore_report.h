// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What `placodectl rescore` and `placodectl batch keep` print: each attempt's scores side by side.

#include "db/rescore.h"
#include "ui/cli/cli.h"

namespace placode::cli {

struct RescoreRun {
    bool dry_run = false, stopped = false;
};

void print_rescores(const Context& context, const curriculum::Task& task,
                    const std::vector<db::RescoreOutcome>& outcomes, const RescoreRun& run);

}  // namespace placode::cli
