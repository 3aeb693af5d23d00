// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How long the pages of the shell take: `placode --time-pages` in a process of its own, so that its
// memory is its own as well.

#include <string>
#include <vector>

#include "db/store.h"

namespace placode::bench {

struct ShellPage {
    std::string who, page;
    double first_ms = 0, median_ms = 0, worst_ms = 0;  ///< From the click to the painted page.
    double processor_ms = 0, complete_ms = 0;
};

struct ShellPages {
    std::vector<ShellPage> pages;
    double peak_memory_mb = 0;
    std::string problem;  ///< Why nothing was measured; empty: it was.
};

/// Opens every page as somebody with every role, and as this trainee, who gets a new password: only
/// for a store made to be measured. Needs the program placode beside this one.
[[nodiscard]] ShellPages time_shell_pages(const std::string& store_url, db::Store& store,
                                          int64_t trainee);

}  // namespace placode::bench
