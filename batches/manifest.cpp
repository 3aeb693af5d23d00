// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "batches/manifest.h"

#include <algorithm>

#include "batches/batch_error.h"
#include "batches/checksum.h"
#include "curriculum/attempt_runner.h"

namespace placode::batches {
namespace {

namespace fs = std::filesystem;
using Kind = BatchError::Kind;

/// One item a line, so that a person can look at it.
std::string text_of(const Manifest& manifest, bool with_seal) {
    Json head{{"format", kManifestFormat},   {"kind", manifest.kind},
              {"build", manifest.build},     {"options", manifest.options},
              {"tasks", manifest.tasks},     {"shard_size", manifest.shard_size},
              {"shards", manifest.shards()}, {"seal", manifest.seal}};
    if (!with_seal) head.erase("seal");
    std::string text = "{\n";
    for (const auto& [key, value] : head.items())
        text += Json(key).dump() + ": " + value.dump() + ",\n";
    text += "\"items\": [\n";
    for (size_t i = 0; i < manifest.items.size(); ++i)
        text += manifest.items[i].dump() + (i + 1 < manifest.items.size() ? ",\n" : "\n");
    return text + "]}\n";
}

Manifest manifest_from_json(const Json& json) {
    Manifest manifest;
    manifest.kind = json.at("kind").get<std::string>();
    manifest.build = json.at("build").get<std::string>();
    manifest.options = json.at("options");
    manifest.tasks = json.at("tasks");
    manifest.shard_size = json.at("shard_size").get<int>();
    manifest.items = json.at("items");
    manifest.seal = json.at("seal").get<std::string>();
    return manifest;
}

}  // namespace

int Manifest::shards() const {
    const auto size = static_cast<size_t>(std::max(1, shard_size));
    return static_cast<int>((items.size() + size - 1) / size);
}

std::pair<size_t, size_t> Manifest::range(int shard) const {
    const auto size = static_cast<size_t>(std::max(1, shard_size));
    const size_t first = static_cast<size_t>(shard) * size;
    return {std::min(first, items.size()), std::min(first + size, items.size())};
}

std::string build_text(const std::string& program_version) {
    return program_version + ", " + curriculum::this_build();
}

Json task_entry(const std::string& ref) {
    const curriculum::Task task = curriculum::load_task(ref);
    const bool file = ref.find('/') != std::string::npos || ref.ends_with(".json");
    return {{"ref", file ? fs::absolute(ref).lexically_normal().string() : ref},
            {"id", task.id},
            {"version", task.version},
            {"sha256", sha256(task.json)}};
}

curriculum::Task task_of_entry(const Json& entry, const fs::path& folder) {
    const auto ref = entry.at("ref").get<std::string>();
    const fs::path brought = own_input(folder, entry.at("sha256").get<std::string>(), ".json");
    curriculum::Task task = curriculum::load_task(fs::exists(brought) ? brought.string() : ref);
    if (sha256(task.json) != entry.at("sha256").get<std::string>())
        throw BatchError(Kind::kBadInput,
                         "task " + ref +
                             ": differs from what it was when the batch was planned; put it back "
                             "or plan anew in another folder");
    return task;
}

const Json* entry_of(const Manifest& manifest, const std::string& key, const std::string& value) {
    for (const Json& entry : manifest.tasks)
        if (entry.at(key) == value) return &entry;
    return nullptr;
}

void write_manifest(const fs::path& folder, Manifest& manifest) {
    manifest.seal = sha256(text_of(manifest, false));
    const fs::path path = folder / "manifest.json";
    if (fs::exists(path)) {
        if (read_manifest(folder).seal == manifest.seal) return;
        throw BatchError(Kind::kBadInput, path.string() +
                                              ": another batch is there; choose another folder, or "
                                              "remove that one");
    }
    std::error_code error;
    for (const char* part : {"shards", "logs"}) fs::create_directories(folder / part, error);
    if (error)
        throw BatchError(Kind::kBadInput, folder.string() + ": cannot be made a folder (" +
                                              error.message() + "); choose another place");
    write_whole(path, text_of(manifest, true));
}

Manifest read_manifest(const fs::path& folder) {
    const fs::path path = folder / "manifest.json";
    if (!fs::exists(path))
        throw BatchError(Kind::kBadInput, folder.string() +
                                              ": holds no manifest.json; expected the folder of a "
                                              "batch, see `placodectl batch plan --help`");
    Manifest manifest;
    const std::string text = read_text(path);
    try {
        const Json json = Json::parse(text);
        if (const int format = json.at("format").get<int>(); format != kManifestFormat)
            throw BatchError(Kind::kBadInput, path.string() + ": format " + std::to_string(format) +
                                                  "; this program reads format " +
                                                  std::to_string(kManifestFormat));
        manifest = manifest_from_json(json);
    } catch (const Json::exception& error) {
        throw BatchError(Kind::kBadInput, path.string() + ": is damaged (" + error.what() +
                                              "); plan anew in another folder");
    }
    if (sha256(text_of(manifest, false)) != manifest.seal || text_of(manifest, true) != text)
        throw BatchError(Kind::kBadInput,
                         path.string() +
                             ": was changed after it had been written: its seal does not fit; put "
                             "the old text back, or plan anew in another folder");
    return manifest;
}

fs::path own_input(const fs::path& folder, const std::string& sha256, const std::string& ending) {
    return folder / "inputs" / (sha256 + ending);
}

fs::path input_path(const fs::path& folder, const Json& item) {
    const fs::path brought = own_input(folder, item.at("sha256").get<std::string>());
    if (fs::exists(brought)) return brought;
    const fs::path path = item.at("recording").get<std::string>();
    return path.is_absolute() ? path : folder / path;
}

}  // namespace placode::batches
