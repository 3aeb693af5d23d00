// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the parts of a store share: the connection, the options, who acts, and what several of them
// look up. Only db/*.cpp include this.

#include <cstdint>
#include <optional>
#include <string>

#include "db/records.h"
#include "db/sql_connection.h"
#include "db/store_options.h"

namespace placode::db {

/// Who acts. The audit trail writes the name.
struct Actor {
    std::string name = "unknown";
};

struct StoreContext {
    /// Opens the connection; the tables are open_store()'s matter.
    StoreContext(const StoreUrl& url, const StoreOptions& options);

    Connection connection;
    StoreOptions options;
    Actor actor;

    [[nodiscard]] int64_t now_ms() const;

    // --- inside a transaction, so that a change and its trace are one
    /// Under the actor's name.
    void append_audit(const std::string& action, const std::string& object,
                      const std::string& detail);
    void append_audit_as(const std::string& name, const std::string& action,
                         const std::string& object, const std::string& detail);
    void delete_attempt(int64_t id);  ///< With all that hangs on it.

    // --- looked up by several parts; need_...() throws kNotFound
    [[nodiscard]] UserRecord need_user(int64_t id);
    void need_group(int64_t id);
    /// version 0 = the newest.
    [[nodiscard]] std::optional<DefinitionRecord> find_definition(const std::string& kind,
                                                                  const std::string& id,
                                                                  int version);

    // --- participants of studies: store_context_studies.cpp
    void need_participant(const std::string& study_id, const std::string& code);
    /// Throws unless this participant may go on: there, not withdrawn, not locked, consented where
    /// that is needed. `step` is the one that gives the consent, or empty.
    void need_active_participant(const std::string& study_id, const std::string& code,
                                 const std::string& step);
    [[nodiscard]] bool is_locked(const std::string& study_id, const std::string& code);
    /// Throws kRefused while the record is locked.
    void need_unlocked(const std::string& study_id, const std::string& code);
};

/// SELECT ... FROM accounts a JOIN persons p ..., for read_user().
[[nodiscard]] const std::string& user_columns();
[[nodiscard]] UserRecord read_user(const Statement& row);

/// SELECT ... FROM definitions, for read_definition().
[[nodiscard]] const std::string& definition_columns();
[[nodiscard]] DefinitionRecord read_definition(const Statement& row);

/// The chain of an audit entry after the one whose chain is `previous`.
[[nodiscard]] std::string audit_chain(const std::string& previous, const AuditRecord& entry);

/// How the audit trail names an account: "user 12". No name: the trail is kept longer than the
/// person may be.
[[nodiscard]] std::string user_object(int64_t id);

}  // namespace placode::db
