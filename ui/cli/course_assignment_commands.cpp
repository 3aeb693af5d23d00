// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl course assign, unassign, assignments, grant: who is to do which course.

#include "db/course_conduct.h"
#include "ui/cli/course_options.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

using db::Action;

Json to_json(const db::AssignmentRecord& each) {
    Json json{{"id", each.id},
              {"course", each.course_id},
              {"version", each.course_version},
              {"starts_utc", each.starts_utc},
              {"due_utc", each.due_utc},
              {"assigned_by", each.assigned_by},
              {"assigned_utc", each.assigned_utc},
              {"ended_utc", each.ended_utc}};
    if (each.user_id != 0) json["user_id"] = each.user_id;
    if (each.group_id != 0) json["group_id"] = each.group_id;
    return json;
}

db::AssignmentRecord find_assignment(Session& session, int64_t id) {
    for (const auto& each : session.store().courses().assignments(0))
        if (each.id == id) return each;
    throw InputError("assignment " + std::to_string(id) + ": not in " + session.store().url() +
                     "; `placodectl course assignments` shows them");
}

}  // namespace

int course_assign(const Context& context, const CourseOptions& options) {
    if (options.user.empty() == options.group.empty())
        throw InputError(std::string("course assign: found ") +
                         (options.user.empty() ? "neither" : "both") +
                         " of --user and --group; expected one of them");
    Session session(context, Missing::kRefuse);
    db::AssignmentRecord assignment;
    assignment.course_id = options.id;
    assignment.starts_utc = options.from;
    assignment.due_utc = options.due;
    if (options.user.empty()) {
        const db::GroupRecord group = find_group(session, options.group);
        need_for_group(session, Action::kAssignCourses, group);
        assignment.group_id = group.id;
    } else {
        assignment.user_id = session.find_user(options.user).id;
        session.need_for(Action::kAssignCourses, assignment.user_id);
    }
    const curriculum::Course course = db::find_course(session.store(), options.id, options.version);
    assignment.course_version = course.version;
    const int64_t id = as_input([&] {
        db::publish_course_on_first_use(session.store(), course);
        return session.store().courses().assign(assignment);
    });
    print(context, {{"assignment", id}, {"course", course.id}, {"version", course.version}},
          "assignment " + std::to_string(id) + ": " + course.id + " version " +
              std::to_string(course.version) + " to " +
              (options.user.empty() ? "group " + options.group : options.user));
    return 0;
}

int course_unassign(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::AssignmentRecord there = find_assignment(session, options.assignment);
    if (there.user_id != 0)
        session.need_for(Action::kAssignCourses, there.user_id);
    else
        need_for_group(session, Action::kAssignCourses,
                       find_group(session, std::to_string(there.group_id)));
    as_input([&] { session.store().courses().end_assignment(options.assignment); });
    print(context, {{"assignment", options.assignment}, {"ended", true}},
          "assignment " + std::to_string(options.assignment) + " has ended");
    return 0;
}

int course_assignments(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t whose = user_or_all(session, options.user);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"id", "course", "version", "to", "from", "due", "by", "ended"}};
    for (const auto& each : session.store().courses().assignments(whose)) {
        json.push_back(to_json(each));
        rows.push_back({std::to_string(each.id), each.course_id,
                        std::to_string(each.course_version),
                        each.user_id != 0 ? "user " + std::to_string(each.user_id)
                                          : "group " + std::to_string(each.group_id),
                        each.starts_utc, each.due_utc, each.assigned_by, each.ended_utc});
    }
    print(context, json, rows.size() == 1 ? "no assignments" : table(rows));
    return 0;
}

int course_grant(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t user = session.find_user(options.user).id;
    session.need_for(Action::kAssignCourses, user);
    const curriculum::Course course = db::find_course(session.store(), options.id, options.version);
    if (course.stage(options.stage) == nullptr)
        throw InputError("course grant: the course " + course.id + " has no stage \"" +
                         options.stage + "\"; `placodectl course show` lists them");
    as_input([&] {
        session.store().courses().grant_attempts(
            {user, course.id, options.stage, options.attempts, options.reason, {}, {}});
    });
    print(context, {{"user_id", user}, {"stage", options.stage}, {"attempts", options.attempts}},
          "granted " + std::to_string(options.attempts) + " more attempt(s)");
    return 0;
}

}  // namespace placode::cli
