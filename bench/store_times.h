// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A store with many people and attempts: filled, and every page, report and window timed.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/shell_pages.h"
#include "bench/store_pages.h"
#include "db/load_generator.h"

namespace placode::bench {

/// What the store is filled with, and what is measured.
struct StoreBenchOrder {
    int users = 1000;
    int64_t attempts = 100000;
    int runs = 5;            ///< Of each query.
    double simulate_s = 20;  ///< Of each attempt that is multiplied.
    bool sealed = false;     ///< Seals every attempt and times the check of all seals.
    bool shell = true;       ///< Opens the pages of the shell as well.
};

/// Told how far it is.
struct StoreBenchWatcher {
    std::function<void(const std::string& attempt)> simulating;
    std::function<void(int64_t done, int64_t total)> multiplying;
    std::function<void()> filled;
    std::function<void(const PageRow&)> measured;
};

struct StoreTimes {
    db::LoadResult load;
    double fill_s = 0;
    /// Largest resident memory before the pages, with them, and with reports [MB].
    double before_mb = 0, pages_mb = 0, memory_mb = 0;
    std::vector<PageRow> rows;  ///< Pages of the shell are among them.
    ShellPages shell;

    /// Every time and all memory within its limit.
    [[nodiscard]] bool kept() const;
};

/// Nothing, and nothing done, where the store has people: copies are not for a real one.
/// @param folder  For files on their way. Throws StoreError.
[[nodiscard]] std::optional<StoreTimes> time_store(const std::string& url,
                                                   const StoreBenchOrder& order,
                                                   const std::string& folder,
                                                   const StoreBenchWatcher& watcher);

}  // namespace placode::bench
