// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files: whole ones, and those that say what differs from another (RFC 7396).
#include <algorithm>

#include "curriculum/json_reader.h"

namespace placode::curriculum {
namespace {

namespace fs = std::filesystem;

/// Puts a scene on top of the one that it extends, and so on. `files_` are the ones that led here.
class Extension {
 public:
    Extension(const std::string& origin, const std::string& prefix)
        : origin_(origin), prefix_(prefix) {}

    Json whole(Json scene) {
        if (!scene.is_object() || !scene.contains("extends")) {
            check_schema(scene, "scene", origin_, prefix_);
            return scene;
        }
        check_schema(scene, "scene", origin_, prefix_, Completeness::kPartial);
        if (!scene.contains("id"))
            fail("/id", "is missing; expected an id of its own, not that of the scene it extends");
        Json result = base(scene["extends"].get<std::string>());
        scene.erase("extends");
        result.merge_patch(scene);
        check_schema(result, "scene", origin_, prefix_);
        return result;
    }

 private:
    [[noreturn]] void fail(const char* key, const std::string& what) const {
        throw DefinitionError(origin_, prefix_ + key, what);
    }

    Json base(const std::string& id_or_file) {
        NamedDefinition found;
        try {
            found = named_definition("scenes", id_or_file, origin_);
        } catch (const DefinitionError& error) {
            fail("/extends", error.what());
        }
        std::error_code problem;
        const fs::path place = fs::weakly_canonical(found.file, problem);
        if (std::find(files_.begin(), files_.end(), place) != files_.end())
            fail("/extends", "\"" + id_or_file +
                                 "\" extends this scene in turn; expected a scene that stands at "
                                 "the end without another");
        Extension below(found.file.string(), "");
        below.files_ = files_;
        below.files_.push_back(place);
        return below.whole(parse_json(found.text, found.file.string()));
    }

    std::string origin_, prefix_;
    std::vector<fs::path> files_;
};

}  // namespace

Json whole_scene(Json scene, const std::string& origin, const std::string& prefix) {
    return Extension(origin, prefix).whole(std::move(scene));
}

}  // namespace placode::curriculum
