// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/task.h"

#include <algorithm>
#include <array>
#include <set>

#include "curriculum/first_view.h"
#include "curriculum/json_reader.h"
#include "curriculum/shipped_definitions.h"
#include "sim/core/near_word.h"
#include "sim/core/number_text.h"

namespace placode::curriculum {

namespace {

/// A metric by its id. Throws where there is none of that name.
std::string read_metric(const Json& json, const std::string& origin, const std::string& pointer) {
    const std::string id = json;
    if (assessment::metric_definition(id) != nullptr) return id;
    std::set<std::string> metrics;  // In the order of the alphabet.
    for (const assessment::MetricDefinition& metric : assessment::metric_definitions())
        metrics.insert(std::string(metric.id));
    std::string known;
    for (const std::string& name : metrics) known += (known.empty() ? "" : ", ") + name;
    throw DefinitionError(origin, pointer,
                          "unknown metric \"" + id + "\"; expected one of: " + known +
                              sim::did_you_mean(id, {metrics.begin(), metrics.end()}));
}

assessment::RubricItem read_item(const Json& json, const std::string& origin,
                                 const std::string& pointer) {
    assessment::RubricItem item;
    item.id = json["id"];
    item.metric = read_metric(json["metric"], origin, pointer + "/metric");
    const LocalText reason =
        json["reason"].is_string() ? LocalText{json["reason"], {}} : local_text(json["reason"]);
    item.reason = reason.en;
    item.reason_pl = reason.pl;
    item.threshold = json.value("threshold", item.threshold);
    item.points_per_unit = json.value("points_per_unit", item.points_per_unit);
    item.points_fixed = json.value("points_fixed", item.points_fixed);
    item.max_points = json.value("max_points", item.max_points);
    item.critical = json.value("critical", item.critical);
    item.below = json.value("below", item.below);
    item.earns = json.value("earns", item.earns);
    if (item.earns > 0 && (!item.below || !(item.threshold > 0)))
        throw DefinitionError(origin, pointer + "/earns",
                              "needs \"below\": true and a threshold above 0, at which all of it "
                              "is earned");
    return item;
}

assessment::Rubric read_rubric(const Json& json, const std::string& origin) {
    assessment::Rubric rubric;
    rubric.id = json["id"];
    rubric.version = json["version"];
    rubric.start_points = json.value("start_points", rubric.start_points);
    rubric.pass_points = json.value("pass_points", rubric.pass_points);
    for (size_t i = 0; i < json["items"].size(); ++i)
        rubric.items.push_back(
            read_item(json["items"][i], origin, "/rubric/items/" + std::to_string(i)));
    if (json.contains("attempted_by"))
        for (size_t i = 0; i < json["attempted_by"].size(); ++i)
            rubric.attempted_by.push_back(read_metric(json["attempted_by"][i], origin,
                                                      "/rubric/attempted_by/" + std::to_string(i)));
    return rubric;
}

constexpr std::string_view kHoldMark = "{hold_s}";

constexpr std::array<const char*, sim::kPracticeKinds> kStepKinds{
    "move",         "depth",       "turn",           "touch",       "cut",         "coag",
    "grasp",        "release",     "trace",          "traction",    "withdraw",    "needle_in",
    "needle_out",   "needle_take", "needle_through", "thread_draw", "patch_take",  "patch_lay",
    "patch_spread", "wash",        "suck",           "undermine",   "needle_show", "needle_lay"};

/// "{hold_s}" in a step's text is the number that the step asks for: no text can promise another.
void fill_hold(std::string& text, double hold_s, char decimal_sign) {
    const size_t mark = text.find(kHoldMark);
    if (mark == std::string::npos) return;
    std::string number = sim::rounded_text(hold_s, 3);
    std::replace(number.begin(), number.end(), '.', decimal_sign);
    text.replace(mark, kHoldMark.size(), number);
}

/// "places_m": targets by where they are in the field, in the order of their marks.
void read_places(const Json& json, const std::string& origin, const std::string& pointer,
                 sim::PracticeStep& goal) {
    if (!json.contains("places_m")) return;
    const Json& places = json["places_m"];
    const auto wanted =
        static_cast<size_t>(sim::finds_targets(goal.kind) ? 0 : sim::targets_of(goal.kind));
    if (places.size() != wanted)
        throw DefinitionError(origin, pointer + "/places_m",
                              "found " + std::to_string(places.size()) + " places; expected " +
                                  std::to_string(wanted) + " for a step of this kind");
    if (json.contains("hour") || json.contains("hour_left") || json.contains("outward_m"))
        throw DefinitionError(origin, pointer + "/places_m",
                              "is said beside hour or outward_m; expected one of both");
    goal.placed = wanted > 0;
    for (size_t i = 0; i < wanted; ++i)
        goal.place_m[i] = sim::Vec2(places[i][0].get<double>(), places[i][1].get<double>());
}

TaskStep read_task_step(const Json& json, const std::string& origin, const std::string& pointer) {
    TaskStep step;
    sim::PracticeStep& goal = step.goal;
    const std::string kind = json["kind"], hand = json.value("hand", "right");
    for (size_t i = 0; i < kStepKinds.size(); ++i)
        if (kind == kStepKinds[i]) goal.kind = static_cast<sim::PracticeKind>(i);
    goal.hand = hand == "left"     ? sim::Hand::kLeft
                : hand == "camera" ? sim::Hand::kCamera
                                   : sim::Hand::kRight;
    goal.distance_m = json.value("distance_m", goal.distance_m);
    goal.turn_rad = json.value("turn_rad", goal.turn_rad);
    goal.hold_s = json.value("hold_s", goal.hold_s);
    goal.hour = json.value("hour", goal.hour);
    goal.hour_left = json.value("hour_left", goal.hour_left);
    goal.outward_m = json.value("outward_m", goal.outward_m);
    read_places(json, origin, pointer, goal);
    goal.tolerance_m = json.value("tolerance_m", goal.tolerance_m);
    goal.take_share = json.value("take_share", goal.take_share);
    // Whoever draws a thread pulls as much as shuts the slit, where nothing else is said.
    if (goal.kind == sim::PracticeKind::kThreadDraw) goal.low_n = 0;
    goal.low_n = json.value("low_n", goal.low_n);
    goal.high_n = json.value("high_n", goal.high_n);
    goal.enough_n = json.value("enough_n", goal.enough_n);
    if (goal.low_n >= goal.high_n)
        throw DefinitionError(origin, pointer + "/low_n", "must be below high_n");
    if (goal.enough_n > 0 && goal.enough_n >= goal.low_n)
        throw DefinitionError(origin, pointer + "/enough_n", "must be below low_n");
    step.text = local_text(json["text"]);
    fill_hold(step.text.en, goal.hold_s, '.');
    fill_hold(step.text.pl, goal.hold_s, ',');
    if (json.contains("hints"))
        for (const auto& [device, text] : json["hints"].items())
            step.hints[device] = local_text(text);
    if (json.contains("devices")) step.devices = json["devices"].get<std::vector<std::string>>();
    return step;
}

/// Places to begin at, behind the steps that they name.
void read_stages(const Json& json, const std::string& origin, Task& task) {
    const auto steps = static_cast<int>(task.steps.size());
    for (const TaskStep& step : task.steps)
        if (!step.devices.empty())
            throw DefinitionError(origin, "/stages",
                                  "some steps are for some devices only; a task with stages has "
                                  "the same steps for all");
    for (size_t i = 0; i < json.size(); ++i) {
        const int before = json[i]["before_step"];
        const std::string pointer = "/stages/" + std::to_string(i) + "/before_step";
        const int least = i == 0 ? 1 : task.stages.back().before_step + 1;
        if (steps < 2)
            throw DefinitionError(origin, pointer,
                                  "found " + std::to_string(before) +
                                      "; the task has no step that comes after another");
        if (before < least || before >= steps)
            throw DefinitionError(origin, pointer,
                                  "found " + std::to_string(before) + "; expected " +
                                      std::to_string(least) + " to " + std::to_string(steps - 1) +
                                      ": the index of a step, behind those of earlier stages");
        task.stages.push_back({before, local_text(json[i]["title"])});
    }
}

/// The scene as one complete object: named file or own object, with the task's changes on top.
Json resolve_scene(const Json& task, const std::string& origin) {
    Json scene;
    if (task["scene"].is_string()) {
        const bool own = origin.starts_with(kProgramOrigin);
        const NamedDefinition named =
            named_definition("scenes", task["scene"], own ? origin : std::string());
        scene = whole_scene(parse_json(named.text, named.file.string()), named.file.string());
    } else {
        scene = whole_scene(task["scene"], origin, "/scene");
    }
    if (task.contains("scene_overrides")) {
        check_schema(task["scene_overrides"], "scene", origin, "/scene_overrides",
                     Completeness::kPartial);
        if (task["scene_overrides"].contains("extends"))
            throw DefinitionError(origin, "/scene_overrides/extends",
                                  "changes of a task extend its scene already");
        scene.merge_patch(task["scene_overrides"]);
        check_schema(scene, "scene", origin, "/scene_overrides");
    }
    return scene;
}

Task read_task(const Json& json, const std::string& origin) {
    check_schema(json, "task", origin);
    Task task;
    task.id = json["id"];
    task.version = json["version"];
    task.title = local_text(json["title"]);
    task.goal = local_text(json["goal"]);
    for (const Json& step : json["instructions"]) task.instructions.push_back(local_text(step));
    task.settle_s = json.value("settle_s", task.settle_s);
    task.time_limit_s = json.value("time_limit_s", task.time_limit_s);
    task.finish_when_cut = json.value("finish_when_cut", task.finish_when_cut);
    if (json.contains("steps")) {
        for (const Json& step : json["steps"])
            task.steps.push_back(
                read_task_step(step, origin, "/steps/" + std::to_string(task.steps.size())));
    }
    if (json.contains("stages")) read_stages(json["stages"], origin, task);
    task.rubric = read_rubric(json["rubric"], origin);

    const Json scene = resolve_scene(json, origin);
    task.scene = scene_from_json(scene, origin, "/scene");
    task.scene_id = task.scene.id;
    if (task.scene.tools.empty() || task.scene.tools.size() > sim::kMaxTools) {
        throw DefinitionError(origin, "/scene/tools",
                              "found " + std::to_string(task.scene.tools.size()) +
                                  " tools; expected 1 to " + std::to_string(sim::kMaxTools));
    }
    aim_scopes(task);

    // What a recording carries: every number spelled out, so that a later default changes nothing.
    Json resolved = json;
    resolved.erase("scene_overrides");
    resolved["settle_s"] = task.settle_s;
    if (task.time_limit_s > 0) resolved["time_limit_s"] = task.time_limit_s;
    resolved["finish_when_cut"] = task.finish_when_cut;
    Json full_scene = scene_to_json(task.scene);
    for (const char* key : {"version", "title"}) {
        if (scene.contains(key)) full_scene[key] = scene[key];
    }
    resolved["scene"] = std::move(full_scene);
    task.json = resolved.dump();
    return task;
}

}  // namespace

double limit_of(const Task& task, double asked_s) noexcept {
    const double own_s = task.time_limit_s > 0 ? task.time_limit_s : kLongestS;
    return asked_s > 0 ? std::min(asked_s, own_s) : own_s;
}

const TaskStage& stage_of(const Task& task, int stage) {
    const auto count = static_cast<int>(task.stages.size());
    if (stage >= 1 && stage <= count) return task.stages[static_cast<size_t>(stage) - 1];
    std::string known;
    for (int i = 0; i < count; ++i)
        known += ", " + std::to_string(i + 1) + " (" +
                 task.stages[static_cast<size_t>(i)].title.en + ")";
    throw DefinitionError(
        "task " + task.id, "/stages",
        "has no stage " + std::to_string(stage) + "; known: 0 (the beginning)" + known);
}

std::vector<TaskStep> steps_for(const Task& task, const std::string& device) {
    const std::string name = device.substr(0, device.find(':'));
    std::vector<TaskStep> steps;
    // Scripts and the operators of an environment (environment/) have no keys to be hinted at.
    for (const TaskStep& step : task.steps) {
        const auto& only = step.devices;
        if (only.empty() || name == "script" || name == "environment" ||
            std::find(only.begin(), only.end(), name) != only.end())
            steps.push_back(step);
    }
    return steps;
}

bool lays_patch(const Task& task) noexcept {
    return std::any_of(task.steps.begin(), task.steps.end(),
                       [](const TaskStep& step) { return sim::is_patch_step(step.goal.kind); });
}

Task load_task(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("tasks", id_or_file);
    return load_task_text(read_definition(file), file.string());
}

LocalText load_task_title(const std::string& id_or_file) {
    const std::filesystem::path file = find_definition("tasks", id_or_file);
    const Json json = parse_json(read_definition(file), file.string());
    if (!json.is_object() || !json.contains("title"))
        throw DefinitionError(file.string(), "/title", "is missing");
    return local_text(json["title"]);
}

std::string rubric_text(const Task& task) {
    return parse_json(task.json, "task " + task.id)["rubric"].dump(2) + "\n";
}

assessment::Rubric load_rubric_text(const std::string& text, const std::string& origin) {
    const Json json = parse_json(text, origin);
    for (const char* key : {"id", "version", "items"})
        if (!json.is_object() || !json.contains(key))
            throw DefinitionError(origin, std::string("/") + key, "is missing in the rubric");
    return read_rubric(json, origin);
}

Task load_task_text(const std::string& json, const std::string& origin) {
    return read_task(parse_json(json, origin), origin);
}

}  // namespace placode::curriculum
