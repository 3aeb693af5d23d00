// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl course ...: courses, who is to do them, what is next and why.

#include <fstream>
#include <memory>

#include "db/course_conduct.h"
#include "ui/cli/course_options.h"

namespace placode::cli {
namespace {

using curriculum::Course;
using db::Action;
using db::Scope;

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

/// The group `course` of the parser, and what its commands have in common.
struct CourseGroup {
    CLI::App& course;
    Context& context;
    std::shared_ptr<CourseOptions> options;

    template <class Work>
    CLI::App* command(const char* name, const char* help, Work work) const {
        CLI::App* added = course.add_subcommand(name, help);
        added->callback([&context = context, options = options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    }
    void add_id(CLI::App* to) const {
        to->add_option("ID", options->id, "Id of the course")->required();
        to->add_option("--version", options->version, "Default: the newest published")
            ->check(CLI::Range(1, 1000000));
    }
};

/// list, show, check, publish, import, export
void add_course_text_commands(const CourseGroup& group) {
    group.command("list", "Published and shipped courses",
                  [](const Context& c, const CourseOptions&) { return list_courses(c); });
    group.add_id(group.command("show", "One course with its stages", show));
    group.command("check", "Validates a course file, changes nothing", check)
        ->add_option("FILE", group.options->file, "FILE.json or id of a shipped course")
        ->required();
    for (const bool import : {false, true}) {
        CLI::App* added =
            group.command(import ? "import" : "publish",
                          import ? "Publishes a course file of another centre"
                                 : "Publishes a version for good; a change is a new version",
                          [import](const Context& c, const CourseOptions& o) {
                              return publish(c, o, import ? "imported" : "published");
                          });
        added->add_option("FILE", group.options->file, "FILE.json or id of a shipped course")
            ->required();
        added->add_option("--reason", group.options->reason, "Why there is a new version");
        if (import) added->add_option("--id", group.options->new_id, "Another id for it here");
    }
    CLI::App* exported = group.command("export", "Writes the text of a course", export_course);
    group.add_id(exported);
    exported->add_option("--out", group.options->out, "FILE.json")->required();
}

/// assign, unassign, assignments, grant, next
void add_assignment_commands(const CourseGroup& group) {
    CLI::App* assigned =
        group.command("assign", "Has a person or a group do a course", course_assign);
    group.add_id(assigned);
    assigned->add_option("--user", group.options->user, "Login or number");
    assigned->add_option("--group", group.options->group, "Name or number");
    assigned->add_option("--from", group.options->from, "First day, 2026-11-21");
    assigned->add_option("--due", group.options->due, "Last day");
    group.command("unassign", "Ends an assignment; what was done stays", course_unassign)
        ->add_option("ASSIGNMENT", group.options->assignment, "Number")
        ->required();
    group.command("assignments", "Lists assignments", course_assignments)
        ->add_option("--user", group.options->user, "Those that hold for this person");
    CLI::App* granted =
        group.command("grant", "Grants attempts beyond a stage's limit", course_grant);
    group.add_id(granted);
    granted->add_option("STAGE", group.options->stage, "Id of the stage")->required();
    granted->add_option("--user", group.options->user, "Login or number")->required();
    granted->add_option("--attempts", group.options->attempts, "How many")->capture_default_str();
    granted->add_option("--reason", group.options->reason, "Why")->required();
    CLI::App* following =
        group.command("next", "Where a person stands, what is next and why", course_next);
    following->add_option("--user", group.options->user, "Login or number (default: whoever acts)");
    following->add_option("--course", group.options->id, "Also when it is not assigned");
    following->add_option("--at", group.options->at, "As on this day (default: now)");
}

}  // namespace

void add_course_commands(CLI::App& app, Context& context) {
    CLI::App* course = app.add_subcommand("course", "Courses, assignments, what is next");
    course->require_subcommand(1);
    const CourseGroup group{*course, context, std::make_shared<CourseOptions>()};
    add_course_text_commands(group);
    add_assignment_commands(group);
}

}  // namespace placode::cli
