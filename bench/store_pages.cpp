// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/store_pages.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>

#include "assessment/scoring.h"
#include "curriculum/attempt_runner.h"
#include "curriculum/utc_time.h"
#include "db/course_conduct.h"
#include "db/norm_bands.h"
#include "db/recording_file.h"
#include "reports/cohort_report.h"

namespace placode::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string now_utc() { return curriculum::utc_text(static_cast<int64_t>(std::time(nullptr))); }

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
    store.attempts().save(user, result);
    fs::remove(file);
}

}  // namespace

double peak_memory_mb() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::strtod(line.c_str() + 6, nullptr) / 1024;
    return 0;
}

void forget_peak() {
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";
}

bool simulate_attempts(db::Store& store, double seconds, const std::string& folder,
                       const std::function<void(const std::string&)>& begun) {
    if (!store.accounts().list().empty()) return false;
    const int64_t user = store.accounts().create(
        {"simulated", "Simulated operator", "not-for-signing-in-1", 1, true});
    for (const char* name : {"novice", "intermediate", "expert"}) {
        if (begun) begun(name);
        simulate(store, user, name, seconds, folder + "/" + name + ".placode");
    }
    return true;
}

template <class Ask>
void StorePages::measure(const char* page, const char* query, double limit_ms, Ask&& ask) {
    PageRow row{page, query, 0, 0, 0, 0, limit_ms, 0};
    std::vector<double> times, used;
    for (int i = 0; i < runs_; ++i) {
        const auto start = Clock::now();
        const std::clock_t before = std::clock();
        row.rows = static_cast<int64_t>(ask());
        used.push_back(1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    row.first_ms = times.front();
    std::sort(times.begin(), times.end());
    row.median_ms = times[times.size() / 2];
    row.worst_ms = times.back();
    std::sort(used.begin(), used.end());
    row.processor_ms = used[used.size() / 2];
    if (measured_) measured_(row);
    rows.push_back(std::move(row));
}

void StorePages::check() {
    const int every = std::exchange(runs_, 1);
    measure("Health", "check of the trail and every seal (problems)", kCheckLimitMs,
            [&] { return store_.check().size(); });
    runs_ = every;
}

void StorePages::pages(const db::LoadResult& load) {
    const int64_t user = load.first_user + load.users / 2, group = load.first_group;
    const std::string task = "diathermy_ring_small";
    measure("Today, Course", "standing in a course, next step", kPageLimitMs, [&] {
        return db::course_standing(store_, user, "first_steps", now_utc()).course.stages.size();
    });
    measure("History", "own attempts", kPageLimitMs,
            [&] { return store_.attempts().list(user).size(); });
    measure("Result", "attempt with metrics, reasons, ledger", kPageLimitMs, [&] {
        db::AttemptFilter newest;
        newest.user_id = user;
        newest.limit = 1;
        const auto page = store_.attempts().page(newest);
        return store_.attempts().detail(page.rows.at(0).id).events.size();
    });
    measure("Result", "own metrics of the task", kPageLimitMs,
            [&] { return store_.norms().measured_attempts(user, task).size(); });
    const auto page = [&](const char* query, const db::AttemptFilter& filter) {
        measure("Attempts", query, kPageLimitMs,
                [&] { return store_.attempts().page(filter).rows.size(); });
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
            [&] { return store_.attempts().standings(group).size(); });
    measure("Cohort", "standing of everybody", kPageLimitMs,
            [&] { return store_.attempts().standings(0).size(); });
    measure("Cohort", "all scores of a group", kPageLimitMs,
            [&] { return store_.attempts().points(group).size(); });
    measure("Standards", "mean of everybody's last attempts", kPageLimitMs,
            [&] { return store_.attempts().recent_means(task, 3).size(); });
    measure("People", "everybody", kPageLimitMs, [&] { return store_.accounts().list().size(); });
    measure("People", "groups", kPageLimitMs, [&] { return store_.groups().list().size(); });
    measure("Audit", "newest 200", kPageLimitMs, [&] { return store_.audit().trail(200).size(); });
}

void StorePages::reports(const db::LoadResult& load, const std::string& folder) {
    const auto cohort = [&](const char* name, int64_t group) {
        measure("Report", name, kReportLimitMs, [&] {
            const auto report = placode::reports::read_cohort_report(store_, group, now_utc());
            placode::reports::write_cohort_pdf(report, folder + "/cohort.pdf");
            return report.people.size();
        });
    };
    cohort("PDF of a group", load.first_group);
    cohort("PDF of everybody", 0);
}

}  // namespace placode::bench
