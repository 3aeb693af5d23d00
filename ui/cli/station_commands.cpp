// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placodectl station list | key | trust | role: the computers that sign the audit trail, and what
// their log-in may do on a server

#include <memory>

#include "db/signature.h"
#include "db/station_role.h"
#include "ui/cli/session.h"

namespace placode::cli {
namespace {

using db::Action;
using db::Scope;

int list_stations(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kViewAudit, Scope::kOther);
    Json json = Json::array();
    std::vector<std::vector<std::string>> rows{
        {"station", "", "trusted", "entries", "first (UTC)", "last (UTC)"}};
    for (const db::StationRecord& each : session.store().audit().stations()) {
        const std::string mark = db::fingerprint(each.public_key);
        json.push_back({{"station", mark},
                        {"public_key", each.public_key},
                        {"own", each.own},
                        {"trusted", each.trusted},
                        {"entries", each.entries},
                        {"first_utc", each.first_utc},
                        {"last_utc", each.last_utc}});
        rows.push_back({mark, each.own ? "this computer" : "", each.trusted ? "yes" : "no",
                        std::to_string(each.entries), each.first_utc, each.last_utc});
    }
    print(context, json, rows.size() == 1 ? "nothing is signed in this store yet" : table(rows));
    return 0;
}

int key(const Context& context) {
    Session session(context, Missing::kRefuse);
    const std::string own = session.store().audit().own_station();
    if (own.empty())
        throw InputError(
            "this computer has no key, and none can be made; set PLACODE_STATION_KEY to "
            "a file that can be written");
    print(context, {{"station", db::fingerprint(own)}, {"public_key", own}},
          own + "  (" + db::fingerprint(own) + ")");
    return 0;
}

int trust(const Context& context, const std::string& fingerprint) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kManageUsers, Scope::kOther);
    session.store().audit().trust_station(fingerprint);
    print(context, {{"trusted", fingerprint}}, "the station " + fingerprint + " is trusted");
    return 0;
}

enum class RoleWork : uint8_t { kPrint, kApply, kCheck };

/// Needs no store: for whoever keeps the server.
int print_role(const Context& context) {
    std::string script =
        "-- What a station of the centre may do in this database. By the owner of its tables,\n"
        "-- again after every update of Placode. A log-in for one station, once:\n"
        "--   CREATE ROLE theatre_1 LOGIN PASSWORD '...' IN ROLE " +
        std::string(db::kStationRole) + ";";
    Json statements = Json::array();
    for (const std::string& each : db::station_role_statements()) {
        statements.push_back(each);
        script += "\n" + each + ";";
    }
    print(context, {{"role", db::kStationRole}, {"statements", statements}}, script);
    return 0;
}

/// With the owner's log-in to the server, who needs no account: the tables are the owner's.
int apply_role(const Context& context) {
    const auto store = db::open_store(url_to_open(context));
    store->give_station_role();
    print(context, {{"store", store->url()}, {"role", db::kStationRole}},
          store->url() + ": the tables are up to date; members of " +
              std::string(db::kStationRole) + " may do what stations need");
    return 0;
}

int check_role(const Context& context) {
    Session session(context, Missing::kRefuse);
    session.need(Action::kBackup, Scope::kOther);
    const auto problems = session.store().role_problems();
    std::string text;
    for (const std::string& problem : problems) text += problem + "\n";
    if (problems.empty())
        text = session.store().url() + ": this log-in may do what a station should";
    else
        text += "give stations a log-in that is member of " + std::string(db::kStationRole) +
                ", and their rights with `placodectl station role --apply`";
    print(context, {{"store", session.store().url()}, {"problems", problems}}, text);
    return problems.empty() ? 0 : 1;
}

void add_role_command(CLI::App& station, Context& context) {
    auto work = std::make_shared<RoleWork>(RoleWork::kPrint);
    CLI::App* role = station.add_subcommand(
        "role", "Prints SQL that gives stations what they need on a centre's server, and no more");
    CLI::Option* apply = role->add_flag_callback(
        "--apply", [work] { *work = RoleWork::kApply; },
        "Runs it, and makes or updates the tables: with their owner's log-in in --store");
    role->add_flag_callback(
            "--check", [work] { *work = RoleWork::kCheck; },
            "Says instead what the log-in of --store may do beyond that")
        ->excludes(apply);
    role->callback([&context, work] {
        context.run = [&context, work] {
            return *work == RoleWork::kPrint   ? print_role(context)
                   : *work == RoleWork::kApply ? apply_role(context)
                                               : check_role(context);
        };
    });
}

}  // namespace

void add_station_commands(CLI::App& app, Context& context) {
    auto fingerprint = std::make_shared<std::string>();
    CLI::App* station = app.add_subcommand("station", "Computers that sign the audit trail");
    station->require_subcommand(1);
    station->add_subcommand("list", "Lists the stations that have written into the store")
        ->callback([&context] { context.run = [&context] { return list_stations(context); }; });
    station->add_subcommand("key", "Prints the public key of this computer")->callback([&context] {
        context.run = [&context] { return key(context); };
    });
    CLI::App* added = station->add_subcommand(
        "trust",
        "Vouches for a station, so that `check` takes its entries; run it at one that is "
        "trusted");
    added
        ->add_option(
            "STATION", *fingerprint,
            "Its fingerprint, in quotation marks, as `station list` shows it, or the public "
            "key that `station key` prints there")
        ->required();
    added->callback([&context, fingerprint] {
        context.run = [&context, fingerprint] { return trust(context, *fingerprint); };
    });
    add_role_command(*station, context);
}

}  // namespace placode::cli
