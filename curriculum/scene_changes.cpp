// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/scene_changes.h"

#include "curriculum/json_reader.h"

namespace placode::curriculum {

Task with_scene_changes(const Task& task, const std::string& changes_json) {
    const std::string origin = "changes of the scene";
    const Json changes = parse_json(changes_json, origin);
    if (!changes.is_object())
        throw DefinitionError(origin, "", "expected an object with keys of a scene");
    check_schema(changes, "scene", origin, "", Completeness::kPartial);
    if (changes.contains("extends"))
        throw DefinitionError(origin, "/extends", "changes extend the task's scene already");
    Json json = parse_json(task.json, "task " + task.id);
    json["scene"].merge_patch(changes);
    return load_task_text(json.dump(), origin);
}

}  // namespace placode::curriculum
