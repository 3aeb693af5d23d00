// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/courses.h"

#include "curriculum/utc_time.h"
#include "db/course_rows.h"
#include "db/packing.h"
#include "db/store_context.h"

namespace placode::db {
namespace {

using Kind = StoreError::Kind;

/// NULL for 0: the table says "nobody" so.
Statement& bind_target(Statement& insert, const AssignmentRecord& a, const std::string& actor) {
    return insert.run(a.course_id, a.course_version, OrNull{a.user_id}, OrNull{a.group_id},
                      a.starts_utc, a.due_utc, actor, utc_now());
}

void check_dates(const Connection& connection, const AssignmentRecord& a) {
    const auto starts = curriculum::utc_seconds(a.starts_utc);
    const auto due = curriculum::utc_seconds(a.due_utc);
    for (const auto& [text, value] : {std::pair{a.starts_utc, starts}, {a.due_utc, due}})
        if (!text.empty() && !value)
            connection.fail(Kind::kRefused,
                            Said::that("found the date \"%1\"; expected a day such as %2")
                                .with(text)
                                .with("2026-11-21"));
    // A day is due to its end.
    const int64_t day_s = a.due_utc.size() == 10 ? 86400 : 0;
    if (starts && due && *due + day_s <= *starts)
        connection.fail(Kind::kRefused, Said::that("the course is due before it begins"));
}

}  // namespace

Courses::Courses(StoreContext& context) : context_(context), connection_(context.connection) {}

int64_t Courses::assign(const AssignmentRecord& assignment) {
    connection_.begin_operation("assign the course \"" + assignment.course_id + "\" in");
    assignment.group_id != 0 ? context_.need_for_group(Action::kAssignCourses, assignment.group_id)
                             : context_.need_for(Action::kAssignCourses, assignment.user_id);
    check_dates(connection_, assignment);
    if ((assignment.user_id == 0) == (assignment.group_id == 0))
        connection_.fail(Kind::kRefused,
                         Said::that("a course is assigned to a person or to a group"));
    UnitOfWork work(connection_);
    connection_.lock_table("course_assignments");
    if (assignment.user_id != 0)
        (void)context_.need_user(assignment.user_id);
    else
        context_.need_group(assignment.group_id);
    if (assignment.course_version == 0 ||
        !context_.find_definition("course", assignment.course_id, assignment.course_version))
        connection_.fail(Kind::kRefused, Said::that("version %1 is not published; publish it first")
                                             .with(assignment.course_version));
    Statement there(connection_,
                    "SELECT id FROM course_assignments WHERE course_id = ? AND ended_utc = '' AND "
                    "COALESCE(account_id, 0) = ? AND COALESCE(group_id, 0) = ?");
    if (there.run(assignment.course_id, assignment.user_id, assignment.group_id).next())
        connection_.fail(Kind::kConflict,
                         Said::that("it is assigned already (assignment %1); end that one first")
                             .with(there.text(0)));
    Statement insert(connection_,
                     "INSERT INTO course_assignments (course_id, course_version, account_id, "
                     "group_id, starts_utc, due_utc, assigned_by, assigned_utc, ended_utc) VALUES "
                     "(?, ?, ?, ?, ?, ?, ?, ?, '') RETURNING id");
    const int64_t id = bind_target(insert, assignment, context_.actor.name).returned_id();
    context_.made("assignment", id);
    context_.append_audit(
        "course.assign",
        assignment.user_id != 0 ? "user " + std::to_string(assignment.user_id)
                                : "group " + std::to_string(assignment.group_id),
        assignment.course_id + " version " + std::to_string(assignment.course_version));
    work.commit();
    return id;
}

void Courses::end_assignment(int64_t id) {
    connection_.begin_operation("end the assignment " + std::to_string(id) + " in");
    int64_t user = 0, group = 0;
    {
        Statement target(connection_,
                         "SELECT COALESCE(account_id, 0) AS for_user, COALESCE(group_id, 0) AS "
                         "for_group FROM course_assignments WHERE id = ?");
        if (target.run(id).next())
            user = target.integer("for_user"), group = target.integer("for_group");
    }
    group != 0 ? context_.need_for_group(Action::kAssignCourses, group)
               : context_.need_for(Action::kAssignCourses, user);
    UnitOfWork work(connection_);
    Statement query(connection_, "SELECT ended_utc FROM course_assignments WHERE id = ?");
    if (!query.run(id).next()) connection_.fail(Kind::kNotFound, "there is no such assignment");
    if (!query.text(0).empty())
        connection_.fail(Kind::kConflict, Said::that("it ended at %1").with(query.text(0)));
    context_.touch("assignment", id);
    Statement(connection_, "UPDATE course_assignments SET ended_utc = ? WHERE id = ?")
        .run(utc_now(), id);
    context_.append_audit("course.unassign", "assignment " + std::to_string(id), "");
    work.commit();
}

std::vector<AssignmentRecord> Courses::assignments(int64_t user_id) {
    connection_.begin_operation("list assignments of");
    user_id == 0 ? context_.need(Action::kViewAttempts)
                 : context_.need_for(Action::kViewAttempts, user_id);
    // Open-ended ones last.
    Statement query(
        connection_,
        "SELECT id, course_id, course_version, COALESCE(account_id, 0) AS for_user, "
        "COALESCE(group_id, 0) AS for_group, starts_utc, due_utc, assigned_by, "
        "assigned_utc, ended_utc FROM course_assignments WHERE ? = 0 OR (ended_utc = '' AND "
        "(account_id = ? OR group_id IN (SELECT group_id FROM group_members WHERE "
        "account_id = ? AND teaches = 0))) ORDER BY CASE WHEN due_utc = '' THEN 1 ELSE "
        "0 END, due_utc, id");
    query.run(static_cast<int>(user_id != 0), user_id, user_id);
    std::vector<AssignmentRecord> found;
    while (query.next())
        found.push_back({query.integer("id"), query.text("course_id"),
                         static_cast<int>(query.integer("course_version")),
                         query.integer("for_user"), query.integer("for_group"),
                         query.text("starts_utc"), query.text("due_utc"), query.text("assigned_by"),
                         query.text("assigned_utc"), query.text("ended_utc")});
    context_.show_names(found, &AssignmentRecord::assigned_by);
    return found;
}

void Courses::grant_attempts(const GrantRecord& grant) {
    connection_.begin_operation("grant attempts in");
    context_.need_for(Action::kAssignCourses, grant.user_id);
    if (grant.attempts < 1 || grant.attempts > 1000)
        connection_.fail(Kind::kRefused,
                         Said::that("found %1; expected 1 to 1000").with(grant.attempts));
    if (grant.reason.empty())
        connection_.fail(Kind::kRefused, Said::that("a grant needs a reason"));
    UnitOfWork work(connection_);
    (void)context_.need_user(grant.user_id);
    context_.touch("user", grant.user_id);
    Statement(connection_,
              "INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
              "granted_by, granted_utc) VALUES (?, ?, ?, ?, ?, ?, ?)")
        .run(grant.user_id, grant.course_id, grant.stage_id, grant.attempts, grant.reason,
             context_.actor.name, utc_now());
    context_.append_audit("course.grant", "user " + std::to_string(grant.user_id),
                          grant.course_id + "/" + grant.stage_id + " +" +
                              std::to_string(grant.attempts) + ": " +
                              context_.without_names(grant.reason));
    work.commit();
}

std::vector<GrantRecord> Courses::grants(int64_t user_id) {
    connection_.begin_operation("list granted attempts of");
    context_.need_for(Action::kViewAttempts, user_id);
    Statement query(connection_,
                    "SELECT account_id, course_id, stage_id, attempts, reason, granted_by, "
                    "granted_utc FROM course_grants WHERE account_id = ? ORDER BY id");
    query.run(user_id);
    std::vector<GrantRecord> found;
    while (query.next())
        found.push_back({query.integer("account_id"), query.text("course_id"),
                         query.text("stage_id"), static_cast<int>(query.integer("attempts")),
                         query.text("reason"), query.text("granted_by"),
                         query.text("granted_utc")});
    context_.show_names(found, &GrantRecord::granted_by);
    return found;
}

namespace {

constexpr const char* kCertificateColumns =
    "SELECT id, account_id, course_id, course_version, mastered_utc, issued_utc, issued_by, code "
    "FROM certificates ";

CertificateRecord read_certificate(const Statement& row) {
    return {row.integer("id"),        row.integer("account_id"),
            row.text("course_id"),    static_cast<int>(row.integer("course_version")),
            row.text("mastered_utc"), row.text("issued_utc"),
            row.text("issued_by"),    row.text("code")};
}

/// When the rows say that this version was mastered. Throws kRefused: they do not.
std::string mastered_at(StoreContext& context, int64_t user_id, const std::string& course_id,
                        int version, const std::string& now_utc) {
    const auto published =
        version == 0 ? std::nullopt : context.find_definition("course", course_id, version);
    if (!published)
        context.connection.fail(
            Kind::kRefused,
            Said::that("version %1 is not published; publish it first").with(version));
    const curriculum::CourseProgress progress =
        progress_in(curriculum::load_published_course(published->json, "course " + course_id),
                    course_rows(context, context.need_owner(user_id)), now_utc);
    if (!progress.mastered)
        context.connection.fail(Kind::kRefused, Said::that("the course is not mastered"));
    return progress.mastered_utc;
}

}  // namespace

CertificateRecord Courses::save_certificate(int64_t user_id, const std::string& course_id,
                                            int course_version) {
    connection_.begin_operation("issue a certificate in");
    context_.need_for(Action::kIssueCertificate, user_id);
    UnitOfWork work(connection_);
    (void)context_.need_user(user_id);
    const auto find = [&]() -> std::optional<CertificateRecord> {
        Statement query(connection_, std::string(kCertificateColumns) +
                                         "WHERE account_id = ? AND course_id = ? AND "
                                         "course_version = ?");
        if (!query.run(user_id, course_id, course_version).next()) return std::nullopt;
        return read_certificate(query);
    };
    lock_exams(connection_, user_id);
    const std::string now = clock_of_store(connection_);
    // Asked also of one that is there: on a server rows can be added by SQL.
    const std::string mastered_utc = mastered_at(context_, user_id, course_id, course_version, now);
    if (const auto there = find()) {
        if (may_stand(*there, mastered_utc)) return *there;
        connection_.fail(
            Kind::kRefused,
            Said::that("the certificate %1 that is there says that the course was mastered at %2, "
                       "and the attempts say %3; show this to an administrator")
                .with(there->code)
                .with(there->mastered_utc)
                .with(mastered_utc));
    }
    // Short enough to be read out, long enough that nobody guesses one.
    const std::string code =
        checksum_hex(std::to_string(user_id) + "\x1f" + course_id + "\x1f" +
                     std::to_string(course_version) + "\x1f" + mastered_utc + "\x1f" + now)
            .substr(0, 16);
    context_.touch("user", user_id);
    Statement(connection_,
              "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
              "issued_utc, issued_by, code) VALUES (?, ?, ?, ?, ?, ?, ?)")
        .run(user_id, course_id, course_version, mastered_utc, now, context_.actor.name, code);
    context_.append_audit(
        "course.certificate", "user " + std::to_string(user_id),
        course_id + " version " + std::to_string(course_version) + " code " + code);
    const auto saved = find();
    work.commit();
    return *saved;
}

std::vector<CertificateRecord> Courses::certificates(int64_t user_id) {
    connection_.begin_operation("list the certificates of");
    user_id == 0 ? context_.need(Action::kViewAttempts)
                 : context_.need_for(Action::kViewAttempts, user_id);
    Statement query(connection_,
                    std::string(kCertificateColumns) + "WHERE ? = 0 OR account_id = ? ORDER BY id");
    query.run(static_cast<int>(user_id != 0), user_id);
    std::vector<CertificateRecord> found;
    while (query.next()) found.push_back(read_certificate(query));
    context_.show_names(found, &CertificateRecord::issued_by);
    return found;
}

}  // namespace placode::db
