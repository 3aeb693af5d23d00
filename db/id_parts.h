// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Many rows by their ids with few questions. Only db/*.cpp include this.

#include <QVariant>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace placode::db {

/// Some of the ids: `"WHERE id IN " + list`, with `values` bound to its places.
struct IdPart {
    std::string list;
    std::vector<QVariant> values;
    std::string numbers;  ///< "1, 2", for PostgreSQL's arrays.
};

/// Engines take 32,766 values in a statement and more.
inline constexpr size_t kIdsAtOnce = 500;

/// All ids, each once.
[[nodiscard]] inline std::vector<IdPart> in_parts(std::vector<int64_t> ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<IdPart> parts;
    for (const int64_t id : ids) {
        if (parts.empty() || parts.back().values.size() == kIdsAtOnce) parts.emplace_back();
        IdPart& part = parts.back();
        part.list += part.values.empty() ? "(?" : ", ?";
        part.numbers += (part.values.empty() ? "" : ", ") + std::to_string(id);
        part.values.emplace_back(qlonglong(id));
    }
    for (IdPart& part : parts) part.list += ')';
    return parts;
}

}  // namespace placode::db
