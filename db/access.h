// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who may do what: decided here, once, for shell and command line alike.

#include "db/records.h"

namespace placode::db {

enum class Action : uint8_t {
    kPerformAttempt,
    kViewAttempts,
    kViewPersonalData,
    kManageUsers,
    kRunQuestionnaire,
    kExportStudy,
    kBackup,
    kViewAudit,
};

enum class Scope : uint8_t { kOwn, kOther };

/// True when somebody with `roles` may do `action` on own or other people's data.
[[nodiscard]] bool allowed(Roles roles, Action action, Scope scope) noexcept;

/// Reason in plain words for a refusal, naming the role that could.
[[nodiscard]] std::string refusal(Action action);

}  // namespace placode::db
