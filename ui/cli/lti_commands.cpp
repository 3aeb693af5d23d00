// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl lti: which learning platforms let people into the portal, and who is who on them.

#include <memory>

#include "db/password.h"
#include "sim/core/counted.h"
#include "ui/cli/session.h"
#include "ui/lti/settings.h"
#include "ui/lti/web_client.h"
#include "ui/lti/web_token.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

struct LinkOptions {
    std::string config, issuer, client_id, subject, user;
};

/// "2 keys" of a platform, or what is wrong with them.
std::string keys_of(const lti::Platform& platform) {
    try {
        if (!platform.keys_file.empty())
            return sim::counted(
                lti::parse_key_set(lti::read_settings_text(platform.keys_file)).size(), "key");
        lti::WebCall call;
        call.address = platform.keys_url;
        const lti::WebReply reply = lti::ask(call);
        if (reply.status != 200)
            return reply.status == 0 ? reply.problem : "status " + std::to_string(reply.status);
        return sim::counted(lti::parse_key_set(reply.body).size(), "key");
    } catch (const std::exception& error) {
        return error.what();
    }
}

int run_check(const Context& context, const std::string& file) {
    const lti::Settings settings = lti::read_settings(file);
    std::string key;
    try {
        key = lti::SigningKey(lti::read_secret(settings.private_key_file)).public_key().id;
    } catch (const std::invalid_argument& error) {
        throw InputError(settings.private_key_file + ": " + error.what());
    }
    const std::string login = settings.tool_url + "/lti/login",
                      keys = settings.tool_url + "/lti/jwks.json";
    Json json{{"tool_url", settings.tool_url},
              {"login_url", login},
              {"redirection_url", settings.launch_url()},
              {"key_set_url", keys},
              {"key_id", key},
              {"platforms", Json::array()}};
    std::string text = "To type in on the platform:\n  tool URL             " + settings.tool_url +
                       "\n  public keyset        " + keys + "\n  initiate login URL   " + login +
                       "\n  redirection URI      " + settings.launch_url() + "\n";
    for (const lti::Platform& each : settings.platforms) {
        const std::string found = keys_of(each);
        json["platforms"].push_back({{"issuer", each.issuer},
                                     {"client_id", each.client_id},
                                     {"links", each.links.size()},
                                     {"line_items", each.line_items.size()},
                                     {"keys", found}});
        text += each.issuer + " (" + each.client_id +
                "): " + sim::counted(each.links.size(), "link") + ", " +
                sim::counted(each.line_items.size(), "line item") + ", keys: " + found + "\n";
    }
    text.pop_back();
    print(context, json, text);
    return 0;
}

int run_link(const Context& context, const LinkOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    const db::UserRecord user = session.find_user(options.user);
    if (db::has_role(user.roles, db::Role::kAdministrator))
        throw InputError("--user: " + user.login +
                         " is an administrator; whoever runs the platform could come as anybody "
                         "who is linked, so administrators sign in with their password");
    lti::add_link(options.config, options.issuer, options.client_id,
                  {options.subject, user.id, user.login});
    session.store().audit().write(session.actor(), "lti.link", "user " + std::to_string(user.id),
                                  options.issuer);
    print(context, {{"issuer", options.issuer}, {"sub", options.subject}, {"login", user.login}},
          options.subject + " of " + options.issuer + " is " + user.login + " from now on");
    return 0;
}

int run_unlink(const Context& context, const LinkOptions& options) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    const auto gone =
        lti::remove_link(options.config, options.issuer, options.client_id, options.subject);
    if (!gone)
        throw InputError("--sub: \"" + options.subject + "\" has no link in " + options.config);
    // By number alone: what the platform calls a person is a name as well.
    session.store().audit().write(session.actor(), "lti.unlink",
                                  "user " + std::to_string(gone->account), options.issuer);
    print(context, {{"issuer", options.issuer}, {"sub", options.subject}},
          options.subject + " of " + options.issuer +
              " is nobody from now on; a session that is open ends at its next page");
    return 0;
}

CLI::App* add_link_command(CLI::App& lti, const char* name, const char* what,
                           const std::shared_ptr<LinkOptions>& options) {
    CLI::App* command = lti.add_subcommand(name, what);
    command->add_option("--config", options->config, "FILE.json with the platforms")->required();
    command->add_option("--issuer", options->issuer, "Of the platform, as in the file")->required();
    command->add_option("--client-id", options->client_id,
                        "Where the issuer is there several times");
    command->add_option("--sub", options->subject, "The person on the platform")->required();
    return command;
}

}  // namespace

void add_lti_commands(CLI::App& app, Context& context) {
    CLI::App* lti = app.add_subcommand(
        "lti", "Learning platforms (LTI 1.3): check the settings, link people, send grades");
    lti->require_subcommand(1);
    auto file = std::make_shared<std::string>();
    CLI::App* check = lti->add_subcommand(
        "check", "Read the settings, ask platforms for their keys, say what to type in there");
    check->add_option("--config", *file, "FILE.json with the platforms")->required();
    check->callback(
        [&context, file] { context.run = [&context, file] { return run_check(context, *file); }; });
    auto link = std::make_shared<LinkOptions>();
    CLI::App* adding =
        add_link_command(*lti, "link", "Say which account somebody on a platform has", link);
    adding->add_option("--user", link->user, "Login or number")->required();
    adding->callback(
        [&context, link] { context.run = [&context, link] { return run_link(context, *link); }; });
    auto unlink = std::make_shared<LinkOptions>();
    add_link_command(*lti, "unlink", "Take that back", unlink)->callback([&context, unlink] {
        context.run = [&context, unlink] { return run_unlink(context, *unlink); };
    });
    add_lti_grades_command(*lti, context);
}

}  // namespace placode::cli
