// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// rights_of_methods.h, for norms, groups, courses, reviews and published texts.

#include "curriculum/standard.h"
#include "db/consent_encryption.h"
#include "db/course_conduct.h"
#include "db/signature.h"
#include "tests/rights_of_methods.h"

namespace placode::test {

inline db::DefinitionRecord definition(const std::string& kind, const std::string& id, int version,
                                       const std::string& json) {
    db::DefinitionRecord made;
    made.kind = kind;
    made.id = id;
    made.version = version;
    made.json = json;
    made.reason = "because";
    return made;
}

inline std::vector<Method> methods_of_training() {
    const std::vector<Needed> sets{{Action::kSetStandards}}, uses{{Action::kUseStore}};
    const std::vector<Needed> persons{{Action::kViewAttempts, About::kPerson}};
    const std::vector<Needed> all{{Action::kViewAttempts}};
    const std::vector<Action> keeps_key{Action::kSetStandards, Action::kBackup};
    return {
        {"norms.measured_attempts",
         all,
         {},
         [](Call& c) { (void)c.store.norms().measured_attempts(0, "diathermy_ring"); }},
        {"norms.measured_attempts",
         persons,
         {},
         [](Call& c) {
             (void)c.store.norms().measured_attempts(c.subject.person, "diathermy_ring");
         }},
        {"norms.centre_key", uses, {}, [](Call& c) { (void)c.store.norms().centre_key(); }},
        {"norms.open_centre_key",
         sets,
         {},
         [](Call& c) { (void)c.store.norms().open_centre_key("Here", kPassphrase); }},
        {"norms.seal_centre_key",
         {},
         keeps_key,
         [](Call& c) { c.store.norms().seal_centre_key(kPassphrase); },
         false,
         true},
        {"norms.change_key_passphrase",
         {},
         keeps_key,
         [](Call& c) { c.store.norms().change_key_passphrase(kPassphrase, kPassphrase); },
         false,
         true},
        {"norms.renew_centre_key",
         {},
         keeps_key,
         [](Call& c) { c.store.norms().renew_centre_key(kPassphrase); },
         false,
         true},
        {"norms.exported_centre_key",
         {},
         keeps_key,
         [](Call& c) { (void)c.store.norms().exported_centre_key(); },
         false,
         true},
        {"norms.take_centre_key",
         {},
         keeps_key,
         [](Call& c) { c.store.norms().take_centre_key("", kPassphrase, false); },
         false,
         true},
        {"norms.centre_name", uses, {}, [](Call& c) { (void)c.store.norms().centre_name(); }},
        {"norms.trust_centre",
         sets,
         {},
         [](Call& c) { c.store.norms().trust_centre(db::new_key_pair().public_key, "There"); }},
        {"norms.trusted_centres",
         sets,
         {},
         [](Call& c) { (void)c.store.norms().trusted_centres(); }},
        {"norms.save", sets, {}, [](Call& c) { c.store.norms().save({}); }, false, true},
        {"norms.list", uses, {}, [](Call& c) { (void)c.store.norms().list(""); }},
        {"norms.use", sets, {}, [](Call& c) { c.store.norms().use(99); }, false, true},
        {"groups.create",
         {{Action::kManageGroups, About::kNewGroup}},
         {},
         [](Call& c) { c.store.groups().create("New"); }},
        {"groups.set_role",
         {{Action::kManageGroups, About::kGroup}, {Action::kManageGroups, About::kPerson}},
         {},
         [](Call& c) {
             c.store.groups().set_role(c.subject.group, c.subject.person, db::GroupRole::kMember);
         }},
        {"groups.set_role",  // Nobody draws people of other groups into the own one.
         {{Action::kManageGroups, About::kPerson}},
         {},
         [](Call& c) {
             c.store.groups().set_role(c.world.free, c.subject.person, db::GroupRole::kMember);
         }},
        {"groups.list", uses, {}, [](Call& c) { (void)c.store.groups().list(); }},
        {"groups.in_reach",
         uses,
         {},
         [](Call& c) { (void)c.store.groups().in_reach(c.me, c.subject.person); }},
        {"groups.in_reach",
         {{Action::kManageGroups, About::kNewGroup}},
         {},
         [](Call& c) { (void)c.store.groups().in_reach(c.world.teacher, c.subject.person); }},
        {"courses.assign",
         {{Action::kAssignCourses, About::kPerson}},
         {},
         [](Call& c) {
             c.store.courses().end_assignment(c.subject.assignment);
             db::AssignmentRecord assignment;
             assignment.course_id = "first_steps";
             assignment.course_version = curriculum::load_course("first_steps").version;
             assignment.user_id = c.subject.person;
             c.store.courses().assign(assignment);
         }},
        {"courses.assign",
         {{Action::kAssignCourses, About::kGroup}},
         {},
         [](Call& c) {
             db::AssignmentRecord assignment;
             assignment.course_id = "first_steps";
             assignment.course_version = curriculum::load_course("first_steps").version;
             assignment.group_id = c.subject.group;
             c.store.courses().assign(assignment);
         }},
        {"courses.end_assignment",
         {{Action::kAssignCourses, About::kPerson}},
         {},
         [](Call& c) { c.store.courses().end_assignment(c.subject.assignment); }},
        {"courses.assignments", all, {}, [](Call& c) { (void)c.store.courses().assignments(0); }},
        {"courses.assignments",
         persons,
         {},
         [](Call& c) { (void)c.store.courses().assignments(c.subject.person); }},
        {"courses.grant_attempts",
         {{Action::kAssignCourses, About::kPerson}},
         {},
         [](Call& c) {
             c.store.courses().grant_attempts(
                 {c.subject.person, "first_steps", "touch", 1, "a power cut", {}, {}});
         }},
        {"courses.grants",
         persons,
         {},
         [](Call& c) { (void)c.store.courses().grants(c.subject.person); }},
        {"courses.save_certificate",
         {{Action::kIssueCertificate, About::kPerson}},
         {},
         [](Call& c) { c.store.courses().save_certificate(c.subject.person, "first_steps", 1); },
         false,
         true},
        {"courses.begin_exam",
         {{Action::kPerformAttempt, About::kPerson}},
         {},
         [](Call& c) { (void)c.store.courses().begin_exam(c.subject.person, {}); },
         false,
         true},
        {"courses.exam_begins",
         persons,
         {},
         [](Call& c) { (void)c.store.courses().exam_begins(c.subject.person); }},
        {"courses.certificates", all, {}, [](Call& c) { (void)c.store.courses().certificates(0); }},
        {"courses.certificates",
         persons,
         {},
         [](Call& c) { (void)c.store.courses().certificates(c.subject.person); }},
        {"reviews.add_comment",
         {{Action::kRemark, About::kAttempt}},
         {},
         [](Call& c) {
             c.store.reviews().add_comment({0, c.subject.attempt, c.me, "", -1, "Good.", ""});
         }},
        {"reviews.set_comment_removed",
         {{Action::kReviewAttempts, About::kAttempt}},
         {},
         [](Call& c) { c.store.reviews().set_comment_removed(c.subject.remark, true); }},
        {"reviews.comments",
         {},
         {},
         [](Call& c) { (void)c.store.reviews().comments(c.subject.attempt); },
         true},
        {"reviews.comments_of",
         {},
         {},
         [](Call& c) { (void)c.store.reviews().comments_of({c.subject.attempt}); },
         true},
        {"reviews.save_rating",
         {{Action::kReviewAttempts, About::kAttempt}},
         {},
         [](Call& c) {
             db::RatingRecord rating;
             rating.attempt_id = c.subject.attempt;
             rating.rater_id = c.me;
             rating.questionnaire_id = "osats";
             c.store.reviews().save_rating(rating);
         }},
        {"reviews.ratings",
         {},
         {Action::kViewAttempts, Action::kExportStudy},
         [](Call& c) { (void)c.store.reviews().ratings("osats"); }},
    };
}

inline std::vector<Method> methods_of_definitions() {
    const std::vector<Needed> uses{{Action::kUseStore}}, runs{{Action::kRunQuestionnaire}};
    const std::vector<Needed> sets{{Action::kSetStandards}}, courses{{Action::kManageCourses}};
    const auto publish = [](const db::DefinitionRecord& record) {
        return [record](Call& c) { c.store.definitions().publish(record); };
    };
    const curriculum::Task task = curriculum::load_task("touch_targets");
    const auto osats = curriculum::load_questionnaire("osats");
    const auto course = curriculum::load_course("full_dissection");
    const auto study = curriculum::load_study("face_content_validity");
    curriculum::PassStandard standard;
    standard.task_id = task.id;
    standard.novice.n = standard.expert.n = 5;
    return {
        // What the program brings along is kept at its first use, whoever that is.
        {"definitions.publish",
         uses,
         {},
         publish(definition("task", task.id, task.version, task.json))},
        {"definitions.publish",
         uses,
         {},
         publish(definition("questionnaire", osats.id, osats.version, osats.json))},
        {"definitions.publish",
         uses,
         {},
         publish(definition("course", course.id, course.version, course.json))},
        {"definitions.publish",
         sets,
         {},
         publish(definition("task", "own_targets", 99, changed(task.json, 99, "own_targets")))},
        {"definitions.publish",
         runs,
         {},
         publish(definition("questionnaire", osats.id, 99, changed(osats.json, 99)))},
        {"definitions.publish",
         courses,
         {},
         publish(definition("course", course.id, 99, changed(course.json, 99)))},
        {"definitions.publish",
         runs,
         {},
         publish(definition("study", study.id, study.version, study.json))},
        {"definitions.publish",
         sets,
         {},
         publish(definition("rubric", task.id + "/" + task.rubric.id, task.rubric.version,
                            curriculum::rubric_text(task)))},
        {"definitions.publish",
         sets,
         {},
         publish(definition("standard", task.id, 1, curriculum::standard_json(standard)))},
        {"definitions.publish",
         runs,
         {},
         publish(definition(
             "consent_seal", RightsWorld::kStudy, 1,
             db::consent_key_json(RightsWorld::kStudy, 1, db::make_consent_keys().public_key)))},
        {"definitions.list", uses, {}, [](Call& c) { (void)c.store.definitions().list("course"); }},
        {"definitions.find",
         uses,
         {},
         [](Call& c) { (void)c.store.definitions().find("course", "first_steps"); }},
    };
}

}  // namespace placode::test
