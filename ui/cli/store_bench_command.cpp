// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench store: what every page asks of a store with 1,000 people and
// 100,000 attempts, and how long the answer takes.

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include "bench/store_times.h"
#include "ui/cli/cli.h"
#include "ui/cli/progress.h"
#include "ui/cli/scratch_folder.h"
#include "ui/cli/write_file.h"
#include "ui/finite_range.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;
using bench::kMemoryLimitMb;
using bench::kPageLimitMs;
using bench::PageRow;
using bench::StoreTimes;

struct StoreBenchOptions : bench::StoreBenchOrder {
    std::string out;
    bool quick = false, no_shell = false;
};

void write_files(const StoreBenchOptions& options, const Json& json,
                 const std::vector<PageRow>& rows) {
    std::error_code error;
    fs::create_directories(options.out, error);
    std::ofstream csv(options.out + "/bench_store.csv");
    csv << "engine,users,attempts,page,query,rows,first_ms,median_ms,worst_ms,"
           "processor_ms,limit_ms,kept\n";
    for (const PageRow& row : rows)
        csv << json["engine"].get<std::string>() << ',' << options.users << ',' << options.attempts
            << ",\"" << row.page << "\",\"" << row.query << "\"," << row.rows << ','
            << fixed(row.first_ms, 3) << ',' << fixed(row.median_ms, 3) << ','
            << fixed(row.worst_ms, 3) << ',' << fixed(row.processor_ms, 3) << ','
            << fixed(row.limit_ms, 0) << ',' << (row.kept() ? "yes" : "no") << '\n';
    std::ofstream document(options.out + "/bench_store.json");
    document << json.dump(2) << '\n';
    csv.flush();
    document.flush();
    if (!csv || !document)
        throw InputError("--out " + options.out + ": cannot be written; choose another place");
}

Json shell_json(const bench::ShellPages& shell) {
    Json list = Json::array();
    for (const bench::ShellPage& each : shell.pages)
        list.push_back({{"who", each.who},
                        {"page", each.page},
                        {"first_ms", each.first_ms},
                        {"median_ms", each.median_ms},
                        {"worst_ms", each.worst_ms},
                        {"processor_ms", each.processor_ms},
                        {"complete_ms", each.complete_ms},
                        {"limit_ms", kPageLimitMs}});
    return list;
}

/// Times on a machine that is busy with something else are no times of the program.
std::string load_words() {
    double load = 0;
    if (::getloadavg(&load, 1) != 1 ||
        load < static_cast<double>(std::thread::hardware_concurrency()))
        return {};
    return "\nThe machine was busy (load " + fixed(load, 1) + " on " +
           std::to_string(std::thread::hardware_concurrency()) +
           " processors): look at the processor times";
}

StoreTimes measure(const std::string& url, const StoreBenchOptions& options,
                   const std::string& folder) {
    bench::StoreBenchWatcher watcher;
    watcher.simulating = [](const std::string& name) {
        std::cerr << "simulating: " << name << '\n';
    };
    watcher.multiplying = [](int64_t done, int64_t total) {
        show_progress("multiplying " + std::to_string(done) + " of " + std::to_string(total));
    };
    watcher.filled = clear_progress;
    watcher.measured = [](const PageRow& row) {
        std::cerr << row.page << ", " << row.query << ": " << fixed(row.median_ms, 1)
                  << " ms, processor " << fixed(row.processor_ms, 1) << " ms\n";
    };
    auto times = bench::time_store(url, options, folder, watcher);
    if (!times)
        throw InputError("bench store: " + db::open_store(url)->url() +
                         " has people; give an empty store, the copies are not for a real one");
    if (options.no_shell) times->shell.problem = "--no-shell was given";
    return *std::move(times);
}

Json times_json(const std::string& url, const StoreBenchOptions& options, const StoreTimes& times) {
    Json json{{"benchmark", "store"},
              {"engine", url.starts_with("sqlite:") ? "sqlite" : "postgresql"},
              {"machine", machine()},
              {"users", times.load.users},
              {"attempts", times.load.attempts},
              {"multiplied_from", times.load.sources},
              {"rows", times.load.rows},
              {"fill_s", times.fill_s},
              {"simulated_s", options.simulate_s},
              {"runs", options.runs},
              {"memory_before_mb", times.before_mb},
              {"peak_memory_pages_mb", times.pages_mb},
              {"peak_memory_mb", times.memory_mb},
              {"shell_peak_memory_mb", times.shell.peak_memory_mb},
              {"shell_problem", times.shell.problem},
              {"shell_pages", shell_json(times.shell)},
              {"memory_limit_mb", kMemoryLimitMb},
              {"all_kept", times.kept()},
              {"queries", Json::array()}};
    for (const PageRow& row : times.rows)
        json["queries"].push_back({{"page", row.page},
                                   {"query", row.query},
                                   {"rows", row.rows},
                                   {"first_ms", row.first_ms},
                                   {"median_ms", row.median_ms},
                                   {"worst_ms", row.worst_ms},
                                   {"processor_ms", row.processor_ms},
                                   {"limit_ms", row.limit_ms},
                                   {"kept", row.kept()}});
    return json;
}

/// A table of all queries, and a sentence on people, attempts, memory and limits.
std::string times_text(const std::string& engine, const StoreTimes& times) {
    std::vector<std::vector<std::string>> cells{{"page", "asks for", "rows", "first ms",
                                                 "median ms", "worst ms", "processor ms",
                                                 "limit ms", ""}};
    for (const PageRow& row : times.rows) {
        cells.push_back({row.page, row.query, std::to_string(row.rows), fixed(row.first_ms, 1),
                         fixed(row.median_ms, 1), fixed(row.worst_ms, 1),
                         fixed(row.processor_ms, 1), fixed(row.limit_ms, 0),
                         row.kept() ? "" : "TOO SLOW"});
    }
    return table(cells) + engine + ", " + std::to_string(times.load.users) + " people, " +
           std::to_string(times.load.attempts) + " attempts multiplied from " +
           std::to_string(times.load.sources) + " simulated ones (" +
           std::to_string(times.load.rows) + " rows, " + fixed(times.fill_s, 1) +
           " s); peak memory " + fixed(times.pages_mb, 0) + " MB for the pages, " +
           fixed(times.memory_mb, 0) + " MB with reports, " +
           (times.shell.problem.empty() ? fixed(times.shell.peak_memory_mb, 0) + " MB for the shell"
                                        : "the shell was not measured: " + times.shell.problem) +
           " (limit " + fixed(kMemoryLimitMb, 0) + "); " +
           (times.kept() ? "all limits kept" : "NOT all limits kept") + load_words();
}

StoreBenchOptions in_short(StoreBenchOptions options) {
    options.users = std::min(options.users, 50);
    options.attempts = std::min<int64_t>(options.attempts, 2000);
    options.runs = 3;
    options.simulate_s = std::min(options.simulate_s, 1.0);
    return options;
}

int run(const Context& context, const StoreBenchOptions& asked) {
    need_writable_folder("--out", asked.out);
    StoreBenchOptions options = asked.quick ? in_short(asked) : asked;
    options.shell = !options.no_shell;
    const ScratchFolder folder;
    const std::string url =
        context.store_url.empty() ? "sqlite:" + folder.path() + "/bench.db" : context.store_url;
    const StoreTimes times = measure(url, options, folder.path());
    const Json json = times_json(url, options, times);
    if (!options.out.empty()) write_files(options, json, times.rows);
    print(context, json, times_text(json["engine"].get<std::string>(), times));
    return 0;
}

}  // namespace

void add_store_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<StoreBenchOptions>();
    CLI::App* command =
        bench.add_subcommand("store",
                             "Pages and reports with 1,000 people and 100,000 attempts, in a "
                             "new store of its own or in "
                             "the empty one given with --store");
    command->add_option("--users", options->users, "People")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command->add_option("--attempts", options->attempts, "Attempts")
        ->check(CLI::Range(int64_t{10}, int64_t{10000000}))
        ->capture_default_str();
    command->add_option("--out", options->out, "Folder for bench_store.csv and bench_store.json");
    command->add_option("--simulate", options->simulate_s, "Length of each simulated attempt [s]")
        ->check(ui::finite_range(0.2, 600.0))
        ->capture_default_str();
    command->add_flag("--quick", options->quick, "50 people and 2,000 attempts at most");
    command->add_flag("--sealed", options->sealed,
                      "Seals every attempt and measures `placodectl check` as well");
    command->add_flag("--no-shell", options->no_shell,
                      "Leaves out opening every page of the shell (placode --time-pages)");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
