// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: the audit trail. Every change of the store writes its entry itself, in its own
// transaction; an entry's chain says that none before it was changed.

#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// `store.audit().write()`. Every change is one transaction and in the audit trail.
class Audit {
 public:
    explicit Audit(StoreContext& context);

    /// What is no change of the store, such as an export.
    void write(const std::string& actor, const std::string& action, const std::string& object,
               const std::string& detail);
    [[nodiscard]] std::vector<AuditRecord> trail(int limit);  ///< Newest first.
    /// Adds the first entry that does not fit the one before it to `problems`, for Store::check().
    void check_chain(std::vector<std::string>& problems);

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
