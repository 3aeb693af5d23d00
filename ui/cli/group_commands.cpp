// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl group add|list|member: cohorts and who teaches them.

#include <memory>

#include "ui/cli/people.h"

namespace placode::cli {
namespace {

using db::Action;
using db::GroupRole;
using db::Scope;

struct GroupOptions {
    std::string name, role = "member";
    std::vector<std::string> users;
};

int add(const Context& context, const GroupOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageGroups, Scope::kGroup);
    const int64_t id = session.store().groups().create(options.name);
    // Who makes a group teaches it; an administrator's own group waits for its educator.
    if (session.user() && db::has_role(session.user()->roles, db::Role::kEducator))
        session.store().groups().set_role(id, session.user()->id, GroupRole::kEducator);
    print(context, {{"group", id}, {"name", options.name}},
          "group " + std::to_string(id) + " \"" + options.name + "\"");
    return 0;
}

int list_groups(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageGroups, Scope::kGroup);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"id", "name", "educators", "members"}};
    const auto logins = [&](const std::vector<int64_t>& ids) {
        std::string text;
        for (const int64_t id : ids)
            if (const auto user = session.store().accounts().find(id))
                text += (text.empty() ? "" : ", ") + user->login;
        return text;
    };
    for (const auto& group : session.store().groups().list()) {
        json.push_back({{"id", group.id},
                        {"name", group.name},
                        {"educators", group.educators},
                        {"members", group.members}});
        rows.push_back(
            {std::to_string(group.id), group.name, logins(group.educators), logins(group.members)});
    }
    print(context, json, rows.size() == 1 ? "no groups yet; `placodectl group add`" : table(rows));
    return 0;
}

int member(const Context& context, const GroupOptions& options) {
    Session session(context, Missing::kRefuse);
    const db::GroupRecord group = find_group(session, options.name);
    need_for_group(session, Action::kManageGroups, group);
    const GroupRole role = options.role == "educator" ? GroupRole::kEducator
                           : options.role == "none"   ? GroupRole::kNone
                                                      : GroupRole::kMember;
    std::vector<db::UserRecord> people;  // All of them are there before the first is changed.
    for (const std::string& login : options.users) people.push_back(session.find_user(login));
    for (const auto& person : people) {
        // Nobody draws people of other groups into the own one.
        session.need_for(Action::kManageGroups, person.id);
        if (role == GroupRole::kEducator && !db::has_role(person.roles, db::Role::kEducator))
            throw InputError(person.login + " has not the role educator; nothing was changed");
    }
    for (const auto& person : people) session.store().groups().set_role(group.id, person.id, role);
    print(context, {{"group", group.id}, {"role", options.role}, {"people", people.size()}},
          std::to_string(people.size()) + " person(s) in " + group.name + ": " + options.role);
    return 0;
}

}  // namespace

void add_group_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<GroupOptions>();
    CLI::App* group = app.add_subcommand("group", "Groups (cohorts) of people");
    group->require_subcommand(1);
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = group->add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    command("add", "Creates a group; an educator who does so teaches it", add)
        ->add_option("NAME", options->name, "Of the new group, not taken yet")
        ->required();
    command("list", "Lists groups with their people",
            [](const Context& c, const GroupOptions&) { return list_groups(c); });
    CLI::App* members = command("member", "Puts people into a group, or takes them out", member);
    members->add_option("GROUP", options->name, "Name or number")->required();
    members->add_option("USER", options->users, "Login or number")->required();
    members->add_option("--role", options->role, "member, educator or none")
        ->check(CLI::IsMember({"member", "educator", "none"}));
}

}  // namespace placode::cli
