// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The rows of one person from which a standing in courses follows, and what follows from them. The
// store itself asks them within a transaction, whoever acts: before an exam is begun, when it is
// saved, and before a certificate is issued.

#include <optional>
#include <string>
#include <vector>

#include "curriculum/course.h"
#include "db/course_conduct.h"

namespace placode::db {

class Connection;
struct StoreContext;

struct CourseRows {
    std::vector<AttemptRecord> attempts;  ///< own_attempts(), oldest first.
    std::vector<ExamBeginRecord> begins;  ///< Oldest first.
    std::vector<GrantRecord> grants;
};

/// What the person did, not what a script showed: that is for accounts that show how it is done.
/// @param demonstration of the account.
[[nodiscard]] std::vector<AttemptRecord> own_attempts(std::vector<AttemptRecord> attempts,
                                                      bool demonstration);

[[nodiscard]] curriculum::CourseProgress progress_in(const curriculum::Course& course,
                                                     const CourseRows& rows,
                                                     const std::string& now_utc);

/// Of the assignments of one person the one that holds in each course, by due date, open-ended ones
/// last. One that has begun comes before one that begins later, then that of the person before that
/// of a group, then the one that is due first.
[[nodiscard]] std::vector<AssignmentRecord> held_assignments(
    std::vector<AssignmentRecord> assignments, const std::string& now_utc);

/// Asks for nobody's rights. Throws StoreError.
[[nodiscard]] CourseRows course_rows(StoreContext& context, const UserRecord& user);

/// course_standing() from the rows, without a certificate. A course that is neither published nor
/// shipped has no stages. Asks for nobody's rights. Throws StoreError, DefinitionError.
[[nodiscard]] CourseStanding standing_from(StoreContext& context, const std::string& course_id,
                                           int64_t user_id, const CourseRows& rows,
                                           const std::string& now_utc);

/// Why an exam of this stage cannot be begun by who stands there; nullopt: it can.
[[nodiscard]] std::optional<Said> why_no_exam(const CourseStanding& standing,
                                              const std::string& stage_id);

/// @pre the course has such a stage.
[[nodiscard]] const curriculum::StageProgress& progress_of(const CourseStanding& standing,
                                                           const std::string& stage_id);

/// The newest version of a task that the store or the program knows; 0 = none.
[[nodiscard]] int newest_task_version(StoreContext& context, const std::string& task_id);

/// Now, as utc_now(), by the clock of the server where there is one: stations have their own.
[[nodiscard]] std::string clock_of_store(Connection& connection);

/// Begins of exams of a person, oldest first. Asks for nobody's rights.
[[nodiscard]] std::vector<ExamBeginRecord> begins_of(Connection& connection, int64_t user_id);

/// Until the transaction ends, nobody else begins or saves an exam of this person.
void lock_exams(Connection& connection, int64_t user_id);

}  // namespace placode::db
