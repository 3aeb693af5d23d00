// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paper about people in training: a cohort, one trainee, a certificate.

#include <string>
#include <vector>

#include "assessment/cohort.h"
#include "db/course_conduct.h"
#include "db/store.h"
#include "reports/pass_marks.h"

namespace placode::reports {

/// One person in one task.
struct PersonInTask {
    db::TaskStanding standing;
    assessment::CohortCell standing_now;  ///< Stuck, regressed ..: the rule of the pages.
    std::vector<double> points;           ///< Oldest first.
    std::vector<bool> failed;
};

/// What an educator sees of a group; interrupted attempts are left out.
struct CohortReport {
    std::string group;  ///< Name; "everybody" for all.
    std::string made_utc;
    std::vector<PersonInTask> people;  ///< By name and task.
    PassMarks pass_marks;              ///< Of the attempts in `people`.
    bool demonstration = false;        ///< Some of the people are demonstration accounts.
};

/// group_id 0 = everybody. Throws StoreError(kNotFound).
[[nodiscard]] CohortReport read_cohort_report(db::Store& store, int64_t group_id,
                                              const std::string& now_utc);

/// Who is stuck, who regressed, a figure of each task, a table of everybody. Throws ReportError.
/// Needs a QApplication.
void write_cohort_pdf(const CohortReport& report, const std::string& path);

/// One person: where each course stands and what is next, learning curves, history.
struct TraineeReport {
    db::UserRecord user;
    std::string made_utc;
    std::vector<db::CourseStanding> courses;
    std::vector<PersonInTask> tasks;
    std::vector<db::AttemptRecord> attempts;  ///< Oldest first.
    PassMarks pass_marks;                     ///< Of the attempts in `tasks`.
};
[[nodiscard]] TraineeReport read_trainee_report(db::Store& store, const db::UserRecord& user,
                                                const std::string& now_utc);
void write_trainee_pdf(const TraineeReport& report, const std::string& path);

/// The certificate of a mastered course, one page, in English and in Polish.
void write_certificate_pdf(const db::CertificateRecord& certificate, const db::UserRecord& user,
                           const curriculum::Course& course, const std::string& path);

}  // namespace placode::reports
