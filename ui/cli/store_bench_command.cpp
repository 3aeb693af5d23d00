// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl bench store: what every page asks of a store with 1,000 people and
// 100,000 attempts, and how long the answer takes.

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "db/course_conduct.h"
#include "db/load_generator.h"
#include "db/norms.h"
#include "db/recording_file.h"
#include "reports/cohort_report.h"
#include "ui/cli/page_bench.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kPageLimitMs = 300, kReportLimitMs = 5000, kMemoryLimitMb = 500;

struct Options {
    int users = 1000, runs = 5;
    int64_t attempts = 100000;
    std::string out;
    double simulate_s = 20;  ///< Of each source attempt.
    bool quick = false, no_shell = false;
};

struct Row {
    std::string page, query;
    int64_t rows = 0;
    double first_ms = 0, median_ms = 0, worst_ms = 0, limit_ms = kPageLimitMs;
    /// Of this process, median: what a page costs, whoever else uses the machine. A PostgreSQL
    /// server's part is not in it.
    double processor_ms = 0;
    [[nodiscard]] bool kept() const { return worst_ms <= limit_ms; }
};

class Folder {
 public:
    Folder() {
        path_ = (fs::temp_directory_path() / "placode-bench-XXXXXX").string();
        if (::mkdtemp(path_.data()) == nullptr)
            throw std::runtime_error("cannot make a temporary folder");
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
    std::string path_;
};

/// Largest resident memory since forget_peak().
double peak_memory_mb() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
    return 0;
}

/// What simulating and multiplying took is no page's memory.
void forget_peak() {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// One attempt of a scripted operator, recorded, measured, scored and saved.
void simulate(db::Store& store, int64_t user, const std::string& operator_name, double seconds,
              const std::string& file) {
    const curriculum::Task task = curriculum::load_task("diathermy_ring_small");
    curriculum::AttemptOptions how;
    how.device = "script:" + operator_name;
    how.fast = true;
    how.demonstration = true;
    how.duration_s = seconds;
    how.started_utc = now_utc();
    {
        curriculum::AttemptRunner runner(task, 1, how, db::create_recording_file(file));
        runner.start();
        while (!runner.finished()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        runner.wait();
    }
    const sim::Recording recording = db::read_recording_file(file);
    db::AttemptResult result;
    result.header = recording.header;
    result.end = recording.end;
    result.end.reason = sim::EndReason::kFinished;
    result.events = recording.events;
    result.metrics = assessment::compute_metrics(recording);
    result.score = assessment::score_attempt(task.rubric, result.metrics, recording);
    result.recording_file = file;
    store.save_attempt(user, result);
    fs::remove(file);
}

db::LoadResult fill(const std::string& url, const Options& options, const Folder& folder) {
    {
        const auto store = db::open_store(url);
        store->act_as("bench store");
        if (!store->users().empty())
            throw InputError("bench store: " + store->url() +
                             " has people; give an empty store, the copies are not "
                             "for a real one");
        const int64_t user = store->create_user(
            {"simulated", "Simulated operator", "not-for-signing-in-1", 1, true});
        for (const char* name : {"novice", "intermediate", "expert"}) {
            std::cerr << "simulating: " << name << '\n';
            simulate(*store, user, name, options.simulate_s,
                     folder.file(std::string(name) + ".placode"));
        }
    }
    db::LoadOrder order;
    order.users = options.users;
    order.attempts = options.attempts;
    const bool show = isatty(STDERR_FILENO) != 0;
    order.progress = [show](int64_t done, int64_t total) {
        if (show) std::cerr << "\rmultiplying " << done << " of " << total << "   " << std::flush;
        return true;
    };
    const db::LoadResult load = db::generate_load(url, order);
    if (show) std::cerr << '\r' << std::string(50, ' ') << '\r';
    return load;
}

class Bench {
 public:
    Bench(db::Store& store, int runs) : store_(store), runs_(runs) {}

    /// `ask` returns how many rows the answer has.
    template <class Ask>
    void measure(const char* page, const char* query, double limit_ms, Ask&& ask) {
        Row row{page, query, 0, 0, 0, 0, limit_ms, 0};
        std::vector<double> times, used;
        for (int i = 0; i < runs_; ++i) {
            const auto start = Clock::now();
            const std::clock_t before = std::clock();
            row.rows = static_cast<int64_t>(ask());
            used.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
            times.push_back(
                std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        }
        row.first_ms = times.front();
        std::sort(times.begin(), times.end());
        row.median_ms = times[times.size() / 2];
        row.worst_ms = times.back();
        std::sort(used.begin(), used.end());
        row.processor_ms = used[used.size() / 2];
        std::cerr << page << ", " << query << ": " << fixed(row.median_ms, 1) << " ms, processor "
                  << fixed(row.processor_ms, 1) << " ms\n";
        rows.push_back(std::move(row));
    }

    void pages(const db::LoadResult& load) {
        const int64_t user = load.first_user + load.users / 2, group = load.first_group;
        const std::string task = "diathermy_ring_small";
        measure("Today, Course", "standing in a course, next step", kPageLimitMs, [&] {
            return db::course_standing(store_, user, "first_steps", now_utc()).course.stages.size();
        });
        measure("History", "own attempts", kPageLimitMs,
                [&] { return store_.attempts(user).size(); });
        measure("Result", "attempt with metrics, reasons, ledger", kPageLimitMs, [&] {
            db::AttemptFilter newest;
            newest.user_id = user;
            newest.limit = 1;
            const auto page = store_.attempt_page(newest);
            return store_.attempt(page.rows.at(0).id).events.size();
        });
        measure("Result", "own metrics of the task", kPageLimitMs,
                [&] { return store_.measured_attempts(user, task).size(); });
        const auto page = [&](const char* query, const db::AttemptFilter& filter) {
            measure("Attempts", query, kPageLimitMs,
                    [&] { return store_.attempt_page(filter).rows.size(); });
        };
        db::AttemptFilter all, last, of_task, of_group;
        last.offset = std::max<int64_t>(0, load.attempts - 100);
        of_task.task_id = task;
        of_group.group_id = group;
        page("first page of all", all);
        page("last page of all", last);
        page("first page of a task", of_task);
        page("first page of a group", of_group);
        measure("Cohort", "standing of a group", kPageLimitMs,
                [&] { return store_.task_standings(group).size(); });
        measure("Cohort", "standing of everybody", kPageLimitMs,
                [&] { return store_.task_standings(0).size(); });
        measure("Cohort", "all scores of a group", kPageLimitMs,
                [&] { return store_.attempt_points(group).size(); });
        measure("Standards", "mean of everybody's last attempts", kPageLimitMs,
                [&] { return store_.recent_means(task, 3).size(); });
        measure("People", "everybody", kPageLimitMs, [&] { return store_.users().size(); });
        measure("People", "groups", kPageLimitMs, [&] { return store_.groups().size(); });
        measure("Audit", "newest 200", kPageLimitMs,
                [&] { return store_.audit_trail(200).size(); });
    }

    void reports(const db::LoadResult& load, const Folder& folder) {
        const auto cohort = [&](const char* name, int64_t group) {
            measure("Report", name, kReportLimitMs, [&] {
                const auto report = reports::read_cohort_report(store_, group, now_utc());
                reports::write_cohort_pdf(report, folder.file("cohort.pdf"));
                return report.people.size();
            });
        };
        cohort("PDF of a group", load.first_group);
        cohort("PDF of everybody", 0);
    }

    std::vector<Row> rows;

 private:
    db::Store& store_;
    int runs_;
};

void write_files(const Options& options, const Json& json, const std::vector<Row>& rows) {
    std::error_code error;
    fs::create_directories(options.out, error);
    std::ofstream csv(options.out + "/bench_store.csv");
    csv << "engine,users,attempts,page,query,rows,first_ms,median_ms,worst_ms,"
           "processor_ms,limit_ms,kept\n";
    for (const Row& row : rows)
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

Json shell_json(const ShellPages& shell) {
    Json list = Json::array();
    for (const ShellPage& each : shell.pages)
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

int run(const Context& context, Options options) {
    if (options.quick) {
        options.users = std::min(options.users, 50);
        options.attempts = std::min<int64_t>(options.attempts, 2000);
        options.runs = 3;
        options.simulate_s = std::min(options.simulate_s, 1.0);
    }
    const Folder folder;
    const std::string url =
        context.store_url.empty() ? "sqlite:" + folder.file("bench.db") : context.store_url;
    const auto start = Clock::now();
    const db::LoadResult load = fill(url, options, folder);
    const double fill_s = std::chrono::duration<double>(Clock::now() - start).count();
    const auto store = db::open_store(url);
    store->act_as("bench store");
    forget_peak();
    const double before_mb = peak_memory_mb();
    Bench bench(*store, options.runs);
    bench.pages(load);
    const double pages_mb = peak_memory_mb();
    bench.reports(load, folder);
    const double memory_mb = peak_memory_mb();
    ShellPages shell;
    if (options.no_shell)
        shell.problem = "--no-shell was given";
    else
        shell = time_shell_pages(url, *store, load.first_user + load.users / 2);
    for (const ShellPage& each : shell.pages)
        bench.rows.push_back({"Shell: " + each.page, "opened by " + each.who, 1, each.first_ms,
                              each.median_ms, each.worst_ms, kPageLimitMs, each.processor_ms});
    const bool kept = memory_mb <= kMemoryLimitMb && shell.peak_memory_mb <= kMemoryLimitMb &&
                      std::all_of(bench.rows.begin(), bench.rows.end(),
                                  [](const Row& row) { return row.kept(); });
    Json json{{"benchmark", "store"},
              {"engine", url.starts_with("sqlite:") ? "sqlite" : "postgresql"},
              {"machine", machine()},
              {"users", load.users},
              {"attempts", load.attempts},
              {"multiplied_from", load.sources},
              {"rows", load.rows},
              {"fill_s", fill_s},
              {"simulated_s", options.simulate_s},
              {"runs", options.runs},
              {"memory_before_mb", before_mb},
              {"peak_memory_pages_mb", pages_mb},
              {"peak_memory_mb", memory_mb},
              {"shell_peak_memory_mb", shell.peak_memory_mb},
              {"shell_problem", shell.problem},
              {"shell_pages", shell_json(shell)},
              {"memory_limit_mb", kMemoryLimitMb},
              {"all_kept", kept},
              {"queries", Json::array()}};
    std::vector<std::vector<std::string>> cells{{"page", "asks for", "rows", "first ms",
                                                 "median ms", "worst ms", "processor ms",
                                                 "limit ms", ""}};
    for (const Row& row : bench.rows) {
        json["queries"].push_back({{"page", row.page},
                                   {"query", row.query},
                                   {"rows", row.rows},
                                   {"first_ms", row.first_ms},
                                   {"median_ms", row.median_ms},
                                   {"worst_ms", row.worst_ms},
                                   {"processor_ms", row.processor_ms},
                                   {"limit_ms", row.limit_ms},
                                   {"kept", row.kept()}});
        cells.push_back({row.page, row.query, std::to_string(row.rows), fixed(row.first_ms, 1),
                         fixed(row.median_ms, 1), fixed(row.worst_ms, 1),
                         fixed(row.processor_ms, 1), fixed(row.limit_ms, 0),
                         row.kept() ? "" : "TOO SLOW"});
    }
    if (!options.out.empty()) write_files(options, json, bench.rows);
    print(context, json,
          table(cells) + json["engine"].get<std::string>() + ", " + std::to_string(load.users) +
              " people, " + std::to_string(load.attempts) + " attempts multiplied from " +
              std::to_string(load.sources) + " simulated ones (" + std::to_string(load.rows) +
              " rows, " + fixed(fill_s, 1) + " s); peak memory " + fixed(pages_mb, 0) +
              " MB for the pages, " + fixed(memory_mb, 0) + " MB with reports, " +
              (shell.problem.empty() ? fixed(shell.peak_memory_mb, 0) + " MB for the shell"
                                     : "the shell was not measured: " + shell.problem) +
              " (limit " + fixed(kMemoryLimitMb, 0) + "); " +
              (kept ? "all limits kept" : "NOT all limits kept") + load_words());
    return 0;
}

}  // namespace

void add_store_bench_command(CLI::App& bench, Context& context) {
    auto options = std::make_shared<Options>();
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
        ->check(CLI::Range(0.2, 600.0))
        ->capture_default_str();
    command->add_flag("--quick", options->quick, "50 people and 2,000 attempts at most");
    command->add_flag("--no-shell", options->no_shell,
                      "Leaves out opening every page of the shell (placode --time-pages)");
    command->callback([&context, options] {
        context.run = [&context, options] { return run(context, *options); };
    });
}

}  // namespace placode::cli
