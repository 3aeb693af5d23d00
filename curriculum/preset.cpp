// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/preset.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>

#include "curriculum/json_reader.h"
#include "sim/core/user_folders.h"

namespace placode::curriculum {

namespace fs = std::filesystem;

namespace {

constexpr int kTissueParameters = 4;

ScenePreset read_preset(const Json& json, const std::string& origin) {
    check_schema(json, "preset", origin);
    ScenePreset preset;
    preset.name = json["name"];
    preset.preset_of = json["preset_of"];
    preset.author = json.value("author", "");
    preset.saved_utc = json.value("saved_utc", "");
    preset.cut_power_w = json.value("cut_power_w", preset.cut_power_w);
    preset.coag_power_w = json.value("coag_power_w", preset.coag_power_w);
    if (!json.contains("materials")) return preset;
    for (int i = 0; i < sim::kTissueCount; ++i) {
        const auto tissue = static_cast<sim::Tissue>(i);
        const std::string name(sim::tissue_name(tissue));
        if (!json["materials"].contains(name)) continue;
        const Json& material = json["materials"][name];
        for (int p = 0; p < kTissueParameters; ++p) {
            const auto parameter = static_cast<sim::TuneParameter>(p);
            const std::string key(sim::tune_range(parameter).name);
            if (material.contains(key)) preset.tissues[tissue][parameter] = material[key];
        }
    }
    return preset;
}

/// "Soft skin, Dr. Kowalska" -> "soft_skin_dr_kowalska".
std::string slug(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const auto u = static_cast<unsigned char>(c);
        if (u < 128 && std::isalnum(u) != 0)
            out += static_cast<char>(std::tolower(u));
        else if (!out.empty() && out.back() != '_')
            out += '_';
    }
    while (!out.empty() && out.back() == '_') out.pop_back();
    return out.empty() ? "preset" : out.substr(0, 60);
}

}  // namespace

fs::path preset_folder() {
    if (const char* own = std::getenv("PLACODE_PRESETS"); own != nullptr && *own != '\0')
        return own;
    return sim::user_path(sim::UserFolder::kData, "placode/presets");
}

std::vector<ScenePreset> list_presets() {
    std::vector<ScenePreset> presets;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(preset_folder(), error)) {
        if (entry.path().extension() != ".json") continue;
        try {
            presets.push_back(load_preset(entry.path().string()));
        } catch (const DefinitionError&) {  // someone else's file
        }
    }
    std::sort(presets.begin(), presets.end(),
              [](const ScenePreset& a, const ScenePreset& b) { return a.id < b.id; });
    return presets;
}

ScenePreset load_preset(const std::string& id_or_file) {
    fs::path file = id_or_file;
    if (file.extension() != ".json") file = preset_folder() / (id_or_file + ".json");
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        std::string known;
        for (const auto& entry : fs::directory_iterator(preset_folder(), error))
            if (entry.path().extension() == ".json")
                known += (known.empty() ? "" : ", ") + entry.path().stem().string();
        throw DefinitionError(file.string(), "",
                              "there is no such preset; known: " +
                                  (known.empty() ? "none (F2 in the simulator saves one)" : known));
    }
    ScenePreset preset =
        read_preset(parse_json(read_definition(file), file.string()), file.string());
    preset.id = file.stem().string();
    return preset;
}

fs::path save_preset(ScenePreset& preset) {
    const fs::path folder = preset_folder();
    if (preset.name.empty())
        throw DefinitionError(folder.string(), "/name", "is empty; give the preset a name");
    if (folder.empty())
        throw DefinitionError(preset.name, "", "has no folder; set HOME or PLACODE_PRESETS");
    Json json;
    json["name"] = preset.name;
    json["preset_of"] = preset.preset_of;
    json["author"] = preset.author;
    json["saved_utc"] = preset.saved_utc;
    for (const auto& [tissue, values] : preset.tissues)
        for (const auto& [parameter, value] : values)
            json["materials"][std::string(sim::tissue_name(tissue))]
                [std::string(sim::tune_range(parameter).name)] = value;
    if (preset.cut_power_w >= 0) json["cut_power_w"] = preset.cut_power_w;
    if (preset.coag_power_w >= 0) json["coag_power_w"] = preset.coag_power_w;
    check_schema(json, "preset", preset.name);
    std::error_code error;
    fs::create_directories(folder, error);
    const std::string stem = slug(preset.name);
    preset.id = stem;
    for (int i = 2; fs::exists(folder / (preset.id + ".json"), error); ++i)
        preset.id = stem + "_" + std::to_string(i);
    const fs::path file = folder / (preset.id + ".json"), part = folder / (preset.id + ".part");
    std::ofstream out(part, std::ios::binary);
    out << json.dump(2) << '\n';
    out.close();
    if (!out)
        throw DefinitionError(part.string(), "", "cannot be written; is the folder writable?");
    fs::rename(part, file, error);
    if (error) throw DefinitionError(file.string(), "", "cannot be written: " + error.message());
    return file;
}

Task with_preset(const Task& task, const ScenePreset& preset) {
    Json json = parse_json(task.json, "task " + task.id);
    Json& scene = json["scene"];
    for (const auto& [tissue, values] : preset.tissues) {
        Json& material = scene["materials"][std::string(sim::tissue_name(tissue))];
        const auto fail = values.find(sim::TuneParameter::kFailStretch);
        if (fail != values.end()) {  // what injures keeps its proportion, as in the panel
            const double before = material["fail_stretch"], injury = material["injury_stretch"];
            material["injury_stretch"] = 1 + (injury - 1) * (fail->second - 1) / (before - 1);
        }
        for (const auto& [parameter, value] : values)
            material[std::string(sim::tune_range(parameter).name)] = value;
    }
    for (Json& tool : scene["tools"]) {
        if (tool["kind"] != "needle" && tool["kind"] != "hook") continue;
        if (preset.cut_power_w >= 0) tool["cut_power_w"] = preset.cut_power_w;
        if (preset.coag_power_w >= 0) tool["coag_power_w"] = preset.coag_power_w;
    }
    json["preset"] = {{"id", preset.id},
                      {"name", preset.name},
                      {"author", preset.author},
                      {"saved_utc", preset.saved_utc}};
    return load_task_text(json.dump(), "preset " + preset.id);
}

std::string preset_of(const Task& task) {
    const Json json = parse_json(task.json, "task " + task.id);
    return json.contains("preset") ? json["preset"].value("id", "") : "";
}

}  // namespace placode::curriculum
