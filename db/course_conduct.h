// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What shell and command line do alike with courses: find the published text, say where somebody
// stands and what is next, prepare an exam, issue a certificate.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "curriculum/next_step.h"
#include "db/store.h"

namespace placode::db {

/// The published course, else the shipped one. @param version 0 = the newest published, else the
/// shipped one. Throws DefinitionError when there is neither.
[[nodiscard]] curriculum::Course find_course(Store& store, const std::string& course_id,
                                             int version = 0);

/// Ids of all courses, published or shipped, sorted.
[[nodiscard]] std::vector<std::string> course_ids(Store& store);

/// Publishes a shipped course where its version is not in the store yet, so that what was assigned
/// stays readable whatever happens to the file. Throws as Definitions::publish().
void publish_course_on_first_use(Store& store, const curriculum::Course& course);

/// Titles of a course's tasks, for next_step(); a task that cannot be loaded is left out.
[[nodiscard]] std::map<std::string, curriculum::LocalText> task_titles(
    const curriculum::Course& course);

/// As far as courses care, oldest first. An exam that was begun stands at the time of its begin.
/// @param attempts, begins oldest first; begins that were not finished are used up.
[[nodiscard]] std::vector<curriculum::AttemptOutcome> outcomes_of(
    const std::vector<AttemptRecord>& attempts, const std::vector<ExamBeginRecord>& begins = {});

/// Where somebody stands in one course.
struct CourseStanding {
    AssignmentRecord assignment;  ///< id 0 = not assigned.
    curriculum::Course course;
    curriculum::CourseProgress progress;
    curriculum::NextStep next;
    /// Of this version; where that has none, the newest of another one that still stands.
    std::optional<CertificateRecord> certificate;
};

/// Standing in one course, whether it is assigned or not.
[[nodiscard]] CourseStanding course_standing(Store& store, int64_t user_id,
                                             const std::string& course_id,
                                             const std::string& now_utc);

/// Every assigned course, by due date.
[[nodiscard]] std::vector<CourseStanding> course_standings(Store& store, int64_t user_id,
                                                           const std::string& now_utc);

/// The active educator or administrator who is present at an exam, by login or by name. Throws
/// kRefused for anybody else, and for the examinee.
[[nodiscard]] UserRecord find_proctor(Store& store, const std::string& name, int64_t examinee);

/// What an exam attempt needs, checked: stage open, proctor and certificate there. `seed` is the
/// one to use. Throws kRefused saying what is missing.
struct ExamOrder {
    ExamContext context;
    std::string task_id;
    uint64_t seed = 0;
};
[[nodiscard]] ExamOrder prepare_exam(Store& store, int64_t user_id, const std::string& course_id,
                                     const std::string& stage_id, const std::string& proctor,
                                     const std::string& device_certificate,
                                     const std::string& now_utc);

/// What prepare_exam() gave, begun: the attempt is used up from then on, and `context.begin` is the
/// number that belongs into its order. Throws kRefused; kConflict where the exam was begun at
/// another station meanwhile.
[[nodiscard]] ExamOrder begin_exam(Store& store, int64_t user_id, const ExamOrder& order);

/// Certificate of a mastered course; that of another version where this one is not mastered. Throws
/// kRefused, saying what is next, when there is none either.
CertificateRecord issue_certificate(Store& store, int64_t user_id, const std::string& course_id,
                                    const std::string& now_utc);

}  // namespace placode::db
