// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading definitions: syntax with line and column, schemas (draft-7), and messages that say what
// was found and what is expected. Private to curriculum: no other folder sees JSON.

#include <nlohmann/json.hpp>
#include <string>

#include "curriculum/task.h"

namespace placode::curriculum {

using Json = nlohmann::ordered_json;

/// Text of a file. Throws DefinitionError when it cannot be read.
[[nodiscard]] std::string read_definition(const std::filesystem::path& file);

/// Path of a definition: `id_or_file` itself when it ends in .json or holds a '/', else
/// data_folder()/kind/ID.json. Throws DefinitionError listing the known ids.
[[nodiscard]] std::filesystem::path find_definition(const std::string& kind,
                                                    const std::string& id_or_file);

struct NamedDefinition {
    std::filesystem::path file;
    std::string text;
};
/// What the text at `origin` names: from the data folder or, as find_definition(), by a path that
/// is meant from that file; where `origin` is the program's own, from within the program. Throws
/// DefinitionError.
[[nodiscard]] NamedDefinition named_definition(const std::string& kind,
                                               const std::string& id_or_file,
                                               const std::string& origin);

/// Parses; a syntax error becomes a DefinitionError with line and column.
[[nodiscard]] Json parse_json(const std::string& text, const std::string& origin);

/// How strictly `check_schema` looks.
enum class Completeness : uint8_t {
    kWhole,   ///< Required keys must be there.
    kPartial  ///< A merge patch: keys may be missing, null removes.
};

/// Checks `value` against data_folder()/schemas/NAME.schema.json. Throws DefinitionError whose
/// pointer is `prefix` + the place inside `value`. An unknown key names the nearest known one with
/// its unit and range.
void check_schema(const Json& value, const std::string& schema, const std::string& origin,
                  const std::string& prefix = "", Completeness completeness = Completeness::kWhole);

/// {"en": ..., "pl": ...} or a plain string, which is English.
[[nodiscard]] LocalText local_text(const Json& value);

/// A scene on top of the one that it "extends" (RFC 7396), and so on, as one complete object
/// without that key, checked against the scene schema. `origin` is its file. Throws
/// DefinitionError, also for a base that is not there and for scenes that extend one another in a
/// circle.
[[nodiscard]] Json whole_scene(Json scene, const std::string& origin,
                               const std::string& prefix = "");

/// Scene file content to specification and back. Keys are the C++ field names.
/// @pre checked against the scene schema.
[[nodiscard]] sim::OperativeFieldSpec scene_from_json(const Json& scene, const std::string& origin,
                                                      const std::string& prefix);
[[nodiscard]] Json scene_to_json(const sim::OperativeFieldSpec& spec);

}  // namespace placode::curriculum
