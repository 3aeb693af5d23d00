// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which rows of which tables make up a sealed object. A migration that adds a column adds it here,
// in a part of its own at the end of the kind, or every old seal breaks.

#include <array>
#include <string_view>
#include <vector>

namespace placode::db {

/// The rows of one table that belong to an object.
struct SealPart {
    std::string_view table;                 ///< With a join where the key stands in another table.
    std::array<std::string_view, 3> key;    ///< Columns that name the object; the rest empty.
    std::array<std::string_view, 2> order;  ///< Among the rows of an object.
    std::string_view columns;               ///< What is sealed, beside the key.
};

struct SealKind {
    std::string_view name;
    bool numeric = true;          ///< Its key is a number.
    std::vector<SealPart> parts;  ///< The first one says whether there is such an object.
};

[[nodiscard]] const std::vector<SealKind>& seal_kinds();

}  // namespace placode::db
