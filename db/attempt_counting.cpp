// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_counting.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "curriculum/machine_speed.h"
#include "sim/core/counted.h"

namespace placode::db {

std::string slow_machine_reason(const std::vector<sim::Event>& events) {
    std::string reason;
    const auto say = [&](const std::string& more) {
        reason += (reason.empty() ? "" : "; ") + more;
    };
    const auto whole = [](double value) { return std::to_string(std::lround(std::floor(value))); };
    for (const sim::Event& event : events) {
        if (event.kind != sim::EventKind::kMachineSpeed) continue;
        if (event.value2 > 0 && event.value2 < curriculum::kLeastPicturesHz)
            say("The computer was too slow: " +
                sim::counted(std::lround(std::floor(event.value2)), "picture") + " a second, " +
                whole(curriculum::kLeastPicturesHz) + " are needed");
        // Not "less than" alone: a value that is no number is no proof of speed.
        if (!(event.value >= static_cast<float>(curriculum::kLeastRealTime)))
            say("The computer was too slow: the simulation ran at " + whole(100 * event.value) +
                " % of real time, " + whole(100 * curriculum::kLeastRealTime + 0.5) +
                " % are needed");
    }
    return reason;
}

std::string tuned_reason(const std::vector<sim::Event>& events) {
    const bool tuned = std::any_of(events.begin(), events.end(), [](const sim::Event& event) {
        return event.kind == sim::EventKind::kTuned;
    });
    return tuned ? std::string(kTunedReason) : std::string();
}

std::string joined_reasons(const std::string& a, const std::string& b) {
    return a.empty() || b.empty() ? a + b : a + "; " + b;
}

bool counts(const AttemptRecord& attempt) noexcept {
    return was_tried(attempt) && attempt.void_reason.empty();
}

bool machine_at_fault(const AttemptRecord& attempt) noexcept {
    return was_tried(attempt) && !attempt.void_reason.empty() &&
           attempt.void_reason.find(kTunedReason) == std::string::npos;
}

std::vector<AttemptRecord> attempts_beside(Store& store, const AttemptRecord& attempt) {
    if (attempt.study.study.empty()) return store.attempts().list(attempt.user_id, attempt.task_id);
    std::set<int64_t> own;
    for (const StepRecord& step : store.studies().steps(attempt.study.study))
        if (step.participant == attempt.study.participant && step.attempt_id != 0)
            own.insert(step.attempt_id);
    own.insert(attempt.id);
    std::vector<AttemptRecord> list;
    for (const int64_t id : own) {
        AttemptRecord each = store.attempts().detail(id).record;
        if (each.task_id == attempt.task_id) list.push_back(std::move(each));
    }
    return list;
}

}  // namespace placode::db
