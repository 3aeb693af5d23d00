// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: assignments of courses, granted attempts, certificates.

#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct ExamOrder;
struct StoreContext;

/// `store.courses()`. Every change is one transaction and in the audit trail.
class Courses {
 public:
    explicit Courses(StoreContext& context);

    /// Assigns a published version. Throws kRefused (not published, dates), kConflict (already).
    int64_t assign(const AssignmentRecord& assignment);
    void end_assignment(int64_t id);  ///< Throws kNotFound, kConflict.
    /// What holds for a person, also by group, by due date; user_id 0 = all, also ended ones.
    [[nodiscard]] std::vector<AssignmentRecord> assignments(int64_t user_id);
    void grant_attempts(const GrantRecord& grant);  ///< Throws kRefused.
    [[nodiscard]] std::vector<GrantRecord> grants(int64_t user_id);
    /// From now on an attempt is used up, whatever happens to shell, simulator and recording: the
    /// attempt that is saved under the number that this gives (ExamContext::begin) ends it. What
    /// the exam needs is looked up again, and nobody else begins one of this person meanwhile.
    /// Throws kRefused; kConflict where another case is due by now. In db/exam_begins.cpp.
    [[nodiscard]] int64_t begin_exam(int64_t user_id, const ExamOrder& order);
    [[nodiscard]] std::vector<ExamBeginRecord> exam_begins(int64_t user_id);  ///< Oldest first.
    /// The same certificate again where this version has one. Throws kRefused where the rows do not
    /// show that the course is mastered.
    CertificateRecord save_certificate(int64_t user_id, const std::string& course_id,
                                       int course_version);
    [[nodiscard]] std::vector<CertificateRecord> certificates(int64_t user_id);  ///< 0 = all.

 private:
    StoreContext& context_;
    Connection& connection_;
};

/// Whether a certificate that is there agrees with attempts that say since when the course is
/// mastered: not dated before that, nor after its own day. Attempts that are verified later may
/// show that somebody was there earlier. Both as UTC text.
[[nodiscard]] inline bool may_stand(const CertificateRecord& there,
                                    const std::string& mastered_utc) noexcept {
    return there.mastered_utc >= mastered_utc && there.mastered_utc <= there.issued_utc;
}

}  // namespace placode::db
