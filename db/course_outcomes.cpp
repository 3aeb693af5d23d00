// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a course sees of attempts and of exams that were begun.

#include <algorithm>
#include <map>
#include <set>

#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/course_conduct.h"
#include "db/void_reason.h"

namespace placode::db {

namespace {

/// Which exam it was is what was written down when it began, and at that time.
void take_from(const ExamBeginRecord& begin, curriculum::AttemptOutcome& outcome) {
    outcome.task_id = begin.task_id;
    // The station's clock may be minutes off; begins are all by the store's.
    outcome.at_utc = begin.begun_utc;
    outcome.seed = begin.seed;
    outcome.exam_course = begin.course_id;
    outcome.exam_version = begin.course_version;
    outcome.exam_stage = begin.stage_id;
    outcome.proctor = begin.proctor;
    outcome.certified = !begin.device_certificate.empty();
}

curriculum::AttemptOutcome unfinished(const ExamBeginRecord& begin) {
    curriculum::AttemptOutcome outcome;
    outcome.interrupted = outcome.unfinished = true;
    take_from(begin, outcome);
    return outcome;
}

/// The person took it out of what counts: left it, or tuned tissue or generator. A crash and a slow
/// computer are not the person's, so nothing is held against whom they hit.
bool given_up(const AttemptRecord& attempt) {
    if (attempt.demonstration || attempt.generated) return false;
    if (attempt.verdict == assessment::Verdict::kNotAttempted) return false;
    const std::vector<VoidReason> voids = void_reasons(attempt.void_reason, attempt.void_meaning);
    const bool tuned = std::any_of(voids.begin(), voids.end(), [](const VoidReason& each) {
        return each.cause == VoidCause::kTuned;
    });
    const bool late = attempt.duration_s >= curriculum::kGiveUpAfterS;
    if (tuned) return late;
    return attempt.end == sim::EndReason::kInterrupted && attempt.ended && voids.empty() &&
           (late || attempt.verdict == assessment::Verdict::kFailed);
}

/// @param begin of the exam that the attempt ended; absent: it ended none.
curriculum::AttemptOutcome outcome_of(const AttemptRecord& attempt, const ExamBeginRecord* begin) {
    curriculum::AttemptOutcome outcome;
    outcome.saved = attempt.id;
    outcome.task_id = attempt.task_id;
    outcome.points = attempt.points;
    outcome.critical = attempt.verdict == assessment::Verdict::kFailed;
    outcome.not_attempted = attempt.verdict == assessment::Verdict::kNotAttempted;
    outcome.given_up = given_up(attempt);
    outcome.at_utc = attempt.started_utc;
    outcome.seed = attempt.seed;
    outcome.exam_course = attempt.exam.course_id;
    outcome.exam_version = attempt.exam.course_version;
    outcome.exam_stage = attempt.exam.stage_id;
    outcome.proctor = attempt.exam.proctor;
    outcome.certified = !attempt.exam.device_certificate.empty();
    // What waits for its replay, or was found to prove nothing, is used up and not met: a case
    // was seen, and nobody gets another one by spoiling a file.
    // Whoever ended a begin was asked for a replay (db/attempts.cpp), whatever the row says of it.
    const bool asked = begin != nullptr && attempt.void_reason.empty();
    const bool unproven = not_verified(attempt) || attempt.replay == ReplayState::kWaiting ||
                          (asked && attempt.replay != ReplayState::kIdentical);
    outcome.voided = !attempt.void_reason.empty() && !not_verified(attempt);
    outcome.interrupted = attempt.end == sim::EndReason::kInterrupted || unproven;
    if (begin == nullptr) return outcome;
    // Nor by putting the recording of another case in the place of the one that went badly.
    if (attempt.task_id != begin->task_id || attempt.seed != begin->seed ||
        attempt.exam.course_id.empty()) {
        outcome.interrupted = true;
        outcome.voided = false;
    }
    take_from(*begin, outcome);
    return outcome;
}

/// Of what does not count the clock may have been wrong: the next one is not late by it.
void mark_late(std::vector<curriculum::AttemptOutcome>& outcomes) {
    std::vector<curriculum::AttemptOutcome*> saved;
    saved.reserve(outcomes.size());
    for (curriculum::AttemptOutcome& each : outcomes) saved.push_back(&each);
    std::sort(saved.begin(), saved.end(),
              [](const auto* a, const auto* b) { return a->saved < b->saved; });
    std::map<std::string, int64_t> before;  // by task: when the one before it began
    for (curriculum::AttemptOutcome* each : saved) {
        const auto began = curriculum::utc_seconds(each->at_utc);
        if (!began || each->interrupted || each->voided) continue;
        const auto last = before.try_emplace(each->task_id, *began).first;
        each->late = *began < last->second;
        last->second = *began;
    }
}

}  // namespace

std::vector<curriculum::AttemptOutcome> outcomes_of(const std::vector<AttemptRecord>& attempts,
                                                    const std::vector<ExamBeginRecord>& begins) {
    std::vector<curriculum::AttemptOutcome> outcomes;
    outcomes.reserve(attempts.size() + begins.size());
    std::map<int64_t, const ExamBeginRecord*> ended;  // by attempt
    for (const ExamBeginRecord& begin : begins)
        if (begin.attempt_id != 0) ended[begin.attempt_id] = &begin;
    std::set<int64_t> saved;
    for (const AttemptRecord& attempt : attempts) {
        const auto begin = ended.find(attempt.id);
        outcomes.push_back(outcome_of(attempt, begin == ended.end() ? nullptr : begin->second));
        saved.insert(attempt.id);
    }
    mark_late(outcomes);
    if (begins.empty()) return outcomes;
    // An attempt that is left out, as one that a script showed is, ended no exam.
    for (const ExamBeginRecord& begin : begins)
        if (!saved.contains(begin.attempt_id)) outcomes.push_back(unfinished(begin));
    std::stable_sort(outcomes.begin(), outcomes.end(),
                     [](const auto& a, const auto& b) { return a.at_utc < b.at_utc; });
    return outcomes;
}

}  // namespace placode::db
