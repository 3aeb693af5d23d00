// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/store_times.h"

#include <algorithm>
#include <chrono>

#include "db/store.h"

namespace placode::bench {
namespace {

using Clock = std::chrono::steady_clock;

std::optional<db::LoadResult> fill(const std::string& url, const StoreBenchOrder& asked,
                                   const std::string& folder, const StoreBenchWatcher& watcher) {
    {
        const auto store = db::open_store(url);
        store->act_as("bench store");
        if (!simulate_attempts(*store, asked.simulate_s, folder, watcher.simulating))
            return std::nullopt;
    }
    db::LoadOrder order;
    order.users = asked.users;
    order.attempts = asked.attempts;
    order.sealed = asked.sealed;
    order.progress = [&watcher](int64_t done, int64_t total) {
        watcher.multiplying(done, total);
        return true;
    };
    const db::LoadResult load = db::generate_load(url, order);
    watcher.filled();
    return load;
}

}  // namespace

bool StoreTimes::kept() const {
    return memory_mb <= kMemoryLimitMb && shell.peak_memory_mb <= kMemoryLimitMb &&
           std::all_of(rows.begin(), rows.end(), [](const PageRow& row) { return row.kept(); });
}

std::optional<StoreTimes> time_store(const std::string& url, const StoreBenchOrder& order,
                                     const std::string& folder, const StoreBenchWatcher& watcher) {
    StoreTimes times;
    const auto start = Clock::now();
    const auto load = fill(url, order, folder, watcher);
    if (!load) return std::nullopt;
    times.load = *load;
    times.fill_s = std::chrono::duration<double>(Clock::now() - start).count();
    const auto store = db::open_store(url);
    store->act_as("bench store");
    forget_peak();
    times.before_mb = peak_memory_mb();
    StorePages measured(*store, order.runs, watcher.measured);
    measured.pages(times.load);
    times.pages_mb = peak_memory_mb();
    measured.reports(times.load, folder);
    times.memory_mb = peak_memory_mb();
    if (order.sealed) measured.check();
    if (order.shell)
        times.shell = time_shell_pages(url, *store, times.load.first_user + times.load.users / 2);
    for (const ShellPage& each : times.shell.pages)
        measured.rows.push_back({"Shell: " + each.page, "opened by " + each.who, 1, each.first_ms,
                                 each.median_ms, each.worst_ms, kPageLimitMs, each.processor_ms});
    times.rows = measured.rows;
    return times;
}

}  // namespace placode::bench
