// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/attempt_counting.h"

#include <algorithm>
#include <cmath>

#include "curriculum/machine_speed.h"
#include "db/said.h"

namespace placode::db {

std::vector<VoidReason> void_reasons(const std::vector<sim::Event>& events) {
    std::vector<VoidReason> tuned, slow;
    const auto whole = [](double value) { return static_cast<int>(std::floor(value)); };
    for (const sim::Event& event : events) {
        if (event.kind == sim::EventKind::kTuned && tuned.empty())
            tuned.push_back({VoidCause::kTuned, 0, 0, {}});
        if (event.kind != sim::EventKind::kMachineSpeed) continue;
        if (event.value2 > 0 && event.value2 < curriculum::kLeastPicturesHz)
            slow.push_back({VoidCause::kFewPictures,
                            whole(event.value2),
                            whole(curriculum::kLeastPicturesHz),
                            {}});
        // Not "less than" alone: a value that is no number is no proof of speed.
        if (!(event.value >= static_cast<float>(curriculum::kLeastRealTime)))
            slow.push_back({VoidCause::kNotRealTime,
                            std::isfinite(event.value) ? whole(100 * event.value) : 0,
                            whole(100 * curriculum::kLeastRealTime + 0.5),
                            {}});
    }
    tuned.insert(tuned.end(), slow.begin(), slow.end());
    return tuned;
}

std::vector<VoidReason> void_causes(const AttemptResult& result) {
    std::vector<VoidReason> voids = void_reasons(result.events);
    if (result.header.stage != 0)
        voids.insert(voids.begin(), VoidReason{VoidCause::kGiven, result.header.stage, 0, {}});
    return voids;
}

std::vector<VoidReason> why_void(const AttemptRecord& attempt) {
    return void_reasons(attempt.void_reason, attempt.void_meaning);
}

bool counts(const AttemptRecord& attempt) noexcept {
    return was_tried(attempt) && attempt.void_reason.empty() &&
           attempt.replay != ReplayState::kWaiting && attempt.replay != ReplayState::kDiffers;
}

bool not_verified(const AttemptRecord& attempt) noexcept {
    const auto reasons = why_void(attempt);
    return std::any_of(reasons.begin(), reasons.end(),
                       [](const VoidReason& reason) { return is_doubt(reason.cause); });
}

int given_stage(const AttemptRecord& attempt) noexcept {
    for (const VoidReason& reason : why_void(attempt))
        if (reason.cause == VoidCause::kGiven) return reason.found;
    return 0;
}

bool machine_at_fault(const AttemptRecord& attempt) noexcept {
    const auto reasons = why_void(attempt);
    return was_tried(attempt) && !reasons.empty() &&
           std::none_of(reasons.begin(), reasons.end(), [](const VoidReason& reason) {
               return reason.cause == VoidCause::kTuned || reason.cause == VoidCause::kGiven ||
                      is_doubt(reason.cause);
           });
}

void need_same_rules(const std::string& what, const AttemptRecord& a, const AttemptRecord& b) {
    if (a.task_version == b.task_version && a.rubric_id == b.rubric_id &&
        a.rubric_version == b.rubric_version)
        return;
    throw StoreError(StoreError::Kind::kRefused, what,
                     Said::that("the attempts are of different versions of the task or of its "
                                "rubric; choose people whose attempts are of one version"));
}

std::vector<AttemptRecord> other_attempts(Store& store, const AttemptRecord& attempt) {
    if (attempt.study.study.empty()) return store.attempts().list(attempt.user_id, attempt.task_id);
    std::vector<int64_t> own{attempt.id};
    for (const StepRecord& step : store.studies().steps(attempt.study.study))
        if (step.participant == attempt.study.participant && step.attempt_id != 0)
            own.push_back(step.attempt_id);
    std::vector<AttemptRecord> list;
    for (auto& [id, each] : store.attempts().records(own))
        if (each.task_id == attempt.task_id) list.push_back(std::move(each));
    return list;
}

}  // namespace placode::db
