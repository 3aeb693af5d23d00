// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl user add|list|roles|deactivate|activate|password

#include <memory>

#include "ui/cli/people.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

Json to_json(const db::UserRecord& user) {
    return {{"id", user.id},
            {"login", user.login},
            {"name", user.display_name},
            {"roles", role_names(user.roles)},
            {"active", user.active},
            {"demonstration", user.demonstration},
            {"created_utc", user.created_utc}};
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

struct AddOptions {
    std::string login, name;
    std::vector<std::string> roles{"trainee"};
    bool begin_anew = false;
};

int add(const Context& context, const AddOptions& options) {
    Session session(context, options.begin_anew ? Missing::kBeginAnew : Missing::kCreate);
    session.need(Action::kManageUsers, Scope::kOther);
    db::NewUser user;
    user.login = options.login;
    user.display_name = options.name.empty() ? options.login : options.name;
    user.roles = roles_of(options.roles);
    user.password = read_password("PLACODE_NEW_PASSWORD", "New password of " + options.login, true);
    user.password_given = session.user().has_value();  // alone at the machine it is one's own
    const int64_t id = session.store().accounts().create(user);
    print(context, to_json(*session.store().accounts().find(id)),
          "created user " + std::to_string(id) + " \"" + user.login + "\" (" +
              joined(options.roles) + ") in " + session.store().url());
    return 0;
}

int list_users(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"id", "login", "name", "roles", "state"}};
    for (const auto& user : session.store().accounts().list()) {
        json.push_back(to_json(user));
        rows.push_back({std::to_string(user.id), user.login, user.display_name,
                        joined(role_names(user.roles)),
                        std::string(user.active ? "active" : "deactivated") +
                            (user.demonstration ? ", demonstration" : "")});
    }
    print(context, json, rows.size() == 1 ? "no users yet; `placodectl user add`" : table(rows));
    return 0;
}

int set_active(const Context& context, const std::string& login, bool active) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    const db::UserRecord user = session.find_user(login);
    session.store().accounts().set_active(user.id, active);
    print(context, to_json(*session.store().accounts().find(user.id)),
          "\"" + user.login + "\" is " + (active ? "active" : "deactivated"));
    return 0;
}

int set_roles(const Context& context, const AddOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    const db::UserRecord user = session.find_user(options.login);
    session.store().accounts().set_roles(user.id, roles_of(options.roles));
    const db::UserRecord now = *session.store().accounts().find(user.id);
    print(context, to_json(now),
          "\"" + now.login + "\" is now " + joined(role_names(now.roles)) +
              (now.roles == user.roles ? ", as before" : ""));
    return 0;
}

int password(const Context& context, const std::string& login) {
    Session session(context, Missing::kRefuse);
    const db::UserRecord user = session.find_user(login);
    // Everybody may change the own password: who got this far has just given the old one.
    const bool own = session.user() && session.user()->id == user.id;
    if (!own) session.need(Action::kManageUsers, Scope::kOther);
    session.store().accounts().set_password(
        user.id, read_password("PLACODE_NEW_PASSWORD", "New password of " + user.login, true),
        !own);
    print(context, {{"id", user.id}, {"login", user.login}},
          "the password of \"" + user.login + "\" is changed");
    return 0;
}

}  // namespace

void add_user_commands(CLI::App& app, Context& context) {
    CLI::App* user = app.add_subcommand("user", "Accounts");
    user->require_subcommand(1);

    auto options = std::make_shared<AddOptions>();
    CLI::App* add_command = user->add_subcommand(
        "add", "Creates an account; its password comes from $PLACODE_NEW_PASSWORD or is asked for");
    add_command->add_option("login", options->login, "Login, unique without case")->required();
    add_command->add_option("--name", options->name, "Name as shown (default: the login)");
    add_command->add_option("--role", options->roles,
                            "trainee, educator, coordinator, administrator; may be given again");
    add_command->add_flag("--begin-anew", options->begin_anew,
                          "Make a new store where one was before and is gone");
    add_command->callback([&context, options] {
        context.run = [&context, options] { return add(context, *options); };
    });

    user->add_subcommand("list", "Lists all accounts")->callback([&context] {
        context.run = [&context] { return list_users(context); };
    });

    auto changed = std::make_shared<AddOptions>();
    CLI::App* roles_command = user->add_subcommand(
        "roles", "Sets the roles of an account; who is signed in has to sign in again");
    roles_command->add_option("login", changed->login, "Login or number")->required();
    roles_command
        ->add_option("--role", changed->roles,
                     "trainee, educator, coordinator, administrator; all that it is to have")
        ->required();
    roles_command->callback([&context, changed] {
        context.run = [&context, changed] { return set_roles(context, *changed); };
    });

    for (const bool active : {false, true}) {
        auto login = std::make_shared<std::string>();
        CLI::App* command = user->add_subcommand(
            active ? "activate" : "deactivate",
            active ? "Lets a person sign in again" : "Keeps a person from signing in; data stays");
        command->add_option("login", *login, "Login or number")->required();
        command->callback([&context, login, active] {
            context.run = [&context, login, active] { return set_active(context, *login, active); };
        });
    }

    auto login = std::make_shared<std::string>();
    CLI::App* password_command = user->add_subcommand(
        "password", "Sets a password, from $PLACODE_NEW_PASSWORD or asked for");
    password_command->add_option("login", *login, "Login or number")->required();
    password_command->callback([&context, login] {
        context.run = [&context, login] { return password(context, *login); };
    });
}

}  // namespace placode::cli
