// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What tests of batches share: a field that they can afford, and which shards are done.

#include <filesystem>
#include <set>
#include <string>

#include "tests/coarse_scene.h"

namespace placode::test {

/// File names of the shards that are done in the folder of a batch.
inline std::set<std::string> shards_in(const std::string& batch) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(batch + "/shards"))
        if (entry.path().extension() == ".jsonl") names.insert(entry.path().filename());
    return names;
}

}  // namespace placode::test
