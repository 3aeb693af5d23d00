// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/shipped_definitions.h"

#include <algorithm>

#include "curriculum/json_reader.h"

namespace placode::curriculum {

std::optional<std::string> shipped_text(std::string_view kind, std::string_view id) {
    for (const EmbeddedDefinition& each : embedded_definitions())
        if (each.kind == kind && each.id == id) return std::string(each.text);
    return std::nullopt;
}

std::vector<std::string> shipped_ids(std::string_view kind) {
    std::vector<std::string> ids;
    for (const EmbeddedDefinition& each : embedded_definitions())
        if (each.kind == kind) ids.emplace_back(each.id);
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::optional<Task> shipped_task(const std::string& id) {
    const auto text = shipped_text("tasks", id);
    if (!text) return std::nullopt;
    return load_task_text(*text, std::string(kProgramOrigin) + "tasks/" + id + ".json");
}

NamedDefinition named_definition(const std::string& kind, const std::string& id_or_file,
                                 const std::string& origin) {
    if (origin.starts_with(kProgramOrigin)) {
        NamedDefinition found;
        found.file = std::string(kProgramOrigin) + kind + "/" + id_or_file + ".json";
        auto text = shipped_text(kind, id_or_file);
        if (!text)
            throw DefinitionError(origin, "",
                                  "no definition \"" + id_or_file + "\" in the program's " + kind);
        found.text = std::move(*text);
        return found;
    }
    NamedDefinition found{find_definition(kind, id_or_file), {}};
    // A path is meant from the file that names it.
    if (found.file.is_relative() && !origin.empty())
        found.file = std::filesystem::path(origin).parent_path() / found.file;
    found.text = read_definition(found.file);
    return found;
}

}  // namespace placode::curriculum
