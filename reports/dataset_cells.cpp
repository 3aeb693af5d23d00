// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A data set as one value a cell, and what was read back from a file against it.

#include "reports/dataset.h"
#include "reports/report.h"

namespace placode::reports {

std::string cell_key(const Form& form, const Row& row, const Field& field) {
    return form.name + "|" + row.participant + "|" + std::to_string(row.instance) + "|" + field.id;
}

Cells cells_of(const Dataset& data) {
    Cells cells;
    for (const Form& form : data.forms) {
        for (const Row& row : form.rows) {
            for (const Field& field : form.fields) {
                const auto found = row.values.find(field.id);
                if (found != row.values.end()) cells[cell_key(form, row, field)] = found->second;
            }
        }
    }
    return cells;
}

void compare_cells(const Cells& expected, const Cells& found, const std::string& what) {
    const auto fail = [&](const std::string& key, const std::string& problem) {
        throw ReportError(what + ": read back, " + key + " (form|participant|instance|field) " +
                          problem + "; nothing was handed out");
    };
    for (const auto& [key, value] : expected) {
        const auto other = found.find(key);
        if (other == found.end()) fail(key, "is missing");
        if (other->second == value) continue;
        const auto a = curriculum::answer_number(value);
        const auto b = curriculum::answer_number(other->second);
        if (a && b && *a == *b) continue;
        fail(key, "is \"" + other->second + "\"; the store has \"" + value + "\"");
    }
    for (const auto& [key, value] : found)
        if (!expected.contains(key)) fail(key, "is \"" + value + "\"; the store has nothing there");
}

}  // namespace placode::reports
