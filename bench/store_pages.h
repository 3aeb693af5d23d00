// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What every page asks of a store with many people and attempts, and how long the answer takes.

#include <functional>
#include <string>
#include <vector>

#include "db/load_generator.h"
#include "db/store.h"

namespace placode::bench {

inline constexpr double kPageLimitMs = 300, kReportLimitMs = 5000, kMemoryLimitMb = 500,
                        kCheckLimitMs = 60000;

struct PageRow {
    std::string page, query;
    int64_t rows = 0;
    double first_ms = 0, median_ms = 0, worst_ms = 0, limit_ms = kPageLimitMs;
    /// Of this process, median: what a page costs, whoever else uses the machine. A PostgreSQL
    /// server's part is not in it.
    double processor_ms = 0;
    [[nodiscard]] bool kept() const { return worst_ms <= limit_ms; }
};

/// Largest resident memory of this process since forget_peak() [MB].
[[nodiscard]] double peak_memory_mb();
/// What was done before is no page's memory.
void forget_peak();

/// Attempts of scripted operators of three levels, recorded, measured, scored and saved, for
/// db::generate_load() to multiply. `begun` is told each. False, and nothing done, where the store
/// has people: copies are not for a real one. @param folder for recordings on their way.
[[nodiscard]] bool simulate_attempts(db::Store& store, double seconds, const std::string& folder,
                                     const std::function<void(const std::string&)>& begun);

class StorePages {
 public:
    /// `measured` is told every row as it comes.
    StorePages(db::Store& store, int runs, std::function<void(const PageRow&)> measured)
        : store_(store), runs_(runs), measured_(std::move(measured)) {}

    void pages(const db::LoadResult& load);
    /// @param folder for the PDF files.
    void reports(const db::LoadResult& load, const std::string& folder);
    /// The trail and every seal, once.
    void check();

    std::vector<PageRow> rows;

 private:
    /// `ask` returns how many rows the answer has.
    template <class Ask>
    void measure(const char* page, const char* query, double limit_ms, Ask&& ask);

    db::Store& store_;
    int runs_;
    std::function<void(const PageRow&)> measured_;
};

}  // namespace placode::bench
