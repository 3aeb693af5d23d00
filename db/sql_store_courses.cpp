// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Groups, assignments of courses, granted attempts, certificates.

#include <algorithm>

#include "curriculum/course.h"
#include "curriculum/utc_time.h"
#include "db/packing.h"
#include "db/password.h"
#include "db/sql_store.h"

namespace placode::db {

using Kind = StoreError::Kind;

int64_t SqlStore::create_group(const std::string& name) {
    connection_.begin_operation("create the group \"" + name + "\" in");
    const std::string key = login_key(name);
    if (key.empty()) connection_.fail(Kind::kRefused, "the name is empty");
    UnitOfWork work(connection_);
    Statement taken(connection_, "SELECT id FROM training_groups WHERE name_key = ?");
    if (taken.run(key).next())
        connection_.fail(Kind::kConflict, "there is a group of this name; choose another one");
    Statement insert(connection_,
                     "INSERT INTO training_groups (name, name_key, created_utc) VALUES (?, ?, ?) "
                     "RETURNING id");
    insert.run(name, key, utc_now());
    const int64_t id = insert.returned_id();
    append_audit(actor_, "group.create", "group " + std::to_string(id), name);
    work.commit();
    return id;
}

void SqlStore::need_group(int64_t id) {
    Statement query(connection_, "SELECT id FROM training_groups WHERE id = ?");
    if (!query.run(id).next())
        connection_.fail(Kind::kNotFound, "there is no group " + std::to_string(id));
}

void SqlStore::set_group_role(int64_t group_id, int64_t user_id, GroupRole role) {
    connection_.begin_operation("change the group " + std::to_string(group_id) + " in");
    UnitOfWork work(connection_);
    need_group(group_id);
    (void)need_user(user_id);
    Statement(connection_, "DELETE FROM group_members WHERE group_id = ? AND account_id = ?")
        .run(group_id, user_id);
    if (role != GroupRole::kNone)
        Statement(connection_,
                  "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, ?)")
            .run(group_id, user_id, role == GroupRole::kEducator);
    append_audit(actor_, "group.member",
                 "group " + std::to_string(group_id) + " user " + std::to_string(user_id),
                 role == GroupRole::kNone       ? "out"
                 : role == GroupRole::kEducator ? "educator"
                                                : "member");
    work.commit();
}

std::vector<GroupRecord> SqlStore::groups() {
    connection_.begin_operation("list the groups of");
    Statement query(connection_,
                    "SELECT g.id, g.name, g.created_utc, m.account_id, m.teaches FROM "
                    "training_groups g LEFT JOIN group_members m ON m.group_id = g.id ORDER BY "
                    "g.name_key, g.id, m.account_id");
    query.run();
    std::vector<GroupRecord> found;
    while (query.next()) {
        const int64_t id = query.integer("id");
        if (found.empty() || found.back().id != id)
            found.push_back({id, query.text("name"), query.text("created_utc"), {}, {}});
        if (const int64_t member = query.integer("account_id"); member != 0)
            (query.integer("teaches") != 0 ? found.back().educators : found.back().members)
                .push_back(member);
    }
    return found;
}

bool SqlStore::in_reach(int64_t actor, int64_t subject) {
    connection_.begin_operation("look up groups in");
    Statement any(connection_, "SELECT COUNT(*) FROM group_members WHERE account_id = ?");
    if (any.run(subject).next() && any.integer(0) == 0) return true;
    Statement shared(connection_,
                     "SELECT COUNT(*) FROM group_members a JOIN group_members b ON b.group_id = "
                     "a.group_id WHERE a.account_id = ? AND a.teaches = 1 AND b.account_id = ?");
    return shared.run(actor, subject).next() && shared.integer(0) > 0;
}

namespace {

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
                            "found the date \"" + text + "\"; expected a day such as 2026-11-21");
    if (starts && due && *due <= *starts)
        connection.fail(Kind::kRefused, "the course is due before it begins");
}

}  // namespace

int64_t SqlStore::assign_course(const AssignmentRecord& assignment) {
    connection_.begin_operation("assign the course \"" + assignment.course_id + "\" in");
    check_dates(connection_, assignment);
    if ((assignment.user_id == 0) == (assignment.group_id == 0))
        connection_.fail(Kind::kRefused, "a course is assigned to a person or to a group");
    UnitOfWork work(connection_);
    if (assignment.user_id != 0)
        (void)need_user(assignment.user_id);
    else
        need_group(assignment.group_id);
    if (assignment.course_version == 0 ||
        !find_definition("course", assignment.course_id, assignment.course_version))
        connection_.fail(Kind::kRefused, "version " + std::to_string(assignment.course_version) +
                                             " is not published; publish it first");
    Statement there(connection_,
                    "SELECT id FROM course_assignments WHERE course_id = ? AND ended_utc = '' AND "
                    "COALESCE(account_id, 0) = ? AND COALESCE(group_id, 0) = ?");
    if (there.run(assignment.course_id, assignment.user_id, assignment.group_id).next())
        connection_.fail(Kind::kConflict, "it is assigned already (assignment " + there.text(0) +
                                              "); end that one first");
    Statement insert(connection_,
                     "INSERT INTO course_assignments (course_id, course_version, account_id, "
                     "group_id, starts_utc, due_utc, assigned_by, assigned_utc, ended_utc) VALUES "
                     "(?, ?, ?, ?, ?, ?, ?, ?, '') RETURNING id");
    const int64_t id = bind_target(insert, assignment, actor_).returned_id();
    append_audit(actor_, "course.assign",
                 assignment.user_id != 0 ? "user " + std::to_string(assignment.user_id)
                                         : "group " + std::to_string(assignment.group_id),
                 assignment.course_id + " version " + std::to_string(assignment.course_version));
    work.commit();
    return id;
}

void SqlStore::end_assignment(int64_t id) {
    connection_.begin_operation("end the assignment " + std::to_string(id) + " in");
    UnitOfWork work(connection_);
    Statement query(connection_, "SELECT ended_utc FROM course_assignments WHERE id = ?");
    if (!query.run(id).next()) connection_.fail(Kind::kNotFound, "there is no such assignment");
    if (!query.text(0).empty()) connection_.fail(Kind::kConflict, "it ended at " + query.text(0));
    Statement(connection_, "UPDATE course_assignments SET ended_utc = ? WHERE id = ?")
        .run(utc_now(), id);
    append_audit(actor_, "course.unassign", "assignment " + std::to_string(id), "");
    work.commit();
}

std::vector<AssignmentRecord> SqlStore::assignments(int64_t user_id) {
    connection_.begin_operation("list assignments of");
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
    return found;
}

void SqlStore::grant_attempts(const GrantRecord& grant) {
    connection_.begin_operation("grant attempts in");
    if (grant.attempts < 1 || grant.attempts > 1000)
        connection_.fail(Kind::kRefused,
                         "found " + std::to_string(grant.attempts) + "; expected 1 to 1000");
    if (grant.reason.empty()) connection_.fail(Kind::kRefused, "a grant needs a reason");
    UnitOfWork work(connection_);
    (void)need_user(grant.user_id);
    Statement(connection_,
              "INSERT INTO course_grants (account_id, course_id, stage_id, attempts, reason, "
              "granted_by, granted_utc) VALUES (?, ?, ?, ?, ?, ?, ?)")
        .run(grant.user_id, grant.course_id, grant.stage_id, grant.attempts, grant.reason, actor_,
             utc_now());
    append_audit(actor_, "course.grant", "user " + std::to_string(grant.user_id),
                 grant.course_id + "/" + grant.stage_id + " +" + std::to_string(grant.attempts) +
                     ": " + grant.reason);
    work.commit();
}

std::vector<GrantRecord> SqlStore::grants(int64_t user_id) {
    connection_.begin_operation("list granted attempts of");
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

}  // namespace

CertificateRecord SqlStore::save_certificate(int64_t user_id, const std::string& course_id,
                                             int course_version, const std::string& mastered_utc) {
    connection_.begin_operation("issue a certificate in");
    UnitOfWork work(connection_);
    (void)need_user(user_id);
    const auto find = [&]() -> std::optional<CertificateRecord> {
        Statement query(connection_, std::string(kCertificateColumns) +
                                         "WHERE account_id = ? AND course_id = ? AND "
                                         "course_version = ?");
        if (!query.run(user_id, course_id, course_version).next()) return std::nullopt;
        return read_certificate(query);
    };
    if (const auto there = find()) return *there;
    const std::string now = utc_now();
    // Short enough to be read out, long enough that nobody guesses one.
    const std::string code =
        checksum_hex(std::to_string(user_id) + "\x1f" + course_id + "\x1f" +
                     std::to_string(course_version) + "\x1f" + mastered_utc + "\x1f" + now)
            .substr(0, 16);
    Statement(connection_,
              "INSERT INTO certificates (account_id, course_id, course_version, mastered_utc, "
              "issued_utc, issued_by, code) VALUES (?, ?, ?, ?, ?, ?, ?)")
        .run(user_id, course_id, course_version, mastered_utc, now, actor_, code);
    append_audit(actor_, "course.certificate", "user " + std::to_string(user_id),
                 course_id + " version " + std::to_string(course_version) + " code " + code);
    const auto saved = find();
    work.commit();
    return *saved;
}

std::vector<CertificateRecord> SqlStore::certificates(int64_t user_id) {
    connection_.begin_operation("list the certificates of");
    Statement query(connection_,
                    std::string(kCertificateColumns) + "WHERE ? = 0 OR account_id = ? ORDER BY id");
    query.run(static_cast<int>(user_id != 0), user_id);
    std::vector<CertificateRecord> found;
    while (query.next()) found.push_back(read_certificate(query));
    return found;
}

}  // namespace placode::db
