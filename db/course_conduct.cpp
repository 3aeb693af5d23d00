// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/course_conduct.h"

#include <set>

#include "curriculum/shipped_definitions.h"
#include "db/course_rows.h"
#include "db/said.h"
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

/// That of the version where the person stands; where that has none, the newest of another one.
/// What was mastered in an older version stays so, whatever a newer one asks for.
std::optional<CertificateRecord> certificate_in(Store& store, int64_t user_id,
                                                const CourseStanding& standing,
                                                const CourseRows& rows,
                                                const std::string& now_utc) {
    // On a server a row can be added by SQL, with any version and date.
    const auto stands = [&](const CertificateRecord& each) {
        if (each.course_version == standing.course.version)
            return standing.progress.mastered && may_stand(each, standing.progress.mastered_utc);
        const auto text = store.definitions().find("course", each.course_id, each.course_version);
        if (each.course_version == 0 || !text) return false;
        const curriculum::CourseProgress then =
            progress_in(curriculum::load_published_course(text->json, "course " + each.course_id),
                        rows, now_utc);
        return then.mastered && may_stand(each, then.mastered_utc);
    };
    std::optional<CertificateRecord> found;
    for (const CertificateRecord& each : store.courses().certificates(user_id)) {
        if (each.course_id != standing.course.id || !stands(each)) continue;
        if (each.course_version == standing.course.version) return each;
        found = each;
    }
    return found;
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
    standing.certificate = certificate_in(store, user_id, standing, rows, now_utc);
    return standing;
}

}  // namespace

Course find_course(Store& store, const std::string& course_id, int version) {
    if (const auto published = store.definitions().find("course", course_id, version))
        return curriculum::load_published_course(published->json, "course " + course_id);
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

CourseStanding course_standing(Store& store, int64_t user_id, const std::string& course_id,
                               const std::string& now_utc) {
    AssignmentRecord held;
    for (const AssignmentRecord& each :
         held_assignments(store.courses().assignments(user_id), now_utc))
        if (each.course_id == course_id) held = each;
    return standing_in(store, user_id, held, find_course(store, course_id, held.course_version),
                       rows_of(store, user_id), now_utc);
}

std::vector<CourseStanding> course_standings(Store& store, int64_t user_id,
                                             const std::string& now_utc) {
    std::vector<CourseStanding> standings;
    const CourseRows rows = rows_of(store, user_id);
    for (const AssignmentRecord& each :
         held_assignments(store.courses().assignments(user_id), now_utc))
        standings.push_back(standing_in(store, user_id, each,
                                        find_course(store, each.course_id, each.course_version),
                                        rows, now_utc));
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
    // A version that is mastered has its own, also beside that of an older one.
    if (standing.certificate && (!standing.progress.mastered ||
                                 standing.certificate->course_version == standing.course.version))
        return *standing.certificate;
    if (!standing.progress.mastered)
        refuse("certificate of " + course_id + ": ",
               Said::that("not mastered yet. %1").with(Said::as_is(standing.next.reason)));
    publish_course_on_first_use(store, standing.course);
    return store.courses().save_certificate(user_id, course_id, standing.course.version);
}

}  // namespace placode::db
