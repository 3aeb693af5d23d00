// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whom a command is about.

#include "ui/cli/session.h"

namespace placode::cli {

/// "trainee", "educator", ... of a sum of roles, and back. Throws InputError.
[[nodiscard]] std::vector<std::string> role_names(db::Roles roles);
[[nodiscard]] db::Roles roles_of(const std::vector<std::string>& names);

/// By name or number. Throws InputError, also where it is both.
[[nodiscard]] db::GroupRecord find_group(Session& session, const std::string& name_or_id);

/// Throws AccessError unless whoever acts may do `action` to this group: it is in reach for its own
/// educators, and everybody's while it has none.
void need_for_group(const Session& session, db::Action action, const db::GroupRecord& group);

/// Number of the person named, else of whoever acts. Throws InputError for the local administrator
/// without a name.
[[nodiscard]] int64_t named_or_self(Session& session, const std::string& login_or_id);

/// Number of the person named; without a name 0 = all for who may see other people's attempts, else
/// the own one. Throws AccessError when the named one may not be looked at.
[[nodiscard]] int64_t user_or_all(Session& session, const std::string& login_or_id);

/// Now, "2026-11-21T18:03:00Z".
[[nodiscard]] std::string now_utc();

}  // namespace placode::cli
