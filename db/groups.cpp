// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/groups.h"

#include "db/password.h"
#include "db/store_context.h"

namespace placode::db {

using Kind = StoreError::Kind;

Groups::Groups(StoreContext& context) : context_(context), connection_(context.connection) {}

int64_t Groups::create(const std::string& name) {
    connection_.begin_operation("create the group \"" + name.substr(0, kMostNameLength) + "\" in");
    context_.need(Action::kManageGroups, Scope::kGroup);  // It has no educator yet.
    const std::string key = login_key(name);
    if (const auto problem = name_problem(name)) connection_.fail(Kind::kRefused, *problem);
    UnitOfWork work(connection_);
    Statement taken(connection_, "SELECT id FROM training_groups WHERE name_key = ?");
    if (taken.run(key).next())
        connection_.fail(Kind::kConflict,
                         Said::that("there is a group of this name; choose another one"));
    Statement insert(connection_,
                     "INSERT INTO training_groups (name, name_key, created_utc) VALUES (?, ?, ?) "
                     "RETURNING id");
    insert.run(name, key, utc_now());
    const int64_t id = insert.returned_id();
    context_.made("group", id);
    context_.append_audit("group.create", "group " + std::to_string(id),
                          context_.without_names(name));
    work.commit();
    return id;
}

void Groups::set_role(int64_t group_id, int64_t user_id, GroupRole role) {
    connection_.begin_operation("change the group " + std::to_string(group_id) + " in");
    context_.need_for_group(Action::kManageGroups, group_id);
    // Nobody draws people of other groups into the own one.
    context_.need_for(Action::kManageGroups, user_id);
    UnitOfWork work(connection_);
    context_.need_group(group_id);
    (void)context_.need_user(user_id);
    context_.touch("group", group_id);
    // In one statement: a server asks who teaches the group, and that may be who is changed.
    if (role == GroupRole::kNone)
        Statement(connection_, "DELETE FROM group_members WHERE group_id = ? AND account_id = ?")
            .run(group_id, user_id);
    else
        Statement(connection_,
                  "INSERT INTO group_members (group_id, account_id, teaches) VALUES (?, ?, ?) ON "
                  "CONFLICT (group_id, account_id) DO UPDATE SET teaches = excluded.teaches")
            .run(group_id, user_id, role == GroupRole::kEducator);
    context_.append_audit("group.member",
                          "group " + std::to_string(group_id) + " user " + std::to_string(user_id),
                          role == GroupRole::kNone       ? "out"
                          : role == GroupRole::kEducator ? "educator"
                                                         : "member");
    work.commit();
}

std::vector<GroupRecord> Groups::list() {
    connection_.begin_operation("list the groups of");
    const bool all = context_.may(Action::kManageGroups, Scope::kGroup);
    if (!all) context_.need(Action::kUseStore);
    Statement query(connection_,
                    "SELECT g.id, g.name, g.created_utc, m.account_id, m.teaches FROM "
                    "training_groups g LEFT JOIN group_members m ON m.group_id = g.id ORDER BY "
                    "g.name_key, g.id, m.account_id");
    query.run();
    std::vector<GroupRecord> found;
    while (query.next()) {
        const int64_t id = query.integer("id");
        const int64_t member = query.integer("account_id");
        if (!all && !context_.is_self(member)) continue;
        if (found.empty() || found.back().id != id)
            found.push_back({id, query.text("name"), query.text("created_utc"), {}, {}});
        if (member != 0)
            (query.integer("teaches") != 0 ? found.back().educators : found.back().members)
                .push_back(member);
    }
    return found;
}

bool Groups::in_reach(int64_t actor, int64_t subject) {
    connection_.begin_operation("look up groups in");
    context_.is_self(actor) ? context_.need(Action::kUseStore)
                            : context_.need(Action::kManageGroups, Scope::kGroup);
    return context_.in_reach(actor, subject);
}

}  // namespace placode::db
