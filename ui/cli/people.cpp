// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/people.h"

#include <algorithm>
#include <ctime>

#include "curriculum/utc_time.h"
#include "sim/core/near_word.h"

namespace placode::cli {

namespace {

const std::vector<std::pair<std::string, db::Role>> kRoles{
    {"trainee", db::Role::kTrainee},
    {"educator", db::Role::kEducator},
    {"coordinator", db::Role::kCoordinator},
    {"administrator", db::Role::kAdministrator}};

}  // namespace

std::vector<std::string> role_names(db::Roles roles) {
    std::vector<std::string> names;
    for (const auto& [name, role] : kRoles)
        if (db::has_role(roles, role)) names.push_back(name);
    return names;
}

db::Roles roles_of(const std::vector<std::string>& names) {
    db::Roles roles = 0;
    for (const std::string& name : names) {
        db::Roles found = 0;
        for (const auto& [known, role] : kRoles)
            if (known == name) found = static_cast<db::Roles>(role);
        if (found == 0)
            throw InputError("--role: found \"" + name +
                             "\"; expected trainee, educator, coordinator or administrator" +
                             sim::did_you_mean(name, role_names(static_cast<db::Roles>(~0u))));
        roles |= found;
    }
    return roles;
}

db::GroupRecord find_group(Session& session, const std::string& name_or_id) {
    std::vector<db::GroupRecord> found;
    for (const db::GroupRecord& group : session.store().groups().list())
        if (group.name == name_or_id || std::to_string(group.id) == name_or_id)
            found.push_back(group);
    if (found.size() > 1)
        throw InputError("group \"" + name_or_id +
                         "\": is the name of one group and the number of another; give the number "
                         "of the one or the name of the other");
    if (!found.empty()) return found.front();
    // Who sees only the own groups is not told that there is none.
    session.need(db::Action::kManageGroups, db::Scope::kGroup);
    std::vector<std::string> names;
    for (const db::GroupRecord& group : session.store().groups().list())
        names.push_back(group.name);
    throw InputError("group \"" + name_or_id + "\": not in " + session.store().url() +
                     "; `placodectl group list` shows them" + sim::did_you_mean(name_or_id, names));
}

void need_for_group(const Session& session, db::Action action, const db::GroupRecord& group) {
    session.need(
        action, session.user() ? db::scope_of_group(group, session.user()->id) : db::Scope::kOther);
}

int64_t named_or_self(Session& session, const std::string& login_or_id) {
    if (!login_or_id.empty()) return session.find_user(login_or_id).id;
    if (!session.user())
        throw InputError("--user: expected a login; the local administrator is not a person");
    return session.user()->id;
}

int64_t user_or_all(Session& session, const std::string& login_or_id) {
    if (login_or_id.empty())
        return session.may(db::Action::kViewAttempts, db::Scope::kOther) ? 0 : session.user()->id;
    const int64_t id = session.find_user(login_or_id).id;
    session.need_for(db::Action::kViewAttempts, id);
    return id;
}

std::string now_utc() { return curriculum::utc_text(static_cast<int64_t>(std::time(nullptr))); }

}  // namespace placode::cli
