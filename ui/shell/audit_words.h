// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the audit's codes ("user.create") say, in the program's language.

#include <QString>
#include <cstdint>
#include <map>
#include <string_view>

namespace placode::ui {

/// The sentence for an action; the code itself where none is known (a newer program's store).
[[nodiscard]] QString audit_words(std::string_view action);

/// How what an entry is about is called: people and groups by number, tasks, courses, studies and
/// questionnaires by id.
struct AuditNames {
    std::map<int64_t, QString> people, groups;
    std::map<QString, QString> titles;
};

/// What an entry is about, or its detail: "user 3" by name, "roles 2" by their words; the text
/// itself where it is no code.
[[nodiscard]] QString audit_thing(const QString& text, const AuditNames& names);

}  // namespace placode::ui
