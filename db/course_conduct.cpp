// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/course_conduct.h"

#include <algorithm>
#include <map>
#include <set>

#include "curriculum/shipped_definitions.h"
#include "curriculum/utc_time.h"
#include "db/attempt_counting.h"
#include "db/course_rows.h"
#include "db/said.h"
#include "db/void_reason.h"
#include "sim/core/near_word.h"

namespace placode::db {

using curriculum::Course;

namespace {

[[noreturn]] void refuse(const std::string& what, const Said& problem) {
    throw StoreError(StoreError::Kind::kRefused, what, problem);
}

CourseRows rows_of(Store& store, int64_t user_id) {
    const auto user = store.accounts().find(user_id);
    return {own_attempts(store.attempts().list(user_id), !user || user->demonstration),
            store.courses().exam_begins(user_id), store.courses().grants(user_id)};
}

CourseStanding standing_in(Store& store, int64_t user_id, const AssignmentRecord& assignment,
                           Course course, const CourseRows& rows, const std::string& now_utc) {
    CourseStanding standing;
    standing.assignment = assignment;
    standing.course = std::move(course);
    standing.progress = progress_in(standing.course, rows, now_utc);
    standing.next =
        curriculum::next_step(standing.course, standing.progress, task_titles(standing.course),
                              {assignment.starts_utc, assignment.due_utc}, now_utc);
    for (const CertificateRecord& each : store.courses().certificates(user_id))
        // On a server a row can be added by SQL, with any date.
        if (standing.progress.mastered && each.course_id == standing.course.id &&
            each.course_version == standing.course.version &&
            may_stand(each, standing.progress.mastered_utc))
            standing.certificate = each;
    return standing;
}

}  // namespace

Course find_course(Store& store, const std::string& course_id, int version) {
    if (const auto published = store.definitions().find("course", course_id, version))
        return curriculum::load_course_text(published->json, "course " + course_id);
    const auto text = curriculum::shipped_text("courses", course_id);
    if (!text) {
        const std::vector<std::string> known = course_ids(store);
        std::string list;
        for (const std::string& id : known) list += (list.empty() ? "" : ", ") + id;
        throw curriculum::DefinitionError(
            "course " + course_id, "",
            "is neither published here nor one of the program's own (" + list +
                "); an educator publishes it: `placodectl course publish FILE`" +
                sim::did_you_mean(course_id, known));
    }
    Course shipped = curriculum::load_course_text(*text, "course " + course_id);
    if (version != 0 && shipped.version != version)
        throw curriculum::DefinitionError("course " + course_id, "",
                                          "version " + std::to_string(version) +
                                              " is neither published nor shipped; found " +
                                              std::to_string(shipped.version));
    return shipped;
}

std::vector<std::string> course_ids(Store& store) {
    std::set<std::string> ids;
    for (const auto& each : store.definitions().list("course")) ids.insert(each.id);
    for (const auto& each : curriculum::shipped_ids("courses")) ids.insert(each);
    return {ids.begin(), ids.end()};
}

void publish_course_on_first_use(Store& store, const Course& course) {
    if (store.definitions().find("course", course.id, course.version)) return;
    DefinitionRecord definition;
    definition.kind = "course";
    definition.id = course.id;
    definition.version = course.version;
    definition.json = course.json;
    definition.reason = "first use of this version";
    store.definitions().publish(definition);
}

std::map<std::string, curriculum::LocalText> task_titles(const Course& course) {
    std::map<std::string, curriculum::LocalText> titles;
    for (const auto& stage : course.stages) {
        if (titles.contains(stage.task_id)) continue;
        try {
            titles[stage.task_id] = curriculum::load_task_title(stage.task_id);
        } catch (const curriculum::DefinitionError&) {
            // Its id is title enough; whoever opens the task is told what is wrong with it.
        }
    }
    return titles;
}

namespace {

/// Which exam it was is what was written down when it began, and at that time.
void take_from(const ExamBeginRecord& begin, curriculum::AttemptOutcome& outcome) {
    outcome.task_id = begin.task_id;
    // The station's clock may be minutes off; begins are all by the store's.
    outcome.at_utc = begin.begun_utc;
    outcome.seed = begin.seed;
    outcome.exam_course = begin.course_id;
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

CourseStanding course_standing(Store& store, int64_t user_id, const std::string& course_id,
                               const std::string& now_utc) {
    AssignmentRecord held;
    for (const AssignmentRecord& each : store.courses().assignments(user_id)) {
        if (each.course_id != course_id) continue;
        held = each;
        break;
    }
    return standing_in(store, user_id, held, find_course(store, course_id, held.course_version),
                       rows_of(store, user_id), now_utc);
}

std::vector<CourseStanding> course_standings(Store& store, int64_t user_id,
                                             const std::string& now_utc) {
    std::vector<CourseStanding> standings;
    const CourseRows rows = rows_of(store, user_id);
    for (const AssignmentRecord& each : store.courses().assignments(user_id)) {
        // Assigned by person and by group: the one that is due first counts.
        const bool there =
            std::any_of(standings.begin(), standings.end(),
                        [&](const CourseStanding& one) { return one.course.id == each.course_id; });
        if (there) continue;
        standings.push_back(standing_in(store, user_id, each,
                                        find_course(store, each.course_id, each.course_version),
                                        rows, now_utc));
    }
    return standings;
}

UserRecord find_proctor(Store& store, const std::string& name, int64_t examinee) {
    // Whoever asks, the examinee too, is told no more of others than this.
    const std::optional<UserRecord> found = store.accounts().find_staff(name);
    if (!found && !store.accounts().may_sign_in(name))
        refuse("", Said::that("the proctor \"%1\" has no account here").with(name));
    if (!found)
        refuse("",
               Said::that("\"%1\" is no active educator or administrator and cannot be the proctor")
                   .with(name));
    if (found->id == examinee) refuse("", Said::that("nobody can be their own proctor"));
    return *found;
}

ExamOrder prepare_exam(Store& store, int64_t user_id, const std::string& course_id,
                       const std::string& stage_id, const std::string& proctor,
                       const std::string& device_certificate, const std::string& now_utc) {
    const CourseStanding standing = course_standing(store, user_id, course_id, now_utc);
    const std::string what = "exam " + course_id + "/" + stage_id + ": ";
    if (const auto problem = why_no_exam(standing, stage_id)) refuse(what, *problem);
    const curriculum::CourseStage* stage = standing.course.stage(stage_id);
    if (stage->exam.proctor && proctor.empty())
        refuse(what, Said::that("the proctor's name is missing"));
    if (!proctor.empty()) (void)find_proctor(store, proctor, user_id);
    if (stage->exam.haptic_certificate && device_certificate.empty())
        refuse(what, Said::that("the device has no haptic certificate"));
    return {{course_id, standing.course.version, stage_id, proctor, device_certificate, 0},
            stage->task_id,
            progress_of(standing, stage_id).next_seed};
}

ExamOrder begin_exam(Store& store, int64_t user_id, const ExamOrder& order) {
    ExamOrder begun = order;
    begun.context.begin = store.courses().begin_exam(user_id, order);
    return begun;
}

CertificateRecord issue_certificate(Store& store, int64_t user_id, const std::string& course_id,
                                    const std::string& now_utc) {
    const CourseStanding standing = course_standing(store, user_id, course_id, now_utc);
    if (standing.certificate) return *standing.certificate;
    if (!standing.progress.mastered)
        refuse("certificate of " + course_id + ": ",
               Said::that("not mastered yet. %1").with(Said::as_is(standing.next.reason)));
    publish_course_on_first_use(store, standing.course);
    return store.courses().save_certificate(user_id, course_id, standing.course.version);
}

}  // namespace placode::db
