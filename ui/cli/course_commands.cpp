// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl course ...: courses, who is to do them, what is next and why.

#include <algorithm>
#include <fstream>
#include <memory>

#include "curriculum/utc_time.h"
#include "db/course_conduct.h"
#include "ui/cli/people.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using curriculum::Course;
using db::Action;
using db::Scope;

struct CourseOptions {
    std::string id, file, user, group, reason, out, from, due, at, stage, new_id;
    int version = 0, attempts = 1;
    int64_t assignment = 0;
};

Json stage_json(const curriculum::CourseStage& stage) {
    Json json{{"id", stage.id},
              {"task", stage.task_id},
              {"mode", curriculum::stage_mode_name(stage.mode)},
              {"requires", stage.requires_stages},
              {"benchmark_points", stage.benchmark_points},
              {"consecutive", stage.consecutive},
              {"max_attempts", stage.max_attempts},
              {"remind_after_days", stage.remind_after_days}};
    if (stage.mode == curriculum::StageMode::kExam)
        json["exam"] = {{"seeds", stage.exam.seeds},
                        {"proctor", stage.exam.proctor},
                        {"haptic_certificate", stage.exam.haptic_certificate}};
    return json;
}

std::string words(const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& each : list) text += (text.empty() ? "" : ", ") + each;
    return text;
}

Json course_head(const Course& course) {
    return {{"id", course.id},
            {"version", course.version},
            {"title", course.title.en},
            {"stages", course.stages.size()}};
}

std::string stage_table(const Course& course) {
    std::vector<std::vector<std::string>> rows{
        {"stage", "task", "mode", "opens after", "benchmark", "in a row", "limit", "repeat after"}};
    for (const auto& stage : course.stages)
        rows.push_back({stage.id, stage.task_id, curriculum::stage_mode_name(stage.mode),
                        words(stage.requires_stages), fixed(stage.benchmark_points, 0),
                        std::to_string(stage.consecutive),
                        stage.max_attempts == 0 ? "-" : std::to_string(stage.max_attempts),
                        stage.remind_after_days == 0
                            ? "-"
                            : std::to_string(stage.remind_after_days) + " days"});
    return table(rows);
}

// --- definitions -------------------------------------------------------------------------------

int list_courses(const Context& context) {
    Session session(context, Missing::kRefuse);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"id", "version", "stages", "published", "title"}};
    for (const std::string& id : db::course_ids(session.store())) {
        const auto published = session.store().definitions().find("course", id);
        const Course course = db::find_course(session.store(), id);
        Json entry = course_head(course);
        entry["published"] = published.has_value();
        if (published) {
            entry["published_by"] = published->published_by;
            entry["published_utc"] = published->published_utc;
            entry["reason"] = published->reason;
        }
        json.push_back(std::move(entry));
        rows.push_back({id, std::to_string(course.version), std::to_string(course.stages.size()),
                        published ? published->published_utc : "shipped", course.title.en});
    }
    print(context, json, table(rows));
    return 0;
}

int show(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const Course course = db::find_course(session.store(), options.id, options.version);
    Json json = course_head(course);
    json["description"] = course.description.en;
    json["stages"] = Json::array();
    for (const auto& stage : course.stages) json["stages"].push_back(stage_json(stage));
    print(context, json,
          course.title.en + " (" + course.id + " version " + std::to_string(course.version) +
              ")\n" + course.description.en + "\n" + stage_table(course));
    return 0;
}

int check(const Context& context, const CourseOptions& options) {
    const Course course = curriculum::load_course(options.file);
    print(context, course_head(course), options.file + ": sound\n" + stage_table(course));
    return 0;
}

int publish(const Context& context, const CourseOptions& options, const char* verb) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageCourses, Scope::kOther);
    Course course = curriculum::load_course(options.file);
    if (!options.new_id.empty()) {
        course.id = options.new_id;
        course.json = curriculum::course_json(course);
        course = curriculum::load_course_text(course.json, options.file + " as " + options.new_id);
    }
    db::DefinitionRecord definition;
    definition.kind = "course";
    definition.id = course.id;
    definition.version = course.version;
    definition.json = course.json;
    definition.reason = options.reason;
    as_input([&] { session.store().definitions().publish(definition); });
    Json json = course_head(course);
    json["checksum"] =
        session.store().definitions().find("course", course.id, course.version)->checksum;
    print(context, json,
          std::string(verb) + " " + course.id + " version " + std::to_string(course.version));
    return 0;
}

int export_course(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageCourses, Scope::kOther);
    const Course course = db::find_course(session.store(), options.id, options.version);
    std::ofstream out(options.out, std::ios::binary | std::ios::trunc);
    out << course.json;
    out.flush();
    if (!out) throw InputError("--out " + options.out + ": cannot be written");
    Json json = course_head(course);
    json["path"] = options.out;
    print(context, json, "wrote " + options.out);
    return 0;
}

// --- assignments -------------------------------------------------------------------------------

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

int assign(const Context& context, const CourseOptions& options) {
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
    const Course course = db::find_course(session.store(), options.id, options.version);
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

db::AssignmentRecord find_assignment(Session& session, int64_t id) {
    for (const auto& each : session.store().courses().assignments(0))
        if (each.id == id) return each;
    throw InputError("assignment " + std::to_string(id) + ": not in " + session.store().url() +
                     "; `placodectl course assignments` shows them");
}

int unassign(const Context& context, const CourseOptions& options) {
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

int assignments(const Context& context, const CourseOptions& options) {
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

int grant(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t user = session.find_user(options.user).id;
    session.need_for(Action::kAssignCourses, user);
    const Course course = db::find_course(session.store(), options.id, options.version);
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

// --- standing ----------------------------------------------------------------------------------

const char* status_name(const curriculum::StageProgress& own) {
    if (own.refresh_due) return "refresh due";
    switch (own.status) {
        case curriculum::StageStatus::kLocked:
            return "locked";
        case curriculum::StageStatus::kOpen:
            return "open";
        case curriculum::StageStatus::kMastered:
            return "mastered";
        case curriculum::StageStatus::kExhausted:
            return "attempts used";
    }
    return "";
}

Json to_json(const db::CourseStanding& standing) {
    const auto& next = standing.next;
    Json json{{"course", standing.course.id},
              {"version", standing.course.version},
              {"assignment", standing.assignment.id},
              {"due_utc", standing.assignment.due_utc},
              {"mastered", standing.progress.mastered},
              {"next",
               {{"kind", curriculum::next_kind_name(next.kind)},
                {"stage", next.stage_id},
                {"task", next.task_id},
                {"to_go", next.to_go},
                {"attempts_left", next.attempts_left},
                {"overdue", next.overdue},
                {"reason", next.reason.en},
                {"reason_pl", next.reason.pl}}},
              {"stages", Json::array()}};
    if (next.kind == curriculum::NextKind::kExam) json["next"]["seed"] = next.seed;
    if (standing.certificate) json["certificate"] = standing.certificate->code;
    for (size_t i = 0; i < standing.course.stages.size(); ++i) {
        const auto& own = standing.progress.stages[i];
        json["stages"].push_back({{"id", standing.course.stages[i].id},
                                  {"task", standing.course.stages[i].task_id},
                                  {"status", status_name(own)},
                                  {"streak", own.streak},
                                  {"attempts", own.attempts},
                                  {"best_points", own.best_points},
                                  {"mastered_utc", own.mastered_utc},
                                  {"refresh_utc", own.refresh_utc}});
    }
    return json;
}

std::string text_of(const db::CourseStanding& standing) {
    std::vector<std::vector<std::string>> rows{{"stage", "status", "streak", "best", "attempts"}};
    for (size_t i = 0; i < standing.course.stages.size(); ++i) {
        const auto& own = standing.progress.stages[i];
        rows.push_back({standing.course.stages[i].id, status_name(own), std::to_string(own.streak),
                        own.attempts == 0 ? "-" : fixed(own.best_points, 1),
                        std::to_string(own.attempts)});
    }
    return standing.course.title.en +
           "\nnext: " + (standing.next.task_id.empty() ? std::string("-") : standing.next.task_id) +
           " (" + curriculum::next_kind_name(standing.next.kind) + "). " + standing.next.reason.en +
           "\n" + table(rows);
}

int next(const Context& context, const CourseOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t whose = named_or_self(session, options.user);
    session.need_for(Action::kViewAttempts, whose);
    const std::string now = options.at.empty() ? now_utc() : options.at;
    if (!curriculum::utc_seconds(now))
        throw InputError("--at " + options.at + ": expected a day such as 2026-11-21");
    std::vector<db::CourseStanding> standings;
    if (options.id.empty())
        standings = db::course_standings(session.store(), whose, now);
    else
        standings.push_back(db::course_standing(session.store(), whose, options.id, now));
    Json json = Json::array();
    std::string text;
    for (const auto& standing : standings) {
        json.push_back(to_json(standing));
        text += (text.empty() ? "" : "\n") + text_of(standing);
    }
    print(context, json,
          text.empty() ? "no course is assigned; `placodectl course next --course ID` shows one "
                         "all the same"
                       : text);
    return 0;
}

}  // namespace

void add_course_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<CourseOptions>();
    CLI::App* course = app.add_subcommand("course", "Courses, assignments, what is next");
    course->require_subcommand(1);
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = course->add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    const auto add_id = [&](CLI::App* to) {
        to->add_option("ID", options->id, "Id of the course")->required();
        to->add_option("--version", options->version, "Default: the newest published")
            ->check(CLI::Range(1, 1000000));
    };
    command("list", "Published and shipped courses",
            [](const Context& c, const CourseOptions&) { return list_courses(c); });
    add_id(command("show", "One course with its stages", show));
    command("check", "Validates a course file, changes nothing", check)
        ->add_option("FILE", options->file, "FILE.json or id of a shipped course")
        ->required();
    for (const bool import : {false, true}) {
        CLI::App* added =
            command(import ? "import" : "publish",
                    import ? "Publishes a course file of another centre"
                           : "Publishes a version for good; a change is a new version",
                    [import](const Context& c, const CourseOptions& o) {
                        return publish(c, o, import ? "imported" : "published");
                    });
        added->add_option("FILE", options->file, "FILE.json or id of a shipped course")->required();
        added->add_option("--reason", options->reason, "Why there is a new version");
        if (import) added->add_option("--id", options->new_id, "Another id for it here");
    }
    CLI::App* exported = command("export", "Writes the text of a course", export_course);
    add_id(exported);
    exported->add_option("--out", options->out, "FILE.json")->required();

    CLI::App* assigned = command("assign", "Has a person or a group do a course", assign);
    add_id(assigned);
    assigned->add_option("--user", options->user, "Login or number");
    assigned->add_option("--group", options->group, "Name or number");
    assigned->add_option("--from", options->from, "First day, 2026-11-21");
    assigned->add_option("--due", options->due, "Last day");
    command("unassign", "Ends an assignment; what was done stays", unassign)
        ->add_option("ASSIGNMENT", options->assignment, "Number")
        ->required();
    command("assignments", "Lists assignments", assignments)
        ->add_option("--user", options->user, "Those that hold for this person");
    CLI::App* granted = command("grant", "Grants attempts beyond a stage's limit", grant);
    add_id(granted);
    granted->add_option("STAGE", options->stage, "Id of the stage")->required();
    granted->add_option("--user", options->user, "Login or number")->required();
    granted->add_option("--attempts", options->attempts, "How many")->capture_default_str();
    granted->add_option("--reason", options->reason, "Why")->required();
    CLI::App* following = command("next", "Where a person stands, what is next and why", next);
    following->add_option("--user", options->user, "Login or number (default: whoever acts)");
    following->add_option("--course", options->id, "Also when it is not assigned");
    following->add_option("--at", options->at, "As on this day (default: now)");
}

}  // namespace placode::cli
