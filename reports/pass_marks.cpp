// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pass_marks.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "db/evidence.h"
#include "db/standards.h"

namespace placode::reports {
namespace {

/// Attempts are judged by the mark of their day (db/evidence.h). Standards follow each other: what
/// has one and the same at both ends has no other in between, so few are read of many attempts.
/// @param times in order, not empty.
void add_marks(db::Store& store, const curriculum::Task& task, std::span<const std::string> times,
               std::set<double>& marks) {
    const auto standard = [&](const std::string& at_utc) {
        const auto set = db::standard_at(store, task.id, at_utc);
        return set ? set->standard.version : 0;
    };
    if (standard(times.front()) == standard(times.back())) {
        marks.insert(db::rubric_at(store, task, times.front()).pass_points);
        return;
    }
    const size_t half = times.size() / 2;
    add_marks(store, task, times.first(half), marks);
    add_marks(store, task, times.subspan(half), marks);
}

}  // namespace

PassMarks pass_marks_of(db::Store& store, const std::vector<JudgedAttempt>& attempts) {
    std::map<std::string, std::map<int, std::vector<std::string>>> times;
    for (const JudgedAttempt& each : attempts)
        times[each.task_id][each.task_version].push_back(each.started_utc);
    PassMarks found;
    for (auto& [id, versions] : times) {
        std::set<double> marks;
        bool known = true;
        for (auto& [version, list] : versions) {
            const auto task = db::published_task(store, id, version);
            // Of a task that is published nowhere the mark is not known.
            known = known && task;
            if (!known) break;
            std::sort(list.begin(), list.end());
            add_marks(store, *task, list, marks);
        }
        if (known && marks.size() == 1) found.of_task[id] = *marks.begin();
    }
    return found;
}

}  // namespace placode::reports
