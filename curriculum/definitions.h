// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where definitions (tasks, scenes, courses, questionnaires) are found, and how a bad one is
// refused.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace placode::curriculum {

/// A definition that cannot be used: names file, JSON pointer, what was found and what is expected,
/// e.g. `tasks/x.json: /scene/materials/skin: unknown key "youngs_modulus_kpa"; expected
/// "youngs_modulus_pa" (a number from 10 to 1e7)`.
class DefinitionError : public std::runtime_error {
 public:
    DefinitionError(const std::string& file, const std::string& pointer,
                    const std::string& problem);
    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    [[nodiscard]] const std::string& pointer() const noexcept { return pointer_; }

 private:
    std::string file_, pointer_;
};

/// Folder with tasks/, scenes/, courses/, questionnaires/, schemas/: $PLACODE_DATA, else
/// share/placode beside the program, else the source tree it was built from.
[[nodiscard]] std::filesystem::path data_folder();

/// Ids of the shipped definitions of one kind ("tasks", ...), sorted.
[[nodiscard]] std::vector<std::string> list_definitions(const std::string& kind);

}  // namespace placode::curriculum
