// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/rescore_report.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/signal.h"
#include "sim/core/counted.h"
#include "ui/cli/progress.h"

namespace placode::cli {
namespace {

bool has_new_score(const db::RescoreOutcome& one, bool dry_run) {
    return one.state == db::RescoreState::kRescored ||
           (dry_run && one.state == db::RescoreState::kAlreadyThere);
}

/// What old recordings cannot tell, once for all of them; --json says it for each.
std::string lack_text(int attempts, const std::set<std::string>& metrics) {
    if (attempts == 0) return {};
    std::string text = "\n" + sim::counted(attempts, "recording") +
                       ", older than these metrics or broken off, lack";
    const char* between = ": ";
    for (const std::string& metric : metrics) {
        text += between + metric;
        between = ", ";
    }
    return text;
}

/// What the list says in the end.
struct Totals {
    int scored = 0, verdicts = 0, lack = 0;
    double largest = 0;
    std::set<std::string> lacking;

    void add(const db::RescoreOutcome& one, bool dry_run) {
        if (has_new_score(one, dry_run)) {
            ++scored;
            largest = std::max(largest, std::abs(one.new_points - one.old_points));
            verdicts += one.new_verdict != one.old_verdict ? 1 : 0;
        }
        if (one.lacks.empty()) return;
        lacking.insert(one.lacks.begin(), one.lacks.end());
        ++lack;
    }
};

Json outcome_json(const db::RescoreOutcome& one, bool dry_run) {
    Json entry{{"attempt", one.attempt_id},
               {"state", db::rescore_state_name(one.state)},
               {"first_points", one.old_points},
               {"first_verdict", assessment::verdict_name(one.old_verdict)}};
    if (has_new_score(one, dry_run)) {
        entry["points"] = one.new_points;
        entry["verdict"] = assessment::verdict_name(one.new_verdict);
    }
    if (!one.lacks.empty()) entry["lacks"] = one.lacks;
    if (!one.problem.empty()) entry["problem"] = one.problem;
    return entry;
}

std::vector<std::string> outcome_row(const db::RescoreOutcome& one, bool dry_run) {
    std::vector<std::string> row{std::to_string(one.attempt_id),
                                 fixed(one.old_points, 2),
                                 "-",
                                 "-",
                                 assessment::verdict_name(one.old_verdict),
                                 db::rescore_state_name(one.state)};
    if (!has_new_score(one, dry_run)) return row;
    row[2] = fixed(one.new_points, 2);
    row[3] = fixed(one.new_points - one.old_points, 2);
    if (one.new_verdict != one.old_verdict)
        row[4] += std::string(" -> ") + assessment::verdict_name(one.new_verdict);
    return row;
}

struct RescoreRun {
    bool dry_run = false, stopped = false;
};

void print_rescores(const Context& context, const curriculum::Task& task,
                    const std::vector<db::RescoreOutcome>& outcomes, const RescoreRun& run) {
    Json json{{"task", task.id},
              {"rubric", task.rubric.id},
              {"rubric_version", task.rubric.version},
              {"metric_set_version", assessment::kMetricSetVersion},
              {"preprocessing_version", assessment::kPreprocessingVersion},
              {"dry_run", run.dry_run},
              {"cancelled", run.stopped},
              {"attempts", Json::array()}};
    std::vector<std::vector<std::string>> rows{
        {"attempt", "first score", "under this rubric", "difference", "verdict", "state"}};
    Totals totals;
    for (const auto& one : outcomes) {
        totals.add(one, run.dry_run);
        json["attempts"].push_back(outcome_json(one, run.dry_run));
        rows.push_back(outcome_row(one, run.dry_run));
    }
    json["scored"] = totals.scored;
    json["verdicts_changed"] = totals.verdicts;
    json["largest_difference"] = totals.largest;
    print(context, json,
          (rows.size() == 1 ? std::string("no attempts of ") + task.id + "\n" : table(rows)) +
              std::to_string(totals.scored) + (run.dry_run ? " would get" : " got") +
              " a score under " + task.rubric.id + " version " +
              std::to_string(task.rubric.version) + ", " + std::to_string(totals.verdicts) +
              " verdicts differ, largest difference " + fixed(totals.largest, 2) +
              (run.stopped ? "; cancelled, what is done is kept" : "") +
              lack_text(totals.lack, totals.lacking));
}

}  // namespace

int run_rescoring(const Context& context, db::Store& store, const curriculum::Task& task,
                  db::RescoreOptions options, const std::string& doing) {
    options.progress = [&](size_t done, size_t total) {
        show_progress(doing + " " + std::to_string(done) + " of " + std::to_string(total));
        return !CancelOn::requested();
    };
    std::vector<db::RescoreOutcome> outcomes;
    try {
        outcomes = db::rescore(store, task, options);
    } catch (const db::StoreError& error) {
        clear_progress();
        if (error.kind() == db::StoreError::Kind::kConflict) throw InputError(error.what());
        throw;
    }
    clear_progress();
    const bool stopped = CancelOn::requested();
    print_rescores(context, task, outcomes, {options.dry_run, stopped});
    return stopped ? 1 : 0;
}

}  // namespace placode::cli
