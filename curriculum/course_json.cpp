// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A course from and to JSON.

#include <algorithm>
#include <set>

#include "curriculum/course.h"
#include "curriculum/json_reader.h"
#include "sim/core/near_word.h"

namespace placode::curriculum {
namespace {

StageMode mode_of(const std::string& name) {
    for (const StageMode mode : {StageMode::kFamiliarisation, StageMode::kExam})
        if (name == stage_mode_name(mode)) return mode;
    return StageMode::kPractice;  // The schema has refused everything else.
}

ExamRule read_exam(const Json& entry, StageMode mode, const std::string& origin,
                   const std::string& pointer) {
    ExamRule exam;
    if (mode != StageMode::kExam) {
        if (entry.contains("exam"))
            throw DefinitionError(origin, pointer + "/exam",
                                  "conditions of an exam on a stage of mode \"" +
                                      std::string(stage_mode_name(mode)) +
                                      "\"; expected \"mode\": \"exam\", or no \"exam\"");
        return exam;
    }
    if (!entry.contains("exam"))
        throw DefinitionError(origin, pointer,
                              "key \"exam\" is missing; expected an object with the list "
                              "\"seeds\": an exam has fixed seeds");
    const Json& json = entry["exam"];
    std::set<uint64_t> seen;
    for (size_t i = 0; i < json["seeds"].size(); ++i) {
        const auto seed = json["seeds"][i].get<uint64_t>();
        if (!seen.insert(seed).second)
            throw DefinitionError(origin, pointer + "/exam/seeds/" + std::to_string(i),
                                  std::to_string(seed) + " stands twice in the list");
        exam.seeds.push_back(seed);
    }
    exam.proctor = json.value("proctor", exam.proctor);
    exam.haptic_certificate = json.value("haptic_certificate", exam.haptic_certificate);
    return exam;
}

/// Of exams alone: practice counts from before the course, too, and nothing stops anybody from
/// doing more of it.
int read_limit(const Json& entry, StageMode mode, bool published, const std::string& origin,
               const std::string& pointer) {
    const int limit = entry.value("max_attempts", 0);
    if (limit == 0 || mode == StageMode::kExam) return limit;
    if (published) return 0;
    throw DefinitionError(origin, pointer + "/max_attempts",
                          "a limit of " + std::to_string(limit) +
                              " attempts at a stage of mode \"" + stage_mode_name(mode) +
                              "\"; only an exam has one: leave \"max_attempts\" out");
}

CourseStage read_stage(const Json& entry, const std::string& origin, const std::string& pointer,
                       bool published, std::set<std::string>& earlier) {
    CourseStage stage;
    stage.task_id = entry["task_id"];
    stage.id = entry.value("id", stage.task_id);
    stage.mode = mode_of(entry.value("mode", std::string()));
    if (stage.mode == StageMode::kFamiliarisation)
        stage.benchmark_points = 0, stage.consecutive = 1;
    stage.benchmark_points = entry.value("benchmark_points", stage.benchmark_points);
    stage.consecutive = entry.value("consecutive", stage.consecutive);
    stage.max_attempts = read_limit(entry, stage.mode, published, origin, pointer);
    stage.remind_after_days = entry.value("remind_after_days", stage.remind_after_days);
    stage.exam = read_exam(entry, stage.mode, origin, pointer);
    if (stage.max_attempts > 0 && stage.max_attempts < stage.consecutive)
        throw DefinitionError(origin, pointer + "/max_attempts",
                              std::to_string(stage.max_attempts) +
                                  " attempts cannot reach the benchmark " +
                                  std::to_string(stage.consecutive) + " times in a row");
    for (const Json& required : entry.value("requires_stages", Json::array())) {
        stage.requires_stages.push_back(required);
        // A stage that waits for itself or for a later one could never open.
        if (!earlier.contains(stage.requires_stages.back()))
            throw DefinitionError(
                origin, pointer + "/requires_stages",
                "\"" + stage.requires_stages.back() + "\" is not the id of an earlier stage");
    }
    if (!earlier.insert(stage.id).second)
        throw DefinitionError(
            origin, pointer + (entry.contains("id") ? "/id" : "/task_id"),
            "\"" + stage.id + "\" is already a stage of this course; give the stage an \"id\"");
    return stage;
}

Json text_json(const LocalText& text) {
    Json json{{"en", text.en}};
    if (!text.pl.empty()) json["pl"] = text.pl;
    return json;
}

Json stage_json(const CourseStage& stage) {
    Json json = Json::object();
    if (stage.id != stage.task_id) json["id"] = stage.id;
    json["task_id"] = stage.task_id;
    if (stage.mode != StageMode::kPractice) json["mode"] = stage_mode_name(stage.mode);
    if (!stage.requires_stages.empty()) json["requires_stages"] = stage.requires_stages;
    json["benchmark_points"] = stage.benchmark_points;
    json["consecutive"] = stage.consecutive;
    if (stage.max_attempts > 0) json["max_attempts"] = stage.max_attempts;
    if (stage.remind_after_days > 0) json["remind_after_days"] = stage.remind_after_days;
    if (stage.mode == StageMode::kExam)
        json["exam"] = {{"seeds", stage.exam.seeds},
                        {"proctor", stage.exam.proctor},
                        {"haptic_certificate", stage.exam.haptic_certificate}};
    return json;
}

Course read_course(const std::string& text, const std::string& origin, bool published) {
    const Json json = parse_json(text, origin);
    check_schema(json, "course", origin);
    Course course;
    course.json = text;
    course.id = json["id"];
    course.version = json["version"];
    course.title = local_text(json["title"]);
    if (json.contains("description")) course.description = local_text(json["description"]);
    std::set<std::string> earlier;
    for (size_t i = 0; i < json["stages"].size(); ++i)
        course.stages.push_back(read_stage(json["stages"][i], origin,
                                           "/stages/" + std::to_string(i), published, earlier));
    return course;
}

}  // namespace

Course load_course_text(const std::string& json, const std::string& origin) {
    return read_course(json, origin, false);
}

Course load_published_course(const std::string& json, const std::string& origin) {
    return read_course(json, origin, true);
}

Course load_course(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("courses", id_or_file);
    const std::string origin = file.string();
    Course course = load_course_text(read_definition(file), origin);
    const std::vector<std::string> tasks = list_definitions("tasks");
    for (size_t i = 0; i < course.stages.size(); ++i) {
        const std::string& task = course.stages[i].task_id;
        if (std::find(tasks.begin(), tasks.end(), task) != tasks.end()) continue;
        std::string known;
        for (const std::string& id : tasks) known += (known.empty() ? "" : ", ") + id;
        throw DefinitionError(origin, "/stages/" + std::to_string(i) + "/task_id",
                              "there is no task \"" + task + "\"; expected one of: " + known +
                                  sim::did_you_mean(task, tasks));
    }
    return course;
}

std::string course_json(const Course& course) {
    Json json{{"id", course.id}, {"version", course.version}, {"title", text_json(course.title)}};
    if (!course.description.en.empty()) json["description"] = text_json(course.description);
    json["stages"] = Json::array();
    for (const CourseStage& stage : course.stages) json["stages"].push_back(stage_json(stage));
    return json.dump(2) + "\n";
}

}  // namespace placode::curriculum
