// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl user import|invite|invitations|accept|pin. Own data and erasure: erasure_commands.cpp.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include "reports/people_file.h"
#include "sim/core/counted.h"
#include "sim/core/text_file.h"
#include "ui/cli/people.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct PeopleOptions {
    std::string file, out, login, name, code, group, until, note;
    std::vector<std::string> roles{"trainee"};
    bool dry_run = false, remove = false;
};

// --- import
// ------------------------------------------------------------------------------------

/// A list that cannot be used is bad input.
template <class Work>
auto as_list(Work&& work) {
    try {
        return work();
    } catch (const reports::PeopleFileError& error) {
        throw InputError(error.what());
    }
}

std::string whole_file(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw InputError(path + ": this is a folder; expected a CSV file");
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path + ": cannot be read; expected a CSV file");
    auto text = sim::read_at_most(in, sim::kLargestText);
    if (!text) throw InputError(path + ": has more than 64 MB; expected a CSV file of less");
    return std::move(*text);
}

int import_people(const Context& context, const PeopleOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    auto people = as_list([&] {
        return reports::read_people(session.store(), whole_file(options.file), options.file);
    });
    const bool need_file = std::any_of(people.begin(), people.end(),
                                       [](const auto& line) { return line.user.password.empty(); });
    if (need_file && options.out.empty() && !options.dry_run)
        throw InputError(options.file +
                         ": some people have no password; give "
                         "--out FILE.csv for those that are "
                         "made for them");
    Json json{{"people", people.size()}, {"dry_run", options.dry_run}};
    if (options.dry_run) {
        print(context, json, sim::counted(people.size(), "person", "people") + " would be added");
        return 0;
    }
    // Written before the first account is made: a password that nobody knows helps nobody.
    const std::string passwords = reports::make_passwords(people);
    if (need_file)
        as_input([&] { reports::save_passwords(options.out, passwords); },
                 db::StoreError::Kind::kOther);
    const size_t added =
        as_list([&] { return reports::make_accounts(session.store(), people, options.file); });
    json["added"] = added;
    print(context, json,
          "added " + sim::counted(added, "person", "people") +
              (need_file ? "; passwords of those without one in " + options.out : ""));
    return 0;
}

// --- invitations
// -------------------------------------------------------------------------------

int invite(const Context& context, const PeopleOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    db::InvitationRecord invitation;
    invitation.roles = roles_of(options.roles);
    invitation.expires_utc = options.until;
    invitation.note = options.note;
    if (!options.group.empty()) invitation.group_id = find_group(session, options.group).id;
    const std::string code =
        as_input([&] { return session.store().accounts().invite(invitation); });
    print(context, {{"code", code}, {"expires_utc", options.until}},
          code + "\nuse: placodectl user accept " + code + " LOGIN, until " + options.until);
    return 0;
}

int invitations(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{{"id", "roles", "until", "by", "used", "note"}};
    for (const auto& each : session.store().accounts().invitations()) {
        json.push_back({{"id", each.id},
                        {"roles", role_names(each.roles)},
                        {"expires_utc", each.expires_utc},
                        {"invited_by", each.invited_by},
                        {"used_utc", each.used_utc},
                        {"note", each.note}});
        std::string roles;
        for (const auto& name : role_names(each.roles)) roles += (roles.empty() ? "" : ", ") + name;
        rows.push_back({std::to_string(each.id), roles, each.expires_utc, each.invited_by,
                        each.used_utc, each.note});
    }
    print(context, json, rows.size() == 1 ? "no invitations" : table(rows));
    return 0;
}

/// Needs no account: the code is the right to make one.
int accept(const Context& context, const PeopleOptions& options) {
    const std::string url = url_to_open(context);
    const std::string password =
        read_password("PLACODE_NEW_PASSWORD", "New password of " + options.login, true);
    const auto store = db::open_store(url);
    store->sign_out();
    db::NewUser user;
    user.login = options.login;
    user.display_name = options.name.empty() ? options.login : options.name;
    user.password = password;
    const int64_t id =
        as_input([&] { return store->accounts().accept_invitation(options.code, user); });
    print(context, {{"id", id}, {"login", options.login}}, "made the account " + options.login);
    return 0;
}

// --- PIN
// ---------------------------------------------------------------------------------------

int pin(const Context& context, const PeopleOptions& options) {
    Session session(context, Missing::kRefuse);
    const int64_t id = named_or_self(session, options.login);
    const bool own = session.user() && session.user()->id == id;
    // Nobody chooses another person's PIN; an administrator may take it away.
    if (!own && !options.remove)
        throw AccessError("a PIN is chosen by the person alone; --remove takes it away");
    if (!own) session.need(Action::kManageUsers, Scope::kOther);
    const std::string chosen =
        options.remove ? std::string() : read_password("PLACODE_NEW_PIN", "New PIN", true);
    as_input([&] { session.store().accounts().set_pin(id, chosen); });
    print(context, {{"user_id", id}, {"pin", !options.remove}},
          options.remove ? "the PIN is gone" : "the PIN is set");
    return 0;
}

}  // namespace

void add_people_commands(CLI::App& app, Context& context) {
    auto options = std::make_shared<PeopleOptions>();
    CLI::App* user = app.get_subcommand("user");
    const auto command = [&](const char* name, const char* help, auto work) {
        CLI::App* added = user->add_subcommand(name, help);
        added->callback([&context, options, work] {
            context.run = [&context, options, work] { return work(context, *options); };
        });
        return added;
    };
    CLI::App* in = command("import", "Adds people from a CSV file, all or none of a wrong file",
                           import_people);
    in->add_option("FILE", options->file, "login,name[,roles][,group][,password]; roles with ';'")
        ->required();
    in->add_option("--out", options->out, "FILE.csv for passwords that are made");
    in->add_flag("--dry-run", options->dry_run, "Checks the file only");
    CLI::App* invited = command("invite", "A code with which somebody makes an account", invite);
    invited->add_option("--role", options->roles, "As of `user add`");
    invited->add_option("--group", options->group, "Name or number");
    invited->add_option("--until", options->until, "Last day, 2026-11-21")->required();
    invited->add_option("--note", options->note, "For whom");
    command("invitations", "Lists invitations, without their codes",
            [](const Context& c, const PeopleOptions&) { return invitations(c); });
    CLI::App* accepted = command("accept", "Makes an account by an invitation's code", accept);
    accepted->add_option("CODE", options->code, "Of the invitation")->required();
    accepted->add_option("login", options->login, "Login, unique without case")->required();
    accepted->add_option("--name", options->name, "Name as shown (default: the login)");
    CLI::App* pinned = command("pin", "Sets the own PIN, from $PLACODE_NEW_PIN or asked for", pin);
    pinned->add_option("--user", options->login, "With --remove: whose");
    pinned->add_flag("--remove", options->remove, "Takes the PIN away");
    add_erasure_commands(*user, context);
}

}  // namespace placode::cli
