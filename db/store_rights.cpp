// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whether who acts on a store may do what a method is asked for. Who may do what stands in
// db/access.cpp; here is only who acts, and whose the data are.

#include <algorithm>
#include <set>

#include "db/id_parts.h"
#include "db/station_guard.h"
#include "db/store_context.h"

namespace placode::db {

void StoreContext::become(int64_t account_id) {
    actor = {user_object(account_id), Actor::Kind::kAccount, account_id};
}

bool StoreContext::is_self(int64_t account_id) const noexcept {
    return actor.kind == Actor::Kind::kAccount && actor.account == account_id;
}

// Asked anew every time, one row by its key: an administrator elsewhere may just have taken a role
// away. A list asks once, not for every row.
Roles StoreContext::roles_of_actor() {
    if (actor.kind != Actor::Kind::kAccount) return 0;
    Statement query(connection, "SELECT roles, active FROM accounts WHERE id = ?");
    if (!query.run(actor.account).next()) {
        // Every account has a row, and a server shows it to whom it knows to have signed in.
        if (server.guards()) connection.fail(StoreError::Kind::kRefused, guard_refusal());
        return 0;
    }
    return query.integer("active") == 0 ? Roles{0} : static_cast<Roles>(query.integer("roles"));
}

bool StoreContext::may(Action action, Scope scope) {
    return actor.kind == Actor::Kind::kProgram || allowed(roles_of_actor(), action, scope);
}

void StoreContext::need(Action action, Scope scope) {
    if (!may(action, scope)) refuse(action);
}

void StoreContext::need_any(std::initializer_list<Action> actions) {
    if (actor.kind == Actor::Kind::kProgram) return;
    const Roles roles = roles_of_actor();
    if (std::none_of(actions.begin(), actions.end(),
                     [roles](Action action) { return allowed(roles, action, Scope::kOther); }))
        refuse(*actions.begin());
}

void StoreContext::need_for(Action action, int64_t user_id) {
    if (actor.kind == Actor::Kind::kProgram) return;
    if (!may_for(roles_of_actor(), action, user_id)) refuse(action);
}

bool StoreContext::may_for(Roles roles, Action action, int64_t user_id) {
    if (is_self(user_id)) return allowed(roles, action, Scope::kOwn);
    const bool group = allowed(roles, action, Scope::kGroup);
    const bool other = allowed(roles, action, Scope::kOther);
    return group == other ? other : group == in_reach(actor.account, user_id);
}

void StoreContext::need_for_group(Action action, int64_t group_id) {
    if (actor.kind == Actor::Kind::kProgram) return;
    GroupRecord group;
    {
        Statement query(connection,
                        "SELECT account_id FROM group_members WHERE group_id = ? AND teaches = 1");
        query.run(group_id);
        while (query.next()) group.educators.push_back(query.integer(0));
    }
    need(action, scope_of_group(group, actor.account));
}

void StoreContext::need_for_attempt(Action action, int64_t attempt_id) {
    if (actor.kind == Actor::Kind::kProgram) return;
    const auto owner = owner_of_attempt(attempt_id);
    if (!owner) return need(Action::kUseStore);
    if (!owner->study.study.empty()) return need(action, Scope::kGroup);
    need_for(action, owner->user_id);
}

void StoreContext::need_sight_of_attempts(const std::vector<int64_t>& ids) {
    if (actor.kind == Actor::Kind::kProgram) return;
    const std::vector<AttemptOwner> owners = owners_of_attempts(ids);
    if (owners.empty()) return need(Action::kUseStore);
    std::set<int64_t> people;
    for (const AttemptOwner& owner : owners)
        if (owner.study.study.empty()) people.insert(owner.user_id);
    // Of a study it bears a code and no name: who runs studies sees it, and who sees all attempts.
    if (people.empty()) return need_any({Action::kViewAttempts, Action::kRunQuestionnaire});
    const Roles roles = roles_of_actor();
    for (const int64_t person : people)
        if (!may_for(roles, Action::kViewAttempts, person)) refuse(Action::kViewAttempts);
    const bool all_of_people = std::all_of(
        owners.begin(), owners.end(), [](const auto& owner) { return owner.study.study.empty(); });
    if (!all_of_people) need_any({Action::kViewAttempts, Action::kRunQuestionnaire});
}

bool StoreContext::in_reach(int64_t of, int64_t subject) {
    Statement any(connection, "SELECT COUNT(*) FROM group_members WHERE account_id = ?");
    if (any.run(subject).next() && any.integer(0) == 0) return true;
    Statement shared(connection,
                     "SELECT COUNT(*) FROM group_members a JOIN group_members b ON b.group_id = "
                     "a.group_id WHERE a.account_id = ? AND a.teaches = 1 AND b.account_id = ?");
    return shared.run(of, subject).next() && shared.integer(0) > 0;
}

void StoreContext::refuse(Action action) const {
    connection.fail(StoreError::Kind::kRefused, refusal(action));
}

std::optional<AttemptOwner> StoreContext::owner_of_attempt(int64_t id) {
    std::vector<AttemptOwner> found = owners_of_attempts({id});
    if (found.empty()) return std::nullopt;
    return std::move(found.front());
}

std::vector<AttemptOwner> StoreContext::owners_of_attempts(const std::vector<int64_t>& ids) {
    const bool guarded = server.guards();
    std::vector<AttemptOwner> found;
    for (const IdPart& part : in_parts(ids)) {
        Statement query(connection,
                        "SELECT o.account_id, o.study, o.participant FROM " +
                            (guarded ? std::string("unnest(CAST(? AS BIGINT[])) AS i (id), "
                                                   "placode_guard.owner_of_attempt(i.id) AS o")
                                     : "attempts o WHERE o.id IN " + part.list));
        guarded ? query.run('{' + part.numbers + '}') : query.run_list(part.values);
        while (query.next()) {
            AttemptOwner& owner = found.emplace_back();
            owner.study = {query.text("study"), query.text("participant")};
            if (owner.study.study.empty()) owner.user_id = query.integer("account_id");
        }
    }
    return found;
}

}  // namespace placode::db
