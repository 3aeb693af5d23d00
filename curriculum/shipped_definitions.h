// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the program itself vouches for: the tasks, scenes, courses and questionnaires that it was
// built with, as texts inside of it. A folder of definitions is a matter of whoever starts the
// program ($PLACODE_DATA, --data); these are not, so that nobody makes a task official by putting
// it into a folder.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "curriculum/task.h"

namespace placode::curriculum {

struct EmbeddedDefinition {
    std::string_view kind, id, text;  ///< "tasks", "trace_contour", the file.
};
/// By kind; generated at build from data/.
[[nodiscard]] std::span<const EmbeddedDefinition> embedded_definitions() noexcept;

/// @param kind "tasks", "scenes", "courses", "questionnaires". nullopt: the program has none.
[[nodiscard]] std::optional<std::string> shipped_text(std::string_view kind, std::string_view id);
/// Sorted.
[[nodiscard]] std::vector<std::string> shipped_ids(std::string_view kind);

/// The program's own task, with its scene and whatever that extends from within the program.
/// nullopt: it has none of that id. Throws DefinitionError where data_folder() has no schemas.
[[nodiscard]] std::optional<Task> shipped_task(const std::string& id);

/// The texts of the program stand in this folder, for messages and for scenes that name others.
inline constexpr std::string_view kProgramOrigin = "program:";

}  // namespace placode::curriculum
