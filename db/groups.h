// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Part of Store: groups (cohorts) of people.

#include <cstdint>
#include <string>
#include <vector>

#include "db/records.h"

namespace placode::db {

class Connection;
struct StoreContext;

/// `store.groups().list()`. Every change is one transaction and in the audit trail.
class Groups {
 public:
    explicit Groups(StoreContext& context);

    int64_t create(const std::string& name);  ///< Throws kConflict, kRefused.
    void set_role(int64_t group_id, int64_t user_id, GroupRole role);
    /// By name. For who keeps no groups: those that they are in themselves, without the others.
    [[nodiscard]] std::vector<GroupRecord> list();
    /// True when `subject` is in no group, or in one where `actor` is educator.
    [[nodiscard]] bool in_reach(int64_t actor, int64_t subject);

 private:
    StoreContext& context_;
    Connection& connection_;
};

}  // namespace placode::db
