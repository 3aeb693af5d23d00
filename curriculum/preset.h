// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Presets that a clinician tuned: what differs from a scene, with who and when, as a JSON file in
// the user's data folder. A task that is loaded with a preset carries the changed numbers in its
// recording and counts as tuned.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "curriculum/task.h"
#include "sim/step/live_tuning.h"

namespace placode::curriculum {

struct ScenePreset {
    std::string id, name;   ///< File name without ".json"; what the clinician called it.
    std::string preset_of;  ///< Scene that it was tuned on.
    std::string author;     ///< Who.
    std::string saved_utc;  ///< When, ISO 8601.
    /// Changed numbers of tissues; parameters as in sim/step/live_tuning.h.
    std::map<sim::Tissue, std::map<sim::TuneParameter, double>> tissues;
    double cut_power_w = -1, coag_power_w = -1;  ///< -1 = as the task says.
};

/// $PLACODE_PRESETS, else $XDG_DATA_HOME/placode/presets, else ~/.local/share/placode/presets;
/// empty without a home.
[[nodiscard]] std::filesystem::path preset_folder();
/// By file name. Files that are no presets are left out.
[[nodiscard]] std::vector<ScenePreset> list_presets();
/// By id or path. Throws DefinitionError listing the known ids.
[[nodiscard]] ScenePreset load_preset(const std::string& id_or_file);
/// Writes a new file, never over an old one; sets `id` from the name and returns the path. Throws
/// DefinitionError (name empty, folder not writable).
std::filesystem::path save_preset(ScenePreset& preset);
/// The task with the preset's numbers. Throws DefinitionError.
[[nodiscard]] Task with_preset(const Task& task, const ScenePreset& preset);
/// Id of the preset that a task was loaded with; empty = none.
[[nodiscard]] std::string preset_of(const Task& task);

}  // namespace placode::curriculum
